//! From bytes to a page: the only module that names every stage.
//!
//! A stage whose result the page does not need does not run; the caller is told which, and why.

mod adapt;
mod areas;
mod areas_of_colours;
mod areas_of_overview;
mod bar_rows;
mod bars;
pub mod colours;
mod cut_contours;
mod decisions;
mod dots;
mod draw;
mod drawn_areas;
mod figure_lines;
mod find_edges;
mod finish;
mod for_words;
mod given;
mod hand_lines;
mod joined_bars;
mod kept_lines;
mod key;
mod label;
mod label_params;
mod leaders;
mod legend;
mod legend_column;
mod legend_frames;
mod legend_patches;
mod line_legend;
mod lines_of_part;
mod links_of_overview;
mod lost_colours;
mod lost_marks;
mod lost_signs;
mod margins;
mod misread;
mod named;
mod narrower_bars;
mod next_cell;
mod on_sheet;
mod open_rings;
mod outlines;
mod overview;
mod overview_for_words;
mod paper_edge;
mod print_words;
mod progress;
mod read;
mod read_key;
mod redraw;
mod remarks;
mod request;
mod series;
pub mod sheets;
mod sign_legend;
mod small_areas;
mod subject;
mod text_reader;
mod texts;
mod textures;
mod thing_of_overview;
mod told_bars;
mod told_drawn;
mod told_given;
mod told_labels;
mod told_lines;
mod told_signs;
mod too_near;
mod torn_lines;
pub mod trace;
mod typed;
mod unwritten;
mod words;

pub use adapt::{Adapted, AsRendered, as_felt, as_rendered, with_strokes_as_dots};
pub use drawn_areas::areas_of;
pub use finish::{is_made, title_of_key, title_of_overview};
pub use given::{Given, GivenLines};
pub use hand_lines::HandLines;
pub use kept_lines::LineName;
pub use key::{Key, KeySheets};
pub use label::{Label, Position};
pub use progress::{Event, Progress, Stage, Watch, run_stage};
pub use read_key::{KeyWanted, key_of_page};
pub use redraw::{OldPage, dots_left_out};
pub use request::{Fit, Request};
pub use text_reader::TextReader;
pub use texts::Text;
pub use told_given::told_no_lines;
pub use words::Words;

use std::cell::Cell;

use crate::braille::Translate;
use crate::lines::Line;
use crate::page::layout::Layout;
use crate::page::{BrailleText, Dots, Figure, InSet, Medium, Overview, Page, Parts, TextRole, frame};
use crate::picture::Picture;
use crate::units::{MmRect, Size};
use crate::{Error, Note};
use draw::{DrawnMarks, FromPerson, WithRoom, draw, find};
use finish::{PageSays, finished, origin};
use for_words::ForWords;
use read::ReadPicture;
use remarks::{FinishedSheets, Remarks};
use request::OverviewSize;
use told_labels::LabelCounts;
use words::{OnPage, WrittenWords};

/// A page and what its maker should know.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Drawing {
    /// The finished page. Where an overview has a page of its own, as on devices of dots, this is the figure alone:
    /// [`Drawing::into_pages`] gives all.
    pub page: Page,
    /// Of a page of dots, the overview, which follows on a sheet of its own.
    pub overview: Option<Page>,
    /// The key, which follows on sheets of its own: the colours that occur and abbreviations.
    pub key: Vec<Page>,
    /// Texts, which are not drawn unless asked for: those of an SVG drawing or a page of PDF in the order in which they
    /// are painted, then those that were found in the pixels of the picture.
    pub texts: Vec<Text>,
    /// Remarks, first what makes the page wrong or lacks on it.
    pub notes: Vec<Note>,
    /// Whether the figure would be larger on the same sheet without the overview, which is what helps most where
    /// something has no room in it.
    pub is_larger_without_overview: bool,
    /// Whether the figure would be larger on the same sheet lying across, which the device takes.
    pub is_larger_turned: bool,
}

impl Drawing {
    /// A page whose words alone were written anew, with its key.
    pub(crate) fn of_key(page: Page, key: Vec<Page>, notes: Vec<Note>) -> Self {
        let (overview, texts) = (None, Vec::new());
        Self { page, overview, key, texts, notes, is_larger_without_overview: false, is_larger_turned: false }
    }

    /// All sheets in the order in which they are numbered: the page, the overview if it has a sheet of its own, the
    /// key.
    pub fn all(&self) -> impl Iterator<Item = &Page> {
        std::iter::once(&self.page).chain(&self.overview).chain(&self.key)
    }

    /// The same sheets as [`write_pdf`](crate::write_pdf) and [`write_dots`](crate::write_dots) take them.
    #[must_use]
    pub fn into_pages(self) -> Vec<Page> {
        std::iter::once(self.page).chain(self.overview).chain(self.key).collect()
    }
}

/// A page, and what is asked of its labels where one of two pages is chosen.
struct Composed {
    drawing: Drawing,
    labels: LabelCounts,
}

