# Part of tests/clients.sh: the same page as PDF and PNG, in other people's programs. Uses its variables and functions.

# What pdftoppm and mutool make of the PDF against what resvg makes of the SVG at 150 dpi, in per cent as MOST_MEAN and
# MOST_FAR. poppler draws thin shapes a little bolder. Measured on the samples: at most 0.27 and 0.051 (a page full of short
# lines).
PRINT_DPI=150
PRINT_MEAN=0.40
# Poppler moves straight strokes along the axes to whole pixels (stroke adjustment). Lines of drawings are straight to a
# thousandth of a millimetre now, so the five bars are half a pixel off along their sides: 0.24 % of the pixels.
POPPLER_FAR=0.30
PRINT_FAR=0.10
PNG_DPI=300

says_nothing() { # says_nothing COMMAND...: it succeeds without a word
  local said
  said=$("$@" 2>&1) || { echo "$said"; return 1; }
  # What Debian's mutool says of itself whatever it is given.
  said=$(printf '%s\n' "$said" | grep -v '^warning: ICC support is not available$' || true)
  [ -z "$said" ] || { echo "$said"; return 1; }
}

qpdf_finds_no_fault() {
  local said
  said=$(qpdf --check "$pdf" 2>&1) || { echo "$said"; return 1; }
  ! printf '%s\n' "$said" | grep -i warning
}

# The pages, their size to 0.1 mm, that it is tagged, and its title.
pdfinfo_says() { # pdfinfo_says WIDTH_MM HEIGHT_MM PAGES TITLE
  pdfinfo -box "$pdf" | awk -v width="$1" -v height="$2" -v pages="$3" -v title="$4" '
    function differs(points, mm) { return points * 25.4 / 72 - mm > 0.1 || mm - points * 25.4 / 72 > 0.1 }
    /^Title:/ { $1 = ""; told = substr($0, 2) }
    /^Tagged:/ { tagged = $2 }
    /^Pages:/ { count = $2 }
    /^Page size:/ { seen++; if (differs($3, width) || differs($5, height)) { print $0 ", wanted " width " x " height " mm"; bad = 1 } }
    /^(MediaBox|TrimBox):/ { seen++; if ($2 != 0 || $3 != 0 || differs($4, width) || differs($5, height)) { print; bad = 1 } }
    END {
      if (told != title) { print "title " told ", wanted " title; bad = 1 }
      if (tagged != "yes") { print "not tagged"; bad = 1 }
      if (count != pages) { print count " pages, wanted " pages; bad = 1 }
      exit bad || seen != 3
    }'
}

# The tree of tags is a document of figures, one a page, as poppler reads it; mutool finds the words that the SVG has.
words_are_tagged() { # words_are_tagged PAGES
  local tags wanted told
  tags=$(pdfinfo -struct "$pdf" | sed -n 's/^ *\(Document\|Figure\).*/\1/p' | tr '\n' ' ')
  wanted="Document $(printf 'Figure %.0s' $(seq "$1"))"
  [ "$tags" = "$wanted" ] || { echo "tags $tags, wanted $wanted"; return 1; }
  told=$(mutool show "$pdf" trailer/Root/StructTreeRoot/K/K/1/Alt 2>/dev/null | sed 's/\\\([()]\)/\1/g')
  wanted=$(xpath 'string(/*/*[local-name()="desc"])' | tr '\n' ' ' | sed 's/^ *//; s/ *$//')
  [ "$told" = "($wanted)" ] || { echo "alternative text $told, wanted $wanted"; return 1; }
}

