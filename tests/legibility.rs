//! What a fingertip needs holds on every page, measured on the finished marks alone: widths, lengths, gaps, ink.

use crate::common::{apart, page, samples};
use tactograph::Page;
use tactograph::internals::geom::{nearest_on_segment, segment_distance};
use tactograph::internals::page::{Line, Shape};
use tactograph::internals::units::MmPoint;

/// The default profile's promises, mm.
const LINE_GAP: f32 = 3.0;
const WIDTHS: std::ops::RangeInclusive<f32> = 0.75..=1.5;
const MIN_LENGTH: f32 = 8.0;
/// Blank between two lines.
const LINE_APART: f32 = 3.2;
/// Ink above this share of the sheet makes swell paper curl.
const MOST_INK: f32 = 0.4;

fn pages() -> impl Iterator<Item = (String, &'static Page)> {
    samples::names().into_iter().map(|name| {
        let page = &page::of_sample(&name, "swell-a4").page;
        (name, page)
    })
}

/// Segments of lines with half their width.
fn segments(lines: &[Line]) -> Vec<(MmPoint, MmPoint, f32)> {
    let runs = lines.iter().flat_map(|line| &line.runs);
    runs.flat_map(|run| run.polyline().segments().map(|(a, b)| (*a, *b, 0.5 * run.width))).collect()
}

#[test]
fn glyphs_keep_their_distance_from_lines() {
    for (name, page) in pages() {
        let segments = segments(&page.figure.lines);
        for glyph in page.figure.textures.iter().flat_map(|texture| &texture.glyphs) {
            let corners = glyph.corners();
            for &(a, b, half_width) in &segments {
                if nearest_on_segment(glyph.at, a, b).0 > LINE_GAP + half_width + glyph.radius() {
                    continue;
                }
                let distance = match glyph.shape {
                    Shape::Dot { diameter } => nearest_on_segment(glyph.at, a, b).0 - 0.5 * diameter,
                    Shape::Rhombus { .. } => (0..4)
                        .map(|i| segment_distance((corners[i], corners[(i + 1) % 4]), (a, b)))
                        .fold(f32::MAX, f32::min),
                };
                let gap = distance - half_width;
                assert!(gap >= LINE_GAP - 1e-3, "{name}: the glyph at {:?} is {gap} mm from a line", glyph.at);
            }
        }
    }
}

#[test]
fn glyphs_lie_in_the_picture_and_apart() {
    for (name, page) in pages() {
        let glyphs: Vec<_> = page.figure.textures.iter().flat_map(|texture| &texture.glyphs).collect();
        for (i, glyph) in glyphs.iter().enumerate() {
            let inside = glyph.corners().iter().all(|corner| page.figure.place.contains_inclusive(*corner));
            assert!(inside, "{name}: the glyph at {:?} leaves the picture", glyph.at);
            let touching = |other: &&&tactograph::internals::page::Glyph| {
                // discs around both would do for dots; rhombuses are thinner across, so their outlines are compared
                let near = (other.at - glyph.at).length() < other.radius() + glyph.radius();
                let sides = |g: &tactograph::internals::page::Glyph| {
                    let c = g.corners();
                    [(c[0], c[1]), (c[1], c[2]), (c[2], c[3]), (c[3], c[0])]
                };
                near && sides(glyph).iter().any(|s| sides(other).iter().any(|t| segment_distance(*s, *t) < 0.1))
            };
            assert!(glyphs[..i].iter().find(touching).is_none(), "{name}: a glyph touches {:?}", glyph.at);
        }
    }
}

#[test]
fn lines_are_wide_and_long_enough() {
    for (name, page) in pages() {
        let overview = page.overview.iter().map(|overview| &overview.lines);
        let parts = [&page.figure.lines].into_iter().chain(overview);
        for (lines, number, line) in parts.flat_map(|lines| (0..).zip(lines).map(move |(i, line)| (lines, i, line))) {
            // points on lines are three times as broad as the broadest line
            let is_bead = |run: &tactograph::marks::Run| run.length() < 0.2 && run.width <= 3.0 * WIDTHS.end();
            let is_fine = |run: &tactograph::marks::Run| WIDTHS.contains(&run.width) || is_bead(run);
            assert!(line.runs.iter().all(is_fine), "{name}: a width is out of range");
            // simplification may shorten a line a little, and one from line to line may be short
            let is_whole = line.length() >= 0.97 * MIN_LENGTH || apart::leads_from_line_to_line(lines, number);
            assert!(is_whole, "{name}: a line of {} mm", line.length());
        }
    }
}

#[test]
fn no_page_has_too_much_ink() {
    for (name, page) in pages() {
        let lines: f32 = segments(&page.figure.lines).iter().map(|(a, b, half)| (*b - *a).length() * 2.0 * half).sum();
        let glyphs: f32 = page.figure.textures.iter().flat_map(|t| &t.glyphs).map(|glyph| glyph.area()).sum();
        let share = (lines + glyphs) / page.figure.place.area();
        assert!(share <= MOST_INK, "{name}: {share} of the figure is black");
    }
}

#[test]
fn lines_keep_apart_where_they_do_not_join() {
    for (name, page) in pages() {
        let overview = page.overview.iter().map(|overview| ("overview", &overview.lines));
        for (part, lines) in [("figure", &page.figure.lines)].into_iter().chain(overview) {
            let near = apart::too_near(lines, LINE_APART, apart::approach_of(&name));
            assert!(near.is_empty(), "{name}, {part}: {} places, such as {:?}", near.len(), near[0]);
        }
    }
}
