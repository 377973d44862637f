#!/usr/bin/env bash
# The programs of other people that tests/clients.sh, with its parts, and tests/instructions.sh need: both read this file, and
# install what is missing as root on Debian. .ci/run has all of it downloaded beside its first steps, and installed in one step.
#
#     tests/programs.sh download    only downloads the packages
#     tests/programs.sh install     installs them

CLIENT_TOOLS=(inkscape potrace convert python3 rsvg-convert xmllint qpdf pdftoppm mutool gs pngcheck tesseract
  ppdc cupsd lp lou_translate jing unzip)
CLIENT_PACKAGES=(inkscape potrace imagemagick python3 librsvg2-bin libxml2-utils qpdf poppler-utils mupdf-tools ghostscript pngcheck
  tesseract-ocr tesseract-ocr-eng fonts-dejavu-core cups cups-client cups-filters cups-ppdc liblouis-bin liblouis-data jing
  libbrailleutils-java unzip)
COUNTING_TOOLS=(valgrind)
COUNTING_PACKAGES=(valgrind)

apt_get() { DEBIAN_FRONTEND=noninteractive apt-get "$1" -y -qq --no-install-recommends "${@:2}"; }

can_install() { [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; }

first_missing() { # first_missing TOOL...: the first that is not there, or nothing
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "$tool"; return; }
  done
}

need() { # need TOOL... -- PACKAGE...: installs the packages if one of the tools is missing
  local tools=() missing why
  while [ "$1" != -- ]; do
    tools+=("$1")
    shift
  done
  shift
  missing=$(first_missing "${tools[@]}")
  [ -n "$missing" ] || return 0
  if ! can_install; then
    echo "$missing is missing; install $*" >&2
    exit 2
  fi
  # from the lists that are there, and what has been downloaded by them; from new ones where that fails
  { why=$(apt_get install "$@" 2>&1 >&3); } 3>&1 || {
    printf 'from new lists of packages, as those that are there do not do:\n%s\n' "$why" >&2
    apt-get update -qq && apt_get install "$@"
  }
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  set -euo pipefail
  tools=("${CLIENT_TOOLS[@]}" "${COUNTING_TOOLS[@]}")
  packages=("${CLIENT_PACKAGES[@]}" "${COUNTING_PACKAGES[@]}")
  case ${1:-} in
    download)
      if [ -n "$(first_missing "${tools[@]}")" ] && can_install; then
        apt-get update -qq
        apt_get install --download-only "${packages[@]}"
      fi
      ;;
    install) need "${tools[@]}" -- "${packages[@]}" ;;
    *)
      echo "tests/programs.sh download, or install" >&2
      exit 2
      ;;
  esac
fi
