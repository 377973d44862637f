//! Input that is no picture, or a damaged or a huge one.

use tactograph::internals::raster::decode::{DecodeOptions, Header, Limits, decode};
use tactograph::internals::units::Size;
use tactograph::{Error, Note, Reason};

use crate::decode::{decode_to, fault, folder, open, read, whole};

#[test]
fn what_is_no_picture_is_named() {
    assert_eq!(whole(b"").err(), Some(Error::Empty));
    for (bytes, what) in [
        (&b"just some words in a file named .png"[..], "text"),
        (b"<!DOCTYPE html><html></html>", "HTML"),
        (b"PK\x03\x04....", "ZIP"),
        (b"\0\0\0\x20ftypheic....", "HEIC"),
        (b"\0\0\0\x20ftypavif....", "AVIF"),
    ] {
        let Err(Error::UnknownFormat { looks_like: Some(looks_like) }) = whole(bytes) else { panic!("{what}") };
        assert!(looks_like.contains(what), "{looks_like}");
    }
    assert_eq!(whole(&[0x00, 0x01, 0x02]).err(), Some(Error::UnknownFormat { looks_like: None }));
}

#[test]
fn a_picture_that_ends_early_is_refused() {
    for name in [
        "rgb.jpg",
        "rgb-420.jpg",
        "rgb-progressive.jpg",
        "rgb-restart.jpg",
        "grey.jpg",
        "ycck.jpg",
        "rgb.png",
        "rgb-interlaced.png",
        "rgb.webp",
        "rgb.tif",
        "rgb.bmp",
        "rgb.gif",
        "rgb.ppm",
        "rgb.svgz",
    ] {
        let bytes = read(name);
        // Cut where pixels are missing, not only the end mark (12 bytes and a checksum of 4 in a PNG).
        for part in [3, 4, 5, 6, 7, 8, 9] {
            let cut = &bytes[..(bytes.len() - 20) * part / 10];
            let fault = whole(cut).err().unwrap_or_else(|| panic!("{name}: {part} tenths are read"));
            assert!(matches!(fault, Error::Undecodable { .. }), "{name}: {fault:?}");
            assert_eq!(fault.to_string().lines().count(), 1, "{name}: {fault}");
            if !name.ends_with("webp") && !name.ends_with("svgz") {
                assert!(fault.to_string().contains("the file ends before the picture does"), "{name}, {part}: {fault}");
            }
        }
    }
}

#[test]
fn a_jpeg_without_its_end_mark_is_whole() {
    for name in ["rgb.jpg", "rgb-420.jpg", "rgb-restart.jpg", "grey.jpg", "cmyk-adobe.jpg"] {
        let bytes = read(name);
        let picture = whole(bytes.strip_suffix(&[0xFF, 0xD9]).unwrap()).unwrap();
        assert_eq!(picture.raster, open(name).raster, "{name}");
    }
}

#[test]
fn a_palette_in_a_tiff_is_refused_by_name() {
    // The tiff crate does not read them. When it does, this test says so.
    let fault = fault(&read("palette.tif"));
    assert!(fault.contains("this kind of TIFF is not read (Photometric interpretation RGBPalette"), "{fault}");
}

/// Where the frame header of a baseline JPEG begins.
fn frame(jpeg: &[u8]) -> usize {
    jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a baseline JPEG")
}

#[test]
fn rare_kinds_of_jpeg_are_refused_by_name() {
    assert!(fault(&read("rgb-arithmetic.jpg")).contains("arithmetic"));
    let with_frame = |kind: u8, bits: u8| {
        let mut bytes = read("rgb.jpg");
        let at = frame(&bytes);
        (bytes[at + 1], bytes[at + 4]) = (kind, bits);
        fault(&bytes)
    };
    assert!(with_frame(0xC1, 12).contains("12 bits"), "{}", with_frame(0xC1, 12));
    assert!(with_frame(0xC5, 8).contains("hierarchical"), "{}", with_frame(0xC5, 8));
    let mut lossless = read("grey.jpg");
    let at = frame(&lossless);
    lossless[at + 1] = 0xC3;
    assert!(fault(&lossless).contains("lossless"), "{}", fault(&lossless));
}

