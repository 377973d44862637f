//! Texts that a person typed into a page, written in braille beside their places.

use super::kept_lines::LineName;
use super::label::{Label, Position};
use super::texts::Text;
use super::words::{OnPage, Words, WrittenWords};
use crate::braille::Translate;
use crate::labels::WrittenLabel;
use crate::page::cells::CellGrid;
use crate::page::layout::Layout;
use crate::page::{BrailleText, Dots, Parts, TextRole};
use crate::profile::Plan;
use crate::reading::TypedText;
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason};

/// What is told of texts that were typed.
#[derive(Debug, Default)]
pub(super) struct Typed {
    /// What is so wherever they stand.
    pub(super) notes: Vec<Note>,
    /// How they stand on this page.
    pub(super) of_places: Vec<Note>,
    /// That they are labels, where these are placed anew.
    pub(super) as_labels: Option<Note>,
    /// Whether some are abbreviated.
    pub(super) abbreviates: bool,
}

/// Adds the texts to a page as labels, in the code of its language: apart from lines and from the braille that is
/// there, nearest to where they were typed, and Unicode braille in its very place. Tells what has no room, what its
/// code cannot write, what stands elsewhere than it was typed, and what was typed outside the figure, where no labels
/// stand.
///
/// `names` are those of the lines, some of which are interrupted.
pub(super) fn write(
    parts: &mut Parts,
    names: &mut Vec<LineName>,
    texts: &[TypedText],
    plan: &Plan,
    translate: Option<&Translate>,
) -> Typed {
    if texts.is_empty() {
        return Typed::default();
    }
    let (place, medium) = (parts.figure.place, parts.medium.clone());
    let cells = CellGrid::of(&medium, plan.profile().braille.cell);
    let width = |text: &TypedText| cells.extent(text.string.chars().count(), 1).x;
    // a word in print is not as wide as its braille: it names the place of its anchor
    let placed = |text: &TypedText| if text.is_braille { text.from_its_begin(width(text)) } else { text.clone() };
    let texts: Vec<TypedText> = texts.iter().map(placed).collect();
    let label = |text: &TypedText| {
        let [x, y] = Position::in_figure(text.at, place);
        Label { x, y, text: text.string.clone() }
    };
    let (exact, beside): (Vec<&TypedText>, Vec<&TypedText>) = texts.iter().partition(|text| text.is_braille);
    // half a line of braille beside the figure is not far
    let is_outside = |text: &&TypedText| !place.inflate(SLACK, SLACK).contains(text.at);
    // what stands there in the figure is not what was meant
    let in_order = beside.iter().chain(&exact).enumerate();
    let nameless: Vec<usize> = in_order.filter(|(_, text)| is_outside(text)).map(|(number, _)| number).collect();
    let labels: Vec<Label> = beside.into_iter().map(label).collect();
    let exact: Vec<Text> = exact.into_iter().map(|text| in_place(text, &cells)).collect();
    let outside: Vec<&TypedText> = texts.iter().filter(is_outside).collect();
    let (language, own_texts) = (parts.language.clone(), !exact.is_empty());
    let blocked = blocked(parts);
    let written = written_labels(parts);
    let words = Words {
        written: &written,
        language: Some(&language),
        labels: &labels,
        own_texts,
        translate,
        blocked: &blocked,
        nameless: &nameless,
        ..Words::default()
    };
    let written = WrittenWords::new(&words, plan);
    let layout = Layout::of_figure(parts.sheet, place, medium);
    let OnPage { mut braille, notes, counts, lines, .. } = written.on(&layout, &mut parts.figure, &exact, &words, plan);
    *names = lines.into_iter().map(|line| names[line].clone()).collect();
    braille.retain(|text| text.role == TextRole::Label);
    let elsewhere = elsewhere(&exact, &braille);
    let (count, in_braille) = (braille.len(), exact.len().min(braille.len()));
    let led = braille.iter().filter(|text| text.leader.is_some()).count();
    parts.braille.extend(braille);
    let notes = written.notes().iter().cloned().chain(notes);
    // they are told last of those of places
    let (abbreviated, notes): (Vec<Note>, Vec<Note>) = notes.partition(|note| matches!(note, Note::Abbreviated(_)));
    let (of_labels, notes): (Vec<Note>, Vec<Note>) = notes.into_iter().partition(is_of_place);
    let of_places = told(count - in_braille, led, in_braille).into_iter().chain(elsewhere).chain(of_labels);
    let of_places = of_places.chain(abbreviated).collect();
    let notes = typed_outside(&outside).into_iter().chain(notes).collect();
    Typed { notes, of_places, as_labels: told_as_labels(count), abbreviates: counts.abbreviated > 0 }
}

/// Whether a note tells how labels stand, and not that they are left out.
fn is_of_place(note: &Note) -> bool {
    let of_labels = matches!(note, Note::TakenAs(About::Braille | About::Leaders, ..));
    // what has less texture beside a label here may have more there
    of_labels || matches!(note, Note::NotOnPage(About::Areas, Reason::UnderLabel, _))
}

/// Tells how many texts are labels, of a page on which these are placed anew.
fn told_as_labels(count: usize) -> Option<Note> {
    let told = match count {
        1 => "1 text that was typed is taken as a label in braille".to_owned(),
        _ => format!("{count} texts that were typed are taken as labels in braille"),
    };
    (count > 0).then_some(Note::TakenAs(About::Texts, Reason::TypedAsLabel, told.into()))
}

