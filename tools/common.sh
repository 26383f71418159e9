# Functions of the scripts beside this one, which source it; it goes to the top of the checkout.

set -eu -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# GHC reads its sources in the encoding of the locale.
export LANG=C.UTF-8 LC_ALL=C.UTF-8

BUILDDIR=${BUILDDIR:-dist-newstyle}
EXE=bin/viscomplex
# Words, as make has them.
eval "CABAL_FLAGS=(${CABAL_FLAGS:-})"

# All state of cabal lies in the checkout, that of two builds at once apart. Where the installed packages suffice, cabal knows no other source and never
# looks for a network.
cabal() {
  if [ -e dist-newstyle/from-hackage ]; then command cabal "$@"
  else CABAL_DIR="$PWD/$BUILDDIR/cabal" CABAL_CONFIG="$PWD/cabal.offline.config" command cabal "$@"
  fi
}

# Writes viscomplex.cabal from package.yaml, if there is hpack and it would say something else, versions of hpack apart.
describe() {
  local described
  command -v hpack > /dev/null || return 0
  described=$(hpack package.yaml -) || return 1
  said() { grep -v '^-- This file has been generated'; }
  [ "$(said <<< "$described")" = "$(said 2> /dev/null < viscomplex.cabal)" ] ||
    printf '%s\n' "$described" > viscomplex.cabal
}

# Where DESCRIBED is set, viscomplex.cabal has been written: two builds at once must not both do it.
build() {
  [ -n "${DESCRIBED-}" ] || describe || return 1
  cabal build --builddir="$BUILDDIR" ${CABAL_FLAGS[@]+"${CABAL_FLAGS[@]}"} "$@"
}

# Where what has been built lies.
built() { cabal list-bin --builddir="$BUILDDIR" ${CABAL_FLAGS[@]+"${CABAL_FLAGS[@]}"} "$@"; }

# Whether dpkg has all of the packages named.
installed() {
  command -v dpkg-query > /dev/null &&
    [ "$(dpkg-query -W -f='${db:Status-Status}\n' "$@" 2> /dev/null | grep -cx installed)" = "$#" ]
}

install_packages() {
  local sudo=
  command -v apt-get > /dev/null || return 1
  if [ "$(id -u)" != 0 ]; then sudo=sudo; command -v sudo > /dev/null || return 1; fi
  $sudo apt-get update && $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}

# need TARGET WHAT PACKAGE …: installs the packages that a target needs besides those of setup.
need() {
  installed "${@:3}" || install_packages "${@:3}" || { echo "$1 needs $2 (Debian: ${*:3})." >&2; exit 1; }
}
