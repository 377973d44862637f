//! Labels in braille: each beside what it names, apart from lines and from one another.
//!
//! ```text
//! wanted -> forms (one line, two, abbreviated) -> groups -> rows (as a whole) -> titles of axes -.
//!                                            `-> candidates (free places near the anchor) ------+-> choose -> placed
//! ```
//!
//! The steps up to the titles of axes ([`place_rows_first`]) are also those of `predicted`, which computes the room
//! that rows and columns need beside a drawing before it is laid out.
//!
//! Labels are horizontal, as fingers read them, and 3 mm from lines; textures and gridlines make room for them.
//! One that has to lie further away than 12 mm has a leader line. What has no room in full is abbreviated.

mod abbreviate;
mod angles;
mod attached;
mod before;
mod candidates;
mod choose;
mod columns;
mod context;
mod cost;
mod cut_textures;
mod forms;
mod groups;
mod interrupted;
mod letters;
mod levels;
mod named_points;
mod placed;
mod predicted;
mod room;
mod rows;
mod scale;
mod sectors;
mod sentence;
mod shape;
mod spacing;
mod surroundings;
mod ticks;
mod titles;

use std::collections::BTreeSet;

pub(crate) use attached::FROM_KEPT_LEADER;
pub use choose::{Choice, choose};
pub use forms::LONGEST;
pub use placed::{Attachment, Params, Placed, PlacedAs, Unplaced, Wanted, WrittenLabel};
pub use predicted::{RowPrediction, row_overhang};
pub use scale::{EVERY, is_number, off_scale};
pub use surroundings::NEAR;

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::braille::Translator;
use crate::page::Figure;
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect};
use candidates::Candidate;
use forms::{Form, FormKind, Forms};
use groups::Group;
use named_points::SmallRing;
use room::Room;
use scale::Alone;
use spacing::Spacing;
use surroundings::{AROUND_RING, LabelsAt, Surroundings};

/// Most labels of a page. Chosen by us: a sheet of A3 has room for some 150, and looking for places takes its time.
pub const MOST: usize = 300;

/// The narrower spacing is taken if all labels together then lie nearer to their anchors by at least this, mm: in a row
/// under the bars of a chart each is below its bar.
const WORTH_LESS_BLANK: f32 = 8.0;

/// A small ring that the page lacks was on a line if one is so near, mm: lines are seldom moved by more.
const OFF_LINE: f32 = 3.0;

/// How often labels are moved a little, each to the best place that is free: the places that are chosen from are some
/// mm apart. A row of five that stand a little too near together needs three rounds.
const ROUNDS: usize = 6;

/// The labels in the order in which they were wanted, each with its place or the reason why it has none.
pub fn place(
    wanted: &[Wanted],
    translator: &Translator<'_>,
    figure: &Figure,
    cells: &CellGrid<'_>,
    params: &Params,
) -> Vec<Result<Placed, Unplaced>> {
    let (wanted, too_many) = wanted.split_at(wanted.len().min(MOST));
    let room = Room::new(&figure.lines, &figure.textures, params);
    let wanted = &levels::at_their_lines(wanted, &room)[..];
    let RowsPlaced { forms, around, placed: in_rows, thinned, titles, .. } =
        place_rows_first(wanted, translator, cells, &room, params);
    let step = candidates::step(wanted.len(), params);
    let candidates_of = |(number, in_row): (usize, Option<Candidate>)| match (in_row, &forms[number]) {
        (Some(in_row), _) => vec![in_row],
        (None, Ok(_)) if thinned[number].is_some() || titles.contains(&number) => Vec::new(),
        (None, Ok(forms)) => candidates::of(&wanted[number], &forms.forms, &around[number], cells, step),
        (None, Err(_)) => Vec::new(),
    };
    let candidates: Vec<Vec<Candidate>> = in_rows.into_par_iter().enumerate().map(candidates_of).collect();
    let choose_from = |candidates: Vec<Vec<Candidate>>| {
        let (chosen, spacing) = chosen_of(&candidates, &forms, cells, params.leader_off, (wanted, &room));
        ChosenPlaces { candidates, chosen, spacing }
    };
    let all = choose_from(candidates);
    // a name leaves its sector if it takes no place there, and no whole word, from another
    let lost = |of: &ChosenPlaces| loss(&of.chosen, &of.candidates, &forms).lost;
    let sparing = candidates::sparing(&all.candidates).map(&choose_from);
    let places = all.or_if(sparing, |sparing, all| lost(sparing) <= lost(all));
    let alike = alike(&places.chosen, &places.candidates, &forms, wanted).map(&choose_from);
    let ChosenPlaces { candidates, chosen, spacing } =
        places.or_if(alike, |alike, places| alike.count() >= places.count());
    let chosen = chosen.into_iter().zip(candidates);
    let mut chosen: Vec<Option<Candidate>> =
        chosen.map(|(chosen, mut of)| chosen.map(|number| of.swap_remove(number))).collect();
    move_nearer(&mut chosen, wanted, &forms, &around, cells, spacing);
    let placed = forms.into_iter().zip(chosen).zip(thinned).map(|((forms, chosen), thinned)| match thinned {
        Some(every) => Err(Unplaced::Thinned(every)),
        None => placed(forms?, chosen),
    });
    placed.chain(too_many.iter().map(|_| Err(Unplaced::TooMany))).collect()
}

