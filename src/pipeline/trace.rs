//! The way from bytes to contours as data: the first half of the way to a page.

use super::{Event, Fit, Stage, Watch, crowded, draw_lines, enough_pixels, run, working_size};
use crate::contours::Trace;
use crate::edges;
use crate::frame::Frame;
use crate::profile::Plan;
use crate::raster::decode::{self, Fonts, Limits, Options, Source};
use crate::{Error, Note};

/// Contours and what should be known of them.
#[derive(Debug, Clone)]
pub struct Traced {
    /// The contours.
    pub trace: Trace,
    /// Remarks, in the order of the stages.
    pub notes: Vec<Note>,
}

/// What is traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// The contours as they are found: thinned, linked and chosen by strength, before any rule of touch.
    Edges {
        /// Whether to look at the source's own pixels with [`edges::Params::default`]. If not, the picture is worked on as
        /// for the page.
        full_resolution: bool,
    },
    /// The lines that the page draws in its figure, with their widths. They have no full resolution of their own: a page is
    /// drawn from what the profile works on, and lines drawn from anything else would be on no page.
    Lines,
}

/// Which contours are strong enough (see [`crate::edges`] for the unit).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thresholds {
    low: f32,
    high: f32,
}

impl Thresholds {
    /// A contour goes on as long as it has the strength `low`, and is kept if it has the strength `high` somewhere. With
    /// 0 and 0 everything is kept that is long enough ([`edges::Params::min_length`]). None unless 0 <= `low` <= `high` and
    /// both are finite.
    pub fn new(low: f32, high: f32) -> Option<Self> {
        (0.0 <= low && low <= high && high.is_finite()).then_some(Self { low, high })
    }
}

/// Everything beside the picture's bytes.
pub struct Request<'a> {
    /// What is traced.
    pub subject: Subject,
    /// Which contours are strong enough; without it the parameters of the subject say so. Widths of lines stay as the plan
    /// has them.
    pub thresholds: Option<Thresholds>,
    /// The checked profile.
    pub plan: &'a Plan,
    /// What decoding may cost.
    pub limits: Limits,
    /// Fonts for drawings; asked only when a drawing has text.
    pub fonts: &'a Fonts<'a>,
}

/// Traces the contours of a picture. `watch` is told of every stage.
///
/// ```no_run
/// use std::sync::Arc;
/// use tactograph::internals::pipeline::trace::{Request, Subject, Thresholds};
/// use tactograph::internals::profile::{Plan, Profile};
///
/// let picture = std::fs::read("samples/coffee.png")?;
/// let plan = Plan::new(&Profile::named("swell-a4").expect("built in")).expect("built-in profiles make sense");
/// let fonts = || Arc::new(usvg::fontdb::Database::new());
/// let subject = Subject::Edges { full_resolution: true };
/// let thresholds = Thresholds::new(5.0, 20.0);
/// let request = Request { subject, thresholds, plan: &plan, limits: Default::default(), fonts: &fonts };
/// let traced = tactograph::trace(&picture, &request, &mut |_event| ())?;
/// for contour in traced.trace.polylines.iter().filter(|contour| contour.closed) {
///     println!("a ring of {} points", contour.points.len());
/// }
/// std::fs::write("coffee.json", tactograph::internals::output::json::write(&traced.trace))?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the picture cannot be read or is too small; see [`Error`].
pub fn trace(picture: &[u8], request: &Request<'_>, watch: &mut Watch<'_>) -> Result<Traced, Error> {
    let &Request { subject, thresholds, plan, limits, fonts } = request;
    let in_full = matches!(subject, Subject::Edges { full_resolution: true });
    let fit = Fit::default();
    let working_size = |source: Source| {
        if in_full {
            enough_pixels(source.size).map(|()| source.size)
        } else {
            working_size(source, &|size| fit.layout(size, plan), &fit, plan)
        }
    };
    let options = Options { limits, fonts, crop: None, working_size: &working_size };
    let picture = run(watch, Stage::Decode, || decode::decode(picture, &options))?;
    let (raster, source, mut notes) = (picture.raster, picture.source.size, picture.notes);

    let layout = fit.layout(source, plan)?;
    let px_per_mm = 1.0 / Frame::new(raster.size(), layout.figure).mm_per_px();
    let mut params = if in_full { edges::Params::default() } else { plan.edges(px_per_mm) };
    if let Some(Thresholds { low, high }) = thresholds {
        (params.low, params.high) = (low, high);
    }
    let edges = if raster.is_flat() {
        watch(Event::Skip(Stage::Edges, "the picture is of one colour"));
        None
    } else {
        Some(run(watch, Stage::Edges, || edges::find(&raster, &params)))
    };
    drop(raster);
    let trace = match (&edges, subject) {
        (None, _) => Trace { size: source, polylines: Vec::new() },
        (Some(edges), Subject::Edges { .. }) => Trace::of_edges(edges, source),
        (Some(edges), Subject::Lines) => {
            let drawn = draw_lines(Some(edges), &layout, plan, watch);
            notes.extend(crowded(&drawn));
            let frame = Frame::new(edges.size, layout.figure);
            let params = plan.lines();
            // The middle line of a bar lies so far from either side, and nothing is moved further.
            let reach = 0.5 * (params.min_gap + params.width_max);
            Trace::of_lines(&drawn.lines, edges, &frame, layout.figure, reach, source)
        }
    };
    if trace.polylines.is_empty() {
        notes.push(Note::NoContours);
    }
    Ok(Traced { trace, notes })
}
