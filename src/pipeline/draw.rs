//! The stages in their order, up to all marks of a picture. A stage whose result the page does not need does not run.

use super::areas_of_colours::AreasOfColours;
use super::decisions::{Decisions, LinesOf, OutlinedRegions};
use super::figure_lines::{FigureLines, draw_lines};
use super::find_edges::{GIVEN, edges_of, find_edges, skip_edges};
use super::finish::{PageSays, PictureFacts};
use super::given::{Given, GivenLines, erase};
use super::hand_lines::{SAME_SHAPE, weaken_thin_strokes};
use super::key::KeySheets;
use super::legend::{self, LegendEntry};
use super::legend_column::Column;
use super::margins::Lettered;
use super::named::NamedThings;
use super::outlines::regions_of_figure;
use super::overview::{DrawnOverview, draw_overview, seen_in_figure};
use super::paper_edge;
use super::progress::{Watch, in_parallel};
use super::read::{Content, Read, ReadPicture, read_lines};
use super::request::{Fit, LayoutOf, OverviewSize, Request, enough_pixels};
use super::series::{self, TexturedPicture};
use super::subject;
use super::texts::{self, Text, placed};
use super::told_bars;
use super::told_drawn::{DrawnLines, told_of_figure};
use super::told_given::{told_no_drawing, told_no_lines, told_short, told_words};
use super::told_lines::{left_out, told_simplified};
use super::words::{Words, become_labels};
use super::{leaders, line_legend, sign_legend};
use crate::edges::{self, Edges};
use crate::lines::{Line, Lines, LostSign};
use crate::page::layout::Layout;
use crate::page::{Figure, LeftOut};
use crate::profile::Plan;
use crate::raster::Raster;
use crate::raster::decode::{self, Header};
use crate::regions::Chosen;
use crate::units::{MmRect, PageTransform, Size};
use crate::{About, Error, GivenFile, Note, Reason};

/// All marks of a picture, where its layout puts them.
pub(super) struct DrawnMarks {
    pub(super) figure: Figure,
    pub(super) overview: Option<(MmRect, Vec<Line>)>,
    pub(super) layout: Layout,
    /// Share of the picture's lines that the overview lacks, 0..=1.
    pub(super) lost_of_overview: f32,
    pub(super) facts: PictureFacts,
    /// What the page says of itself.
    pub(super) said: PageSays,
    /// Small closed shapes of a drawing that are not on the page, or not whole.
    pub(super) lost_signs: Vec<LostSign>,
    /// What colours mean by the drawing's legend, if it has one.
    pub(super) legend: Vec<LegendEntry>,
    /// Texts that are not drawn.
    pub(super) texts: Vec<Text>,
    pub(super) notes: Vec<Note>,
}

impl DrawnMarks {
    /// What of the picture's lines is not on the page, as a share: of the figure's, and of the overview's with a third
    /// of the weight, as it shows them a second time.
    pub(super) fn loss(&self) -> f32 {
        self.said.left_out.share() + self.lost_of_overview / 3.0
    }
}

/// The layout with room for the texts of a drawing, which the last argument lays out in another size.
pub(super) type WithRoom<'a> = dyn Fn(&Lettered<'_>, Layout, &dyn Fn(Size) -> Result<Layout, Error>) -> Layout + 'a;

/// A picture that is read and laid out, with its contours.
pub(super) struct Found {
    picture: decode::Decoded,
    facts: PictureFacts,
    layout: Layout,
    texts: Vec<Text>,
    edges: Edges,
    decisions: Decisions,
    legend: Vec<LegendEntry>,
    /// How large the overview should be: it may be laid out smaller.
    overview: OverviewSize,
    /// Whether there are labels in the figure.
    has_labels: bool,
    notes: Vec<Note>,
}

/// What a person gives beside a picture.
#[derive(Clone, Copy)]
pub(super) struct FromPerson<'a> {
    /// Lines, areas, and what is erased.
    pub(super) given: &'a Given,
    pub(super) words: &'a Words<'a>,
}

