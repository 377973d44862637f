//! From bytes to contours as data: the first half of what a page takes.

use super::decisions::Decisions;
use super::draw::{Contours, contours_of, lines_of, overview_of};
use super::figure_lines::{FigureLines, draw_lines};
use super::find_edges::{GIVEN, edges_of, skip_edges};
use super::given::Given;
use super::named::NamedThings;
use super::outlines::regions_of_figure;
use super::progress::{ONE_COLOUR, Stage, Watch};
use super::read::{Read, read};
use super::request::{Fit, OverviewSize, Request, enough_pixels, working_size};
use super::subject;
use super::told_bars;
use super::told_lines::LinesLeftOut;
use crate::contours::Trace;
use crate::edges::{self, Edges};
use crate::page::layout::Layout;
use crate::picture::Picture;
use crate::profile::Plan;
use crate::raster::decode::Header;
use crate::regions::Detail;
use crate::units::{PageTransform, Size};
use crate::{Error, Note};

/// Contours and what should be known of them.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Traced {
    /// The contours.
    pub trace: Trace,
    /// Remarks, in the order of the stages.
    pub notes: Vec<Note>,
}

/// What [`trace`](crate::trace) looks for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Tracing {
    target: Target,
    /// Down to which strength a contour goes on, and which it has somewhere.
    thresholds: Option<[f32; 2]>,
}

/// What becomes data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Target {
    Contours,
    ContoursAtFullResolution,
    Lines,
}

impl Tracing {
    /// The contours as they are found for the page, before any rule of touch: thinned, linked and chosen by strength.
    pub fn contours() -> Self {
        Self { target: Target::Contours, thresholds: None }
    }

    /// The contours in the picture's own pixels, whatever the size of the page. The profile has no say in how they are
    /// found.
    pub fn contours_at_full_resolution() -> Self {
        Self { target: Target::ContoursAtFullResolution, thresholds: None }
    }

    /// The lines that the page draws in its figure, with their widths. They have no full resolution of their own: a
    /// page is drawn from what the profile works on, and lines drawn from anything else would be on no page. A
    /// [subject](crate::Options::subject) and a [calm background](crate::Options::calm_background) count as there; for
    /// contours they have no meaning.
    pub fn lines() -> Self {
        Self { target: Target::Lines, thresholds: None }
    }

    /// Which contours are strong enough: a contour goes on as long as it has the strength `low`, and is kept if it has
    /// the strength `high` somewhere. Strength is the height of the colour step, in units of lightness with the colour
    /// axes of CIELAB counted twice: black against white is 100. With 0 and 0 everything is kept that is long enough
    /// (at full resolution 6 pixels). Default: `edges.low` and `edges.high` of the profile; at full resolution 3.5 and
    /// 5. Widths of lines stay as the profile has them.
    ///
    /// # Errors
    /// [`Error::NoSuchThresholds`] unless 0 <= `low` <= `high` and both are finite.
    pub fn thresholds(self, low: f32, high: f32) -> Result<Self, Error> {
        let fit = 0.0 <= low && low <= high && high.is_finite();
        fit.then_some(Self { thresholds: Some([low, high]), ..self }).ok_or(Error::NoSuchThresholds { low, high })
    }

    /// The last stage that it takes.
    pub(crate) fn last_stage(&self) -> Stage {
        match self.target {
            Target::Contours | Target::ContoursAtFullResolution => Stage::Regions,
            Target::Lines => Stage::Lines,
        }
    }
}

