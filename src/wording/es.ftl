# Español

place-1 = arriba a la izquierda
place-2 = arriba en el centro
place-3 = arriba a la derecha
place-4 = en el centro a la izquierda
place-5 = en el centro
place-6 = en el centro a la derecha
place-7 = abajo a la izquierda
place-8 = abajo en el centro
place-9 = abajo a la derecha

percent = { $size ->
    [under] menos del 1 %
    [over] más del 99 %
   *[is] { $percent } %
}

title-of-key = { $title }, leyenda
title-of-overview = { $title }, vista general
title-of-sheet = { $title }, hoja { $sheet }
title = La página se llama «{ $title }».
sheet = Una hoja { $orientation ->
    [across] horizontal
   *[upright] vertical
}, de { $width } por { $height } mm, con una figura de { $across } por { $down } mm que tiene { $lines ->
    [0] ninguna línea
    [one] 1 línea
   *[other] { $lines } líneas
} y { $areas ->
    [0] ninguna superficie con textura
    [one] 1 superficie con textura
   *[other] { $areas } superficies con textura
}.
sheet-of-key = Una hoja { $orientation ->
    [across] horizontal
   *[upright] vertical
}, de { $width } por { $height } mm, con una leyenda{ $patches ->
    [0] {""}
    [one] {" "}y 1 muestra de textura
   *[other] {" "}y { $patches } muestras de textura
}.

shape-round = Un contorno cerrado redondo { $place }, de { $across } mm de diámetro{ $holds ->
    [0] {""}
    [one] ; contiene uno más pequeño
   *[other] ; contiene { $holds } más pequeños
}.
shape-closed = Un contorno cerrado { $place }, de { $width } mm de ancho y { $height } mm de alto{ $holds ->
    [0] {""}
    [one] ; contiene uno más pequeño
   *[other] ; contiene { $holds } más pequeños
}.
line-level = Una línea recta horizontal { $place }, de { $length } mm de largo{ $long ->
    [yes] , a lo largo de la mayor parte de la figura
   *[no] {""}
}.
line-upright = Una línea recta vertical { $place }, de { $length } mm de largo{ $long ->
    [yes] , a lo largo de la mayor parte de la figura
   *[no] {""}
}.
line-slanting = Una línea recta inclinada { $place }, de { $length } mm de largo.
line-bent = Una línea curva { $place }, de { $length } mm de largo.
line-bowed = Una línea curva { $place }, de { $length } mm de largo, hasta { $off } mm { $way ->
    [left] a la izquierda
    [up] por encima
    [right] a la derecha
   *[down] por debajo
} de la recta entre sus extremos.
line-winding = Una línea sinuosa { $place }, de { $length } mm de largo, hasta { $off } mm de la recta
    entre sus extremos.
arrow = Una flecha { $place }, de { $length } mm de largo, cuya punta señala { $way ->
    [left] a la izquierda
    [up] hacia arriba
    [down] hacia abajo
    [up-right] hacia arriba a la derecha
    [up-left] hacia arriba a la izquierda
    [down-right] hacia abajo a la derecha
    [down-left] hacia abajo a la izquierda
   *[right] a la derecha
}.
arrow-both = Una línea { $place }, de { $length } mm de largo, con una punta de flecha en cada extremo.
shape-stands = Un rectángulo { $place } que una línea cierra { $side ->
    [above] por arriba
    [left] por la izquierda
    [right] por la derecha
   *[below] por abajo
}, de { $width } mm de ancho y { $height } mm de alto.
shape-open = Un rectángulo { $place }, abierto { $side ->
    [above] por arriba
    [left] por la izquierda
    [right] por la derecha
   *[below] por abajo
}, de { $width } mm de ancho y { $height } mm de alto.
lines-more = { $lines ->
    [one] 1 línea más es más corta que estas.
   *[other] { $lines } líneas más son más cortas que estas.
}
lines-more-as-long = { $lines ->
    [one] 1 línea más no es más larga que estas.
   *[other] { $lines } líneas más no son más largas que estas.
}
point = Un punto { $place }, de { $across } mm de diámetro.
points = { $count } puntos, de { $across } mm de diámetro como máximo.
arrows = { $count ->
    [one] Una línea termina en punta de flecha.
   *[other] { $count } líneas terminan en punta de flecha.
}
ticks = { $count ->
    [one] 1 marca de escala en una línea.
   *[other] { $count } marcas de escala en líneas.
}
points-filled = { $count ->
    [one] 1 punto relleno en una línea.
   *[other] { $count } puntos rellenos en líneas.
}
points-hollow = { $count ->
    [one] 1 punto hueco en una línea.
   *[other] { $count } puntos huecos en líneas.
}

