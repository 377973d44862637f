#!/usr/bin/env bash
# Installs what bench_all runs beside our program, and what writes its pictures: from Debian as root, and from PyPI into an
# environment of its own under target/bench. What cannot be had is told; bench_all leaves its rows out, and with --write it
# refuses. Without cjpeg and cwebp it measures nothing, as they write its pictures.
#
# Inkscape is not among them: that of Debian 12 (1.2) traces bitmaps only in its window, by no command. What its window
# runs is potrace, which is here.
set -euo pipefail
cd "$(dirname "$0")/../../../.."

TOOLS=(djpeg cjpeg cwebp vips potrace convert-im6 python3 node)
PACKAGES=(libjpeg-turbo-progs webp libvips-tools potrace imagemagick python3 nodejs)

missing=()
for i in "${!TOOLS[@]}"; do
  command -v "${TOOLS[i]}" >/dev/null || missing+=("${PACKAGES[i]}")
done
# what Debian's python3 lacks to make an environment
python3 -c 'import ensurepip' 2>/dev/null || missing+=(python3-venv)
if [ ${#missing[@]} != 0 ]; then
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
  else
    echo "missing: install ${missing[*]}" >&2
  fi
fi

venv=target/bench/venv
if ! "$venv/bin/python" -c 'import cv2, vtracer' 2>/dev/null; then
  mkdir -p target/bench
  { python3 -m venv "$venv" && "$venv/bin/pip" install --quiet opencv-python-headless vtracer; } ||
    echo "missing: OpenCV and vtracer could not be installed with pip" >&2
fi

# the library as a browser runs it
rustup target add wasm32-wasip1 || echo "missing: Rust's target wasm32-wasip1 could not be installed" >&2
