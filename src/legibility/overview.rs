//! Whether the overview shows what the figure shows.

use super::finding::{Found, around};
use super::limits::Limits;
use super::rules::OVERVIEW;
use super::ways::{Ways, point_at};
use crate::geom::nearby::{Nearby, Segment};
use crate::page::Page;
use crate::units::{MmPoint, MmRect};

/// Lines are looked at this often, mm of the overview.
const STEP: f32 = 0.5;
/// A line whose larger part is missing in the other picture is missing there.
const MISSING: f32 = 0.5;

pub(super) fn findings(page: &Page, index: &Nearby, limits: &Limits) -> Vec<Found> {
    let Some(overview) = page.overview.as_ref().filter(|_| !page.figure.lines.is_empty()) else { return Vec::new() };
    let scale = page.figure.place.width() / overview.place.width().max(f32::MIN_POSITIVE);
    let reach = scale * limits.spacing();
    let ways = Ways::of(&overview.lines, f32::INFINITY);
    let lacking = |number: usize| {
        let segments =
            ways.ways.iter().filter(|way| way.line == number).flat_map(|way| &ways.segments[way.segments.clone()]);
        let mut lengths = (0.0, 0.0);
        let mut places = Vec::new();
        for segment in segments {
            let length = (segment.b - segment.a).length();
            let steps = (length / STEP).ceil().max(1.0);
            for k in 0..steps as u32 {
                let at = point_at(segment, segment.arc + (k as f32 + 0.5) / steps * length);
                let there = page.figure.place.min + (at - overview.place.min) * scale;
                let is_there = index.nearest(there, reach, |_: &Segment| true).is_some();
                lengths.1 += length / steps;
                if !is_there {
                    lengths.0 += length / steps;
                    places.push(at);
                }
            }
        }
        if lengths.0 > MISSING * lengths.1 { missing(number, &places, lengths.0) } else { None }
    };
    (0..overview.lines.len()).filter_map(lacking).collect()
}

fn missing(number: usize, places: &[MmPoint], length: f32) -> Option<Found> {
    let at = places.get(places.len() / 2).copied()?;
    let extent = around(places.iter().copied()).unwrap_or_else(MmRect::zero);
    let what = format!("the figure has nothing like line {} of the overview, {length:.0} mm of it", number + 1);
    Some(Found::at(OVERVIEW, at, extent, length, what))
}
