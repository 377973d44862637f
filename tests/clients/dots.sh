# Part of tests/clients.sh: the formats of dots, in the programs that read them. Uses its variables and functions; the files
# come from tools/src/bin/dot_files.rs.
#
# The drivers of Index embossers and the rest of CUPS's way to braille are filters of cups-filters. The one for V4 and V5 looks
# for a file of its own in a wrong place and then leaves the header out; a copy with that line corrected is made here.

FILTERS=/usr/lib/cups/filter
BRAILLE=/usr/share/cups/braille
PEF_JAR=/usr/share/java/brailleUtils-core.jar

# Options that leave the dots alone: by default the filters look for edges, turn, fit to the page, add two blank lines and
# columns, and want a table of the reader's language.
AS_THEY_ARE=(Edge=None Rotate=0 fitplot=False TopMargin=0 BottomMargin=0 LeftMargin=0 RightMargin=0 page-left=0 page-right=0
  page-top=0 page-bottom=0 LibLouis=None LibLouis2=None)

filter() { # filter PPD FILTER COPIES FILE OPTION...: as CUPS calls it
  local ppd=$dots/ppd/$1.ppd program=$2 copies=$3 file=$4
  shift 4
  PPD=$ppd LANG=C.UTF-8 "$program" 1 user title "$copies" "${AS_THEY_ARE[*]} $*" "$file"
}

# One case of index.txt; writes a line if the driver's bytes are not ours.
index_case() { # index_case NAME PPD PAGE PITCH COPIES IMPACT
  local driver=$FILTERS/imageubrltoindexv3
  case $2 in *4) driver=$dots/imageubrltoindexv4 ;; esac
  filter "$2" "$driver" "$5" "$dots/$1.ubrl" PageSize="$3" GraphicDotDistance="$4" IndexMultipleImpact="$6" \
    >"$dots/$1.theirs" 2>"$dots/$1.log" || echo "$1: the driver fails: $(tail -n 1 "$dots/$1.log")"
  cmp "$dots/$1.theirs" "$dots/$1.idx" || true
}

index_drivers_agree() {
  local said
  # As many at a time as there are processors: a filter takes a tenth of a second, and there are many cases.
  export -f index_case filter
  export dots FILTERS AS_THEY_ARE_TEXT="${AS_THEY_ARE[*]}"
  said=$(xargs -P "$(nproc)" -L 1 bash -c 'AS_THEY_ARE=($AS_THEY_ARE_TEXT); index_case "$@"' - <"$dots/index.txt" 2>&1)
  [ -z "$said" ] || { printf '%s\n' "$said"; return 1; }
  [ "$(find "$dots" -name '*.theirs' | wc -l)" = "$(wc -l <"$dots/index.txt")" ] || { echo "not every case was tried"; return 1; }
}

# A picture with a pixel a dot comes out as the same cells.
pictures_become_cells() {
  filter ibasicd3 $FILTERS/imagetoubrl 1 "$dots/eight.png" PageSize=A4 GraphicDotDistance=200 2>"$dots/log" |
    cmp - "$dots/eight.ubrl" || { tail -n 3 "$dots/log"; return 1; }
}

# The same with cells of six dots, sent to an embosser of text. CUPS keeps blanks at the ends of rows and ends the line of the
# last form feed.
pictures_become_text() {
  filter gen-brf $FILTERS/imagetobrf 1 "$dots/six.png" PageSize=A4 GraphicDotDistance=250 >"$dots/six.theirs" 2>"$dots/log" &&
    filter gen-brf $FILTERS/brftoembosser 1 "$dots/six.theirs" SendFF=False SendSUB=False 2>"$dots/log" |
    sed 's/ *\r$/\r/; s/^\f\r$/\f/' | cmp - "$dots/six.brf" || { tail -n 3 "$dots/log"; return 1; }
}

