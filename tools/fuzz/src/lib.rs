//! One fuzz target for each of `tactograph_tools::fuzz::TARGETS`.

pub use libfuzzer_sys;
pub use tactograph_tools::fuzz;

/// Runs a target on whatever libFuzzer gives. Panics that the library catches are told once for each place; any other
/// ends the run with the input in a file.
#[macro_export]
macro_rules! run {
    ($name:literal) => {
        $crate::libfuzzer_sys::fuzz_target!(init: $crate::fuzz::listen(), |bytes: &[u8]| {
            $crate::fuzz::target($name).expect("a target of this name")(bytes)
        });
    };
}
