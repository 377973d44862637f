# Polski

place-1 = u góry po lewej
place-2 = u góry pośrodku
place-3 = u góry po prawej
place-4 = pośrodku po lewej
place-5 = pośrodku
place-6 = pośrodku po prawej
place-7 = u dołu po lewej
place-8 = u dołu pośrodku
place-9 = u dołu po prawej

percent = { $size ->
    [under] mniej niż 1 %
    [over] ponad 99 %
   *[is] { $percent } %
}

title-of-key = { $title }, legenda
title-of-overview = { $title }, podgląd
title-of-sheet = { $title }, arkusz { $sheet }
title = Strona nosi tytuł „{ $title }”.
sheet = Arkusz { $orientation ->
    [across] poziomy
   *[upright] pionowy
}, { $width } na { $height } mm, z rysunkiem { $across } na { $down } mm; liczba linii: { $lines }, liczba pól z fakturą:
    { $areas }.
sheet-of-key = Arkusz { $orientation ->
    [across] poziomy
   *[upright] pionowy
}, { $width } na { $height } mm, z legendą; liczba próbek faktury: { $patches }.

shape-round = Zamknięty okrągły kontur { $place }, o średnicy { $across } mm{ $holds ->
    [0] {""}
    [one] ; zawiera 1 mniejszy
    [few] ; zawiera { $holds } mniejsze
   *[other] ; zawiera { $holds } mniejszych
}.
shape-closed = Zamknięty kontur { $place }, szerokości { $width } mm i wysokości { $height } mm{ $holds ->
    [0] {""}
    [one] ; zawiera 1 mniejszy
    [few] ; zawiera { $holds } mniejsze
   *[other] ; zawiera { $holds } mniejszych
}.
line-level = Prosta pozioma linia { $place }, długości { $length } mm{ $long ->
    [yes] , przez większą część rysunku
   *[no] {""}
}.
line-upright = Prosta pionowa linia { $place }, długości { $length } mm{ $long ->
    [yes] , przez większą część rysunku
   *[no] {""}
}.
line-slanting = Prosta ukośna linia { $place }, długości { $length } mm.
line-bent = Zagięta linia { $place }, długości { $length } mm.
line-bowed = Zagięta linia { $place }, długości { $length } mm, do { $off } mm { $way ->
    [left] na lewo od prostej
    [up] nad prostą
    [right] na prawo od prostej
   *[down] pod prostą
} między jej końcami.
line-winding = Kręta linia { $place }, długości { $length } mm, do { $off } mm od prostej między jej
    końcami.
arrow = Strzałka { $place }, długości { $length } mm; jej grot wskazuje { $way ->
    [left] w lewo
    [up] w górę
    [down] w dół
    [up-right] w górę i w prawo
    [up-left] w górę i w lewo
    [down-right] w dół i w prawo
    [down-left] w dół i w lewo
   *[right] w prawo
}.
arrow-both = Linia { $place }, długości { $length } mm, z grotem strzałki na każdym końcu.
shape-stands = Prostokąt { $place }, zamknięty { $side ->
    [above] u góry
    [left] z lewej strony
    [right] z prawej strony
   *[below] u dołu
} linią, szerokości { $width } mm i wysokości { $height } mm.
shape-open = Prostokąt { $place }, otwarty { $side ->
    [above] u góry
    [left] z lewej strony
    [right] z prawej strony
   *[below] u dołu
}, szerokości { $width } mm i wysokości { $height } mm.
lines-more = { $lines ->
    [one] 1 dalsza linia jest krótsza od tych.
    [few] { $lines } dalsze linie są krótsze od tych.
   *[other] { $lines } dalszych linii jest krótszych od tych.
}
lines-more-as-long = { $lines ->
    [one] 1 dalsza linia nie jest dłuższa od tych.
    [few] { $lines } dalsze linie nie są dłuższe od tych.
   *[other] { $lines } dalszych linii nie jest dłuższych od tych.
}
point = Punkt { $place }, o średnicy { $across } mm.
points = Punkty: { $count }, o średnicy do { $across } mm.
arrows = { $count ->
    [one] Jedna linia kończy się strzałką.
    [few] { $count } linie kończą się strzałką.
   *[many] { $count } linii kończy się strzałką.
}
ticks = { $count ->
    [one] 1 kreska podziałki na linii.
    [few] { $count } kreski podziałki na liniach.
   *[other] { $count } kresek podziałki na liniach.
}
points-filled = { $count ->
    [one] 1 pełny punkt na linii.
    [few] { $count } pełne punkty na liniach.
   *[other] { $count } pełnych punktów na liniach.
}
points-hollow = { $count ->
    [one] 1 pusty punkt na linii.
    [few] { $count } puste punkty na liniach.
   *[other] { $count } pustych punktów na liniach.
}

