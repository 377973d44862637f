//! `tactograph trace` on the command line.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use tactograph::Tracing;

use super::shared::Shared;

pub(super) const LONG_ABOUT: &str = "\
Writes the contours of each picture as data (JSON), in pixels of the picture.

For programs that go on with the contours, and to measure how good they are. The file holds

  {\"program\":\"tactograph 0.1.0\",\"image\":[width,height],\"polylines\":[
  {\"closed\":true,\"points\":[[x,y],...],\"strength\":[one number for each point]},
  ...
  ]}

x runs to the right and y down, in pixels of the picture as it is seen (after the turn that a camera noted); the \
middle of the first pixel is 0.5, 0.5. This holds whatever size the picture is worked on. A closed polyline goes on \
from its last point to its first, which is not repeated.

Strength is the height of the colour step in units of lightness (0 to 100), with the colour axes of CIELAB counted \
twice: black against white \
is 100, a step of 10 grey values of 255 about 4, and below 10 a step is hardly worth a line on a page.";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph trace coffee.png
        makes coffee.json beside the picture: contours as found for the page
  tactograph trace coffee.png -o edges.json --full-resolution
        looks at every pixel of the picture, whatever the size of the page
  tactograph trace photos/*.jpg --out-dir edges --full-resolution --threshold 0,0
        writes everything that may be a contour, to choose by strength afterwards
  tactograph trace coffee.png --stage lines --profile swell-a3
        writes the lines that convert draws for A3 paper
  curl https://example.org/cat.jpg | tactograph trace - | jq '.polylines | length'
        reads from standard input and writes to standard output

Exit codes:
  0  every trace is written
  1  a picture could not be traced, or its trace not written; the other traces are written
  2  wrong usage: an option, a profile or a value is wrong; nothing is written";

/// `tactograph trace`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Trace {
    /// Pictures to trace; - for standard input
    ///
    /// A picture from standard input goes to standard output unless -o names a file.
    #[arg(value_name = "PICTURE", required = true)]
    pub(in crate::cli) pictures: Vec<PathBuf>,

    /// Where the trace goes, for one picture; - for standard output
    ///
    /// The name ends in .json (or has no ending). An existing file is replaced in one step, when the new trace is
    /// complete; until then, and if anything fails, it stays as it is.
    ///
    /// [default: the picture's name with .json, beside the picture]
    #[arg(short, long, value_name = "TRACE.json", conflicts_with = "out_dir")]
    pub(in crate::cli) output: Option<PathBuf>,

    /// Directory for the traces, made if missing
    ///
    /// Each trace has its picture's name with .json. Two pictures whose traces would have the same name are refused.
    ///
    /// [default: each trace lies beside its picture]
    #[arg(long, value_name = "DIR")]
    pub(in crate::cli) out_dir: Option<PathBuf>,

    /// What to write: the contours as found, or the lines of the page
    #[arg(long, value_enum, default_value_t = Stage::Edges)]
    stage: Stage,

    /// Which contours are strong enough, in units of strength (see above)
    ///
    /// A contour goes on as long as it has the strength LOW, and is kept if it has the strength HIGH somewhere. 0,0
    /// keeps everything but crumbs, which at full resolution are shorter than 6 pixels.
    ///
    /// [default: edges.low,edges.high of the profile; with --full-resolution 3.5,5]
    #[arg(long, value_name = "LOW,HIGH", value_parser = thresholds, allow_hyphen_values = true)]
    threshold: Option<[f32; 2]>,

    /// Works on the picture's own pixels
    ///
    /// Without it, a picture is brought to the size that the profile works on for the page, and the profile says how
    /// its contours are found. With it, the profile has no say. Not for --stage lines, as a page has lines only at the
    /// size that its profile works on.
    #[arg(long)]
    full_resolution: bool,

    #[command(flatten)]
    pub(in crate::cli) shared: Shared,
}

impl Trace {
    /// What is traced.
    ///
    /// # Errors
    /// If what is asked for does not go together.
    pub(in crate::cli) fn tracing(&self) -> Result<Tracing, &'static str> {
        let tracing = match (self.stage, self.full_resolution) {
            (Stage::Edges, false) => Tracing::contours(),
            (Stage::Edges, true) => Tracing::contours_at_full_resolution(),
            (Stage::Lines, false) => Tracing::lines(),
            (Stage::Lines, true) => {
                return Err(
                    "--full-resolution does not go with --stage lines: a page has lines only at the size that its \
                     profile works on; leave one out, or make that size larger with --set figure.resolution=12",
                );
            }
        };
        match self.threshold {
            Some([low, high]) => tracing.thresholds(low, high).map_err(|_| THRESHOLDS),
            None => Ok(tracing),
        }
    }
}

/// `--stage`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Stage {
    /// Contours as they are found, before any rule of touch: thinned, linked, chosen by strength, not simplified
    Edges,
    /// The lines that "tactograph convert" draws in the figure: joined, cleared, simplified; with their width on the
    /// page, width_mm, from each point to the next
    Lines,
}

/// What is told of numbers that are no thresholds.
const THRESHOLDS: &str = "give two numbers from 0 up, the first not above the second, such as 3,6";

fn thresholds(text: &str) -> Result<[f32; 2], String> {
    let numbers =
        text.split_once(',').and_then(|(low, high)| Some([low.trim().parse().ok()?, high.trim().parse().ok()?]));
    let thresholds = numbers.filter(|&[low, high]| Tracing::contours().thresholds(low, high).is_ok());
    thresholds.ok_or_else(|| THRESHOLDS.into())
}
