//! What may be said on the command line, and the help that teaches it.

mod calibrate;
mod check;
mod correcting;
mod describe;
mod feel;
mod fitting;
mod labels;
mod pages;
mod render;
mod running;
mod shared;
mod subject;
mod trace;
mod words;
mod writing;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand};

pub(super) use self::calibrate::Calibrate;
pub(super) use self::check::{Check, CheckFormat};
pub(super) use self::correcting::{Correcting, Corrections};
pub(super) use self::describe::Describe;
pub(super) use self::feel::Feel;
pub(super) use self::fitting::Fitting;
pub(super) use self::labels::{GivenLabels, Labels};
pub(super) use self::pages::Pages;
pub(super) use self::render::Render;
pub(super) use self::running::Running;
pub(super) use self::shared::Shared;
pub(super) use self::subject::Subject;
pub(super) use self::trace::Trace;
pub(super) use self::words::Words;
pub(super) use self::writing::{Chosen, EmbossingOptions, Writing};
use super::report::{Exit, Report};

const ABOUT: &str = "Turns colour pictures into tactile graphics: pages that blind people read with their fingers";

const LONG_ABOUT: &str = "\
Turns colour pictures into tactile graphics: pages that blind people read with their fingers.

The contours of the picture become raised lines; the stronger a contour, the broader its line. The colours become \
textures: rhombuses in rows that run across for blue, up to the right for green, up and down for yellow, down to the \
right for red; dots for greys; nothing for white. Darker colours have larger glyphs. A small overview with lines only \
lies below the figure.

The page is in true millimetres: an SVG drawing to be changed in a program such as Inkscape, a PDF to be printed, or a \
PNG picture. Print it at 100 % on swell paper and heat it. With the profile of an embosser or a pin display it is \
dots.";

const AFTER_HELP: &str = "\
Examples:
  tactograph convert coffee.png             makes coffee.svg beside the picture
  tactograph convert coffee.png -o page.pdf
  tactograph render coffee.svg -o page.pdf  writes it as a PDF, after it was changed in an editor
  tactograph check coffee.svg               what fingers could not read of it
  tactograph feel coffee.svg                what a fingertip would feel of it
  tactograph profiles                       which papers there are

Exit codes: 0 done, 1 a picture could not be converted, 2 wrong usage.
More about converting: tactograph convert --help";

const CONVERT_LONG_ABOUT: &str = "\
Makes a page of each picture.

Formats read: JPEG, PNG, WebP, TIFF, BMP, GIF (first frame), PNM, SVG and pages of PDF. The format is told from the \
contents, not from the name. Written are SVG, PDF and PNG, and dots for embossers and pin displays, as the name for \
-o ends or --format says.

The page of photo.png is photo.svg beside it, unless -o or --out-dir say otherwise. Where that is the picture itself, \
because the picture is photo.svg, the page is photo.page.svg: a picture is never overwritten. Nor is a file that \
tactograph did not write, or a page that was changed in an editor, unless -o names it.

Several pictures are worked on side by side. One that cannot be converted does not stop the others. Results are told \
in the order of the pictures.";

