//! Options that say in which format pages are written.

use std::path::Path;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use tactograph::{Depth, Dpi};

use crate::cli::places::{NO_NAME_OF_PREVIEW, is_std};
use crate::cli::product::{DrawingFormat, Format};

/// Options of all commands that write pages.
#[derive(Debug, Args)]
pub(in crate::cli) struct Writing {
    /// Format of the page: svg, pdf, png, or one of dots
    ///
    /// SVG to change it in a drawing program, PDF to print it, PNG for everything else.
    /// Needed only where no name says it: the ending of a name for -o does. SVG, PDF and PNG are in true millimetres;
    /// SVG and PDF have the same layers. The others hold dots and nothing else, and need a profile of an embosser or a
    /// pin display: ubrl is Unicode braille for CUPS, brf ASCII braille for any embosser, pef the Portable Embosser
    /// Format, idx for Index embossers, gcode for BrailleRAP, pixels a PNG picture with one pixel a dot, txt plain
    /// text. With such a profile SVG, PDF and PNG show the dots at their true size.
    ///
    /// [possible values: svg, pdf, png, ubrl, brf, pef, idx, gcode, pixels, txt] [default: svg]
    #[arg(long, value_name = "FORMAT", value_parser = format(), hide_possible_values = true)]
    format: Option<Format>,

    /// Also writes each page as a picture to look at: png, pdf or svg
    ///
    /// The preview of cup.idx is cup.idx.preview.png beside it; of several sheets cup.idx.preview-1.png and so on, but
    /// one PDF. It is the file that --format png would write. An existing file is treated like any other whose name the
    /// program makes up.
    #[arg(long, value_name = "FORMAT", value_parser = drawing(), hide_possible_values = true, hide_short_help = true)]
    preview: Option<DrawingFormat>,

    /// Pixels of one inch of the sheet, for PNG
    ///
    /// Take what the printer draws, then it has nothing to round: 300 and 600 are usual. The picture says its size in
    /// millimetres, so print it at 100 %. Range: 50 to 1200.
    ///
    /// [default: 300]
    #[arg(long, value_name = "N", value_parser = dpi)]
    dpi: Option<Dpi>,

    /// Draws PNG with smooth edges in 256 greys, for displays; without it, every pixel is black or white, for printers
    #[arg(long)]
    grey: bool,
}

/// How pages are written.
#[derive(Debug, Clone, Copy)]
pub(in crate::cli) struct Chosen {
    /// The format.
    pub(in crate::cli) format: Format,
    /// `--preview`.
    pub(in crate::cli) preview: Option<DrawingFormat>,
    /// `--dpi`.
    pub(in crate::cli) dpi: Dpi,
    /// `--grey`.
    pub(in crate::cli) depth: Depth,
}

impl Writing {
    /// What these options and the name for `-o` say together, and everything in them that does not go together.
    pub(in crate::cli) fn choose(&self, output: Option<&Path>) -> (Chosen, Vec<String>) {
        let mut faults = Vec::new();
        let told = output.filter(|path| !is_std(path));
        let of_name = told.and_then(Path::extension).and_then(|ending| Format::of_extension(ending.to_str()?));
        if let (Some(name), Some(by_name), Some(asked)) = (told, of_name, self.format)
            && by_name.extension() != asked.extension()
        {
            let (name, asked) = (name.display(), asked.name());
            faults.push(format!("{name}: this name does not go with --format {asked}; leave one out"));
        }
        // of two that go with the name, the one that is asked for
        let asked = self.format.filter(|asked| of_name.is_none_or(|by_name| by_name.extension() == asked.extension()));
        let format = asked.or(of_name).unwrap_or(Format::Drawing(DrawingFormat::Svg));
        let has_png =
            [Some(format), self.preview.map(Format::Drawing)].contains(&Some(Format::Drawing(DrawingFormat::Png)));
        for (option, given) in [("--dpi", self.dpi.is_some()), ("--grey", self.grey)] {
            if given && !has_png {
                faults.push(format!(
                    "{option} is for PNG, and this page is written as {}; leave it out, or give a name that ends in \
                     .png",
                    format.name().to_uppercase()
                ));
            }
        }
        if self.preview.is_some() && output.is_some_and(is_std) {
            faults.push(NO_NAME_OF_PREVIEW.into());
        }
        let depth = if self.grey { Depth::Grey } else { Depth::Bilevel };
        (Chosen { format, preview: self.preview, dpi: self.dpi.unwrap_or_default(), depth }, faults)
    }
}

fn dpi(text: &str) -> Result<Dpi, String> {
    let (least, most) = (Dpi::LEAST, Dpi::MOST);
    text.parse()
        .ok()
        .and_then(|dpi| Dpi::new(dpi).ok())
        .ok_or_else(|| format!("give a whole number from {least} to {most}"))
}

fn format() -> impl TypedValueParser<Value = Format> {
    let names = PossibleValuesParser::new(Format::ALL.iter().map(|format| format.name()));
    names.try_map(|name| Format::named(&name))
}

fn drawing() -> impl TypedValueParser<Value = DrawingFormat> {
    let names = PossibleValuesParser::new(DrawingFormat::ALL.iter().map(|format| format.name()));
    names.try_map(|name| DrawingFormat::named(&name))
}

/// Options of `tactograph convert` that only some embossers have.
#[derive(Debug, Args)]
pub(in crate::cli) struct EmbossingOptions {
    /// How many copies an Index embosser makes
    ///
    /// For --format idx. Range: 1 to 999.
    ///
    /// [default: 1]
    #[arg(long, value_name = "N", hide_short_help = true)]
    pub(in crate::cli) copies: Option<u16>,

    /// How hard an Index embosser strikes, for thick paper
    ///
    /// For --format idx. Range: 1 to 3.
    ///
    /// [default: 1]
    #[arg(long, value_name = "N", hide_short_help = true)]
    pub(in crate::cli) impact: Option<u8>,
}
