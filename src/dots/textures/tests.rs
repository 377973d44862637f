//! Dots lie on the grid, in their own region and clear of lines, whatever the regions look like; there are fewer
//! where the colour is light or lines are far; mirrored pictures give mirrored dots.

use std::collections::{BTreeMap, BTreeSet};

use super::{Least, Params, fill, sample};
use crate::classes::{Class, Classes, Region};
use crate::devices::{DotArea, Grid};
use crate::lines::{Height, Line, Run};
use crate::raster::plane::Plane;
use crate::textures::{Palette, Shape, Texture};
use crate::units::{MmPoint, MmRect, Size};
use proptest::prelude::*;

/// Odd, so that no dot lies on the border between two cells, which belongs to one side.
const CELLS: u32 = 61;
/// Side of a cell, mm.
const CELL: f32 = 120.0 / 61.0;
/// The picture: 120 mm wide and high, its middle on a dot of every grid below.
const AREA: MmRect = MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(140.0, 150.0));

fn params(pitch: f32) -> Params {
    Params {
        pitch,
        diameter: 0.7 * pitch,
        line_gap: 1,
        least_gap: 1,
        least: Least::of_rows(2),
        density_blur: 8.0,
        dense_from: 0.5,
        white_from: 0.92,
        palette: Palette::PAPER,
    }
}

/// A grid with a dot in the middle of the picture and as many to all sides.
fn grid(pitch: f32) -> Grid {
    let places = |middle: f32| {
        let reach = (70.0 / pitch) as i32;
        (-reach..=reach).map(|i| middle + i as f32 * pitch).collect()
    };
    Grid { columns: places(80.0), rows: places(90.0) }
}

fn free() -> DotArea {
    DotArea::Free(MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0)))
}

fn line(points: Vec<MmPoint>) -> Line {
    Line { strength: 30.0, runs: vec![Run::dots(1.5, points, Height::High)] }
}

