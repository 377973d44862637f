//! Which name a page gets, and what is never overwritten.

use std::fs;

use crate::cli::common::*;

#[test]
fn the_page_lies_beside_the_picture() {
    let place = Place::new();
    place.put("in/red.square.png", &picture());
    let run = place.run(&["convert", "in/red.square.png"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", "wrote in/red.square.svg\n"));
    place.has_page("in/red.square.svg");
    assert_eq!(place.names(), ["in"]);
    assert_eq!(fs::read_dir(place.path("in")).expect("in").count(), 2, "something is left over");
}

#[test]
fn a_picture_without_ending_gets_one_for_its_page() {
    let place = Place::with_picture("red");
    assert_eq!(place.run(&["convert", "red"]).code, 0);
    assert_eq!(place.names(), ["red", "red.svg"]);
}

#[test]
fn o_names_the_page() {
    for name in ["page.svg", "PAGE.SVG", "page"] {
        let place = Place::with_picture("a.png");
        for option in ["-o", "--output"] {
            let run = place.run(&["convert", "a.png", option, name]);
            assert_eq!((run.code, run.err), (0, format!("wrote {name}\n")));
            place.has_page(name);
        }
    }
}

#[test]
fn an_svg_picture_is_not_overwritten() {
    for name in ["a.svg", "a.SVG"] {
        let place = Place::new();
        place.put(name, DRAWING.as_bytes());
        let run = place.run(&["convert", name]);
        assert_eq!((run.code, run.err.as_str()), (0, "wrote a.page.svg\n"));
        place.has_page("a.page.svg");
        assert_eq!(place.text(name), DRAWING);
        // Its own directory by another name is no way round.
        fs::create_dir(place.path("sub")).expect("sub");
        assert_eq!(place.run(&["convert", name, "--out-dir", "sub/.."]).err, "wrote sub/../a.page.svg\n");
        assert_eq!(place.text(name), DRAWING);
        // In another directory it can have its plain name.
        assert_eq!(place.run(&["convert", name, "--out-dir", "sub"]).err, "wrote sub/a.svg\n");
    }
}

#[test]
fn a_page_never_overwrites_a_picture() {
    let place = Place::with_picture("a.png");
    place.put("d/a.svg", DRAWING.as_bytes());
    let itself = "the page would overwrite the picture itself; choose another name with -o";
    for page in ["d/a.svg", "d/../d/a.svg", "./d/a.svg"] {
        place.refuses(&["convert", "d/a.svg", "-o", page], 2, &[&format!("{page}: {itself}")]);
    }
    place.put("d/a.png", &picture());
    let other = "d/a.svg: the page of d/a.png would overwrite the picture d/a.svg; choose another name with -o";
    place.refuses(&["convert", "d/a.png", "d/a.svg"], 2, &[other]);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("d/a.svg", place.path("link.svg")).expect("a link");
        place.refuses(&["convert", "d/a.svg", "-o", "link.svg"], 2, &[&format!("link.svg: {itself}")]);
    }
    assert_eq!(place.text("d/a.svg"), DRAWING);
}

#[test]
fn a_derived_name_does_not_cost_the_user_a_drawing() {
    let place = Place::with_picture("a.png");
    place.put("a.svg", DRAWING.as_bytes());
    let kept = "this file exists and was not written by tactograph, or changed since; name the page with -o, move that file away, or replace it with --force";
    place.refuses(&["convert", "a.png"], 1, &[&format!("a.svg: {kept}")]);
    assert_eq!(place.text("a.svg"), DRAWING);
    // Whoever names it means it.
    assert_eq!(place.run(&["convert", "a.png", "-o", "a.svg"]).code, 0);
    place.has_page("a.svg");
    // A page that somebody touched up, be it by hand, is theirs now.
    let edited = place.text("a.svg").replacen(">A sheet", ">Our pond", 1);
    place.put("a.svg", edited.as_bytes());
    place.refuses(&["convert", "a.png"], 1, &[&format!("a.svg: {kept}")]);
    assert_eq!(place.text("a.svg"), edited);
    place.put("a.svg", b"");
    // A page of ours is replaced, and so is an empty file.
    assert_eq!(place.run(&["convert", "a.png"]).code, 0);
    place.put("a.svg", b"");
    assert_eq!(place.run(&["convert", "a.png"]).code, 0);
    place.has_page("a.svg");
}

#[test]
fn an_ending_that_is_not_written_is_refused() {
    let place = Place::with_picture("a.png");
    for ending in ["ps", "jpg", "svgz"] {
        let page = format!("page.{ending}");
        let line = format!(
            "{page}: a page is not written as .{ending}, only as .svg, .pdf or .png, or for dots .ubrl, .brf, .pef, .idx, .gcode or .txt; name it page.svg"
        );
        place.refuses(&["convert", "a.png", "-o", &page], 2, &[&line]);
    }
    assert_eq!(place.names(), ["a.png"]);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let place = Place::new();
    let run = place.run_with_input(&["convert", "-"], &picture());
    assert_eq!((run.code, run.err.as_str()), (0, "wrote standard output\n"));
    assert_is_page(&run.out, "standard output");
    let quiet = place.run_with_input(&["convert", "-", "-q", "-o", "-"], &picture());
    assert_eq!((quiet.code, quiet.err.as_str()), (0, ""));
    assert_eq!(quiet.out, run.out, "not the same page again");
    assert_eq!(place.names(), [""; 0]);
}

#[test]
fn standard_input_to_a_file_and_a_file_to_standard_output() {
    let place = Place::with_picture("a.png");
    let run = place.run_with_input(&["convert", "-", "-o", "b.svg"], &picture());
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", "wrote b.svg\n"));
    place.has_page("b.svg");
    let run = place.run(&["convert", "a.png", "-o", "-"]);
    assert_is_page(&run.out, "standard output");
    assert_eq!(place.names(), ["a.png", "b.svg"]);
}

#[test]
fn standard_input_has_one_picture_and_no_name() {
    let place = Place::with_picture("a.png");
    place.refuses(&["convert", "-", "-"], 2, &["standard input (-) is given more than once; give it once"]);
    let line = "a picture from standard input (-) has no name for a page in --out-dir; name the page with -o";
    place.refuses(&["convert", "-", "--out-dir", "d"], 2, &[line]);
    let run = place.run_with_input(&["convert", "-"], b"");
    assert_eq!(run.err, "tactograph: standard input: the file is empty; give a picture\n");
    assert_eq!((run.code, run.out.as_str()), (1, ""));
}