# Every operator that sets a colour, in any content of the file, sets DeviceGray black; no ink but black comes out. Words in
# strings are no operators.
is_black_alone() {
  local operators ink
  qpdf --qdf --object-streams=disable "$pdf" "$out/$name.qdf.pdf" || return 1
  operators=$(LC_ALL=C sed 's/\\[()]//g; s/([^()]*)//g' "$out/$name.qdf.pdf" | LC_ALL=C tr -cs '[:graph:]' '\n' | LC_ALL=C awk '
    /^(g|G|rg|RG|k|K|cs|CS|sc|SC|scn|SCN|sh|ri)$/ { print before, $0 } { before = $0 }' | sort -u | tr '\n' ' ')
  [ "$operators" = "0 G 0 g " ] || { echo "colour operators: $operators"; return 1; }
  ink=$(gs -q -o - -sDEVICE=inkcov "$pdf" | awk '$1 + $2 + $3 != 0 || !/CMYK OK/')
  [ -z "$ink" ] || { echo "coloured ink: $ink"; return 1; }
}

pdf_is_drawn_alike() { # pdf_is_drawn_alike PNG: another program's rendering against resvg's of the SVG
  local numbers
  numbers=$("$render" "$page" "$out/$name.150.png" --dpi $PRINT_DPI --against "$1") || return 1
  echo "$name $numbers" >>"$out/print-differences"
  echo "$numbers" | awk -v mean=$PRINT_MEAN -v far=$PRINT_FAR '
    NF != 2 || $1 > mean || $2 > far { print "mean " $1 " %, over a quarter " $2 " %; at most " mean " and " far; exit 1 }'
}

# Words in braille are found, and copied, as text: a title in letters of several languages, and labels.
words_are_found() {
  local text
  pdf=$out/words.pdf
  "$program" convert samples/map.svg --quiet --labels texts --title "Łódź, Köln and the sea" -o "$pdf" || return 1
  text=$(pdftotext "$pdf" -) || return 1
  for words in "Łódź, Köln and the sea" North Capital; do
    printf '%s\n' "$text" | grep -qF "$words" || { printf 'not "%s" in:\n%s\n' "$words" "$text"; return 1; }
  done
  qpdf_finds_no_fault
}

# The drawing has the same place and size, to 0.1 mm, whether Inkscape opens the PDF or the SVG.
inkscape_measures_alike() {
  local here there
  here=$(inkscape --query-all "$pdf" 2>/dev/null | head -n 1)
  there=$(inkscape --query-all "$page" 2>/dev/null | head -n 1)
  printf '%s\n%s\n' "$here" "$there" | awk -F, '
    NR == 1 { split($0, a, ",") }
    NR == 2 { for (i = 2; i <= 5; i++) { d = (a[i] - $i) * 25.4 / 96; if (d > 0.1 || d < -0.1) bad = 1 } }
    END { exit bad || NR != 2 }' || { echo "the PDF measures $here, the SVG $there"; return 1; }
}

check_pdf() { # check_pdf PICTURE PROFILE WIDTH_MM HEIGHT_MM: the page of check_page again as PDF
  pdf=$out/$name.pdf
  check "the program makes a PDF" "$program" convert "$1" -o "$pdf" --profile "$2"
  check_pdf_file "$3" "$4" 1 "$(basename "$1")"
}

check_pdf_file() { # check_pdf_file WIDTH_MM HEIGHT_MM PAGES TITLE: the file $pdf, whose first page is the SVG $page
  [ -s "$pdf" ] || return 0
  check "qpdf finds no fault in the PDF" qpdf_finds_no_fault
  check "pdfinfo sees the size, the tags and the title" pdfinfo_says "$1" "$2" "$3" "$4"
  check "the words are tagged" words_are_tagged "$3"
  check "the PDF is black alone" is_black_alone
  check "pdftoppm renders it without a word" says_nothing pdftoppm -r $PRINT_DPI -gray -png -singlefile "$pdf" "$out/$name.poppler"
  PRINT_FAR=$POPPLER_FAR check "pdftoppm renders what resvg renders" pdf_is_drawn_alike "$out/$name.poppler.png"
  check "mutool renders it without a word" says_nothing mutool draw -q -r $PRINT_DPI -c gray -o "$out/$name.mupdf.png" "$pdf" 1
  check "mutool renders what resvg renders" pdf_is_drawn_alike "$out/$name.mupdf.png"
  check "Ghostscript renders it without a word" \
    says_nothing gs -q -dNOPAUSE -dBATCH -sDEVICE=pnggray -r$PRINT_DPI -sOutputFile="$out/$name.gs.png" "$pdf"
  check "Inkscape imports the PDF" inkscape "$pdf" --export-area-page --export-dpi=96 --export-filename="$out/$name.pdf.png"
  check "Inkscape's sheet of the PDF has its true size" has_pixels "$out/$name.pdf.png" "$1" "$2" 96
  check "Inkscape measures the PDF and the SVG alike" inkscape_measures_alike
}

# Ghostscript prints less with a layer switched off, each of them; without the figure, less than without any part of it.
layers_can_be_switched_off() {
  local page_text=$out/$name.qdf.pdf whole less layers number label fault=0 figure='' least=1
  black() { gs -q -o - -sDEVICE=inkcov "$1" | awk '{ print $4 }'; }
  is_less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }
  whole=$(black "$page_text")
  layers=$(LC_ALL=C awk '/^[0-9]+ 0 obj/ { number = $1 } /^  \/Name \(/ { name = $0; sub(/.*\(/, "", name); sub(/\).*/, "", name) }
    /^  \/Type \/OCG/ { print number, name }' "$page_text")
  [ "$(printf '%s\n' "$layers" | wc -l)" = "$1" ] || { printf 'not %s layers:\n%s\n' "$1" "$layers"; return 1; }
  while read -r number label; do
    sed "s#^      /Name (Layers)#& /OFF [ $number 0 R ]#" "$page_text" | fix-qdf >"$out/$name.off.pdf"
    less=$(black "$out/$name.off.pdf")
    is_less "$less" "$whole" || { echo "without the layer $label there is $less of black, with it $whole"; fault=1; }
    case $label in
    Figure) figure=$less ;;
    Texture* | Lines) is_less "$least" "$less" || least=$less ;;
    esac
  done <<<"$layers"
  is_less "$figure" "$least" || { echo "without the figure there is $figure of black, without its parts $least"; fault=1; }
  return $fault
}

