//! A part of a picture is what it would be if the rest had been cut off first.

use tactograph::Error;
use tactograph::internals::raster::crop::Crop;

use super::*;

fn part_of(bytes: &[u8], crop: &str, working_size: &dyn Fn(Header) -> Result<Size, Error>) -> Result<Decoded, Error> {
    let crop: Crop = crop.parse().expect("a part");
    decode(bytes, &DecodeOptions { crop: Some(crop), ..DecodeOptions::whole(working_size) })
}

/// The pixels of a part of a raster.
fn cut(raster: &Raster, left: u32, top: u32, size: Size) -> Vec<Vec<f32>> {
    let width = raster.size().width as usize;
    let rows = |plane: &Vec<f32>| -> Vec<f32> {
        let rows = plane.chunks(width).skip(top as usize).take(size.height as usize);
        rows.flat_map(|row| row[left as usize..][..size.width as usize].to_vec()).collect()
    };
    raster.planes().iter().map(rows).collect()
}

#[test]
fn every_format_gives_the_pixels_of_the_part() {
    for name in [
        "rgb.png",
        "rgb-interlaced.png",
        "grey-16.png",
        "rgb.jpg",
        "rgb-progressive.jpg",
        "rgb.bmp",
        "rgb.tif",
        "rgb.webp",
        "rgb.gif",
        "rgb.ppm",
        "rgb.svg",
        "orient-3.jpg",
        "orient-6.jpg",
        "orient-7.jpg",
    ] {
        let bytes = read(name);
        let all = open(name);
        let size = Size::new(20, 11);
        let part = part_of(&bytes, "7,3,20,11", &|source| Ok(source.size)).expect(name);
        assert_eq!((part.source.size, part.raster.size()), (size, size), "{name}");
        let want = cut(&all.raster, 7, 3, size);
        for (got, want) in part.raster.planes().iter().zip(&want) {
            let worst = got.iter().zip(want).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(worst < 1e-6, "{name}: {worst}");
        }
    }
}

/// Averages are over the part alone, also where a JPEG is decoded at a part of its size.
#[test]
fn a_part_is_shrunk_as_if_it_were_all() {
    for name in ["wide.jpg", "rgb.png", "rgb.svg"] {
        let bytes = read(name);
        let all = open(name).raster;
        let Size { width, height } = all.size();
        // whole blocks of a JPEG, so that its own way of shrinking sees the same pixels
        let (left, size) = (width / 4 / 8 * 8, Size::new(width / 2 / 8 * 8, height / 8 * 8));
        let crop = format!("{left},0,{},{}", size.width, size.height);
        let target = Size::new(size.width / 4, size.height / 4);
        let part = part_of(&bytes, &crop, &|_| Ok(target)).expect(name);
        assert_eq!(part.raster.size(), target, "{name}");
        let mean = |plane: &[f32]| plane.iter().sum::<f32>() / plane.len() as f32;
        for (got, want) in part.raster.planes().iter().zip(cut(&all, left, 0, size)) {
            assert!((mean(got) - mean(&want)).abs() < 0.02, "{name}: {} for {}", mean(got), mean(&want));
        }
    }
}

#[test]
fn a_part_beyond_the_picture_is_refused() {
    let fault = part_of(&read("rgb.png"), "60,0,10,10", &|source| Ok(source.size)).expect_err("it is not there");
    assert_eq!(
        fault.to_string(),
        "the part 60,0,10,10 reaches beyond the picture, which has 64 x 32 pixels; give a part that lies in it"
    );
}

/// A small part of a picture takes the memory of the part.
#[test]
fn limits_are_about_the_part_that_is_kept() {
    let limits = Limits { memory_mb: 1, ..Limits::default() };
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2000, 1000);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[90; 2000 * 1000 * 3]).expect("the pixels");
    writer.finish().expect("the end");
    let decode_part = |crop: Option<&str>| {
        let crop = crop.map(|crop| crop.parse().expect("a part"));
        decode(&bytes, &DecodeOptions { limits, crop, ..DecodeOptions::whole(&|source| Ok(source.size)) })
    };
    assert!(matches!(decode_part(None), Err(Error::TooMuchMemory { .. })));
    assert_eq!(decode_part(Some("90%,90%,10%,10%")).expect("little memory").raster.size(), Size::new(200, 100));
}