/// Lays a picture out where `layout_of` its size says, `with_room` for the texts in it, and finds its contours: what
/// [`draw`] draws.
pub(super) fn find(
    picture: ReadPicture<'_>,
    person: FromPerson<'_>,
    request: &Request<'_>,
    layout_of: &LayoutOf<'_>,
    with_room: &WithRoom<'_>,
    watch: &mut Watch<'_>,
) -> Result<Found, Error> {
    let (FromPerson { given, words }, plan, fit) = (person, request.plan, &request.fit);
    let ReadPicture { file, read: Read { picture, content, is_on_paper } } = picture;
    let source = picture.source.size;
    let lettered = Lettered { texts: &picture.texts, raster: &picture.raster, source };
    let overview = overview_of(&picture, &content, given, plan);
    let (laid_out, layout) = overview.fitting(source, plan, layout_of)?;
    let layout = with_room(&lettered, layout, &|size| layout_of(size, laid_out));
    let mut notes = given.told();
    notes.extend(picture.notes.iter().cloned());
    notes.extend(told_narrower(fit, &layout));
    let mut texts = placed(&picture.texts, &PageTransform::new(picture.raster.size(), layout.figure));
    let drawing = picture.drawing.as_ref();
    let (texts_left_out, told_texts) = texts::left_out(&texts, words.own_texts, layout.figure, drawing);
    notes.extend(told_texts);

    request.go_on()?;
    let erased = given.boxes(source, layout.figure)?;
    if given.lines.is_some() {
        skip_edges(GIVEN, watch);
    }
    let Contours { mut edges, mut decisions, told, all_erased, .. } =
        contours_of(given, picture.raster.size(), &layout, erased, request, || {
            find_edges(&picture, &content, &layout, plan, watch)
        })?;
    notes.extend(told);
    notes.extend(paper_edge::taken_out(&mut edges, given, is_on_paper));
    let of_other = given.told_other_picture(source);
    let of_given = [of_other, told_short(given, &layout, plan), told_words(given, words), given.told_areas()];
    notes.extend(of_given.into_iter().flatten());
    let none_sought = content.is_uniform() || given.lines.is_some();
    let lines_of = lines_of(given, None, &decisions);
    let beside_words = (&mut edges, &mut texts[..]);
    let ApartFromWords { legend, has_named_lines, told } =
        apart_from_words(beside_words, words, lines_of, &picture.raster, &layout, plan);
    notes.extend(told);
    let facts = PictureFacts { none_sought, all_erased, texts_left_out, has_named_lines, ..PictureFacts::default() };
    let things = NamedThings::of(given, file, request, watch)?;
    notes.extend(subject::prepare(given, things.as_ref(), &mut edges, &mut decisions, source, &layout, plan));
    request.go_on()?;
    let has_labels = plan.profile().braille.on && (!words.labels.is_empty() || texts.iter().any(become_labels(words)));
    Ok(Found { picture, facts, layout, texts, edges, decisions, legend, overview, has_labels, notes })
}

/// What is known of a drawing whose contours that go with its words were taken out.
struct ApartFromWords {
    legend: Vec<LegendEntry>,
    /// Whether words of a legend of lines became labels of these.
    has_named_lines: bool,
    told: Vec<Note>,
}