check_layers() { # check_layers PICTURE LAYERS: on the PDF that check_page made of it
  name=$(basename "$1").swell-a4
  check "Ghostscript can switch off each layer" layers_can_be_switched_off "$2"
}

check_calibration() { # the sheets of samples, which are several pages of one PDF
  # poppler moves upright lines to whole pixels, and this sheet has little else. Measured: 0.139.
  local PRINT_FAR=0.20
  name=calibration
  page=$out/$name-1.svg
  pdf=$out/$name.pdf
  check "the program makes the sheets as SVG" "$program" calibrate -o "$out/$name.svg"
  check "the program makes the sheets as PDF" "$program" calibrate -o "$pdf"
  check_pdf_file 210 297 4 "Calibration sheet for swell-a4"
}

check_sheets() { # a picture on two by two sheets with its overview, as one PDF
  local PRINT_FAR=0.20 # as for the calibration: ticks are upright lines
  name=sheets
  page=$out/$name-1.svg
  pdf=$out/$name.pdf
  check "the program spreads a picture as SVG" "$program" convert samples/landscape.svg --sheets 2x2 -o "$out/$name.svg"
  check "the program spreads a picture as PDF" "$program" convert samples/landscape.svg --sheets 2x2 -o "$pdf"
  check_pdf_file 297 210 5 "landscape.svg"
}

png_is_fine() {
  local said
  said=$(pngcheck -v "$png") || { echo "$said"; return 1; }
  # 300 dots per inch are 11811.02 a metre
  case $said in *"1-bit grayscale"*"11811x11811 pixels/meter"*) ;; *) echo "$said"; return 1 ;; esac
}

check_png() { # check_png PICTURE PROFILE WIDTH_MM HEIGHT_MM: the page of check_page again as PNG
  png=$out/$name.page.png
  check "the program makes a PNG" "$program" convert "$1" -o "$png" --profile "$2" --dpi $PNG_DPI
  [ -s "$png" ] || return 0
  check "the PNG has its true size" has_pixels "$png" "$3" "$4" $PNG_DPI
  check "pngcheck finds bits, a size in metres and no fault" png_is_fine
}
