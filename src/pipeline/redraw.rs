//! A page that was read, made ready for its own paper or device, or drawn anew for another one.

use super::areas;
use super::described::{described, is_made};
use super::draw::{Marks, draw_lines, draw_overview, draw_textures, left_out, told_left_out, told_of_overview};
use super::drawn_areas;
use super::give_way;
use super::hand_lines::HandLines;
use super::kept_lines::{self, LineName};
use super::key::Key;
use super::label::{Label, Position};
use super::print_words;
use super::progress::Watch;
use super::request::Request;
use super::typed;
use super::words::{Words, Written, blank_to_signs};
use crate::classes::Classes;
use crate::lines::{Line, Pen, Run};
use crate::page::layout::Layout;
use crate::page::{
    BrailleText, Figure, Glyph, InSet, Medium, MediumParams, Names, Page, Parts, Shape, Sign, TextRole, Texture,
};
use crate::profile::Plan;
use crate::reading::Reading;
use crate::units::{MmPoint, MmRect, PageTransform, Size};
use crate::wording::Wording;
use crate::{About, Error, Note, dots, legibility};

/// Pixels for a millimetre in which the shape of a figure is said.
const PX_PER_MM: f32 = 20.0;

/// How far lines end before one that a person drew across them, as a share of the gap over which ends are joined or
/// led on.
const GAP_OF_ENDS: f32 = 0.6;

/// How far the sign of an area may be turned from that of its class before it is another one, degrees.
const TURNED: f32 = 15.0;

/// A page as its paper or device takes it.
#[derive(Debug)]
pub struct Ready {
    /// The page.
    pub page: Page,
    /// What the lines of its figure are called in the file that was read.
    pub lines: Vec<LineName>,
    /// What was changed.
    pub notes: Vec<Note>,
}

