# Français

place-1 = en haut à gauche
place-2 = en haut au milieu
place-3 = en haut à droite
place-4 = au milieu à gauche
place-5 = au milieu
place-6 = au milieu à droite
place-7 = en bas à gauche
place-8 = en bas au milieu
place-9 = en bas à droite

percent = { $size ->
    [under] moins de 1 %
    [over] plus de 99 %
   *[is] { $percent } %
}

title-of-key = { $title }, légende
title-of-overview = { $title }, vue d’ensemble
title-of-sheet = { $title }, feuille { $sheet }
title = La page s’appelle « { $title } ».
sheet = Une feuille { $orientation ->
    [across] en largeur
   *[upright] en hauteur
}, de { $width } sur { $height } mm, avec une figure de { $across } sur { $down } mm qui compte { $lines ->
    [0] aucune ligne
    [one] { $lines } ligne
   *[other] { $lines } lignes
} et { $areas ->
    [0] aucune surface à texture
    [one] { $areas } surface à texture
   *[other] { $areas } surfaces à texture
}.
sheet-of-key = Une feuille { $orientation ->
    [across] en largeur
   *[upright] en hauteur
}, de { $width } sur { $height } mm, avec une légende{ $patches ->
    [0] {""}
    [one] {" "}et { $patches } échantillon de texture
   *[other] {" "}et { $patches } échantillons de texture
}.

shape-round = Un contour fermé rond { $place }, de { $across } mm de diamètre{ $holds ->
    [0] {""}
    [one] {" "}; il en contient un plus petit
   *[other] {" "}; il en contient { $holds } plus petits
}.
shape-closed = Un contour fermé { $place }, de { $width } mm de large et { $height } mm de haut{ $holds ->
    [0] {""}
    [one] {" "}; il en contient un plus petit
   *[other] {" "}; il en contient { $holds } plus petits
}.
line-level = Une ligne droite horizontale { $place }, longue de { $length } mm{ $long ->
    [yes] , sur la plus grande partie de la figure
   *[no] {""}
}.
line-upright = Une ligne droite verticale { $place }, longue de { $length } mm{ $long ->
    [yes] , sur la plus grande partie de la figure
   *[no] {""}
}.
line-slanting = Une ligne droite oblique { $place }, longue de { $length } mm.
line-bent = Une ligne courbe { $place }, longue de { $length } mm.
line-bowed = Une ligne courbe { $place }, longue de { $length } mm, jusqu’à { $off } mm { $way ->
    [left] à gauche
    [up] au-dessus
    [right] à droite
   *[down] au-dessous
} de la droite entre ses extrémités.
line-winding = Une ligne sinueuse { $place }, longue de { $length } mm, jusqu’à { $off } mm de la droite
    entre ses extrémités.
arrow = Une flèche { $place }, longue de { $length } mm, dont la pointe est dirigée { $way ->
    [left] vers la gauche
    [up] vers le haut
    [down] vers le bas
    [up-right] vers le haut à droite
    [up-left] vers le haut à gauche
    [down-right] vers le bas à droite
    [down-left] vers le bas à gauche
   *[right] vers la droite
}.
arrow-both = Une ligne { $place }, longue de { $length } mm, avec une pointe de flèche à chaque bout.
shape-stands = Un rectangle { $place } fermé { $side ->
    [above] en haut
    [left] à gauche
    [right] à droite
   *[below] en bas
} par une ligne, de { $width } mm de large et { $height } mm de haut.
shape-open = Un rectangle { $place }, ouvert { $side ->
    [above] en haut
    [left] à gauche
    [right] à droite
   *[below] en bas
}, de { $width } mm de large et { $height } mm de haut.
lines-more = { $lines ->
    [one] { $lines } autre ligne est plus courte.
   *[other] { $lines } autres lignes sont plus courtes.
}
lines-more-as-long = { $lines ->
    [one] { $lines } autre ligne n’est pas plus longue.
   *[other] { $lines } autres lignes ne sont pas plus longues.
}
point = Un point { $place }, de { $across } mm de diamètre.
points = { $count } points, de { $across } mm de diamètre au plus.
arrows = { $count ->
    [one] Une ligne se termine par une pointe de flèche.
   *[other] { $count } lignes se terminent par une pointe de flèche.
}
ticks = { $count ->
    [one] 1 graduation sur une ligne.
   *[other] { $count } graduations sur des lignes.
}
points-filled = { $count ->
    [one] 1 point plein sur une ligne.
   *[other] { $count } points pleins sur des lignes.
}
points-hollow = { $count ->
    [one] 1 point creux sur une ligne.
   *[other] { $count } points creux sur des lignes.
}

