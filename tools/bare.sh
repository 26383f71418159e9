#!/usr/bin/env bash
# Runs commands in a checkout of HEAD on a bare Debian 12, which has make and nothing else that the project needs:
#
#   tools/bare.sh [COMMAND …]        by default the two commands of the README
#
# That Debian is made by debootstrap in a temporary folder, from this machine's own source of Debian packages, and
# removed at the end. Needs root and about three minutes besides what the commands take. What they print goes to
# dist-newstyle/bare.log, and its end is shown if one fails. The exit status is 1 if a command fails, 2 if there is no
# bare Debian to be had.
set -u -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2
[ $# -gt 0 ] || set -- 'make demo' 'make test'
suite=bookworm
mkdir -p dist-newstyle
log=$PWD/dist-newstyle/bare.log
: > "$log"

none() { tail -n 5 "$log"; echo "bare: there is no bare Debian: $1"; exit 2; }

[ "$(id -u)" = 0 ] || none 'this needs root.'
if ! command -v debootstrap > /dev/null; then
  { apt-get update && apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=300 debootstrap; } >> "$log" 2>&1 < /dev/null ||
    none 'debootstrap is not installed, and could not be.'
fi

root=$(mktemp -d "${TMPDIR:-/tmp}/bare.XXXXXX") || none 'no temporary folder.'
running=
leave() {
  [ -z "$running" ] || kill -- "-$running" 2> /dev/null
  umount "$root/proc" 2> /dev/null
  rm -rf --one-file-system "$root"
}
trap leave EXIT
trap 'exit 2' INT TERM HUP

# The source that has the suite, from files of either format: lines "deb [options] URI SUITE …", or paragraphs with
# "URIs:" and "Suites:".
source_of_suite() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2> /dev/null |
    sed -nE "s/^deb +(\[[^]]*\] +)?([^ ]+) +$suite .*/\2/p"
  awk -v RS= -v suite="$suite" '
    { uri = ""; has = 0
      count = split($0, lines, "\n")
      for (i = 1; i <= count; i++) {
        words = split(lines[i], word, /[ \t]+/)
        if (word[1] == "URIs:") uri = word[2]
        if (word[1] == "Suites:") for (j = 2; j <= words; j++) if (word[j] == suite) has = 1
      }
      if (has) print uri }' /etc/apt/sources.list.d/*.sources 2> /dev/null
}
mirror=$(source_of_suite | head -n 1)

# A process group of its own can be stopped as a whole.
in_group() {
  set -m
  "$@" >> "$log" 2>&1 < /dev/null & running=$!
  set +m
  local status=0
  wait "$running" || status=$?
  running=
  return "$status"
}

begun=$SECONDS
# Without an address, debootstrap takes Debian's own.
in_group debootstrap --variant=minbase --include=make,ca-certificates "$suite" "$root" ${mirror:+"$mirror"} ||
  none 'debootstrap fails.'
# How this machine reaches its source: names, certificates, proxies.
cp /etc/resolv.conf "$root/etc/" 2>> "$log"
cp -rL /etc/ssl/certs/. "$root/etc/ssl/certs/" 2>> "$log"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/" 2>> "$log"
mapfile -t proxies < <(env | grep -iE '^[a-z]+_proxy=')
mount -t proc proc "$root/proc" 2>> "$log"
git clone -q . "$root/root/checkout" 2>> "$log" || none 'the checkout cannot be cloned.'
echo "bare: a Debian with nothing in it but make: $((SECONDS - begun)) s"

for command in "$@"; do
  begun=$SECONDS
  if in_group chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "${proxies[@]}" \
    bash -c "cd /root/checkout && $command"; then
    echo "bare: $command: $((SECONDS - begun)) s. It ends with: $(tail -n 1 "$log")"
  else
    tail -n 15 "$log"
    echo "bare: $command fails."
    exit 1
  fi
done