/// A page that was read as its paper or device takes it: widths of lines within the range of `plan`, strokes on a page
/// of dots as dots, areas that were moved to another colour or drawn by hand with the signs of that, typed texts in
/// braille, and textures apart from lines.
///
/// # Errors
/// If a mark is off the sheet then.
pub fn made_ready(read: &Reading, plan: &Plan) -> Result<Ready, Error> {
    let Reading { page, .. } = read;
    let mut parts = Parts::clone(page);
    let own_names = read.names.lines.iter().zip(&read.by_hand);
    let mut lines: Vec<LineName> =
        own_names.map(|(name, by_hand)| LineName { name: name.clone(), by_hand: *by_hand }).collect();
    let mut notes = Vec::new();
    let classes = wrong_signs(page);
    if !classes.is_empty() {
        let all = areas::of_page(page);
        for &number in &classes {
            parts.figure.textures[number].glyphs = fill(page, &all, number, plan);
        }
        parts.figure.textures.retain(|texture| !texture.glyphs.is_empty());
        let (count, noun) = (classes.len(), if classes.len() == 1 { "area has" } else { "areas have" });
        let told = format!("{count} {noun} another colour now, and the texture was drawn anew");
        notes.push(Note::TakenAs(About::Areas, told));
    }
    match &page.medium {
        Medium::Print(print) => {
            let swell = print.swell;
            let params = plan.lines();
            let range = [params.width_min - swell, params.width_max - swell];
            let overview = parts.overview.iter_mut().flat_map(|overview| &mut overview.lines);
            let count =
                parts.figure.lines.iter_mut().chain(overview).map(|line| snap(line, range)).filter(|s| *s).count();
            if count > 0 {
                let noun = if count == 1 { "line is" } else { "lines are" };
                let [least, most] = [range[0].max(0.0), range[1]];
                let told = format!("{count} {noun} drawn {least:.2} to {most:.2} mm wide, the range of the profile");
                notes.push(Note::TakenAs(About::Widths, told));
            }
        }
        Medium::Dots(medium) => {
            let params = plan.dots(medium);
            let all: Vec<(Line, LineName)> = parts.figure.lines.drain(..).zip(lines).collect();
            let is_stroke = |(line, _): &(Line, LineName)| line.runs.iter().any(|run| run.pen == Pen::Stroke);
            let (strokes, rows): (Vec<_>, Vec<_>) = all.into_iter().partition(is_stroke);
            (parts.figure.lines, lines) = rows.into_iter().unzip();
            if !strokes.is_empty() {
                let (strokes, of_strokes): (Vec<Line>, Vec<LineName>) = strokes.into_iter().unzip();
                let (count, place) = (strokes.len(), page.figure.place);
                let drawn = dots::lines(&strokes, place, &medium.area, &params);
                let (stand_for, shares) = kept_lines::matched(&strokes, place, &drawn, place);
                let noun = if count == 1 { "line" } else { "lines" };
                notes.push(Note::TakenAs(About::Lines, format!("{count} {noun} on a page of dots made dots")));
                notes.extend(kept_lines::lost(&of_strokes, &shares));
                lines.extend(stand_for.into_iter().map(|line| of_strokes[line].clone()));
                parts.figure.lines.extend(drawn);
            }
        }
    }
    notes.extend(drawn_areas::lay(&mut parts, &read.areas, plan));
    let labels = parts.braille.len();
    notes.extend(typed::write(&mut parts, &read.texts, plan));
    if read.is_changed {
        notes.extend(print_words::follow(&mut parts, labels, plan));
    }
    let made = is_made(page);
    let mut page = Page::new(parts)?;
    if read.is_changed {
        let (free, told) = give_way::textures(page, plan)?;
        page = free;
        notes.extend(told);
        let names = Names {
            lines: lines.iter().map(|line| line.name.clone()).collect(),
            overview_lines: read.names.overview_lines.clone(),
            // they have others than in the file where some were drawn or left out
            areas: Names::of(&page).areas,
        };
        let limits = plan.limits();
        let of_overview = legibility::overview_as_told(&page, &names, &limits);
        notes.extend(of_overview.map(|told| Note::TakenAs(About::Overview, told)));
        let of_braille = legibility::braille_as_told(&page, &names, &limits);
        notes.extend(of_braille.map(|told| Note::Faulty(About::Braille, told)));
    }
    let wording = Wording::nearest(&page.description_language);
    Ok(Ready { page: if made { described(page, wording) } else { page }, lines, notes })
}

/// Which textures have signs of another class.
fn wrong_signs(page: &Page) -> Vec<usize> {
    let is_wrong = |texture: &Texture| {
        let wrong = texture.glyphs.iter().filter(|glyph| match (glyph.shape, texture.sign) {
            (Shape::Rhombus { degrees, .. }, Sign::Rhombus { degrees: sign }) => {
                let apart = (degrees - sign).rem_euclid(180.0);
                apart.min(180.0 - apart) > TURNED
            }
            (Shape::Dot { .. }, Sign::Dot) => false,
            _ => true,
        });
        2 * wrong.count() > texture.glyphs.len()
    };
    match page.medium {
        Medium::Print(_) => {
            (0..page.figure.textures.len()).filter(|&number| is_wrong(&page.figure.textures[number])).collect()
        }
        // dots look alike
        Medium::Dots(_) => Vec::new(),
    }
}

/// The signs of an area of a printed page, drawn anew.
fn fill(page: &Page, areas: &Classes, number: usize, plan: &Plan) -> Vec<Glyph> {
    let mut one = areas.clone();
    one.region.iter_mut().for_each(|region| *region = region.filter(|of| *of as usize == number));
    let drawn = drawn_areas::fill(&one, page.figure.place, &page.figure.lines, &page.medium, plan);
    let mut glyphs = drawn.into_iter().flat_map(|texture| texture.glyphs).collect();
    let boxes: Vec<MmRect> = page.braille.iter().filter_map(|text| text.dots.bounds()).collect();
    drawn_areas::clear_of_braille(&mut glyphs, blank_to_signs(&page.medium), &boxes, &page.braille);
    glyphs
}

