//! Pages in: in other formats, for other devices, and what a person corrected in a rerun.

use crate::cli::common::*;
use crate::common::samples;
use tactograph::internals::page::Class;
use tactograph::marks::{Line, Pen, Run};
use tactograph::{Page, Profile};

/// A folder with a picture and its page.
pub(crate) fn with_page(profile: &str) -> Place {
    let place = Place::new();
    place.put("cup.png", &samples::read("coffee.png"));
    let run = place.run(&["convert", "cup.png", "--no-overview", "--profile", profile, "-q"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    place
}

pub(crate) fn read(place: &Place, name: &str) -> Page {
    reading(&place.text(name))
}

pub(crate) fn reading(svg: &str) -> Page {
    tactograph::internals::reading::read(svg.as_bytes()).expect("it is a page").page
}

pub(crate) fn done(place: &Place, args: &[&str]) -> String {
    let run = place.run(args);
    assert_eq!(run.code, 0, "{args:?}: {}", run.err);
    run.err
}

fn runs(page: &Page) -> Vec<&Run> {
    page.figure.lines.iter().flat_map(|line| &line.runs).collect()
}

#[test]
fn dots_drawn_by_hand_are_told_where_they_are_left_out() {
    let place = with_page("swell-a4");
    let page = place.text("cup.svg");
    let disc = "<circle cx=\"30\" cy=\"30\" r=\"0.75\" fill=\"#000\"/></svg>";
    place.put("marked.svg", page.replace("</svg>", disc).as_bytes());
    let left_out = "1 dot drawn by hand";
    let told = done(&place, &["render", "marked.svg", "-o", "same.svg"]);
    assert!(!told.contains(left_out) && !read(&place, "same.svg").labels.is_empty(), "{told}");
    for args in [
        vec!["render", "marked.svg", "--profile", "index-basic-d", "-o", "cup.idx"],
        vec!["convert", "cup.png", "--lines", "marked.svg", "-o", "anew.svg"],
    ] {
        let told = done(&place, &args);
        assert!(told.contains(left_out), "{args:?}: {told}");
    }
}

#[test]
fn a_page_becomes_any_format() {
    let place = with_page("swell-a4");
    done(&place, &["render", "cup.svg", "-o", "same.svg"]);
    assert_eq!(place.text("same.svg"), place.text("cup.svg"));
    done(&place, &["render", "cup.svg", "-o", "cup.pdf"]);
    done(&place, &["convert", "cup.png", "--no-overview", "-o", "direct.pdf"]);
    let file = |name: &str| std::fs::read(place.path(name)).expect("it is there");
    assert!(file("cup.pdf").starts_with(b"%PDF") && file("cup.pdf").len().abs_diff(file("direct.pdf").len()) < 200);
    place.refuses(
        &["render", "cup.svg", "-o", "cup.idx"],
        2,
        &["cup.svg: IDX holds dots, and the profile swell-a4 is for printing; take one for dots, such as \
           --profile index-basic-d"],
    );
}

#[test]
fn dots_are_the_same_after_a_page_of_them_was_read() {
    let place = with_page("index-basic-d");
    done(&place, &["render", "cup.svg", "-o", "read.idx"]);
    done(&place, &["convert", "cup.png", "--no-overview", "--profile", "index-basic-d", "-o", "direct.idx"]);
    let file = |name: &str| std::fs::read(place.path(name)).expect("it is there");
    assert_eq!(file("read.idx"), file("direct.idx"));
}

#[test]
fn a_printed_page_is_laid_out_anew_for_a_device() {
    let place = with_page("swell-a4");
    done(&place, &["render", "cup.svg", "--profile", "index-basic-d", "-o", "dots.idx"]);
    done(&place, &["render", "cup.svg", "--profile", "index-basic-d", "--set", "overview=false", "-o", "dots.svg"]);
    let (print, dots) = (read(&place, "cup.svg"), read(&place, "dots.svg"));
    let direct = {
        let mut profile = Profile::named("index-basic-d").expect("it is built in");
        profile.set("overview", "false").expect("there is such a key");
        tactograph::convert(&samples::read("coffee.png"), &tactograph::Options::new(profile)).expect("a page").page
    };
    let (here, there) = (dots.figure.place, direct.figure.place);
    assert!((here.min - there.min).length() < 0.1 && (here.max - there.max).length() < 0.1, "{here:?} {there:?}");
    // the same colours, about as much of each
    let share = |page: &Page, class: Class| {
        let of = page.figure.textures.iter().filter(|texture| texture.class == class);
        of.map(|texture| texture.area).sum::<f32>() / page.figure.place.area()
    };
    for class in Class::ALL {
        let (print, dots, direct) = (share(&print, class), share(&dots, class), share(&direct, class));
        assert!((dots - direct).abs() < 0.1 && (dots - print).abs() < 0.1, "{class:?}: {print} {dots} {direct}");
    }
    let is_dot = |run: &Run| run.pen != Pen::Stroke;
    assert!(dots.figure.lines.len() * 2 > direct.figure.lines.len() && runs(&dots).into_iter().all(is_dot));
}

#[test]
fn a_page_is_no_picture() {
    let place = with_page("swell-a4");
    place.refuses(
        &["convert", "cup.svg", "-o", "x.pdf"],
        1,
        &["cup.svg: this is a page that tactograph made, and no picture; render it to write it in another format or \
          for another device (tactograph render)"],
    );
    place.put("plain.svg", DRAWING.as_bytes());
    let run = place.run(&["render", "plain.svg", "-o", "x.pdf"]);
    assert!(run.code == 1 && run.err.contains("plain.svg: this cannot be read as a page"), "{}", run.err);
    assert_eq!(place.run(&["render", "cup.svg"]).code, 2);
}

#[test]
fn what_a_person_draws_is_made_fit() {
    let place = with_page("swell-a4");
    let drawn = "<path d=\"M30,60h60\" stroke=\"#000\" stroke-width=\"0.2\"/><path d=\"M30,70h60\" stroke=\"#000\" \
                 stroke-width=\"9\"/></svg>";
    place.put("edited.svg", place.text("cup.svg").replace("</svg>", drawn).as_bytes());
    let told = done(&place, &["render", "edited.svg", "-o", "fit.svg"]);
    assert!(told.contains("2 lines are drawn 0.75 or 1.50 mm wide, the least and the most of the profile"), "{told}");
    let page = read(&place, "fit.svg");
    let of = |y: f32| runs(&page).into_iter().find(|run| (run.points[0].y - y).abs() < 1e-3).map(|run| run.width);
    assert_eq!((of(60.0), of(70.0)), (Some(0.75), Some(1.5)));
}

#[test]
fn an_area_in_another_group_of_textures_has_its_signs() {
    let place = with_page("swell-a4");
    let svg = place.text("cup.svg");
    let document = roxmltree::Document::parse(&svg).expect("a page is well-formed");
    let red = document.descendants().find(|node| node.attribute("data-class") == Some("red")).expect("red");
    let text = &svg[red.range()];
    let without = svg.replacen(text, "", 1);
    let group = without.find("id=\"texture-yellow\"").expect("there is yellow");
    let inside = group + without[group..].find('>').expect("the group begins") + 1;
    place.put("edited.svg", format!("{}{text}{}", &without[..inside], &without[inside..]).as_bytes());
    let told = done(&place, &["render", "edited.svg", "-o", "new.svg"]);
    assert!(told.contains(", which was moved to yellow or turned, is drawn with the texture of yellow"), "{told}");
    let (before, after) = (read(&place, "cup.svg"), read(&place, "new.svg"));
    let glyphs = |page: &Page, class: Class| {
        page.figure.textures.iter().filter(|texture| texture.class == class).map(|texture| texture.glyphs.len()).sum()
    };
    let grown: usize = glyphs(&after, Class::Yellow);
    assert!(grown > glyphs(&before, Class::Yellow), "the area has signs of yellow");
    let rerun = ["convert", "cup.png", "--regions", "edited.svg", "--no-overview", "-o", "rerun.svg"];
    done(&place, &rerun);
    let rerun = read(&place, "rerun.svg");
    assert!(glyphs(&rerun, Class::Yellow) > glyphs(&before, Class::Yellow));
    assert!(glyphs(&rerun, Class::Red) < glyphs(&before, Class::Red));
}

#[test]
fn lines_of_a_page_come_again_and_a_deleted_one_stays_away() {
    let place = with_page("swell-a4");
    done(&place, &["convert", "cup.png", "--lines", "cup.svg", "--no-overview", "-o", "again.svg"]);
    let (before, again) = (read(&place, "cup.svg"), read(&place, "again.svg"));
    let length = |page: &Page| runs(page).into_iter().map(Run::length).sum::<f32>();
    assert!((length(&again) / length(&before) - 1.0).abs() < 0.02, "{} of {}", length(&again), length(&before));
    let near = |at: tactograph::MmPoint, page: &Page| {
        let segments = runs(page).into_iter().flat_map(|run| run.path().zip(run.path().skip(1)).collect::<Vec<_>>());
        let distance = |(a, b)| tactograph::internals::geom::nearest_on_segment(at, a, b).0;
        segments.map(distance).fold(f32::MAX, f32::min)
    };
    let off = runs(&again).iter().flat_map(|run| &run.points).map(|at| near(*at, &before)).fold(0.0, f32::max);
    assert!(off < 0.1, "a line lies {off} mm from where it was");
    // the first line is deleted
    let hidden = place.text("cup.svg").replacen("id=\"line-1\"", "id=\"line-1\" style=\"display:none\"", 1);
    place.put("less.svg", hidden.as_bytes());
    done(&place, &["convert", "cup.png", "--lines", "less.svg", "--no-overview", "-o", "less-again.svg"]);
    let less = read(&place, "less-again.svg");
    let first = &before.figure.lines[0].runs[0];
    let middle = first.points[first.points.len() / 2];
    assert!(near(middle, &again) < 0.1 && near(middle, &less) > 1.0);
}

#[test]
fn lines_of_a_picture_of_lines_run_along_the_middle_of_its_strokes() {
    let place = Place::new();
    place.put("cup.png", &samples::read("coffee.png"));
    let mut rgb = vec![255; 600 * 400 * 3];
    for y in 196..204 {
        rgb[3 * (600 * y + 60)..3 * (600 * y + 540)].fill(0);
    }
    place.put("lines.png", &png(600, 400, &rgb));
    done(&place, &["convert", "cup.png", "--lines", "lines.png", "--no-overview", "-o", "page.svg"]);
    let page = read(&place, "page.svg");
    let middle = page.figure.place.center().y;
    assert_eq!(page.figure.lines.len(), 1);
    assert!(runs(&page).iter().flat_map(|run| &run.points).all(|at| (at.y - middle).abs() < 0.2), "{:?}", runs(&page));
    assert!((page.figure.lines[0].length() / page.figure.place.width() - 0.8).abs() < 0.02);
}

#[test]
fn lines_that_are_added_win() {
    let place = with_page("swell-a4");
    let box_of = read(&place, "cup.svg").figure.place;
    let own = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='400' viewBox='0 0 600 400'><g id='Lines'>\
         <path d='M30,210h540' stroke='black' stroke-width='4' fill='none'/></g></svg>";
    place.put("own.svg", own.as_bytes());
    done(&place, &["convert", "cup.png", "--add-lines", "own.svg", "--no-overview", "-o", "more.svg"]);
    let page = read(&place, "more.svg");
    let y = box_of.min.y + box_of.height() * 210.0 / 400.0;
    let mine = page
        .figure
        .lines
        .iter()
        .filter(|line| line.runs.iter().flat_map(|run| &run.points).all(|at| (at.y - y).abs() < 0.1));
    let length: f32 = mine.map(Line::length).sum();
    assert!((length / box_of.width() - 0.9).abs() < 0.01, "all of it is drawn, not {length} mm");
    assert!(page.figure.lines.len() > 5, "the others are there as well");
    // a drawing needs no layer of that name
    let plain = own.replace("<g id='Lines'>", "<g>");
    place.put("plain.svg", plain.as_bytes());
    let told = done(&place, &["convert", "cup.png", "--add-lines", "plain.svg", "--no-overview", "-o", "same.svg"]);
    assert!(read(&place, "same.svg").figure.lines == page.figure.lines, "{told}");
}

#[test]
fn what_is_erased_is_blank() {
    let place = with_page("swell-a4");
    let erase = ["convert", "cup.png", "--erase", "0,0,50%,100%", "--erase", "90%,0,10%,20%", "--no-overview"];
    done(&place, &[&erase[..], &["-o", "less.svg"]].concat());
    let page = read(&place, "less.svg");
    let place = page.figure.place;
    let middle = place.center().x;
    assert!(runs(&page).iter().flat_map(|run| &run.points).all(|at| at.x > middle - 1.0));
    assert!(page.figure.textures.iter().flat_map(|texture| &texture.glyphs).all(|glyph| glyph.at.x > middle));
    assert!(!page.figure.lines.is_empty() && !page.figure.textures.is_empty());
}

/// How many signs of a class have their middle in a box: left, top, right, bottom in mm.
pub(crate) fn signs(page: &Page, class: Class, [left, top, right, bottom]: [f32; 4]) -> usize {
    let of_class = page.figure.textures.iter().filter(|texture| texture.class == class);
    let inside = |at: tactograph::MmPoint| (left..=right).contains(&at.x) && (top..=bottom).contains(&at.y);
    of_class.flat_map(|texture| &texture.glyphs).filter(|glyph| inside(glyph.at)).count()
}

#[test]
fn a_shape_that_is_drawn_and_filled_is_an_area_of_its_colour() {
    let place = with_page("swell-a4");
    let within = [31.0, 101.0, 59.0, 129.0];
    let with = |added: &str| place.text("cup.svg").replacen("</svg>", &format!("{added}</svg>"), 1);
    let square = "<path d=\"M30,100h30v30h-30z\" fill=\"#1040d0\"/>";
    place.put("blue.svg", with(square).as_bytes());
    let told = done(&place, &["render", "blue.svg", "-o", "done.svg"]);
    assert!(told.contains("1 drawn area filled with the texture of its colour"), "{told}");
    assert_eq!(told.matches(": note: ").count(), 1, "it is told once: {told}");
    let page = read(&place, "done.svg");
    assert!(signs(&page, Class::Blue, within) > 20);
    for other in [Class::Green, Class::Yellow, Class::Red, Class::Grey] {
        assert_eq!(signs(&page, other, within), 0, "{other:?}");
    }
    assert_eq!(page.figure.lines.len(), read(&place, "cup.svg").figure.lines.len(), "no line is drawn around it");
    let area: f32 = page.figure.textures.iter().filter(|of| of.class == Class::Blue).map(|of| of.area).sum();
    assert!((area - 900.0).abs() < 10.0, "{area}");
    // what is written is a page like any other
    let again = done(&place, &["render", "done.svg", "-o", "again.svg"]);
    assert!(!again.contains("note") && place.text("again.svg") == place.text("done.svg"), "{again}");
    // as dots, and in a rerun
    done(&place, &["render", "blue.svg", "--profile", "index-basic-d", "--set", "overview=false", "-o", "dots.svg"]);
    let dots = read(&place, "dots.svg");
    assert!(dots.figure.textures.iter().any(|texture| texture.class == Class::Blue));
    done(&place, &["convert", "cup.png", "--regions", "blue.svg", "--no-overview", "-o", "new.svg"]);
    assert!(signs(&read(&place, "new.svg"), Class::Blue, within) > 20);
    // with a stroke there is a line too; in a layer of textures the colour is that of the layer
    let ring = square.replace("fill=", "stroke=\"#000\" stroke-width=\"1.2\" fill=");
    place.put("ring.svg", with(&ring).as_bytes());
    done(&place, &["render", "ring.svg", "-o", "ringed.svg"]);
    let ringed = read(&place, "ringed.svg");
    assert_eq!(ringed.figure.lines.len(), page.figure.lines.len() + 1);
    assert!(signs(&ringed, Class::Blue, within) > 10);
    let layer = format!(
        "<g inkscape:groupmode=\"layer\" inkscape:label=\"Texture green\">{}</g>",
        square.replace("#1040d0", "#000")
    );
    place.put("green.svg", with(&layer).as_bytes());
    done(&place, &["render", "green.svg", "-o", "greened.svg"]);
    assert!(signs(&read(&place, "greened.svg"), Class::Green, within) > 20);
    // a small hole is a part of it
    let holed = square.replace("h-30z", "h-30z m10,10h4v4h-4z").replace("fill=", "fill-rule=\"evenodd\" fill=");
    place.put("holed.svg", with(&holed).as_bytes());
    let told = done(&place, &["render", "holed.svg", "-o", "filled.svg"]);
    assert!(told.contains("1 drawn area filled with the texture of its colour"), "{told}");
    // braille that is there already keeps its blank
    let at = page.figure.place;
    let share = [(45.0 - at.min.x) / at.width(), (115.0 - at.min.y) / at.height()].map(|share| 100.0 * share);
    place.put("cup.csv", format!("{}%,{}%,cup\n", share[0], share[1]).as_bytes());
    let labels = ["--labels", "cup.csv", "--key", "never", "--no-overview", "--force", "-o", "cup.svg"];
    done(&place, &[&["convert", "cup.png"][..], &labels].concat());
    place.put("labelled.svg", with(square).as_bytes());
    done(&place, &["render", "labelled.svg", "-o", "labelled-done.svg"]);
    let page = read(&place, "labelled-done.svg");
    let label = page.braille.iter().find(|text| text.text == "cup").expect("the label stays");
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let nearest = glyphs.flat_map(|glyph| label.dots.at.iter().map(|dot| (*dot - glyph.at).length()));
    let nearest = nearest.fold(f32::MAX, f32::min);
    assert!(nearest >= 3.0, "a sign is {nearest} mm from a dot of braille");
    // what has no texture is told
    let thin = "<path d=\"M30,100h60v0.9h-60z\" fill=\"#1040d0\"/>";
    place.put("thin.svg", with(thin).as_bytes());
    let told = done(&place, &["render", "thin.svg", "-o", "x.svg"]);
    assert!(told.contains("1 drawn area (the first at 60, 100 mm), too small for a texture"), "{told}");
}

#[test]
fn the_last_of_many_drawn_areas_lies_on_top_and_too_many_are_told() {
    let place = with_page("swell-a4");
    let with = |added: &str| place.text("cup.svg").replacen("</svg>", &format!("{added}</svg>"), 1);
    let square = |colour: &str| format!("<path d=\"M30,100h30v30h-30z\" fill=\"{colour}\"/>");
    place.put("two.svg", with(&(square("#1040d0") + &square("#d01010"))).as_bytes());
    let told = done(&place, &["render", "two.svg", "-o", "done.svg"]);
    assert!(told.contains("1 drawn area filled with the texture of its colour"), "{told}");
    assert!(told.contains("1 drawn area (the first at 45, 115 mm), under others"), "{told}");
    let (page, within) = (read(&place, "done.svg"), [31.0, 101.0, 59.0, 129.0]);
    assert_eq!(signs(&page, Class::Blue, within), 0);
    assert!(signs(&page, Class::Red, within) > 20);
    place.put("many.svg", with(&square("#1040d0").repeat(1100)).as_bytes());
    let told = done(&place, &["render", "many.svg", "-o", "done-many.svg"]);
    assert!(told.contains("1 drawn area filled"), "{told}");
    assert!(told.contains("100 drawn areas (the first at 45, 115 mm), more than 1000, the most on a page"), "{told}");
    assert!(told.contains("999 drawn areas (the first at 45, 115 mm), under others"), "{told}");
}

#[test]
fn words_of_a_page_that_are_not_taken_are_told() {
    let place = with_page("swell-a4");
    let added = "<g id=\"labels-text\"><text x=\"90\" y=\"120\">cup</text></g>";
    place.put("typed.svg", place.text("cup.svg").replacen("</svg>", &format!("{added}</svg>"), 1).as_bytes());
    let wanted = "the text \"cup\" that was typed at 90, 120 mm: lines and areas are taken from a corrected page, and no \
                  words; give them as labels";
    for option in ["--lines", "--regions", "--add-lines"] {
        let told =
            done(&place, &["convert", "cup.png", option, "typed.svg", "--no-overview", "-o", "x.svg", "--force"]);
        assert_eq!(told.matches(wanted).count(), 1, "{option}: {told}");
    }
    // beside the figure
    let outside = added.replace("x=\"90\" y=\"120\"", "x=\"3\" y=\"290\"");
    place.put("outside.svg", place.text("cup.svg").replacen("</svg>", &format!("{outside}</svg>"), 1).as_bytes());
    let told = done(&place, &["render", "outside.svg", "-o", "done.svg"]);
    assert!(told.contains("the text \"cup\" at 3, 290 mm lies outside the figure"), "{told}");
}

#[test]
fn typed_texts_are_written_in_braille_or_told_with_their_place() {
    let place = with_page("swell-a4");
    let added = "<g id=\"labels-text\" transform=\"translate(10 20)\"><text x=\"90\" y=\"120\"><tspan>c</tspan>u<tspan>p</tspan></text></g>\
                 <text transform=\"scale(2)\" x=\"12\" y=\"60\">\u{2813}\u{280a}</text>\
                 <text x=\"30\" y=\"60\">Oven</text><text x=\"31\" y=\"61\" style=\"display:none\">never</text><text x=\"31\" y=\"65\" visibility=\"hidden\">never</text>";
    place.put("typed.svg", place.text("cup.svg").replacen("</svg>", &format!("{added}</svg>"), 1).as_bytes());
    let told = done(&place, &["render", "typed.svg", "-o", "done.svg"]);
    assert!(told.contains("1 text that was typed is written in braille beside its place"), "{told}");
    assert!(told.contains("1 text that was typed in braille: written as typed"), "{told}");
    assert!(told.contains("text \"Oven\" at 30, 60 mm: fingers read no print letters"), "{told}");
    assert!(!told.contains("never"), "{told}");
    let page = read(&place, "done.svg");
    let [cup, hi] = &page.braille[..] else { panic!("{:?}", page.braille) };
    assert_eq!((cup.text.as_str(), cup.lines.join(" ")), ("cup", "\u{2809}\u{2825}\u{280f}".to_owned()));
    assert_eq!(hi.lines.join(" "), "\u{2813}\u{280a}");
    // not far from where they were typed, or led there
    for (text, at) in [(cup, [100.0, 140.0]), (hi, [24.0, 120.0])] {
        let at = tactograph::MmPoint::new(at[0], at[1]);
        let ends = text.leader.iter().flat_map(|run| &run.points);
        let nearest = text.dots.at.iter().chain(ends).map(|dot| (*dot - at).length()).fold(f32::MAX, f32::min);
        assert!(nearest < 15.0, "{}: {nearest} mm away", text.text);
    }
    let checked = place.run(&["check", "done.svg"]);
    assert!(!checked.out.contains("error braille"), "{}", checked.out);
    // entities, as Illustrator declares them, change nothing
    let namespace = "\"http://www.w3.org/2000/svg\"";
    let plain = place.text("typed.svg");
    let (_, root) = plain.split_once("<svg ").expect("a root");
    let declared =
        format!("<!DOCTYPE svg [<!ENTITY ns_svg {namespace}>]>\n<svg {}", root.replacen(namespace, "\"&ns_svg;\"", 1));
    assert!(declared.contains("xmlns=\"&ns_svg;\""));
    place.put("entities.svg", declared.as_bytes());
    let told = done(&place, &["render", "entities.svg", "-o", "of-entities.svg"]);
    assert!(told.contains("text \"Oven\" at 30, 60 mm: fingers read no print letters"), "{told}");
    assert_eq!(place.text("of-entities.svg"), place.text("done.svg"));
    let again = done(&place, &["render", "done.svg", "--profile", "index-basic-d", "-o", "dots.svg"]);
    assert!(!again.contains("no cells for it"), "{again}");
}

#[test]
fn a_page_that_is_corrected_by_hand_is_written_for_printer_and_embosser() {
    let place = Place::new();
    place.put("coffee.png", &samples::read("coffee.png"));
    done(&place, &["convert", "coffee.png", "-o", "cup.svg"]);
    let stages = tactograph_tools::correction::stages(&place.text("cup.svg")).expect("it is the page of the sample");
    let last = &stages[stages.len() - 1];
    place.put("cup.svg", last.svg.as_bytes());
    done(&place, &["render", "cup.svg", "-o", "cup.pdf"]);
    done(&place, &["render", "cup.svg", "--profile", "index-basic-d", "-o", "cup.idx"]);
    done(&place, &["render", "cup.svg", "-o", "done.svg"]);
    done(&place, &["render", "cup.svg", "--profile", "index-basic-d", "-o", "dots.svg"]);
    let (before, after) = (reading(&stages[0].svg), read(&place, "done.svg"));
    // six pieces of clutter and one of the saucer less, one curve more
    assert_eq!(after.figure.lines.len(), before.figure.lines.len() - 6);
    let left = [21.0, 84.0, 40.0, 118.0];
    assert!(signs(&before, Class::Yellow, left) > 10 && signs(&before, Class::Red, left) == 0);
    assert!(signs(&after, Class::Red, left) > 10 && signs(&after, Class::Yellow, left) == 0);
    assert!(signs(&after, Class::Blue, [25.0, 125.0, 50.0, 147.0]) > 5);
    assert_eq!(after.labels.last().map(|dots| (dots.diameter, dots.at.len())), Some((1.5, 1)));
    let dots = read(&place, "dots-1.svg");
    let classes: Vec<Class> = dots.figure.textures.iter().map(|texture| texture.class).collect();
    assert!(classes.contains(&Class::Blue) && classes.contains(&Class::Red), "{classes:?}");
    let file = |name: &str| std::fs::read(place.path(name)).expect("it is there");
    assert!(file("cup.pdf").starts_with(b"%PDF") && file("cup.idx").starts_with(b"\x1b"));
    // and no line of the correction breaks a rule
    let run = place.run(&["check", "done.svg"]);
    assert!(!run.out.contains("error line-"), "{}", run.out);
}

#[test]
fn what_is_left_of_an_area_beside_what_is_erased_is_large_enough_or_blank() {
    let place = with_page("swell-a4");
    let told = done(&place, &["convert", "cup.png", "--keep", "40mm,0mm,90mm,80mm", "--no-overview", "-o", "less.svg"]);
    assert!(told.contains("the texture of what is left of 1 area (at "), "{told}");
    let checked = place.run(&["check", "less.svg"]);
    assert!(checked.code == 0 && checked.out.contains("Verdict: 0 errors"), "{}", checked.out);
    let told = done(&place, &["convert", "cup.png", "--keep", "0,0,100%,99%", "--no-overview", "-o", "most.svg"]);
    assert!(!told.contains("what is left of"), "{told}");
}

#[test]
fn what_is_not_kept_is_blank_and_mm_are_those_of_the_figure() {
    let place = with_page("swell-a4");
    let run = |name: &str, options: &[&str]| {
        done(&place, &[&["convert", "cup.png", "--no-overview", "-o", name], options].concat());
        read(&place, name)
    };
    let whole = run("whole.svg", &[]).figure.place;
    let (left, width) = (0.25 * whole.width(), 0.5 * whole.width());
    let in_mm = format!("{left}mm,0mm,{width}mm,{}mm", whole.height());
    let page = run("kept.svg", &["--keep", &in_mm]);
    assert_eq!(page.figure.place, whole, "what is kept stays where it is");
    let is_kept = |x: f32| (left - 1.0..=left + width + 1.0).contains(&(x - whole.min.x));
    assert!(runs(&page).iter().flat_map(|run| &run.points).all(|at| is_kept(at.x)));
    assert!(page.figure.textures.iter().flat_map(|texture| &texture.glyphs).all(|glyph| is_kept(glyph.at.x)));
    assert!(!page.figure.lines.is_empty() && !page.figure.textures.is_empty());
    // in percent, and as the opposite of what is erased
    let same = run("percent.svg", &["--keep", "25%,0%,50%,100%"]).figure.clone();
    let erased = run("erased.svg", &["--erase", "0%,0%,25%,100%", "--erase", "75%,0%,25%,100%"]).figure.clone();
    assert_eq!((same.lines.len(), same.textures.len()), (erased.lines.len(), erased.textures.len()));
    // of two parts both are there
    let two = run("two.svg", &["--keep", "0,0,20%,100%", "--keep", "80%,0,20%,100%"]);
    let middle = |x: f32| (0.22..0.78).contains(&((x - whole.min.x) / whole.width()));
    assert!(runs(&two).iter().flat_map(|run| &run.points).all(|at| !middle(at.x)));
    let beyond = place.run(&["convert", "cup.png", "-o", "x.svg", "--keep", "0,0,999mm,9mm"]);
    assert!(beyond.code == 1 && beyond.err.contains("reaches beyond the figure, which is "), "{}", beyond.err);
    let crop = place.run(&["convert", "cup.png", "-o", "x.svg", "--crop", "0,0,9mm,9mm"]);
    assert!(crop.code == 2 && crop.err.contains("give it in pixels or in percent"), "{}", crop.err);
}

#[test]
fn lines_of_another_shape_and_files_that_are_none_are_refused() {
    let place = with_page("swell-a4");
    place.put("tall.png", &png(40, 90, &[200; 40 * 90 * 3]));
    let run = place.run(&["convert", "tall.png", "--lines", "cup.svg", "-o", "x.svg"]);
    assert!(run.code == 1 && run.err.contains("times as wide as high"), "{}", run.err);
    place.put("no.svg", b"<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>");
    let run = place.run(&["convert", "cup.png", "--lines", "no.svg", "-o", "x.svg"]);
    assert!(run.code == 2 && run.err.contains("no.svg: this cannot be read as a page"), "{}", run.err);
    let run = place.run(&["convert", "cup.png", "tall.png", "--lines", "cup.svg"]);
    assert!(run.code == 2 && run.err.contains("--lines: this is of one picture"), "{}", run.err);
}
