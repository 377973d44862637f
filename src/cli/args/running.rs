//! Options for many pictures.

use std::path::PathBuf;

use clap::Args;

/// Options of `tactograph convert` for many pictures.
#[derive(Debug, Args)]
pub(in crate::cli) struct Running {
    /// Writes a report of the run as JSON: of each picture its files, what check says, notes, errors and time
    ///
    /// Written when all pictures are done, also if some could not be converted. An existing file is replaced; - stands
    /// for standard output.
    #[arg(long, value_name = "FILE.json", hide_short_help = true)]
    pub(in crate::cli) report: Option<PathBuf>,

    /// Goes on until it is stopped, and converts every picture that is saved into this directory
    ///
    /// A page that was changed in an editor is written anew in the same way, as with "tactograph render"; one that was
    /// made with another profile is laid out anew for this one. What lies there already is converted when it is saved
    /// again. What goes wrong is told, and it goes on. Ctrl-C stops it.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "report", "title", "alt", "page"])]
    #[arg(hide_short_help = true)]
    pub(in crate::cli) watch: Option<PathBuf>,
}
