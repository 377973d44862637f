//! What the program says of a panic: nothing when it happens, since the library catches those of decoders and tells
//! them as faults of the picture; one line when nobody has caught it but the program.

use std::sync::{Mutex, PoisonError};

/// The panic that came last, with its place in the source.
static LAST: Mutex<String> = Mutex::new(String::new());

/// From now on panics are kept instead of written to standard error. With `RUST_BACKTRACE` set, which asks for more
/// than a line, they are written as well.
pub(super) fn keep() {
    let usual = std::env::var_os("RUST_BACKTRACE").map(|_| std::panic::take_hook());
    std::panic::set_hook(Box::new(move |panic| {
        let text = panic.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        *LAST.lock().unwrap_or_else(PoisonError::into_inner) = text;
        if let Some(usual) = &usual {
            usual(panic);
        }
    }));
}

/// What to say of a panic that the program itself has caught.
pub(super) fn line() -> String {
    let last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    format!("an error in tactograph itself ({last}); please report it with this line and the picture")
}
