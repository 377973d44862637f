//! What the maker is told of lines that are not drawn, or drawn otherwise.

use super::hand_lines::HandLines;
use super::kept_lines;
use super::lost_signs::is_small;
use super::texts::Text;
use super::unwritten::named;
use crate::edges::Edges;
use crate::geom::form::Form;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::{ALONG, nearest_on_segment, polyline};
use crate::lines::{Beyond, Line, Lines, Lost, LostLine};
use crate::page::layout::Layout;
use crate::page::sheet_windows::{SheetWindows, place_from_edges};
use crate::page::{LeftOut, Medium};
use crate::profile::Plan;
use crate::regions::OutlineAreas;
use crate::units::{MmPoint, PageTransform};
use crate::{About, Note, Reason, Told};

/// Share of the contours of a drawing from which the maker is told that it is too dense for its size.
const DENSE: f32 = 0.2;
/// Length of the lines left out from which the maker of a drawing is told, mm: there every line is meant. Less is lost
/// where lines meet.
const LEAST_TOLD: f32 = 3.0;
/// On a grid of dots lines are longer or shorter by about this share, which is no loss.
const LEAST_TOLD_OF_DOTS: f32 = 0.05;

/// What the maker is told of lines that are left out as there are to be few.
pub(super) fn told_simplified(beyond: Beyond, areas: Option<&OutlineAreas>, plan: &Plan) -> Option<Note> {
    let most = plan.lines().most_shapes.filter(|_| plan.profile().figure.lines)?;
    // the outline of a region beyond the most is a closed contour too, and so counts in both
    let shapes = beyond.shapes.max(areas.map_or(0, OutlineAreas::beyond));
    Some(Note::Simplified { shapes, lines: beyond.lines, most })
}

/// Contours that are not drawn, where the maker is told of them.
pub(super) struct LinesLeftOut {
    millimetres: u32,
    percent: u32,
    place: Option<&'static str>,
    is_larger_turned: bool,
    /// The width of the figure, mm, for which a drawing is too dense.
    too_dense_for: Option<u32>,
}

impl LinesLeftOut {
    /// None where they are too few to be told.
    pub(super) fn of(drawn: &Lines, edges: &Edges, layout: &Layout) -> Option<Self> {
        let (wanted, lost) = (drawn.lost.wanted, of_lines(&drawn.lost));
        let share = if wanted > 0.0 { (lost / wanted).min(1.0) } else { 0.0 };
        let of_drawing = edges.of_drawing();
        // a display has one sheet, so a figure is not spread over several
        let has_sheets = !matches!(&layout.medium, Medium::Dots(dots) if !dots.device.takes_paper());
        let is_dense = of_drawing && has_sheets && share >= DENSE;
        let is_told = lost >= least_told(&layout.medium, wanted) && (of_drawing || share >= LeftOut::TOLD);
        is_told.then(|| Self {
            millimetres: lost.round() as u32,
            percent: (100.0 * share).round() as u32,
            place: drawn.lost.place_name(),
            is_larger_turned: is_larger_turned(layout),
            too_dense_for: is_dense.then(|| layout.figure.width().round() as u32),
        })
    }

    /// What is told of the page of a picture.
    pub(super) fn told(self) -> Note {
        let Self { millimetres, percent, place, is_larger_turned, .. } = self;
        match self.too_dense_for {
            Some(width) => Note::TooDense { millimetres, percent, place, width, is_larger_turned },
            None => self.told_of_page(),
        }
    }

    /// What is told of a page that was read: it has no parts to draw, and no sheets to be spread over.
    pub(super) fn told_of_page(self) -> Note {
        let Self { millimetres, percent, place, is_larger_turned, .. } = self;
        Note::LinesLeftOut { millimetres, percent, place, is_larger_turned }
    }
}

/// The least length of lines left out that is told, mm, of so many mm of lines.
fn least_told(medium: &Medium, wanted: f32) -> f32 {
    match medium {
        Medium::Print(_) => LEAST_TOLD,
        Medium::Dots(_) => LEAST_TOLD.max(LEAST_TOLD_OF_DOTS * wanted),
    }
}

