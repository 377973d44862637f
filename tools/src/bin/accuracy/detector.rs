//! The detector under test: from a camera's bytes to traced lines, and its time.

use std::time::Instant;

use tactograph::internals::edges::{self, Edges, Params, PictureKind};
use tactograph::internals::raster::Raster;
use tactograph::internals::regions::Detail;
use tactograph::internals::units::Size;

use crate::draw::Picture;
use crate::measure::Traced;

/// Runs over the mosaic; the table shows the middle one and the fastest.
const RUNS: usize = 7;
/// A run repeats the job until about this many seconds have passed: the system counts a thread's work in steps of 4 ms.
const LEAST: f64 = 0.12;

/// Milliseconds for a megapixel, on one thread.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Time {
    pub(crate) median: f64,
    pub(crate) best: f64,
}

/// The contours of this project, by name: weighted by the regions between them, as `trace --full-resolution` finds them
/// in photographs, and alone. In drawings, as scenes without noise are, no regions are looked for, and both are the same.
pub(crate) const OWN: [(&str, Option<Detail>); 2] =
    [("tactograph", Some(Detail::CONTOURS)), ("tactograph (contours alone)", None)];

/// The lines that the edges of this project are, weighted by regions of some detail if there is one.
pub(crate) fn trace(picture: &Picture, params: &Params, regions: Option<Detail>) -> Vec<Traced> {
    traced(&found(&raster(picture), params, regions))
}

fn found(raster: &Raster, params: &Params, regions: Option<Detail>) -> Edges {
    edges::find_of_kind(raster, &PictureKind::of(raster, None), params, regions)
}

/// Edges as traced lines.
pub(crate) fn traced(edges: &Edges) -> Vec<Traced> {
    edges
        .chains()
        .map(|chain| Traced {
            closed: chain.closed,
            points: chain.path().map(|p| [f64::from(p.at.x), f64::from(p.at.y)]).collect(),
            strength: chain.path().map(|p| f64::from(p.strength)).collect(),
        })
        .collect()
}

/// Time of the edges alone: from linear light, as the decoder hands it over, to linked lines.
pub(crate) fn time(picture: &Picture, params: &Params, regions: Option<Detail>) -> Time {
    let raster = raster(picture);
    timed(picture, || drop(std::hint::black_box(found(&raster, params, regions))))
}

/// Time of a job on this picture.
pub(crate) fn timed(picture: &Picture, mut job: impl FnMut()) -> Time {
    let megapixels = 1e-6 * (picture.size[0] * picture.size[1]) as f64;
    let mut seconds_of = |times: usize| {
        let clock = Clock::start();
        (0..times).for_each(|_| job());
        clock.seconds() / times as f64
    };
    seconds_of(1); // pages and caches are warm after this
    let wall = Instant::now();
    let once = seconds_of(1).max(wall.elapsed().as_secs_f64()).max(1e-4);
    let repeats = (LEAST / once).ceil() as usize;
    let mut times: Vec<f64> = (0..RUNS).map(|_| 1e3 * seconds_of(repeats) / megapixels).collect();
    times.sort_by(f64::total_cmp);
    Time { median: times[RUNS / 2], best: times[0] }
}

/// Counts the time that this thread works, not what it waits for others; where Linux's own count is not to be had, the
/// time on the wall.
struct Clock(Instant, Option<f64>);

impl Clock {
    fn start() -> Self {
        Self(Instant::now(), Self::worked())
    }

    fn seconds(&self) -> f64 {
        match (self.1, Self::worked()) {
            (Some(start), Some(now)) => now - start,
            _ => self.0.elapsed().as_secs_f64(),
        }
    }

    /// Seconds that this thread has been on a processor.
    fn worked() -> Option<f64> {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| 1e-9 * nanoseconds)
    }
}

/// Linear light from sRGB bytes, as the decoder makes it (the curve of IEC 61966-2-1).
pub(crate) fn raster(picture: &Picture) -> Raster {
    let linear: Vec<f32> = (0..=255)
        .map(|code| {
            let encoded = f64::from(code) / 255.0;
            if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
        })
        .map(|light| light as f32)
        .collect();
    let plane = |channel: usize| picture.rgb.iter().skip(channel).step_by(3).map(|&v| linear[v as usize]).collect();
    Raster::colour(Size::new(picture.size[0] as u32, picture.size[1] as u32), [plane(0), plane(1), plane(2)])
}
