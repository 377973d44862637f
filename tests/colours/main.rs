//! Colours are sorted as a person would say, areas keep their own colour, and stay calm.

#[path = "../common/page.rs"]
mod page;
mod named;
mod scenes;
mod stains;