/// Takes out of the contours of a drawing what says nothing beside words in braille: the samples of a legend of signs
/// or lines, leader lines that have no room as a whole, and a legend of colours that the key has.
fn apart_from_words(
    (edges, texts): (&mut Edges, &mut [Text]),
    words: &Words<'_>,
    lines_of: LinesOf<'_>,
    raster: &Raster,
    layout: &Layout,
    plan: &Plan,
) -> ApartFromWords {
    let (mut has_named_lines, mut told) = (false, Vec::new());
    let is_label = become_labels(words);
    if plan.profile().figure.lines {
        told.extend(sign_legend::taken_out(edges, texts, raster, layout));
    }
    let column = Column::find(edges, texts, raster, &PageTransform::new(edges.size, layout.figure));
    let column = column.as_ref();
    if plan.profile().figure.lines {
        let of_legend = line_legend::to_curves(edges, texts, (&is_label, column), raster, layout);
        has_named_lines = of_legend.as_ref().is_some_and(|(count, _)| *count > 1);
        told.extend(of_legend.map(|(_, told)| told));
        let draw = |edges: &Edges| draw_lines(edges, lines_of, layout, plan, &mut |_| ()).lines.lines;
        told.extend(leaders::whole_or_none(edges, texts, leaders::FROM_PRINT, &is_label, layout, draw));
    }
    let legend = legend::entries(edges, texts, raster, column, layout, plan);
    if words.key != KeySheets::Never && plan.profile().braille.on && plan.profile().figure.textures {
        told.extend(legend::moved_to_key(edges, (&legend, column), (texts, is_label), raster, layout));
    }
    ApartFromWords { legend, has_named_lines, told }
}