/// Traces the contours of a picture, or of the part that [`Request::fit`] names, or those that are given in their
/// place. `watch` is told of every stage.
///
/// # Errors
/// When the picture cannot be read or is too small; see [`Error`].
pub fn trace<'p>(
    picture: impl Into<Picture<'p>>,
    tracing: &Tracing,
    given: &Given,
    request: &Request<'_>,
    watch: &mut Watch<'_>,
) -> Result<Traced, Error> {
    let plan = request.plan;
    let in_full = tracing.target == Target::ContoursAtFullResolution;
    let fit = Fit { mirrored: false, ..request.fit };
    let layout_of = |size: Size, overview: OverviewSize| fit.layout(size, plan, overview);
    let working_size = |source: Header| {
        if in_full {
            enough_pixels(source.size).map(|()| source.size)
        } else {
            working_size(source, &layout_of, &fit, plan)
        }
    };
    let options = request.decoding(&working_size);
    let file: Picture<'p> = picture.into();
    let read = read(file, &options, None, watch)?;
    let (source, mut notes) = (read.picture.source.size, read.picture.notes.clone());

    let overview = overview_of(&read.picture, &read.content, given, plan);
    let (_, layout) = overview.fitting(source, plan, &layout_of)?;
    request.go_on()?;
    let erased = given.boxes(source, layout.figure)?;
    if given.lines.is_some() {
        skip_edges(GIVEN, watch);
    }
    let Contours { mut edges, mut decisions, told, none_given, .. } =
        contours_of(given, read.picture.raster.size(), &layout, erased, request, || {
            find_edges(&read, tracing, &layout, plan, watch)
        })?;
    notes.extend(given.told().into_iter().chain(given.told_other_picture(source)));
    notes.extend(told);
    drop(read);
    request.go_on()?;
    let trace = match tracing.target {
        Target::Contours | Target::ContoursAtFullResolution => Trace::of_edges(&edges, source),
        Target::Lines => {
            let things = NamedThings::of(given, file, request, watch)?;
            let things = things.as_ref();
            notes.extend(subject::prepare(given, things, &mut edges, &mut decisions, source, &layout, plan));
            let (trace, told) = lines_as_data((given, &decisions), &edges, source, &layout, plan, watch);
            notes.extend(told);
            trace
        }
    };
    if tracing.target == Target::Lines && !plan.profile().figure.lines {
        notes.push(Note::LinesOff);
    } else if trace.polylines.is_empty() && !none_given {
        notes.push(Note::NoContours);
    }
    Ok(Traced { trace, notes })
}

/// The lines of the figure of a picture of this size, and what is told of them.
fn lines_as_data(
    (given, decisions): (&Given, &Decisions),
    edges: &Edges,
    source: Size,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> (Trace, Vec<Note>) {
    let regions = regions_of_figure(edges, decisions, layout, plan, watch);
    let lines_of = lines_of(given, regions.as_ref(), decisions);
    let FigureLines { lines: drawn, instead, .. } = draw_lines(edges, lines_of, layout, plan, watch);
    let mut notes: Vec<Note> = LinesLeftOut::of(&drawn, edges, layout).map(LinesLeftOut::told).into_iter().collect();
    notes.extend(subject::told(decisions, edges.size, &drawn.lines, None, layout, plan));
    notes.extend(told_bars::told(instead, None));
    let transform = PageTransform::new(edges.size, layout.figure);
    let reach = plan.lines().farthest_moved();
    (Trace::of_lines(&drawn.lines, edges, &transform, layout.figure, reach, source), notes)
}

/// The contours that are asked for; none in a picture of one colour.
fn find_edges(read: &Read, tracing: &Tracing, layout: &Layout, plan: &Plan, watch: &mut Watch<'_>) -> Edges {
    let Read { picture, content, .. } = read;
    if content.is_uniform() {
        skip_edges(ONE_COLOUR, watch);
        return Edges::none(picture.raster.size());
    }
    let px_per_mm = PageTransform::new(picture.raster.size(), layout.figure).px_per_mm();
    let mut params = match tracing.target {
        Target::ContoursAtFullResolution => edges::Params::default(),
        Target::Contours | Target::Lines => plan.edges(px_per_mm),
    };
    if let Some([low, high]) = tracing.thresholds {
        (params.low, params.high) = (low, high);
    }
    let detail = match tracing.target {
        Target::ContoursAtFullResolution => Some(Detail::CONTOURS),
        Target::Contours | Target::Lines => plan.region_detail(),
    };
    let edges = edges_of(picture, content, &params, detail, watch);
    // only lines have outlines of regions; for contours the tree has done its work
    let regions = edges.regions.filter(|_| tracing.target == Target::Lines);
    Edges { regions, ..edges }
}
