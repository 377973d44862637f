//! A page that was read, drawn anew for another paper or device.

use super::areas;
use super::decisions::LinesOf;
use super::draw::DrawnMarks;
use super::figure_lines::{FigureLines, draw_lines};
use super::finish::{PageSays, PictureFacts};
use super::hand_lines::HandLines;
use super::kept_lines::{self, LineName};
use super::leaders;
use super::legend::{self, LegendEntry};
use super::margins::{self, LetteredAt};
use super::overview::{draw_overview, told_by_hand, told_of_overview};
use super::progress::Watch;
use super::request::{OverviewSize, Request};
use super::texts::Text;
use super::textures::{blank_ground, draw_textures, without_unlearned};
use super::told_lines::{LinesLeftOut, left_out};
use super::words::{Words, WrittenWords};
use crate::classes::Classes;
use crate::edges::Edges;
use crate::lines::{Line, Pen, Run, arrows};
use crate::page::layout::Layout;
use crate::page::spread;
use crate::page::{BrailleText, Figure, InSet, LeftOut, MediumParams, Page, TextRole, Texture, ToldInKey};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, PageTransform, Size};
use crate::{About, Error, Note, Reason};

/// Pixels for a millimetre in which the shape of a figure is said.
const PX_PER_MM: f32 = 20.0;

/// How far lines end before one that a person drew across them, as a share of the gap over which ends are joined or
/// led on.
const GAP_OF_ENDS: f32 = 0.6;

/// The shape of a page's figure, as that of a picture.
pub(super) fn shape(page: &Page) -> Size {
    let px = |side: f32| (side * PX_PER_MM).round().clamp(1.0, 100_000.0) as u32;
    Size::new(px(page.figure.place.width()), px(page.figure.place.height()))
}

/// The words of a page as they would be given.
pub(super) fn words<'a>(page: &'a Page, legend: &'a [LegendEntry]) -> Words<'a> {
    let title = page.braille.iter().find(|text| text.role == TextRole::Title);
    Words {
        title: title.map(|text| text.text.as_str()).or_else(|| ToldInKey::title_of(page)),
        language: Some(page.language.as_str()),
        own_texts: labels_of(page).next().is_some(),
        legend,
        number: page.braille.iter().find(|text| text.role == TextRole::Number).and_then(|text| text.text.parse().ok()),
        ..Words::default()
    }
}

/// A page that is laid out anew.
#[derive(Clone, Copy)]
pub struct OldPage<'a> {
    /// The page.
    pub page: &'a Page,
    /// What the lines of its figure are called.
    pub lines: &'a [LineName],
    /// What its areas are called.
    pub areas: &'a [String],
    /// The title that it is given, if not its own.
    pub title: Option<&'a str>,
    /// Its own profile.
    pub plan: &'a Plan,
}

