# Deutsch

place-1 = oben links
place-2 = oben in der Mitte
place-3 = oben rechts
place-4 = links in der Mitte
place-5 = in der Mitte
place-6 = rechts in der Mitte
place-7 = unten links
place-8 = unten in der Mitte
place-9 = unten rechts

percent = { $size ->
    [under] weniger als 1 %
    [over] mehr als 99 %
   *[is] { $percent } %
}

title-of-key = { $title }, Legende
title-of-overview = { $title }, Übersicht
title-of-sheet = { $title }, Blatt { $sheet }
title = Die Seite heißt „{ $title }“.
sheet = Ein Blatt im { $orientation ->
    [across] Querformat
   *[upright] Hochformat
}, { $width } mal { $height } mm, mit einer Abbildung von { $across } mal { $down } mm; sie hat { $lines ->
    [0] keine Linien
    [one] 1 Linie
   *[other] { $lines } Linien
} und { $areas ->
    [0] keine Flächen mit Textur
    [one] 1 Fläche mit Textur
   *[other] { $areas } Flächen mit Textur
}.
sheet-of-key = Ein Blatt im { $orientation ->
    [across] Querformat
   *[upright] Hochformat
}, { $width } mal { $height } mm, mit einer Legende{ $patches ->
    [0] {""}
    [one] {" "}und 1 Feld mit Textur
   *[other] {" "}und { $patches } Feldern mit Textur
}.

shape-round = Ein geschlossener runder Umriss { $place }, { $across } mm im Durchmesser{ $holds ->
    [0] {""}
    [one] ; darin liegt ein kleinerer
   *[other] ; darin liegen { $holds } kleinere
}.
shape-closed = Ein geschlossener Umriss { $place }, { $width } mm breit und { $height } mm hoch{ $holds ->
    [0] {""}
    [one] ; darin liegt ein kleinerer
   *[other] ; darin liegen { $holds } kleinere
}.
line-level = Eine gerade waagerechte Linie { $place }, { $length } mm lang{ $long ->
    [yes] , über den größten Teil der Abbildung
   *[no] {""}
}.
line-upright = Eine gerade senkrechte Linie { $place }, { $length } mm lang{ $long ->
    [yes] , über den größten Teil der Abbildung
   *[no] {""}
}.
line-slanting = Eine gerade schräge Linie { $place }, { $length } mm lang.
line-bent = Eine gebogene Linie { $place }, { $length } mm lang.
line-bowed = Eine gebogene Linie { $place }, { $length } mm lang, bis zu { $off } mm { $way ->
    [left] links von
    [up] über
    [right] rechts von
   *[down] unter
} der Geraden zwischen ihren Enden.
line-winding = Eine geschlängelte Linie { $place }, { $length } mm lang, bis zu { $off } mm neben der
    Geraden zwischen ihren Enden.
arrow = Ein Pfeil { $place }, { $length } mm lang; seine Spitze zeigt { $way ->
    [left] nach links
    [up] nach oben
    [down] nach unten
    [up-right] nach rechts oben
    [up-left] nach links oben
    [down-right] nach rechts unten
    [down-left] nach links unten
   *[right] nach rechts
}.
arrow-both = Eine Linie { $place }, { $length } mm lang, mit einer Pfeilspitze an jedem Ende.
shape-stands = Ein Rechteck { $place }, das eine Linie { $side ->
    [above] oben
    [left] links
    [right] rechts
   *[below] unten
} schließt, { $width } mm breit und { $height } mm hoch.
shape-open = Ein Rechteck { $place }, { $side ->
    [above] oben
    [left] links
    [right] rechts
   *[below] unten
} offen, { $width } mm breit und { $height } mm hoch.
lines-more = { $lines ->
    [one] 1 weitere Linie ist kürzer als diese.
   *[other] { $lines } weitere Linien sind kürzer als diese.
}
lines-more-as-long = { $lines ->
    [one] 1 weitere Linie ist nicht länger als diese.
   *[other] { $lines } weitere Linien sind nicht länger als diese.
}
point = Ein Punkt { $place }, { $across } mm im Durchmesser.
points = { $count } Punkte, bis zu { $across } mm im Durchmesser.
arrows = { $count ->
    [one] Eine Linie endet in einer Pfeilspitze.
   *[other] { $count } Linien enden in Pfeilspitzen.
}
ticks = { $count ->
    [one] 1 Teilstrich steht an einer Linie.
   *[other] { $count } Teilstriche stehen an Linien.
}
points-filled = { $count ->
    [one] 1 gefüllter Punkt liegt auf einer Linie.
   *[other] { $count } gefüllte Punkte liegen auf Linien.
}
points-hollow = { $count ->
    [one] 1 hohler Punkt liegt auf einer Linie.
   *[other] { $count } hohle Punkte liegen auf Linien.
}

