//! What draws with dots: braille embossers and pin displays, and where on a sheet each of them can put a dot.
//!
//! The table is [`Device::ALL`]. Sizes of paper come from the drivers: Index from those of CUPS (cups-filters) and
//! BrailleUtils, ViewPlus, Romeo and Juliet from libembosser, BrailleRAP from DesktopBrailleRAP.

mod area;
mod device;
mod table;

#[cfg(test)]
mod tests;

pub(crate) use area::{INDEX_MARGIN_V4, SHORTEST_SIDE, hundredths};
pub use device::{Device, DotArea, Family, Grid, Paper, Pitches};
