//! Tests of `png_file`.

use super::*;

fn file(depth: BitDepth, filter: Filter, language: &str) -> (Vec<u8>, Vec<u8>) {
    let mut state = 1_u32;
    let noise = std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    });
    let pixels: Vec<u8> = noise.take(if depth == BitDepth::One { 20 * 70 } else { 160 * 70 }).collect();
    let words = [("A <\u{1}", language), ("", "en")];
    let file = PngFile { size: [160, 70], depth, filter, level: 6, per_metre: 787, words, origin: None };
    let written = file.write(|out| pixels.chunks(33).try_for_each(|part| out.write_all(part)));
    (written.expect("all pixels are there"), pixels)
}

#[test]
fn pixels_size_and_words_come_back() {
    for (depth, filter) in [(BitDepth::One, Filter::NoFilter), (BitDepth::Eight, Filter::Up)] {
        let (bytes, pixels) = file(depth, filter, "de");
        let mut reader = png::Decoder::new(io::Cursor::new(&bytes)).read_info().expect("a PNG");
        let mut back = vec![0; reader.output_buffer_size().expect("small")];
        reader.next_frame(&mut back).expect("a PNG");
        assert!(back == pixels, "{depth:?}");
        let info = reader.info();
        assert_eq!(info.pixel_dims.map(|dims| (dims.xppu, dims.unit)), Some((787, Unit::Meter)));
        let title = &info.utf8_text[0];
        assert_eq!((title.keyword.as_str(), title.language_tag.as_str()), ("Title", "de"));
        assert_eq!(title.get_text().expect("not compressed"), "A <\u{fffd}");
    }
    assert!(file(BitDepth::One, Filter::NoFilter, "d\u{e9}").0.len() > 100, "a language that no PNG can hold");
}

/// No byte can change, and none be added, without anybody noticing.
#[test]
fn changes_are_seen() {
    let (mut bytes, _) = file(BitDepth::One, Filter::NoFilter, "en");
    assert!(is_as_written(&bytes));
    for at in 0..bytes.len() {
        bytes[at] ^= 1;
        assert!(!is_as_written(&bytes), "byte {at}");
        bytes[at] ^= 1;
    }
    assert!(!is_as_written(&[&bytes[..], b"\n"].concat()) && !is_as_written(&bytes[1..]) && !is_as_written(b""));
}