impl Composed {
    /// How many labels stand in the figure with all their letters.
    fn whole_labels(&self) -> usize {
        let labels = self.drawing.page.braille.iter().filter(|text| text.role == TextRole::Label).count();
        labels.saturating_sub(self.labels.abbreviated)
    }
}

/// Makes the page of a picture. `watch` is told of every stage.
///
/// # Errors
/// When no page can be made at all; see [`Error`].
pub fn convert<'p>(
    picture: impl Into<Picture<'p>>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Drawing, Error> {
    convert_with_words(picture, &Words::default(), &Given::default(), request, watch)
}

/// As [`convert`], with words in braille, and with what a person gives beside the picture. A drawing, such as a
/// table, whose words have no room beside its overview has none, if nobody asked for one.
///
/// # Errors
/// As [`convert`].
pub fn convert_with_words<'p>(
    picture: impl Into<Picture<'p>>,
    words: &Words<'_>,
    given: &Given,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Drawing, Error> {
    let picture = picture.into();
    let Composed { drawing, labels } = convert_as_asked(picture, words, given, request, watch)?;
    let may_go = words.own_texts && drawing.is_larger_without_overview && !overview_for_words::is_asked(request.plan);
    if !may_go || !overview_for_words::lack(labels, &drawing.texts) {
        return Ok(drawing);
    }
    let plan = overview_for_words::plan_without(request.plan)?;
    // stages are told of once
    let without = convert_as_asked(picture, words, given, &request.with_plan(&plan), &mut |_| ())?;
    let Some(told) = overview_for_words::told(labels, without.labels) else { return Ok(drawing) };
    let mut without = without.drawing;
    without.notes.push(told);
    Note::sort(&mut without.notes);
    Ok(without)
}

/// The page of a picture as the request is.
fn convert_as_asked<'p>(
    picture: Picture<'p>,
    words: &Words<'_>,
    given: &Given,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Composed, Error> {
    let person = FromPerson { given, words };
    let written = WrittenWords::new(words, request.plan);
    let layout_of = |size: Size, overview: OverviewSize| written.layout(size, overview, request);
    let was_narrowed = Cell::new(false);
    let with_room =
        |drawing: &margins::Lettered<'_>, layout: Layout, layout_of: &dyn Fn(Size) -> Result<Layout, Error>| {
            let own = layout.figure;
            let narrowed = margins::with_room(drawing, words, &written, request.plan, layout, layout_of);
            was_narrowed.set(narrowed.figure != own);
            narrowed
        };
    let marks = |picture: ReadPicture<'p>, with_room: &WithRoom<'_>, watch: &mut Watch<'_>| {
        draw(find(picture, person, request, &layout_of, with_room, watch)?, given, request, watch)
    };
    let picture = ReadPicture::of(picture, given, request, &layout_of, watch)?;
    let again = (words.own_texts && picture.has_texts()).then(|| picture.clone());
    let narrowed = marks(picture, &with_room, watch)?;
    let again = again.filter(|_| was_narrowed.get());
    // stages are told of once
    let whole = again.map(|picture| || marks(picture, &|_, layout, _| layout, &mut |_| ()));
    narrowed_or_whole(narrowed, whole, |marks, watch| compose(marks, words, &written, request, watch), watch)
}

