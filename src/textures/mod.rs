//! Regions become textures: small rhombuses whose direction names the colour, dots for grey.
//!
//! Three things vary and nothing else: the *direction* of the lattice by class, the *boldness* of the glyph by
//! lightness, the *density* of the lattice by how many lines are near. Around every line the page stays white, and no
//! glyph crosses a boundary between classes or the edge of the picture. No glyph is smaller, and no two are nearer to
//! one another, than the least that is felt: where a colour fades into white its glyphs shrink to that size, and then
//! rows are left out.
//!
//! `lattice` documents which lattices fingers read right; [`crate::touch`] is the measure.

mod fill;
mod glyph;
pub(crate) mod lattice;
mod maps;
mod palette;
mod params;

#[cfg(test)]
mod tests;

pub use fill::{fill, leave_out_cells, leave_out_crumbs, sample};
pub use glyph::{Glyph, Shape, Texture};
pub use palette::{LEAST_ANGLE, Palette, Sign};
pub use params::Params;

pub(crate) use glyph::{boldness_of, unit};
pub(crate) use maps::{RegionMap, line_density};
