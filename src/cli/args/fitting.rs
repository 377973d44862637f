//! Options that say which part of a picture is drawn, how large, and what of it.

use clap::Args;
use tactograph::{Crop, Error, Options, Profile, SheetGrid};

use crate::cli::settings::Change;

/// Options of `tactograph convert` that are chosen anew for each picture.
#[derive(Debug, Args)]
pub(in crate::cli) struct Fitting {
    /// Draws a part of the picture only, as if the rest were not there
    ///
    /// Where it begins from the left and from the top, its width and its height, each in pixels of the picture as it
    /// is seen or in percent, such as 10%,0,80%,50% or 320,200,640,480. With several pictures, the same part of each.
    #[arg(long, value_name = "X,Y,W,H", value_parser = part)]
    crop: Option<Crop>,

    /// Width of the figure on the sheet, in millimetres
    ///
    /// The height follows. More than there is room for is refused, with what there is room for; but what is wider than
    /// the sheet itself is spread over as few sheets as it takes. A page of dots is spread only where --sheets is
    /// given. Range: 3 to 1200.
    ///
    /// [default: as wide as the sheet has room for]
    #[arg(long, value_name = "MM", value_parser = width, allow_negative_numbers = true)]
    width_mm: Option<f32>,

    /// Spreads the picture over several sheets, across by down
    ///
    /// Such as 2x2, up to 9x9. Neighbours overlap (sheets.overlap) and show the same lines and textures there; ticks
    /// beside the picture meet where sheets lie right. Braille at the top left says the row (a letter) and the column
    /// (a number), beside the title. The overview has a sheet of its own, the first. For a device of dots windows are
    /// whole dots apart. A PDF has all sheets; SVG and PNG are files with numbers: page-1.svg, page-2.svg.
    #[arg(long, value_name = "CxR")]
    pub(in crate::cli) sheets: Option<SheetGrid>,

    /// Draws only the N most telling shapes, and at most as many other lines
    ///
    /// For those who are new to tactile graphics: begin with 3 to 5, and draw more when these are known. In a drawing
    /// lines that meet are one shape. The overview of a photo outlines nothing else. What is left out is told. The same
    /// as --set lines.shapes=N. Range: 1 to 100.
    #[arg(long, value_name = "N", value_parser = shapes, conflicts_with = "lines")]
    simplify: Option<u8>,

    /// Draws contours only, no textures
    ///
    /// The same as --set figure.textures=false.
    #[arg(long, conflicts_with = "textures_only")]
    outlines: bool,

    /// Draws textures only: no contours, and so no overview
    ///
    /// The same as --set figure.lines=false --set overview=false.
    #[arg(long, hide_short_help = true)]
    textures_only: bool,

    /// Draws no overview
    ///
    /// The same as --set overview=false.
    #[arg(long)]
    no_overview: bool,

    /// Writes title and labels in braille, also where the profile says otherwise
    ///
    /// The same as --set braille=true. Of this and --no-braille the last one counts.
    #[arg(long, hide_short_help = true, overrides_with = "no_braille")]
    braille: bool,

    /// Writes no braille: the title is then for screen readers only
    ///
    /// Labels are left out, and listed. The same as --set braille=false.
    #[arg(long, hide_short_help = true, overrides_with = "braille")]
    no_braille: bool,

    /// Exchanges left and right, marks and frames included
    ///
    /// For machines that press a page up from its back. Not for swell paper.
    #[arg(long, hide_short_help = true)]
    mirror: bool,

    /// Draws the letters of texts, too
    ///
    /// Fingers cannot read letters, so texts of SVG drawings and of PDF pages are left out and listed, and so are rows
    /// of letters in the pixels of any picture. With this they are drawn like all else.
    #[arg(long, hide_short_help = true)]
    keep_text: bool,

    /// Draws the ground of scans in its colour
    ///
    /// Of a scan or photograph of a drawing the ground is taken for paper, and is blank, even where the paper is cream
    /// or grey, or lies in a shadow. With this it has the texture of its colour, as that of a poster should. So has the
    /// dark or white rim of a scanned photograph, which otherwise is left out.
    #[arg(long, hide_short_help = true)]
    keep_ground: bool,
}

impl Fitting {
    /// Puts what these options say of the picture on its sheet into those of the library.
    pub(in crate::cli) fn add_to(&self, options: Options) -> Options {
        let options = options.mirrored(self.mirror).keep_text(self.keep_text).keep_ground(self.keep_ground);
        let options = self.crop.into_iter().fold(options, Options::crop);
        self.width_mm.into_iter().fold(options, Options::width_mm)
    }

    /// Whether it takes several sheets: asked for, or because a figure is asked for that is wider than a sheet that
    /// stands upright. A page of dots is spread only where that is asked for; a width that is too large is refused.
    pub(in crate::cli) fn is_for_several_sheets(&self, profile: &Profile) -> bool {
        let page = &profile.page;
        let is_wider = self.width_mm.is_some_and(|width| width > page.width.min(page.height));
        self.sheets.is_some() || profile.dots.device.is_none() && is_wider
    }

    /// Whether they say how wide the figure is.
    pub(in crate::cli) fn has_width(&self) -> bool {
        self.width_mm.is_some()
    }

    /// What they change in the profile.
    pub(in crate::cli) fn changes(&self) -> Vec<Change> {
        let given = [
            (self.outlines, "--outlines", &["figure.textures=false"][..]),
            (self.textures_only, "--textures-only", &["figure.lines=false", "overview.on=false"]),
            (self.no_overview, "--no-overview", &["overview.on=false"]),
            (self.braille, "--braille", &["braille.on=true"]),
            (self.no_braille, "--no-braille", &["braille.on=false"]),
        ];
        let given = given.into_iter().filter(|(given, ..)| *given);
        let switches = given.flat_map(|(_, option, sets)| sets.iter().map(|set| Change::of_option(option, set)));
        let shapes = self
            .simplify
            .iter()
            .map(|most| Change::of_option(&format!("--simplify {most}"), &format!("lines.shapes={most}")));
        switches.chain(shapes).collect()
    }
}

/// A part of a picture. One in mm is refused before any picture is looked at: nobody knows the mm of a figure before it
/// is laid out.
fn part(text: &str) -> Result<Crop, String> {
    let crop: Crop = text.parse().map_err(|error: Error| error.to_string())?;
    if crop.is_in_mm() { Err(Error::PartInMm { part: crop.to_string() }.to_string()) } else { Ok(crop) }
}

fn shapes(text: &str) -> Result<u8, String> {
    let number = text.parse().ok().filter(|number| (1..=100).contains(number));
    number.ok_or_else(|| "give a whole number from 1 to 100".into())
}

fn width(text: &str) -> Result<f32, String> {
    let number = text.parse().ok().filter(|number| (3.0..=1200.0).contains(number));
    number.ok_or_else(|| "give a number of millimetres from 3 to 1200, with a point as in 120.5".into())
}
