//! What was found in the way of those who used the program for the first time; one test for each.

use crate::cli::common::*;

#[test]
fn lang_goes_with_a_title_alone() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--title", "Karte", "--lang", "de"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.svg\n"));
    let page = place.text("a.svg");
    // The description is made in the same language, where the program has its words; otherwise in English.
    assert!(page.contains("<title xml:lang=\"de\">"), "{page}");
    assert!(page.contains("<desc xml:lang=\"de\">Ein Blatt im Hochformat, "), "{page}");
    let run = place.run(&["convert", "a.png", "--title", "Mapa", "--lang", "cs"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.svg\n"));
    assert!(place.text("a.svg").contains("<desc xml:lang=\"en\">A sheet upright, "), "{}", place.text("a.svg"));
    let run = place.run(&["convert", "a.png", "--alt", "Eine Karte", "--lang", "de"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.svg\n"));
    assert!(place.text("a.svg").contains("<desc xml:lang=\"de\">"), "{}", place.text("a.svg"));
}

#[test]
fn a_title_may_begin_with_a_minus() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--title", "-5 °C"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.svg\n"));
    assert!(place.text("a.svg").contains("<title>-5 °C</title>"), "{}", place.text("a.svg"));
}

#[test]
fn texts_for_labels_that_are_not_there_are_told() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--labels", "texts"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.err.contains("there are no texts for labels"), "{}", run.err);
}

#[test]
fn a_list_of_labels_without_any_and_a_negative_width_are_refused_in_plain_words() {
    let place = Place::with_picture("a.png");
    place.put("none.csv", b"");
    let line = "--labels none.csv: this has no labels; write one a line, as x, y and text";
    place.refuses(&["convert", "a.png", "--labels", "none.csv"], 2, &[line]);
    let run = place.run(&["convert", "a.png", "--width-mm", "-5"]);
    assert!(run.code == 2 && run.err.contains("3 to 1200") && !run.err.contains("-- -5"), "{}", run.err);
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
    for (args, option) in [
        (&["--detail", "2"][..], "--detail 2: "),
        (&["--detail", "0,2"], "--detail 0,2: "),
        (&["--set", "lines.detail=2"], "--set lines.detail=2: "),
    ] {
        let run = place.run(&[&["convert", "a.png"], args].concat());
        assert_eq!(run.code, 2);
        assert!(run.err.starts_with(&format!("tactograph: {option}")), "{}", run.err);
        assert_eq!(run.err.contains("--set"), args[0] == "--set", "{}", run.err);
        assert_eq!(run.err.contains("write a point for the decimal comma"), args[1] == "0,2", "{}", run.err);
    }
}

#[test]
fn names_that_are_nearly_right_get_a_suggestion() {
    let place = Place::with_picture("a.png");
    place.put("my.toml", b"inherits = \"swell-a4\"\n[lines]\nwidht = 1\n[dots]\ndevice = \"index-basic-d\"\n");
    for (args, end) in [
        (&["--profile", "A4"][..], "; for a file of your own give a name that ends in .toml\n"),
        (&["--profile", "A4"], "called \"A4\", did you mean swell-a4? Take one of"),
        (&["--profile", "index"], "did you mean index-basic-d, index-everest-d, index-basic-d-v3 or index-braillebox?"),
        (&["--profile", "my.toml"], "no key lines.widht, did you mean lines.width_min or lines.width_max?\n"),
        (
            &["--profile", "my.toml"],
            "dots.device cannot be the text \"index-basic-d\", which is a profile, its device is \"index-basic-d-v5\"\n",
        ),
        (
            &["--set", "dots.device=index-basic-d-v6"],
            "cannot be index-basic-d-v6, did you mean \"index-basic-d-v3\", \"index-basic-d-v4\" or \"index-basic-d-v5\"?\n",
        ),
        (&["--set", "page.orientation=portrat"], "cannot be portrat, did you mean \"portrait\"?\n"),
        (&["--braille", "uk"], "the measures of cells are --set braille.cell=uk; see tactograph convert --help\n"),
        (&["--braille", "uk"], "--braille takes no value, and there is no picture uk: words are written in"),
        (&["--braille=uk"], "tactograph: --braille takes no value: words are written in the braille of their language"),
        (&["--o", "b.svg"], "tactograph: there is no option --o, did you mean -o; see tactograph convert --help\n"),
    ] {
        let run = place.run(&[&["convert", "a.png"], args].concat());
        assert!(run.code == 2 && run.err.contains(end), "{args:?}: {}", run.err);
    }
}

#[test]
fn a_profile_of_ones_own_is_shown_with_what_it_inherits() {
    let place = Place::new();
    place.put("my.toml", b"inherits = \"school/our.toml\"\n[lines]\nwidth_max = 1.2\n");
    place.put("school/our.toml", b"inherits = \"swell-a3\"\n[frame]\non = false\n");
    let run = place.run(&["profiles", "show", "my.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for line in [
        "width_max = 1.2 # a number from 0.3 to 10 mm; from my.toml, line 3",
        "on = false # true or false; from school/our.toml, line 3",
    ] {
        assert!(run.out.lines().any(|shown| shown == line), "{line}\n{}", run.out);
    }
    assert!(run.out.contains("\nwidth = 297 # a number from 60 to 1200 mm; from swell-a3.toml, line "), "{}", run.out);
    place.put("bad.toml", b"inherits = \"swell-a4\"\nnonsense = 1\n");
    assert_eq!(place.run(&["profiles", "show", "bad.toml"]).code, 2);
}

#[test]
fn a_file_of_dots_is_named_when_it_is_felt() {
    let place = Place::with_picture("a.png");
    let made = ["convert", "a.png", "--profile", "index-basic-d", "-o", "a.idx"];
    let run = place.run(&made);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.idx, 2 sheets: figure, overview\n"));
    place.refuses(
        &["feel", "a.idx"],
        1,
        &["a.idx: this is a page as IDX, which holds dots only, and feel reads the SVG of a page; write it with the same \
           profile and -o a.svg, and feel that"],
    );
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
            "{name}: this cannot be read as a page: it is {what}, and pages are read from their SVG; give the SVG of the page, or convert the picture to a page.svg"
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
