//! Lines that lead from labels: whether a finger that follows one finds anything at its end.

use std::f32::consts::TAU;

use super::finding::{FoundBreach, around};
use super::limits::LEADER_END;
use super::rules::LABEL_LINE;
use crate::geom::crossing;
use crate::geom::nearby::Nearby;
use crate::geom::polygon::distance_to_box;
use crate::page::{BrailleText, Page, Run, text_name};
use crate::units::{MmPoint, MmVector};

/// Directions in which it is looked for the sides of a shape around the end of a line.
const DIRECTIONS: u32 = 16;

/// Of each label whose line ends in the blank, where that is; `index` has the lines of the figure.
pub(super) fn findings(page: &Page, index: &Nearby) -> Vec<FoundBreach> {
    let glyphs = || page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let to_glyph = |at: MmPoint| glyphs().map(|glyph| (glyph.at - at).length()).fold(f32::MAX, f32::min);
    let of = |text: &BrailleText| {
        let (at, leader) = (tip(text)?, text.leader.as_ref()?);
        let is_near = index.nearest(at, LEADER_END, |_| true).is_some() || to_glyph(at) <= LEADER_END;
        if is_near || is_shut_in(at, page) {
            return None;
        }
        let extent = around(leader.points.iter().copied())?;
        let name = text_name(text);
        let what = format!("the line that leads from {name} ends where nothing is within {LEADER_END} mm");
        Some(FoundBreach::at(LABEL_LINE, at, extent, LEADER_END, what).of(&name))
    };
    page.braille.iter().filter_map(of).collect()
}

/// The end of the line of a label that is farther from its cells.
fn tip(text: &BrailleText) -> Option<MmPoint> {
    let cells = around(text.dots.at.iter().copied())?;
    let points = &text.leader.as_ref()?.points;
    let far = |at: &MmPoint| distance_to_box(*at, cells);
    [*points.first()?, *points.last()?].into_iter().max_by(|a, b| far(a).total_cmp(&far(b)))
}

/// Whether lines of the figure lie around a point on all sides, as it may name the area in which it stands.
fn is_shut_in(at: MmPoint, page: &Page) -> bool {
    let place = page.figure.place;
    let reach = place.width() + place.height();
    let runs = || page.figure.lines.iter().flat_map(|line| &line.runs);
    let meets = |(from, to): (MmPoint, MmPoint)| {
        let along = |run: &Run| run.polyline().segments().any(|(a, b)| crossing((from, to), (*a, *b)).is_some());
        runs().any(along)
    };
    (0..DIRECTIONS).all(|k| {
        let (sin, cos) = (TAU * (k as f32 + 0.5) / DIRECTIONS as f32).sin_cos();
        meets((at, at + MmVector::new(cos, sin) * reach))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legibility::paths::Paths;
    use crate::page::{Dots, Figure, Line, Parts, TextRole};
    use crate::units::{MmRect, Size};

    /// What is found of a label at the left whose line ends at this place, beside a square of 40 mm.
    fn found(x: f32, y: f32) -> Vec<String> {
        let at = |x: f32, y: f32| MmPoint::new(x, y);
        let square = [at(60.0, 30.0), at(100.0, 30.0), at(100.0, 70.0), at(60.0, 70.0), at(60.0, 30.0)];
        let line = Line { strength: 100.0, runs: vec![Run::stroke(1.0, square.to_vec())] };
        let figure = Figure {
            place: MmRect::new(at(10.0, 10.0), at(190.0, 130.0)),
            source: Size::new(180, 120),
            textures: Vec::new(),
            lines: vec![line],
        };
        let text = BrailleText {
            role: TextRole::Label,
            text: "roof".to_owned(),
            language: "en".to_owned(),
            abbreviation: None,
            lines: vec!["\u{2801}".to_owned()],
            dots: Dots { diameter: 1.3, at: vec![at(20.0, 50.0)] },
            leader: Some(Run::stroke(0.75, vec![at(23.0, 50.0), at(x, y)])),
        };
        let page = Page::new(Parts { braille: vec![text], ..Parts::of([210.0, 297.0], figure) }).expect("a page");
        let paths = Paths::of(&page.figure.lines, f32::INFINITY);
        let found = findings(&page, &paths.index(5.0));
        found.into_iter().map(|found| found.what).collect()
    }

    #[test]
    fn a_line_that_leads_to_nothing_is_told() {
        assert!(found(59.0, 50.0).is_empty() && found(80.0, 50.0).is_empty(), "to a side, and into a shape");
        assert_eq!(found(45.0, 50.0), ["the line that leads from \"roof\" ends where nothing is within 6 mm"]);
    }
}