# What a table of liblouis shows for all cells of six dots is our file of them; some tables have small letters, and other
# signs at those places.
louis_agrees() { # louis_agrees TABLE
  local cells
  # Each of them behind a full cell, since programs drop blanks at the ends.
  cells=$(for cell in {0..63}; do printf '\u283f\\u%04x\n' $((0x2800 + cell)); done)
  LC_ALL=C.UTF-8 printf '%b\n' "$cells" | lou_translate --forward "$1,braille-patterns.cti" | sed 's/^=//; s/^$/ /' |
    tr -d '\n' | tr 'a-z`{|}~' 'A-Z@[\\]^' >"$dots/$1.cells" || return 1
  tr -d '\r\n\f' <"$dots/cells6.brf" | cmp - "$dots/$1.cells" || { cat "$dots/$1.cells"; return 1; }
}

pef_is_valid() { # pef_is_valid FILE
  jing "$dots/pef.rng" "$1"
}

# The schema refuses what it should: it is read at all.
pef_faults_are_found() {
  sed 's/ rowgap="0"//' "$dots/plain.pef" >"$dots/faulty.pef"
  ! jing "$dots/pef.rng" "$dots/faulty.pef"
}

# The whole way through CUPS: a scheduler of our own, with a backend that writes what an embosser would get to a file. (CUPS's
# own file: devices get nothing of a raw document.) Its folder is not in ours, which other users cannot enter; filters run as
# one.
start_cups() {
  mkdir -p "$cups"/{root,run,spool,cache,tmp,log,bin/backend}
  chmod 755 "$cups"
  chmod 1777 "$cups/tmp"
  ln -s /usr/lib/cups/{filter,driver,daemon,monitor,notifier} "$cups/bin"
  cat >"$cups/bin/backend/paper" <<END
#!/bin/sh
[ \$# = 0 ] || cat "\${6:--}" >"$cups/paper"
END
  chmod 755 "$cups/bin/backend/paper"
  cat >"$cups/cups-files.conf" <<END
ServerBin $cups/bin
ServerRoot $cups/root
StateDir $cups/run
RequestRoot $cups/spool
CacheDir $cups/cache
TempDir $cups/tmp
AccessLog $cups/log/access
ErrorLog $cups/log/error
PageLog $cups/log/page
SystemGroup root
END
  cat >"$cups/cupsd.conf" <<END
Listen $cups/socket
Browsing Off
DefaultAuthType None
WebInterface No
<Location />
  Order allow,deny
  Allow all
</Location>
<Policy default>
  <Limit All>
    Order deny,allow
    Allow all
  </Limit>
</Policy>
END
  cupsd -f -c "$cups/cupsd.conf" -s "$cups/cups-files.conf" >"$cups/log/said" 2>&1 &
  echo $! >"$cups/pid"
  for _ in $(seq 100); do
    [ -S "$cups/socket" ] && CUPS_SERVER=$cups/socket lpstat -r >/dev/null 2>&1 && return
    kill -0 "$(cat "$cups/pid")" 2>/dev/null || break
    sleep 0.1
  done
  cat "$cups/log/said"
  tail -n 5 "$cups/log/error"
  return 1
}

# Its folder can go when it has stopped.
stop_cups() {
  local pid
  pid=$(cat "$cups/pid") && kill "$pid" 2>/dev/null || true
  for _ in $(seq 100); do
    kill -0 "$pid" 2>/dev/null || break
    sleep 0.1
  done
  rm -rf "$cups"
}

# lp, with the options that leave the dots alone, brings the bytes to the printer that we write ourselves.
lp_brings() { # lp_brings WANTED TYPE FILE OPTION...
  local wanted=$1 type=$2 file=$3 said option options=() paper=$cups/paper
  shift 3
  for option in "${AS_THEY_ARE[@]}" "$@"; do options+=(-o "$option"); done
  : >"$paper"
  chmod a+w "$paper"
  export CUPS_SERVER=$cups/socket
  said=$(lp -d index -o document-format="$type" "${options[@]}" "$file") || { echo "$said"; return 1; }
  for _ in $(seq 200); do
    [ -z "$(lpstat -o)" ] && break
    sleep 0.1
  done
  cmp "$paper" "$wanted" || { lpstat -o -l; tail -n 20 "$cups/log/error"; return 1; }
}

# Dots and pictures by way of the V3 driver, and for a V4 our own bytes as they are.
cups_prints() {
  local of
  CUPS_SERVER=$cups/socket lpadmin -p index -v paper:/ -P "$dots/ppd/ibasicd3.ppd" -E || return 1
  read -ra of < <(grep '^ibasicd3.A4.200 ' "$dots/index.txt")
  lp_brings "$dots/$of.idx" image/vnd.cups-ubrl "$dots/$of.ubrl" PageSize=A4 GraphicDotDistance=200 copies="${of[4]}" \
    IndexMultipleImpact="${of[5]}" || return 1
  lp_brings "$dots/eight.idx" image/png "$dots/eight.png" PageSize=A4 GraphicDotDistance=200 || return 1
  lp_brings "$dots/ibasicd4.A4.200.idx" application/vnd.cups-raw "$dots/ibasicd4.A4.200.idx"
}

# A real page, with its overview, comes to the same bytes by way of CUPS's driver and straight.
pages_agree() { # pages_agree PROFILE PPD
  local driver=$FILTERS/imageubrltoindexv3
  case $2 in *4) driver=$dots/imageubrltoindexv4 ;; esac
  "$program" convert samples/coffee.png --quiet --profile "$1" --set dots.pitch=2.0 -o "$dots/$1.ubrl" || return 1
  "$program" convert samples/coffee.png --quiet --profile "$1" --set dots.pitch=2.0 --copies 2 -o "$dots/$1.idx" || return 1
  filter "$2" "$driver" 2 "$dots/$1.ubrl" PageSize=A4 GraphicDotDistance=200 2>"$dots/log" | cmp - "$dots/$1.idx" ||
    { tail -n 3 "$dots/log"; return 1; }
}

