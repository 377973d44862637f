//! Which areas have a texture, and what is told of the others.

use super::*;
use crate::classes::Region;
use crate::lines::Run;
use crate::page::{Glyph, Shape};
use crate::pipeline::request::{Fit, OverviewSize};
use crate::profile::Profile;
use crate::raster::plane::Plane;

/// Twelve by six cells, one letter each: the class by its first letter, a dot for white. Areas are those of a
/// letter, capital or small.
fn classes(rows: [&str; 6]) -> Classes {
    let letters: Vec<char> = rows.iter().flat_map(|row| row.chars()).collect();
    let mut kinds: Vec<char> = letters.iter().copied().filter(|letter| *letter != '.').collect();
    kinds.sort_unstable();
    kinds.dedup();
    let class = |kind: char| {
        Class::ALL.into_iter().find(|class| class.name().starts_with(kind.to_ascii_lowercase())).expect("a class")
    };
    let count = |kind: char| letters.iter().filter(|letter| **letter == kind).count() as u32;
    let number = |letter: &char| kinds.iter().position(|kind| kind == letter).map(|number| number as u32);
    Classes {
        size: Size::new(12, 6),
        region: letters.iter().map(number).collect(),
        regions: kinds.iter().map(|&k| Region { class: class(k), colour: [0; 3], cells: count(k) }).collect(),
        lightness: Plane::filled(Size::new(12, 6), 0.3),
        fringe: Vec::new(),
    }
}

fn plan(profile: &str) -> Plan {
    Plan::new(&Profile::named(profile).expect("it is built in")).expect("built-in profiles make sense")
}

/// How many cells of each letter are left, and the note.
fn blanked(rows: [&str; 6], profile: &str) -> (Vec<u32>, Option<String>) {
    let mut classes = classes(rows);
    let note = blank_ground(&mut classes, &plan(profile));
    let left = classes.regions.iter().map(|region| region.cells).collect();
    let counted = |number: usize| classes.region.iter().flatten().filter(|r| **r as usize == number).count() as u32;
    assert_eq!(left, (0..classes.regions.len()).map(counted).collect::<Vec<_>>(), "cells are counted anew");
    (left, note.map(|note| note.to_string()))
}

#[test]
fn the_ground_is_blank_on_pins_and_is_told() {
    // a table on both sides of a bowl with a ball of its colour in it
    let rows = ["YYYYggggYYYY", "YYYggggggYYY", "YYgggyyggYYY", "YYgggyyggYYY", "YYYggggggYYY", "YYYYggggYYYY"];
    let (left, note) = blanked(rows, "dot-pad");
    assert_eq!(left, [0, 30, 4], "the table, the bowl and the ball");
    let wanted = "left out: the texture of the ground (yellow, 52 percent of the figure), so that \
                      lines stand out; turn figure.ground on to draw it";
    assert_eq!(note.as_deref(), Some(wanted));
    assert_eq!(blanked(rows, "swell-a4"), (vec![38, 30, 4], None), "paper has room for it");
}

#[test]
fn an_area_that_is_mostly_white_is_not_said_to_have_textures_of_several_colours() {
    // a swan on the left, with a beak, and a flag on the right
    let classes =
        classes(["......rrrr..", "....yyrrrr..", "......bbbb..", "......bbbb..", "............", "............"]);
    let area: Vec<usize> = (0..72).map(|cell| if cell % 12 < 6 { 1 } else { 2 }).collect();
    let cells = with_cells(vec![1, 2], &area);
    assert!(is_mostly_white(&classes, &cells[&1]), "34 of 36 cells");
    assert!(!is_mostly_white(&classes, &cells[&2]), "20 of 36 cells");
}