/// All dots with their class, to the hundredth of a millimetre.
fn dots(textures: &[Texture]) -> BTreeSet<(i32, i32, Class)> {
    let key = |mm: f32| (100.0 * mm).round() as i32;
    let of = |texture: &Texture| {
        let class = texture.class;
        texture.glyphs.iter().map(move |glyph| (key(glyph.at.x), key(glyph.at.y), class)).collect::<Vec<_>>()
    };
    textures.iter().flat_map(of).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn dots_keep_to_the_grid_their_region_and_from_lines(
        seats in prop::collection::vec((0.0_f32..60.0, 0.0_f32..60.0, 0_u8..6), 2..12),
        lightness in 0.1_f32..1.0,
        pitch in prop::sample::select(vec![1.27_f32, 1.6, 2.0, 2.5]),
        gap in 0_u32..3,
        ray in (-20_i32..20, -20_i32..20, -1_i32..2, -1_i32..2),
    ) {
        let classes = Classes::of_seats(&seats, CELLS, lightness);
        let place = |k: i32| {
            let (x, y) = (ray.0 + k * ray.2, ray.1 + k * ray.3);
            MmPoint::new(80.0 + x as f32 * pitch, 90.0 + y as f32 * pitch)
        };
        let lines = [line((0..20).map(place).collect())];
        let params = Params { line_gap: gap, least_gap: gap, ..params(pitch) };
        let textures = fill(&classes, AREA, &lines, &DotArea::Grid(grid(pitch)), &params);
        prop_assert_eq!(&textures, &fill(&classes, AREA, &lines, &DotArea::Grid(grid(pitch)), &params));
        prop_assert!(lightness < 0.92 || textures.is_empty(), "there is a texture on white");
        let step = |from: f32, to: f32| ((to - from) / pitch).round() as i32;
        let mut all: BTreeMap<(i32, i32), Class> = BTreeMap::new();
        for texture in &textures {
            prop_assert!(texture.glyphs.len() >= 6, "{} dots are no texture", texture.glyphs.len());
            for glyph in &texture.glyphs {
                prop_assert_eq!(glyph.shape, Shape::Dot { diameter: params.diameter });
                let (x, y) = (step(80.0, glyph.at.x), step(90.0, glyph.at.y));
                let on_grid = MmPoint::new(80.0 + x as f32 * pitch, 90.0 + y as f32 * pitch);
                prop_assert!((glyph.at - on_grid).length() < 1e-3, "{:?} is off the grid", glyph.at);
                let inner = AREA.inflate(-glyph.radius(), -glyph.radius());
                prop_assert!(inner.contains_inclusive(glyph.at), "{:?} leaves the picture", glyph.at);
                let (column, row) = ((glyph.at.x - 20.0) / CELL, (glyph.at.y - 30.0) / CELL);
                let region = classes.region[row as usize * CELLS as usize + column as usize];
                let class = region.map(|region| classes.regions[region as usize].class);
                prop_assert_eq!(class, Some(texture.class), "{:?} is off its region", glyph.at);
                for k in 0..20 {
                    let (i, j) = (ray.0 + k * ray.2, ray.1 + k * ray.3);
                    let steps = (i - x).abs().max((j - y).abs());
                    prop_assert!(steps > gap as i32, "{:?} is too near to a line", glyph.at);
                }
                for near in (-1..=1).flat_map(|j| (-1..=1).map(move |i| (x + i, y + j))) {
                    let other = all.get(&near).is_some_and(|class| *class != texture.class);
                    prop_assert!(!other, "two textures meet at {:?}", glyph.at);
                }
                all.insert((x, y), texture.class);
            }
        }
    }

    #[test]
    fn free_dots_keep_their_distances(
        seats in prop::collection::vec((0.0_f32..60.0, 0.0_f32..60.0, 0_u8..6), 2..12),
        lightness in 0.1_f32..1.0,
        pitch in 2.0_f32..3.0,
        from in (20.0_f32..140.0, 30.0_f32..150.0),
    ) {
        let classes = Classes::of_seats(&seats, CELLS, lightness);
        let from = MmPoint::new(from.0, from.1);
        let lines = [line((0..20).map(|k| from.lerp(AREA.center(), k as f32 / 20.0)).collect())];
        let params = params(pitch);
        let textures = fill(&classes, AREA, &lines, &free(), &params);
        prop_assert!(lightness < 0.92 || textures.is_empty(), "there is a texture on white");
        let mut all: Vec<(MmPoint, Class)> = Vec::new();
        for texture in &textures {
            for glyph in &texture.glyphs {
                for at in &lines[0].runs[0].points {
                    let far = (glyph.at - *at).length();
                    prop_assert!(far >= 2.0 * pitch - 1e-3, "{:?} is too near to a line", glyph.at);
                }
                for (at, class) in &all {
                    let least = if *class == texture.class { pitch } else { 1.5 * pitch };
                    prop_assert!((glyph.at - *at).length() >= least - 1e-3, "two dots meet at {:?}", glyph.at);
                }
                all.push((glyph.at, texture.class));
            }
        }
    }

    #[test]
    fn a_mirrored_picture_gives_mirrored_dots(
        seats in prop::collection::vec((0.0_f32..60.0, 0.0_f32..60.0, 0_u8..6), 2..12),
        lightness in 0.1_f32..0.9,
        pitch in prop::sample::select(vec![1.27_f32, 1.6, 2.0, 2.5]),
        up_down in any::<bool>(),
    ) {
        let classes = Classes::of_seats(&seats, CELLS, lightness);
        let other = |i: u32| {
            let (x, y) = (i % CELLS, i / CELLS);
            if up_down { (CELLS - 1 - y) * CELLS + x } else { y * CELLS + CELLS - 1 - x }
        };
        let region = (0..CELLS * CELLS).map(|i| classes.region[other(i) as usize]).collect();
        let mirrored = Classes { region, ..classes.clone() };
        let palette = Palette { signs: Palette::PAPER.signs.map(crate::textures::Sign::mirrored) };
        let area = DotArea::Grid(grid(pitch));
        // Without lines textures are sparse. Dense diagonal rows from 2.2 mm on are two dots thick, the second on one
        // side of the first; on a picture that stands on its head it lies on the other.
        let here = fill(&classes, AREA, &[], &area, &params(pitch));
        let there = fill(&mirrored, AREA, &[], &area, &Params { palette, ..params(pitch) });
        type Dot = (i32, i32, Class);
        let back = |(x, y, class): Dot| if up_down { (x, 18_000 - y, class) } else { (16_000 - x, y, class) };
        let apart = |a: Dot, b: Dot| (a.0 - b.0).abs() + (a.1 - b.1).abs();
        let here: Vec<Dot> = dots(&here).into_iter().collect();
        let there: Vec<Dot> = dots(&there).into_iter().map(back).collect();
        prop_assert_eq!(here.len(), there.len());
        for dot in here {
            let is_mirrored = |other: &Dot| other.2 == dot.2 && apart(dot, *other) <= 2;
            prop_assert!(there.iter().any(is_mirrored), "{:?} has no mirrored one", dot);
        }
    }
}