/// The places that labels take.
struct ChosenPlaces {
    /// From which places each label has one.
    candidates: Vec<Vec<Candidate>>,
    /// Which of them it takes, if any.
    chosen: Vec<Option<usize>>,
    /// How much blank is kept between labels.
    spacing: Spacing,
}

impl ChosenPlaces {
    /// Those of `other` candidates instead, if they are no worse than these.
    fn or_if(self, other: Option<Self>, is_no_worse: impl Fn(&Self, &Self) -> bool) -> Self {
        match other {
            Some(other) if is_no_worse(&other, &self) => other,
            _ => self,
        }
    }

    /// How many labels have a place.
    fn count(&self) -> usize {
        self.chosen.iter().flatten().count()
    }
}

/// Labels of which those in rows and columns have their places.
struct RowsPlaced<'a> {
    wanted: &'a [Wanted],
    cells: &'a CellGrid<'a>,
    room: &'a Room,
    params: &'a Params,
    /// What each can be written as.
    forms: Vec<Result<Forms, Unplaced>>,
    /// What lies around what each names.
    around: Vec<Surroundings<'a>>,
    /// The place of each that stands in a row or column, or is the title of one.
    placed: Vec<Option<Candidate>>,
    /// Of numbers along an axis that are left out as there is no room for all, every how many-th is written.
    thinned: Vec<Option<i64>>,
    /// Titles of upright axes, which stand above those or nowhere.
    titles: Vec<usize>,
}

impl RowsPlaced<'_> {
    fn context(&self) -> context::Context<'_> {
        let Self { wanted, cells, room, params, forms, around, .. } = self;
        context::Context { wanted, forms, around, room, params, cells }
    }
}

/// Writes labels in their forms and places those in rows and columns with their titles: what placing all of them and
/// predicting their room begin with.
fn place_rows_first<'a>(
    wanted: &'a [Wanted],
    translator: &Translator<'_>,
    cells: &'a CellGrid<'a>,
    room: &'a Room,
    params: &'a Params,
) -> RowsPlaced<'a> {
    let texts: Vec<&str> = wanted.iter().map(|label| label.text.as_str()).collect();
    let mut forms = forms_of(&texts, translator, params);
    let mut around = around(wanted, &forms, room, cells, params);
    let (groups, of_tables) = groups_of(wanted, &mut forms, &around, translator);
    of_tables.into_iter().for_each(|label| around[label].is_in_table = true);
    // numbers at an axis stand in squares of its grid, and are of its lines
    let on_axes = groups.iter().filter(|group| group.steps.is_some()).flat_map(|group| &group.members);
    on_axes.for_each(|&label| around[label].cell = None);
    let scales = groups.iter().filter(|group| group.steps.is_some());
    scales.for_each(|group| group.members.iter().for_each(|&label| around[label].scale = Some(group.lies)));
    let is_alone = |label: usize| !groups.iter().any(|group| group.members.contains(&label));
    let reach: Vec<f32> = forms.iter().map(|of| longest(of, cells, params)).collect();
    before::look(&mut around, wanted, is_alone, &reach);
    sectors::look(&mut around, wanted);
    let (placed, thinned, titles) = (Vec::new(), Vec::new(), Vec::new());
    let mut rows = RowsPlaced { wanted, cells, room, params, forms, around, placed, thinned, titles };
    let rows::InRows { mut placed, thinned } = rows::placed(&groups, &rows.context());
    rows.titles = titles::place(&groups, &rows.context(), &mut placed);
    rows.placed = placed;
    rows.thinned = thinned;
    rows
}