colours-are-names = no
area = Kolor { $colour } zajmuje { $share } rysunku{ $areas ->
    [one] , głównie { $place }
    [few] {" "}w { $areas } polach, największe { $place }
   *[other] {" "}w { $areas } polach, największe { $place }
}.
blank = Bez faktury: { $share } rysunku.

braille-title = Tytuł w brajlu: „{ $text }”.
braille-number = Numer strony w brajlu: { $text }.
braille-label = Podpis { $place }: „{ $text }”.
braille-key = Legenda: „{ $text }”.

overview = Pod rysunkiem jest podgląd { $width } na { $height } mm, który ma { $lines ->
    [0] 0 linii
    [one] 1 linię
    [few] { $lines } linie
   *[other] { $lines } linii
}.
overview-follows = Na następnym arkuszu jest podgląd z samych linii.
overview-alone = To jest podgląd z samych linii.
overview-of-sheets = To jest podgląd z samych linii; liczba arkuszy całego obrazu: { $sheets }.
sheet-of-sheets = To jest arkusz { $name }; liczba arkuszy: { $sheets } ({ $names }); litera oznacza rząd od góry, liczba kolumnę od
    lewej.

left-out = Na { $length } mm konturów, { $share }, nie było miejsca; brakuje ich.
left-out-most = Na { $length } mm konturów, { $share }, nie było miejsca; brakuje ich, najwięcej { $place }.
left-out-of-sheets = Na wszystkich arkuszach razem ({ $sheets }) nie było miejsca na { $length } mm konturów, { $share };
    brakuje ich.
areas-left-out = { $count ->
    [one] Przy tworzeniu strony 1 pole było za małe na fakturę.
    [few] Przy tworzeniu strony { $count } pola były za małe na fakturę.
   *[other] Przy tworzeniu strony { $count } pól było za małych na fakturę.
}
texts-left-out = { $count ->
    [one] Przy tworzeniu strony pominięto 1 tekst obrazu.
    [few] Przy tworzeniu strony pominięto { $count } teksty obrazu.
   *[other] Przy tworzeniu strony pominięto { $count } tekstów obrazu.
}
labels-left-out = { $count ->
    [one] Przy tworzeniu strony pominięto 1 podpis.
    [few] Przy tworzeniu strony pominięto { $count } podpisy.
   *[other] Przy tworzeniu strony pominięto { $count } podpisów.
}

verdict = Ocena: { $errors ->
    [one] 1 błąd
    [few] { $errors } błędy
   *[other] { $errors } błędów
}{ $faulty ->
    [none] {""}
   *[other] {" "}na { $faulty } rysunku
}, { $warnings ->
    [one] 1 ostrzeżenie
    [few] { $warnings } ostrzeżenia
   *[other] { $warnings } ostrzeżeń
}{ $lines ->
    [none] {""}
   *[other] ; { $lines }
}{ $missing ->
    [none] {""}
   *[other] ; na stronie brakuje { $missing } konturów obrazu
}{ $textures ->
    [none] {""}
   *[other] ; { $textures }
}.
verdict-lines = niektóre linie trudno śledzić, bo tuż obok nich leżą rzędy faktur: lepiej pominąć faktury albo
    narysować obraz większy
verdict-textures = opuszek palca odczytuje dobrze { $right } faktur{ $wrong ->
    [none] {""}
   *[other] {" "}i źle { $wrong }
}{ $rest ->
    [none] {""}
   *[other] ; reszta leży zbyt blisko linii i brzegów, by ją ocenić
}
verdict-textures-few = tylko { $judged } faktur leży co najmniej { $from } mm od linii i brzegów, gdzie opuszek palca
    nie czuje nic innego; nie wiadomo, jak odczytuje resztę: większy rysunek albo rysunek z mniejszą liczbą linii ma
    szersze pola
verdict-textures-near = wszystkie faktury leżą bliżej niż { $from } mm od linii lub brzegów, które opuszek palca też
    czuje; nie wiadomo, jak je odczytuje: większy rysunek albo rysunek z mniejszą liczbą linii ma szersze pola
verdict-textures-large = faktur nie dało się ocenić, bo strona jest za duża dla modelu opuszka palca
