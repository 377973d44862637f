//! What is told of labels: those that are not on the page, and why, and how others stand there.

use std::collections::BTreeMap;

use super::unwritten::{Lacks, RefusedTexts, named};
use crate::geom::polygon::is_inside;
use crate::labels::{self, Attachment, NEAR, Placed, PlacedAs, Unplaced, Wanted};
use crate::lines::Line;
use crate::listing::{counted, first_few, list};
use crate::page::Figure;
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason, Told};

/// Why labels are left out, or there is no key: for programs and for the maker.
pub(super) type Why = (Reason, &'static str);

pub(super) const OUTSIDE: Why = (Reason::LabelOutside, "what lies outside of the picture is not drawn");
pub(super) const OFF: Why = (Reason::BrailleOff, "braille is off (braille=false)");
pub(super) const NO_CODE: Why = (Reason::NoCode, "there is no braille code for this language");
pub(super) const NO_CODE_OF_WORDS: Why = (Reason::NoCode, "there is no braille code for the language of the words");
pub(super) const NOTHING_TO_TELL: Why = (
    Reason::NothingToTell,
    "it would tell nothing: the figure has no textures, whose colours it names, and no label is abbreviated",
);
const NO_ROOM: Why = (Reason::NoRoomForLabel, "there is no room");
/// Why some numbers along an axis are left out where every so many-th stands.
const EVERY: [(i64, &str); 3] = [
    (2, "there is room for every second number along an axis only"),
    (5, "there is room for every fifth number along an axis only"),
    (10, "there is room for every tenth number along an axis only"),
];
const _: () =
    assert!(EVERY[0].0 == labels::EVERY[0] && EVERY[1].0 == labels::EVERY[1] && EVERY[2].0 == labels::EVERY[2]);
/// The same where only those stand that have a tick on the page.
const AT_TICKS: &str = "there is room for the numbers at the ticks of the page only";
const NO_CELLS: Why = (Reason::NoCells, "the braille code has no cells for such a text");
const MISLEADING: Why = (
    Reason::Misleading,
    "without characters that the braille code has no cells for such a text would say something else",
);
const TOO_MANY: Why = (Reason::TooManyLabels, "a page takes 300 labels at most");
pub(super) const TOO_LONG: Why = (Reason::TextTooLong, "a text of a page has 1000 characters at most");
const _: () = assert!(labels::MOST == 300 && labels::LONGEST == 1000);

pub(super) fn left_out(texts: Vec<String>, (reason, why): Why) -> Option<Note> {
    (!texts.is_empty()).then_some(Note::LabelsLeftOut { texts, reason, why })
}

/// Tells of labels that stand on the page though what they name does not: a label names what is nearer than that from
/// which on it has a leader line. In the middle of a large shape nothing may be so near: where the figure is that of a
/// page that is drawn anew, only what was near `before` is missing. What a closed line surrounds names that.
pub(super) fn of_nothing(
    wanted: &[Wanted],
    results: &[Result<Placed, Unplaced>],
    figure: &Figure,
    before: Option<&Figure>,
) -> Option<Note> {
    let is_met_in = |figure: &Figure, at: MmPoint, near: f32| {
        let place = MmRect::new(at, at).inflate(near, near);
        let mut runs = figure.lines.iter().flat_map(|line| &line.runs);
        let mut points = figure.textures.iter().flat_map(|texture| &texture.glyphs);
        points.any(|glyph| place.contains(glyph.at))
            || runs.any(|run| is_met(run.path(), place))
            || figure.lines.iter().any(|line| surrounds(line, at))
    };
    let was_there = |before: &Figure, at: MmPoint| {
        let (from, to) = (figure.place, before.place);
        let share = |at: f32, side: f32| if side > 0.0 { at / side } else { 0.0 };
        let x = to.min.x + to.width() * share(at.x - from.min.x, from.width());
        let y = to.min.y + to.height() * share(at.y - from.min.y, from.height());
        is_met_in(before, MmPoint::new(x, y), NEAR)
    };
    let is_there = |label: &Wanted| {
        let at = label.anchor.center();
        // in a larger figure all is farther off, and lines may move a little
        let larger = |before: &Figure| figure.place.width() / before.place.width().max(f32::MIN_POSITIVE);
        let near = before.map_or(NEAR, |before| MOVED * NEAR * larger(before).max(1.0));
        is_met_in(figure, at, near) || before.is_some_and(|before| !was_there(before, at))
    };
    let placed = wanted.iter().zip(results).filter(|(_, result)| result.is_ok());
    let alone: Vec<&str> = placed
        .filter(|(label, _)| label.anchor.is_empty() && !label.is_nameless && !is_there(label))
        .map(|(label, _)| label.text.as_str())
        .collect();
    (!alone.is_empty()).then(|| {
        let told = format!(
            "labels that name something which is not on the page, as no line or texture is within {NEAR} mm: {}",
            named(&alone)
        );
        Note::TakenAs(About::Braille, Reason::NamesNothing, told.into())
    })
}

/// A heading has so many words at least: shorter texts above a drawing may name a part of it.
const OF_HEADING: usize = 3;

/// Tells of headings that are not on the page in full: texts of several words above all lines, beside which no other
/// text stands. As the title of the page they have more room.
pub(super) fn of_headings(wanted: &[Wanted], results: &[Result<Placed, Unplaced>], figure: &Figure) -> Option<Note> {
    let heights = figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.path().map(|at| at.y));
    let top = heights.min_by(f32::total_cmp)?;
    let is_alone = |of: &Wanted| {
        let is_beside = |other: &&Wanted| other.anchor.min.y < of.anchor.max.y && other.anchor.max.y > of.anchor.min.y;
        wanted.iter().filter(is_beside).count() == 1
    };
    let is_heading = |of: &Wanted| {
        let is_of_print = !of.anchor.is_empty() && of.lost_leader.is_none() && of.kept_leader.is_none();
        let has_words = of.text.split_whitespace().count() >= OF_HEADING;
        is_of_print && has_words && of.anchor.center().y < top && is_alone(of)
    };
    let is_short = |result: &Result<Placed, Unplaced>| match result {
        Ok(placed) => placed.abbreviation.is_some(),
        Err(why) => matches!(why, Unplaced::NoRoom),
    };
    let short = wanted.iter().zip(results).filter(|(of, result)| is_heading(of) && is_short(result));
    let texts: Vec<&str> = short.map(|(of, _)| of.text.as_str()).collect();
    (!texts.is_empty()).then(|| {
        let told = format!(
            "the full text of {} above the drawing, as there is no room; if it is a title, give it as that of the \
             page: it has more room there, or begins the key",
            named(&texts)
        );
        Note::NotOnPage(About::Braille, Reason::HeadingNotInFull, told.into())
    })
}

