#!/usr/bin/env bash
# Proves with other people's programs that the pages are what they claim to be: well-formed (xmllint), real layers of the
# true size in millimetres (Inkscape, rsvg-convert), and the same picture whoever renders them (rsvg-convert, resvg). The
# same for PDF (qpdf, poppler, mutool, Ghostscript, Inkscape) and PNG (pngcheck), in tests/clients/prints.sh. Formats of dots
# are compared with what the drivers of CUPS make, in tests/clients/dots.sh.
#
#     tests/clients.sh            builds the program (debug) and checks the page of every picture in samples/
#     KEEP=folder tests/clients.sh    also keeps pages and renderings there, to be looked at
#
# Needs the programs of tests/programs.sh; as root on Debian it installs what is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

# 5 pixels per millimetre: a whole number, so that programs have little to round.
DPI=127
# Renderers smooth edges differently and agree on everything else. In per cent: the mean difference, where black against
# white is 100, and the share of pixels that are off by more than a quarter. Measured on the samples: at most 0.14 and
# 0.0000. A single line of 160 mm that one of them draws 0.2 mm aside makes a share of 0.24.
MOST_MEAN=0.30
MOST_FAR=0.02

passed=0
failed=0
exec 3>&1 # what is told though the check passes
check() { # check WHAT COMMAND...: runs the command and counts; its output is shown when it fails
  local what=$1 said
  shift
  if said=$("$@" 2>&1); then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED %s: %s\n' "$name" "$what"
    [ -z "$said" ] || printf '%s\n' "$said" | head -n 20 | sed 's/^/    /'
  fi
}

xpath() { xmllint --xpath "$1" "$page"; }
ids() { xpath "$1/@id" | grep -o '"[^"]*"' | tr -d '"'; }
png_size() { # width and height from the header, two big-endian numbers
  od -An -v -tu1 -j16 -N8 "$1" | awk '{ print $1 * 2^24 + $2 * 2^16 + $3 * 2^8 + $4, $5 * 2^24 + $6 * 2^16 + $7 * 2^8 + $8 }'
}

# The SVG says its size in millimetres, its units are millimetres, and the size is that of the profile's sheet.
says_size() { # says_size WIDTH HEIGHT
  local said
  said=$(xpath 'concat(/*/@width, " ", /*/@height, " ", /*/@viewBox)')
  [ "$said" = "$1mm $2mm 0 0 $1 $2" ] || { echo "it says $said, wanted $1 x $2 mm"; return 1; }
}

# A rendering has as many pixels as the sheet has at a resolution; one more or less is rounding.
has_pixels() { # has_pixels PNG WIDTH_MM HEIGHT_MM DPI
  png_size "$1" | awk -v w="$2" -v h="$3" -v dpi="$4" '
    { dx = $1 - w / 25.4 * dpi; dy = $2 - h / 25.4 * dpi }
    dx > -1 && dx < 1 && dy > -1 && dy < 1 { fine = 1 }
    END { if (!fine) { print "it has " $1 " x " $2 " pixels, wanted " w / 25.4 * dpi " x " h / 25.4 * dpi; exit 1 } }'
}

# The groups that this page must have: a white picture gives nothing but its frame.
groups_of_page() {
  echo frame figure
  [ "$picture" = samples/empty.png ] || echo textures lines overview-frame overview
}