colours-are-names = no
area = La couleur { $colour } couvre { $share } de la figure{ $areas ->
    [one] , surtout { $place }
   *[other] {" "}en { $areas } surfaces, la plus grande { $place }
}.
blank = Sans texture : { $share } de la figure.

braille-title = Le titre en braille est « { $text } ».
braille-number = Le numéro de page en braille est { $text }.
braille-label = Une étiquette { $place } dit « { $text } ».
braille-key = La légende dit « { $text } ».

overview = Sous la figure se trouve une vue d’ensemble de { $width } sur { $height } mm, avec { $lines ->
    [0] aucune ligne
    [one] { $lines } ligne
   *[other] { $lines } lignes
}.
overview-follows = Une vue d’ensemble en lignes seules suit sur la feuille suivante.
overview-alone = Ceci est la vue d’ensemble, en lignes seules.
overview-of-sheets = Ceci est la vue d’ensemble d’une image sur { $sheets } feuilles, en lignes seules.
sheet-of-sheets = Ceci est la feuille { $name } sur { $sheets } ({ $names }), avec une lettre pour chaque rangée depuis le haut
    et un nombre pour chaque colonne depuis la gauche.

left-out = { $length } mm de contours, { $share }, n’avaient pas de place et manquent.
left-out-most = { $length } mm de contours, { $share }, n’avaient pas de place et manquent, la plupart { $place }.
left-out-of-sheets = Sur l’ensemble des { $sheets } feuilles, { $length } mm de contours, { $share }, n’avaient pas de
    place et manquent.
areas-left-out = { $count ->
    [one] { $count } surface était trop petite pour une texture à la création de la page.
   *[other] { $count } surfaces étaient trop petites pour une texture à la création de la page.
}
texts-left-out = { $count ->
    [one] { $count } texte de l’image a été omis à la création de la page.
   *[other] { $count } textes de l’image ont été omis à la création de la page.
}
labels-left-out = { $count ->
    [one] { $count } étiquette a été omise à la création de la page.
   *[other] { $count } étiquettes ont été omises à la création de la page.
}

verdict = Verdict : { $errors ->
    [one] { $errors } erreur
   *[other] { $errors } erreurs
}{ $faulty ->
    [none] {""}
   *[other] {" "}sur { $faulty } de la figure
}, { $warnings ->
    [one] { $warnings } avertissement
   *[other] { $warnings } avertissements
}{ $lines ->
    [none] {""}
   *[other] {" "}; { $lines }
}{ $missing ->
    [none] {""}
   *[other] {" "}; { $missing } des contours de l’image ne sont pas sur la page
}{ $textures ->
    [none] {""}
   *[other] {" "}; { $textures }
}.
verdict-lines = certaines lignes sont difficiles à suivre, car des rangées de textures sont tout près d’elles :
    il faut omettre des textures ou dessiner plus grand
verdict-textures = un bout de doigt lit correctement { $right } des textures{ $wrong ->
    [none] {""}
   *[other] {" "}et { $wrong } de travers
}{ $rest ->
    [none] {""}
   *[other] {" "}; le reste est trop près des lignes et des bords pour être jugé
}
verdict-textures-few = seulement { $judged } des textures sont à { $from } mm ou plus des lignes et des bords, où un
    bout de doigt ne sent rien d’autre ; on ne sait pas comment il lit le reste : une figure plus grande, ou avec
    moins de lignes, a des surfaces plus larges
verdict-textures-near = toutes les textures sont à moins de { $from } mm de lignes ou de bords, qu’un bout de doigt
    sent aussi ; on ne sait pas comment il les lit : une figure plus grande, ou avec moins de lignes, a des surfaces
    plus larges
verdict-textures-large = les textures n’ont pas pu être jugées, car la page est trop grande pour le modèle d’un bout de doigt
