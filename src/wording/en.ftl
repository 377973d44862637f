# What is said of a page. Syntax: https://projectfluent.org/fluent/guide. Blanks and line ends count as one blank.
# Places are said within a sentence; colours have their names from the braille tables.

place-1 = in the upper left
place-2 = in the upper middle
place-3 = in the upper right
place-4 = in the middle left
place-5 = in the middle
place-6 = in the middle right
place-7 = in the lower left
place-8 = in the lower middle
place-9 = in the lower right

# $size: under (less than 1), over (more than 99) or is
percent = { $size ->
    [under] under 1 %
    [over] over 99 %
   *[is] { $percent } %
}

title-of-key = { $title }, key
title-of-overview = { $title }, overview
title-of-sheet = { $title }, sheet { $sheet }
title = The page is called "{ $title }".
# $orientation: across or upright
sheet = A sheet { $orientation ->
    [across] that lies across
   *[upright] upright
}, { $width } by { $height } mm, with a figure of { $across } by { $down } mm that has { $lines ->
    [0] no lines
    [one] 1 line
   *[other] { $lines } lines
} and { $areas ->
    [0] no textured areas
    [one] 1 textured area
   *[other] { $areas } textured areas
}.
sheet-of-key = A sheet { $orientation ->
    [across] that lies across
   *[upright] upright
}, { $width } by { $height } mm, with a key{ $patches ->
    [0] {""}
    [one] {" "}and 1 patch of a texture
   *[other] {" "}and { $patches } patches of textures
}.

# $holds: how many closed outlines lie inside
shape-round = A closed round outline { $place }, { $across } mm across{ $holds ->
    [0] {""}
    [one] ; it contains a smaller one
   *[other] ; it contains { $holds } smaller ones
}.
shape-closed = A closed outline { $place }, { $width } mm wide and { $height } mm high{ $holds ->
    [0] {""}
    [one] ; it contains a smaller one
   *[other] ; it contains { $holds } smaller ones
}.
# $long: yes or no
line-level = A straight level line { $place }, { $length } mm long{ $long ->
    [yes] , across most of the figure
   *[no] {""}
}.
line-upright = A straight upright line { $place }, { $length } mm long{ $long ->
    [yes] , across most of the figure
   *[no] {""}
}.
line-slanting = A straight slanting line { $place }, { $length } mm long.
line-bent = A bent line { $place }, { $length } mm long.
# $way: on which side it lies
line-bowed = A bent line { $place }, { $length } mm long, up to { $off } mm { $way ->
    [left] left of
    [up] above
    [right] right of
   *[down] below
} the straight between its ends.
line-winding = A winding line { $place }, { $length } mm long, up to { $off } mm off the straight between
    its ends.
# $way: where the head points
arrow = An arrow { $place }, { $length } mm long, whose head points { $way ->
    [left] to the left
    [up] up
    [down] down
    [up-right] up and to the right
    [up-left] up and to the left
    [down-right] down and to the right
    [down-left] down and to the left
   *[right] to the right
}.
arrow-both = A line { $place }, { $length } mm long, with an arrowhead at each end.
# a bar of a chart on its axis
shape-stands = A rectangle { $place } that a line closes { $side ->
    [above] at the top
    [left] on the left
    [right] on the right
   *[below] at the bottom
}, { $width } mm wide and { $height } mm high.
shape-open = A rectangle { $place }, open { $side ->
    [above] at the top
    [left] on the left
    [right] on the right
   *[below] at the bottom
}, { $width } mm wide and { $height } mm high.
lines-more = { $lines ->
    [one] 1 more line is shorter than these.
   *[other] { $lines } more lines are shorter than these.
}
# where the longest of them is as long as the last that is told
lines-more-as-long = { $lines ->
    [one] 1 more line is no longer than these.
   *[other] { $lines } more lines are no longer than these.
}
# points beside all lines; of more than three only how many there are
point = A point { $place }, { $across } mm across.
points = { $count } points, up to { $across } mm across.
# marks on lines of dots
arrows = { $count ->
    [one] One line ends in an arrowhead.
   *[other] { $count } lines end in arrowheads.
}
ticks = { $count ->
    [one] 1 tick stands on a line.
   *[other] { $count } ticks stand on lines.
}
points-filled = { $count ->
    [one] 1 filled point lies on a line.
   *[other] { $count } filled points lie on lines.
}
points-hollow = { $count ->
    [one] 1 hollow point lies on a line.
   *[other] { $count } hollow points lie on lines.
}

