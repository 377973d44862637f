"""Writes names.tsv: phrases that nobody chose, with the cells that liblouis gives for them.

usage: names.py TABLES >names.tsv    TABLES: those of liblouis at commit d1f57dcf, for codes that are newer than 3.24

Names of countries, languages and currencies in ten languages, from the Unicode Common Locale Data Repository (CLDR,
Unicode licence, by the Python package Babel 2.19), with numbers, in capitals, in an order that a hash gives. Left out
are phrases with characters that the table of liblouis lacks: it writes them as a number in quotation marks or as a
blank, in Czech those of squares and of A with a ring as dots 26.
"""

import hashlib
import os
import subprocess
import sys

from babel import Locale

TABLES = {
    "cs": "cs-g1.ctb", "de": "de-g0.utb", "en": "en-ueb-g1.ctb", "es": "es-g1.ctb", "fr": "fr-bfu-comp6.utb",
    "it": "it-it-comp6.utb", "nl": "nl-NL-g0.utb", "pl": "Pl-Pl-g1.utb", "pt": "pt-pt-g1.utb", "sv": "sv-g0.utb",
}
NEWER = ["es", "it", "sv"]
COUNT = 250


def names(language):
    locale = Locale(language)
    of = {"territory": locale.territories, "language": locale.languages, "currency": locale.currencies}
    return {f"{kind} {key}": name for kind, names in of.items() for key, name in names.items()}


def phrase(language, name, key):
    number = int(hashlib.sha256(key.encode()).hexdigest()[:8], 16)
    whole, tenth = number % 977, number // 977 % 10
    decimal = f"{whole}.{tenth}" if language == "en" else f"{whole},{tenth}"
    forms = [
        name, name, name.upper(), f"{name}: {decimal}", f"{name} ({1800 + whole})", f"{decimal} % {name}",
        f"{1 + whole % 28}.{1 + tenth}.{1100 + whole}, {name}", f"{whole} km\u00b2: {name}",
    ]
    return forms[number // 9770 % len(forms)]


def is_known(language, text, cells):
    is_written = all(0x2800 <= ord(cell) < 0x2840 for cell in cells) and cells.count("\u2800") <= text.count(" ")
    return is_written and not (language == "cs" and set(text) & set("\u00b2\u00c5"))


def main():
    all_names = {language: names(language) for language in TABLES}
    keys = set.intersection(*[set(of) for of in all_names.values()])
    keys = sorted(keys, key=lambda key: hashlib.sha256(key.encode()).hexdigest())
    for language, table in TABLES.items():
        of = (phrase(language, all_names[language][key], key) for key in keys)
        texts = [text for text in dict.fromkeys(of) if len(text) <= 60 and not set(text) & set("\n\t")][:400]
        said = "".join(text.replace("\\", "\\\\") + "\n" for text in texts)
        tables = {"LOUIS_TABLEPATH": sys.argv[1]} if language in NEWER else {}
        command = ["lou_translate", "--forward", f"unicode.dis,{table}"]
        louis = subprocess.run(command, input=said, capture_output=True, text=True, env={**os.environ, **tables})
        pairs = [pair for pair in zip(texts, louis.stdout.split("\n")) if is_known(language, *pair)]
        for text, cells in pairs[:COUNT]:
            print(language, text, cells, sep="\t")


main()