/// Headers of a picture of 30000 x 30000 pixels; there is nothing behind them.
fn huge() -> Vec<(&'static str, Vec<u8>)> {
    let mut png = b"\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR\0\0\x75\x30\0\0\x75\x30\x08\x02\0\0\0".to_vec();
    png.extend(0xE945_6FED_u32.to_be_bytes());
    let mut bmp = read("rgb.bmp");
    bmp[18..22].copy_from_slice(&30000u32.to_le_bytes());
    bmp[22..26].copy_from_slice(&30000u32.to_le_bytes());
    let mut tiff = read("rgb.tif");
    let directory = u32::from_le_bytes(tiff[4..8].try_into().expect("four bytes")) as usize;
    for entry in [0, 1, 7] {
        // width, height, rows in a strip
        let value = directory + 2 + 12 * entry + 8;
        tiff[value..value + 4].copy_from_slice(&30000u32.to_le_bytes());
    }
    let mut jpeg = read("rgb.jpg");
    let at = frame(&jpeg);
    jpeg[at + 5..at + 9].copy_from_slice(&[0x75, 0x30, 0x75, 0x30]);
    let mut gif = read("rgb.gif");
    gif[6..10].copy_from_slice(&[0x30, 0x75, 0x30, 0x75]);
    vec![
        ("PNG", png),
        ("BMP", bmp),
        ("TIFF", tiff),
        ("JPEG", jpeg),
        ("GIF", gif),
        ("PNM", b"P6 30000 30000 255\n".to_vec()),
    ]
}

#[test]
fn a_header_over_a_limit_is_refused_by_name() {
    for (format, bytes) in huge() {
        let Err(fault) = whole(&bytes) else { panic!("{format} is read") };
        let size = Size::new(30000, 30000);
        assert!(
            matches!(fault, Error::TooManyPixels { size: s, limit_megapixels: 300, .. } if s == size),
            "{format}: {fault}"
        );
    }
}

#[test]
fn memory_over_the_limit_is_refused_before_decoding() {
    let limits = Limits { megapixels: 1_000_000, memory_mb: 50 };
    let working_size = |_: Header| Ok(Size::new(1000, 1000));
    let options = DecodeOptions { limits, ..DecodeOptions::whole(&working_size) };
    for (format, bytes) in huge() {
        // PNG comes row by row, and gets as far as its missing pixels.
        let Err(fault) = decode(&bytes, &options) else { panic!("{format} is read") };
        match format {
            "PNG" => assert!(matches!(fault, Error::Undecodable { .. }), "{format}: {fault}"),
            _ => {
                assert!(matches!(fault, Error::TooMuchMemory { limit_mb: 50, .. }), "{format}: {fault}");
                assert!(fault.to_string().contains("50 MB"), "{fault}");
            }
        }
    }
}

#[test]
fn a_header_of_no_pixels_is_refused() {
    let mut jpeg = read("rgb.jpg");
    let at = frame(&jpeg);
    jpeg[at + 7..at + 9].fill(0);
    let mut bmp = read("rgb.bmp");
    bmp[18..22].fill(0);
    let mut gif = read("rgb.gif");
    gif[6..10].fill(0);
    for bytes in [jpeg, bmp, gif, b"P6 0 0 255\n".to_vec(), b"P5 0 7 255\n".to_vec()] {
        assert!(matches!(whole(&bytes), Err(Error::Undecodable { .. })), "{:?}", whole(&bytes).map(|p| p.source));
    }
}

#[test]
fn pictures_of_one_pixel_and_of_one_column_are_decoded() {
    for size in [Size::new(1, 1), Size::new(1, 10_000), Size::new(10_000, 1)] {
        let pgm =
            [format!("P5 {} {} 255\n", size.width, size.height).into_bytes(), vec![255; size.area() as usize]].concat();
        for target in [size, Size::new(1, 1), Size::new(size.width.div_ceil(3), size.height.div_ceil(3))] {
            let picture = decode_to(&pgm, &|_| Ok(target)).unwrap();
            assert_eq!(picture.raster.size(), target);
            assert!(picture.raster.planes().iter().flatten().all(|&v| v.total_cmp(&1.0).is_eq()));
        }
    }
}

