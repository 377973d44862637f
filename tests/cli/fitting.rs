//! Parts of a picture, sizes on the sheet, and pages with less or the other way round.

use crate::cli::common::*;
use crate::common::samples;

fn page(place: &Place, words: &[&str]) -> String {
    let run = place.run(&[&["convert", "a.png", "-q", "-o", "-"], words].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{words:?}");
    run.out
}

/// Where the figure lies: x, y, width and height.
fn figure(page: &str) -> Vec<f32> {
    let (_, rest) = page.split_once("data-box=\"").expect("a figure");
    rest.split('"').next().unwrap_or_default().split(' ').map(|n| n.parse().expect("a number")).collect()
}

#[test]
fn a_part_is_drawn_as_if_it_were_all() {
    let place = Place::with_picture("a.png");
    let part = page(&place, &["--crop", "0,0,50%,100%"]);
    assert!(part.contains("part of the picture = 0,0,50%,100%"), "the page does not say which part");
    let (all, part) = (figure(&page(&place, &[])), figure(&part));
    assert!((all[2] / all[3] / (part[2] / part[3]) - 2.0).abs() < 0.05, "{all:?} {part:?}");
    for wrong in ["1,2,3", "0,0,0,1", "a,b,c,d"] {
        let run = place.run(&["convert", "a.png", "--crop", wrong]);
        assert_eq!(run.code, 2);
        assert!(run.err.contains("four numbers x,y,width,height") && run.err.lines().count() == 1, "{}", run.err);
    }
    let run = place.run(&["convert", "a.png", "--crop", "0,0,100000,10"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("a.png: the part 0,0,100000,10 reaches beyond the picture"), "{}", run.err);
}

#[test]
fn a_figure_is_as_wide_as_asked() {
    let place = Place::with_picture("a.png");
    let wide = figure(&page(&place, &["--width-mm", "90.5"]));
    assert!((wide[2] - 90.5).abs() < 0.01, "{wide:?}");
    let most = figure(&page(&place, &[]))[2];
    let run = place.run(&["convert", "a.png", "--width-mm", "205"]);
    let what = format!("a figure 205 mm wide does not fit; {most:.1} mm is the most for this picture on this sheet");
    assert_eq!(run.code, 1);
    assert!(run.err.contains(&what), "{}", run.err);
    // the width that is told can be asked for
    page(&place, &["--width-mm", &format!("{most:.1}")]);
    for wrong in ["0", "wide", "-5", "120,5"] {
        let run = place.run(&["convert", "a.png", &format!("--width-mm={wrong}")]);
        assert_eq!(run.code, 2);
        assert!(run.err.contains("give a number of millimetres from 3 to 1200"), "{}", run.err);
    }
}

#[test]
fn lines_or_textures_can_be_had_alone() {
    let place = Place::with_picture("a.png");
    let has = |page: &str| ["id=\"lines\"", "id=\"textures\"", "id=\"overview\""].map(|id| page.contains(id));
    assert_eq!(has(&page(&place, &[])), [true, true, true]);
    assert_eq!(has(&page(&place, &["--outlines"])), [true, false, true]);
    assert_eq!(has(&page(&place, &["--textures-only"])), [false, true, false]);
    assert_eq!(page(&place, &["--outlines"]), page(&place, &["--set", "figure.textures=false"]));
    let run = place.run(&["convert", "a.png", "--outlines", "--textures-only"]);
    assert_eq!(run.code, 2);
}

/// Of two switches the last one counts, as where a script adds one to a line that has the other.
#[test]
fn braille_is_a_switch() {
    let place = Place::with_picture("a.png");
    place.put("silent.toml", b"inherits = \"swell-a4\"\n[braille]\non = false\n");
    let titled = |options: &[&str]| page(&place, &[&["--title", "Apples"], options].concat());
    let has = |options: &[&str]| titled(options).contains("data-braille");
    assert!(has(&[]) && has(&["--braille"]));
    assert!(!has(&["--profile", "silent.toml"]));
    assert!(has(&["--profile", "silent.toml", "--braille"]));
    assert!(!has(&["--no-braille"]) && !has(&["--braille", "--no-braille"]));
    assert_eq!(titled(&["--no-braille", "--braille"]), titled(&["--set", "braille=true"]));
    let run = place.run(&["render", "page.svg", "-o", "b.svg", "--braille"]);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(run.err.contains("there is no option --braille here: words are written in"), "{}", run.err);
}

#[test]
fn a_mirrored_page_has_its_marks_on_the_other_side() {
    let place = Place::with_picture("a.png");
    let (front, back) = (page(&place, &[]), page(&place, &["--mirror"]));
    let mark = |page: &str| {
        let (_, rest) = page.split_once("id=\"orientation-mark\"").expect("there is a mark");
        let (_, rest) = rest.split_once("d=\"M").expect("a path");
        rest.split(',').next().and_then(|x| x.parse::<f32>().ok()).expect("a number")
    };
    assert!((mark(&front) + mark(&back) - 210.0).abs() < 0.011, "{} {}", mark(&front), mark(&back));
    assert!(back.contains("mirrored = true") && !front.contains("mirrored = true"));
    assert!(!page(&place, &["--set", "mark=false"]).contains("orientation-mark"));
}

#[test]
fn several_sheets_are_one_pdf_or_files_with_numbers() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--sheets", "2x1"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a-1.svg to a-3.svg: overview, a1, a2\n"));
    assert_eq!(place.names(), ["a-1.svg", "a-2.svg", "a-3.svg", "a.png"]);
    assert!(place.text("a-1.svg").contains("<title>") && place.text("a-1.svg").contains("a.png, overview"));
    assert!(place.text("a-2.svg").contains("id=\"registration\"") && place.text("a-2.svg").contains("sheets = 2x1"));
    // wider than the sheet: as many sheets as it takes
    let run = place.run(&["convert", "a.png", "--width-mm", "300", "-o", "wide.svg"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(place.text("wide-2.svg").contains("id=\"registration\""), "{}", run.err);
    let run = place.run(&["convert", "a.png", "--sheets", "2x1", "-o", "a.pdf"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a.pdf, 3 sheets: overview, a1, a2\n"));
    let pdf = std::fs::read(place.path("a.pdf")).expect("a PDF");
    assert!(pdf.windows(8).any(|part| part == b"/Count 3"), "not three pages");
    let what = "3 sheets do not go into one file of this format; add --format pdf, or name a file";
    place.refuses(&["convert", "a.png", "--sheets", "2x1", "-o", "-"], 1, &[&format!("standard output: {what}")]);
    // a file of somebody else's is not replaced by a number
    place.put("a-2.svg", b"<svg/>");
    let run = place.run(&["convert", "a.png", "--sheets", "2x1"]);
    assert_eq!((run.code, place.text("a-2.svg").as_str()), (1, "<svg/>"), "{}", run.err);
    for wrong in ["2", "0x2", "1x1", "10x1"] {
        let run = place.run(&["convert", "a.png", "--sheets", wrong]);
        assert_eq!(run.code, 2);
        assert!(run.err.contains("give how many sheets across and down"), "{}", run.err);
    }
}

#[test]
fn the_subject_is_a_place_on_the_picture() {
    let place = Place::new();
    place.put("a.png", &samples::read("coffee.png"));
    for wrong in ["40%", "40%,", "a,b", "140%,20%", "-3,20%", "nan%,20%"] {
        let run = place.run(&["convert", "a.png", "--subject", wrong]);
        assert_eq!(run.code, 2, "{wrong}");
        assert!(run.err.contains("such as 50%,40%"), "{wrong}: {}", run.err);
    }
    let nine: Vec<&str> = ["convert", "a.png"].into_iter().chain(["--subject", "40%,20%"].repeat(9)).collect();
    let run = place.run(&nine);
    assert!(run.code == 2 && run.err.contains("at most 8"), "{}", run.err);
    let run = place.run(&["convert", "a.png", "--calm-background"]);
    assert!(run.code == 2 && run.err.contains("--subject"), "{}", run.err);
    let run = place.run(&["convert", "a.png", "--subject", "240,80", "--calm-background"]);
    assert!(run.code == 0 && run.err.contains("around the subject"), "{}", run.err);
}

/// The library says what helps, and the program with which options.
#[test]
fn what_helps_a_drawing_that_is_too_dense_is_told_with_options() {
    let place = Place::new();
    let rules: String = (0..64).map(|i| format!("<rect x='{}' y='20' width='4' height='552'/>", 20 + i * 12)).collect();
    let ruled = format!("<svg xmlns='http://www.w3.org/2000/svg' width='840' height='592'>{rules}</svg>");
    place.put("ruled.svg", ruled.as_bytes());
    // on several sheets a figure of a width that is asked for is no larger
    let cases: [(&[&str], &str); 3] = [
        (&[], "--no-overview, --sheets 2x2, --crop"),
        (&["--no-overview"], "--sheets 2x2, --crop"),
        (&["--width-mm", "120"], "--crop"),
    ];
    for (asked, options) in cases {
        let run = place.run(&[&["convert", "ruled.svg", "-o", "page.svg", "--force"], asked].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(run.err.contains(&format!("so that it is larger ({options})\n")), "{}", run.err);
    }
}