/// Whether a figure would be larger if the sheet of a device lay across, as the device can take it.
pub(super) fn is_larger_turned(layout: &Layout) -> bool {
    let Medium::Dots(medium) = &layout.medium else { return false };
    let ([width, height], is_sheet) = (layout.sheet, medium.device.takes_paper());
    let is_wide = layout.figure.width() >= WIDE * layout.figure.height();
    is_sheet && width < height && is_wide && medium.device.dot_area([height, width], medium.pitch).is_ok()
}

/// A picture so many times as wide as it is high is larger on a sheet that lies across: one of A4 is 1.4 times as wide
/// as it is high.
const WIDE: f32 = 1.2;

/// What the maker is told of contours that are not drawn, and of lines of a drawing that are not whole on the page.
/// Where what is missing of these is all that is left out but for a little, only they are told.
pub(super) fn told_of_lost(
    drawn: &Lines,
    edges: &Edges,
    texts: &[Text],
    layout: &Layout,
) -> impl Iterator<Item = Note> {
    let (lost, sheets) = (&drawn.lost, Places::of(layout));
    let texts = &of_places(texts, &drawn.lines)[..];
    let is_all = is_told_by_lines(lost, least_told(&layout.medium, lost.wanted));
    let left_out = LinesLeftOut::of(drawn, edges, layout);
    let left_out = left_out.filter(|left_out| !is_all || left_out.too_dense_for.is_some()).map(LinesLeftOut::told);
    let whole = told_gone(lost, &drawn.lines, texts, sheets).into_iter().chain(told_gaps(lost, sheets));
    let whole = whole.chain(told_loose(lost, texts, sheets)).chain(told_torn(lost, texts, sheets));
    left_out.into_iter().chain(whole).chain(told_gridlines(lost))
}

/// Less than this share of the lines of a drawing is not told once more where lines are told one by one that are longer
/// together.
const REST: f32 = 0.05;

/// Whether lines that are told one by one, as gone, open, in pieces or without an end, are all that is left out, but
/// for less than so much, mm, or a small share that is less than what is told.
fn is_told_by_lines(lost: &Lost, least: f32) -> bool {
    let all = lost.gone.iter().chain(&lost.gaps).chain(&lost.torn).chain(&lost.loose);
    let told: f32 = all.map(|line| line.length).sum();
    told > 0.0 && of_lines(lost) - told < least.max(told.min(REST * lost.wanted))
}

/// A text stands beside a line no farther from it than this, mm.
const FARTHEST_TEXT: f32 = 6.0;

/// The texts that stand beside a line that is gone, and beside none that is drawn.
fn beside_gone<'t>(gone: &[&LostLine], drawn: &[Line], texts: &'t [Text]) -> Vec<&'t str> {
    let has_line = |text: &Text| {
        let mut sides = drawn.iter().flat_map(|line| &line.runs).flat_map(|run| run.path().zip(run.path().skip(1)));
        let middle = text.place.center();
        sides.any(|(a, b)| nearest_on_segment(middle, a, b).0 <= FARTHEST_TEXT + 0.5 * text.size)
    };
    let is_beside = |text: &&Text| {
        let near = text.place.inflate(FARTHEST_TEXT, FARTHEST_TEXT);
        let is_near = |line: &&LostLine| near.contains(line.extent.center()) || line.extent.intersects(&text.place);
        text.is_read() && gone.iter().any(is_near) && !has_line(text)
    };
    texts.iter().filter(is_beside).map(|text| text.string.as_str()).collect()
}

/// The texts after which places are named: all but titles, which stand above all lines in larger letters than the texts
/// beside those.
fn of_places(texts: &[Text], drawn: &[Line]) -> Vec<Text> {
    let points = drawn.iter().flat_map(|line| &line.runs).flat_map(|run| run.path());
    let top = points.map(|at| at.y).fold(f32::INFINITY, f32::min);
    let is_above = |text: &Text| text.place.max.y <= top;
    let beside = texts.iter().filter(|text| text.is_read() && !is_above(text));
    let largest = beside.map(|text| text.size).fold(0.0, f32::max);
    let is_title = |text: &Text| is_above(text) && largest > 0.0 && text.size > LARGER * largest;
    texts.iter().filter(|text| !is_title(text)).cloned().collect()
}

/// The letters of a title are so many times as large as any beside the lines, at least.
const LARGER: f32 = 1.1;

