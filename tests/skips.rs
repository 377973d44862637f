//! What a page does not need is not done: the stages tell what ran and what was skipped.

use std::io::Cursor;

use crate::common::{page, samples};
use image::{DynamicImage, GrayImage, ImageFormat, Luma, Rgb, RgbImage};
use tactograph::internals::note::Note;
use tactograph::internals::page::Page;
use tactograph::internals::pipeline::{Drawing, Event, Stage};

/// Makes the page of a picture; gives it with the stages that ran and those that were skipped wholly or in part.
fn run(picture: &DynamicImage, settings: &[(&str, &str)]) -> (Drawing, Vec<Stage>, Vec<(Stage, &'static str)>) {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Bmp).expect("a picture can be written");
    let (mut ran, mut skipped) = (Vec::new(), Vec::new());
    let drawing = page::page_of(&bytes.into_inner(), "test", settings, &mut |event| match event {
        Event::End(stage) => ran.push(stage),
        Event::Skip(stage, why) => skipped.push((stage, why)),
        _ => (),
    });
    ran.sort(); // some run side by side, and either may end first
    ran.dedup(); // and some in parts
    (drawing, ran, skipped)
}

/// What every drawing skips.
const OF_DRAWING: (Stage, &str) = (Stage::Regions, "the picture is a drawing");

/// A red disc on blue.
fn disc() -> DynamicImage {
    RgbImage::from_fn(300, 200, |x, y| {
        let inside = (f64::from(x) - 150.0).hypot(f64::from(y) - 100.0) < 60.0;
        Rgb(if inside { [220, 30, 30] } else { [60, 90, 230] })
    })
    .into()
}

#[test]
fn a_whole_page_of_a_drawing_skips_nothing_but_regions() {
    let (drawing, ran, skipped) = run(&disc(), &[]);
    use Stage::{Classes, Decode, Edges, Lines, Overview, Page, Text, Textures};
    assert_eq!(ran, [Decode, Text, Edges, Lines, Overview, Classes, Textures, Page]);
    assert_eq!(skipped, [OF_DRAWING]);
    assert_eq!(drawing.notes, []);
    assert_eq!(drawing.page.figure.lines.len(), 1, "a disc has one contour");
    assert!(drawing.page.figure.lines[0].runs[0].closed);
}

#[test]
fn without_textures_colours_are_not_looked_at() {
    let (drawing, ran, skipped) = run(&disc(), &[("figure.textures", "false")]);
    assert!(!ran.contains(&Stage::Classes) && !ran.contains(&Stage::Textures));
    let off = [Stage::Classes, Stage::Textures].map(|stage| (stage, "figure.textures is off"));
    assert_eq!(skipped, [OF_DRAWING, off[0], off[1]]);
    assert!(drawing.page.figure.textures.is_empty());
}

/// Bars, dots, ticks and large outlines: what is looked for in pixels is letters that paths paint, and none of these can
/// be one.
#[test]
fn in_a_drawing_without_small_outlines_no_letters_are_looked_for() {
    let skipped_in = |more: &str| {
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'><rect width='900' height='600' fill='#fff'/>\
             <rect x='100' y='200' width='20' height='100' fill='#c22'/><circle cx='200' cy='250' r='9' fill='#22c'/>\
             <path d='M100 350V365M200 350V365M300 350V365' stroke='#000' stroke-width='3'/>\
             <circle cx='550' cy='300' r='200' fill='none' stroke='#000' stroke-width='4'/>{more}</svg>"
        );
        let mut skipped = Vec::new();
        page::page_of(svg.as_bytes(), "test", &[], &mut |event| {
            if let Event::Skip(Stage::Text, why) = event {
                skipped.push(why);
            }
        });
        skipped
    };
    assert_eq!(skipped_in(""), ["no paths are letters"]);
    let l = "<path d='M700 90h3v9h5v3h-8z'/>";
    assert_eq!(skipped_in(l), [""; 0], "the bar, the dot and a letter L");
}

