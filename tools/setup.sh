#!/usr/bin/env bash
# setup.sh: installs the Debian packages that are missing; where that cannot be, says what is needed, and goes on with
# what is there or with Hackage. `make setup` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The bounds of package.yaml, by the names of Debian.
packages=(
  ghc cabal-install hpack hspec-discover
  libghc-aeson-dev libghc-colour-dev libghc-criterion-dev libghc-diagrams-lib-dev
  libghc-diagrams-svg-dev libghc-hspec-dev libghc-optparse-applicative-dev libghc-primitive-dev
  libghc-quickcheck2-dev libghc-splitmix-dev libghc-svg-builder-dev libghc-temporary-dev libghc-vector-dev
  libghc-vector-algorithms-dev libghc-weigh-dev
)

mkdir -p dist-newstyle
marker=dist-newstyle/from
if installed "${packages[@]}"; then rm -f $marker-*; exit 0; fi
if [ -e $marker-hackage ] || [ -e $marker-system ]; then exit 0; fi
if install_packages "${packages[@]}"; then exit 0; fi

exec >&2
if command -v apt-get > /dev/null; then
  echo 'The packages could not be installed from here. As root:'
  echo
  echo "apt-get update && apt-get install ${packages[*]}" | fold -s -w 90 | sed -e 's/^/    /' -e '$!s/$/\\/'
  echo
  echo 'Without them, viscomplex needs'
else
  echo 'There is no apt-get here, so nothing is installed. viscomplex needs'
fi
cat << END

    GHC     9.0 to 9.4 (base >= 4.15 && < 4.18)
    cabal   3.4 or later
    hpack   0.34.6 or later
    gcc, make, bash, awk

and these Haskell packages; cabal fetches those that are not installed from Hackage (cabal update, once):

$(sed -nE 's/^  - &[a-z0-9-]+ +/    /p' package.yaml)

END
missing=
for tool in ghc cabal hpack; do
  if path=$(type -P $tool); then echo "    $tool is $path"
  else echo "    $tool is not on PATH"; missing="$missing $tool"; fi
done
echo
if [ -n "$missing" ]; then echo "Missing:$missing. Install and run make again."; exit 1; fi
describe
if type -P hspec-discover > /dev/null && cabal build --dry-run all > /dev/null 2>&1; then
  touch $marker-system
  echo 'All three are here, and the installed Haskell packages suffice: going on without Hackage.'
else
  touch $marker-hackage
  echo 'All three are here: going on with Hackage.'
fi
