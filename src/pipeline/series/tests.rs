//! Tests of `series`.

use super::*;
use crate::page::{Glyph, Shape};
use crate::pipeline::request::{Fit, OverviewSize};
use crate::profile::Profile;
use crate::raster::plane::Plane;
use crate::textures::Sign;
use crate::units::Size;

const FIGURE: MmRect = MmRect { min: MmPoint::new(0.0, 0.0), max: MmPoint::new(80.0, 40.0) };

/// A bar from one place to another along the base of the figure, and so high.
fn bar(from: f32, to: f32, height: f32, class: Class) -> ColouredBar {
    ColouredBar { place: MmRect::new(MmPoint::new(from, 40.0 - height), MmPoint::new(to, 40.0)), class }
}

/// Cells of a square mm with these bars as areas.
fn classes(bars: &[ColouredBar]) -> Classes {
    let size = Size::new(80, 40);
    let mut all = Classes {
        size,
        region: vec![None; size.len()],
        regions: Vec::new(),
        lightness: Plane::filled(size, 0.5),
        fringe: Vec::new(),
    };
    for (number, bar) in (0..).zip(bars) {
        let cells: Vec<usize> = cells_in(bar.place, &all, FIGURE).collect();
        all.regions.push(Region { class: bar.class, colour: [0; 3], cells: cells.len() as u32 });
        cells.into_iter().for_each(|cell| all.region[cell] = Some(number));
    }
    all
}

/// The texture of a bar: one sign in its middle.
fn texture(bar: &ColouredBar) -> Texture {
    let glyphs = vec![Glyph { at: bar.place.center(), shape: Shape::Dot { diameter: 1.0 } }];
    Texture { class: bar.class, sign: Sign::Dot, colour: [0; 3], area: bar.place.area(), glyphs }
}

fn entry(text: &str, class: Class) -> LegendEntry {
    LegendEntry { text: text.to_owned(), class, place: None, has_blank: false }
}

/// Which bars have a texture afterwards if these had one, which entries of the legend have blank ones, what is told.
fn alike(bars: &[ColouredBar], had: &[usize]) -> (Vec<usize>, Vec<bool>, String) {
    let mut textures: Vec<Texture> = had.iter().map(|&bar| texture(&bars[bar])).collect();
    let mut legend = vec![entry("Girls", Class::Red), entry("Boys", Class::Yellow)];
    let told = made_alike(bars, &mut classes(bars), &mut textures, &mut legend, FIGURE);
    let has = |bar: &ColouredBar| {
        let own = textures.iter().filter(|texture| texture.class == bar.class);
        own.flat_map(|texture| &texture.glyphs).any(|glyph| bar.place.contains(glyph.at))
    };
    let with: Vec<usize> = (0..bars.len()).filter(|&number| has(&bars[number])).collect();
    let blank = legend.iter().map(|entry| entry.has_blank).collect();
    (with, blank, told.map(|note| note.to_string()).unwrap_or_default())
}

fn girls_and_boys() -> [ColouredBar; 6] {
    let pair = |x: f32, girls: f32, boys: f32| {
        [bar(x, x + 10.0, girls, Class::Red), bar(x + 10.0, x + 20.0, boys, Class::Yellow)]
    };
    let [[a, b], [c, d], [e, f]] = [pair(2.0, 30.0, 25.0), pair(27.0, 20.0, 5.0), pair(52.0, 35.0, 4.0)];
    [a, b, c, d, e, f]
}

#[test]
fn a_series_whose_low_bars_have_no_texture_has_none() {
    let bars = girls_and_boys();
    let (with, blank, told) = alike(&bars, &[0, 1, 2, 4]);
    assert_eq!((with, blank), (vec![0, 2, 4], vec![false, true]));
    assert!(told.contains("all 3 yellow bars (2 for want of room, and the others so that all are alike)"), "{told}");
    assert!(told.contains("say in labels which these are") && !told.contains("key"), "{told}");
}

#[test]
fn a_series_without_texture_is_named_by_its_colour_where_there_is_no_legend() {
    let bars = girls_and_boys();
    let legend_of = |had: &[usize]| {
        let mut textures: Vec<Texture> = had.iter().map(|&bar| texture(&bars[bar])).collect();
        let mut legend = Vec::new();
        let told = made_alike(&bars, &mut classes(&bars), &mut textures, &mut legend, FIGURE);
        (legend, told.map(|note| note.to_string()).unwrap_or_default())
    };
    let (legend, told) = legend_of(&[0, 1, 2, 4]);
    assert_eq!(legend, [LegendEntry::of_blank(Class::Yellow)]);
    assert!(!told.contains("key"), "whether there is one is not known here: {told}");
    // of several that lack fewer than half of their bars none becomes blank, and a key has nothing to say of them
    assert_eq!(legend_of(&[0, 1, 3, 4]).0, []);
    assert_eq!(legend_of(&[0, 1, 2, 3, 4, 5]), (Vec::new(), String::new()), "all have theirs");
}

#[test]
fn series_that_are_whole_and_several_that_lack_bars_stay_as_they_are() {
    let bars = girls_and_boys();
    assert_eq!(alike(&bars, &[0, 1, 2, 3, 4, 5]), (vec![0, 1, 2, 3, 4, 5], vec![false; 2], String::new()));
    // blank, nobody could tell them apart
    let (with, blank, told) = alike(&bars, &[0, 1, 3, 4]);
    assert_eq!((with, blank), (vec![0, 1, 3, 4], vec![true; 2]));
    assert!(told.contains("1 of 3 yellow bars and 1 of 3 red bars"), "{told}");
    // but of a series that has hardly any texture, none is left
    assert_eq!(alike(&bars, &[0, 1, 4]).0, [0, 4]);
}