#[test]
fn without_regions_none_are_looked_for_in_a_photograph() {
    let stages = |settings: &[(&str, &str)]| {
        let mut ran = Vec::new();
        let photograph = samples::read("chelsea.png");
        let drawing = page::page_of(&photograph, "test", settings, &mut |event| {
            if let Event::End(stage) = event {
                ran.push(stage);
            }
        });
        (ran.contains(&Stage::Regions), drawing.page)
    };
    let ((regions, with), (none, without)) = (stages(&[]), stages(&[("lines.regions", "false")]));
    assert!(regions && !none);
    let closed = |page: &Page| page.figure.lines.iter().flat_map(|line| &line.runs).filter(|run| run.closed).count();
    assert!(closed(&with) > closed(&without), "{} {}", closed(&with), closed(&without));
}

#[test]
fn without_overview_its_lines_are_not_drawn() {
    let (drawing, ran, skipped) = run(&disc(), &[("overview", "false")]);
    assert!(!ran.contains(&Stage::Overview));
    assert_eq!(skipped, [OF_DRAWING, (Stage::Overview, "overview.on is off")]);
    assert!(drawing.page.overview.is_none());
}

#[test]
fn with_textures_only_edges_are_not_looked_for() {
    let (drawing, ran, skipped) = run(&disc(), &[("figure.lines", "false"), ("overview", "false")]);
    assert_eq!(ran, [Stage::Decode, Stage::Text, Stage::Classes, Stage::Textures, Stage::Page]);
    let no_contours =
        [Stage::Edges, Stage::Regions].map(|stage| (stage, "neither the figure nor an overview has lines"));
    assert_eq!(skipped[..2], no_contours);
    assert!(drawing.page.figure.lines.is_empty() && drawing.page.figure.textures.len() == 2);
}

#[test]
fn a_grey_picture_has_no_hues_to_sort() {
    let grey = GrayImage::from_fn(300, 200, |x, _| Luma([if x < 150 { 60 } else { 200 }]));
    let (_, ran, skipped) = run(&grey.into(), &[]);
    assert!(ran.contains(&Stage::Classes));
    assert_eq!(skipped, [OF_DRAWING, (Stage::Hues, "the picture is grey")]);
}

#[test]
fn a_white_page_is_left_alone() {
    let (drawing, ran, skipped) = run(&GrayImage::from_pixel(300, 200, Luma([255])).into(), &[]);
    assert_eq!(ran, [Stage::Decode, Stage::Classes, Stage::Page]);
    for stage in [Stage::Text, Stage::Edges, Stage::Regions] {
        assert!(skipped.contains(&(stage, "the picture is of one colour")), "{stage:?}");
    }
    assert!(skipped.contains(&(Stage::Textures, "the picture is white")));
    assert_eq!(drawing.notes, [Note::EmptyPage]);
    assert!(drawing.page.is_empty());
}

#[test]
fn every_stage_runs_or_is_skipped_once_with_its_reason() {
    let off = |key: &'static str| (key, "false");
    let all: [(&str, &[(&str, &str)]); 6] = [
        ("coffee.png", &[]),
        ("coffee.png", &[off("lines.regions")]),
        ("coffee.png", &[off("figure.lines"), off("overview")]),
        ("coffee.png", &[off("figure.textures")]),
        ("empty.png", &[]),
        ("bars.svg", &[]),
    ];
    for (name, settings) in all {
        let (mut ran, mut skipped) = (Vec::new(), Vec::new());
        let picture = samples::read(name);
        page::page_of(&picture, "test", settings, &mut |event| match event {
            Event::End(stage) => ran.push(stage),
            Event::Skip(stage, why) => {
                assert!(!why.is_empty());
                skipped.push(stage);
            }
            _ => (),
        });
        for stage in Stage::ALL.iter().filter(|stage| **stage != Stage::Hues) {
            let times = skipped.iter().filter(|other| *other == stage).count() + usize::from(ran.contains(stage));
            assert_eq!(times, 1, "{name} {settings:?} {stage:?}: ran {ran:?}, skipped {skipped:?}");
        }
    }
}