/// Brings the widths of a line into a range, mm; tells whether any was outside.
fn snap(line: &mut Line, [least, most]: [f32; 2]) -> bool {
    let mut changed = false;
    for run in line.runs.iter_mut().filter(|run| run.pen == Pen::Stroke) {
        let width = run.width.clamp(least.max(0.0), most.max(least.max(0.0)));
        // widths are written in steps of 0.01 mm
        if (width - run.width).abs() > 0.011 {
            run.width = width;
            changed = true;
        }
    }
    changed
}

/// The shape of a page's figure, as that of a picture.
pub(super) fn shape(page: &Page) -> Size {
    let px = |side: f32| (side * PX_PER_MM).round().clamp(1.0, 100_000.0) as u32;
    Size::new(px(page.figure.place.width()), px(page.figure.place.height()))
}

/// The words of a page as they would be given.
pub(super) fn words<'a>(page: &'a Page, labels: &'a [Label]) -> Words<'a> {
    let title = page.braille.iter().find(|text| text.role == TextRole::Title);
    Words {
        title: title.map(|text| text.text.as_str()),
        language: Some(page.language.as_str()),
        labels,
        number: page.braille.iter().find(|text| text.role == TextRole::Number).and_then(|text| text.text.parse().ok()),
        ..Words::default()
    }
}

/// The sheets of a page's own key, none where there is to be none, and what is told of them.
///
/// # Errors
/// If a mark is off its sheet.
pub fn key_of_page(page: &Page, key: Key, request: &Request<'_>) -> Result<(Vec<Page>, Vec<Note>), Error> {
    if page.braille.iter().any(|text| text.role == TextRole::Key) {
        let told = (key == Key::Always).then_some(Note::NoKey("this sheet is one of a key itself"));
        return Ok((Vec::new(), told.into_iter().collect()));
    }
    let labels = labels(page);
    let words = Words { key, ..words(page, &labels) };
    let written = Written::new(&words, request.plan);
    let layout = Layout {
        sheet: page.sheet,
        figure: page.figure.place,
        overview: None,
        mark: None,
        heading: None,
        medium: page.medium.clone(),
    };
    // an overview has the next sheet to itself
    let before = 1 + u32::from(InSet::of(page) == Some(InSet::Followed));
    written.key_sheets(&words, &page.braille, &page.figure, before, &layout, request)
}