/// The page of a figure that is smaller for the sake of its words: or, if that has cost it more than [`MOST_LOST`], the
/// page with the figure as it would be without, if it has clearly more of the picture and no fewer whole words. `whole`
/// gives the marks of the latter where the figure is smaller at all, and `page_of` composes a page.
fn narrowed_or_whole(
    narrowed: DrawnMarks,
    whole: Option<impl FnOnce() -> Result<DrawnMarks, Error>>,
    page_of: impl Fn(DrawnMarks, &mut Watch<'_>) -> Result<Composed, Error>,
    watch: &mut Watch<'_>,
) -> Result<Composed, Error> {
    let loss = narrowed.loss();
    let narrowed = page_of(narrowed, watch)?;
    let Some(whole) = whole.filter(|_| loss >= MOST_LOST) else { return Ok(narrowed) };
    let whole = whole()?;
    // room for its words is looked for only where it may be the better one
    if loss - whole.loss() < MOST_LOST {
        return Ok(narrowed);
    }
    let whole = page_of(whole, &mut |_| ())?;
    Ok(if whole.whole_labels() >= narrowed.whole_labels() { whole } else { narrowed })
}

/// What room for words may cost a drawing, as [`DrawnMarks::loss`]. Of 150 charts, maps and diagrams with their words
/// on an embosser and on swell paper 72 pages are smaller for the sake of words, most by up to 15 percent; few lose
/// more by it than this, as a labelled plant cell.
const MOST_LOST: f32 = 0.05;

/// Draws a page anew with another profile: lines and areas keep their places in the figure, and everything that hangs
/// on paper or device is made for the new one.
///
/// # Errors
/// As [`convert`].
pub fn redraw(
    old: OldPage<'_>,
    key: KeySheets,
    translate: Option<&Translate>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Drawing, Error> {
    let page = old.page;
    let legend = legend::of_page(page);
    // a sheet of a key stays one, and a page with a key that was asked for has one
    let key = if key == KeySheets::Auto && read_key::has_own_key(page) { KeySheets::Always } else { key };
    let words = redraw::words(page, &legend);
    let words = Words { key, translate, before: Some(&page.figure), title: old.title.or(words.title), ..words };
    let mut written = WrittenWords::new(&words, request.plan);
    if matches!(InSet::of(page), Some(InSet::One(..))) {
        written = written.beside_label(request.plan);
    }
    let layout = written.layout(redraw::shape(page), OverviewSize::Own, request)?;
    if let Some(Key { sheets, notes, .. }) = read_key::redrawn(page, &written, &layout, request)? {
        let mut sheets = sheets.into_iter();
        if let Some(page) = sheets.next() {
            return Ok(Drawing::of_key(page, sheets.collect(), notes));
        }
    }
    let layout_of = |size: Size| written.layout(size, OverviewSize::Own, request);
    let roomy = redraw::with_room(page, &words, &written, request.plan, layout.clone(), &layout_of);
    let was_narrowed = roomy.figure != layout.figure;
    let marks = |layout: Layout, watch: &mut Watch<'_>| redraw::marks(old, layout, request, watch);
    let narrowed = marks(roomy, watch)?;
    let whole = was_narrowed.then_some(|| marks(layout, &mut |_| ()));
    let page_of = |marks: DrawnMarks, watch: &mut Watch<'_>| compose(marks, &words, &written, request, watch);
    let Composed { drawing, .. } = narrowed_or_whole(narrowed, whole, page_of, watch)?;
    // its labels are no texts of a picture
    Ok(Drawing { texts: Vec::new(), ..drawing })
}

/// The page of these marks, with its words.
fn compose(
    marks: DrawnMarks,
    words: &Words<'_>,
    written: &WrittenWords<'_>,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Composed, Error> {
    let plan = request.plan;
    let DrawnMarks { mut figure, overview, layout, facts, said, lost_signs, legend, texts, notes, .. } = marks;
    let for_words = ForWords::of(words, legend, &lost_signs, facts.coloured_ground);
    let words = &for_words.known_to(words);
    let mut remarks = Remarks::of_marks(notes);
    remarks.extend(lost_signs::told(&lost_signs, &texts, words, &figure, layout.sheets.as_ref()));
    let (page, overview, key, labels) = run_stage(watch, Stage::Page, || {
        let OnPage { braille, notes, counts, above, .. } = written.on(&layout, &mut figure, &texts, words, plan);
        let alone = matches!(layout.medium, Medium::Dots(_)) && overview.is_some();
        let before = 1 + u32::from(alone);
        let key = written.key(words, &braille, &figure, before, &layout, request)?;
        remarks.add_words(written.notes(), above, notes, &key);
        let said = said.with_labels(counts.left_out);
        let (page, overview) = match &layout.medium {
            Medium::Print(_) => Ok((assemble(figure, overview, said, braille, &layout, request)?, None)),
            Medium::Dots(medium) => {
                let braille = [braille, written.above_overview(&layout, plan)];
                dots::assemble(figure, overview, said, braille, &layout, medium, request)
            }
        }?;
        Ok::<_, Error>((page.with_key(&key.told), overview, key.sheets, counts))
    })?;
    let has_lines = !page.figure.lines.is_empty();
    let sheets = FinishedSheets { of_picture: vec![&page], key: &key, has_lines, medium: &layout.medium };
    let notes = remarks.of_sheets(&sheets, facts, plan);
    let is_larger_without_overview = page.overview.is_some() && request.fit.is_larger_without_overview(&layout, plan);
    let is_larger_turned = told_lines::is_larger_turned(&layout);
    let drawing = Drawing { page, overview, key, texts, notes, is_larger_without_overview, is_larger_turned };
    Ok(Composed { drawing, labels })
}

/// Puts all marks on the sheet.
fn assemble(
    figure: Figure,
    overview: Option<(MmRect, Vec<Line>)>,
    said: PageSays,
    braille: Vec<BrailleText>,
    layout: &Layout,
    request: &Request<'_>,
) -> Result<Page, Error> {
    let params = request.plan.layout();
    let around = |place| params.frame.as_ref().map_or_else(Dots::default, |params| frame::printed(place, params));
    let overview = overview.map(|(place, lines)| Overview { place, frame: around(place), lines });
    let parts = Parts {
        title: request.title.to_owned(),
        origin: [origin(request, figure.source, &braille), said.to_origin()].concat(),
        labels: said.label.into_iter().collect(),
        frame: around(layout.room),
        orientation_mark: layout.mark.clone(),
        overview,
        braille,
        medium: layout.medium.clone(),
        ..Parts::of(layout.sheet, figure)
    };
    finished(parts, request)
}
