//! Pages that are laid out anew: what their key told, and leader lines of drawings.

use crate::cli::common::*;
use crate::cli::render::{done, read};
use crate::common::samples;
use tactograph::internals::page::{Page, TextRole};

/// A chart of two bars in colours that a legend beside them names.
const CHART: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='600' font-family='sans-serif' \
    font-size='26'><rect width='800' height='600' fill='#fff'/>\
    <path d='M100 60V500H560' fill='none' stroke='#000' stroke-width='4'/>\
    <rect x='150' y='250' width='130' height='250' fill='#2050c0'/>\
    <rect x='350' y='150' width='130' height='350' fill='#d03020'/>\
    <rect x='600' y='80' width='30' height='30' fill='#2050c0'/><text x='640' y='105'>Cats</text>\
    <rect x='600' y='140' width='30' height='30' fill='#d03020'/><text x='640' y='165'>Dogs</text></svg>";

/// What the key says.
fn key(page: &Page) -> Vec<&str> {
    page.braille.iter().filter(|text| text.role == TextRole::Key).map(|text| text.text.as_str()).collect()
}

/// A folder with the page of a chart, and its key.
fn with_legend() -> Place {
    let place = Place::new();
    place.put("chart.svg", CHART.as_bytes());
    let told =
        done(&place, &["convert", "chart.svg", "--labels", "texts", "--title", "Pets", "--no-overview", "-o", "p.svg"]);
    assert!(told.contains("wrote p-1.svg to p-2.svg: figure, key"), "{told}");
    assert_eq!(key(&read(&place, "p-2.svg")), ["Key: Pets", "blue: Cats", "red: Dogs"]);
    place
}

#[test]
fn a_page_for_another_device_has_a_key_with_what_its_colours_mean() {
    let place = with_legend();
    for profile in ["index-basic-d", "viewplus-columbia", "swell-a3"] {
        let args = ["render", "p-1.svg", "--profile", profile, "--set", "overview=false", "--force", "-o", "x.svg"];
        let told = done(&place, &args);
        assert_eq!(key(&read(&place, "x-2.svg")), ["Key: Pets", "blue: Cats", "red: Dogs"], "{profile}: {told}");
        // and the page that was made so knows it as well
        done(&place, &["render", "x-1.svg", "--profile", "swell-a4", "--force", "-o", "again.svg"]);
        assert_eq!(key(&read(&place, "again-2.svg")), ["Key: Pets", "blue: Cats", "red: Dogs"], "{profile}");
    }
}

#[test]
fn a_sheet_of_a_key_keeps_its_words_on_another_device() {
    let place = with_legend();
    for profile in ["index-basic-d", "viewplus-columbia", "swell-letter"] {
        let told = done(&place, &["render", "p-2.svg", "--profile", profile, "--force", "-o", "k.svg"]);
        let page = read(&place, "k.svg");
        assert_eq!(key(&page), ["Key: Pets", "blue: Cats", "red: Dogs"], "{profile}: {told}");
        assert_eq!((page.title.as_str(), page.figure.textures.len()), ("Pets, key", 2), "{profile}: {told}");
        assert!(!told.contains("no contour"), "{profile}: {told}");
    }
    // abbreviations too
    let long = "x,y,text\n30%,60%,Thermometers of the whole house\n";
    place.put("words.csv", long.as_bytes());
    let args = ["convert", "chart.svg", "--labels", "words.csv", "--key", "always", "--no-overview", "-o", "w.svg"];
    done(&place, &args);
    let before = read(&place, "w-2.svg");
    assert!(key(&before).iter().any(|text| text.ends_with(": Thermometers of the whole house")), "{:?}", key(&before));
    done(&place, &["render", "w-2.svg", "--profile", "index-basic-d", "-o", "wk.svg"]);
    assert_eq!(key(&read(&place, "wk.svg")), key(&before));
}

