//! Options for what a person corrects.

use std::path::{Path, PathBuf};

use clap::Args;
use tactograph::{Crop, Error, Options};

use crate::cli::input;

/// Options of `tactograph convert` by which a person's decisions count.
#[derive(Debug, Args)]
pub(in crate::cli) struct Correcting {
    /// Takes the lines from a page that was changed in an editor, or from a picture of lines
    ///
    /// An SVG that "tactograph convert" made of the same part of the same picture, or any SVG with a layer called
    /// "lines" that covers the picture; or a picture of the same shape, black lines on white, which is followed along
    /// the middle of its strokes. Textures, overview and frame are made around them. Lines that are too near to others
    /// are left out, and told.
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    lines: Option<PathBuf>,

    /// Adds lines of a page or an SVG with a layer called "lines" to those that are found
    ///
    /// What is found along them, too near, gives way; what they only cross, or end before, stays.
    #[arg(long, value_name = "FILE.svg", conflicts_with = "lines", hide_short_help = true)]
    add_lines: Option<PathBuf>,

    /// Takes the areas of the textures from a page that was changed in an editor
    ///
    /// An area that was deleted stays blank; one that was moved to another group of textures has the colour of that.
    #[arg(long, value_name = "PAGE.svg", hide_short_help = true)]
    regions: Option<PathBuf>,

    /// Leaves a part of the picture blank: no lines, no textures; can be given several times
    ///
    /// As --crop: where it begins from the left and from the top, its width and its height, in pixels of the part that
    /// is drawn or in percent; or, with mm behind the number, in mm on the sheet from the figure's top left corner
    /// (10mm,20mm,30mm,15mm).
    #[arg(long, value_name = "X,Y,W,H", hide_short_help = true)]
    erase: Vec<Crop>,

    /// Leaves everything blank but this part of the picture; can be given several times
    ///
    /// The opposite of --erase, with the same measures. What is kept stays as large and where it is; --crop makes it as
    /// large as the sheet.
    #[arg(long, value_name = "X,Y,W,H", hide_short_help = true)]
    keep: Vec<Crop>,
}

/// Longest file of lines, bytes.
const MOST_BYTES: u64 = 500_000_000;

/// A change of the options, by the contents of a file.
type Change = fn(Options, &[u8]) -> Result<Options, Error>;

/// Files that were read, each with what it changes.
#[derive(Default)]
pub(in crate::cli) struct Corrections(Vec<(PathBuf, Vec<u8>, Change)>, [Vec<Crop>; 2]);

impl Correcting {
    /// The files.
    ///
    /// # Errors
    /// Everything that is wrong with them, also that they are for one picture.
    pub(in crate::cli) fn read(&self, pictures: usize, is_watched: bool) -> Result<Corrections, Vec<String>> {
        let files: [(&str, &Option<PathBuf>, Change); 3] = [
            ("--lines", &self.lines, |options, bytes| options.lines(bytes)),
            ("--add-lines", &self.add_lines, |options, bytes| options.add_lines(bytes)),
            ("--regions", &self.regions, |options, bytes| options.areas(bytes)),
        ];
        let (mut read, mut faults) = (Vec::new(), Vec::new());
        for (option, path, change) in files {
            let Some(path) = path else { continue };
            if is_watched {
                faults.push(format!("{option}: this is of one picture, and --watch is for many; convert it by itself"));
            } else if pictures > 1 {
                faults.push(format!(
                    "{option}: this is of one picture, but there are {pictures}; convert them one by one"
                ));
            }
            match input::read(path, MOST_BYTES, "this is too large; give a page") {
                Ok(bytes) => read.push((path.clone(), bytes, change)),
                Err(error) => faults.push(format!("{option} {}: {error:#}", path.display())),
            }
        }
        if faults.is_empty() { Ok(Corrections(read, [self.erase.clone(), self.keep.clone()])) } else { Err(faults) }
    }
}

impl Corrections {
    /// Whether there is a file among them.
    pub(in crate::cli) fn has_files(&self) -> bool {
        !self.0.is_empty()
    }

    /// Puts them into the options of the library.
    ///
    /// # Errors
    /// If a file is no page, with its name.
    pub(in crate::cli) fn add_to(&self, options: Options) -> Result<Options, (&Path, Error)> {
        let [erased, kept] = &self.1;
        let options = erased.iter().fold(options, |options, part| options.erase(*part));
        let options = kept.iter().fold(options, |options, part| options.keep(*part));
        self.0.iter().try_fold(options, |options, (path, bytes, change)| {
            change(options, bytes).map_err(|error| (path.as_path(), error))
        })
    }
}