/// A line is named after a text that is no farther from it than this, mm: about a cell of a table, or half a room.
const NAMES: f32 = 20.0;

/// The text nearest to a line, as in `, near "Kitchen"`; nothing where there is none near it.
fn near_text(line: &LostLine, texts: &[Text]) -> String {
    let far = |text: &Text| {
        let (of, place) = (line.extent, text.place);
        let across = (place.min.x - of.max.x).max(of.min.x - place.max.x).max(0.0);
        across.hypot((place.min.y - of.max.y).max(of.min.y - place.max.y).max(0.0))
    };
    let near = texts.iter().filter(|text| text.is_read() && far(text) <= NAMES);
    let nearest = near.min_by(|a, b| far(a).total_cmp(&far(b)));
    nearest.map_or_else(String::new, |text| format!(", near {}", named(&[text.string.as_str()])))
}

/// What places are told on.
#[derive(Debug, Clone, Copy)]
struct Places<'a> {
    /// The windows of several sheets.
    windows: Option<&'a SheetWindows>,
    /// What one is called.
    name: &'a str,
}

impl<'a> Places<'a> {
    fn of(layout: &'a Layout) -> Self {
        Self { windows: layout.sheets.as_ref(), name: layout.medium.name_of_sheet() }
    }
}

/// Where on the sheet or display, or on which of several sheets, a line has its middle.
fn around(at: MmPoint, sheets: Places<'_>) -> String {
    format!("around {}", place_from_edges(at, sheets.windows, sheets.name))
}

/// What an open line is, in the words of a page that has it: `a bent line from lower left to upper right, `; nothing of
/// others.
fn kind(line: &LostLine) -> String {
    let Some((form, from_to)) = line.form else { return String::new() };
    match form {
        Form::Level => "a straight level line, ".to_owned(),
        Form::Upright => "a straight upright line, ".to_owned(),
        Form::Slanting => format!("a straight slanting line {from_to}, "),
        Form::Winding => format!("a winding line {from_to}, "),
        Form::Bowed => format!("a bent line {from_to}, "),
        Form::Bent if from_to.is_empty() => "a bent line, ".to_owned(),
        Form::Bent => format!("a bent line {from_to}, "),
    }
}

/// What the maker is told of lines of a drawing of which nothing is on the page; small closed shapes are told as such.
fn told_gone(lost: &Lost, drawn: &[Line], texts: &[Text], sheets: Places<'_>) -> Option<Note> {
    let gone = || lost.gone.iter().filter(|line| !(line.closed && is_small(line.extent)));
    let longest = gone().max_by(|a, b| a.length.total_cmp(&b.length))?;
    let (at, mm) = (longest.extent.center(), longest.length);
    let kind = kind(longest);
    let (lines, which, them) = match gone().count() {
        1 => ("1 line as a whole".to_owned(), kind, "it"),
        count if kind.is_empty() => (format!("{count} lines as a whole"), "the longest ".to_owned(), "them"),
        count => (format!("{count} lines as a whole"), format!("the longest, {kind}"), "them"),
    };
    let beside = beside_gone(&gone().collect::<Vec<_>>(), drawn, texts);
    let named = match beside.len() {
        0 => near_text(longest, texts),
        1 => format!("; the text {} beside it names nothing on the page", named(&beside)),
        _ => format!("; the texts {} beside them name nothing on the page", named(&beside)),
    };
    let why = format!("there is no room for {them} beside other lines");
    let told = format!("{lines} ({which}{mm:.0} mm long, {}){named}: {why}", around(at, sheets));
    let helped = Told::from(told).or_larger().or("say it in a label");
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForLine, helped))
}

/// What the maker is told of closed outlines of a drawing that are open on the page; small ones are told as lost.
fn told_gaps(lost: &Lost, sheets: Places<'_>) -> Option<Note> {
    let longest = lost.gaps.iter().max_by(|a, b| a.length.total_cmp(&b.length))?;
    let (at, mm) = (longest.extent.center(), longest.length);
    let (pieces, which, is_open) = match lost.gaps.len() {
        1 => ("a piece of 1 closed outline".to_owned(), "", "it is open"),
        count => (format!("pieces of {count} closed outlines"), "the longest ", "they are open"),
    };
    let told = format!(
        "{pieces} ({which}{mm:.0} mm long, {}), so that {is_open} on the page: there is no room beside other lines",
        around(at, sheets)
    );
    let helped = Told::from(told).or_larger().or("say it in a label");
    Some(Note::NotOnPage(About::Lines, Reason::OutlineOpen, helped))
}

