//! Each format and each thing that can go wrong with colours, on the pictures of `tests/pictures` (see the README there).

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use tactograph::raster::Raster;
use tactograph::raster::decode::{Limits, Options, Picture, Source, decode};
use tactograph::units::Size;
use tactograph::{Error, Note};

/// The scene's quarters: red, green, blue, grey.
const SCENE: [[u8; 3]; 4] = [[200, 40, 40], [40, 160, 60], [40, 60, 200], [128, 128, 128]];

const SIZE: Size = Size::new(64, 32);

/// A step of an 8-bit sample is at most this much light.
const STEP: f32 = 0.009;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pictures")
}

fn read(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn no_fonts() -> Arc<usvg::fontdb::Database> {
    Arc::default()
}

fn decode_to(bytes: &[u8], working_size: &dyn Fn(Source) -> Result<Size, Error>) -> Result<Picture, Error> {
    decode(bytes, &Options { limits: Limits::default(), fonts: &no_fonts, working_size })
}

/// At the size of the source.
fn whole(bytes: &[u8]) -> Result<Picture, Error> {
    decode_to(bytes, &|source| Ok(source.size))
}

fn open(name: &str) -> Picture {
    whole(&read(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn fault(bytes: &[u8]) -> String {
    match whole(bytes) {
        Ok(_) => panic!("this should not be read"),
        Err(fault) => fault.to_string(),
    }
}

fn linear(sample: f32) -> f32 {
    let value = sample / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

fn light(colour: [u8; 3]) -> [f32; 3] {
    colour.map(|sample| linear(sample.into()))
}

/// Grey as the test pictures have it: rounded luma of the scene.
fn grey(colour: [u8; 3]) -> f32 {
    let [r, g, b] = colour.map(f32::from);
    (0.299 * r + 0.587 * g + 0.114 * b).round()
}

/// The values in the middle of the quarters.
fn quarters(raster: &Raster) -> [Vec<f32>; 4] {
    let Size { width, height } = raster.size();
    [(1, 1), (3, 1), (1, 3), (3, 3)].map(|(x, y)| {
        let at = (height * y / 4 * width + width * x / 4) as usize;
        raster.planes().iter().map(|plane| plane[at]).collect()
    })
}

fn check(name: &str, raster: &Raster, wanted: [Vec<f32>; 4], tolerance: f32) {
    for (quarter, (got, want)) in quarters(raster).iter().zip(&wanted).enumerate() {
        assert_eq!(got.len(), want.len(), "{name}: planes");
        let near = got.iter().zip(want).all(|(a, b)| (a - b).abs() <= tolerance);
        assert!(near, "{name}, quarter {quarter}: got {got:?}, want {want:?}");
    }
}

fn scene() -> [Vec<f32>; 4] {
    SCENE.map(|colour| light(colour).to_vec())
}

#[test]
fn every_format_shows_the_scene() {
    let exact = [
        "rgb.png",
        "rgb-interlaced.png",
        "palette-2.png",
        "palette-2-interlaced.png",
        "animated.png",
        "rgb.webp",
        "animated.webp",
        "rgb.tif",
        "lzw.tif",
        "deflate.tif",
        "16.tif",
        "rgb.bmp",
        "palette.bmp",
        "rgb.gif",
        "animated.gif",
        "rgb.ppm",
        "ascii.ppm",
        "rgb.pam",
        "rgb.svg",
        "rgb.svgz",
        "viewbox.svg",
        "picture-inside.svg",
    ];
    let near = [
        "rgb.jpg",
        "rgb-420.jpg",
        "rgb-progressive.jpg",
        "rgb-restart.jpg",
        "wide.jpg",
        "wide-progressive.jpg",
        "rgb-adobe.jpg",
        "odd.jpg",
        "cmyk-adobe.jpg",
        "cmyk-plain.jpg",
        "ycck.jpg",
        "ycck-magick.jpg",
        "cmyk.tif",
    ];
    for (names, tolerance) in [(&exact[..], 1e-6), (&near[..], STEP)] {
        for name in names {
            let picture = open(name);
            let size = match *name {
                "odd.jpg" => Size::new(61, 35),
                "wide.jpg" | "wide-progressive.jpg" => Size::new(144, 72),
                "ascii.ppm" => Size::new(16, 8),
                _ => SIZE,
            };
            assert_eq!((picture.source.size, picture.raster.size()), (size, size), "{name}");
            assert_eq!(picture.source.is_drawing, name.contains("svg"), "{name}");
            check(name, &picture.raster, scene(), tolerance);
            assert_eq!(picture.notes, [], "{name}");
        }
    }
    // At this quality WebP keeps the quarters, but not to the step.
    check("lossy.webp", &open("lossy.webp").raster, scene(), 4.0 * STEP);
}

#[test]
fn grey_pictures_have_one_plane() {
    let wanted = SCENE.map(|colour| vec![linear(grey(colour))]);
    for name in ["grey.png", "grey.pgm", "grey-as-rgb.png"] {
        check(name, &open(name).raster, wanted.clone(), 1e-6);
    }
    for name in ["grey.jpg", "grey-as-rgb.jpg"] {
        check(name, &open(name).raster, wanted.clone(), STEP);
    }
}

#[test]
fn few_bits_are_spread_from_black_to_white() {
    for (name, last) in [("grey-1.png", 1), ("grey-2.png", 3), ("grey-2-interlaced.png", 3), ("grey-4.png", 15)] {
        let wanted = [0, 1, 2, 3].map(|quarter| vec![linear((quarter * last / 3) as f32 * 255.0 / last as f32)]);
        check(name, &open(name).raster, wanted, 1e-6);
    }
    for name in ["bilevel.tif", "bilevel.pbm"] {
        check(name, &open(name).raster, [0.0, 0.0, 0.0, 1.0].map(|v| vec![v]), 1e-6);
    }
}

#[test]
fn sixteen_bits_are_kept() {
    for name in ["rgb-16.png", "rgb-16-interlaced.png"] {
        let wanted = [0, 1, 2, 3].map(|quarter| {
            SCENE[quarter].map(|v| linear((f32::from(v) * 257.0 + 100.0 * quarter as f32) / 257.0)).to_vec()
        });
        check(name, &open(name).raster, wanted, 1e-5);
    }
    let wanted = [0u16, 1, 2, 3].map(|quarter| vec![linear(f32::from(0x8000 + 0x40 * quarter) / 257.0)]);
    for name in ["grey-16.png", "grey-16.pgm"] {
        check(name, &open(name).raster, wanted.clone(), 1e-5);
    }
}

/// Light of a quarter at the opacities of the alpha pictures, over white.
fn over_white(value: impl Fn([u8; 3]) -> Vec<f32>, opacity: [u8; 4]) -> [Vec<f32>; 4] {
    std::array::from_fn(|i| {
        let opacity = f32::from(opacity[i]) / 255.0;
        value(SCENE[i]).iter().map(|light| opacity * light + 1.0 - opacity).collect()
    })
}

#[test]
fn what_is_clear_is_white_paper() {
    let rgb = |colour| light(colour).to_vec();
    for name in ["alpha.png", "alpha-16.png", "alpha-interlaced.png", "alpha.webp", "alpha.tif"] {
        check(name, &open(name).raster, over_white(rgb, [255, 128, 0, 64]), 1e-5);
    }
    let wanted = over_white(|colour| vec![linear(grey(colour))], [255, 128, 0, 64]);
    check("grey-alpha.png", &open("grey-alpha.png").raster, wanted, 1e-5);
    check("palette-8-clear.png", &open("palette-8-clear.png").raster, over_white(rgb, [255, 128, 0, 255]), 1e-5);
    check("rgb-clear.png", &open("rgb-clear.png").raster, over_white(rgb, [255, 0, 255, 255]), 1e-5);
    check("clear.gif", &open("clear.gif").raster, over_white(rgb, [255, 255, 0, 255]), 1e-5);
}

#[test]
fn paper_shows_through_before_pixels_are_averaged() {
    // Clear black and full white, side by side: white, whatever colour the clear pixels hide.
    let mut pam = b"P7\nWIDTH 2\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n".to_vec();
    pam.extend([0, 0, 0, 0, 255, 255, 255, 255]);
    let picture = decode_to(&pam, &|_| Ok(Size::new(1, 1))).unwrap();
    assert_eq!(picture.raster.planes(), [[1.0]]);
}

#[test]
fn light_is_averaged_not_numbers() {
    let checks: Vec<u8> = (0..64 * 64).map(|i| if (i % 64 + i / 64) % 2 == 0 { 0 } else { 255 }).collect();
    let pgm = [b"P5 64 64 255\n".to_vec(), checks].concat();
    for target in [Size::new(1, 1), Size::new(32, 16), Size::new(2, 64)] {
        let picture = decode_to(&pgm, &|_| Ok(target)).unwrap();
        assert!(picture.raster.planes()[0].iter().all(|v| (v - 0.5).abs() < 1e-6), "{target}");
    }
}

#[test]
fn all_eight_orientations_stand_upright() {
    for orientation in 1..=8 {
        let name = format!("orient-{orientation}.jpg");
        let picture = open(&name);
        assert_eq!((picture.source.size, picture.raster.size()), (SIZE, SIZE), "{name}");
        check(&name, &picture.raster, scene(), STEP);
        // The working size is asked and given upright.
        let small =
            decode_to(&read(&name), &|source| Ok(Size::new(source.size.width / 4, source.size.height / 2))).unwrap();
        assert_eq!(small.raster.size(), Size::new(16, 16), "{name}");
        check(&name, &small.raster, scene(), STEP);
    }
    for name in ["orient-6-before.png", "orient-8-behind.png", "orient-7.tif"] {
        let picture = open(name);
        assert_eq!(picture.source.size, SIZE, "{name}");
        check(name, &picture.raster, scene(), 1e-6);
    }
}

/// The scene through the swapped profiles: red drives green, green drives blue and blue drives red.
fn swapped(curve: impl Fn(u8) -> f32) -> [Vec<f32>; 4] {
    SCENE.map(|[r, g, b]| vec![curve(b), curve(r), curve(g)])
}

#[test]
fn colour_profiles_are_used() {
    let gamma_18 = |v: u8| (f32::from(v) / 255.0).powf(1.8);
    for name in ["icc.png", "icc-palette.png", "icc.tif", "orient-6-icc.webp"] {
        let picture = open(name);
        check(name, &picture.raster, swapped(gamma_18), 0.002);
        assert_eq!(picture.notes, [], "{name}");
    }
    check("icc.jpg", &open("icc.jpg").raster, swapped(gamma_18), STEP);
    check("gamma-1.png", &open("gamma-1.png").raster, SCENE.map(|c| c.map(|v| f32::from(v) / 255.0).to_vec()), 1e-6);
    let wanted = SCENE.map(|colour| vec![grey(colour) / 255.0]);
    check("grey-icc.png", &open("grey-icc.png").raster, wanted.clone(), 1e-4);
    check("grey-icc.jpg", &open("grey-icc.jpg").raster, wanted, STEP);
}

#[test]
fn colour_profiles_made_of_a_table_are_used() {
    // The table has two entries for each channel, in Lab, so lightness is even between black and white: what is in between
    // is not worth a number, but which of the colours is the strongest is.
    for name in ["icc-table.jpg", "icc-16-alpha.png", "cmyk-icc.jpg"] {
        let picture = open(name);
        assert_eq!(picture.notes, [], "{name}");
        let strongest: Vec<_> = quarters(&picture.raster)[..3]
            .iter()
            .map(|q| (0..3).max_by(|&a, &b| q[a].total_cmp(&q[b])).unwrap())
            .collect();
        if name == "icc-16-alpha.png" {
            assert_eq!(strongest[..2], [1, 2], "{name}"); // the third quarter is clear
            assert_eq!(quarters(&picture.raster)[2], [1.0; 3], "{name}");
        } else {
            // The red quarter has the second and third ink, and those are cyan and magenta.
            let wanted = if name == "cmyk-icc.jpg" { [2, 0, 1] } else { [1, 2, 0] };
            assert_eq!(strongest, wanted, "{name}");
        }
    }
}

#[test]
fn a_profile_that_cannot_be_used_is_a_remark() {
    for name in ["icc-broken.jpg", "icc-broken.png", "icc-wrong-kind.png"] {
        let picture = open(name);
        check(name, &picture.raster, scene(), STEP);
        assert!(matches!(&picture.notes[..], [Note::ColourProfileIgnored(_)]), "{name}: {:?}", picture.notes);
    }
}

#[test]
fn a_jpeg_is_the_same_at_every_scale() {
    for name in ["rgb.jpg", "rgb-progressive.jpg", "rgb-420.jpg", "odd.jpg", "grey-as-rgb.jpg", "ycck.jpg"] {
        let bytes = read(name);
        let full = whole(&bytes).unwrap();
        for divisor in [1, 2, 3, 4, 7, 8] {
            if matches!(name, "rgb-420.jpg" | "odd.jpg") && divisor > 4 {
                continue; // a quarter then has but one or two pixels of its own
            }
            let small = |source: Source| Ok(Size::new(source.size.width / divisor, source.size.height / divisor));
            let picture = decode_to(&bytes, &small).unwrap();
            assert_eq!(picture.raster.size(), small(full.source).unwrap(), "{name} / {divisor}");
            check(&format!("{name} / {divisor}"), &picture.raster, quarters(&full.raster), 5.0 * STEP);
        }
    }
}

#[test]
fn the_working_size_is_never_larger_than_the_source() {
    for name in ["rgb.jpg", "rgb.png", "rgb.gif"] {
        let picture = decode_to(&read(name), &|_| Ok(Size::new(1000, 1))).unwrap();
        assert_eq!(picture.raster.size(), Size::new(64, 1), "{name}");
    }
    let drawing = decode_to(&read("rgb.svg"), &|_| Ok(Size::new(640, 320))).unwrap();
    assert_eq!(drawing.raster.size(), Size::new(640, 320));
    check("rgb.svg x 10", &drawing.raster, scene(), 1e-6);
}

#[test]
fn the_maker_of_the_working_size_can_refuse() {
    let refusal = Error::TooSmall { size: SIZE, why: "no".into() };
    for name in ["rgb.jpg", "rgb.png", "rgb.gif", "rgb.svg"] {
        assert_eq!(decode_to(&read(name), &|_| Err(refusal.clone())).err(), Some(refusal.clone()), "{name}");
    }
}

// Drawings -----------------------------------------------------------------------------------------------------------

#[test]
fn nothing_outside_a_drawing_is_reached() {
    // The linked picture lies beside the drawing, and in the folder tests run in; it must not show.
    let picture = open("linked.svg");
    assert_eq!(picture.raster.planes(), [vec![1.0; 64 * 32]]);
    let [Note::LeftOut(file), Note::LeftOut(net)] = &picture.notes[..] else { panic!("{:?}", picture.notes) };
    assert!(file.contains("rgb.png") && net.contains("http://localhost/rgb.png"), "{file} {net}");
    let path = folder().join("rgb.png");
    for what in [
        format!("<image width='9' height='9' href='{}'/>", path.display()),
        format!("<image width='9' height='9' href='file://{}'/>", path.display()),
        format!("<style>@import url('{0}'); rect {{ fill: url('{0}') }}</style>", path.display()),
        format!("<filter id='f'><feImage href='{}'/></filter><g filter='url(#f)'><rect/></g>", path.display()),
        format!("<use href='{}#a'/>", folder().join("rgb.svg").display()),
    ] {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>{what}</svg>");
        let picture = whole(text.as_bytes()).unwrap();
        assert!(picture.raster.planes()[0].iter().all(|&v| v.total_cmp(&1.0).is_eq()), "{what}");
    }
}

#[test]
fn no_file_comes_in_as_an_entity() {
    let text = format!(
        "<!DOCTYPE svg [<!ENTITY file SYSTEM '{}'>]><svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>&file;</svg>",
        folder().join("rgb.svg").display()
    );
    assert!(fault(text.as_bytes()).contains("line 1"), "{}", fault(text.as_bytes()));
}

#[test]
fn fonts_are_asked_for_once_and_only_by_texts() {
    let asked = AtomicUsize::new(0);
    let fonts = || {
        asked.fetch_add(1, Ordering::Relaxed);
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_font_data(read("block.ttf"));
        Arc::new(fonts)
    };
    let working_size = |source: Source| Ok(source.size);
    let options = Options { limits: Limits::default(), fonts: &fonts, working_size: &working_size };
    for name in ["rgb.svg", "picture-inside.svg", "linked.svg", "rgb.png"] {
        decode(&read(name), &options).unwrap();
    }
    assert_eq!(asked.load(Ordering::Relaxed), 0);
    // The letter is a black square of the em, in the left half.
    let picture = decode(&read("text.svg"), &options).unwrap();
    check("text.svg", &picture.raster, [0.0, 1.0, 0.0, 1.0].map(|v| vec![v]), 1e-6);
    assert_eq!(picture.notes, []);
    let two = String::from_utf8(read("text.svg")).unwrap().replace("</text>", "</text><text>A</text>");
    decode(two.as_bytes(), &options).unwrap();
    assert_eq!(asked.load(Ordering::Relaxed), 2);
}

#[test]
fn a_text_without_a_font_is_a_remark() {
    let picture = open("text.svg");
    assert!(matches!(&picture.notes[..], [Note::LeftOut(what)] if what.contains("Block")), "{:?}", picture.notes);
}

fn svg(attributes: &str) -> Vec<u8> {
    format!("<svg xmlns='http://www.w3.org/2000/svg' {attributes}><rect width='1' height='1'/></svg>").into_bytes()
}

#[test]
fn the_size_of_a_drawing_is_in_css_pixels_or_keeps_its_shape() {
    for (attributes, size) in [
        ("width='640' height='480'", Size::new(640, 480)),
        ("viewBox='0 0 640 480'", Size::new(640, 480)),
        ("width='210mm' height='297mm'", Size::new(794, 1123)),
        ("width='100%' height='100%' viewBox='5 5 20 10'", Size::new(20, 10)),
        ("width='1' height='1.4142'", Size::new(512, 724)),
        ("width='0.001' height='0.002'", Size::new(1, 2)),
    ] {
        let got = decode_to(&svg(attributes), &|_| Ok(Size::new(8, 8))).unwrap().source;
        let ratio = |size: Size| f64::from(size.width) / f64::from(size.height);
        if attributes.contains("0.001") || attributes.contains("1.4142") {
            assert!((ratio(got.size) / ratio(size) - 1.0).abs() < 0.001, "{attributes}: {}", got.size);
        } else {
            assert_eq!(got, Source { size, is_drawing: true }, "{attributes}");
        }
    }
}

#[test]
fn sizes_that_are_none_are_refused() {
    for attributes in [
        "width='0' height='10'",
        "width='-5' height='10'",
        "width='1e30' height='1e30'",
        "width='1e38' height='1'",
        "width='1e-30' height='1'",
        "width='NaN' height='1' viewBox='0 0 0 0'",
        "width='10000000' height='10000000'",
    ] {
        let bytes = svg(attributes);
        let got = decode_to(&bytes, &|_| Ok(Size::new(8, 8)));
        match got {
            Err(Error::Undecodable { format: "SVG", why }) => assert!(why.contains("size"), "{attributes}: {why}"),
            // usvg takes a size it cannot read as if it were not there.
            Ok(picture) => assert!(attributes.contains("NaN") && picture.source.size.area() > 0, "{attributes}"),
            Err(other) => panic!("{attributes}: {other}"),
        }
    }
}

#[test]
fn a_malformed_drawing_is_refused_with_its_line() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>\n<g>\n</svg>";
    let fault = fault(text.as_bytes());
    assert!(fault.contains("SVG") && fault.contains("line 3"), "{fault}");
    assert_eq!(fault.lines().count(), 1);
}

#[test]
fn drawings_that_grow_without_end_are_refused() {
    let start = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>";
    let entities: String =
        (1..12).map(|i| format!("<!ENTITY e{i} '{}'>", format!("&e{};", i - 1).repeat(10))).collect();
    let uses: String =
        (1..12).map(|i| format!("<g id='u{i}'>{}</g>", format!("<use href='#u{}'/>", i - 1).repeat(10))).collect();
    let canvases = format!("{}<rect width='9' height='9'/>{}", "<g opacity='.9'>".repeat(900), "</g>".repeat(900));
    for text in [
        format!("<!DOCTYPE svg [<!ENTITY e0 'e'>{entities}]>{start}&e11;</svg>"),
        format!("{start}<defs><rect id='u0' width='1' height='1'/>{uses}</defs><use href='#u11'/></svg>"),
        format!("{start}{}{}</svg>", "<g>".repeat(100_000), "</g>".repeat(100_000)),
        format!("{start}{canvases}</svg>"),
    ] {
        let got = decode_to(text.as_bytes(), &|_| Ok(Size::new(1000, 1000)));
        assert!(got.is_err(), "{}", &text[..200.min(text.len())]);
    }
}

#[test]
fn a_huge_picture_inside_a_drawing_is_left_out() {
    // 30000 x 30000 by its header.
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><image width='9' height='9' \
                href='data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAdTAAAHUwCAIAAADpRW/t'/></svg>";
    let picture = whole(text.as_bytes()).unwrap();
    assert!(
        matches!(&picture.notes[..], [Note::LeftOut(what)] if what.contains("30000 x 30000")),
        "{:?}",
        picture.notes
    );
}

// Bad input ----------------------------------------------------------------------------------------------------------

#[test]
fn what_is_no_picture_is_named() {
    assert_eq!(whole(b"").err(), Some(Error::Empty));
    for (bytes, what) in [
        (&b"just some words in a file named .png"[..], "text"),
        (b"%PDF-1.4 ...", "PDF"),
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
            if name.ends_with("jpg") || name.ends_with("png") {
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
fn rare_kinds_of_jpeg_are_refused_by_name() {
    assert!(fault(&read("rgb-arithmetic.jpg")).contains("arithmetic"));
    let with_frame = |kind: u8, bits: u8| {
        let mut bytes = read("rgb.jpg");
        let at = bytes.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
        (bytes[at + 1], bytes[at + 4]) = (kind, bits);
        fault(&bytes)
    };
    assert!(with_frame(0xC1, 12).contains("12 bits"), "{}", with_frame(0xC1, 12));
    assert!(with_frame(0xC5, 8).contains("hierarchical"), "{}", with_frame(0xC5, 8));
    let mut lossless = read("grey.jpg");
    let at = lossless.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
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
    let at = jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
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
    let working_size = |_: Source| Ok(Size::new(1000, 1000));
    let options = Options { limits, fonts: &no_fonts, working_size: &working_size };
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
    let at = jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
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
            assert!(picture.raster.planes()[0].iter().all(|&v| v.total_cmp(&1.0).is_eq()));
        }
    }
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
        |source: Source| Ok(Size::new(source.size.width.div_ceil(3).min(100), source.size.height.div_ceil(3).min(100)));
    let options = Options { limits, fonts: &no_fonts, working_size: &working_size };
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
            if tried.is_err() {
                panicked.push(format!("{}, round {round}", path.display()));
            }
        }
    }
    assert!(panicked.is_empty(), "{}", panicked.join("\n"));
}

#[test]
fn a_picture_without_height_in_a_drawing_is_no_panic() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='64' height='32'><image width='64' height='32' \
                href='data:image/svg+xml,%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 width=%221e9%22 height=%221%22/%3E'/></svg>";
    assert!(fault(text.as_bytes()).contains("too small"), "{}", fault(text.as_bytes()));
}