/// The marks of a page in another layout: lines and areas keep their places in the figure, and lines that a person drew
/// come first. Its labels are texts where they stood: each is placed in that place again, or at the line of the figure
/// that leads to it; one whose leader line is not drawn as a whole is led to where the tip of that was.
///
/// # Errors
/// If the figure has no area, its lines are too long, or the page is no longer wanted.
pub(super) fn marks(
    old: OldPage<'_>,
    layout: Layout,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<DrawnMarks, Error> {
    let OldPage { page, lines, plan: own, .. } = old;
    let (plan, size) = (request.plan, shape(page));
    let (px_per_mm, params) = (PageTransform::new(size, layout.figure).px_per_mm(), plan.lines());
    // two ends that face one another over such a gap are not joined, and each is led on to the line between them
    let blank = [params.max_spacing(), GAP_OF_ENDS * params.join_gap].map(|mm| mm * px_per_mm);
    let hand_lines = HandLines::of_figure(page, own)?.called(lines.to_vec());
    let mut edges = hand_lines.contours_by_hand_first(size, blank, params.full_strength)?;
    without_second_rows(&mut edges, plan);
    let of_overview = HandLines::of_overview(page, own).map(|lines| lines.contours(size)).transpose()?;
    let beside = leaders::reach(page, own.profile().braille.cell);
    let (texts, of_leaders) = labels_led(&mut edges, (old, beside), &layout, plan);
    request.go_on()?;
    // the lines of a page stay lines of their own
    let FigureLines { lines: mut drawn, .. } = draw_lines(&edges, LinesOf::Person, &layout, plan, watch);
    let edges_of_overview = of_overview.as_ref().unwrap_or(&edges);
    let overview = draw_overview(edges_of_overview, LinesOf::Person, OverviewSize::Own, &layout, plan, watch);
    let told = LinesLeftOut::of(&drawn, &edges, &layout).map(LinesLeftOut::told_of_page);
    let mut notes: Vec<Note> = told.into_iter().collect();
    notes.extend(hand_lines.told_outside().into_iter().chain(of_leaders));
    if plan.profile().figure.lines {
        let (stand_for, mut shares) =
            kept_lines::matched(&page.figure.lines, page.figure.place, &drawn.lines, layout.figure);
        told_by_themselves(page, &hand_lines).for_each(|line| shares[line] = 1.0);
        keep_widths(&mut drawn.lines, &stand_for, old, plan);
        notes.extend(kept_lines::lost(lines, &shares));
    }
    notes.extend(told_of_overview(&overview, &drawn.lost.marks).chain(dots_left_out(page, own)));
    // what an overview of the page lacks is told where the page is read
    let of_figure = std::iter::once(&hand_lines).filter(|_| of_overview.is_none());
    notes.extend(told_by_hand(of_figure, &drawn.lines, &overview, &layout));
    request.go_on()?;
    let of_drawing = !LeftOut::of(page).of_photograph;
    let (textures, of_areas, coloured_ground) = textures(old, &drawn.lines, of_drawing, &layout, plan, watch);
    notes.extend(of_areas);
    let mut leaders = leaders::on_page(&edges, (&texts, beside), &layout);
    leaders.extend(leaders::of_dots(page).map(|ends| ends.map(moved(page, &layout))));
    let lines = leaders::spaced(drawn.lines, &leaders, &layout);
    let figure = Figure { place: layout.figure, source: page.figure.source, textures, lines };
    let left_out = beside_counts_of(page, left_out(&drawn.lost, overview.lost.rings, of_drawing));
    let (said, told) = sheet_of_set(PageSays::of(left_out), page, &layout, plan);
    notes.extend(told);
    Ok(DrawnMarks {
        figure,
        lost_of_overview: overview.lost.share(),
        overview: overview.marks,
        layout,
        facts: PictureFacts { coloured_ground, ..PictureFacts::default() },
        said,
        lost_signs: drawn.lost.signs,
        legend: legend::of_page(page),
        texts,
        notes,
    })
}

/// The textures of the areas of a page, beside these lines, what is told of areas without one, and whether the ground
/// is such an area of its own colour.
fn textures(
    old: OldPage<'_>,
    lines: &[Line],
    of_drawing: bool,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> (Vec<Texture>, Vec<Note>, bool) {
    let (classes, lost, of_ground) = areas_of(old, plan);
    let mut textures = draw_textures(classes.as_ref(), layout, lines, plan, watch);
    let bare = without_unlearned(&mut textures, classes.as_ref(), lines, layout, of_drawing, plan);
    let coloured_ground = of_ground.is_some();
    let notes = lost.into_iter().chain(of_ground).chain(bare).collect();
    (textures, notes, coloured_ground)
}

/// The lines of a page that are told otherwise where they are not drawn: heads of arrows, and those that lie outside of
/// the figure.
fn told_by_themselves(page: &Page, hand_lines: &HandLines) -> impl Iterator<Item = usize> {
    let heads = arrows(&page.figure.lines).into_iter().filter_map(|arrow| arrow.head);
    heads.chain((0..page.figure.lines.len()).filter(|line| hand_lines.is_outside(*line)))
}

/// Makes contours too weak for a second row, where a device has one height only: a page tells one strength of a whole
/// line, and a second row would go all along it.
fn without_second_rows(edges: &mut Edges, plan: &Plan) {
    if matches!(plan.medium(), MediumParams::Dots { device, .. } if !device.has_heights())
        && let Some(heavy) = plan.heavy_strokes()
    {
        edges.edgels.iter_mut().for_each(|edgel| edgel.strength = heavy.strength(0.0, edgel.strength));
    }
}

/// The areas of a page, if any are to have textures, what is told of those that have no cell, and of its ground: that
/// of a page that has none already is another area.
fn areas_of(old: OldPage<'_>, plan: &Plan) -> (Option<Classes>, Vec<Note>, Option<Note>) {
    if !plan.profile().figure.textures {
        return (None, Vec::new(), None);
    }
    let of_page = areas::of_page(old.page, old.plan);
    let lost = areas::told_lost(old.page, &of_page, old.areas, &areas::lost(old.page, &of_page));
    let mut classes = of_page.classes;
    let has_ground = old.plan.profile().figure.ground;
    let told = has_ground.then(|| blank_ground(&mut classes, plan)).flatten();
    (Some(classes), lost, told)
}

/// What a sheet of a set says of itself in another layout: it stays that sheet, with its name if there is room at the
/// top. Tells what it has no longer.
fn sheet_of_set(said: PageSays, page: &Page, layout: &Layout, plan: &Plan) -> (PageSays, Option<Note>) {
    let in_set = InSet::of(page).filter(|in_set| *in_set != InSet::Followed);
    let (label, told) = match &in_set {
        Some(InSet::One(name, _)) => {
            let label = spread::label(name, &layout.medium, plan.layout().margin).filter(|_| layout.heading.is_some());
            let has_name = if label.is_some() { "" } else { ", for whose name there is no room at its top" };
            let told = format!(
                "this is sheet {name} of a picture on several sheets{has_name}; in another size it has no ticks, and \
                 does not lie beside the others: for a set of such sheets, convert the picture for this paper or device"
            );
            (label, Some(Note::TakenAs(About::Marks, Reason::SheetOfSet, told.into())))
        }
        Some(InSet::Overview | InSet::OverviewOf(_) | InSet::Followed) | None => (None, None),
    };
    (PageSays { in_set, label, ..said }, told)
}

/// What is left out of a page that is laid out anew, with the words and areas that it lacked before.
fn beside_counts_of(page: &Page, left_out: LeftOut) -> LeftOut {
    let LeftOut { areas, texts, labels, .. } = LeftOut::of(page);
    LeftOut { areas, texts, labels, ..left_out }
}

/// The layout of a page whose labels have room beside its figure, as those of a drawing have.
pub(super) fn with_room(
    page: &Page,
    words: &Words<'_>,
    written: &WrittenWords<'_>,
    plan: &Plan,
    layout: Layout,
    layout_of: &dyn Fn(Size) -> Result<Layout, Error>,
) -> Layout {
    let source = shape(page);
    let texts_at = |layout: &Layout| labels_of(page).map(|text| text_at(text, page, layout)).collect();
    let contours_at = |layout: &Layout| {
        let there = moved(page, layout);
        let points = page
            .figure
            .lines
            .iter()
            .flat_map(|line| &line.runs)
            .flat_map(|run| points_along(&run.path().collect::<Vec<_>>()));
        points.map(there).collect()
    };
    let lettered = LetteredAt { source, texts_at: &texts_at, contours_at: &contours_at };
    margins::with_room_for(&lettered, words, written, plan, layout, layout_of)
}

/// Points of a polyline no farther apart than a millimetre.
fn points_along(points: &[MmPoint]) -> Vec<MmPoint> {
    let between = |pair: &[MmPoint]| {
        let count = (pair[1] - pair[0]).length().ceil().max(1.0) as u32;
        let (from, to) = (pair[0], pair[1]);
        (0..count).map(move |step| from.lerp(to, step as f32 / count as f32))
    };
    points.windows(2).flat_map(between).chain(points.last().copied()).collect()
}

/// Where a place in the figure of a page lies in another layout.
fn moved(page: &Page, layout: &Layout) -> impl Fn(MmPoint) -> MmPoint + use<> {
    let size = shape(page);
    let (transform, before) = (PageTransform::new(size, layout.figure), PageTransform::new(size, page.figure.place));
    move |at| transform.to_mm(before.to_px(at))
}

/// A label of a page as a text in another layout.
fn text_at(label: &BrailleText, page: &Page, layout: &Layout) -> Text {
    let there = moved(page, layout);
    let place = label.dots.bounds().unwrap_or_else(MmRect::zero);
    Text {
        string: label.text.clone(),
        place: MmRect::new(there(place.min), there(place.max)),
        angle: 0.0,
        size: place.height(),
        hidden: false,
        lost_leader: None,
        kept_leader: None,
        of_legend: false,
        of_sign: None,
    }
}

/// The labels of a page, so far `beside` which their leader lines begin at most, as texts in another layout. Takes the
/// leader lines among the lines of the page out that are not drawn as a whole: their labels are led to what they name,
/// as those are whose leader line came with them.
fn labels_led(
    edges: &mut Edges,
    (old, beside): (OldPage<'_>, f32),
    layout: &Layout,
    plan: &Plan,
) -> (Vec<Text>, Vec<Note>) {
    let page = old.page;
    let transform = PageTransform::new(edges.size, layout.figure);
    let before = PageTransform::new(edges.size, page.figure.place);
    let there = moved(page, layout);
    let mut texts: Vec<Text> = labels_of(page).map(|label| text_at(label, page, layout)).collect();
    // no line of the figure leads to one that has a leader line of its own
    let own: Vec<Option<[MmPoint; 2]>> = labels_of(page).map(own_leader).collect();
    let numbers: Vec<usize> = (0..texts.len()).filter(|&text| own[text].is_none()).collect();
    let mut led: Vec<Text> = numbers.iter().map(|&text| texts[text].clone()).collect();
    let is_label = |text: &Text| text.place.area() > 0.0;
    let draw = |edges: &Edges| draw_lines(edges, LinesOf::Person, layout, plan, &mut |_| ()).lines.lines;
    let told = leaders::whole_or_none(edges, &mut led, beside, is_label, layout, draw);
    numbers.into_iter().zip(led).for_each(|(number, text)| texts[number] = text);
    for ((text, label), own) in texts.iter_mut().zip(labels_of(page)).zip(own) {
        text.lost_leader = own.map(|[from, tip]| (there(from), there(tip))).or(text.lost_leader);
        // braille is not larger in a larger figure: it keeps its distance from the line that leads to it
        if let (Some((from, _)), Some(place)) = (text.kept_leader, label.dots.bounds()) {
            text.place = place.translate(from - before.to_mm(transform.to_px(from)));
        }
    }
    (texts, told)
}

/// Gives lines that a person drew the width that they have on the page, within the range of `plan`: as contours they
/// are all of full strength.
fn keep_widths(drawn: &mut [Line], stand_for: &[Option<usize>], old: OldPage<'_>, plan: &Plan) {
    let OldPage { page, lines: names, plan: own, .. } = old;
    let (params, swell) = (plan.lines(), own.profile().print.swell);
    for (line, number) in drawn.iter_mut().zip(stand_for) {
        let by_hand = number.filter(|number| names.get(*number).is_some_and(|of| of.by_hand));
        let Some(before) = by_hand.and_then(|number| page.figure.lines.get(number)) else {
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

/// That dots which somebody drew on a page are not on one that is laid out anew; none if there are none.
pub fn dots_left_out(page: &Page, own: &Plan) -> Option<Note> {
    // the name of one of several sheets is made with it
    let name = match InSet::of(page) {
        Some(InSet::One(name, _)) => spread::label(&name, &page.medium, own.layout().margin),
        Some(InSet::Overview | InSet::OverviewOf(_) | InSet::Followed) | None => None,
    };
    let is_of_name = |at: &MmPoint| name.iter().flat_map(|name| &name.at).any(|dot| (*dot - *at).length() < SAME);
    let count = page.labels.iter().flat_map(|dots| &dots.at).filter(|at| !is_of_name(at)).count();
    let dots = if count == 1 { "1 dot" } else { &format!("{count} dots") };
    let why = "drawn by hand: they stay only where the page is written as it is, for its own paper or device";
    (count > 0).then(|| Note::NotOnPage(About::Dots, Reason::DotsByHand, format!("{dots} {why}").into()))
}

/// Two dots no farther apart are one, mm: coordinates are rounded.
const SAME: f32 = 0.05;

/// The labels of a page.
fn labels_of(page: &Page) -> impl Iterator<Item = &BrailleText> {
    page.braille.iter().filter(|text| text.role == TextRole::Label)
}

/// The leader line of a label that came with it, from the label to its tip.
fn own_leader(text: &BrailleText) -> Option<[MmPoint; 2]> {
    let middle = MmRect::from_points(&text.dots.at).center();
    let points = &text.leader.as_ref()?.points;
    let (&a, &b) = points.first().zip(points.last())?;
    Some(if (a - middle).length() > (b - middle).length() { [b, a] } else { [a, b] })
}