/// What the maker is told of open lines of a drawing of which pieces are on the page.
fn told_torn(lost: &Lost, texts: &[Text], sheets: Places<'_>) -> Option<Note> {
    let longest = lost.torn.iter().max_by(|a, b| a.length.total_cmp(&b.length))?;
    let (at, mm, near) = (longest.extent.center(), longest.length, near_text(longest, texts));
    let (pieces, which, them, goes_on) = match lost.torn.len() {
        1 => ("a piece of a line whose other pieces are drawn".to_owned(), "", "it", "the line goes on"),
        count => {
            let pieces = format!("{count} pieces of lines whose other pieces are drawn");
            (pieces, "the longest ", "them", "the lines go on")
        }
    };
    let told = format!(
        "{pieces} ({which}{mm:.0} mm long, {}){near}: there is no room for {them} beside other lines",
        around(at, sheets)
    );
    let helped = Told::from(told).or_larger().or(format!("say in a label how {goes_on}"));
    Some(Note::NotOnPage(About::Lines, Reason::LineInPieces, helped))
}

/// What the maker is told of lines that end before the lines that they met in the drawing.
fn told_loose(lost: &Lost, texts: &[Text], sheets: Places<'_>) -> Option<Note> {
    let longest = lost.loose.iter().max_by(|a, b| a.length.total_cmp(&b.length))?;
    let (at, mm, near) = (longest.extent.center(), longest.length, near_text(longest, texts));
    let (ends, which, them, they_lead) = match lost.loose.len() {
        1 => ("the end of 1 line, which stops before the line that it met".to_owned(), "", "it", "it leads"),
        count => {
            let ends = format!("the ends of {count} lines, which stop before the lines that they met");
            (ends, "the longest ", "them", "they lead")
        }
    };
    let told = format!(
        "{ends} ({which}{mm:.0} mm long, {}){near}: there is no room for {them} beside other lines",
        around(at, sheets)
    );
    let helped = Told::from(told).or_larger().or(format!("say in a label where {they_lead}"));
    Some(Note::NotOnPage(About::Lines, Reason::EndsBeforeLine, helped))
}

/// What the maker is told of a squared grid that is left out as a whole.
fn told_gridlines(lost: &Lost) -> Option<Note> {
    (lost.gridlines > 0).then(|| {
        let told = format!("the squared grid, {} lines: pieces of it would be felt as lines", lost.gridlines);
        let helped = Told::from(told).or_larger().or("say the scale in a label");
        Note::NotOnPage(About::Lines, Reason::SquaredGrid, helped)
    })
}

/// What the maker is told of dashed lines.
pub(super) fn told_dashed(edges: &Edges) -> Option<Note> {
    let lines = match edges.dashed {
        0 => return None,
        1 => "1 dashed line: it is".to_owned(),
        count => format!("{count} dashed lines: they are"),
    };
    let told = "drawn without gaps where dashes and gaps are too short for fingers; where the difference matters, say \
                so in the title or a label";
    Some(Note::TakenAs(About::Lines, Reason::Dashed, format!("{lines} {told}").into()))
}

/// What the maker is told of strokes that lie on other ones of another colour, as windows of a plan in its walls.
pub(super) fn told_overlaid(edges: &Edges, layout: &Layout) -> Option<Note> {
    let at = PageTransform::new(edges.size, layout.figure).to_mm(*edges.overlaid.first()?);
    let (strokes, first, them) = match edges.overlaid.len() {
        1 => ("1 stroke lies on a line of another colour".to_owned(), "", "it"),
        count => (format!("{count} strokes lie on lines of other colours"), "the first ", "them"),
    };
    let told = format!(
        "{strokes} ({first}around {}), and fingers cannot tell the two apart; where it matters, as of a window in a \
         wall, say in a label what is there, or draw {them} beside the line or with an outline",
        layout.place_in_words(at)
    );
    Some(Note::TakenAs(About::Lines, Reason::OnOtherLine, told.into()))
}

