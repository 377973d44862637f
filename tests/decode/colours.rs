//! Each format, and each thing that can go wrong with colours.

use tactograph::internals::raster::decode::Header;
use tactograph::internals::units::Size;
use tactograph::{Error, Note};

use crate::decode::{SCENE, SIZE, STEP, check, decode_to, grey, light, linear, open, quarters, read, scene, whole};

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
    assert_eq!(picture.raster.planes().as_slice(), [[1.0]]);
}

#[test]
fn light_is_averaged_not_numbers() {
    let checks: Vec<u8> = (0..64 * 64).map(|i| if (i % 64 + i / 64) % 2 == 0 { 0 } else { 255 }).collect();
    let pgm = [b"P5 64 64 255\n".to_vec(), checks].concat();
    for target in [Size::new(1, 1), Size::new(32, 16), Size::new(2, 64)] {
        let picture = decode_to(&pgm, &|_| Ok(target)).unwrap();
        assert!(picture.raster.planes().iter().flatten().all(|v| (v - 0.5).abs() < 1e-6), "{target}");
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
            let small = |source: Header| Ok(Size::new(source.size.width / divisor, source.size.height / divisor));
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
    let refusal = Error::TooFewPixels { size: SIZE, least: 1000 };
    for name in ["rgb.jpg", "rgb.png", "rgb.gif", "rgb.svg"] {
        assert_eq!(decode_to(&read(name), &|_| Err(refusal.clone())).err(), Some(refusal.clone()), "{name}");
    }
}
