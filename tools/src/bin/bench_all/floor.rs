//! Decoding a PNG and nothing else, as a process of its own: its start counts as ours does.

use std::ffi::OsString;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// First argument of that process; the picture follows.
pub(crate) const MODE: &str = "--decode-png";

/// What to run.
pub(crate) fn command(picture: &Path) -> Vec<OsString> {
    let this = std::env::current_exe().map_or_else(|_| "bench_all".into(), OsString::from);
    vec![this, MODE.into(), picture.into()]
}

/// Reads all rows, one after the other, as the leanest program would.
///
/// # Errors
/// The file is missing or no PNG.
pub(crate) fn decode(picture: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(picture)?)).read_info()?;
    while let Some(row) = reader.next_row()? {
        std::hint::black_box(row.data());
    }
    Ok(())
}
