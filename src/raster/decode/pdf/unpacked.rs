//! Refuses documents whose compressed parts unpack to more than the limit, before the whole document is read: hayro
//! unpacks each part at once, and a part of a megabyte can unpack to a gigabyte.

use std::io::Read;

use crate::Error;
use crate::raster::decode::job::{Limits, unpacks_too_far};

/// The format's name in messages.
pub(super) const FORMAT: &str = "PDF";

/// Most bytes that DEFLATE makes of one.
const MOST_FOR_ONE: u64 = 1032;

/// Most times a part is compressed again.
const MOST_TIMES: u32 = 3;

/// # Errors
/// If a part unpacks to more than the limit of memory.
pub(super) fn check(bytes: &[u8], limits: Limits) -> Result<(), Error> {
    let limit = limits.memory_mb.saturating_mul(1_000_000);
    let most = |packed: usize| (packed as u64).saturating_mul(MOST_FOR_ONE.pow(MOST_TIMES));
    if most(bytes.len()) <= limit {
        return Ok(());
    }
    let mut rest = bytes;
    while let Some(start) = find(rest, b"stream") {
        let part = &rest[start + b"stream".len()..];
        let part = part.strip_prefix(b"\r").unwrap_or(part);
        let part = part.strip_prefix(b"\n").unwrap_or(part);
        // The end of the part in front, which is called endstream, is found as well, and is no compressed part.
        if is_zlib(part) {
            let end = find(part, b"endstream").unwrap_or(part.len());
            if most(end) > limit && unpacks_beyond(&part[..end], limit) {
                return Err(unpacks_too_far(FORMAT, "a part", limits));
            }
            rest = &part[end..];
        } else {
            rest = part;
        }
    }
    Ok(())
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|window| window == what)
}

/// Whether bytes begin as zlib streams do.
fn is_zlib(bytes: &[u8]) -> bool {
    matches!(bytes, [first, second, ..]
        if first & 0x0F == 8 && first >> 4 <= 7 && u16::from_be_bytes([*first, *second]).is_multiple_of(31))
}

/// Whether bytes, unpacked as often as they go on being compressed, are more than `limit`. Nothing is kept of them.
fn unpacks_beyond(packed: &[u8], limit: u64) -> bool {
    let mut reader: Box<dyn Read + '_> = Box::new(packed);
    for _ in 0..MOST_TIMES {
        let mut unpacked = flate2::read::ZlibDecoder::new(reader);
        let mut head = [0; 2];
        let mut length = 0;
        while let Some(rest) = head.get_mut(length..).filter(|rest| !rest.is_empty()) {
            match unpacked.read(rest) {
                Ok(0) | Err(_) => return false, // ends or is broken after two bytes at most
                Ok(count) => length += count,
            }
        }
        let whole: Box<dyn Read + '_> = Box::new(std::io::Cursor::new(head).chain(unpacked));
        if is_zlib(&head) {
            reader = whole;
            continue;
        }
        // One that is broken at its end counts as far as it goes.
        return count(whole, limit) > limit;
    }
    count(reader, limit) > limit
}

/// Length of what is read, up to one above the limit.
fn count(reader: impl Read, limit: u64) -> u64 {
    let mut reader = reader.take(limit.saturating_add(1));
    let mut buffer = vec![0; 1 << 16];
    let mut total = 0;
    while let Ok(count @ 1..) = reader.read(&mut buffer) {
        total += count as u64;
    }
    total
}

#[cfg(test)]
mod tests;
