//! Pages that somebody changed: what gives way, and what is lost and told.

use std::collections::BTreeSet;

use crate::cli::common::*;
use crate::cli::render::{done, read, with_page};
use crate::common::samples;
use tactograph::Page;

#[test]
fn textures_give_way_to_a_line_that_is_drawn_and_a_page_that_nobody_changed_stays() {
    for (profile, gap) in [("swell-a4", 1.9), ("index-basic-d", 3.9)] {
        let place = with_page(profile);
        let page = read(&place, "cup.svg");
        let glyphs = |page: &Page| page.figure.textures.iter().map(|texture| texture.glyphs.len()).sum::<usize>();
        let texture = page.figure.textures.iter().max_by_key(|texture| texture.glyphs.len()).expect("there is one");
        let (at, box_of) = (texture.glyphs[texture.glyphs.len() / 2].at, page.figure.place);
        let (y, x) = (at.y, [box_of.min.x + 2.0, box_of.max.x - 2.0]);
        let line = format!(
            "<path id=\"mine\" fill=\"none\" stroke=\"#000\" stroke-width=\"1.2\" d=\"M{},{y}L{},{y}\"/>",
            x[0], x[1]
        );
        place.put("line.svg", place.text("cup.svg").replacen("</svg>", &format!("{line}</svg>"), 1).as_bytes());
        let told = done(&place, &["render", "line.svg", "-o", "done.svg"]);
        assert!(
            told.contains("signs of textures that are too near to a line or dot that was drawn or moved"),
            "{told}"
        );
        let after = read(&place, "done.svg");
        assert!(glyphs(&after) < glyphs(&page), "{profile}");
        let nearest = after.figure.textures.iter().flat_map(|texture| &texture.glyphs);
        let nearest = nearest.map(|glyph| (glyph.at.y - y).abs()).fold(f32::MAX, f32::min);
        assert!(nearest > gap, "{profile}: {nearest}");
        let checked = place.run(&["check", "done.svg"]);
        assert!(!checked.out.contains("texture-gap"), "{profile}: {}", checked.out);
        // as it was, and as another program writes the same
        done(&place, &["render", "cup.svg", "-o", "same.svg"]);
        assert_eq!(place.text("same.svg"), place.text("cup.svg"), "{profile}");
        place.put("saved.svg", place.text("cup.svg").replace("/><path", "/>\n<path").as_bytes());
        done(&place, &["render", "saved.svg", "-o", "same-again.svg"]);
        assert_eq!(place.text("same-again.svg"), place.text("cup.svg"), "{profile}");
    }
}

#[test]
fn lines_outside_of_the_figure_and_values_that_a_profile_refuses_are_told() {
    let place = with_page("swell-a4");
    let svg = place.text("cup.svg");
    let figure = read(&place, "cup.svg").figure.place;
    let (x, y) = (figure.min.x + 20.0, figure.max.y + 3.0);
    let outside = format!("<path fill=\"none\" stroke=\"#000\" stroke-width=\"1\" d=\"M{x},{y}h60\"/>");
    place.put("more.svg", svg.replacen("</svg>", &format!("{outside}</svg>"), 1).as_bytes());
    let told = done(&place, &["render", "more.svg", "--profile", "index-basic-d", "-o", "dots.svg"]);
    assert!(told.contains("60 mm of lines outside of the figure"), "{told}");
    let key = "lines.min_gap = ";
    let (before, after) = svg.split_once(key).expect("a page says its profile");
    let (_, rest) = after.split_once('\n').expect("one a line");
    place.put("odd.svg", format!("{before}{key}999\n{rest}").as_bytes());
    let told = done(&place, &["render", "odd.svg", "-o", "even.svg"]);
    assert!(told.contains("is not taken: lines.min_gap = 999"), "{told}");
}

#[test]
fn an_overview_that_fits_no_longer_is_told() {
    let place = Place::new();
    place.put("landscape.svg", &samples::read("landscape.svg"));
    done(&place, &["convert", "landscape.svg", "-o", "page.svg"]);
    let told = done(&place, &["render", "page.svg", "-o", "same.svg"]);
    assert!(!told.contains("the overview is as it was"), "{told}");
    // without the line that is longest
    let page = place.text("page.svg");
    let longest = read(&place, "page.svg").figure.lines.clone();
    let (number, _) = (1..).zip(&longest).max_by(|a, b| a.1.length().total_cmp(&b.1.length())).expect("lines");
    let hidden = page.replacen(&format!("id=\"line-{number}\""), &format!("id=\"line-{number}\" display=\"none\""), 1);
    place.put("changed.svg", hidden.as_bytes());
    let told = done(&place, &["render", "changed.svg", "-o", "done.svg"]);
    assert!(told.contains("the overview is as it was: the figure has nothing like overview line "), "{told}");
}

#[test]
fn lines_that_are_lost_on_another_device_are_named() {
    let place = with_page("swell-a4");
    let [left, top] = [40.0, 100.0];
    let lines: String = [(0.0, "first"), (1.6, "second"), (60.0, "far")]
        .map(|(down, name)| {
            let y = top + down;
            format!("<path id=\"{name}\" stroke=\"#000\" stroke-width=\"1.2\" fill=\"none\" d=\"M{left},{y}h70\"/>")
        })
        .concat();
    let page = place.text("cup.svg");
    let (before, _) = page.split_once("<g id=\"textures\"").expect("it has textures");
    place.put("lines.svg", format!("{before}<g id=\"lines\">{lines}</g></g></svg>").as_bytes());
    let told = done(&place, &["render", "lines.svg", "--profile", "index-basic-d", "-o", "dots.svg"]);
    assert!(told.contains("line \"second\"") ^ told.contains("line \"first\""), "one of the two is named: {told}");
    assert!(!told.contains("line \"far\""), "{told}");
    // strokes drawn on a page of dots
    done(&place, &["convert", "cup.png", "--profile", "index-basic-d", "--no-overview", "--force", "-o", "dotted.svg"]);
    place.put("drawn.svg", place.text("dotted.svg").replacen("</svg>", &format!("{lines}</svg>"), 1).as_bytes());
    let told = done(&place, &["render", "drawn.svg", "-o", "drawn-done.svg"]);
    assert!(told.contains("3 lines on a page of dots made dots, one row of dots"), "{told}");
    // how many rows the drawn line has that the page shows whole
    let rows = |name: &str| {
        let page = read(&place, name);
        let new = page.figure.lines.len() - read(&place, "dotted.svg").figure.lines.len();
        page.figure.lines.iter().rev().take(new).map(|line| line.runs.len()).collect::<BTreeSet<_>>()
    };
    assert_eq!(rows("drawn-done.svg"), BTreeSet::from([1]));
    place.put("broad.svg", place.text("drawn.svg").replace("stroke-width=\"1.2\"", "stroke-width=\"3\"").as_bytes());
    let broad = done(&place, &["render", "broad.svg", "-o", "broad-done.svg"]);
    assert!(broad.contains("made dots, two rows; a stroke narrower than 2 mm"), "{broad}");
    assert!(rows("broad-done.svg").contains(&2), "{broad}");
    assert!(told.contains("line \"second\"") || told.contains("line \"first\""), "{told}");
}