#[test]
fn only_an_outlined_area_with_two_textures_on_the_page_is_told() {
    let (plan, size) = (plan("swell-a4"), Size::new(120, 60));
    let layout = Fit::default().layout(size, &plan, OverviewSize::Own).expect("there is room");
    let place = layout.figure;
    let at = |x: f32, y: f32| place.min + MmVector::new(x / 12.0, y / 6.0).component_mul(place.size().to_vector());
    // the left half of the figure, and two colours one above the other in it
    let area: Vec<usize> = (0..72).map(|cell| usize::from(cell % 12 < 6)).collect();
    let mixed = with_cells(vec![1], &area);
    let areas = MixedAreas { area, size: Size::new(12, 6), mixed };
    let texture = |class: Class, signs: usize, y: f32| Texture {
        class,
        sign: plan.textures().palette.sign(class),
        colour: [0; 3],
        area: 400.0,
        glyphs: (0..signs)
            .map(|sign| Glyph { at: at(0.5 + 0.5 * sign as f32, y), shape: Shape::Dot { diameter: 1.0 } })
            .collect(),
    };
    let across = |y: [f32; 2]| Line { strength: 60.0, runs: vec![Run::stroke(1.5, y.map(|y| at(5.5, y)).to_vec())] };
    let told = |of_red: usize, of_blue: usize, line: Line| {
        let textures = [texture(Class::Red, of_red, 1.5), texture(Class::Blue, of_blue, 4.5)];
        areas.told(&textures, &[line], &layout, &plan).map(|note| note.to_string())
    };
    let both = told(8, 8, across([0.0, 6.0])).expect("two textures beside a line");
    assert!(both.starts_with("1 outlined area, in the middle left of the figure, has textures of several"), "{both}");
    assert_eq!(told(8, 5, across([0.0, 6.0])), None, "a few signs are no texture");
    assert_eq!(told(8, 0, across([0.0, 6.0])), None, "white is none");
    assert_eq!(told(8, 8, across([0.0, 1.0])), None, "most of the outline is not drawn");
}

#[test]
fn a_part_between_lines_without_a_sign_is_bare_though_its_region_has_some() {
    // a bar of one region, which a line divides, 10 mm a cell
    let classes =
        classes(["............", ".bbbbbbbbbb.", ".bbbbbbbbbb.", ".bbbbbbbbbb.", ".bbbbbbbbbb.", "............"]);
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 60.0));
    let line =
        Line { strength: 60.0, runs: vec![Run::stroke(1.5, vec![MmPoint::new(60.0, 0.0), MmPoint::new(60.0, 60.0)])] };
    let sign = |x: f32| Glyph { at: MmPoint::new(x, 30.0), shape: Shape::Dot { diameter: 1.0 } };
    let bare = |signs: &[f32]| {
        let params = plan("swell-a4").textures();
        let texture = Texture {
            class: Class::Blue,
            sign: params.palette.sign(Class::Blue),
            colour: [0; 3],
            area: 4000.0,
            glyphs: signs.iter().map(|x| sign(*x)).collect(),
        };
        bare_areas(&classes, &[texture], std::slice::from_ref(&line), place)
    };
    assert_eq!(bare(&[30.0, 90.0]), [0_usize; 0]);
    let [cell] = bare(&[30.0])[..] else { panic!("one is bare") };
    assert!(cell % 12 >= 6, "the right part: {cell}");
    assert_eq!(bare(&[]).len(), 1, "a region without any sign is told once");
}

#[test]
fn what_holds_less_than_a_third_of_the_edge_is_no_ground() {
    let bars = ["............", ".rr.bb.gg...", ".rr.bb.gg...", ".rr.bb.gg...", ".rr.bb.gg...", ".rr.bb.gg..."];
    assert_eq!(blanked(bars, "dot-pad"), (vec![10, 10, 10], None));
    let white = ["............"; 6];
    assert_eq!(blanked(white, "dot-pad"), (vec![], None));
}

#[test]
fn a_photograph_on_dots_is_told_once_of_areas_without_a_texture() {
    let (plan, size) = (plan("index-basic-d"), Size::new(120, 60));
    let layout = Fit::default().layout(size, &plan, OverviewSize::Own).expect("there is room");
    let classes =
        classes(["............", ".bbbb..yyyy.", ".bbbb..yyyy.", ".bbbb..yyyy.", ".bbbb..yyyy.", "............"]);
    let told = |unlearned: &[Class]| {
        let unlearned: BTreeSet<Class> = unlearned.iter().copied().collect();
        told_bare(&classes, &[], &[], &layout, (false, &unlearned), &plan).expect("half of it is bare").to_string()
    };
    assert!(!told(&[]).contains("learn"));
    let both = told(&[Class::Blue]);
    assert!(
        both.contains("no room for")
            && both.ends_with("learn a texture: blue; make the figure larger, or crop the picture"),
        "{both}"
    );
}