# They are there, and each of the page's groups with a name is an Inkscape layer with a label.
are_layers() {
  local id fault=0
  for id in $(groups_of_page); do
    [ "$(xpath "count(//*[local-name()='g'][@id='$id'])")" = 1 ] || { echo "there is not one #$id"; fault=1; }
  done
  for id in $(ids "//*[local-name()='g'][not(@data-strength) and not(@data-braille)]"); do
    [ "$(xpath "count(//*[@id='$id'][@*[name()='inkscape:groupmode']='layer'][@*[name()='inkscape:label']!=''])")" = 1 ] ||
      { echo "#$id is no layer with a label"; fault=1; }
  done
  return $fault
}

# Inkscape's own list of objects has every group that has something in it, and its selection of layers the outer ones.
inkscape_sees() {
  local id fault=0
  for id in $(ids "//*[local-name()='g'][.//*[local-name()!='g']]"); do
    grep -q "^$id,-\?[0-9]" "$seen" || { echo "Inkscape does not list #$id"; fault=1; }
  done
  for id in $(ids "/*/*[local-name()='g']"); do
    grep -q "^$id cloned:" "$seen" || { echo "Inkscape does not take #$id for a layer"; fault=1; }
  done
  return $fault
}

# What Inkscape measures (CSS pixels, 96 to the inch) fits the millimetres that the page states: figure and overview lie
# in their data-box, give or take half a line, and the frame lies on the sheet and around the figure.
inkscape_measures() { # inkscape_measures WIDTH HEIGHT
  awk -F, -v width="$1" -v height="$2" \
    -v figure="$(xpath 'string(//*[@id="figure"]/@data-box)')" \
    -v overview="$(xpath 'string(//*[@id="overview"]/@data-box)')" '
    function mm(px) { return px * 25.4 / 96 }
    function lies_in(x, y, w, h, X, Y, W, H, slack) {
      return x >= X - slack && y >= Y - slack && x + w <= X + W + slack && y + h <= Y + H + slack
    }
    function complain() {
      print "#" $1 " measures x " mm($2) " y " mm($3) " width " mm($4) " height " mm($5) " mm; data-box of the figure " \
        figure ", of the overview " overview
      bad = 1
    }
    BEGIN { split(figure, f, " "); split(overview, o, " ") }
    $1 == "figure" && !lies_in(mm($2), mm($3), mm($4), mm($5), f[1], f[2], f[3], f[4], 1) { complain() }
    $1 == "overview" && !lies_in(mm($2), mm($3), mm($4), mm($5), o[1], o[2], o[3], o[4], 1) { complain() }
    $1 == "frame" {
      seen = 1
      if (!lies_in(f[1], f[2], f[3], f[4], mm($2), mm($3), mm($4), mm($5), 0.01)) complain()
      if (!lies_in(mm($2), mm($3), mm($4), mm($5), 0, 0, width, height, 0)) complain()
    }
    END { if (!seen) print "there is no frame"; exit bad || !seen }' "$seen"
}

renders_alike() {
  local numbers
  numbers=$("$render" "$page" "$out/$name.resvg.png" --dpi $DPI --against "$out/$name.rsvg.png") || return 1
  echo "$name $numbers" >>"$out/differences"
  echo "$numbers" | awk -v mean=$MOST_MEAN -v far=$MOST_FAR '
    NF != 2 || $1 > mean || $2 > far { print "mean " $1 " %, over a quarter " $2 " %; at most " mean " and " far; exit 1 }'
}

# A page is read as the same page after ten trips through Inkscape, as Inkscape SVG and plain SVG in turn, and after one
# through Python's ElementTree. The same bytes are more than the 0.01 mm that is promised.
comes_back() { # comes_back PAGE
  local trip kind
  cp "$1" "$out/trip.svg"
  for trip in 1 2 3 4 5 6 7 8 9 10; do
    kind=$((trip % 2))
    inkscape "$out/trip.svg" --export-overwrite $([ $kind = 0 ] || echo --export-plain-svg) \
      --export-filename="$out/trip-new.svg" || return 1
    mv "$out/trip-new.svg" "$out/trip.svg"
    if [ $trip = 1 ] || [ $trip = 10 ]; then
      "$program" render "$out/trip.svg" -o "$out/trip-read.svg" || return 1
      cmp "$1" "$out/trip-read.svg" || { echo "trip $trip"; return 1; }
    fi
  done
  python3 -c 'import sys, xml.etree.ElementTree as tree; tree.parse(sys.argv[1]).write(sys.argv[2], "utf-8", True)' \
    "$1" "$out/trip.svg" || return 1
  "$program" render "$out/trip.svg" -o "$out/trip-read.svg" && cmp "$1" "$out/trip-read.svg"
}

# What a person does in Inkscape, as actions: a line deleted, an area moved by 3 mm, a rectangle drawn.
edits_are_read() { # edits_are_read PAGE
  inkscape "$1" --actions="select-by-id:line-2;delete;select-clear;select-by-id:region-1;transform-translate:11.34,0;\
export-filename:$out/edited.svg;export-do" || return 1
  "$program" render "$out/edited.svg" -o "$out/edited-read.svg" || return 1
  python3 - "$1" "$out/edited-read.svg" <<'PYTHON'
import re, sys
was, now = (open(name).read() for name in sys.argv[1:])
lines = lambda page: len(re.findall('id="line-', page))
def of(page):
    tag = next(tag for tag in re.findall("<path [^>]*>", page) if 'id="region-1"' in tag)
    return [float(n) for n in re.search(' d="M([-0-9.]+),([-0-9.]+)', tag).groups()]
assert lines(now) == lines(was) - 1, (lines(was), lines(now))
(x, y), (u, v) = of(was), of(now)
assert abs(u - x - 3) < 0.02 and abs(v - y) < 0.02, (x, y, u, v)
PYTHON
}

# A page with edits of many kinds goes into all that the program does with pages: a line duplicated and moved, a clone of
# one, two grouped, one made a path, an area hidden and the layer of the overview.
edited_page_goes_everywhere() { # edited_page_goes_everywhere PAGE PICTURE
  local edited="$out/edited page.svg" code=0 option
  inkscape "$1" --actions="select-by-id:line-2;duplicate;transform-translate:0,150;select-clear;\
select-by-id:line-4;clone;transform-translate:60,0;select-clear;select-by-id:line-5,line-6;selection-group;select-clear;\
select-by-id:line-3;object-to-path;select-clear;select-by-id:region-2;selection-hide;select-clear;\
select-by-id:overview;selection-hide;export-filename:$edited;export-do" || return 1
  "$program" check "$edited" >"$out/everywhere.txt" || code=$?
  # the duplicate lies across other lines
  [ $code = 1 ] && grep -q '^error line-gap: .* line 2 ("path' "$out/everywhere.txt" &&
    grep -q '^Verdict: ' "$out/everywhere.txt" ||
    { echo "check: exit code $code"; cat "$out/everywhere.txt"; return 1; }
  code=0
  "$program" check "$edited" --format sarif >"$out/everywhere.sarif" || code=$?
  [ $code = 1 ] || { echo "check --format sarif: exit code $code"; return 1; }
  "$program" describe "$edited" >"$out/everywhere.desc" || return 1
  "$program" render "$edited" -o "$out/everywhere.svg" || return 1
  "$program" render "$edited" --profile index-basic-d -o "$out/everywhere.idx" || return 1
  for option in lines regions add-lines; do
    "$program" convert "$2" "--$option" "$edited" --no-overview --force -o "$out/everywhere-$option.svg" || return 1
  done
  python3 - "$1" "$out/everywhere" <<'PYTHON'
import json, re, sys
text = lambda name: open(name, encoding="utf-8").read()
was, name = text(sys.argv[1]), sys.argv[2]
lines = lambda page: len(re.findall(r'id="line-\d+"', page))
of = lambda page, colour: page.count(f'data-class="{colour}"')
area = next(tag for tag in re.findall("<path [^>]*>", was) if 'id="region-2"' in tag)
colour = re.search(r'data-class="(\w+)"', area).group(1)
now = text(name + ".svg")
assert lines(now) == lines(was) + 2, (lines(was), lines(now))
assert of(now, colour) == of(was, colour) - 1, (of(was, colour), of(now, colour))
assert 'id="overview-line-' in was and 'id="overview-line-' not in now
told = text(name + ".desc")
assert f"that has {lines(now)} lines" in told and "with no lines" in told, told
run = json.loads(text(name + ".sarif"))["runs"][0]
gaps = [result for result in run["results"] if result["ruleId"] == "line-gap"]
assert gaps and all(gap["level"] == "error" for gap in gaps), run["results"]
place = gaps[0]["locations"][0]["physicalLocation"]
assert place["artifactLocation"]["uri"].endswith("/edited%20page.svg") and place["region"]["startLine"] > 1, place
assert open(name + ".idx", "rb").read(1) == b"\x1b"
assert lines(text(name + "-lines.svg")) > 0.8 * lines(now)
assert of(text(name + "-regions.svg"), colour) == of(now, colour)
assert lines(text(name + "-add-lines.svg")) > lines(was)
PYTHON
}

# Tesseract reads the texts of a chart that is a bitmap, and most of them become labels.
texts_are_read() {
  local text found=0
  sed 's/font-family="[^"]*"/font-family="DejaVu Sans"/' samples/chart.svg >"$out/chart.svg"
  rsvg-convert -w 1800 -b white "$out/chart.svg" -o "$out/chart.png" || return 1
  "$program" convert "$out/chart.png" -o "$out/read.svg" --force --ocr --labels texts --key never 2>"$out/read.log" ||
    { cat "$out/read.log"; return 1; }
  for text in 100 50 0 Mar Apr May Jun Jul; do
    grep -q "aria-label=\"$text\"" "$out/read.svg" && found=$((found + 1))
  done
  [ $found -ge 6 ] || { echo "$found of 8 texts are read"; cat "$out/read.log"; return 1; }
}

# A correction by hand (tools/src/correction.rs), opened and saved in Inkscape, is written as it is without Inkscape; a
# line deleted and a shape coloured there are read.
correction_is_read() {
  local stage=$out/stage-4.svg
  "$correction" "$out" || return 1
  "$program" render "$stage" -o "$out/corrected.svg" || return 1
  inkscape "$stage" --export-filename="$out/stage-saved.svg" || return 1
  "$program" render "$out/stage-saved.svg" -o "$out/corrected-saved.svg" || return 1
  cmp "$out/corrected.svg" "$out/corrected-saved.svg" || return 1
  inkscape "$stage" --actions="select-by-id:line-5;delete;select-clear;select-by-id:cloth;object-set-attribute:fill,#108030;\
export-filename:$out/stage-changed.svg;export-do" || return 1
  "$program" render "$out/stage-changed.svg" -o "$out/changed.svg" || return 1
  python3 - "$out/corrected.svg" "$out/changed.svg" <<'PYTHON'
import re, sys
was, now = (open(name).read() for name in sys.argv[1:])
lines = lambda page: len(re.findall(r'id="line-\d+"', page))
of = lambda page, colour: page.count(f'data-class="{colour}"')
assert lines(now) == lines(was) - 1, (lines(was), lines(now))
assert of(was, "blue") == 1 and of(now, "blue") == 0 and of(now, "green") == of(was, "green") + 1
PYTHON
}

# What other programs trace is no page that fingers can read, and the check says so.
tracing_fails() { # tracing_fails SVG
  local code=0
  "$program" check "$1" >"$out/tracing.txt" || code=$?
  [ $code = 1 ] && grep -q '^error ' "$out/tracing.txt" || { echo "exit code $code"; tail -n 3 "$out/tracing.txt"; return 1; }
}
tracings_fail() { # tracings_fail SAMPLE
  case $1 in
    *.svg) rsvg-convert -w 600 "samples/$1" -o "$out/tracing.png" ;;
    *) cp "samples/$1" "$out/tracing.png" ;;
  esac || return 1
  convert "$out/tracing.png" -colorspace Gray -threshold 50% "$out/tracing.pbm" || return 1
  potrace --svg "$out/tracing.pbm" -o "$out/potrace.svg" && tracing_fails "$out/potrace.svg" || return 1
  # Inkscape traces by the same method: what it saves of that is one of its own drawings, with its layers and styles
  inkscape "$out/potrace.svg" --export-filename="$out/potrace-saved.svg" || return 1
  tracing_fails "$out/potrace-saved.svg" || return 1
  # Inkscape traces without a window since 1.3
  if ! inkscape --action-list 2>/dev/null | grep -q '^selection-trace'; then
    echo "skipped: Inkscape older than 1.3 (its tracing of $1)" >&3
    return 0
  fi
  inkscape "$out/tracing.png" --actions="select-all;selection-trace:8,true,true,false,2,1.0,0.2;\
export-filename:$out/inkscape-traced.svg;export-do" || return 1
  tracing_fails "$out/inkscape-traced.svg"
}

check_page() { # check_page PICTURE PROFILE WIDTH_MM HEIGHT_MM
  picture=$1
  name=$(basename "$1").$2
  page=$out/$name.svg
  seen=$out/$name.seen
  check "the program makes it" "$program" convert "$picture" -o "$page" --profile "$2"
  [ -s "$page" ] || return 0
  check "well-formed" xmllint --noout "$page"
  check "says its size in millimetres" says_size "$3" "$4"
  check "its groups are layers" are_layers
  check "Inkscape opens it" bash -c 'inkscape --actions="$1" "$2" >"$3"' - \
    "select-all:layers;select-list;query-all;export-area-page;export-dpi:96;export-filename:$out/$name.inkscape.png;export-do" \
    "$page" "$seen"
  check "Inkscape sees the objects and layers" inkscape_sees
  check "Inkscape measures true millimetres" inkscape_measures "$3" "$4"
  check "Inkscape's sheet has its true size" has_pixels "$out/$name.inkscape.png" "$3" "$4" 96
  check "rsvg-convert renders it" rsvg-convert --dpi-x $DPI --dpi-y $DPI -b white "$page" -o "$out/$name.rsvg.png"
  check "rsvg-convert's sheet has its true size" has_pixels "$out/$name.rsvg.png" "$3" "$4" $DPI
  check "resvg and rsvg-convert render it alike" renders_alike
  check_pdf "$@"
  check_png "$@"
}

. tests/clients/prints.sh
. tests/clients/dots.sh
. tests/programs.sh
need "${CLIENT_TOOLS[@]}" -- "${CLIENT_PACKAGES[@]}"
cargo build --quiet -p tactograph -p tactograph-tools --bin tactograph --bin render --bin dot_files --bin correction
program=target/debug/tactograph
render=target/debug/render
correction=target/debug/correction
dot_files=target/debug/dot_files
out=${KEEP:-$(mktemp -d)}
mkdir -p "$out"
: >"$out/differences"
: >"$out/print-differences"
[ -n "${KEEP:-}" ] || trap 'rm -rf "$out"' EXIT

for sample in samples/*.{png,jpg,svg}; do
  check_page "$sample" swell-a4 210 297
done
check_page samples/coffee.png swell-a3 297 420
check_page samples/coffee.png swell-letter 215.9 279.4
check_page samples/coffee.png swell-11x11.5 279.4 292.1
check_page samples/coffee.png swell-11x17 279.4 431.8
check_page samples/coffee.png plain-print 210 297
name="trips"
check "a page of dots is made" "$program" convert samples/coffee.png --profile index-basic-d -o "$out/coffee.dots.svg"
check "a page with labels is made" "$program" convert samples/chart.svg --labels texts --title Rain --key never \
  -o "$out/chart.labels.svg"
for trip in coffee.png.swell-a4 landscape.svg.swell-a4 coffee.dots-1 coffee.dots-2 chart.labels; do
  check "$trip comes back from other programs" comes_back "$out/$trip.svg"
done
check "what was edited in Inkscape is read" edits_are_read "$out/coffee.png.swell-a4.svg"
check "a page edited in Inkscape goes everywhere" edited_page_goes_everywhere "$out/coffee.png.swell-a4.svg" \
  samples/coffee.png
check "texts of a bitmap are read" texts_are_read
check "words in braille are found in a PDF" words_are_found
check "a correction by hand goes through Inkscape" correction_is_read
for sample in coffee.png chart.svg; do
  check "a tracing of $sample is found faulty" tracings_fail "$sample"
done
check_sheets
check_layers samples/landscape.svg 12
check_calibration
check_dots

largest() { # largest FILE WHAT
  sort -k2,2nr "$out/$1" | awk -v what="$2" '
    NR == 1 { mean = $2 " % (" $1 ")" } $3 >= far { far = $3; at = $1 }
    END { if (NR) print "largest differences of the " what ": mean " mean ", over a quarter " far " % (" at ")" }'
}
largest differences "renderings of the SVG"
largest print-differences "renderings of the PDF"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