/// A PNG of two pixels with a palette of `length` bytes.
fn with_palette(length: usize) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1A\n".to_vec();
    let header = [0, 0, 0, 2, 0, 0, 0, 1, 8, 3, 0, 0, 0]; // 2 x 1 pixels of 8 bits, each a number in the palette
    // one stored block of three bytes: the row's filter and two numbers
    let pixels = [0x78, 0x01, 1, 3, 0, 0xFC, 0xFF, 0, 0, 1, 0, 5, 0, 2];
    let palette: Vec<u8> = (0..length as u8).collect();
    for (name, data) in [(b"IHDR", &header[..]), (b"PLTE", &palette), (b"IDAT", &pixels), (b"IEND", &[])] {
        let checked = [name, data].concat();
        bytes.extend((data.len() as u32).to_be_bytes());
        bytes.extend_from_slice(&checked);
        bytes.extend(crc32(&checked).to_be_bytes());
    }
    bytes
}

/// The checksum of a chunk (PNG specification, annex D).
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32| if crc & 1 == 1 { 0xEDB8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), |crc, _| step(crc)))
}

#[test]
fn a_palette_of_broken_colours_is_refused_by_its_header() {
    let sound = whole(&with_palette(6)).unwrap();
    assert_eq!(sound.source.size, Size::new(2, 1));
    let broken = with_palette(7);
    assert_eq!(broken.len(), 90);
    let fault = fault(&broken);
    assert_eq!(
        fault,
        "the PNG picture cannot be read: its palette (chunk PLTE at byte 33) has 7 bytes, and a colour takes 3; \
         open and save it again in another program, or use another copy"
    );
    // Inside a drawing it is left out.
    let text: String = broken.iter().map(|byte| format!("%{byte:02X}")).collect();
    let drawing = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>\
         <image width='9' height='9' href='data:image/png,{text}'/></svg>"
    );
    let notes = whole(drawing.as_bytes()).unwrap().notes;
    assert!(
        matches!(&notes[..], [Note::LeftOut(Reason::Unreadable, what)] if what.contains("cannot be read")),
        "{notes:?}"
    );
}

/// Numbers that look random and are the same in every run (xorshift, Marsaglia 2003).
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end as u64) as usize
    }
}

#[test]
fn damaged_pictures_never_panic() {
    // TACTOGRAPH_DAMAGE=1000 tries harder.
    let rounds = std::env::var("TACTOGRAPH_DAMAGE").ok().and_then(|n| n.parse().ok()).unwrap_or(8);
    let mut names: Vec<_> = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    let limits = Limits { megapixels: 4, memory_mb: 64 };
    let working_size =
        |source: Header| Ok(Size::new(source.size.width.div_ceil(3).min(100), source.size.height.div_ceil(3).min(100)));
    let options = DecodeOptions { limits, ..DecodeOptions::whole(&working_size) };
    let mut panicked = Vec::new();
    for path in names {
        let whole = std::fs::read(&path).unwrap();
        if whole.is_empty() || matches!(path.extension().and_then(|e| e.to_str()), Some("py" | "md" | "ttf" | "icc")) {
            continue;
        }
        for round in 0..rounds {
            let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ (round + 1));
            let mut bytes = whole.clone();
            for _ in 0..=dice.below(8) {
                let at = dice.below(bytes.len());
                match dice.below(4) {
                    0 => bytes[at] = dice.below(256) as u8,
                    1 => bytes[at] ^= 1 << dice.below(8),
                    2 => bytes[at] = [0x00, 0xFF, 0x7F, 0x80][dice.below(4)],
                    _ if dice.below(4) == 0 => bytes.truncate(at + 1),
                    _ => {
                        let other = dice.below(bytes.len());
                        bytes.swap(at, other);
                    }
                }
            }
            let tried = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
                decode(&bytes, &options).map(|picture| {
                    assert!(
                        picture.raster.planes().iter().flatten().all(|v| (0.0..=1.0).contains(v)),
                        "light out of range"
                    );
                })
            }));
            // What `decode` itself catches counts as well: this test is how such pictures are found.
            match tried {
                Ok(Err(fault)) if fault.to_string().contains("its decoder failed") => {
                    panicked.push(format!("{}, round {round}: {fault}", path.display()));
                }
                Ok(_) => {}
                Err(_) => panicked.push(format!("{}, round {round}", path.display())),
            }
        }
    }
    assert!(panicked.is_empty(), "{}", panicked.join("\n"));
}

