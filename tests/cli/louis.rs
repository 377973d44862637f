//! `--braille-table`: contracted braille by an installed liblouis. Where it is not installed, that is one clear line.

use std::io::Write as _;
use std::process::{Command, Stdio};

use super::common::*;
use crate::common::samples;

const PICTURE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"90\" height=\"60\">\
    <rect x=\"20\" y=\"15\" width=\"50\" height=\"30\" fill=\"#c00\"/></svg>";

fn place() -> Place {
    let place = Place::new();
    place.put("red.svg", PICTURE.as_bytes());
    place
}

fn is_installed() -> bool {
    Command::new("lou_translate").arg("--version").output().is_ok()
}

/// What liblouis itself makes of lines.
fn by_liblouis(direction: &str, lines: &[String]) -> Vec<String> {
    let mut command = Command::new("lou_translate");
    command.args([direction, "unicode.dis,en-ueb-g2.ctb"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut run = command.spawn().expect("it is installed");
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    run.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("it reads");
    let out = run.wait_with_output().expect("it ends").stdout;
    String::from_utf8(out).expect("text").lines().map(str::to_owned).collect()
}

/// Contracted where liblouis is there; else a fault that names what is missing, and no page.
#[test]
fn a_title_is_contracted_by_liblouis() {
    let place = place();
    let title = ["convert", "red.svg", "-o", "page.svg", "--title", "The great house"];
    let run = place.run(&[&title[..], &["--braille-table", "contracted"]].concat());
    if is_installed() {
        assert_eq!(run.code, 0, "{}", run.err);
        let page = place.text("page.svg");
        assert!(page.contains("data-braille=\"⠠⠮⠀⠛⠗⠞⠀⠓⠳⠎⠑\""), "the title is not contracted");
        assert!(page.contains("aria-label=\"The great house\""));
        // what the table lacks is told, and not drawn as its number
        let run = place.run(&[
            "convert",
            "red.svg",
            "-o",
            "b.svg",
            "--title",
            "a \u{65e5}",
            "--braille-table",
            "en-ueb-g2.ctb",
        ]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(
            run.err.contains(
                "is not written in braille: the table en-ueb-g2.ctb has no cells for '\u{65e5}' (character 3)\n"
            ),
            "{}",
            run.err
        );
        assert!(!place.text("b.svg").contains("braille-title"));
        // the French table writes a blank for it
        let skoda = ["convert", "red.svg", "-o", "c.svg", "--title", "\u{160}koda"];
        let run = place.run(&[&skoda[..], &["--braille-table", "fr-bfu-g2.ctb"]].concat());
        assert!(run.err.contains("the table fr-bfu-g2.ctb has no cells for '\u{160}' (character 1)"), "{}", run.err);
        // of several, the first in the text is named, not the first in Unicode
        let two = ["convert", "red.svg", "-o", "d.svg", "--title", "ab \u{672c} \u{65e5}"];
        let run = place.run(&[&two[..], &["--braille-table", "en-ueb-g2.ctb"]].concat());
        assert!(run.err.contains("has no cells for '\u{672c}' (character 4)"), "{}", run.err);
        let run = place.run(&[&title[..], &["--braille-table", "no-such.ctb", "--force"]].concat());
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(
            run.err.contains("--braille-table no-such.ctb: lou_translate says: Cannot resolve table"),
            "{}",
            run.err
        );
    } else {
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(run.err.contains("there is no program lou_translate; install liblouis"), "{}", run.err);
    }
}

/// Title, labels, key and page numbers of a page in contracted braille are what liblouis gives, and read back by it they
/// are the texts.
#[test]
fn a_whole_page_is_contracted() {
    if !is_installed() {
        return;
    }
    let place = Place::new();
    place.put("cell.svg", &samples::read("cell.svg"));
    let words = ["--title", "The animal cell and its parts", "--labels", "texts", "--key", "always", "--number", "12"];
    let run = place.run(&[&["convert", "cell.svg", "-o", "page.svg", "--set", "braille.grade=2"], &words[..]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let mut written: Vec<(String, String)> = Vec::new();
    for name in place.names().iter().filter(|name| name.starts_with("page")) {
        let svg = place.text(name);
        let document = roxmltree::Document::parse(&svg).expect("a page is well-formed");
        for text in document.descendants().filter(|node| node.has_attribute("data-braille")) {
            let of = |attribute: &str| text.attribute(attribute).map(str::to_owned);
            // abbreviations are spelled
            if of("data-abbreviation").is_none() {
                // a blank parts its lines
                let cells = of("data-braille").expect("its cells").replace(' ', "\u{2800}");
                written.push((of("aria-label").expect("its text"), cells));
            }
        }
    }
    for wanted in
        ["The animal cell and its parts", "membrane", "Key: The animal cell and its parts", "yellow", "12", "13"]
    {
        assert!(written.iter().any(|(text, _)| text == wanted), "{wanted} is not among {written:?}");
    }
    let abbreviations = |text: &str| text.split_once(": ").is_some_and(|(short, _)| short.len() <= 3 && short != "Key");
    written.retain(|(text, _)| !abbreviations(text));
    let (texts, cells): (Vec<String>, Vec<String>) = written.into_iter().unzip();
    assert_eq!(by_liblouis("--forward", &texts), cells);
    assert_eq!(by_liblouis("--backward", &cells), texts);
    assert!(cells[0].starts_with("⠠⠮⠀"), "the title is not contracted: {}", cells[0]);
}

#[test]
fn a_language_without_a_contracted_table_is_told() {
    let place = place();
    let run = place.run(&["convert", "red.svg", "--title", "Dům", "--lang", "cs", "--braille-table", "contracted"]);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(
        run.err.contains("no contracted table is known for the language cs, only for de, en, es, fr, pt, sv"),
        "{}",
        run.err
    );
    assert!(!place.names().iter().any(|name| name == "red.page.svg"));
    // a code that is named overrides the language
    let code = ["convert", "red.svg", "--title", "The great house", "--lang", "cs", "--set", "braille.code=en"];
    let run = place.run(&[&code[..], &["--set", "braille.grade=2", "-o", "en.svg"]].concat());
    if is_installed() {
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(place.text("en.svg").contains("data-braille=\"⠠⠮⠀⠛⠗⠞⠀⠓⠳⠎⠑\""), "the title is not contracted");
    } else {
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(run.err.contains("braille.grade = 2: there is no program lou_translate; install"), "{}", run.err);
    }
    // where nothing is written, no translator is needed
    for words in [&["--alt", "a red box"][..], &["--title", "x", "--set", "braille=false"]] {
        let grade = ["convert", "red.svg", "--force", "--set", "braille.grade=2", "--lang", "cs"];
        let run = place.run(&[&grade[..], words].concat());
        assert_eq!(run.code, 0, "{}", run.err);
    }
    let run = place.run(&["convert", "red.svg", "--set", "braille.grade=3"]);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(run.err.contains("braille.grade must be 1 or 2"), "{}", run.err);
}

/// A page in contracted braille stays so when it is laid out for another device.
#[test]
fn a_page_keeps_its_grade_when_it_is_rendered() {
    if !is_installed() {
        return;
    }
    let place = place();
    let run =
        place.run(&["convert", "red.svg", "-o", "page.svg", "--title", "The great house", "--set", "braille.grade=2"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let render = ["render", "page.svg", "--profile", "viewplus-columbia", "-o", "dots.svg"];
    let run = place.run(&render);
    assert_eq!(run.code, 0, "{}", run.err);
    let names = place.names();
    let dots = names.iter().find(|name| ["dots.svg", "dots-1.svg"].contains(&name.as_str())).expect("a page of dots");
    assert!(place.text(dots).contains("data-braille=\"⠠⠮⠀⠛⠗⠞⠀⠓⠳⠎⠑\""), "the title is not contracted");
    // unless it is to be otherwise
    let run = place.run(&[&render[..], &["--set", "braille.grade=1", "--force"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(!place.text(dots).contains("⠠⠮⠀"), "the title is contracted still");
}

/// A page that another table wrote is told when its words are written anew by another one, and keeps it by its name.
#[test]
fn a_table_is_kept_when_it_is_named_to_render() {
    if !is_installed() {
        return;
    }
    let place = place();
    let title = ["--title", "The great house", "--braille-table", "en-ueb-g2.ctb"];
    let run = place.run(&[&["convert", "red.svg", "-o", "page.svg"][..], &title].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let render = ["render", "page.svg", "--profile", "swell-a3", "-o", "large.svg"];
    let run = place.run(&render);
    assert_eq!(run.code, 0, "{}", run.err);
    let told = "1 text is written in other cells of braille than on the page, which another table wrote; write them with \
         that table (--braille-table TABLE)";
    assert!(run.err.contains(told), "{}", run.err);
    let run = place.run(&[&render[..], &["--braille-table", "en-ueb-g2.ctb"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(!run.err.contains("other cells") && place.text("large.svg").contains("⠠⠮⠀⠛⠗⠞⠀⠓⠳⠎⠑"), "{}", run.err);
    let run = place.run(&[&render[..], &["--braille-table", "no-such.ctb"]].concat());
    assert_eq!(run.code, 2, "{}", run.err);
}