colours-are-names = yes
area = Die Farbe { $colour } bedeckt { $share } der Abbildung{ $areas ->
    [one] , vor allem { $place }
   *[other] {" "}in { $areas } Flächen, die größte { $place }
}.
blank = { $share } der Abbildung haben keine Textur.

braille-title = Der Titel in Braille lautet „{ $text }“.
braille-number = Die Seitenzahl in Braille ist { $text }.
braille-label = Eine Beschriftung { $place } lautet „{ $text }“.
braille-key = In der Legende steht „{ $text }“.

overview = Unter der Abbildung liegt eine Übersicht von { $width } mal { $height } mm mit { $lines ->
    [0] keinen Linien
    [one] 1 Linie
   *[other] { $lines } Linien
}.
overview-follows = Auf dem nächsten Blatt folgt eine Übersicht nur mit Linien.
overview-alone = Dies ist die Übersicht, nur mit Linien.
overview-of-sheets = Dies ist die Übersicht eines Bildes auf { $sheets } Blättern, nur mit Linien.
sheet-of-sheets = Dies ist Blatt { $name } von { $sheets } ({ $names }), mit einem Buchstaben für jede Zeile von oben und einer
    Zahl für jede Spalte von links.

left-out = { $length } mm Konturen, { $share }, hatten keinen Platz und fehlen.
left-out-most = { $length } mm Konturen, { $share }, hatten keinen Platz und fehlen, die meisten { $place }.
left-out-of-sheets = Auf allen { $sheets } Blättern zusammen hatten { $length } mm Konturen, { $share }, keinen Platz
    und fehlen.
areas-left-out = { $count ->
    [one] 1 Fläche war beim Erstellen der Seite zu klein für eine Textur.
   *[other] { $count } Flächen waren beim Erstellen der Seite zu klein für eine Textur.
}
texts-left-out = { $count ->
    [one] 1 Text des Bildes wurde beim Erstellen der Seite weggelassen.
   *[other] { $count } Texte des Bildes wurden beim Erstellen der Seite weggelassen.
}
labels-left-out = { $count ->
    [one] 1 Beschriftung wurde beim Erstellen der Seite weggelassen.
   *[other] { $count } Beschriftungen wurden beim Erstellen der Seite weggelassen.
}

verdict = Urteil: { $errors ->
    [one] 1 Fehler
   *[other] { $errors } Fehler
}{ $faulty ->
    [none] {""}
   *[other] {" "}auf { $faulty } der Abbildung
}, { $warnings ->
    [one] 1 Warnung
   *[other] { $warnings } Warnungen
}{ $lines ->
    [none] {""}
   *[other] ; { $lines }
}{ $missing ->
    [none] {""}
   *[other] ; { $missing } der Konturen des Bildes fehlen auf der Seite
}{ $textures ->
    [none] {""}
   *[other] ; { $textures }
}.
verdict-lines = manche Linien sind kaum zu verfolgen, weil Reihen von Texturen dicht neben ihnen liegen: Texturen
    weglassen oder größer zeichnen
verdict-textures = eine Fingerkuppe liest { $right } der Texturen richtig{ $wrong ->
    [none] {""}
   *[other] {" "}und { $wrong } falsch
}{ $rest ->
    [none] {""}
   *[other] ; der Rest liegt zu nah an Linien und Rändern, um beurteilt zu werden
}
verdict-textures-few = nur { $judged } der Texturen liegen mindestens { $from } mm von Linien und Rändern, wo eine
    Fingerkuppe nichts anderes fühlt; wie sie den Rest liest, ist nicht bekannt: größer oder mit weniger Linien
    gezeichnet sind die Flächen breiter
verdict-textures-near = alle Texturen liegen näher als { $from } mm an Linien oder Rändern, so dass eine Fingerkuppe
    auch diese fühlt; wie sie sie liest, ist nicht bekannt: größer oder mit weniger Linien gezeichnet sind die Flächen
    breiter
verdict-textures-large = die Texturen waren nicht zu beurteilen, weil die Seite für das Modell einer Fingerkuppe zu groß ist
