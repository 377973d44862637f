//! `--labels`: what is written in braille in the figure.

use std::path::Path;

use clap::{Args, ValueEnum};
use tactograph::{Error, KeySheets, Label, Options};

use crate::cli::input;

/// Largest list of labels, bytes: some hundred times what a page has room for.
const MOST_BYTES: u64 = 1 << 20;
/// The word for the texts of the drawing itself.
const TEXTS: &str = "texts";

/// Labels in braille.
#[derive(Debug, Args)]
pub(in crate::cli) struct Labels {
    /// Labels in braille: a file with x, y and a text in each row, or "texts" for those of a drawing
    ///
    /// The file has rows such as 30%,45%,apple: how far from the left and from the top of the picture (or of the part
    /// that --crop takes), in percent or in pixels, and what the label says. With the word texts in place of a
    /// file, the texts of an SVG drawing or a page of PDF become labels where they stand, and with --ocr those of a
    /// bitmap.
    ///
    /// Each label is put beside its point, 3 mm from lines; textures make room. Where it has to lie further
    /// away, a thin line leads to its point; where there is no room for all of it, it is abbreviated, and you
    /// are told.
    #[arg(long, value_name = "FILE.csv|texts", hide_short_help = true)]
    labels: Option<String>,

    #[command(flatten)]
    key: WithKey,

    /// Page number in braille, at the top on the right
    ///
    /// The sheets that follow it, such as the overview of a page of dots and the key, have the next numbers. Without
    /// it, only the sheets of a key are numbered, where there are several.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=9999), hide_short_help = true)]
    number: Option<u32>,

    /// Writes braille by a table of an installed liblouis; "contracted" takes that of the language
    ///
    /// For contracted braille (grade 2) in German, English, French, Portuguese, Spanish or Swedish, or with
    /// any table such as da-dk-g26.ctb. Needs the program lou_translate of liblouis. Without it, braille is
    /// uncontracted, unless the profile says braille.grade = 2, which is the same as "contracted".
    #[arg(long, value_name = "TABLE|contracted", hide_short_help = true)]
    pub(in crate::cli) braille_table: Option<String>,

    /// Reads the texts of a bitmap with an installed Tesseract, in the language of --lang
    ///
    /// What it reads is listed, and with --labels texts written in braille where it stands. Look at it: letters in
    /// pictures are small, and some are read wrongly. Needs the program tesseract with its data of the language.
    #[arg(long, conflicts_with = "keep_text", hide_short_help = true)]
    pub(in crate::cli) ocr: bool,
}

/// Whether a key follows.
#[derive(Debug, Clone, Copy, Args)]
pub(in crate::cli) struct WithKey {
    /// When a key follows on a sheet of its own, in braille: auto, always or never
    ///
    /// It has the colours that occur, each as a patch of its texture with its name, and what abbreviations
    /// stand for. With auto there is one where labels are abbreviated; after "render" on the
    /// device of the page itself, where that is new.
    #[arg(long, value_name = "WHEN", value_enum, default_value_t = When::Auto, hide_short_help = true)]
    key: When,
}

/// When there is a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(in crate::cli) enum When {
    /// Where labels are abbreviated.
    #[default]
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// What is to be written.
#[derive(Debug, Clone, Default)]
pub(in crate::cli) struct GivenLabels {
    labels: Vec<Label>,
    texts: bool,
    key: When,
    number: Option<u32>,
}

impl Labels {
    /// Whether a file is given, whose points are those of one picture.
    pub(in crate::cli) fn is_for_one_picture(&self) -> bool {
        self.labels.as_deref().is_some_and(|labels| labels != TEXTS)
    }

    /// Whether a page number is given.
    pub(in crate::cli) fn is_numbered(&self) -> bool {
        self.number.is_some()
    }

    /// Whether there are any.
    pub(in crate::cli) fn are_given(&self) -> bool {
        self.labels.is_some()
            || self.key.key == When::Always
            || self.braille_table.is_some()
            || self.number.is_some()
            || self.ocr
    }

    /// Reads the file.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its line.
    pub(in crate::cli) fn read(&self) -> Result<GivenLabels, Vec<String>> {
        match self.labels.as_deref() {
            None => Ok(GivenLabels { key: self.key.key, number: self.number, ..GivenLabels::default() }),
            Some(TEXTS) => {
                Ok(GivenLabels { texts: true, key: self.key.key, number: self.number, ..GivenLabels::default() })
            }
            Some(path) => {
                let of_file = |what: String| vec![format!("--labels {path}: {what}")];
                let bytes = input::read(Path::new(path), MOST_BYTES, "this is too large for a list of labels")
                    .map_err(|error| of_file(format!("{error:#}")))?;
                let text = String::from_utf8(bytes)
                    .map_err(|_| of_file("this is not text in UTF-8; save it as CSV in UTF-8".to_owned()))?;
                let labels = Label::from_csv(&text).map_err(|error| match error {
                    Error::NotLabels(faults) => {
                        faults.into_iter().map(|fault| format!("--labels {path}, {fault}")).collect()
                    }
                    other => of_file(other.to_string()),
                })?;
                if labels.is_empty() {
                    return Err(of_file("this has no labels; write one a line, as x, y and text".to_owned()));
                }
                Ok(GivenLabels { labels, texts: false, key: self.key.key, number: self.number })
            }
        }
    }
}

impl WithKey {
    /// As the library takes it.
    pub(in crate::cli) fn sheets(self) -> KeySheets {
        self.key.sheets()
    }
}

impl When {
    fn sheets(self) -> KeySheets {
        match self {
            Self::Auto => KeySheets::Auto,
            Self::Always => KeySheets::Always,
            Self::Never => KeySheets::Never,
        }
    }
}

impl GivenLabels {
    /// When there is a key.
    pub(in crate::cli) fn key(&self) -> KeySheets {
        self.key.sheets()
    }

    /// Puts the labels into the options of the library.
    pub(in crate::cli) fn add_to(&self, options: Options) -> Options {
        let options = options.labels(self.labels.clone()).label_texts(self.texts).key(self.key());
        self.number.into_iter().fold(options, Options::page_number)
    }
}