/// How much farther off something may be in a figure that is drawn anew, as a share.
const MOVED: f32 = 1.25;

/// Whether a line is closed, of strokes or of dots, and surrounds a place.
fn surrounds(line: &Line, at: MmPoint) -> bool {
    let points = line.own_path();
    let ends_meet = points.first().zip(points.last()).is_some_and(|(first, last)| (*first - *last).length() <= SAME);
    (ends_meet || line.is_ring_of_dots() || line.is_block_of_dots())
        && points.len() > 3
        && is_inside(points.iter().zip(points.iter().cycle().skip(1)), at)
}

/// The ends of a closed line lie in one place, mm: a page has hundredths.
const SAME: f32 = 0.05;

/// Whether a line of these points passes through a box: looked at every 2 mm.
fn is_met(mut points: impl Iterator<Item = MmPoint>, place: MmRect) -> bool {
    let mut last: Option<MmPoint> = None;
    points.any(|at| {
        let from = last.replace(at).unwrap_or(at);
        let steps = ((at - from).length() / 2.0).ceil().max(1.0);
        (0..=steps as u32).any(|step| place.contains(from.lerp(at, step as f32 / steps)))
    })
}

/// Tells of labels that have moved and now stand nearer to what another one names.
pub(super) fn nearer_to_others(wanted: &[Wanted], results: &[Result<Placed, Unplaced>]) -> Option<Note> {
    let far = |anchor: &MmRect, place: &MmRect| {
        let dx = (anchor.min.x - place.max.x).max(place.min.x - anchor.max.x).max(0.0);
        let dy = (anchor.min.y - place.max.y).max(place.min.y - anchor.max.y).max(0.0);
        dx.hypot(dy)
    };
    let names_of = |number: usize, placed: &Placed| {
        let own = far(&wanted[number].anchor, &placed.place);
        // a leader line says what it names; what is nearer by less than a part of a fingertip is as near
        let is_nearer =
            |other: &&Wanted| other.text != wanted[number].text && far(&other.anchor, &placed.place) + NEARER < own;
        let other = wanted
            .iter()
            .filter(is_nearer)
            .min_by(|a, b| far(&a.anchor, &placed.place).total_cmp(&far(&b.anchor, &placed.place)));
        other
            .filter(|_| !wanted[number].is_nameless)
            .filter(|_| {
                placed.attachment == Attachment::Beside
                    && !matches!(placed.stands, PlacedAs::InMargin | PlacedAs::AsTitle)
            })
            .map(|other| other.text.as_str())
    };
    let all = wanted.iter().zip(results).enumerate();
    let moved: Vec<String> = all
        .filter_map(|(number, (label, result))| Some((label, names_of(number, result.as_ref().ok()?)?)))
        .map(|(label, other)| format!("\"{}\" near \"{other}\"", label.text))
        .collect();
    (!moved.is_empty()).then(|| {
        let moved = first_few(&moved, MOST_MOVED, String::clone);
        let told = format!("for want of room labels stand nearer to what another one names than to their own: {moved}");
        let helped = Told::from(told).or_larger().or("leave some out");
        Note::TakenAs(About::Braille, Reason::NearerToOther, helped)
    })
}