/// What each text can be written as on this page.
fn forms_of(texts: &[&str], translator: &Translator<'_>, params: &Params) -> Vec<Result<Forms, Unplaced>> {
    let mut forms = forms::of(texts, &params.written, translator);
    // on a pin display, where leader lines may not cross others, few cells have room
    if !params.may_cross {
        forms::without_splinters(&mut forms);
    }
    forms
}

/// Points of what ticks of axes will be longer by than in the drawing, so that they are `least` mm long.
fn longer_ticks(
    wanted: &[Wanted],
    translator: &Translator<'_>,
    cells: &CellGrid<'_>,
    room: &Room,
    params: &Params,
    least: f32,
) -> Vec<MmPoint> {
    let texts: Vec<&str> = wanted.iter().map(|label| label.text.as_str()).collect();
    let mut forms = forms_of(&texts, translator, params);
    let around = around(wanted, &forms, room, cells, params);
    ticks::longer(&groups_of(wanted, &mut forms, &around, translator).0, wanted, room, least)
}

/// Length of the longest form of a label, mm, at most all that there is.
fn longest(forms: &Result<Forms, Unplaced>, cells: &CellGrid<'_>, params: &Params) -> f32 {
    let forms = forms.iter().flat_map(|forms| &forms.forms);
    forms.map(|form| form.extent(cells).x).fold(0.0, f32::max).min(params.area.width())
}

/// What lies around what each label names.
fn around<'a>(
    wanted: &[Wanted],
    forms: &[Result<Forms, Unplaced>],
    room: &'a Room,
    cells: &CellGrid<'_>,
    params: &'a Params,
) -> Vec<Surroundings<'a>> {
    // one in the blank is told by the name that stands in its place
    let is_on_line = |at: &&MmPoint| room.line_beside(MmRect::new(**at, **at), OFF_LINE, OFF_LINE).is_some();
    let missing = params.points.iter().filter(is_on_line).map(|&at| named_points::missing(at));
    let rings: Vec<_> = room.rings().iter().copied().chain(missing).collect();
    let is_seen = |text: MmPoint, ring: &SmallRing| !room.is_parted(text, ring.at, ring.reach + AROUND_RING);
    let anchors = named_points::anchors(wanted, &rings, is_seen);
    let labels = LabelsAt { wanted, anchors: &anchors };
    let around = |(number, forms)| Surroundings::of(number, labels, longest(forms, cells, params), room, params);
    forms.iter().enumerate().map(around).collect()
}