#[test]
fn a_series_by_itself_has_no_texture_where_most_of_its_bars_have_none() {
    let of_one = girls_and_boys().map(|bar| ColouredBar { class: Class::Red, ..bar });
    // low bars without one are no others
    assert_eq!(alike(&of_one, &[0, 1, 2, 4]).0, [0, 1, 2, 4]);
    // the one that has one would be
    let (with, _, told) = alike(&of_one, &[0, 1]);
    assert!(with.is_empty(), "{with:?}");
    assert!(told.contains("all 6 red bars (4 for want of room"), "{told}");
    let mut legend = Vec::new();
    let mut textures = vec![texture(&of_one[0])];
    made_alike(&of_one, &mut classes(&of_one), &mut textures, &mut legend, FIGURE);
    assert_eq!(legend, [], "its colour says nothing, so that a key need not name it");
}

#[test]
fn a_bar_of_a_blank_series_under_a_legend_has_no_texture_either() {
    let bars = girls_and_boys();
    let beside = bar(76.0, 80.0, 10.0, Class::Yellow);
    let all: Vec<ColouredBar> = bars.iter().copied().chain([beside]).collect();
    let left = |found: &[ColouredBar]| {
        let (mut all_classes, mut legend) = (classes(&all), Vec::new());
        let mut textures: Vec<Texture> = [0, 1, 2, 4, 5, 6].iter().map(|&bar| texture(&all[bar])).collect();
        made_alike(found, &mut all_classes, &mut textures, &mut legend, FIGURE);
        let cell = |of: &ColouredBar| cells_in(of.place, &all_classes, FIGURE).next();
        let has_colour = |of: &ColouredBar| cell(of).is_some_and(|cell| all_classes.region[cell].is_some());
        let with: Vec<usize> = (0..all.len()).filter(|&bar| has_colour(&all[bar])).collect();
        let lies_in = |texture: &Texture| all.iter().position(|bar| bar.place.contains(texture.glyphs[0].at));
        (textures.iter().filter_map(lies_in).collect::<Vec<_>>(), with)
    };
    // what lies farther off is no bar
    assert_eq!(left(&bars[..5]), (vec![0, 2, 4, 6], vec![0, 2, 4, 6]), "nothing of the last bar is found");
    let part = ColouredBar { place: MmRect::new(MmPoint::new(62.0, 36.0), MmPoint::new(65.0, 40.0)), ..bars[5] };
    let in_part: Vec<ColouredBar> = bars[..5].iter().copied().chain([part]).collect();
    assert_eq!(left(&in_part), (vec![0, 2, 4, 6], vec![0, 2, 4, 6]), "a part of it is");
}

#[test]
fn low_bars_have_the_colour_that_they_lack_in_areas_of_high_ones() {
    let bars = girls_and_boys();
    let fine = classes(&bars);
    let mut coarse = classes(&bars[..3]);
    colour(&mut coarse, &fine, &bars, FIGURE);
    assert_eq!(coarse.regions.len(), 6);
    assert_eq!(coarse.regions.iter().map(|region| region.cells).sum::<u32>(), 1190);
    assert!((0..coarse.region.len()).all(|cell| class_of(&coarse, cell) == class_of(&fine, cell)));
}

#[test]
fn a_low_bar_has_a_texture_only_if_a_larger_area_has_it_too() {
    let bars = [
        bar(0.0, 10.0, 30.0, Class::Blue),
        bar(20.0, 30.0, 8.0, Class::Blue),
        bar(40.0, 50.0, 8.0, Class::Red),
        bar(60.0, 70.0, 20.0, Class::Grey),
    ];
    let mut textures: Vec<Texture> = bars.iter().map(texture).collect();
    assert_eq!(take_unlearned(&mut textures, 170.0, |class| class != Class::Green).len(), 1);
    assert_eq!(textures.iter().map(|of| of.class).collect::<Vec<_>>(), [Class::Blue, Class::Blue, Class::Grey]);
}

#[test]
fn a_colour_of_which_too_little_is_left_has_no_texture_and_is_told() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.colours.min_area = 600.0;
    let plan = Plan::new(&profile).expect("it is right");
    let layout = Fit::default().layout(Size::new(80, 40), &plan, OverviewSize::Own).expect("there is room");
    let cell = layout.figure.area() / 3200.0;
    // areas of a photograph, no bars
    let told = |height: f32| {
        let parts = [bar(0.0, 60.0, 40.0, Class::Red), bar(62.0, 69.0, height, Class::Yellow)];
        let areas = Some((classes(&parts), Vec::new()));
        let photograph = TexturedPicture { is_drawing: false, has_labels: false };
        let (textures, notes) = textured(areas, (&mut Vec::new(), photograph), &layout, &[], &plan, &mut |_| ());
        let has_texture = textures.iter().any(|of| of.class == Class::Yellow);
        (7.0 * height * cell, has_texture, notes.iter().map(ToString::to_string).collect::<String>())
    };
    let (area, has_texture, notes) = told(39.0);
    assert!(area > 601.0 && has_texture && notes.is_empty(), "{area}, {has_texture}: {notes}");
    let (area, has_texture, notes) = told(9.0);
    let is_told = notes.contains("learn a texture: yellow");
    assert!(area < 599.0 && !has_texture && is_told, "{area}, {has_texture}: {notes}");
}
