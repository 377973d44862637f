//! Regions of a picture as a tree over its traced contours, and the outlines of the most salient ones.
//!
//! ```text
//! traces, colours -> landscape -> watershed (basins) -> arcs (what is seen between them) -> merge -> Tree
//!                  Tree -> choose (the most salient) -> label_map -> border -> follow (which traces) -> outlines
//!                  Tree -> heights (of borders): how strong contours are
//! ```
//!
//! A watershed over the contours divides the picture into basins; they are merged, the least visible border first, into
//! ever larger regions (hierarchy of contours: Arbelaez et al. 2011). Every region that ever was is a candidate for an
//! outline.
//!
//! The numbers of `tree`, `arcs`, `merge`, `choose` and `heights` that have no other reason were chosen together on 50
//! photographs of BSDS500 (val), by how well outlines of pages agree with those of people, and tested on 50 others
//! (train, of which none had been looked at; since then all have): `docs/photographs.md` has the figures, and says on
//! which pictures later numbers were chosen.

mod arcs;
mod border;
mod bumps;
mod choose;
mod disc;
mod follow;
mod grid;
mod heights;
mod label_map;
mod main_thing;
mod majority;
mod mask;
mod merge;
mod outline;
mod subject;
mod trace;
mod traces;
mod tree;
mod watershed;

pub use choose::{Chosen, Params};
pub use grid::RegionGrid;
pub use heights::Heights;
pub use mask::Mask;
pub use trace::{OutlineAreas, RegionOutline, TracePoint, TracedContour};
pub use tree::{Detail, Tree};
