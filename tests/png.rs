//! PNG pages are what they claim to be: the true size to one pixel, black and white, the drawing of the SVG.

use crate::common::page;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tactograph::internals::output::png::{self as page_png, Depth, Dpi, is_as_written};
use tactograph::internals::output::svg;
use tactograph::{Error, Page};

const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="120" height="90">
<rect width="120" height="90" fill="#fff"/><circle cx="50" cy="45" r="35" fill="#c22"/></svg>"##;

fn page_on(sheet: &[(&str, &str)]) -> Page {
    page::page_of(DRAWING.as_bytes(), "Grünes \u{1F375}.svg", sheet, &mut |_| ()).page
}

fn dpi(dpi: u32) -> Dpi {
    Dpi::new(dpi).expect("in the range")
}

/// The PNG of a page without words in print, which need no fonts.
fn write(page: &Page, dpi: Dpi, depth: Depth) -> Result<Vec<u8>, Error> {
    page_png::write(page, dpi, depth, Default::default())
}

struct Picture {
    info: png::Info<'static>,
    /// One byte a pixel, 0 black and 255 white.
    pixels: Vec<u8>,
}

fn read(bytes: &[u8]) -> Picture {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("all pixels");
    reader.finish().expect("an end");
    Picture { info: reader.info().clone(), pixels }
}

/// The SVG as resvg draws it at once, in greys.
fn drawn(page: &Page, dpi: f32, size: (u32, u32)) -> Vec<u8> {
    let tree = Tree::from_str(&svg::write(page), &Options::default()).expect("an SVG");
    let mut pixmap = Pixmap::new(size.0, size.1).expect("memory");
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(dpi / 96.0, dpi / 96.0), &mut pixmap.as_mut());
    pixmap.pixels().iter().map(|pixel| pixel.green()).collect()
}

#[test]
fn sizes_are_true_to_one_pixel() {
    let sheets = [[210.0, 297.0], [215.9, 279.4], [60.3, 61.7]];
    for sheet in sheets {
        let [width, height] = sheet.map(|side: f32| side.to_string());
        let settings = [
            ("page.width", &*width),
            ("page.height", &*height),
            ("page.orientation", "portrait"),
            ("frame", "false"),
            ("overview", "false"),
        ];
        let page = page_on(&settings);
        for n in [Dpi::LEAST, 96, 300, 301] {
            let picture = read(&write(&page, dpi(n), Depth::Bilevel).expect("a PNG"));
            let pixels = [picture.info.width, picture.info.height].map(f64::from);
            let dims = picture.info.pixel_dims.expect("a size of its own");
            assert_eq!(dims.unit, png::Unit::Meter);
            for (per_metre, (pixels, mm)) in [dims.xppu, dims.yppu].into_iter().zip(pixels.into_iter().zip(sheet)) {
                let true_pixels = f64::from(mm) / 25.4 * f64::from(n);
                assert!((pixels - true_pixels).abs() <= 0.5, "{mm} mm at {n} dpi are {pixels} px, not {true_pixels}");
                let told_mm = pixels / f64::from(per_metre) * 1000.0;
                assert!((told_mm - f64::from(mm)).abs() <= 25.4 / f64::from(n), "{mm} mm at {n} dpi say {told_mm} mm");
            }
        }
    }
}

#[test]
fn pixels_are_those_of_the_drawing_whole_and_in_bands() {
    // 300 dpi is one band, the others are several; the last band is a shorter one.
    for (settings, n) in [(&[][..], 300), (&[("page.width", "120"), ("page.height", "231")], 1200), (&[], 601)] {
        let page = page_on(settings);
        let grey = read(&write(&page, dpi(n), Depth::Grey).expect("a PNG"));
        assert_eq!((grey.info.color_type, grey.info.bit_depth), (png::ColorType::Grayscale, png::BitDepth::Eight));
        let want = drawn(&page, n as f32, (grey.info.width, grey.info.height));
        let worst = grey.pixels.iter().zip(&want).map(|(a, b)| a.abs_diff(*b)).max();
        let off = grey.pixels.iter().zip(&want).filter(|(a, b)| a.abs_diff(**b) > 1).count();
        // Rounding in another place of the plane: single pixels of edges by a step of their smoothing.
        assert!(off as f64 <= 1e-4 * want.len() as f64 && worst <= Some(80), "{off} pixels differ, most by {worst:?}");

        let bits = read(&write(&page, dpi(n), Depth::Bilevel).expect("a PNG"));
        assert_eq!((bits.info.color_type, bits.info.bit_depth), (png::ColorType::Grayscale, png::BitDepth::One));
        assert!(bits.pixels.iter().zip(&grey.pixels).all(|(bit, grey)| *bit == if *grey < 128 { 0 } else { 255 }));
        let black = bits.pixels.iter().filter(|&&bit| bit == 0).count() as f64 / bits.pixels.len() as f64;
        assert!((0.01..0.5).contains(&black), "{black} of it is black");
    }
}

