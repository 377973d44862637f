//! Tests of `pixels`.

use super::*;

fn pixels(bytes: &[u8]) -> (u32, u32, Vec<u8>, Option<u32>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    reader.next_frame(&mut pixels).expect("a PNG");
    let info = reader.info();
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Grayscale, png::BitDepth::Eight));
    (info.width, info.height, pixels, info.pixel_dims.map(|dims| dims.xppu))
}

#[test]
fn a_pixel_is_a_dot() {
    let matrix = DotMatrix::drawn(".-+#\n#...\n");
    let words = DocumentWords { title: "A < B\u{1}", language: "en", ..DocumentWords::default() };
    let seen = |pitch, has_heights| pixels(&write(&matrix, pitch, has_heights, &words));
    assert_eq!(seen(1.27, true), (4, 2, vec![255, 170, 85, 0, 0, 255, 255, 255], Some(787)));
    assert_eq!(seen(2.5, false), (4, 2, vec![255, 0, 0, 0, 0, 255, 255, 255], Some(400)));
    assert_eq!(pixels(&write(&DotMatrix::drawn("\n\n"), 2.5, false, &words)).2, [255]);
}
