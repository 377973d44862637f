#!/usr/bin/env bash
# Shows that pages are the same on every machine: makes the page of every picture in samples/ on the processor at hand, on one
# without AVX2 (QEMU's Nehalem, which has SSE 4.2), and as WebAssembly (no threads, own code without vectors, and other sines and
# powers: those of Rust's own library) in Node.js, and compares mark by mark. Prints a table for docs/stability.md.
#
#     tests/machines.sh
#     SIMD= tests/machines.sh     WebAssembly without vectors: JPEGs are then decoded with other roundings
#
# Needs qemu-x86_64 and node; as root on Debian it installs what is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

TOOLS=(qemu-x86_64 node)
PACKAGES=(qemu-user nodejs)
for tool in "${TOOLS[@]}"; do
  if ! command -v "$tool" > /dev/null; then
    [ "$(id -u)" = 0 ] || { echo "missing: $tool; install ${PACKAGES[*]}" >&2; exit 1; }
    apt-get update -q > /dev/null
    DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${PACKAGES[@]}" > /dev/null
    break
  fi
done
rustup target add wasm32-wasip1 2> /dev/null

cargo build --quiet --bin tactograph
cargo build --quiet -p tactograph-tools --bin agreement
# with vectors, as JPEGs are decoded without them with other roundings: off by one in places, as by any other decoder
RUSTFLAGS="${SIMD--C target-feature=+simd128}" \
  cargo build --quiet --release --manifest-path tools/browser/Cargo.toml --target wasm32-wasip1 --target-dir target/bench/browser
tactograph=target/debug/tactograph
browser=target/bench/browser/wasm32-wasip1/release/tactograph-browser.wasm
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

compare() { # compare PAGE: with the page of this processor; in a cell of the table
  target/debug/agreement "$work/own.svg" "$1" 2>&1 || { echo "(not the same)"; touch "$work/failed"; }
}
echo "| picture | without AVX2 | WebAssembly |"
echo "|---|---|---|"
for picture in samples/*.png samples/*.jpg samples/*.svg; do
  convert=(convert "$picture" --quiet --force --output)
  "$tactograph" "${convert[@]}" "$work/own.svg" 2> /dev/null
  qemu-x86_64 -cpu Nehalem "$tactograph" "${convert[@]}" "$work/nehalem.svg" 2> /dev/null
  node --no-warnings tools/browser/run.mjs "$browser" "$PWD/$picture" "$work/browser.svg" 2> /dev/null
  echo "| $(basename "$picture") | $(compare "$work/nehalem.svg") | $(compare "$work/browser.svg") |"
done
[ ! -e "$work/failed" ]
