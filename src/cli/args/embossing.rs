//! Options for embossers.

use clap::Args;

/// Options of `tactograph convert` that only some embossers have.
#[derive(Debug, Args)]
pub(in crate::cli) struct Embossing {
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