const CONVERT_AFTER_LONG_HELP: &str = "\
Examples:
  tactograph convert coffee.png
        makes coffee.svg beside the picture, for A4 swell paper
  tactograph convert coffee.png -o page.pdf --profile swell-a3
        makes a PDF, to be printed, and takes larger paper
  tactograph convert coffee.png -o page.png --dpi 600
        makes a picture for a printer of 600 dots per inch
  tactograph convert photos/*.jpg --out-dir pages --format pdf
        makes pages/NAME.pdf of every photo
  tactograph convert coffee.png --profile index-basic-d -o coffee.idx
        makes a page of dots for an embosser, and the overview on another sheet; -o look.pdf shows them
  tactograph convert week/*.png --titles week.csv --out-dir pages --profile index-basic-d --format idx --preview png
        makes dots with titles for an embosser, and a picture of each page to look at
  tactograph convert --watch week --out-dir pages --format pdf
        converts every picture, and every page changed in an editor, that is saved into a directory
  tactograph convert coffee.png --detail 0.2
        draws the main outlines only
  tactograph convert coffee.png --simplify 5
        draws the five most telling shapes, and at most five other lines
  tactograph convert photo.jpg --quality draft
        shows in less time what the page of a large picture will be like
  tactograph convert coffee.png --crop 20%,10%,50%,70% --width-mm 120
        draws a part of the picture, 120 mm wide
  tactograph convert worksheet.pdf --page 1-2
        makes worksheet-1.svg and worksheet-2.svg of the first two pages of a document
  tactograph convert chart.svg --title Rainfall --labels texts -o chart.pdf
        writes the title and the texts of a drawing in braille
  tactograph convert coffee.png --lines coffee.svg -o new.svg
        takes the lines of a page that was corrected in an editor, and makes the rest anew
  tactograph convert coffee.png --erase 0,0,30%,100% -o less.svg
        leaves a part of the picture blank
  tactograph convert coffee.png --subject 40%,20% --calm-background
        outlines first what is at that place, and leaves what is around it calm
  tactograph convert coffee.png --sheets 2x2 -o large.pdf
        spreads the picture over two by two sheets, and the overview on another
  tactograph convert coffee.png --outlines --set page.orientation=landscape
        draws lines without textures on a sheet that lies across
  tactograph convert coffee.png --set lines.width_max=1.2 --set overview=false
        changes two values of the profile
  curl https://example.org/cat.jpg | tactograph convert - > cat.svg
        reads from standard input and writes to standard output

Messages go to standard error, so that standard output carries nothing but a page. Colours in this help can be \
switched off with the environment variable NO_COLOR.

Exit codes:
  0  every page is written
  1  a picture could not be converted, or its page not written; the other pages are written
  2  wrong usage: an option, a profile or a value is wrong; nothing is written
  130  stopped with Ctrl-C; pages that were written are complete";

#[derive(Debug, Parser)]
#[command(name = "tactograph", version, about = ABOUT, long_about = LONG_ABOUT, after_help = AFTER_HELP)]
#[command(arg_required_else_help = true, subcommand_required = true)]
#[command(max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Makes pages of pictures
    #[command(long_about = CONVERT_LONG_ABOUT, after_long_help = CONVERT_AFTER_LONG_HELP)]
    #[command(after_help = "Examples, formats, ranges and exit codes: tactograph convert --help")]
    Convert(Box<Convert>),
    /// Writes a page that was changed in an editor, or not, in another format or for another device
    #[command(long_about = render::LONG_ABOUT, after_long_help = render::AFTER_LONG_HELP)]
    #[command(after_help = "What counts, examples and exit codes: tactograph render --help")]
    Render(Box<Render>),
    /// Writes the contours of pictures as data (JSON)
    #[command(long_about = trace::LONG_ABOUT, after_long_help = trace::AFTER_LONG_HELP)]
    #[command(after_help = "Format, unit, examples and exit codes: tactograph trace --help")]
    Trace(Trace),
    /// Makes a sheet of samples, to choose widths, gaps and textures for your paper by touch
    #[command(long_about = calibrate::LONG_ABOUT, after_long_help = calibrate::AFTER_LONG_HELP)]
    #[command(after_help = "What is on it, examples and exit codes: tactograph calibrate --help")]
    Calibrate(Calibrate),
    /// Tells whether fingers can read a page: every fault, where it is, and what to do
    #[command(long_about = check::LONG_ABOUT, after_long_help = check::AFTER_LONG_HELP)]
    #[command(after_help = "Examples and exit codes: tactograph check --help")]
    Check(Check),
    /// Tells in plain sentences what is on a page
    #[command(long_about = describe::LONG_ABOUT, after_long_help = describe::AFTER_LONG_HELP)]
    #[command(after_help = "Examples and exit codes: tactograph describe --help")]
    Describe(Describe),
    /// Tells what a fingertip would feel of a page's textures
    #[command(long_about = feel::LONG_ABOUT, after_long_help = feel::AFTER_LONG_HELP)]
    #[command(after_help = "What the report says, examples and exit codes: tactograph feel --help")]
    Feel(Feel),
    /// Lists the profiles (papers and their settings) that come with the program, or shows one
    #[command(long_about = "Lists the profiles that come with the program, one a line: name and description.\n\n\
        A profile is a paper with all settings that a page for it needs: sizes, line widths, textures. The first in \
        the list is used unless --profile names another.")]
    #[command(after_help = "Examples:\n  tactograph profiles\n  tactograph profiles show swell-a4\n  \
        tactograph profiles show swell-a4 > my.toml    a start for your own\n  \
        tactograph profiles show my.toml               your own, with what it inherits\n  \
        tactograph profiles keys > keys.md             every key there is")]
    Profiles(Profiles),
}

/// `tactograph convert`.
#[derive(Debug, Args)]
pub(super) struct Convert {
    /// Pictures to convert; - for standard input
    ///
    /// A picture from standard input goes to standard output unless -o names a file.
    #[arg(value_name = "PICTURE", required_unless_present = "watch", conflicts_with = "watch")]
    pub(super) pictures: Vec<PathBuf>,

    /// Where the page goes, for one picture; - for standard output
    ///
    /// The name ends in .svg, .pdf or .png, or in that of a format of dots, which says the format, or has no ending.
    /// An existing file is replaced in one step, when the new page is complete; until then, and if anything fails, it
    /// stays as it is.
    ///
    /// [default: the picture's name with the ending of the format, beside the picture]
    #[arg(short, long, value_name = "PAGE", conflicts_with = "out_dir")]
    pub(super) output: Option<PathBuf>,

    /// Directory for the pages, made if missing
    ///
    /// Each page has its picture's name with the ending of the format. Two pictures whose pages would have the same
    /// name are refused.
    ///
    /// [default: each page lies beside its picture]
    #[arg(long, value_name = "DIR")]
    pub(super) out_dir: Option<PathBuf>,

    #[command(flatten)]
    pub(super) running: Running,

    #[command(flatten)]
    pub(super) fitting: Fitting,

    #[command(flatten)]
    pub(super) subject: Subject,

    #[command(flatten)]
    pub(super) correcting: Correcting,

    #[command(flatten)]
    pub(super) writing: Writing,

    #[command(flatten)]
    pub(super) embossing: EmbossingOptions,

    #[command(flatten)]
    pub(super) words: Words,

    /// Tells on standard output what is on each page, as "tactograph describe" does
    #[arg(long, hide_short_help = true)]
    pub(super) describe: bool,

    #[command(flatten)]
    pub(super) labels: Labels,

    #[command(flatten)]
    pub(super) shared: Shared,
}

impl Convert {
    /// Everything that is wrong with the words for a page, and with `--describe`.
    pub(super) fn faults_of_words(&self) -> Vec<String> {
        let is_std = |path: &PathBuf| path.as_os_str() == "-";
        let is_page = match &self.output {
            Some(path) => is_std(path),
            None => self.out_dir.is_none() && self.pictures.iter().any(is_std),
        };
        let is_report = self.running.report.as_ref().is_some_and(is_std);
        let other = is_page.then_some(match self.output {
            Some(_) => "-o -; name a file with -o",
            None => "the page of a picture from there; name a file with -o",
        });
        let other = other.or(is_report.then_some("--report -; name a file for the report"));
        let pictures = self.running.watch.is_none().then_some(self.pictures.len());
        let output = other
            .filter(|_| self.describe)
            .map(|other| format!("--describe writes to standard output, and so does {other}"));
        output.into_iter().chain(self.words.faults(&self.labels, pictures, self.shared.page)).collect()
    }
}

/// `tactograph profiles`.
#[derive(Debug, Args)]
pub(super) struct Profiles {
    #[command(subcommand)]
    pub(super) command: Option<ProfilesCommand>,
}

/// What `tactograph profiles` can do beside listing.
#[derive(Debug, Subcommand)]
pub(super) enum ProfilesCommand {
    /// Prints every key of a profile with its unit, range, default and reason, as a Markdown page
    Keys,
    /// Prints a profile as TOML, with the unit, range and reason of every value as comments
    ///
    /// Of a file of your own every key is printed, also those that it inherits, with the line that each value comes
    /// from.
    Show {
        /// Name of the profile, as "tactograph profiles" lists it, or a .toml file of your own
        #[arg(value_name = "NAME|FILE.toml")]
        name: String,
    },
}

/// What became of the command line.
#[derive(Debug)]
pub(super) enum Parsed {
    /// It is right: this is to be done.
    Command(Box<Command>),
    /// It was answered already, with help, the version or an error.
    Shown(Exit),
}

/// Reads the command line. Help and version go to standard output; what is wrong goes to standard error in one line.
pub(super) fn parse(args: impl IntoIterator<Item = OsString>) -> Parsed {
    let args = args.into_iter().collect::<Vec<_>>();
    let error = match (Cli::try_parse_from(&args), value_of_braille(&args)) {
        (Ok(_), Some(value)) => {
            let what = format!("--braille takes no value, and there is no picture {value}: {OF_BRAILLE}");
            Report::plain().usage(&format!("{what}; see tactograph convert --help"));
            return Parsed::Shown(Exit::Usage);
        }
        (Ok(cli), None) => return Parsed::Command(Box::new(cli.command)),
        (Err(error), _) => error,
    };
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            let _ = error.print(); // nobody listens: a closed pipe
            Parsed::Shown(Exit::Done)
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let _ = error.print();
            Parsed::Shown(Exit::Usage)
        }
        _ => {
            let command = ["convert", "render", "trace", "calibrate", "check", "describe", "feel", "profiles"]
                .iter()
                .find(|name| args.get(1).is_some_and(|arg| arg == *name));
            let help = command.map_or_else(|| "--help".into(), |command| format!("{command} --help"));
            let told = error.to_string();
            let what = natural_mistake(&args, error.kind(), &told).unwrap_or_else(|| in_one_line(&told));
            Report::plain().usage(&format!("{what}; see tactograph {help}"));
            Parsed::Shown(Exit::Usage)
        }
    }
}

/// Plain words for what people do most often: a picture without a command, a command without a picture, a profile's
/// name without `show`.
fn natural_mistake(args: &[OsString], kind: ErrorKind, told: &str) -> Option<String> {
    let first = args.get(1)?.to_string_lossy();
    let second = args.get(2).map(|arg| arg.to_string_lossy());
    if let (ErrorKind::UnknownArgument, Some(option)) = (kind, short_with_two_hyphens(args, told)) {
        return Some(format!("there is no option -{option}, did you mean {option}"));
    }
    match kind {
        ErrorKind::UnknownArgument if told.contains("unexpected argument '--braille'") => {
            return Some(format!("there is no option --braille here: {OF_BRAILLE}"));
        }
        ErrorKind::TooManyValues if told.contains("'--braille'") => {
            return Some(format!("--braille takes no value: {OF_BRAILLE}"));
        }
        _ => {}
    }
    match (kind, &*first, second) {
        // The usage, which is told after the error itself, names it always.
        (ErrorKind::MissingRequiredArgument, verb @ ("convert" | "trace"), _)
            if in_one_line(told).contains("<PICTURE>") =>
        {
            Some(format!("name a picture to {verb}"))
        }
        (ErrorKind::MissingRequiredArgument, "profiles", _) => {
            Some("name a profile to show (tactograph profiles lists them), or a .toml file of your own".into())
        }
        (ErrorKind::MissingRequiredArgument, "calibrate", _) if in_one_line(told).contains("--output") => {
            Some("name a file for the sheets, such as -o sheet.pdf".into())
        }
        (ErrorKind::MissingRequiredArgument, "render", _) => {
            Some("name a page to render, and where it goes, such as page.svg -o page.pdf".into())
        }
        (ErrorKind::MissingRequiredArgument, "check", _) => Some("name a page to check".into()),
        (ErrorKind::MissingRequiredArgument, "describe", _) => Some("name a page to describe".into()),
        (ErrorKind::MissingRequiredArgument, "feel", _) => Some("name a page to feel".into()),
        (ErrorKind::InvalidSubcommand | ErrorKind::UnknownArgument, "profiles", Some(name))
            if !name.starts_with('-') =>
        {
            Some(format!("there is no command profiles {name}, did you mean: tactograph profiles show {name}"))
        }
        (ErrorKind::InvalidSubcommand, picture, _) if picture.contains('.') || picture == "-" => {
            Some(format!("there is no command {picture}, did you mean: tactograph convert {picture}"))
        }
        _ => None,
    }
}

/// What says in which braille words are written, for those who expect it of `--braille`.
const OF_BRAILLE: &str = "words are written in the braille of their language (--lang pl), or of a code that the \
    profile names (--set braille.code=de); the measures of cells are --set braille.cell=uk";

/// What stands behind `--braille` as if it were a value, such as `uk`, which is no name of a picture that is there.
fn value_of_braille(args: &[OsString]) -> Option<&str> {
    let behind = args.iter().zip(args.iter().skip(1)).filter(|(arg, _)| *arg == "--braille");
    let mut values = behind.filter_map(|(_, value)| value.to_str());
    values.find(|value| !value.starts_with('-') && !value.contains(['.', '/', '\\']) && !Path::new(value).exists())
}

/// The short option, such as `-o`, that was typed with a hyphen too many, if that is what clap does not know.
fn short_with_two_hyphens<'a>(args: &'a [OsString], told: &str) -> Option<&'a str> {
    let shorts = args.iter().filter_map(|arg| arg.to_str()?.split('=').next()?.strip_prefix('-'));
    let known = |option: &&str| {
        told.contains(&format!("'-{option}'"))
            && Cli::command().get_subcommands().any(|command| {
                command.get_arguments().any(|arg| {
                    arg.get_short().is_some_and(|c| option.strip_prefix('-') == Some(c.encode_utf8(&mut [0; 4])))
                })
            })
    };
    shorts.into_iter().find(known)
}

/// clap writes paragraphs: the error, tips, the usage, where to find help. Here the first two, as one line.
fn in_one_line(error: &str) -> String {
    let paragraphs = error.split("\n\n").map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "));
    let told = paragraphs.take_while(|part| !part.starts_with("Usage:") && !part.starts_with("For more"));
    let told = told.collect::<Vec<_>>().join("; ");
    told.strip_prefix("error: ").unwrap_or(&told).to_string()
}

#[cfg(test)]
mod tests;
