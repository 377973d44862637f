//! The calibration sheet on the command line.

use std::fs;

use crate::cli::common::*;

#[test]
fn a_pdf_has_all_sheets_and_their_key_is_told() {
    let place = Place::new();
    let run = place.run(&["calibrate", "-o", "sheet.pdf"]);
    assert_eq!((run.code, run.out.as_str()), (0, ""));
    let lines: Vec<&str> = run.err.lines().collect();
    let (key, rest) = lines.split_at(lines.len() - 1);
    assert!(key.iter().all(|line| line.starts_with("Calibration sheet for swell-a4, ")), "{}", run.err);
    assert!(
        key[0].contains(" a (lines.width_min, lines.width_max): lines 0.3, ") && rest == ["wrote sheet.pdf, 4 sheets"],
        "{}",
        run.err
    );
    let bytes = fs::read(place.path("sheet.pdf")).expect("the file");
    assert!(bytes.starts_with(b"%PDF") && String::from_utf8_lossy(&bytes).contains(&format!("/Count {}", key.len())));
    assert_eq!(place.names(), ["sheet.pdf"]);
    let quiet = place.run(&["calibrate", "-o", "sheet.pdf", "-q"]);
    assert_eq!((quiet.code, quiet.err.as_str()), (0, ""));
    assert!(fs::read(place.path("sheet.pdf")).expect("the file") == bytes);
}

#[test]
fn drawings_and_pictures_have_numbers_and_cost_nobody_theirs() {
    let place = Place::new();
    let run = place.run(&["calibrate", "-o", "d.svg", "--set", "lines.width_max=1.7"]);
    assert!(run.err.ends_with("wrote d-1.svg\nwrote d-2.svg\nwrote d-3.svg\nwrote d-4.svg\n"), "{}", run.err);
    assert!(run.err.contains("pairs of lines 1.7 mm wide"), "{}", run.err);
    let drawings = ["d-1.svg", "d-2.svg", "d-3.svg", "d-4.svg"];
    for name in drawings {
        place.has_page(name);
    }
    assert_eq!(place.run(&["calibrate", "-q", "-o", "p.png", "--dpi", "60"]).code, 0);
    let pictures = ["p-1.png", "p-2.png", "p-3.png", "p-4.png"];
    assert_eq!(place.names(), [drawings, pictures].concat());
    // A name that the user did not give must not cost them a drawing; nothing else is written then.
    place.put("d-2.svg", DRAWING.as_bytes());
    let first = place.text("d-1.svg");
    let kept = "this file exists and was not written by tactograph, or changed since; name the page with -o, move that file away, or replace it with --force";
    place.refuses(&["calibrate", "-o", "d.svg"], 1, &[&format!("d-2.svg: {kept}")]);
    assert_eq!((place.text("d-2.svg"), place.text("d-1.svg")), (DRAWING.to_string(), first));
}

#[test]
fn standard_output_takes_what_goes_into_one_file() {
    let place = Place::new();
    let out = place.command(&["calibrate", "-o", "-", "--format", "pdf", "-q"]).output().expect("the program starts");
    assert!(out.status.success() && out.stdout.starts_with(b"%PDF") && out.stderr.is_empty());
    let line = "standard output: 4 sheets do not go into one file of this format; add --format pdf, or name a file";
    place.refuses(&["calibrate", "-o", "-"], 1, &[line]);
}

#[test]
fn wrong_usage_is_told() {
    let place = Place::new();
    let missing = "name a file for the sheets, such as -o sheet.pdf; see tactograph calibrate --help";
    place.refuses(&["calibrate"], 2, &[missing]);
    let lines = [
        "--dpi is for PNG, and this page is written as SVG; leave it out, or give a name that ends in .png",
        "s.jpg: a page is not written as .jpg, only as .svg, .pdf or .png, or for dots .ubrl, .brf, .pef, .idx, .gcode or .txt; name it s.svg",
        "--set x: write it as key=value, such as lines.width_max=1.2",
    ];
    place.refuses(&["calibrate", "-o", "s.jpg", "--dpi", "100", "--set", "x"], 2, &lines);
    let small = ["--set", "page.width=100", "--set", "page.height=100", "--set", "page.margin=10"];
    let run = place.run(&[&["calibrate", "-o", "s.pdf"][..], &small].concat());
    assert_eq!(run.code, 1);
    assert!(
        run.err.starts_with("tactograph: swell-a4: a sample of ") && run.err.contains("take larger paper"),
        "{}",
        run.err
    );
    assert_eq!(place.names(), [""; 0]);
}

#[test]
fn a_device_gets_its_own_sheets() {
    let place = Place::new();
    let of_device = |options: &[&str]| place.run(&[&["calibrate", "--profile", "index-basic-d"], options].concat());
    let bytes = |name: &str| fs::read(place.path(name)).expect("the file");
    let run = of_device(&["-o", "s.idx", "--preview", "pdf"]);
    assert_eq!(run.code, 0, "{}", run.err);
    // one for each pitch
    let files = [
        "s-1.6.idx",
        "s-1.6.idx.preview.pdf",
        "s-2.0.idx",
        "s-2.0.idx.preview.pdf",
        "s-2.5.idx",
        "s-2.5.idx.preview.pdf",
    ];
    let wrote: Vec<&str> = run.err.lines().filter_map(|line| line.strip_prefix("wrote ")).collect();
    let named: Vec<&str> = wrote.iter().filter_map(|line| line.split(',').next()).collect();
    assert_eq!((&named[..], place.names()), (&files[..], files.map(str::to_owned).to_vec()), "{}", run.err);
    for told in [
        "dots 1.6 mm apart",
        "dots 2 mm apart",
        "dots 2.5 mm apart",
        " b (dots.line_gap): pairs of lines",
        "3 pitches, each in files of its own that are named by it; for one alone --set dots.pitch=1.6",
    ] {
        assert!(run.err.contains(told), "{told}: {}", run.err);
    }
    // the one that is asked for, and that of the profile where all goes into one document
    assert_eq!(of_device(&["-o", "one.idx", "--set", "dots.pitch=2.5", "-q"]).code, 0);
    assert!(bytes("one.idx") == bytes("s-2.5.idx") && bytes("one.idx") != bytes("s-1.6.idx"));
    let mut command = place.command(&["calibrate", "--profile", "index-basic-d", "-o", "-", "--format", "idx", "-q"]);
    assert!(command.output().expect("the program starts").stdout == bytes("s-2.0.idx"));
    // names that the program made up cost nobody a file, and then nothing is written
    place.put("t-2.0.idx", b"mine");
    let run = of_device(&["-o", "t.idx"]);
    assert!(run.code == 1 && run.err.contains("t-2.0.idx: this file exists and is another one"), "{}", run.err);
    assert!(!place.path("t-1.6.idx").exists() && bytes("t-2.0.idx") == b"mine");
    let run = place.run(&["calibrate", "-o", "s.idx"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("IDX holds dots, and the profile swell-a4 is for printing"), "{}", run.err);
    assert!(!place.path("s.idx").exists());
}