# A real page as PEF, with a title that XML must not see.
page_is_valid_pef() {
  "$program" convert samples/coffee.png --quiet --profile monarch --title 'A < B & "C"' -o "$dots/page.pef" || return 1
  jing "$dots/pef.rng" "$dots/page.pef"
}

# Words in braille on real pages, read back by liblouis: title, labels, key and page numbers say what the page says they say.
# Lines of a text are joined by a blank; a text with a hyphen at the end of a line, or an abbreviation in the key, is left to the
# tests of our own.
louis_reads_words() {
  local sample profile count
  for profile in swell-a4 index-basic-d viewplus-columbia pins-120x60; do
    for sample in chart map cell; do
      "$program" convert "samples/$sample.svg" --quiet --profile "$profile" --title "Sheet (a), 3 of 12: what it shows" \
        --labels texts --key always --number 8 --format svg -o "$dots/words-$profile-$sample.svg" || return 1
    done
  done
  cat "$dots"/words-*.svg | grep -o 'aria-label="[^"]*"[^>]*data-braille="[^"]*"' | grep -v 'data-abbreviation\|⠤ ' |
    sed 's/aria-label="\([^"]*\)".*data-braille="\([^"]*\)"/\1\t\2/' | grep -v $'^[a-z]*: ' >"$dots/words.tsv"
  count=$(wc -l <"$dots/words.tsv")
  [ "$count" -ge 150 ] || { echo "only $count texts"; return 1; }
  cut -f 2 "$dots/words.tsv" | sed 's/ /⠀/g' | lou_translate --backward unicode.dis,en-ueb-g1.ctb >"$dots/words.back" || return 1
  cut -f 1 "$dots/words.tsv" | diff - "$dots/words.back"
}

# The phrases that our tables are held against have the cells that the installed liblouis gives: nothing in them was written by
# hand. What codes have otherwise is in newer.tsv. They were recorded with liblouis 3.24; another one may differ.
louis_has_our_phrases() {
  local table language phrases fault=0
  for table in cs-g1.ctb de-g0.utb en-ueb-g1.ctb es-g1.ctb fr-bfu-comp6.utb it-it-comp6.utb nl-NL-g0.utb Pl-Pl-g1.utb \
    pt-pt-g1.utb sv-g0.utb; do
    language=${table%%-*}
    phrases=tests/braille/phrases/${language,,}.tsv
    [ "$(wc -l <"$phrases")" = 500 ] || { echo "$phrases has not 500 phrases"; fault=1; }
    cut -f 1 "$phrases" | sed 's/\\/\\\\/g' | lou_translate --forward "unicode.dis,$table" >"$dots/phrases.txt" || fault=1
    cut -f 2 "$phrases" | diff - "$dots/phrases.txt" || { echo "$phrases is not what $table gives"; fault=1; }
  done
  return $fault
}

