#!/usr/bin/env bash
# Holds the speed: counts the instructions that the program as it is shipped executes for a few pages, and for a check of
# one (valgrind's callgrind), and compares with tests/instructions.txt. Other than times, counts are the same however busy
# the machine is: two runs differ by 0.1 % at most. What takes MOST per cent more fails.
#
#     tests/instructions.sh            counts and compares
#     UPDATE=1 tests/instructions.sh   writes the counts anew: say in the commit why they changed. So does what is new in
#                                      WORK get its line: until then it fails as "not in the file"
#     KEEP=folder tests/instructions.sh    also keeps what callgrind wrote; `callgrind_annotate FILE` tells where the time goes
#
# The program chooses its vectors by the processor, and valgrind shows every program one and the same processor as long as
# the real one has AVX2 and FMA. Where it has not, other code would be counted, so nothing is. Another compiler may make
# somewhat other code: the file says which one it was counted with.
#
# Why not gungraun (once iai-callgrind), which does the same for single functions: it needs a program of its own, built by
# `cargo install` in the very version of the library, and counts code linked into a benchmark rather than what is shipped.
set -euo pipefail
cd "$(dirname "$0")/.."

MOST=3
FILE=tests/instructions.txt
# A name, and the words of the program; OUT is the folder of the pages. Of the drawing, 2 % are for the fonts that its
# texts are set in: without any installed it takes so much less. The check is of the page that photo-png has made. The scaled
# JPEG is decoded at a part of its size, as large photographs are. The fine drawing is the left half of a picture of the
# README: a bitmap, worked on at its own pixels, in which most that is thin is no stroke.
WORK=(
  "photo-png convert samples/coffee.png -o OUT/coffee.svg --quiet"
  "photo-jpeg convert samples/rocket.jpg -o OUT/photo-jpeg.svg --quiet"
  "jpeg-scaled convert samples/rocket.jpg -o OUT/jpeg-scaled.svg --quiet --set figure.resolution=1"
  "photo-pdf convert samples/coffee.png -o OUT/photo-pdf.pdf --quiet"
  "regions-off convert samples/coffee.png -o OUT/regions-off.svg --quiet --set lines.regions=false"
  "outlines convert samples/coffee.png -o OUT/outlines.svg --quiet --outlines"
  "textures convert samples/coffee.png -o OUT/textures.svg --quiet --textures-only"
  "white convert samples/empty.png -o OUT/white.svg --quiet"
  "drawing convert samples/chart.svg -o OUT/drawing.svg --quiet"
  "drawing-fine convert docs/readme/landscape.png -o OUT/drawing-fine.svg --quiet --crop 0,0,50%,100% --quality fine"
  "chart-words convert samples/chart.svg -o OUT/chart-words.svg --quiet --labels texts"
  "pdf-page convert samples/worksheet.pdf -o OUT/pdf-page.svg --quiet"
  "dense convert samples/portrait.svg -o OUT/dense.svg --quiet"
  "dots convert samples/chelsea.png -o OUT/dots.svg --quiet --profile romeo-60"
  "check check OUT/coffee.svg"
)

if [ "$(uname -sm)" != "Linux x86_64" ] || ! grep -qw avx2 /proc/cpuinfo || ! grep -qw fma /proc/cpuinfo; then
  echo "not counted: the figures are of x86-64 processors with AVX2 and FMA under Linux, and this is another"
  exit 0
fi
if [ -n "${UPDATE:-}" ] && [ -n "${CI:-}" ]; then
  echo "UPDATE is not for CI: there the counts must be as somebody last saw them" >&2
  exit 2
fi
. tests/programs.sh
need "${COUNTING_TOOLS[@]}" -- "${COUNTING_PACKAGES[@]}"

cargo build --quiet --release --bin tactograph
out=${KEEP:-$(mktemp -d)}
mkdir -p "$out"
[ -n "${KEEP:-}" ] || trap 'rm -rf "$out"' EXIT

count() { # count NAME WORDS...: how many instructions the program takes with these words
  local profile=$out/$1.callgrind
  shift
  # one thread: others spin while they wait, and how long they do is chance
  RAYON_NUM_THREADS=1 valgrind --quiet --tool=callgrind --callgrind-out-file="$profile" \
    target/release/tactograph "${@/#OUT/$out}" >/dev/null || return
  awk '$1 == "summary:" || $1 == "totals:" { print $2; exit }' "$profile"
}

wanted() { awk -v name="$1" '$1 == name { print $2 }' "$FILE"; }

# As many at a time as there are cores; a check waits for the page that it reads.
for work in "${WORK[@]}"; do
  read -ra words <<<"$work"
  [ "${words[1]}" != check ] || wait
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  count "${words[@]}" >"$out/${words[0]}.count" &
done
wait

counted=$out/instructions.txt
passed=0
failed=0
{
  echo "# Instructions that the work of tests/instructions.sh takes; UPDATE=1 tests/instructions.sh writes them anew."
  echo "# $(rustc --version | cut -d' ' -f1,2), $(valgrind --version)"
} >"$counted"
for work in "${WORK[@]}"; do
  read -ra words <<<"$work"
  name=${words[0]}
  now=$(<"$out/$name.count")
  if [ -z "$now" ]; then
    echo "FAILED $name: the program does not run under valgrind"
    failed=$((failed + 1))
    continue
  fi
  echo "$name $now" >>"$counted"
  [ -z "${UPDATE:-}" ] || continue
  before=$(wanted "$name")
  if said=$(awk -v name="$name" -v now="$now" -v before="${before:-0}" -v most=$MOST 'BEGIN {
      if (before == 0) { print name ": not in the file; UPDATE=1 adds it"; exit 1 }
      more = 100 * (now / before - 1)
      printf "%-12s %7.1f million instructions, %+.2f %%", name, now / 1e6, more
      if (more > most) { printf ": more than %s %% over what it was", most; exit 1 }
      if (more < -most) printf ": better; UPDATE=1 holds it"
    }'); then
    passed=$((passed + 1))
    echo "$said"
  else
    failed=$((failed + 1))
    echo "FAILED $said"
  fi
done
if [ -n "${UPDATE:-}" ]; then
  [ "$failed" = 0 ] || exit 1
  cp "$counted" "$FILE"
  cat "$FILE"
  exit 0
fi
if [ "$failed" != 0 ]; then
  echo "counted with $(sed -n '2s/# //p' "$counted"); $FILE with $(sed -n '2s/# //p' "$FILE")"
fi
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