/// What the maker is told of lines that run beside those that a person drew and added, for half of their length or
/// more: what these were to replace is nearly always such a line.
pub(super) fn told_beside_added(
    added: Option<&HandLines>,
    figure: &[Line],
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let (added, near) = (added?, plan.lines().max_spacing());
    let own = kept_lines::index_of(&drawn_by_hand(added, layout), layout.figure, near);
    let (beside, mm, at) = longest(figure.iter().filter_map(|line| runs_beside(line, &own, near)))?;
    let (lines, run, which) = match beside {
        1 => ("1 line".to_owned(), "runs", ""),
        count => (format!("{count} lines"), "run", "the longest "),
    };
    let told = format!(
        "{lines} ({which}{mm:.0} mm long, {}) {run} beside lines that you drew and added, and may be what these \
         replace: take the lines of the corrected page in place of those that are found, or erase that part",
        around(at, Places::of(layout))
    );
    Some(Note::TakenAs(About::Lines, Reason::BesideAdded, told.into()))
}

/// How many there are, and the length, mm, and the place of the longest, the first of several.
fn longest(of: impl Iterator<Item = (f32, MmPoint)>) -> Option<(usize, f32, MmPoint)> {
    let mut all: Vec<(f32, MmPoint)> = of.collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.first().map(|&(mm, at)| (all.len(), mm, at))
}

/// Those of the lines that are added which a person drew, where the figure lies.
fn drawn_by_hand(added: &HandLines, layout: &Layout) -> Vec<Line> {
    let lines = added.in_place(layout.figure).into_iter();
    lines.filter(|(_, number)| added.name_by_hand(*number).is_some()).map(|(line, _)| line).collect()
}

/// What the maker is told of lines that would be closed and are open beside those that a person drew and added: a piece
/// of them `gave_way` to these, in shares of the width and height of the figure.
pub(super) fn told_opened(
    added: Option<&HandLines>,
    figure: &[Line],
    gave_way: &[[f32; 2]],
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let (added, near) = (added?, plan.lines().max_spacing());
    let own = kept_lines::index_of(&drawn_by_hand(added, layout), layout.figure, near);
    let (from, size) = (layout.figure.min, layout.figure.size());
    let on_page = |[x, y]: &[f32; 2]| MmPoint::new(from.x + x * size.width, from.y + y * size.height);
    let gave_way: Vec<MmPoint> = gave_way.iter().map(on_page).collect();
    let opened = figure.iter().filter_map(|line| opened(line, &own, near)).filter(|gap| was_closed(*gap, &gave_way));
    let (gaps, mm, at) = longest(opened)?;
    let (pieces, which, they_are) = match gaps {
        1 => ("a piece of 1 closed line".to_owned(), "", "it is"),
        count => (format!("pieces of {count} closed lines"), "the longest ", "they are"),
    };
    let told = format!(
        "{pieces} ({which}{mm:.0} mm long, around {}), so that {they_are} open on the page: what is found gives way \
         along lines that are added; draw yours up to it or across, or end it farther off",
        layout.place_in_words(at)
    );
    Some(Note::NotOnPage(About::Lines, Reason::OutlineOpen, told.into()))
}

/// How long the gap of a line that is nearly closed is, mm, and its middle, if both ends lie beside other lines; none
/// of one that lies on them.
fn opened(line: &Line, others: &Nearby, near: f32) -> Option<(f32, MmPoint)> {
    let path = line.own_path();
    let (first, last) = (*path.first()?, *path.last()?);
    let is_within = |at: MmPoint, reach: f32| others.nearest(at, reach, |_| true).is_some();
    let (gap, length) = ((last - first).length(), polyline::length(&path));
    let is_open = !line.is_ring_of_dots() && gap > LEAST_GAP && gap <= FAR_BESIDE * near && length >= RING * gap;
    let are_within = |reach: f32| is_within(first, reach) && is_within(last, reach);
    // with both ends on one of them it is closed by that
    let is_beside = are_within(FAR_BESIDE * near) && !are_within(ON * near);
    let on = path.iter().filter(|at| is_within(**at, ON * near)).count();
    (is_open && is_beside && 2 * on < path.len()).then(|| (gap, first.lerp(last, 0.5)))
}

