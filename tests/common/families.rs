//! Profiles in families. Those of a family find contours and sort colours by the same numbers (`tests/relations.rs` asks
//! them all), so that a relation which holds for one of them holds for all.

use tactograph::internals::profile::{Plan, Profile};

/// The profile that is used when none is named; swell paper of other sizes and plain paper are of its family.
pub(crate) const DEFAULT: &str = "swell-a4";

/// One profile of each family of dots: embossers on a grid (Index, Enabling Technologies), with dots anywhere, by text
/// cells and with heights, and pin displays.
pub(crate) const DOTS: [&str; 5] = ["index-basic-d", "braillerap", "braille-cells", "viewplus-columbia", "graphiti"];

/// One profile of each family.
pub(crate) fn all() -> impl Iterator<Item = &'static str> {
    std::iter::once(DEFAULT).chain(DOTS)
}

/// What a built-in profile asks of each stage.
pub(crate) fn plan(profile: &str) -> Plan {
    Plan::new(&Profile::named(profile).expect("it is built in")).expect("built-in profiles make sense")
}
