//! Colours are sorted as a person would say, areas keep their own colour, and stay calm.

mod areas;
mod calm;
mod fringe;
mod named;
#[path = "../common/page.rs"]
mod page;
mod scenes;
mod stains;