#[test]
fn every_hundredth_of_a_file_is_a_picture_or_one_clear_line() {
    let mut paths: Vec<_> = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let limits = Limits { megapixels: 4, memory_mb: 64 };
    let working_size = |_: Header| Ok(Size::new(16, 16));
    let options = DecodeOptions { limits, ..DecodeOptions::whole(&working_size) };
    let (mut faults, mut refused) = (Vec::new(), 0);
    for path in paths {
        let bytes = std::fs::read(&path).unwrap();
        if matches!(path.extension().and_then(|e| e.to_str()), Some("py" | "md" | "ttf" | "icc")) {
            continue;
        }
        for percent in 1..100 {
            let cut = &bytes[..bytes.len() * percent / 100];
            let tried = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| decode(cut, &options).err()));
            let told = match tried {
                Ok(None) => continue,
                Ok(Some(fault)) => fault.to_string(),
                Err(_) => "a panic".to_owned(),
            };
            refused += 1;
            // a panic that `decode` itself catches counts as well
            let is_clear = told.lines().count() == 1 && told.len() < 400 && told.contains(' ') && told != "a panic";
            if !is_clear || told.contains("its decoder failed") || told.chars().any(char::is_control) {
                faults.push(format!("{}, {percent} %: {told}", path.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(refused > 1000, "{refused}");
}

/// A TIFF of floating point samples, two rows of two pixels.
fn float_tiff(planes: u32, samples: [f32; 4]) -> Vec<u8> {
    let data: Vec<u8> = samples.iter().flat_map(|value| value.to_le_bytes().repeat(planes as usize)).collect();
    let tags = 10_u32;
    let bits_at = 8 + 2 + 12 * tags + 4;
    let data_at = bits_at + 12;
    let mut tiff = b"II*\0\x08\0\0\0\x0a\0".to_vec();
    // a value of three numbers of 16 bits stands elsewhere, one number in the tag itself
    let three = |value: u32, at: u32| if planes == 3 { at } else { value };
    for (tag, kind, count, value) in [
        (256, 4, 1, 2),
        (257, 4, 1, 2),
        (258, 3, planes, three(32, bits_at)),
        (259, 3, 1, 1),
        (262, 3, 1, if planes == 3 { 2 } else { 1 }),
        (273, 4, 1, data_at),
        (277, 3, 1, planes),
        (278, 4, 1, 2),
        (279, 4, 1, data.len() as u32),
        (339, 3, planes, three(3, bits_at + 6)),
    ] {
        tiff.extend(u16::to_le_bytes(tag));
        tiff.extend(u16::to_le_bytes(kind));
        tiff.extend(u32::to_le_bytes(count));
        tiff.extend(u32::to_le_bytes(value));
    }
    tiff.extend([0; 4]);
    tiff.extend([32_u16, 32, 32, 3, 3, 3].map(u16::to_le_bytes).as_flattened());
    tiff.extend(data);
    tiff
}

#[test]
fn samples_of_floating_point_are_refused_by_name_whatever_they_hold() {
    let values = [[0.0, 0.2, 0.5, 1.0], [f32::NAN; 4], [f32::INFINITY, -1.0, 1e30, f32::MIN_POSITIVE]];
    for (planes, samples) in [1, 3].into_iter().flat_map(|planes| values.map(|samples| (planes, samples))) {
        let told = fault(&float_tiff(planes, samples));
        assert!(told.starts_with("the TIFF picture cannot be read: ") && told.contains("samples"), "{planes}: {told}");
        assert!(told.lines().count() == 1 && told.len() < 300, "{planes}: {told}");
    }
}