#[test]
fn darker_and_nearer_to_lines_is_the_same_dots_and_more() {
    for (area, pitch) in [1.27, 1.6, 2.0, 2.5].map(|p| (DotArea::Grid(grid(p)), p)).into_iter().chain([(free(), 2.5)]) {
        for class in Class::ALL {
            let of = |lightness, density| dots(&[sample(class, lightness, density, AREA, &area, &params(pitch))]);
            let (far, near) = (of(0.85, 0.0), of(0.2, 1.0));
            assert!(far.is_subset(&near), "{class:?} at {pitch}: a dot goes where there should be more");
            let ratio = near.len() as f32 / far.len() as f32;
            assert!((1.3..2.2).contains(&ratio), "{class:?} at {pitch}: {ratio} times as many dots");
            for values in [[(0.9, 0.3), (0.6, 0.3), (0.3, 0.3)], [(0.5, 0.0), (0.5, 0.3), (0.5, 0.9)]] {
                let sets = values.map(|(lightness, density)| of(lightness, density));
                assert!(sets[0].is_subset(&sets[1]) && sets[1].is_subset(&sets[2]), "{class:?} at {pitch}: {values:?}");
            }
            assert!(of(0.92, 1.0).is_empty(), "{class:?} has a texture on white");
        }
    }
}

#[test]
fn a_grid_of_one_column_or_row_has_no_texture() {
    let places = |count: usize| (0..count).map(|i| 25.0 + i as f32 * 2.5).collect::<Vec<f32>>();
    let classes = Classes::of_seats(&[(15.0, 30.0, 0), (30.0, 15.0, 1), (45.0, 30.0, 4)], CELLS, 0.1);
    for (columns, rows) in [(0, 0), (1, 1), (1, 40), (40, 1)] {
        let area = DotArea::Grid(Grid { columns: places(columns), rows: places(rows) });
        let lines = [line(vec![MmPoint::new(60.0, 60.0)])];
        assert_eq!(fill(&classes, AREA, &lines, &area, &params(2.5)), [], "{columns} x {rows}");
        let of = |class| sample(class, 0.1, 1.0, AREA, &area, &params(2.5)).glyphs;
        assert!(Class::ALL.into_iter().all(|class| of(class).is_empty()), "{columns} x {rows}");
    }
}

/// The dots of a dark blue area of a few millimetres in white, where a texture has so many rows at least.
fn band(width: f32, height: f32, rows: usize) -> usize {
    let size = Size::new(240, 240);
    let inside = |i: u32| (i % 240) as f32 * 0.5 < width && (i / 240) as f32 * 0.5 < height;
    let region: Vec<Option<u32>> = (0..240 * 240).map(|i| inside(i).then_some(0)).collect();
    let cells = region.iter().flatten().count() as u32;
    let regions = vec![Region { class: Class::Blue, colour: [0; 3], cells }];
    let classes = Classes { size, region, regions, lightness: Plane::filled(size, 0.1), fringe: Vec::new() };
    let params = Params { least: Least::of_rows(rows), ..params(2.5) };
    let textures = fill(&classes, AREA, &[line(vec![MmPoint::new(16.0, 36.0)])], &DotArea::Grid(grid(2.5)), &params);
    textures.iter().map(|texture| texture.glyphs.len()).sum()
}

#[test]
fn one_row_and_a_few_dots_are_no_texture() {
    assert_eq!(band(100.0, 4.0, 2), 0, "one row of dots is felt as a line");
    assert_eq!(band(6.0, 12.0, 2), 0, "two dots a row");
    // far from lines rows are 10 mm apart
    assert!(band(100.0, 22.0, 2) > 60, "two rows are a texture where two are enough");
    assert_eq!(band(100.0, 22.0, 3), 0, "two rows, where three are wanted");
    assert!(band(100.0, 32.0, 3) > 100, "three rows");
    assert!(band(8.0, 50.0, 2) >= 9, "rows of three dots");
    assert_eq!(band(8.0, 50.0, 3), 0, "rows of three dots, where four are wanted");
}

#[test]
fn regions_of_a_class_share_their_rows() {
    let two = Classes::of_seats(&[(15.0, 30.0, 1), (30.0, 30.0, 5), (45.0, 30.0, 1)], CELLS, 0.3);
    let one = Classes::of_seats(&[(30.0, 30.0, 1), (99.0, 99.0, 5)], CELLS, 0.3);
    let area = DotArea::Grid(grid(1.6));
    let [two, one] = [two, one].map(|classes| dots(&fill(&classes, AREA, &[], &area, &params(1.6))));
    assert!(two.len() > 200 && two.is_subset(&one));
}