/// Whether there was something in the middle of a gap of a line before it gave way, such as the piece that closed a
/// ring; a line that was open in the picture, such as a letter C, had nothing there.
fn was_closed((mm, middle): (f32, MmPoint), gave_way: &[MmPoint]) -> bool {
    gave_way.iter().any(|at| (*at - middle).length() <= IN_GAP * mm)
}

/// What lay no farther from the middle of a gap than this, as a share of its length, closed it: a corner that is gone
/// lies half of it away, and the nearest points of its sides 0.35 of it.
const IN_GAP: f32 = 0.4;
/// A line is closed whose ends are no farther apart, mm: dots of a row are up to 2.5 mm apart.
const LEAST_GAP: f32 = 2.6;
/// A line so many times as long as its ends are apart is a closed one with a gap.
const RING: f32 = 5.0;

/// What the maker is told of what is missing of lines that a person drew and added, but for what is `erased`.
pub(super) fn told_cut(
    added: Option<&HandLines>,
    figure: &[Line],
    is_erased: impl Fn(MmPoint) -> bool,
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let (added, profile) = (added.filter(|_| plan.profile().figure.lines)?, plan.profile());
    // those that are too short for the figure are told by themselves
    let mut own = drawn_by_hand(added, layout);
    own.retain(|line| line.length() >= profile.lines.min_length);
    let (all, reach) = (own.iter().map(Line::length).sum::<f32>(), plan.lines().farthest_moved());
    let (mm, at) = kept_lines::missing(&own, figure, layout.figure, reach, |at| !is_erased(at))?;
    let told = format!(
        "{mm:.0} mm of the lines that you drew and added ({}): too near to others or to one another; move them apart, \
         or erase what is found there",
        around(at, Places::of(layout))
    );
    (mm >= least_told(&layout.medium, all)).then_some(Note::NotOnPage(About::Lines, Reason::ShortOrNear, told.into()))
}

/// How long a line is, mm, and its middle, if it runs beside other lines; none of one that lies on them.
fn runs_beside(line: &Line, others: &Nearby, near: f32) -> Option<(f32, MmPoint)> {
    let (mut all, mut beside, mut on, mut points) = (0.0, 0.0, 0.0, Vec::new());
    let sides = line.own_runs().iter().flat_map(|run| run.path().zip(run.path().skip(1)));
    for (a, b) in sides {
        let (length, way) = ((b - a).length(), (b - a).try_normalize().unwrap_or_default());
        let steps = (length / BESIDE_STEP).ceil().max(1.0);
        let is_along =
            |other: &Segment| way.dot((other.b - other.a).try_normalize().unwrap_or_default()).abs() >= ALONG;
        for k in 0..steps as u32 {
            let at = a.lerp(b, (k as f32 + 0.5) / steps);
            points.push(at);
            all += length / steps;
            match others.nearest(at, FAR_BESIDE * near, is_along) {
                Some((distance, ..)) if distance < ON * near => on += length / steps,
                Some(_) => beside += length / steps,
                None => {}
            }
        }
    }
    let middle = points.get(points.len() / 2).copied()?;
    (on < 0.5 * all && beside >= 0.5 * all).then_some((all, middle))
}

/// Lines are looked at this often, mm.
const BESIDE_STEP: f32 = 1.0;
/// Two lines are one nearer than this, and beside one another up to the other, both as shares of the distance at which
/// what is found gives way to what is added. Chosen by us: a person who draws by eye is some mm off.
const ON: f32 = 0.3;
const FAR_BESIDE: f32 = 2.0;

/// What is kept in the page of contours that are not drawn.
pub(super) fn left_out(lost: &Lost, shapes: usize, of_drawing: bool) -> LeftOut {
    let whole = |mm: f32| mm.max(0.0).round() as u32;
    let by_place = Some(lost.by_place.map(whole));
    let millimetres = whole(of_lines(lost));
    let (shapes, of_photograph) = (shapes as u32, !of_drawing);
    LeftOut { millimetres, of: whole(lost.wanted), by_place, shapes, of_photograph, ..LeftOut::default() }
}

/// How much of lines is lost, mm: marks that are too short are told by themselves, and no room would help them.
fn of_lines(lost: &Lost) -> f32 {
    (lost.lost - lost.marks.length).max(0.0)
}

#[cfg(test)]
mod tests;