/// Tells how many texts are written, beside where they were typed and in their very places, and how many have a leader
/// line to where they were typed.
fn told(written: usize, led: usize, in_place: usize) -> Vec<Note> {
    let with_leader = match led {
        0 => String::new(),
        1 if written == 1 => ", with a leader line to it".to_owned(),
        1 => ", 1 of them with a leader line to where it was typed".to_owned(),
        _ => format!(", {led} of them with leader lines to where they were typed"),
    };
    let beside = match written {
        0 => None,
        1 => Some(format!("1 text that was typed is written in braille beside its place{with_leader}")),
        _ => Some(format!("{written} texts that were typed are written in braille beside their places{with_leader}")),
    };
    let in_place = match in_place {
        0 => None,
        1 => Some("1 text that was typed in braille: written as typed".to_owned()),
        _ => Some(format!("{in_place} texts that were typed in braille: written as typed")),
    };
    let beside = beside.map(|told| Note::TakenAs(About::Texts, Reason::WrittenBeside, told.into()));
    let in_place = in_place.map(|told| Note::TakenAs(About::Texts, Reason::WrittenAsTyped, told.into()));
    beside.into_iter().chain(in_place).collect()
}

/// Tells of texts that were typed outside of the figure.
fn typed_outside(outside: &[&TypedText]) -> Option<Note> {
    let first = outside.first()?;
    let (string, at) = (&first.string, first.at);
    let texts = match outside.len() {
        1 => format!("the text \"{string}\" at {:.0}, {:.0} mm lies", at.x, at.y),
        count => format!("{count} typed texts, the first \"{string}\" at {:.0}, {:.0} mm, lie", at.x, at.y),
    };
    let told = format!("{texts} outside the figure, and labels stand in it: taken as typed at its edge");
    Some(Note::TakenAs(About::Texts, Reason::TypedOutside, told.into()))
}

/// Unicode braille as it was typed: its cells stand on the line on which its letters do.
fn in_place(text: &TypedText, cells: &CellGrid<'_>) -> Text {
    let size = cells.extent(text.string.chars().count(), 1);
    let corner = MmPoint::new(text.at.x, text.at.y - size.y);
    let place = MmRect::new(corner, corner + size);
    Text {
        string: text.string.clone(),
        place,
        angle: 0.0,
        size: size.y,
        hidden: false,
        lost_leader: None,
        kept_leader: None,
        of_legend: false,
        of_sign: None,
    }
}

/// Tells of Unicode braille that stands elsewhere than it was typed.
fn elsewhere(exact: &[Text], braille: &[BrailleText]) -> Option<Note> {
    // dots of a grid lie up to half of its step off
    const NEAR: f32 = 2.0;
    let far = |text: &&Text| {
        let of_text =
            braille.iter().filter(|written| written.text == text.string).filter_map(|written| written.dots.bounds());
        // only dots that are raised are in that box
        let is_near = |dots: MmRect| text.place.inflate(NEAR, NEAR).contains_box(&dots);
        let mut of_text = of_text.peekable();
        of_text.peek().is_some() && !of_text.any(is_near)
    };
    let far: Vec<String> = exact.iter().filter(far).map(|text| format!("\"{}\"", text.string)).collect();
    let why =
        "stands beside the place where it was typed, as that is too near to lines, to other braille or to the edge";
    (!far.is_empty())
        .then(|| Note::TakenAs(About::Texts, Reason::BrailleMoved, format!("braille {} {why}", far.join(", ")).into()))
}

/// How far from the figure a text may be typed without being told, mm.
const SLACK: f32 = 5.0;

/// The labels that are on the page.
fn written_labels(parts: &Parts) -> Vec<WrittenLabel> {
    let labels = parts.braille.iter().filter(|text| text.role == TextRole::Label && text.lines.len() == 1);
    let cell = |sign: char| u32::from(sign).checked_sub(u32::from('\u{2800}')).and_then(|cell| u8::try_from(cell).ok());
    labels
        .filter_map(|label| {
            let cells = label.lines[0].chars().map(cell).collect::<Option<Vec<u8>>>()?;
            Some(WrittenLabel { text: label.text.clone(), abbreviation: label.abbreviation.clone(), cells })
        })
        .collect()
}

/// Boxes around braille that is on the page, and along the leader lines of its labels.
fn blocked(parts: &Parts) -> Vec<MmRect> {
    let dots = parts.braille.iter().map(|text| &text.dots).chain(&parts.labels);
    let leaders = parts.braille.iter().filter_map(|text| text.leader.as_ref());
    let points: Vec<Vec<MmPoint>> = leaders.map(|leader| leader.path().collect()).collect();
    let pieces = points.iter().flat_map(|points| points.windows(2)).flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        let count = ((to - from).length() / PIECE).ceil().max(1.0);
        let at = move |step: u32| from.lerp(to, step as f32 / count);
        (0..count as u32).map(move |step| MmRect::from_points([at(step), at(step + 1)]))
    });
    dots.filter_map(Dots::bounds).chain(pieces).collect()
}

/// Length of the pieces of a leader line around which boxes lie, mm: the box of a slanted one is much wider than it.
const PIECE: f32 = 2.0;
