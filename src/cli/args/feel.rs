//! `tactograph feel` on the command line.

use std::path::PathBuf;

use clap::Args;
use tactograph::PageOptions;

pub(super) const LONG_ABOUT: &str = "\
Tells what a fingertip would feel of a page's textures: which colours are told right.

It looks at the page as it is drawn, not at how it was made, so it can also be asked about a page that you changed in \
an editor, as long as its layers have their ids (texture-blue and so on).

The textures are blurred as by a fingertip, and then their direction is read: rows across are blue, up to the right \
green, up and down yellow, down to the right red; no direction is grey; or what the page's layers say, if its profile \
has a palette of its own. Things drawn beside the layers are not looked at. For each colour on the page the report \
says, in percent of the area of its textures, how much is felt right, how much is unclear (it could as well be another \
colour), how much is wrong, and how much is not judged: what lies nearer than 7 mm to a line or to another colour. \
Then come how much of the area is ink, and how many glyphs there are. The last lines say the same of all textures \
together.

This is a model that compares textures well. It does not replace a reader.";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph feel coffee.svg
        tells in some sentences what is felt
  tactograph feel pages/*.svg
        tells it of several pages
  tactograph feel coffee.svg --finger 1.5
        asks for a broader or less practised fingertip
  tactograph feel coffee.svg -o felt.png
        also draws a map of what is felt, with the names of the colours on it
  tactograph convert coffee.png -o - | tactograph feel -
        feels a page from standard input

The report goes to standard output. On the map each colour that is felt has its pattern and its name; crosses are \
where another colour is felt than is meant, rings where it is unclear, and pale places are not judged.

Exit codes:
  0  the report is written, whatever it says
  1  the page could not be read, or the map not written
  2  wrong usage: an option or a value is wrong";

/// `tactograph feel`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Feel {
    /// Pages to feel, SVG files that "tactograph convert" made; - for standard input
    ///
    /// Of several the name of each stands before what is felt. -o takes one page.
    #[arg(value_name = "PAGE.svg", required = true)]
    pub(in crate::cli) pages: Vec<PathBuf>,

    /// Size of the fingertip in mm: 0.5 fine, 1 usual, 1.5 coarse
    ///
    /// The sigma of the Gaussian by which the page is blurred. Range: 0.3 to 2.5.
    #[arg(long, value_name = "MM", default_value_t = 1.0, value_parser = finger, allow_negative_numbers = true)]
    pub(in crate::cli) finger: f32,

    /// Also draws a map of what is felt
    ///
    /// The name ends in .png (or has no ending). An existing file is replaced in one step.
    #[arg(short, long, value_name = "FELT.png")]
    pub(in crate::cli) output: Option<PathBuf>,
}

fn finger(text: &str) -> Result<f32, String> {
    let known = PageOptions::FINGERS;
    let number = text.parse().ok().filter(|number| known.contains(number));
    number.ok_or_else(|| format!("give a number of millimetres from {} to {}", known.start(), known.end()))
}
