//! What a page's SVG shows that a page of black marks has not: colours, pictures, letters, and what reaches beyond the
//! sheet.

use std::collections::BTreeMap;

use resvg::tiny_skia::PathSegment;
use usvg::roxmltree::Document;
use usvg::{Group, Paint, Path, Tree};

use super::finding::{FoundBreach, InFile};
use super::limits::{MediumLimits, RuleLimits};
use super::rules::{BLACK_ONLY, BRAILLE_CELL, ELSEWHERE, LETTERS, MARGIN, PICTURE, Rule};
use crate::geom::polygon::exit;
use crate::reading::{SeenText, UnreadKind, UnreadObject, in_mm, is_black, is_braille, is_white, unread_of};
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect};

/// Most colours that are told one by one.
const MOST: usize = 6;

/// All that is no black mark. `texts` are those that are shown in letters.
pub(super) fn findings(
    document: &Document<'_>,
    tree: &Tree,
    texts: &[SeenText],
    limits: &RuleLimits,
) -> Vec<FoundBreach> {
    let sheet = MmRect::new(MmPoint::zero(), MmPoint::new(tree.size().width(), tree.size().height()) * MM_PER_CSS_PX);
    let mut seen = Seen { sheet, ..Seen::default() };
    seen.add(tree.root(), 1.0);
    let mut found = Vec::new();
    // dots are pressed, whatever their colour is
    if matches!(limits.medium, MediumLimits::Print { .. }) {
        found.extend(of_colours(seen.colours));
    }
    // of dots the device says how far they may reach, and there is no number
    let is_printed = matches!(limits.medium, MediumLimits::Print { .. });
    found.extend(seen.beyond.into_iter().map(|beyond| if is_printed { beyond } else { beyond.unmeasured() }));
    found.extend(unread_of(document).iter().flat_map(|object| unread(object, sheet)));
    found.extend(texts.iter().map(|text| letters(text, sheet)));
    found
}

/// A colour and the box around all that has it.
type Coloured = BTreeMap<(u8, u8, u8), (usize, MmRect)>;

/// What reaches no farther beyond the sheet than this lies on it, mm: frames of other programs lie on its edge.
const ON_EDGE: f32 = 0.5;

#[derive(Default)]
struct Seen {
    colours: Coloured,
    sheet: MmRect,
    /// What reaches beyond the sheet.
    beyond: Vec<FoundBreach>,
}

impl Seen {
    fn add(&mut self, group: &Group, opacity: f32) {
        let opacity = opacity * group.opacity().get();
        for node in group.children() {
            match node {
                usvg::Node::Group(group) => self.add(group, opacity),
                usvg::Node::Path(path) if path.is_visible() => {
                    let fill = path.fill().map(|fill| (fill.paint(), fill.opacity().get()));
                    let stroke = path.stroke().map(|stroke| (stroke.paint(), stroke.opacity().get()));
                    let extent = in_mm(path.abs_stroke_bounding_box());
                    let paints = fill.into_iter().chain(stroke).map(|(paint, own)| channels(paint, own * opacity));
                    let inks: Vec<[u8; 3]> = paints.filter(|channels| !is_white(*channels)).collect();
                    let beyond = beyond(extent, self.sheet, path);
                    self.beyond.extend(beyond.filter(|_| !inks.is_empty()));
                    inks.into_iter().for_each(|channels| self.add_ink(channels, extent));
                }
                // letters and pictures are told by their elements
                usvg::Node::Path(_) | usvg::Node::Text(_) | usvg::Node::Image(_) => {}
            }
        }
    }

    fn add_ink(&mut self, channels: [u8; 3], extent: MmRect) {
        if is_black(channels) {
            return;
        }
        let [red, green, blue] = channels;
        let seen = self.colours.entry((red, green, blue)).or_insert((0, extent));
        *seen = (seen.0 + 1, seen.1.union(&extent));
    }
}

/// A paint as it looks on white paper.
fn channels(paint: &Paint, opacity: f32) -> [u8; 3] {
    let channels = match paint {
        Paint::Color(colour) => [colour.red, colour.green, colour.blue],
        _ => [128; 3], // a gradient or a pattern has greys at least
    };
    channels.map(|channel| (255.0 - (255.0 - f32::from(channel)) * opacity).round() as u8)
}

/// How far a path, with this box around its marks, reaches beyond the sheet, if it does.
fn beyond(extent: MmRect, sheet: MmRect, path: &Path) -> Option<FoundBreach> {
    let (id, is_filled) = (path.id(), path.fill().is_some());
    let MmRect { min, max } = extent;
    let out = (sheet.min.x - min.x).max(sheet.min.y - min.y).max(max.x - sheet.max.x).max(max.y - sheet.max.y);
    let name = if id.is_empty() { "a mark without a name".to_owned() } else { format!("\"{id}\"") };
    // half of a stroke that is broader than this has no room on the sheet
    let is_broad = is_broader(path, sheet.width().min(sheet.height()));
    let made = match (sheet.intersects(&extent) && !is_broad, is_filled) {
        (false, _) => "leaves it out",
        (true, false) => "cuts it off at the edge",
        (true, true) => "leaves it out, or cuts off a line around it at the edge",
    };
    let what = || format!("{name} reaches {out:.1} mm beyond the sheet, and render {made}");
    let at = || leaving(path, sheet).unwrap_or_else(|| extent.center().clamp(sheet.min, sheet.max));
    (out > ON_EDGE).then(|| FoundBreach::at(MARGIN, at(), extent, -out, what()).of(id))
}