#[test]
fn words_are_in_the_file() {
    let page = page_on(&[]).called(None, Some("Ein Kreis\nmit Rand"), Some("de"));
    let picture = read(&write(&page, dpi(100), Depth::Bilevel).expect("a PNG"));
    let text = |keyword: &str| {
        let chunk = picture.info.utf8_text.iter().find(|chunk| chunk.keyword == keyword).expect("the text is there");
        (chunk.get_text().expect("text"), chunk.language_tag.clone())
    };
    assert_eq!(text("Title"), ("Grünes \u{1F375}.svg".into(), "de".into()));
    assert_eq!(text("Description"), ("Ein Kreis mit Rand".into(), "de".into()));
    assert!(text("Software").0.starts_with("tactograph "));
    assert!(text("Comment").0.lines().any(|line| line == "lines.width_max = 1.5"), "{:?}", text("Comment"));
}

#[test]
fn the_same_page_gives_the_same_bytes_and_a_change_is_seen() {
    let page = page_on(&[]);
    let bytes = write(&page, dpi(100), Depth::Bilevel).expect("a PNG");
    assert!(bytes == write(&page, dpi(100), Depth::Bilevel).expect("a PNG"));
    assert!(is_as_written(&bytes));
    for at in (0..bytes.len()).step_by(31) {
        let mut changed = bytes.clone();
        changed[at] ^= 1;
        assert!(!is_as_written(&changed), "byte {at}");
    }
    // As another program writes the same pixels again, with our texts or without.
    let picture = read(&bytes);
    let mut again = Vec::new();
    let mut encoder = png::Encoder::with_info(&mut again, picture.info.clone()).expect("an encoder");
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&picture.pixels).expect("the pixels");
    writer.finish().expect("the end");
    assert!(!is_as_written(&again));
    for other in [&b""[..], b"\x89PNG\r\n\x1a\n", &bytes[..bytes.len() - 1], &[&bytes[..], b"x"].concat()] {
        assert!(!is_as_written(other));
    }
}

#[test]
fn too_many_pixels_are_refused_before_they_are_drawn() {
    let page = page_on(&[("page.width", "1000"), ("page.height", "1000"), ("figure.resolution", "1")]);
    let error = write(&page, dpi(1200), Depth::Bilevel).expect_err("two thousand megapixels");
    assert!(matches!(error, Error::TooFine { dpi: 1200, .. }), "{error}");
    assert!(write(&page, dpi(Dpi::LEAST), Depth::Bilevel).is_ok());
    for n in [0, Dpi::LEAST - 1, Dpi::MOST + 1, u32::MAX] {
        assert_eq!(Dpi::new(n).map_err(|error| error.id()), Err("no-such-dpi"));
    }
    assert_eq!(Dpi::new(300), Ok(Dpi::default()));
}

/// Heights are greys, whatever is asked for.
#[test]
fn a_page_with_heights_is_grey() {
    let page = &page::of_sample("coffee.png", "viewplus-columbia").page;
    let png = write(page, dpi(100), Depth::Bilevel).expect("few pixels");
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    reader.next_frame(&mut pixels).expect("a PNG");
    for grey in [0, 85, 170, 255] {
        assert!(pixels.iter().filter(|&&pixel| pixel == grey).count() > 500, "no dots of grey {grey}");
    }
}