# A real page for ViewPlus: its PDF drawn at 20 dots per inch has its ink where the picture of dots has its pixels.
viewplus_agrees() {
  "$program" convert samples/coffee.png --quiet --profile viewplus-columbia --no-overview -o "$dots/tiger.pdf" || return 1
  "$program" convert samples/coffee.png --quiet --profile viewplus-columbia --no-overview --format pixels -o "$dots/tiger.png" || return 1
  local pixels drawn
  pixels=$(convert "$dots/tiger.png" -threshold 99% -format '%w %h %[fx:1-mean]' info:)
  # Ink anywhere in the square of a dot is a dot.
  pdftoppm -r 200 -gray -png -singlefile "$dots/tiger.pdf" "$dots/tiger-drawn" || return 1
  convert "$dots/tiger-drawn.png" -threshold 90% -negate -crop "$(echo "$pixels" | awk '{ print $1 * 10 "x" $2 * 10 }')+0+0" +repage \
    -filter box -resize 10% -threshold 20% -negate "$dots/tiger-seen.png"
  drawn=$(convert "$dots/tiger-seen.png" \( "$dots/tiger.png" -threshold 99% \) -metric AE -compare -format '%[distortion]' info:)
  [ "$drawn" = 0 ] || { echo "$drawn dots of $pixels differ"; return 1; }
}

greys_are_fine() {
  local said wanted
  said=$(pngcheck -v "$dots/heights.png") || { echo "$said"; return 1; }
  case $said in *"4 x 2 image, 8-bit grayscale"*"787x787 pixels/meter (20 dpi)"*) ;; *) echo "$said"; return 1 ;; esac
  # Greys of the first row and of the second one.
  wanted="255 170 85 0 0 85 170 255"
  said=$(convert "$dots/heights.png" gray:- | od -An -v -tu1 | xargs)
  [ "$said" = "$wanted" ] || { echo "greys $said, wanted $wanted"; return 1; }
}

check_dots() {
  local file
  name=dots
  dots=$out/dots
  mkdir -p "$dots"
  check "the example writes the files" "$dot_files" "$dots"
  for driver in indexv3 indexv4 generic-brf; do
    check "ppdc makes the PPDs of $driver" ppdc -d "$dots/ppd" /usr/share/cups/drv/$driver.drv
  done
  sed "s#$FILTERS/indexv4.sh#$BRAILLE/indexv4.sh#" $FILTERS/imageubrltoindexv4 >"$dots/imageubrltoindexv4"
  chmod +x "$dots/imageubrltoindexv4"
  check "the drivers of Index embossers make our bytes" index_drivers_agree
  check "CUPS makes our cells of eight from our picture" pictures_become_cells
  check "CUPS makes our cells of six from our picture" pictures_become_text
  check "liblouis has our table in en-us-brf.dis" louis_agrees en-us-brf.dis
  check "liblouis has our table in text_nabcc.dis" louis_agrees text_nabcc.dis
  unzip -p "$PEF_JAR" org/daisy/braille/pef/resource-files/pef-2008-1-full.rng >"$dots/pef.rng"
  for file in "$dots"/{plain,odd,none}.pef; do
    check "jing finds no fault in $(basename "$file")" pef_is_valid "$file"
  done
  check "CUPS's driver and we agree on a real page, V3" pages_agree index-basic-d-v3 ibasicd3
  check "CUPS's driver and we agree on a real page, V4" pages_agree index-basic-d ibasicd4
  check "jing finds no fault in a real page" page_is_valid_pef
  check "a page for ViewPlus has its dots where the picture has its pixels" viewplus_agrees
  check "liblouis reads the words of real pages" louis_reads_words
  check "liblouis has our phrases" louis_has_our_phrases
  check "jing finds faults in a faulty one" pef_faults_are_found
  check "pngcheck and ImageMagick see dots as pixels" greys_are_fine
  cups=$(mktemp -d)
  check "CUPS starts" start_cups
  check "lp brings an Index embosser our bytes" cups_prints
  stop_cups
}