/// Everything but the page: draws the contours and colours that were found.
pub(super) fn draw(
    found: Found,
    given: &Given,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<DrawnMarks, Error> {
    let plan = request.plan;
    let Found { picture, mut facts, layout, texts, edges, mut decisions, overview: size, .. } = found;
    let (mut legend, mut notes) = (found.legend, found.notes);
    let regions = regions_of_figure(&edges, &decisions, &layout, plan, watch);
    let has_contours = !edges.is_empty() || lines_of(given, regions.as_ref(), &decisions).has_subject();
    let has_lines = plan.profile().figure.lines && has_contours;
    let follows_figure = has_lines && regions.is_some() && plan.lines().most_shapes.is_some();
    let of_overview = leaders::without_leaders(&edges, &texts, &layout);
    notes.extend(leaders::told_without(of_overview.as_ref(), &edges));
    let (drawn, (overview, mut areas_of_colours)) = {
        let (edges, layout) = (&edges, &layout);
        let lines_of = lines_of(given, regions.as_ref(), &decisions);
        let lines = |watch: &mut Watch<'_>| draw_lines(edges, lines_of, layout, plan, watch).with_legend(&legend);
        let overview = |edges: &Edges, watch: &mut Watch<'_>| draw_overview(edges, lines_of, size, layout, plan, watch);
        let (drawn, (own, areas)) = in_parallel(has_lines, watch, lines, |watch| {
            let own = (!follows_figure).then(|| overview(of_overview.as_ref().unwrap_or(edges), watch));
            (own, AreasOfColours::of(given, &picture.raster, edges, layout, plan, watch))
        });
        let of_figure = |watch| overview(&seen_in_figure(edges, &drawn.lines.lines, layout, plan), watch);
        let overview = own.unwrap_or_else(|| of_figure(watch));
        (drawn, (overview, areas))
    };
    request.go_on()?;
    let FigureLines { lines: drawn, areas, instead } = drawn;
    let overview = if regions.is_some() { overview.within(&drawn.lines, &layout, plan) } else { overview };
    notes.extend(told_of_figure(&drawn, &edges, (&texts, &picture.raster), &layout, plan));
    if let Some(of_colours) = &mut areas_of_colours {
        of_colours.without(&legend::patches_in_key(&legend, &texts), layout.figure);
        notes.extend(of_colours.fit_to_page(given, &mut decisions, areas.as_ref(), edges.size, &layout, plan));
        facts.coloured_ground = of_colours.coloured_ground;
    }
    let said = said_of(&drawn, &overview, &edges, areas_of_colours.as_ref(), facts.texts_left_out);
    let (of_picture, by) = ((&edges, regions.as_ref()), (given, &decisions));
    let both = DrawnLines { of_picture, by, drawn: &drawn, overview: &overview, layout: &layout, plan };
    notes.extend(both.told(follows_figure));
    notes.extend(told_bars::told(instead, overview.instead));
    notes.extend(told_simplified(drawn.beyond, areas.as_ref(), plan));
    notes.extend(legend::told_lines(&edges, &picture.raster, &layout, plan).filter(|_| !facts.has_named_lines));
    let of_legend = (&mut legend, TexturedPicture { is_drawing: edges.of_drawing(), has_labels: found.has_labels });
    let leaders = leaders::on_page(&edges, (&texts, leaders::FROM_PRINT), &layout);
    drop((picture.raster, edges));
    let mixed = areas_of_colours.as_mut().and_then(|areas| areas.mixed.take());
    let areas = areas_of_colours.map(|areas| (areas.classes, areas.bars));
    let (textures, told) = series::textured(areas, of_legend, &layout, &drawn.lines, plan, watch);
    notes.extend(told);
    notes.extend(mixed.and_then(|areas| areas.told(&textures, &drawn.lines, &layout, plan)));
    request.go_on()?;
    let lines = leaders::spaced(drawn.lines, &leaders, &layout);
    let figure = Figure { place: layout.figure, source: picture.source.size, textures, lines };
    let (lost_signs, lost_of_overview, overview) = (drawn.lost.signs, overview.lost.share(), overview.marks);
    Ok(DrawnMarks { figure, overview, layout, lost_of_overview, facts, said, lost_signs, legend, texts, notes })
}

/// What a page says of what is left out of it.
fn said_of(
    drawn: &Lines,
    overview: &DrawnOverview,
    edges: &Edges,
    areas: Option<&AreasOfColours>,
    texts: u32,
) -> PageSays {
    let areas = areas.map_or(0, |of_colours| of_colours.too_small as u32);
    PageSays::of(LeftOut { areas, texts, ..left_out(&drawn.lost, overview.lost.rings, edges.of_drawing()) })
}

/// The contours of a picture, and what is decided about the lines that are drawn of them.
pub(super) struct Contours {
    pub(super) edges: Edges,
    pub(super) decisions: Decisions,
    /// What is told of those that were given.
    pub(super) told: Vec<Note>,
    /// Whether there were some, and all were erased.
    pub(super) all_erased: bool,
    /// Whether a person gave lines in place of them, and there are none in that file, which is told of it.
    pub(super) none_given: bool,
}

/// The contours of a picture of this size: what a person gave, or what `find` finds, with the lines that were added,
/// and without what is erased.
///
/// # Errors
/// If what was given cannot be read or is of another shape than the picture.
pub(super) fn contours_of(
    given: &Given,
    size: Size,
    layout: &Layout,
    erased: Vec<[f32; 4]>,
    request: &Request<'_>,
    find: impl FnOnce() -> Edges,
) -> Result<Contours, Error> {
    let px_per_mm = PageTransform::new(size, layout.figure).px_per_mm();
    let mut told = Vec::new();
    let mut edges = match &given.lines {
        Some(GivenLines::Vectors(lines)) => lines.contours(size)?,
        Some(GivenLines::Picture(bytes)) => {
            let (edges, of_drawn) = edges_of_drawn(bytes, size, request, px_per_mm)?;
            told = of_drawn;
            edges
        }
        None => find(),
    };
    let none_given = given.lines.is_some() && edges.is_empty();
    let room_of_added = request.plan.lines().max_spacing() * px_per_mm;
    let gave_way = match &given.added {
        Some(added) => added.add_to(&mut edges, room_of_added)?,
        None => Vec::new(),
    };
    let is_any = !edges.is_empty();
    erase(&mut edges, &erased);
    let all_erased = is_any && edges.is_empty();
    let decisions = Decisions { erased, room_of_added, gave_way, ..Decisions::default() };
    Ok(Contours { edges, decisions, told, all_erased, none_given })
}

/// Whose lines are drawn of contours: those that a person gave stay as they are.
pub(super) fn lines_of<'a>(given: &Given, regions: Option<&'a Chosen>, decisions: &'a Decisions) -> LinesOf<'a> {
    match given.lines {
        Some(_) => LinesOf::Person,
        None => LinesOf::Picture(regions.map(|of_figure| OutlinedRegions { of_figure, decisions })),
    }
}

/// Strokes in a picture of lines are one line up to this width, mm; what is broader is an area. As pixels show them,
/// and where they branch, strokes measure more than they are: those of 11 mm are one line, some of 12 mm are not.
const WIDEST_STROKE: f32 = 13.0;

/// The lines of a picture of lines, as contours of a picture of this size, and what is told: of texts of a document,
/// which are left out as those of any picture, and of what has no lines or is no picture of them.
fn edges_of_drawn(
    bytes: &[u8],
    size: Size,
    request: &Request<'_>,
    px_per_mm: f32,
) -> Result<(Edges, Vec<Note>), Error> {
    let working_size = |source: Header| {
        let shape = |size: Size| size.width as f32 / size.height as f32;
        enough_pixels(source.size)?;
        let (lines, picture) = (shape(source.size), shape(size));
        if (lines / picture - 1.0).abs() > SAME_SHAPE {
            return Err(Error::OtherShape { lines, picture });
        }
        Ok(size)
    };
    let options = decode::DecodeOptions { crop: None, page: None, ..request.decoding(&working_size) };
    let Read { picture, content, .. } = read_lines(bytes.into(), &options)?;
    let texts = picture.texts.iter().filter(|text| !text.hidden).count();
    let (noun, them) = if texts == 1 { ("text", "it") } else { ("texts", "them") };
    let why = "fingers read no print letters";
    let told = format!("{texts} {noun} in the picture of lines: {why}; give {them} as labels, or keep {them} as lines");
    let params = edges::Params { dark_lines: Some(WIDEST_STROKE * px_per_mm), ..request.plan.edges(px_per_mm) };
    let mut edges = edges_of(&picture, &content, &params, None, &mut |_| ());
    weaken_thin_strokes(&mut edges, WIDEST_STROKE * px_per_mm, request.plan);
    let of_texts = (texts > 0).then_some(Note::NotOnPage(About::Lines, Reason::PrintLetters, told.into()));
    let is_photograph = content.kind().is_some_and(|kind| !kind.is_drawing);
    let of_file = match edges.is_empty() {
        true => Some(told_no_lines("none of its strokes is black on white, or white on black, and long enough")),
        false => is_photograph.then(told_no_drawing),
    };
    let of_file = of_file.map(|note| Note::OfFile(GivenFile::Lines, Box::new(note)));
    Ok((edges, of_texts.into_iter().chain(of_file).collect()))
}

/// How large the overview of a picture is laid out.
pub(super) fn overview_of(picture: &decode::Decoded, content: &Content, given: &Given, plan: &Plan) -> OverviewSize {
    let is_photograph = picture.drawing.is_none() && content.kind().is_some_and(|kind| !kind.is_drawing);
    // few shapes need no more room
    let has_regions = plan.region_detail().is_some() && plan.lines().most_shapes.is_none();
    if is_photograph && has_regions && given.lines.is_none() { OverviewSize::OfPhotograph } else { OverviewSize::Own }
}

/// What the maker is told of a figure that is narrower than asked for.
fn told_narrower(fit: &Fit, layout: &Layout) -> Option<Note> {
    let (wanted, width) = (fit.width?, layout.figure.width());
    let why = "the room beside it is for the drawing's own words; give the words as labels, or ask for more";
    let told = format!("the figure is {width:.0} mm wide and not {wanted:.0}, as {why}");
    (layout.room != layout.figure && wanted - width >= 1.0).then_some(Note::TakenAs(
        About::Marks,
        Reason::NarrowerForWords,
        told.into(),
    ))
}
