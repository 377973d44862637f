//! In which format a page is written, and what is said where names and options do not go together.

use std::fs;

use crate::cli::common::*;

/// The format that a file really has.
#[track_caller]
fn format_of(place: &Place, name: &str) -> &'static str {
    let bytes = fs::read(place.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    match &bytes[..] {
        [b'%', b'P', b'D', b'F', ..] => "pdf",
        [0x89, b'P', b'N', b'G', ..] => "png",
        [b'<', b'?', b'x', b'm', b'l', ..] => "svg",
        _ => panic!("{name} is in no format of a page"),
    }
}

#[test]
fn the_name_says_the_format() {
    let place = Place::with_picture("a.jpeg");
    for (name, format) in [("p.svg", "svg"), ("p.pdf", "pdf"), ("P.PDF", "pdf"), ("p.png", "png"), ("p", "svg")] {
        let run = place.run(&["convert", "a.jpeg", "-o", name]);
        assert_eq!((run.code, run.err), (0, format!("wrote {name}\n")));
        assert_eq!(format_of(&place, name), format);
    }
}

#[test]
fn format_says_it_where_no_name_does() {
    let place = Place::with_picture("a.png");
    for format in ["svg", "pdf", "png"] {
        let args = ["convert", "a.png", "--format", format, "-q"];
        for (to, name) in [(&["-o", "name"][..], "name"), (&["--out-dir", "d"], &format!("d/a.{format}"))] {
            assert_eq!(place.run(&[&args[..], to].concat()).code, 0, "{format} {to:?}");
            assert_eq!(format_of(&place, name), format);
        }
        let out = place.command(&[&args[..], &["-o", "-"]].concat()).output().expect("the program starts");
        assert!(out.stdout == fs::read(place.path("name")).expect("the page"), "standard output has another page");
    }
    // Beside the picture, where the page of a PNG as PNG must not be the picture itself.
    let run = place.run(&["convert", "a.png", "--format", "png"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.page.png\n"));
    assert_eq!(fs::read(place.path("a.png")).expect("the picture"), picture());
}

#[test]
fn a_page_in_any_format_that_somebody_changed_is_kept() {
    let place = Place::with_picture("a.jpeg");
    for format in ["pdf", "png"] {
        let (name, args) = (format!("a.{format}"), ["convert", "a.jpeg", "-q", "--format", format]);
        // Ours is replaced, an empty file as well.
        for _ in 0..2 {
            assert_eq!(place.run(&args).code, 0);
        }
        let page = fs::read(place.path(&name)).expect("the page");
        let edited = [&page[..], b"\n% a note"].concat();
        for theirs in [&edited[..], b"%PDF-1.4 something else", &picture()] {
            place.put(&name, theirs);
            let kept = "this file exists and was not written by tactograph, or changed since; name the page with -o, move that file away, or replace it with --force";
            place.refuses(&args, 1, &[&format!("{name}: {kept}")]);
            assert!(fs::read(place.path(&name)).expect("theirs") == theirs);
        }
        assert_eq!(place.run(&["convert", "a.jpeg", "-q", "-o", &name]).code, 0, "whoever names it means it");
        assert!(fs::read(place.path(&name)).expect("the page") == page);
    }
}

#[test]
fn what_does_not_go_together_is_told_at_once() {
    let place = Place::with_picture("a.jpeg");
    place.put("b.jpeg", &picture());
    let lines = [
        "p.pdf: this name does not go with --format png; leave one out",
        "--dpi is for PNG, and this page is written as PDF; leave it out, or give a name that ends in .png",
        "--grey is for PNG, and this page is written as PDF; leave it out, or give a name that ends in .png",
    ];
    place.refuses(&["convert", "a.jpeg", "-o", "p.pdf", "--format", "png", "--dpi", "600", "--grey"], 2, &lines);
    let line = "--title and --alt: these words are for one picture, but there are 2; convert them one by one";
    place.refuses(&["convert", "a.jpeg", "b.jpeg", "--title", "x", "--alt", "y"], 2, &[line]);
    let see = "see tactograph convert --help";
    for (option, value, what) in [
        ("--dpi", "49", "give a whole number from 50 to 1200"),
        ("--dpi", "1201", "give a whole number from 50 to 1200"),
        ("--dpi", "300.5", "give a whole number from 50 to 1200"),
        ("--lang", "deutsch", "give a language tag, such as de or fr-CA"),
        ("--lang", "de_DE", "give a language tag, such as de or fr-CA"),
    ] {
        let unit = if option == "--dpi" { "N" } else { "TAG" };
        let line = format!("invalid value '{value}' for '{option} <{unit}>': {what}; {see}");
        place.refuses(&["convert", "a.jpeg", "--alt", "x", option, value], 2, &[&line]);
    }
    let line = "--lang is the language of --title, --alt, --titles, --labels and --ocr, and none is given; give one, or \
                leave --lang out";
    place.refuses(&["convert", "a.jpeg", "--lang", "de"], 2, &[line]);
    assert_eq!(place.names(), ["a.jpeg", "b.jpeg"]);
}

#[test]
fn a_picture_of_a_sheet_can_be_too_fine() {
    let place = Place::with_picture("a.jpeg");
    let sheet = ["--set", "page.width=1200", "--set", "page.height=1200", "--set", "figure.resolution=1"];
    let line = "a.jpeg: at 600 dots per inch the page would have 28346 x 28346 pixels, over the limit of 400 megapixels; \
                take fewer dots per inch with --dpi";
    place.refuses(&[&["convert", "a.jpeg", "-o", "p.png", "--dpi", "600"][..], &sheet].concat(), 1, &[line]);
    assert_eq!(place.names(), ["a.jpeg"]);
}

#[test]
fn words_of_the_maker_are_in_the_page() {
    let place = Place::with_picture("a.jpeg");
    let args = ["convert", "a.jpeg", "-o", "p.svg", "--title", "Ein Quadrat", "--alt", "Rot auf Weiß", "--lang", "de"];
    assert_eq!(place.run(&args).code, 0);
    let text = place.text("p.svg");
    let page = roxmltree::Document::parse(&text).expect("XML");
    let of = |tag: &str| {
        page.descendants().find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", tag))).expect("it is there")
    };
    assert_eq!(of("title").text().map(str::trim), Some("Ein Quadrat"));
    assert_eq!(of("desc").text().map(str::trim), Some("Rot auf Weiß"));
    assert_eq!(of("desc").attribute(("http://www.w3.org/XML/1998/namespace", "lang")), Some("de"));
    // How it was made still says of which picture.
    assert!(of("metadata").text().is_some_and(|text| text.contains("picture = a.jpeg")));
}