# yes where the name of a colour has a capital letter, as a name
colours-are-names = no
area = The colour { $colour } covers { $share } of the figure{ $areas ->
    [one] , mainly { $place }
   *[other] {" "}in { $areas } areas, the largest { $place }
}.
blank = { $share } of the figure has no texture.

braille-title = The title in braille is "{ $text }".
braille-number = The page number in braille is { $text }.
braille-label = A label { $place } says "{ $text }".
braille-key = The key says "{ $text }".

overview = Below the figure is an overview of { $width } by { $height } mm, with { $lines ->
    [0] no lines
    [one] 1 line
   *[other] { $lines } lines
}.
overview-follows = An overview of lines only follows on the next sheet.
overview-alone = This is the overview, with lines only.
overview-of-sheets = This is the overview of a picture on { $sheets } sheets, with lines only.
sheet-of-sheets = This is sheet { $name } of { $sheets } ({ $names }), with a letter for each row from the top and a number
    for each column from the left.

left-out = { $length } mm of contours, { $share }, had no room and are left out.
left-out-most = { $length } mm of contours, { $share }, had no room and are left out, most of them { $place }.
# of a picture on several sheets, of which each says it
left-out-of-sheets = On all { $sheets } sheets together { $length } mm of contours, { $share }, had no room and are
    left out.
# counts when the page was made: somebody may have written labels since
areas-left-out = { $count ->
    [one] 1 area was too small for a texture when the page was made.
   *[other] { $count } areas were too small for a texture when the page was made.
}
texts-left-out = { $count ->
    [one] 1 text of the picture was left out when the page was made.
   *[other] { $count } texts of the picture were left out when the page was made.
}
labels-left-out = { $count ->
    [one] 1 label was left out when the page was made.
   *[other] { $count } labels were left out when the page was made.
}

# $faulty, $lines, $missing, $textures: none, or words
verdict = Verdict: { $errors ->
    [one] 1 error
   *[other] { $errors } errors
}{ $faulty ->
    [none] {""}
   *[other] {" "}in { $faulty } of the figure's area
}, { $warnings ->
    [one] 1 warning
   *[other] { $warnings } warnings
}{ $lines ->
    [none] {""}
   *[other] ; { $lines }
}{ $missing ->
    [none] {""}
   *[other] ; { $missing } of the picture's contours are not on the page
}{ $textures ->
    [none] {""}
   *[other] ; { $textures }
}.
verdict-lines = some lines can hardly be followed, as rows of textures lie close beside them: leave textures out, or
    draw the picture larger
verdict-textures = a fingertip reads { $right } of the textures right{ $wrong ->
    [none] {""}
   *[other] {" "}and { $wrong } wrong
}{ $rest ->
    [none] {""}
   *[other] ; the rest lies too near to lines and borders to be judged
}
verdict-textures-few = only { $judged } of the textures is { $from } mm or more from lines and borders, where a
    fingertip feels nothing else; how it reads the rest is not known: a larger figure, or one with fewer lines, has
    wider areas
verdict-textures-near = all textures are nearer than { $from } mm to lines or borders, so that a fingertip feels these
    as well; how it reads them is not known: a larger figure, or one with fewer lines, has wider areas
verdict-textures-large = the textures could not be judged, as the page is too large for the model of a fingertip
