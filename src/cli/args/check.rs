//! `tactograph check` on the command line.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

pub(super) const LONG_ABOUT: &str = "\
Tells whether fingers can read a page: every fault with its place, its size, and what to do.

It looks at the page as it is drawn, so it can also be asked about a page that you changed in an editor. Widths, gaps, \
lengths, areas, sizes, margins, braille, colours and ink are held against the numbers of the page's own profile, or of \
the one that --profile names. A drawing of another program has no layers, so all of it is judged as ink.

Each finding is one line: error or warning, the rule, the place in words and in mm from the left and the top of \
the sheet, what is wrong, and what to do. Errors come first. The last line is the verdict: how much of the figure is \
faulty, and how much of its textures a model of a fingertip reads, and how much of them it could not judge.";

pub(super) const AFTER_LONG_HELP: &str = "\
Examples:
  tactograph check coffee.svg
        tells what is wrong with a page
  tactograph check pages/*.svg
        tells it of several pages
  tactograph check coffee.svg --mark faults.svg
        also draws a box around each fault, in a layer on top of the page
  tactograph check coffee.svg --profile swell-letter
        asks with the numbers of another profile
  tactograph check coffee.svg --format json
        writes the same as data; sarif is for programs that collect what checkers find
  tactograph check --rules
        lists the rules, with numbers, units and sources
  tactograph convert coffee.png -o - | tactograph check -
        checks a page from standard input

Exit codes:
  0  there are no errors; with --strict no warnings either
  1  there are errors, or a page could not be read
  2  wrong usage: an option, a profile or a value is wrong";

/// `tactograph check`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Check {
    /// Pages to check, SVG files; - for standard input
    ///
    /// Of several the name of each stands before its findings. --format json and sarif, and --mark, take one page.
    #[arg(value_name = "PAGE.svg", required_unless_present = "rules")]
    pub(in crate::cli) pages: Vec<PathBuf>,

    /// Profile whose numbers count: a name from "tactograph profiles" or a .toml file of your own
    ///
    /// [default: the one that the page was made with]
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub(in crate::cli) profile: Option<String>,

    /// How findings are written: text, json or sarif
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, hide_possible_values = true)]
    pub(in crate::cli) format: CheckFormat,

    /// Ends with exit code 1 on warnings too
    #[arg(long)]
    pub(in crate::cli) strict: bool,

    /// Also writes the page with a layer in which a box is drawn around each finding
    ///
    /// The name ends in .svg. Reading such a page later leaves the layer out. An existing file is replaced in one step.
    #[arg(long, value_name = "OUT.svg")]
    pub(in crate::cli) mark: Option<PathBuf>,

    /// Lists the rules: what each asks for, its number, and where that comes from
    #[arg(long, conflicts_with_all = ["pages", "mark", "strict"])]
    pub(in crate::cli) rules: bool,
}

/// How findings are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum CheckFormat {
    /// Lines that are read aloud.
    Text,
    /// Data.
    Json,
    /// SARIF 2.1.0.
    Sarif,
}
