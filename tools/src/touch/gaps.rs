//! Does every glyph keep its distance: from lines, from the picture's edge, from other glyphs?

use tactograph::Page;
use tactograph::internals::geom::{nearest_on_segment, segment_distance};
use tactograph::internals::page::{Glyph, Shape};
use tactograph::internals::textures::Params;
use tactograph::internals::units::MmPoint;

/// Numbers of the page are a little off in f32, mm.
const ROUNDING: f32 = 1e-3;

fn sides(glyph: &Glyph) -> [(MmPoint, MmPoint); 4] {
    let c = glyph.corners();
    [(c[0], c[1]), (c[1], c[2]), (c[2], c[3]), (c[3], c[0])]
}

/// Blank between a glyph and a segment, mm.
fn to_segment(glyph: &Glyph, segment: (MmPoint, MmPoint)) -> f32 {
    match glyph.shape {
        Shape::Dot { diameter } => nearest_on_segment(glyph.at, segment.0, segment.1).0 - 0.5 * diameter,
        Shape::Rhombus { .. } => {
            sides(glyph).into_iter().map(|side| segment_distance(side, segment)).fold(f32::MAX, f32::min)
        }
    }
}

/// Blank between two glyphs, mm.
fn between(one: &Glyph, other: &Glyph) -> f32 {
    match (one.shape, other.shape) {
        (Shape::Dot { diameter }, _) => match other.shape {
            Shape::Dot { diameter: second } => (one.at - other.at).length() - 0.5 * (diameter + second),
            Shape::Rhombus { .. } => to_segment(other, (one.at, one.at)) - 0.5 * diameter,
        },
        (_, Shape::Dot { .. }) => between(other, one),
        _ => sides(other).into_iter().map(|side| to_segment(one, side)).fold(f32::MAX, f32::min),
    }
}

/// Everything on a page that is nearer than it may be, and every glyph that is too small.
pub fn faults(page: &Page, params: &Params) -> Vec<String> {
    let glyphs: Vec<&Glyph> = page.figure.textures.iter().flat_map(|texture| &texture.glyphs).collect();
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    let segments: Vec<(MmPoint, MmPoint, f32)> =
        runs.flat_map(|run| run.polyline().segments().map(|(a, b)| (*a, *b, 0.5 * run.width))).collect();
    let mut faults = Vec::new();
    for (number, glyph) in glyphs.iter().enumerate() {
        let radius = glyph.radius();
        let mut fault = |what: String| faults.push(format!("{what} at {:.2}, {:.2}", glyph.at.x, glyph.at.y));
        for &(a, b, half_width) in &segments {
            let reach = params.line_gap + half_width;
            if nearest_on_segment(glyph.at, a, b).0 < reach + radius && to_segment(glyph, (a, b)) < reach - ROUNDING {
                fault("too near to a line".into());
            }
        }
        if !glyph.corners().iter().all(|corner| page.figure.place.contains_inclusive(*corner)) {
            fault("out of the picture".into());
        }
        let smallest = match glyph.shape {
            Shape::Rhombus { length, thickness, .. } => length.min(thickness),
            Shape::Dot { diameter } => diameter,
        };
        if smallest < params.min_glyph - ROUNDING {
            fault(format!("a glyph of {smallest} mm"));
        }
        for other in &glyphs[..number] {
            let reach = radius + other.radius() + params.min_glyph;
            if (other.at - glyph.at).square_length() < reach * reach {
                let blank = between(glyph, other);
                if blank < params.min_glyph - ROUNDING {
                    fault(format!("two glyphs with {blank} mm between them"));
                }
            }
        }
    }
    faults
}