colours-are-names = no
area = El color { $colour } cubre { $share } de la figura{ $areas ->
    [one] , sobre todo { $place }
   *[other] {" "}en { $areas } superficies, la mayor { $place }
}.
blank = Sin textura: { $share } de la figura.

braille-title = El título en braille es «{ $text }».
braille-number = El número de página en braille es { $text }.
braille-label = Una etiqueta { $place } dice «{ $text }».
braille-key = La leyenda dice «{ $text }».

overview = Debajo de la figura hay una vista general de { $width } por { $height } mm, con { $lines ->
    [0] ninguna línea
    [one] 1 línea
   *[other] { $lines } líneas
}.
overview-follows = En la hoja siguiente hay una vista general solo con líneas.
overview-alone = Esta es la vista general, solo con líneas.
overview-of-sheets = Esta es la vista general de una imagen en { $sheets } hojas, solo con líneas.
sheet-of-sheets = Esta es la hoja { $name } de { $sheets } ({ $names }), con una letra para cada fila desde arriba y un número
    para cada columna desde la izquierda.

left-out = { $length } mm de contornos, { $share }, no tenían sitio y faltan.
left-out-most = { $length } mm de contornos, { $share }, no tenían sitio y faltan, la mayoría { $place }.
left-out-of-sheets = En las { $sheets } hojas juntas, { $length } mm de contornos, { $share }, no tenían sitio y
    faltan.
areas-left-out = { $count ->
    [one] 1 superficie era demasiado pequeña para una textura al crear la página.
   *[other] { $count } superficies eran demasiado pequeñas para una textura al crear la página.
}
texts-left-out = { $count ->
    [one] 1 texto de la imagen se omitió al crear la página.
   *[other] { $count } textos de la imagen se omitieron al crear la página.
}
labels-left-out = { $count ->
    [one] 1 etiqueta se omitió al crear la página.
   *[other] { $count } etiquetas se omitieron al crear la página.
}

verdict = Veredicto: { $errors ->
    [one] 1 error
   *[other] { $errors } errores
}{ $faulty ->
    [none] {""}
   *[other] {" "}en { $faulty } de la figura
}, { $warnings ->
    [one] 1 advertencia
   *[other] { $warnings } advertencias
}{ $lines ->
    [none] {""}
   *[other] ; { $lines }
}{ $missing ->
    [none] {""}
   *[other] ; { $missing } de los contornos de la imagen no están en la página
}{ $textures ->
    [none] {""}
   *[other] ; { $textures }
}.
verdict-lines = algunas líneas apenas se pueden seguir, pues hay filas de texturas muy cerca de ellas:
    conviene omitir texturas o dibujar más grande
verdict-textures = una yema lee bien { $right } de las texturas{ $wrong ->
    [none] {""}
   *[other] {" "}y mal { $wrong }
}{ $rest ->
    [none] {""}
   *[other] ; el resto está demasiado cerca de líneas y bordes para juzgarlo
}
verdict-textures-few = solo { $judged } de las texturas está a { $from } mm o más de líneas y bordes, donde una yema
    no siente nada más; no se sabe cómo lee el resto: una figura más grande, o con menos líneas, tiene áreas más
    anchas
verdict-textures-near = todas las texturas están a menos de { $from } mm de líneas o bordes, que una yema también
    siente; no se sabe cómo las lee: una figura más grande, o con menos líneas, tiene áreas más anchas
verdict-textures-large = las texturas no se pudieron juzgar, pues la página es demasiado grande para el modelo de una yema
