//! Pages of dots on the command line: which format, for which profile, in how many files.

use std::fs;

use crate::cli::common::*;

/// The picture's page in a format, from standard output.
#[track_caller]
fn page(place: &Place, args: &[&str]) -> Vec<u8> {
    let out =
        place.command(&[&["convert", "a.png", "-q", "-o", "-"], args].concat()).output().expect("the program starts");
    assert!(out.status.success(), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
    out.stdout
}

#[test]
fn every_format_of_dots_is_chosen_by_name_or_by_format() {
    let place = Place::with_picture("a.png");
    for (profile, format, head) in [
        ("index-basic-d", "ubrl", "".as_bytes()),
        ("index-basic-d", "pef", b"<?xml"),
        ("index-basic-d", "idx", b"\x1bDTM0,BI0,FO0,MI1,DP1,TD0,GD0,PN0,CH33,LP29,LS50,BT0;\x1b\x07"),
        ("index-basic-d", "txt", b""),
        ("index-basic-d-v3", "idx", b"\x1bDTM0,BI0,FO0,MI1,DP1,TD0,GD0,PN0,PW81,PL114,LS4,BT0;\x1b\x07"),
        ("braille-cells", "brf", b""),
        ("viewplus-columbia", "ubrl", b""),
        ("monarch", "txt", b""),
    ] {
        let name = format!("p.{format}");
        let run = place.run(&["convert", "a.png", "--profile", profile, "--no-overview", "-o", &name]);
        assert_eq!(
            (run.code, run.err.lines().last()),
            (0, Some(format!("wrote {name}").as_str())),
            "{profile} {format}"
        );
        let file = fs::read(place.path(&name)).expect("the file");
        assert!(
            file.starts_with(head) && file.len() > 100,
            "{profile} {format}: {:?}",
            file.escape_ascii().to_string()
        );
        let same = page(&place, &["--profile", profile, "--no-overview", "--format", format]);
        assert!(file == same, "{profile}: {format} by --format is another file");
    }
}

/// The same dots in every format of a grid.
#[test]
fn formats_hold_the_same_dots() {
    use crate::dots::reading::ubrl;
    let place = Place::with_picture("a.png");
    let as_format = |format| page(&place, &["--profile", "dot-pad", "--format", format]);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    let pages = ubrl(&text(as_format("ubrl")));
    assert_eq!(pages.len(), 2, "the figure and its overview");
    let drawn = text(as_format("txt"));
    for (page, drawn) in pages.iter().zip(drawn.split('\u{c}')) {
        assert_eq!(page.count(), drawn.matches('o').count());
        assert!(page.columns() <= 60 && page.rows() <= 40);
    }
    let pef = text(as_format("pef"));
    let cells = |text: &str| text.chars().filter(|c| ('\u{2801}'..='\u{28ff}').contains(c)).collect::<String>();
    assert_eq!(cells(&pef), cells(&text(as_format("ubrl"))));
}

#[test]
fn what_holds_one_page_is_written_to_files_with_numbers() {
    let place = Place::with_picture("a.png");
    for (profile, args, ending) in [
        ("braillerap", &[][..], "gcode"),
        ("viewplus-columbia", &["--format", "pixels"], "png"),
        ("index-basic-d", &[], "svg"),
    ] {
        let name = format!("p.{ending}");
        // and again, since they are as the program wrote them
        for _ in 0..2 {
            let run = place.run(&[&["convert", "a.png", "--profile", profile, "-o", &name], args].concat());
            assert_eq!(run.code, 0, "{}", run.err);
            assert!(
                run.err.ends_with(&format!("wrote p-1.{ending} to p-2.{ending}: figure, overview\n")),
                "{}",
                run.err
            );
        }
        assert!(!place.path(&name).exists() && place.path(format!("p-2.{ending}")).exists());
        let run =
            place.run(&[&["convert", "a.png", "--profile", profile, "--no-overview", "-o", &name], args].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(place.path(&name).exists());
    }
    let gcode = fs::read_to_string(place.path("p.gcode")).expect("G-code");
    assert!(gcode.starts_with("G28 X; a.png\r\nG28 Y;") && gcode.contains("\r\nM3 S1;\r\nM3 S0;\r\n"));
}

#[test]
fn formats_that_do_not_go_with_the_profile_are_told_with_what_does() {
    let place = Place::with_picture("a.png");
    for (args, want) in [
        (
            &["-o", "p.ubrl"][..],
            "UBRL holds dots, and the profile swell-a4 is for printing; take one for dots, such as --profile index-basic-d",
        ),
        (
            &["-o", "p.gcode", "--profile", "index-basic-d"],
            "GCODE is not for Index Basic-D V5, which takes idx, ubrl, pef, pixels or txt; take one of these, or SVG, PDF or PNG to look at",
        ),
        (
            &["-o", "p.pef", "--profile", "braillerap"],
            "PEF is not for BrailleRAP, which takes gcode; take one of these, or SVG, PDF or PNG to look at",
        ),
        (
            &["-o", "p.ubrl", "--profile", "braille-cells"],
            "UBRL is not for a braille-cell embosser, which takes brf or txt; take one of these, or SVG, PDF or PNG to look at",
        ),
        (
            &["-o", "p.svg", "--copies", "2"],
            "--copies is for Index embossers; leave it out, or give a name that ends in .idx",
        ),
        (
            &["-o", "p.idx", "--profile", "romeo-60", "--copies", "1000"],
            "1000 copies with an impact of 1 cannot be embossed; give 1 to 999 copies and an impact of 1 to 3",
        ),
        (
            &["-o", "p.idx", "--profile", "index-everest-d", "--set", "page.width=420", "--set", "page.height=600"],
            "--set page.height=600: the sheet is 420 mm wide; Index Everest-D V5 takes sheets 25.4 to 297 mm wide\n\
             --set page.height=600: the sheet is 600 mm long; Index Everest-D V5 takes sheets 25.4 to 590 mm long",
        ),
        (
            &["-o", "p.idx", "--profile", "index-basic-d", "--set", "dots.pitch=1.5"],
            "--set dots.pitch=1.5: Index Basic-D V5 has no dots 1.5 mm apart; it has 1.6, 2 or 2.5 mm",
        ),
    ] {
        let run = place.run(&[&["convert", "a.png"], args].concat());
        let want: String = want.lines().map(|line| format!("tactograph: {line}\n")).collect();
        assert_eq!((run.code, run.err), (2, want), "{args:?}");
        assert_eq!(place.names(), ["a.png"], "{args:?}");
    }
}

#[test]
fn a_width_that_the_device_has_no_room_for_is_refused() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--profile", "braillerap", "--width-mm", "400"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("400") && run.err.contains("mm"), "{}", run.err);
}

#[test]
fn copies_and_impact_reach_the_embosser() {
    let place = Place::with_picture("a.png");
    let idx = page(&place, &["--profile", "juliet-120", "--format", "idx", "--copies", "3", "--impact", "2"]);
    assert!(idx.starts_with(b"\x1bDTM0,BI0,FO0,MC3,MI2,DP1,"), "{}", idx[..40].escape_ascii());
}

#[test]
fn calibration_for_paper_has_no_format_of_dots() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["calibrate", "-o", "s.ubrl"]);
    assert_eq!((run.code, run.err.lines().count()), (2, 1), "{}", run.err);
}
