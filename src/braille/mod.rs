//! Text to uncontracted braille: tables of the codes of ten languages, and what no table has is told.
//!
//! ```text
//! text -> translate (signs by their neighbours, numbers, capitals) -> cells -> wrap (lines; words by divide)
//! ```
//!
//! A cell is a byte: bit 0 is dot 1, bit 5 is dot 6; 0 is a blank.

mod address;
mod capitals;
mod cell;
mod characters;
mod code;
mod divide;
mod formula;
mod grouped;
mod joined;
mod neighbours;
mod numbers;
mod parse;
mod quotes;
mod table;
mod telephone;
mod translate;
mod translator;
mod wrap;

pub use cell::{CellSize, PRINTED, TRIAL, letter, number};
pub use characters::{characters, is_accent, is_greek, is_of_formula};
pub use code::{Code, Grade};
pub use formula::{is_formula, is_raised_or_lowered};
pub use grouped::is_in_groups;
pub use numbers::{is_script, power};
pub use table::Table;
pub use translate::{Braille, Lacking, unicode};
pub use translator::{Translate, Translator};
pub use wrap::{Divide, Wrapped, in_two, in_two_at_any_blank, wrap, wrap_beside};