/// The marks of a page in another layout: lines and areas keep their places in the figure. `lines` are what its lines
/// are called, of which those that a person drew come first; `own` is its profile.
///
/// # Errors
/// If the figure has no area.
pub(super) fn marks(
    (page, lines): (&Page, &[LineName]),
    own: &Plan,
    layout: Layout,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Marks, Error> {
    let (plan, size) = (request.plan, shape(page));
    let px_per_mm = PageTransform::new(size, layout.figure).px_per_mm();
    let params = plan.lines();
    // two ends that face one another over such a gap are not joined, and each is led on to the line between them
    let blank = [params.max_spacing(), GAP_OF_ENDS * params.join_gap].map(|mm| mm * px_per_mm);
    let mut edges = HandLines::of_figure(page, own).edges_below(lines, size, blank, params.full_strength)?;
    if let MediumParams::Dots { device, .. } = plan.medium()
        && !device.has_heights()
    {
        // a page tells one strength of a whole line: a second row would go all along it
        let most = 0.99 * plan.profile().dots.heavy_from;
        edges.edgels.iter_mut().for_each(|edgel| edgel.strength = edgel.strength.min(most));
    }
    let of_overview = HandLines::of_overview(page, own).map(|lines| lines.edges(size)).transpose()?;
    let (mut drawn, _) = draw_lines(Some(&edges), &layout, plan, watch);
    let (overview, not_in_overview) = draw_overview(of_overview.as_ref().or(Some(&edges)), &layout, plan, watch);
    let left_out = left_out(&drawn.lost, not_in_overview.rings);
    let mut notes: Vec<Note> = told_left_out(&drawn, Some(&edges), &layout).map(of_page).into_iter().collect();
    if plan.profile().figure.lines {
        let (stand_for, shares) =
            kept_lines::matched(&page.figure.lines, page.figure.place, &drawn.lines, layout.figure);
        keep_widths(&mut drawn.lines, &stand_for, (page, lines), own, plan);
        notes.extend(kept_lines::lost(lines, &shares));
    }
    notes.extend(told_of_overview(&not_in_overview));
    notes.extend(dots_left_out(page));
    let classes = plan.profile().figure.textures.then(|| areas::of_page(page));
    let textures = draw_textures(classes.as_ref(), &layout, &drawn.lines, plan, watch);
    let figure = Figure { place: layout.figure, source: page.figure.source, textures, lines: drawn.lines };
    Ok(Marks { figure, overview, layout, is_flat: false, left_out, texts: Vec::new(), notes })
}

/// Gives lines that a person drew the width that they have on the page, within the range of `plan`: as contours they
/// are all of full strength.
fn keep_widths(drawn: &mut [Line], stand_for: &[usize], (page, names): (&Page, &[LineName]), own: &Plan, plan: &Plan) {
    let (params, swell) = (plan.lines(), own.profile().print.swell);
    for (line, &number) in drawn.iter_mut().zip(stand_for) {
        let Some(before) = page.figure.lines.get(number).filter(|_| names.get(number).is_some_and(|of| of.by_hand))
        else {
            continue;
        };
        let strokes = || before.runs.iter().filter(|run| run.pen == Pen::Stroke);
        let length: f32 = strokes().map(Run::length).sum();
        let width = strokes().map(|run| run.width * run.length()).sum::<f32>() / length.max(f32::MIN_POSITIVE) + swell;
        for run in line.runs.iter_mut().filter(|run| run.pen == Pen::Stroke && length > 0.0) {
            run.width = width.clamp(params.width_min, params.width_max);
        }
    }
}

/// A note as it is of use for a page: it has no parts to draw, and no sheets to be spread over.
fn of_page(note: Note) -> Note {
    match note {
        Note::TooDense { millimetres, percent, place, .. } => Note::LinesLeftOut { millimetres, percent, place },
        other => other,
    }
}

/// That dots which somebody drew on a page are not on one that is laid out anew; none if there are none.
pub fn dots_left_out(page: &Page) -> Option<Note> {
    let count: usize = page.labels.iter().map(|dots| dots.at.len()).sum();
    let dots = if count == 1 { "1 dot" } else { &format!("{count} dots") };
    let why = "drawn by hand: they stay only where the page is written as it is, for its own paper or device";
    (count > 0).then(|| Note::NotOnPage(About::Dots, format!("{dots} {why}")))
}

/// The labels of a page as they would be given, each at what it names.
pub(super) fn labels(page: &Page) -> Vec<Label> {
    let place = page.figure.place;
    let percent = |at: f32, low: f32, side: f32| Position::Percent((100.0 * (at - low) / side).clamp(0.0, 100.0));
    let label = |text: &BrailleText| {
        let middle = MmRect::from_points(&text.dots.at).center();
        let ends = text.leader.as_ref().map(|leader| (leader.points.first(), leader.points.last()));
        let at: MmPoint = match ends {
            Some((Some(&a), Some(&b))) if (a - middle).length() > (b - middle).length() => a,
            Some((Some(_), Some(&b))) => b,
            _ => middle,
        };
        let x = percent(at.x, place.min.x, place.width());
        Label { x, y: percent(at.y, place.min.y, place.height()), text: text.text.clone() }
    };
    page.braille.iter().filter(|text| text.role == TextRole::Label).map(label).collect()
}
