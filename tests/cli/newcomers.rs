//! What was found in the way of those who used the program for the first time; one test for each.

use crate::cli::common::*;

#[test]
fn lang_goes_with_a_title_alone() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--title", "Karte", "--lang", "de"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.svg\n"));
    let page = place.text("a.svg");
    assert!(page.contains("Karte") && page.contains("xml:lang=\"de\""), "{page}");
}

#[test]
fn a_mistyped_folder_of_a_picture_is_not_blamed_on_the_page() {
    let place = Place::with_picture("photos/a.png");
    place.refuses(&["convert", "phtos/a.png"], 1, &["phtos/a.png: there is no such file; check the name"]);
    place.refuses(&["trace", "photos"], 1, &["photos: this is a directory; name the files in it"]);
}

#[test]
fn what_is_to_be_printed_is_named_pdf_or_pixels() {
    let place = Place::with_picture("a.png");
    let line = "bar.prn: the languages of printers are not written; to print the page, name it bar.pdf, or for the driver of a \
                ViewPlus embosser take --format pixels and name it bar.png";
    place.refuses(&["convert", "a.png", "-o", "bar.prn"], 2, &[line]);
}

#[test]
fn a_width_that_is_there_without_the_overview_is_told() {
    let place = Place::new();
    let tall = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"130\">\
                <rect width=\"100\" height=\"130\" fill=\"#fff\"/><circle cx=\"50\" cy=\"65\" r=\"30\"/></svg>";
    place.put("tall.svg", tall.as_bytes());
    let run = place.run(&["convert", "tall.svg", "--width-mm", "160"]);
    let (_, rest) = run.err.split_once(" on this sheet, or ").unwrap_or_else(|| panic!("{}", run.err));
    let (width, rest) = rest.split_once(" mm with --no-overview").expect("the option");
    assert_eq!((run.code, rest), (1, ", so take one of these or a larger sheet\n"));
    let run = place.run(&["convert", "tall.svg", "--width-mm", width, "--no-overview"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote tall.page.svg\n"));
    // A width that is not there either way is refused without that advice.
    let run = place.run(&["convert", "tall.svg", "--width-mm", "209"]);
    assert!(run.code == 1 && !run.err.contains("overview"), "{}", run.err);
}

#[test]
fn a_fault_names_the_option_that_was_typed() {
    let place = Place::with_picture("a.png");
    for (args, option) in
        [(&["--detail", "2"][..], "--detail 2: "), (&["--set", "lines.detail=2"], "--set lines.detail=2: ")]
    {
        let run = place.run(&[&["convert", "a.png"], args].concat());
        assert_eq!(run.code, 2);
        assert!(run.err.starts_with(&format!("tactograph: {option}")), "{}", run.err);
        assert_eq!(run.err.contains("--set"), args[0] == "--set", "{}", run.err);
    }
}

#[test]
fn help_is_a_command_too() {
    let place = Place::new();
    let help = place.run(&["help"]);
    assert_eq!((help.code, help.err.as_str()), (0, ""));
    assert!(help.out.contains("convert") && help.out.contains("feel"), "{}", help.out);
    assert_eq!(place.run(&["help", "convert"]).out, place.run(&["convert", "--help"]).out);
}

#[test]
fn what_is_no_svg_is_named_when_it_is_felt() {
    let place = Place::new();
    for (name, bytes, what) in [
        ("page.pdf", &b"%PDF-1.7\n%\xe2\xe3\xcf\xd3"[..], "a PDF"),
        ("page.png", b"\x89PNG\r\n\x1a\n\0\0", "a PNG picture"),
    ] {
        place.put(name, bytes);
        let line = format!(
            "{name}: this is {what}, and a page is felt from its SVG; give the SVG of the page, or convert the picture to a page.svg"
        );
        place.refuses(&["feel", name], 1, &[&line]);
    }
}

#[test]
fn a_batch_of_dots_can_be_run_twice() {
    let place = Place::with_picture("a.png");
    let cells = ["convert", "a.png", "--profile", "braille-cells", "--format", "brf", "--no-overview", "-q"];
    assert_eq!(place.run(&cells).code, 0);
    let first = place.text("a.brf");
    let again = place.run(&cells);
    assert_eq!((again.code, again.err.as_str()), (0, ""), "the same bytes");
    assert_eq!(place.text("a.brf"), first);
    // Other bytes may be somebody's work.
    place.put("a.brf", b"mine");
    let refused = place.run(&cells);
    assert!(refused.code == 1 && refused.err.contains("--force"), "{}", refused.err);
    assert_eq!(place.text("a.brf"), "mine");
    for force in ["--force", "--overwrite"] {
        place.put("a.brf", b"mine");
        assert_eq!(place.run(&[&cells[..], &[force]].concat()).code, 0);
        assert_eq!(place.text("a.brf"), first, "{force}");
    }
    // But never a picture.
    place.put("b.svg", DRAWING.as_bytes());
    assert_eq!(place.run(&["convert", "b.svg", "-o", "b.svg", "--force"]).code, 2);
    assert_eq!(place.text("b.svg"), DRAWING);
}
