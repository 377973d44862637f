//! `--ocr`: texts of a bitmap, read by an installed Tesseract. Here a script stands for it, which calls the lines that it
//! is given word1, word2 and so on; the real one is in `tests/clients.sh`.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::PermissionsExt;

use super::common::*;
use crate::lettering::labelled_chart;

const LANGUAGES: &str =
    "#!/bin/sh\nif [ \"$1\" = --list-langs ]; then echo 'List (2):'; echo deu; echo eng; exit; fi\n";
const READS: &str = "echo \"$*\" >asked.txt\n\
    printf 'level\\tpage_num\\tblock_num\\tpar_num\\tline_num\\tword_num\\tleft\\ttop\\twidth\\theight\\tconf\\ttext\\n'\n\
    n=0\nwhile read -r line; do\n  n=$((n + 1))\n  [ -s \"$line\" ] || exit 7\n\
    printf '5\\t%d\\t1\\t1\\t1\\t1\\t0\\t0\\t9\\t9\\t95.1\\tword%d\\n' $n $n\ndone <\"$1\"\n\
    echo 'Estimating resolution as 300' >&2\n";
const FAILS: &str = "echo >&2\necho 'Image file cannot be read!' >&2\nexit 1\n";

/// A place with a chart of six texts, and with this as Tesseract.
fn place(script: &str) -> Place {
    let place = Place::new();
    place.put("chart.png", &labelled_chart());
    place.put("programs/tesseract", (LANGUAGES.to_owned() + script).as_bytes());
    let all = fs::Permissions::from_mode(0o755);
    fs::set_permissions(place.path("programs/tesseract"), all).expect("a program");
    place
}

fn run(place: &Place, args: &[&str]) -> Run {
    let path = std::env::join_paths([place.path("programs"), "/bin".into(), "/usr/bin".into()]).expect("a path");
    let args = [&["convert", "chart.png", "-o", "page.svg"], args].concat();
    ended(place.command(&args).env("PATH", path).output().expect("the program starts"))
}

#[test]
fn texts_of_a_bitmap_are_read_and_listed() {
    let place = place(READS);
    let run = run(&place, &["--ocr"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let wanted = "6 texts left out, as fingers cannot read letters: \"word1\", \"word2\", \"word3\", \"word4\", \
                  \"word5\", \"word6\"; write them in braille with --labels texts\n";
    assert!(run.err.contains(wanted), "{}", run.err);
    let asked = place.text("asked.txt");
    assert!(asked.ends_with("stdout -l eng --psm 7 --dpi 300 tsv\n"), "{asked}");
}

#[test]
fn texts_that_were_read_become_labels_where_they_stand() {
    let place = place(READS);
    let run = run(&place, &["--ocr", "--labels", "texts", "--key", "never", "--lang", "de"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(!run.err.contains("texts left out") && !run.err.contains("no texts"), "{}", run.err);
    let page = place.text("page.svg");
    let labels = (1..=6).filter(|n| page.contains(&format!("aria-label=\"word{n}\""))).count();
    assert!(labels >= 4, "{labels} labels; {}", run.err);
    assert!(place.text("asked.txt").contains(" -l deu "));
}

#[test]
fn what_keeps_tesseract_from_reading_is_told_and_the_page_is_made() {
    let place = place(FAILS);
    let run = run(&place, &["--ocr"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let told = "note: the texts in the pixels are not read: tesseract says: Image file cannot be read!\n";
    assert!(run.err.contains(told) && run.err.contains("keep the text to draw them (--keep-text)\n"), "{}", run.err);
    place.has_page("page.svg");
}

#[test]
fn without_tesseract_or_its_language_there_is_one_line_and_no_page() {
    let place = place(READS);
    let french = run(&place, &["--ocr", "--lang", "fr"]);
    let told = "tactograph: --ocr: tesseract has no data of the language fra; install it (tesseract-ocr-fra)\n";
    assert_eq!((french.code, french.err.as_str()), (2, told));
    let mut command = place.command(&["convert", "chart.png", "-o", "page.svg", "--ocr"]);
    let none = ended(command.env("PATH", place.path("nothing")).output().expect("the program starts"));
    let told =
        "tactograph: --ocr: there is no program tesseract; install Tesseract (tesseract-ocr), or leave --ocr out\n";
    assert_eq!((none.code, none.err.as_str()), (2, told));
    assert!(!place.names().contains(&"page.svg".to_owned()));
}