/// Whether a path has a stroke at least so broad, mm.
fn is_broader(path: &Path, least: f32) -> bool {
    let to_mm = path.abs_transform().post_scale(MM_PER_CSS_PX, MM_PER_CSS_PX);
    let scale = (to_mm.sx * to_mm.sy - to_mm.kx * to_mm.ky).abs().sqrt();
    path.stroke().is_some_and(|stroke| stroke.width().get() * scale >= least)
}

/// Where a path first crosses the edge of the sheet; curves count as their chords.
fn leaving(path: &Path, sheet: MmRect) -> Option<MmPoint> {
    let to_mm = path.abs_transform().post_scale(MM_PER_CSS_PX, MM_PER_CSS_PX);
    let geometry = path.data().clone().transform(to_mm)?;
    let mut last = None;
    geometry.segments().find_map(|segment| {
        let (from, to) = match segment {
            PathSegment::MoveTo(at) => (None, Some(at)),
            PathSegment::LineTo(at) | PathSegment::QuadTo(_, at) | PathSegment::CubicTo(_, _, at) => (last, Some(at)),
            PathSegment::Close => (last, None),
        };
        last = to;
        let [from, to] = [from?, to?].map(|at| MmPoint::new(at.x, at.y));
        exit(from, to, sheet)
    })
}

fn of_colours(colours: Coloured) -> Vec<FoundBreach> {
    let mut all: Vec<_> = colours.into_iter().collect();
    all.sort_by_key(|(colour, (count, _))| (std::cmp::Reverse(*count), *colour));
    let rest = all.split_off(all.len().min(MOST));
    let one = |((red, green, blue), (count, extent)): ((u8, u8, u8), (usize, MmRect))| {
        let marks = if count == 1 { "1 mark is".into() } else { format!("{count} marks are") };
        let kind = if red.abs_diff(green).max(green.abs_diff(blue)) < 8 { "grey" } else { "coloured" };
        let what = format!("{marks} {kind} (#{red:02x}{green:02x}{blue:02x}), and only black swells");
        FoundBreach::at(BLACK_ONLY, extent.center(), extent, count as f32, what)
    };
    let more: usize = rest.iter().map(|(_, (count, _))| count).sum();
    let others = (more > 0).then(|| {
        FoundBreach::of_page(BLACK_ONLY, Some(more as f32), format!("{more} marks have {} other colours", rest.len()))
    });
    all.into_iter().map(one).chain(others).collect()
}

/// What is shown and is no mark: pictures of pixels, and what is not read, with the letters in it.
fn unread(object: &UnreadObject, sheet: MmRect) -> Vec<FoundBreach> {
    let found = |rule: Rule, what: String| of_object(rule, what, object, sheet);
    match &object.kind {
        UnreadKind::Picture => vec![found(PICTURE, "a picture of pixels lies on the page".to_owned())],
        UnreadKind::Clone(of) => {
            let what = match of.is_empty() {
                true => "a clone names nothing to show: render leaves it out".to_owned(),
                false => format!("a clone shows \"{}\", which is not in this file: render leaves it out", short(of)),
            };
            vec![found(ELSEWHERE, what)]
        }
        UnreadKind::Foreign(words) => {
            let lost = found(ELSEWHERE, "an object has content that is no SVG: render leaves it out".to_owned());
            let letters = (!words.is_empty()).then(|| found(LETTERS, in_letters(words)));
            std::iter::once(lost).chain(letters).collect()
        }
    }
}

/// The beginning of a text.
fn short(text: &str) -> String {
    text.chars().take(40).collect()
}

/// What is told of a text in letters.
fn in_letters(text: &str) -> String {
    format!("\"{}\" is written in letters, which fingers do not read", short(text))
}

/// A breach by something that is no mark.
fn of_object(rule: Rule, what: String, object: &UnreadObject, sheet: MmRect) -> FoundBreach {
    let extent = object.extent.map(|extent| on_sheet(extent, sheet));
    let at = extent.map(|extent| extent.center().clamp(sheet.min, sheet.max));
    let in_file = InFile::Row(object.row);
    FoundBreach { rule, what, at, extent, measured: None, becomes_braille: false, in_file }
}

/// What of a box lies on the sheet; all of one that lies beside it.
fn on_sheet(extent: MmRect, sheet: MmRect) -> MmRect {
    extent.intersection(&sheet).unwrap_or(extent)
}

/// Texts that are written in letters and shown.
fn letters(text: &SeenText, sheet: MmRect) -> FoundBreach {
    let (rule, what) = match is_braille(&text.string) {
        true => {
            let short = short(&text.string);
            (BRAILLE_CELL, format!("\"{short}\" is braille in a font, whose dots are not those of standard cells"))
        }
        false => (LETTERS, in_letters(&text.string)),
    };
    let (at, extent, in_file) = (Some(text.at), Some(on_sheet(text.extent, sheet)), InFile::Row(text.row));
    FoundBreach { rule, what, at, extent, measured: None, becomes_braille: text.is_written, in_file }
}
