//! Dots and a picture of them in one run.

use std::fs;

use crate::cli::common::*;

#[test]
fn a_preview_is_the_picture_that_the_format_would_be() {
    let place = Place::with_picture("a.png");
    let (swell, index) = ("swell-a4", "index-basic-d");
    let formats = [
        ("svg", swell),
        ("pdf", swell),
        ("png", swell),
        ("idx", index),
        ("ubrl", index),
        ("pef", index),
        ("txt", index),
        ("pixels", index),
        ("brf", "braille-cells"),
        ("gcode", "braillerap"),
    ];
    for (format, profile) in formats {
        let dir = format!("{format}-only");
        let base = ["convert", "a.png", "--no-overview", "--profile", profile, "-q", "--out-dir"];
        let run = place.run(&[&base[..], &[format, "--format", format, "--preview", "png"]].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{format}");
        assert_eq!(place.run(&[&base[..], &[&dir, "--format", format]].concat()).code, 0);
        assert_eq!(place.run(&[&base[..], &["look", "--format", "png", "--force"]].concat()).code, 0);
        let bytes = |name: String| fs::read(place.path(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let ending = if format == "pixels" { "png" } else { format };
        assert!(bytes(format!("{format}/a.{ending}")) == bytes(format!("{dir}/a.{ending}")), "{format}: another page");
        assert!(
            bytes(format!("{format}/a.{ending}.preview.png")) == bytes("look/a.png".into()),
            "{format}: another preview"
        );
        assert_eq!(fs::read_dir(place.path(format)).expect("the directory").count(), 2, "{format}: something is left");
    }
}

#[test]
fn previews_of_several_sheets_have_numbers() {
    let place = Place::with_picture("a.png");
    let index = ["convert", "a.png", "--profile", "index-basic-d", "--format", "idx", "--preview"];
    let run = place.run(&[&index[..], &["png", "--dpi", "60", "--grey"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    assert_eq!(
        run.err.lines().last(),
        Some("wrote a.idx, 2 sheets: figure, overview, and a.idx.preview-1.png to a.idx.preview-2.png")
    );
    let run = place.run(&[&index[..], &["pdf"]].concat());
    assert_eq!(run.err.lines().last(), Some("wrote a.idx, 2 sheets: figure, overview, and a.idx.preview.pdf"));
    let run = place.run(&["render", "b.svg", "-o", "x.pdf", "--preview", "svg"]);
    assert_eq!(run.code, 1);
    assert_eq!(place.run(&["convert", "a.png", "-q", "-o", "b.svg"]).code, 0);
    let run = place.run(&["render", "b.svg", "-o", "c.pdf", "--preview", "png"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote c.pdf\nwrote c.pdf.preview.png\n"));
    let of_dots = ["a.idx", "a.idx.preview-1.png", "a.idx.preview-2.png", "a.idx.preview.pdf"];
    assert_eq!(place.names(), [&of_dots[..], &["a.png", "b.svg", "c.pdf", "c.pdf.preview.png"]].concat());
    // another format of the same page has one of its own
    let run = place.run(&["render", "b.svg", "-o", "c.svg", "--preview", "png"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote c.svg\nwrote c.svg.preview.png\n"));
}

#[test]
fn a_preview_takes_the_place_of_nothing() {
    let place = Place::with_picture("a.png");
    place.put("a.pdf.preview.png", &picture());
    let line = "a.pdf.preview.png: the preview of a.png would overwrite the picture a.pdf.preview.png; choose another \
                name with -o";
    place.refuses(&["convert", "a.png", "a.pdf.preview.png", "--format", "pdf", "--preview", "png"], 2, &[line]);
    // a file of somebody else: nothing is written, not even the page
    let line = "a.pdf.preview.png: this file exists and was not written by tactograph, or changed since; name the page \
                with -o, move that file away, or replace it with --force";
    place.refuses(&["convert", "a.png", "-o", "a.pdf", "--preview", "png"], 1, &[line]);
    assert_eq!(place.names(), ["a.pdf.preview.png", "a.png"]);
    let run = place.run(&["convert", "a.png", "-o", "a.pdf", "--preview", "png", "--force", "-q"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(fs::read(place.path("a.pdf.preview.png")).expect("it") != picture());
    let again = place.run(&["convert", "a.png", "-o", "a.pdf", "--preview", "png", "-q"]);
    assert_eq!((again.code, again.err.as_str()), (0, ""), "our own preview was not replaced");
    let line = "--preview: there is no name for it beside standard output; name the page with -o";
    place.refuses(&["convert", "a.png", "-o", "-", "--preview", "png"], 2, &[line]);
    place.refuses(&["convert", "-", "--preview", "png"], 2, &[line]);
    let line = "--dpi is for PNG, and this page is written as SVG; leave it out, or give a name that ends in .png";
    place.refuses(&["convert", "a.png", "--preview", "pdf", "--dpi", "60"], 2, &[line]);
}