/// How much nearer a label is to what another names, mm: half a fingertip.
const NEARER: f32 = 4.0;
/// Most of them that a note shows.
const MOST_MOVED: usize = 5;

/// What is told of textures in whose place labels stand, each with its labels: an area without its texture seems white.
pub(super) fn without_texture(areas: &[Vec<&str>]) -> Option<Note> {
    let (of_areas, they_stand) = match areas.len() {
        0 => return None,
        1 => ("the texture of 1 area".to_owned(), "the label stands in its place"),
        count => (format!("the textures of {count} areas"), "labels stand in their places"),
    };
    let told = format!("{of_areas} ({}), as {they_stand}", under(areas));
    let helped = Told::from(told).or_larger().or(SAY_COLOURS);
    Some(Note::NotOnPage(About::Areas, Reason::UnderLabel, helped))
}

/// The same of textures of which less than two thirds are left beside labels.
pub(super) fn with_less_texture(areas: &[Vec<&str>]) -> Option<Note> {
    let (of_areas, they_stand) = match areas.len() {
        0 => return None,
        1 => ("the texture of 1 area".to_owned(), "the label stands"),
        count => (format!("each of the textures of {count} areas"), "labels stand"),
    };
    let told = format!(
        "more than a third of {of_areas} ({}), where {they_stand} and in what is too narrow beside",
        under(areas)
    );
    let helped = Told::from(told).or_larger().or(SAY_COLOURS);
    Some(Note::NotOnPage(About::Areas, Reason::UnderLabel, helped))
}

/// What helps beside a larger figure where labels stand in textures.
const SAY_COLOURS: &str = "say in the labels what the colours mean";

/// Says of areas under which labels they are; these may be names of something else, as of a town or a river.
fn under(areas: &[Vec<&str>]) -> String {
    let quoted = |labels: &Vec<&str>| {
        let mut all: Vec<String> = labels.iter().take(MOST_LABELS).map(|label| format!("\"{label}\"")).collect();
        let more = labels.len() - all.len();
        all.extend((more > 0).then(|| format!("{more} more")));
        format!("under {}", list(&all, "and"))
    };
    first_few(areas, MOST_AREAS, quoted)
}

/// Most areas that a note names by their labels, and most labels of each.
const MOST_AREAS: usize = 5;
const MOST_LABELS: usize = 5;

/// Tells of leader lines that cross others.
pub(super) fn across(wanted: &[Wanted], results: &[Result<Placed, Unplaced>]) -> Option<Note> {
    let crosses = |result: &Result<Placed, Unplaced>| result.as_ref().is_ok_and(|label| label.attachment.crosses());
    let texts: Vec<&str> = wanted
        .iter()
        .zip(results)
        .filter(|(_, result)| crosses(result))
        .map(|(label, _)| label.text.as_str())
        .collect();
    let why = "other lines, as there is no room for the label";
    let told = match texts.len() {
        0 => return None,
        1 => format!("the leader line of {} crosses {why} elsewhere", named(&texts)),
        count => format!("{count} leader lines cross {why}s elsewhere: {}", named(&texts)),
    };
    let helped = Told::from(told).or_larger();
    Some(Note::TakenAs(About::Leaders, Reason::CrossesLines, helped))
}