#[test]
fn a_key_that_fits_no_longer_is_told_and_written_anew() {
    let place = with_legend();
    let page = place.text("p-1.svg");
    let (before, rest) = page.split_once("id=\"texture-red\"").expect("there is red");
    let red = &rest[..rest.find("</g>").expect("the layer ends")];
    let without =
        |name: &str| place.put(name, format!("{before}id=\"texture-red\"{}", rest.replacen(red, ">", 1)).as_bytes());
    without("edited.svg");
    let told = done(&place, &["render", "edited.svg", "-o", "new.svg"]);
    assert!(
        told.contains("the key that was made with the page no longer fits it: red is not on the page; the one that")
    );
    assert!(told.contains("what the colours of the legend mean (\"Dogs\")"), "{told}");
    assert_eq!(key(&read(&place, "new-2.svg")), ["Key: Pets", "blue: Cats"]);
    let told = done(&place, &["render", "edited.svg", "--key", "never", "-o", "alone.svg"]);
    assert!(told.contains("no longer fits it: red is not on the page; take it away"), "{told}");
    // the new page has a key that fits
    place.put("new.svg", place.text("new-1.svg").replace("</svg>", " </svg>").as_bytes());
    let told = done(&place, &["render", "new.svg", "-o", "same.svg"]);
    assert!(!told.contains("no longer fits") && told.contains("wrote same.svg\n"), "{told}");
    // and so has one that is only saved
    place.put("saved.svg", page.replace("</svg>", " </svg>").as_bytes());
    let told = done(&place, &["render", "saved.svg", "-o", "saved.pdf"]);
    assert!(!told.contains("no longer fits") && told.contains("wrote saved.pdf\n"), "{told}");
    assert!(told.contains("made with the page is a file of its own: render that file too"), "{told}");
}

/// Leader lines that a drawing has are lines of its page. On a device with larger gaps they may be cut: then the label
/// stands at what it names, or has a line of its own.
#[test]
fn leader_lines_of_a_drawing_are_whole_on_another_device_or_not_there() {
    let place = Place::new();
    place.put("cell.svg", &samples::read("cell.svg"));
    done(&place, &["convert", "cell.svg", "--labels", "texts", "--no-overview", "-o", "page.svg"]);
    assert_eq!(read(&place, "page.svg").figure.lines.len(), 9, "5 outlines, and a line for each of 4 labels");
    let args = ["render", "page.svg", "--profile", "index-basic-d", "--set", "overview=false", "-o", "dots.svg"];
    let told = done(&place, &args);
    assert!(told.contains("the leader lines of \"mitochondrion\", ") && told.contains("\"vacuole\""), "{told}");
    let page = read(&place, "dots.svg");
    assert_eq!(page.figure.lines.len(), 8, "that of the membrane is whole, that of the nucleus crosses it: {told}");
    // the vacuole lies right of the middle, below it
    let at = |text: &str| {
        let label = page.braille.iter().find(|label| label.text == text).expect("it is labelled");
        let tip = label.leader.as_ref().and_then(|leader| leader.points.last());
        tip.or(label.dots.at.first()).copied().expect("it has dots")
    };
    let (figure, vacuole) = (page.figure.place, at("vacuole"));
    let share = (vacuole - figure.min).component_div(figure.size().to_vector());
    assert!((0.4..0.6).contains(&share.x) && (0.55..0.85).contains(&share.y), "{share:?}");
    let checked = place.run(&["check", "dots.svg"]);
    assert!(checked.code == 0 && !checked.out.contains("label-line"), "{}", checked.out);
    // so they are where the lines of the page are drawn of the picture
    let args = ["convert", "cell.svg", "--lines", "page.svg", "--labels", "texts", "--profile", "index-basic-d"];
    let told = done(&place, &[&args[..], &["--no-overview", "--key", "never", "-o", "lines.svg"]].concat());
    assert!(told.contains("the leader lines of \"mitochondrion\", "), "{told}");
    assert_eq!(read(&place, "lines.svg").figure.lines.len(), 8, "{told}");
    // on paper with the same gaps they are as they were
    let told = done(&place, &["render", "page.svg", "--profile", "swell-a3", "-o", "large.svg"]);
    assert!(!told.contains("the leader line"), "{told}");
}

/// Numbers beside an axis have room on another device too: the drawing is made smaller in its frame for them.
#[test]
fn numbers_of_an_axis_stay_on_another_device() {
    let place = Place::new();
    place.put("chart.svg", &samples::read("chart.svg"));
    done(&place, &["convert", "chart.svg", "--labels", "texts", "--no-overview", "--key", "never", "-o", "page.svg"]);
    let numbers = |page: &Page| -> Vec<String> {
        let texts = page.braille.iter().map(|text| text.text.clone());
        texts.filter(|text| text.parse::<u32>().is_ok()).collect()
    };
    let before = numbers(&read(&place, "page.svg"));
    assert!(before.len() >= 3, "{before:?}");
    for profile in ["index-basic-d", "dot-pad"] {
        let args = ["render", "page.svg", "--profile", profile, "--set", "overview=false", "--key", "never", "--force"];
        let told = done(&place, &[&args[..], &["-o", "dots.svg"]].concat());
        assert_eq!(numbers(&read(&place, "dots.svg")), before, "{profile}: {told}");
    }
}
