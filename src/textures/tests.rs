//! Glyphs keep inside their own region, and regions from one another, whatever the regions look like.

use super::{Params, Shape, fill};
use crate::classes::Classes;
use crate::lines::{Line, Run};
use crate::units::{MmPoint, MmRect};
use proptest::prelude::*;

const PARAMS: Params = Params::TEST;

const CELLS: u32 = 60;

/// Places on the outline of a glyph.
fn outline(shape: Shape, corners: [MmPoint; 4], at: MmPoint) -> Vec<MmPoint> {
    match shape {
        Shape::Dot { diameter } => (0..24)
            .map(|k| {
                let (sin, cos) = (k as f32 / 24.0 * std::f32::consts::TAU).sin_cos();
                MmPoint::new(at.x + 0.5 * diameter * cos, at.y + 0.5 * diameter * sin)
            })
            .collect(),
        Shape::Rhombus { .. } => {
            (0..24).map(|k| corners[k / 6].lerp(corners[(k / 6 + 1) % 4], (k % 6) as f32 / 6.0)).collect()
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn no_glyph_crosses_a_border(
        seats in prop::collection::vec((0.0_f32..60.0, 0.0_f32..60.0, 0_u8..6), 2..12),
        lightness in 0.1_f32..0.9,
        side in 40.0_f32..150.0,
        ends in (0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0),
    ) {
        let classes = Classes::of_seats(&seats, CELLS, lightness);
        let area = MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(20.0 + side, 30.0 + side));
        let place = |x: f32, y: f32| MmPoint::new(20.0 + x * side, 30.0 + y * side);
        let points = vec![place(ends.0, ends.1), place(ends.2, ends.3)];
        let line = Line { strength: 30.0, runs: vec![Run::stroke(1.0, points)] };
        let textures = fill(&classes, area, &[line], &PARAMS);
        let region_at = |at: MmPoint| {
            let cell = |value: f32| (value / side * CELLS as f32).floor() as usize;
            classes.region[cell(at.y - 30.0).min(59) * CELLS as usize + cell(at.x - 20.0).min(59)]
        };
        let Params { min_glyph, .. } = PARAMS;
        let mut all: Vec<(u32, MmPoint, Vec<MmPoint>)> = Vec::new();
        for texture in &textures {
            for glyph in &texture.glyphs {
                let region = region_at(glyph.at);
                let own = region.map(|number| classes.regions[number as usize].class);
                prop_assert_eq!(own, Some(texture.class));
                let outline = outline(glyph.shape, glyph.corners(), glyph.at);
                for at in &outline {
                    prop_assert!(area.contains_inclusive(*at), "{:?} leaves the picture", glyph);
                    prop_assert_eq!(region_at(*at), region, "{:?} crosses a border", glyph);
                }
                for (other, at, places) in &all {
                    if Some(*other) != region && (*at - glyph.at).length() < 4.0 {
                        let near = places.iter().flat_map(|p| outline.iter().map(move |q| (*p - *q).length()));
                        let least = near.fold(f32::MAX, f32::min);
                        prop_assert!(least >= min_glyph - 1e-3, "{:?} is {} mm from another region's", glyph, least);
                    }
                }
                all.push((region.unwrap_or(u32::MAX), glyph.at, outline));
            }
        }
    }
}