/// Tells of labels along an axis that stand beyond the lines, and of numbers whose unit stands with another one.
pub(super) fn of_axes(wanted: &[Wanted], results: &[Result<Placed, Unplaced>]) -> Vec<Note> {
    let those = |is: fn(&Placed) -> bool| -> Vec<&str> {
        let of = wanted.iter().zip(results).filter(|(_, result)| result.as_ref().is_ok_and(is));
        of.map(|(label, _)| label.text.as_str()).collect()
    };
    let tell = |texts: &[&str], reason: Reason, what: &str| {
        (!texts.is_empty()).then(|| Note::TakenAs(About::Braille, reason, format!("{what}: {}", named(texts)).into()))
    };
    let beyond = those(|label| label.stands == PlacedAs::InMargin);
    let in_margin = format!(
        "{} of a row or column stand in the margin, each in line with its place, as there is no room for them there",
        counted(beyond.len(), "label")
    );
    let bare = "of numbers along an axis only one has the unit, as there is no room for it behind each";
    let of_margin = tell(&beyond, Reason::InMargin, &in_margin);
    of_margin.into_iter().chain(tell(&those(|label| label.is_bare), Reason::OneUnit, bare)).collect()
}

/// How many labels are not on a page, or not as they are. Remarks tell of them; what depends on them asks here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct LabelCounts {
    /// Those that are left out, but for those that the translator could not write.
    pub(super) left_out: usize,
    /// Those of them that have no room.
    pub(super) without_room: usize,
    /// Those that are abbreviated, the same text once.
    pub(super) abbreviated: usize,
}

/// What the maker is told of labels: what their code lacks, which are abbreviated, which are not there and why; and how
/// many these are.
pub(super) fn told(wanted: &[Wanted], results: &[Result<Placed, Unplaced>]) -> (Vec<Note>, LabelCounts) {
    let (mut abbreviated, mut refused, mut lacks) = (Vec::new(), RefusedTexts::default(), Lacks::default());
    let mut thinned: BTreeMap<i64, Vec<String>> = BTreeMap::new();
    let mut misleading = Vec::new();
    let (mut no_room, mut no_cells, mut too_many, mut too_long) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (Wanted { text, .. }, result) in wanted.iter().zip(results) {
        match result {
            Ok(label) => {
                lacks.add(text, &label.lacking);
                if let Some(short) = &label.abbreviation
                    && !abbreviated.contains(&(short.clone(), text.clone()))
                {
                    abbreviated.push((short.clone(), text.clone()));
                }
            }
            Err(Unplaced::Thinned(every)) => thinned.entry(*every).or_default().push(text.clone()),
            Err(Unplaced::NoRoom) => no_room.push(text.clone()),
            Err(Unplaced::TooMany) => too_many.push(text.clone()),
            Err(Unplaced::TooLong) => too_long.push(text.clone()),
            Err(Unplaced::Misleading(lacking)) => {
                lacks.add(text, lacking);
                misleading.push(text.clone());
            }
            Err(Unplaced::NoCells(lacking)) => {
                lacks.add(text, lacking);
                no_cells.push(text.clone());
            }
            Err(Unplaced::NotTranslated(why)) => refused.add(text, why.clone()),
        }
    }
    let (abbreviated_count, without_room) = (abbreviated.len(), no_room.len());
    let mut notes: Vec<Note> = lacks.note().into_iter().collect();
    notes.extend((!abbreviated.is_empty()).then_some(Note::Abbreviated(abbreviated)));
    notes.extend(refused.notes());
    let every = |(every, texts): (i64, Vec<String>)| {
        let why = EVERY.iter().find(|(count, _)| *count == every).map_or(AT_TICKS, |(_, why)| why);
        left_out(texts, (Reason::NumbersThinned, why))
    };
    let mut left_out_count: usize = thinned.values().map(Vec::len).sum();
    notes.extend(thinned.into_iter().filter_map(every));
    let missing = [
        (no_cells, NO_CELLS),
        (misleading, MISLEADING),
        (no_room, NO_ROOM),
        (too_many, TOO_MANY),
        (too_long, TOO_LONG),
    ];
    left_out_count += missing.iter().map(|(texts, _)| texts.len()).sum::<usize>();
    notes.extend(missing.into_iter().filter_map(|(texts, why)| left_out(texts, why)));
    (notes, LabelCounts { left_out: left_out_count, without_room, abbreviated: abbreviated_count })
}

#[cfg(test)]
mod tests;
