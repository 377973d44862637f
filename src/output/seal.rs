//! A number that is computed from a file and stands in it, so that a later look tells whether anybody has changed the
//! file.
//!
//! Whatever program writes a file again changes its bytes, and so does a person in a text editor: the number does not
//! fit any more.

/// FNV-1a of 64 bits (Fowler, Noll and Vo): a few operations a byte, and enough against accidents, which is all that is
/// asked for.
const START: u64 = 0xcbf2_9ce4_8422_2325;
const FACTOR: u64 = 0x0000_0100_0000_01b3;

/// Bytes of a seal.
pub(super) const LENGTH: usize = 16;

/// The seal of `bytes`: 16 hexadecimal digits.
pub fn of(bytes: &[u8]) -> String {
    let hash = bytes.iter().fold(START, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(FACTOR));
    format!("{hash:016x}")
}

/// A last line of XML that holds the seal of all before it.
pub(super) fn comment(body: &[u8]) -> String {
    format!("<!-- as written {} -->\n", of(body))
}

/// Whether bytes end with the [`comment`] of what is before it.
pub(super) fn is_commented(bytes: &[u8]) -> bool {
    let last = comment(&[]).len();
    bytes
        .split_at_checked(bytes.len().saturating_sub(last))
        .is_some_and(|(body, seal)| seal == comment(body).as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seals_are_fnv_1a() {
        // The values that its authors give.
        assert_eq!(of(b""), "cbf29ce484222325");
        assert_eq!(of(b"foobar"), "85944171f73967e8");
        assert_eq!(of(b"foobar").len(), LENGTH);
    }
}
