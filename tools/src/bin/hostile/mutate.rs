//! Damage as it happens to files and as somebody does it on purpose: bits, cut ends, pieces of other files, absurd numbers.

use tactograph_tools::rng::Rng;

/// Bytes that decide most often: the least, the most, and both sides of the sign.
const BYTES: [u8; 6] = [0x00, 0x01, 0x7f, 0x80, 0xfe, 0xff];
/// Numbers of four bytes that sizes, offsets and counts fail at.
const WORDS: [u32; 8] = [0, 1, 0x7fff, 0xffff, 0x0001_0000, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff];
/// Numbers as text.
const NUMBERS: [&str; 16] = [
    "0",
    "-0",
    "-1",
    "1e-38",
    "1e38",
    "-1e38",
    "1e309",
    "NaN",
    "inf",
    "65536",
    "4294967296",
    "99999999999999999999",
    "0.0000001",
    "1e9",
    "-32769",
    "",
];

/// Damages a file once to three times; `other` lends pieces.
pub(crate) fn mutate(bytes: &[u8], other: &[u8], is_text: bool, rng: &mut Rng) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    for _ in 0..=rng.below(3) {
        damaged = if is_text && rng.below(4) > 0 { text(&damaged, other, rng) } else { once(damaged, other, rng) };
    }
    if damaged.starts_with(b"\x89PNG") && rng.coin() {
        // otherwise most damage would end at the checksums
        mend_checksums(&mut damaged);
    }
    damaged
}

/// A place in a file: anywhere, but half the time among the first 256 bytes, where headers are.
fn place(bytes: &[u8], rng: &mut Rng) -> usize {
    let end = if rng.coin() { bytes.len() } else { bytes.len().min(256) };
    rng.below(end.max(1))
}

/// Two places in order.
fn span(bytes: &[u8], rng: &mut Rng) -> std::ops::Range<usize> {
    let (a, b) = (rng.below(bytes.len() + 1), rng.below(bytes.len() + 1));
    a.min(b)..a.max(b)
}

fn once(mut bytes: Vec<u8>, other: &[u8], rng: &mut Rng) -> Vec<u8> {
    if bytes.is_empty() {
        return other.to_vec();
    }
    match rng.below(8) {
        0 => {
            for _ in 0..=rng.below(8) {
                let at = place(&bytes, rng);
                bytes[at] ^= 1 << rng.below(8);
            }
        }
        1 => {
            for _ in 0..=rng.below(8) {
                let at = place(&bytes, rng);
                bytes[at] = BYTES[rng.below(BYTES.len())];
            }
        }
        2 => bytes.truncate(bytes.len() * (1 + rng.below(99)) / 100),
        3 => {
            // the head of one on the body of another
            let (cut, from) = (place(&bytes, rng), rng.below(other.len() + 1));
            bytes.truncate(cut);
            bytes.extend(&other[from..]);
        }
        4 => {
            let piece = bytes[span(&bytes, rng)].to_vec();
            let at = place(&bytes, rng);
            bytes.splice(at..at, piece);
        }
        5 => {
            let start = place(&bytes, rng);
            let end = (start + 1 + rng.below(64)).min(bytes.len());
            bytes.drain(start..end);
        }
        6 => {
            let word = WORDS[rng.below(WORDS.len())];
            let at = place(&bytes, rng);
            let word = if rng.coin() { word.to_be_bytes() } else { word.to_le_bytes() };
            let wide = if rng.coin() { 4 } else { 2 };
            let end = (at + wide).min(bytes.len());
            bytes[at..end].copy_from_slice(&word[4 - wide..][..end - at]);
        }
        _ => {
            let at = place(&bytes, rng);
            let end = (at + 1 + rng.below(32)).min(bytes.len());
            for byte in &mut bytes[at..end] {
                *byte = rng.below(256) as u8;
            }
        }
    }
    bytes
}

/// Damage that keeps most of a text's grammar: numbers, elements and values change places.
fn text(bytes: &[u8], other: &[u8], rng: &mut Rng) -> Vec<u8> {
    let pieces = |wanted: fn(&u8) -> bool| -> Vec<std::ops::Range<usize>> {
        let mut found = Vec::new();
        let mut start = None;
        for (at, byte) in bytes.iter().enumerate() {
            match (wanted(byte), start) {
                (true, None) => start = Some(at),
                (false, Some(from)) => {
                    found.push(from..at);
                    start = None;
                }
                _ => {}
            }
        }
        found.extend(start.map(|from| from..bytes.len()));
        found
    };
    let replaced =
        |range: std::ops::Range<usize>, with: &[u8]| [&bytes[..range.start], with, &bytes[range.end..]].concat();
    match rng.below(5) {
        0 | 1 => {
            let numbers = pieces(|byte| byte.is_ascii_digit() || b".-".contains(byte));
            let Some(number) = numbers.get(rng.below(numbers.len().max(1))) else { return bytes.to_vec() };
            replaced(number.clone(), NUMBERS[rng.below(NUMBERS.len())].as_bytes())
        }
        2 => {
            let words = pieces(u8::is_ascii_alphabetic);
            let (Some(word), Some(with)) =
                (words.get(rng.below(words.len().max(1))), words.get(rng.below(words.len().max(1))))
            else {
                return bytes.to_vec();
            };
            replaced(word.clone(), &bytes[with.clone()])
        }
        3 => {
            // an element or a line again, many times or not at all
            let lines = pieces(|byte| *byte != b'\n' && *byte != b'>');
            let Some(line) = lines.get(rng.below(lines.len().max(1))) else { return bytes.to_vec() };
            let line = line.start..(line.end + 1).min(bytes.len());
            let times = [0, 2, 3, 500][rng.below(4)];
            replaced(line.clone(), &bytes[line].repeat(times))
        }
        _ => {
            let (cut, from) = (rng.below(bytes.len() + 1), rng.below(other.len() + 1));
            let end = (from + rng.below(400)).min(other.len());
            replaced(cut..cut, &other[from..end])
        }
    }
}

/// Right checksums for all chunks that can be found.
pub(crate) fn mend_checksums(png: &mut [u8]) {
    let mut at = 8;
    while let Some(length) = png.get(at..at + 4) {
        let length = u32::from_be_bytes([length[0], length[1], length[2], length[3]]) as usize;
        let Some(end) = (at + 8).checked_add(length).filter(|end| end + 4 <= png.len()) else { break };
        let sum = crc32fast::hash(&png[at + 4..end]);
        png[end..end + 4].copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}