/// Which labels stand in rows and columns; those of rows may be written as single letters too. Then which stand in the
/// cells of a table.
fn groups_of(
    wanted: &[Wanted],
    forms: &mut [Result<Forms, Unplaced>],
    around: &[Surroundings<'_>],
    translator: &Translator<'_>,
) -> (Vec<Group>, BTreeSet<usize>) {
    // names of points, such as towns, are no row though some stand at one height; numbers along a line of points are
    let names_point = |label: usize| {
        let Wanted { text, anchor, .. } = &wanted[label];
        around[label].is_point() && !anchor.is_empty() && !scale::is_number(text)
    };
    let is_written = |label: usize| forms[label].is_ok() && !wanted[label].is_nameless && !names_point(label);
    let is_at_line = |label: usize| levels::is_at_line(wanted[label].anchor, around[label].room);
    let mut groups = groups::of(wanted, is_written, |label| around[label].is_at_lower_side(), is_at_line);
    // each word of a table has a cell of its own, and need not be shorter for one that is too long for its
    let is_of_table = |group: &Group| group.is_of_table(wanted, |label| around[label].cell);
    let of_tables: BTreeSet<usize> =
        groups.iter().filter(|group| is_of_table(group)).flat_map(|group| group.members.clone()).collect();
    groups.retain(|group| !is_of_table(group));
    letters::add(&mut groups, forms, wanted, translator);
    letters::add_bare(&groups, forms, wanted, translator);
    letters::add_to_alone(of_tables.iter().copied(), forms, wanted, translator);
    // a number of an axis is whole or not there: shortened, it is none; one in a table may be read as that of an axis
    let is_axis = |group: &&Group| {
        let is_long = group.members.len() >= groups::OF_AN_AXIS && group.steps.is_some();
        is_long && group.members.iter().any(|&label| around[label].cell.is_none())
    };
    for &label in groups.iter().filter(is_axis).flat_map(|group| &group.members) {
        if let Ok(of) = &mut forms[label] {
            of.forms.retain(|form| form.kind != FormKind::Short);
        }
    }
    (groups, of_tables)
}

/// The candidates where some labels of one text are abbreviated and others are not, with those abbreviated too: two
/// words for one thing would be two things. None where there are no such labels, or one of them has no such place.
fn alike(
    chosen: &[Option<usize>],
    candidates: &[Vec<Candidate>],
    forms: &[Result<Forms, Unplaced>],
    wanted: &[Wanted],
) -> Option<Vec<Vec<Candidate>>> {
    let is_short = |label: usize, candidate: &Candidate| {
        forms[label].as_ref().is_ok_and(|of| of.forms[candidate.form].abbreviation.is_some())
    };
    let texts = |short: bool| -> BTreeSet<&str> {
        let of = (0..wanted.len())
            .filter(|&label| chosen[label].is_some_and(|number| is_short(label, &candidates[label][number]) == short));
        of.map(|label| wanted[label].text.as_str()).collect()
    };
    let (short, whole) = (texts(true), texts(false));
    let mixed: Vec<&&str> = short.intersection(&whole).collect();
    if mixed.is_empty() {
        return None;
    }
    let mut alike = candidates.to_vec();
    for (label, of) in alike.iter_mut().enumerate() {
        if mixed.iter().any(|text| ***text == wanted[label].text) && !of.is_empty() {
            of.retain(|candidate| is_short(label, candidate));
            if of.is_empty() {
                return None;
            }
        }
    }
    Some(alike)
}

/// Which candidate each label takes, if any, and how much blank is kept between them: less where labels would be lost
/// otherwise, or lie much further away.
fn chosen_of(
    candidates: &[Vec<Candidate>],
    forms: &[Result<Forms, Unplaced>],
    cells: &CellGrid<'_>,
    leader_off: f32,
    (wanted, room): (&[Wanted], &Room),
) -> (Vec<Option<usize>>, Spacing) {
    let costs: Vec<Vec<f32>> =
        candidates.iter().map(|of| of.iter().map(|candidate| candidate.cost).collect()).collect();
    let (alone, narrow) = (read_alone(wanted), Spacing::narrow(cells));
    let chosen_with = |spacing: Spacing| {
        let of = |choice: Choice| &candidates[choice.label][choice.candidate];
        let chosen = choose(&costs, &|a, b| {
            let (spacing, are_apart) = spacing.between([alone[a.label], alone[b.label]], narrow);
            of(a).conflicts(of(b), spacing, leader_off, (!are_apart).then_some(room))
        });
        (loss(&chosen, candidates, forms), chosen, spacing)
    };
    let (wide, narrow) = (chosen_with(Spacing::wide(cells)), chosen_with(narrow));
    let is_better =
        narrow.0.lost < wide.0.lost || narrow.0.lost == wide.0.lost && narrow.0.cost + WORTH_LESS_BLANK < wide.0.cost;
    let mut best = if is_better { narrow } else { wide };
    if best.0.lost > (0, 0) {
        let tight = chosen_with(Spacing::tight(cells));
        if tight.0.lost < best.0.lost {
            best = tight;
        }
    }
    // rather an abbreviation than two texts that are read as two lines of one
    if best.0.lost.0 > 0 {
        let least = chosen_with(Spacing::least(cells));
        if least.0.lost.0 < best.0.lost.0 {
            best = least;
        }
    }
    (best.1, best.2)
}

/// Which labels may stand nearer to others of their kind, such as numbers.
fn read_alone(wanted: &[Wanted]) -> Vec<Option<Alone>> {
    wanted.iter().map(|label| Alone::of(&label.text)).collect()
}

/// What a choice of places costs.
struct Loss {
    /// Labels without a place, then texts that are abbreviated or led to across lines.
    lost: (usize, usize),
    /// How far labels lie away, mm.
    cost: f32,
}

fn loss(chosen: &[Option<usize>], candidates: &[Vec<Candidate>], forms: &[Result<Forms, Unplaced>]) -> Loss {
    let of = |(label, chosen): (usize, &Option<usize>)| Some((label, &candidates[label][(*chosen)?]));
    let placed: Vec<(usize, &Candidate)> = chosen.iter().enumerate().filter_map(of).collect();
    let is_short = |(label, candidate): &&(usize, &Candidate)| {
        let form = forms[*label].as_ref().ok().and_then(|of| of.forms.get(candidate.form));
        candidate.attachment.crosses() || form.is_some_and(|form| form.abbreviation.is_some())
    };
    let cost = placed.iter().map(|(_, candidate)| candidate.cost).sum();
    Loss { lost: (chosen.len() - placed.len(), placed.iter().filter(is_short).count()), cost }
}

/// Moves each label to the best place nearby that is free of the others.
fn move_nearer(
    chosen: &mut [Option<Candidate>],
    wanted: &[Wanted],
    forms: &[Result<Forms, Unplaced>],
    around: &[Surroundings<'_>],
    cells: &CellGrid<'_>,
    spacing: Spacing,
) {
    let (alone, narrow) = (read_alone(wanted), Spacing::narrow(cells));
    for _ in 0..ROUNDS {
        let mut changed = false;
        for number in 0..chosen.len() {
            let (Some(now), Ok(of)) = (&chosen[number], &forms[number]) else { continue };
            if now.is_fixed() {
                continue;
            }
            let (off, room) = (around[number].leader_off(), around[number].room);
            let conflicts = |found: &Candidate, other: usize| {
                let (spacing, are_apart) = spacing.between([alone[number], alone[other]], narrow);
                let room = (!are_apart).then_some(room);
                chosen[other].as_ref().is_some_and(|of| other != number && found.conflicts(of, spacing, off, room))
            };
            let is_free = |found: &Candidate| !(0..chosen.len()).any(|other| conflicts(found, other));
            let form = &of.forms[now.form];
            if let Some(better) = candidates::better(&wanted[number], form, now, &around[number], cells, is_free) {
                chosen[number] = Some(better);
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
}

fn placed(forms: Forms, chosen: Option<Candidate>) -> Result<Placed, Unplaced> {
    let Forms { mut forms, lacking } = forms;
    let candidate = chosen.ok_or(Unplaced::NoRoom)?;
    let Form { lines, abbreviation, kind, .. } = forms.swap_remove(candidate.form);
    Ok(Placed {
        place: candidate.place,
        lines,
        lacking,
        abbreviation,
        attachment: candidate.attachment,
        stands: candidate.stands,
        is_bare: kind == FormKind::Bare,
    })
}

/// What labels change of a figure.
#[derive(Debug)]
pub struct MadeRoom {
    /// Of each line that is there now, which line it was, or was a part of.
    pub lines: Vec<usize>,
    /// For each texture of which none is left, which of the labels stand in its place.
    pub without_texture: Vec<Vec<usize>>,
    /// The same for each of which less than two thirds are left.
    pub with_less_texture: Vec<Vec<usize>>,
}

/// A texture of which less than this share is left is told of: an area of which a half is blank, such as that on one
/// side of a river, seems to be two.
const WITHOUT_A_THIRD: f32 = 2.0 / 3.0;

/// Takes the glyphs out of a figure that labels and their leader lines need blank, and interrupts gridlines.
pub fn make_room(figure: &mut Figure, placed: &[&Placed], params: &Params) -> MadeRoom {
    let lines = interrupted::interrupt(&mut figure.lines, placed, params);
    let (mut gone, mut cut) = (Vec::new(), Vec::new());
    figure.textures.retain_mut(|texture| {
        let before = texture.clone();
        cut_textures::make_room(texture, placed, params);
        let left = texture.glyphs.len();
        if (left as f32) < WITHOUT_A_THIRD * before.glyphs.len() as f32 {
            let labels = cut_textures::labels_in(&before, placed, params);
            let told = if left == 0 { &mut gone } else { &mut cut };
            told.extend((!labels.is_empty()).then_some(labels));
        }
        left > 0
    });
    MadeRoom { lines, without_texture: gone, with_less_texture: cut }
}
