//! What is refused at the face, and that a program can tell it apart: by the ids of errors.

use std::panic::{AssertUnwindSafe, catch_unwind};

use tactograph::marks::{Figure, Parts, Sign};
use tactograph::medium::{Device, DotMedium};
use tactograph::{
    Crop, Description, DotFormat, Embossing, Error, Fonts, Length, MmPoint, MmRect, Options, Page, PageOptions,
    Position, Profile, RenderOptions, Size, Tracing,
};

use crate::common::samples;

fn profile(name: &str) -> Profile {
    Profile::named(name).expect("it is built in")
}

fn id<T>(result: Result<T, Error>) -> Option<&'static str> {
    result.err().map(|error| {
        assert!(Error::ids().contains(&error.id()), "{error}");
        error.id()
    })
}

/// An SVG of so many pixels with something in it.
fn svg(width: u32, height: u32, inner: &str) -> Vec<u8> {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}'><rect width='100%' height='60%'/>\
         {inner}</svg>"
    )
    .into_bytes()
}

/// A page of an A4 sheet with nothing on it.
fn empty_page(sheet: [f32; 2]) -> Result<Page, Error> {
    let place = MmRect::new(MmPoint::new(30.0, 30.0), MmPoint::new(50.0, 50.0));
    let figure = Figure { place, source: Size::new(10, 10), textures: vec![], lines: vec![] };
    Page::new(Parts::of(sheet, figure))
}

#[test]
fn a_number_that_is_none_is_refused_wherever_one_is_given() {
    let device = Device::named("index-basic-d-v5").expect("in the table");
    let stylus = Device::named("braillerap-a4").expect("in the table");
    let a4 = [210.0, 297.0];
    let svg = empty_page(a4).expect("a page").to_svg();
    let picture = samples::read("bars.svg");
    let options = || Options::new(profile("swell-a4"));
    type Give<'a> = &'a dyn Fn(f32) -> Result<(), Error>;
    let places: [(&str, Give<'_>); 19] = [
        ("not-a-position", &|n| Position::percent(n.into()).map(drop)),
        ("not-a-position", &|n| Position::pixels(n.into()).map(drop)),
        ("not-a-position", &|n| format!("{n}").parse::<Position>().map(drop)),
        ("not-a-position", &|n| format!("{n}%").parse::<Position>().map(drop)),
        ("not-a-crop", &|n| Crop::percent(n.into(), 0.0, 50.0, 50.0).map(drop)),
        ("not-a-crop", &|n| Crop::mm(0.0, 0.0, n.into(), 50.0).map(drop)),
        ("not-a-crop", &|n| {
            let part = Length::Pixels(5.0);
            Crop::new(part, Length::Pixels(n.into()), part, part).map(drop)
        }),
        ("not-a-crop", &|n| format!("0,0,5,{n}px").parse::<Crop>().map(drop)),
        ("not-a-sign", &|n| format!("rhombus {n}").parse::<Sign>().map(drop)),
        ("no-such-thresholds", &|n| Tracing::contours().thresholds(n, n).map(drop)),
        ("no-such-thresholds", &|n| Tracing::contours().thresholds(1.0, n).map(drop)),
        ("no-width", &|n| tactograph::convert(&picture, &options().width_mm(n)).map(drop)),
        ("no-such-finger", &|n| tactograph::feel(&svg, &PageOptions::new().finger_mm(n)).map(drop)),
        ("cannot-press", &|n| device.dot_area([n, 297.0], 2.0).map(drop)),
        ("cannot-press", &|n| device.dot_area([210.0, n], 2.0).map(drop)),
        ("cannot-press", &|n| DotMedium::on(stylus, n, a4).map(drop)),
        ("no-measure", &|n| empty_page([n, 297.0]).map(drop)),
        ("no-such-embossing", &|n| Embossing::new(n as u16, 1).map(drop)),
        ("profile", &|n| {
            let mut profile = profile("swell-a4");
            let numbers = Profile::keys().iter().filter(|key| key.limits.is_some());
            let taken = numbers.filter(|key| profile.set(key.path, n).is_ok()).count();
            assert_eq!(taken, 0, "{n}");
            profile.set("lines.width_max", n)
        }),
    ];
    for number in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for (at, (expected, give)) in places.iter().enumerate() {
            // as a count, infinity is the largest there is
            assert_eq!(id(give(number)), Some(*expected), "{number}, row {at}");
        }
    }
    assert_eq!(device.pitches().find(f32::NAN), None);
}

#[test]
fn what_is_wrong_with_a_picture_is_told_apart() {
    let convert = |picture: &[u8], options: &Options| id(tactograph::convert(picture, options));
    let options = Options::new(profile("swell-a4"));
    let levels = 300;
    let deep = svg(100, 100, &format!("{}{}", "<g>".repeat(levels), "</g>".repeat(levels)));
    let long = svg(100, 100, "<path d='M0 0L1e12 5'/>");
    for (picture, expected) in [
        (svg(100, 100, "<g>"), "undecodable"),
        (svg(5_000_000, 100, ""), "too-complex"),
        (deep.clone(), "too-complex"),
        (long.clone(), "too-complex"),
        (b"P1 7 300 0".to_vec(), "too-few-pixels"),
        (svg(10, 2000, ""), "too-narrow"),
    ] {
        assert_eq!(convert(&picture, &options), Some(expected), "{}", String::from_utf8_lossy(&picture[..60]));
    }
    assert_eq!(convert(&svg(100, 100, ""), &options.clone().width_mm(2.0)), Some("not-wide-enough"));
    // the same of what is to be a page
    let of_page = |svg: &[u8]| {
        let page = String::from_utf8_lossy(svg).replace("<rect", "<g id='lines'/><rect").into_bytes();
        [
            id(tactograph::render(&page, &RenderOptions::new())),
            id(tactograph::check(&page, &PageOptions::new())),
            id(tactograph::describe(&page, &PageOptions::new())),
        ]
    };
    assert_eq!(of_page(&deep), [Some("too-complex"); 3]);
    assert_eq!(of_page(&long), [Some("too-complex"); 3]);
    assert_eq!(of_page(&svg(100, 100, "<g>")), [Some("undecodable"); 3]);
    assert_eq!(id(tactograph::feel(&deep, &PageOptions::new())), Some("too-complex"));
}

#[test]
fn the_narrowest_pictures_are_told_and_the_smallest_make_pages() {
    let options = Options::new(profile("swell-a4"));
    for ([width, height], expected) in [
        ([1_u32, 1], Some("too-few-pixels")),
        ([400, 1], Some("too-few-pixels")),
        ([1, 400], Some("too-few-pixels")),
        ([400, 7], Some("too-few-pixels")),
        ([7, 400], Some("too-few-pixels")),
        ([400, 8], Some("too-narrow")),
        ([8, 400], Some("too-narrow")),
        ([100, 8], None),
        ([8, 100], None),
        ([8, 8], None),
    ] {
        let step = |x: u32, y: u32| if x + y < (width + height) / 2 { 30_u8 } else { 230 };
        let noise = |x: u32, y: u32| ((x * 31 + y * 17) * 7 % 61 * 4) as u8;
        let values: [&dyn Fn(u32, u32) -> u8; 2] = [&step, &noise];
        for (at, value) in values.into_iter().enumerate() {
            let pixels: Vec<u8> = (0..width * height).map(|i| value(i % width, i / width)).collect();
            let picture = [format!("P5 {width} {height} 255\n").into_bytes(), pixels].concat();
            assert_eq!(id(tactograph::convert(&picture, &options)), expected, "{width} x {height}, {at}");
        }
    }
}

/// Drawings that are beyond what can be drawn, each with the limit that is to be told.
fn beyond() -> Vec<(&'static str, Vec<u8>)> {
    let join = |count: u32, each: &dyn Fn(u32) -> String| (0..count).map(each).collect::<String>();
    let filtered = |filter: &str| {
        let group = "<g filter='url(#f)'><rect width='99' height='99'/></g>".repeat(400);
        format!("<filter id='f'>{filter}</filter>{group}")
    };
    let doubled = join(30, &|i| format!("<g id='u{}'>{}</g>", i + 1, format!("<use href='#u{i}'/>").repeat(2)));
    let patterns = join(201, &|i| format!("<pattern id='p{i}'/>"));
    let references = join(201, &|i| format!("url(#p{i})"));
    let rules = |count: usize| format!("<style>{}</style>", ".a{fill:url(#a)}".repeat(count));
    // usvg panics on it, which is caught
    let flat = "<image width='64' height='32' href='data:image/svg+xml,%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 \
                width=%22999999999%22 height=%221%22/%3E'/>";
    let inside = [
        ("200 elements deep", format!("{}{}", "<g>".repeat(300), "</g>".repeat(300))),
        ("9 digits", "<path d='M0 0L1e12 5'/>".to_owned()),
        ("7 digits", flat.to_owned()),
        ("1000000 elements", format!("<g id='u0'/>{doubled}")),
        ("5000000 attributes", "=".repeat(5_000_001)),
        ("200 patterns", format!("{patterns}<g style='{references}'/>")),
        ("more than 20000", format!("<path d='M0 0{}'/>", "L100 100L0 0".repeat(8000))),
        ("10 are the most", filtered("<feGaussianBlur stdDeviation='2'/>")),
        ("16 octaves", filtered("<feTurbulence numOctaves='17'/>")),
        ("2 %", filtered("<feMorphology radius='3'/>")),
        ("30000 letters", format!("<text>{}</text>", "a".repeat(30_001))),
        ("8000 rules", rules(8001)),
        ("more than 10000000", format!("{}{}", rules(5000), "<g/>".repeat(2000))),
    ];
    let drawings = inside.into_iter().map(|(limit, inner)| (limit, svg(100, 100, &inner)));
    drawings.chain([("over 4000000", svg(5_000_000, 100, ""))]).collect()
}

#[test]
fn what_is_too_complex_is_told_with_its_limit_and_a_remedy() {
    let assert_told = |error: Option<Error>, limit: &str, remedy: &str| {
        let Some(refused @ Error::TooComplex { .. }) = &error else { panic!("{limit}: {error:?}") };
        let told = refused.to_string();
        assert!(told.contains(limit) && told.contains(remedy), "{limit}: {told}");
        assert_eq!(told.lines().count(), 1, "{told}");
    };
    let options = Options::new(profile("swell-a4"));
    for (limit, picture) in beyond() {
        assert_told(tactograph::convert(&picture, &options).err(), limit, "; simplify it or make it smaller");
    }
    let page = svg(100, 100, "<g id='lines'><path d='M0 0L1e8 5'/></g>");
    assert_told(tactograph::check(&page, &PageOptions::new()).err(), "7 digits", "; put that right in the program");
}

/// The length is looked at before anything else.
#[test]
fn a_page_that_is_too_long_is_told_with_its_limit() {
    let long = vec![b' '; 100_000_001];
    let told = [
        tactograph::render(&long, &RenderOptions::new()).map(drop),
        tactograph::check(&long, &PageOptions::new()).map(drop),
        tactograph::describe(&long, &PageOptions::new()).map(drop),
        tactograph::feel(&long, &PageOptions::new()).map(drop),
    ];
    for result in told {
        let error = result.expect_err("it is too long").to_string();
        assert!(error.contains("longer than 100 MB"), "{error}");
    }
}

#[test]
fn why_dots_are_not_written_is_told_apart() {
    let printed = empty_page([210.0, 297.0]).expect("a page");
    let refused = printed.to_dots(DotFormat::Idx).expect_err("it is printed");
    assert_eq!(refused, Error::NotOfDots { format: "idx", profile: "index-basic-d" });
    let pins =
        tactograph::convert(&samples::read("bars.svg"), &Options::new(profile("graphiti"))).expect("a page").page;
    let refused = pins.to_dots(DotFormat::Idx).expect_err("for others");
    let Error::NotItsFormat { format: "idx", takes, .. } = &refused else { panic!("{refused:?}") };
    assert_eq!(takes, &["pixels", "ubrl", "pef", "txt"]);
    for (copies, impact) in [(0, 1), (1000, 1), (1, 0), (1, 4)] {
        let refused = Embossing::new(copies, impact).expect_err("out of range");
        assert!(matches!(refused, Error::NoSuchEmbossing { most_copies: 999, most_impact: 3, .. }), "{refused}");
    }
    let device = Device::named("index-everest-d-v5").expect("in the table");
    let Err(Error::CannotPress(why)) = DotMedium::on(device, 1.8, [300.0, 700.0]) else { panic!("it takes all") };
    assert_eq!(why.len(), 3, "{why:?}");
}

#[test]
fn names_that_are_not_known_are_told_in_one_way() {
    let nearest = |error: Option<Error>| match error {
        Some(Error::NoSuchName { known, nearest, .. }) if known.len() > 1 => nearest,
        other => panic!("{other:?}"),
    };
    assert_eq!(nearest(Profile::named("swell_a4").err()), ["swell-a4"]);
    assert_eq!(nearest(Device::named("graphitti").err()), ["graphiti"]);
    assert_eq!(nearest(DotFormat::named("pixel").err()), ["pixels"]);
    let page = empty_page([210.0, 297.0]).expect("a page").to_svg();
    let described = tactograph::describe(&page, &PageOptions::new().language("dee"));
    let Err(Error::NoSuchName { name, known, .. }) = &described else { panic!("{described:?}") };
    assert_eq!((name.as_str(), known.len()), ("dee", Description::languages().count()));
}

#[test]
fn bytes_that_are_no_font_are_refused() {
    assert_eq!(id(Fonts::from_data(vec![b"<!DOCTYPE html>".to_vec()])), Some("not-a-font"));
    assert_eq!(id(Fonts::from_data(Vec::new())), None);
}

/// A panic of what the caller gives goes through to the caller, and nothing is broken by it.
#[test]
fn a_panic_of_a_caller_is_the_callers() {
    let picture = samples::read("bars.svg");
    let plain = || Options::new(profile("swell-a4")).title("bars");
    let expected = tactograph::convert(&picture, &plain()).expect("a page").page.to_svg();
    let panicking = [
        plain().progress(|_| std::panic::panic_any("of the caller")),
        plain().cancelled(|| std::panic::panic_any("of the caller")),
        plain().translator(|_| std::panic::panic_any("of the caller")),
    ];
    for (at, options) in panicking.iter().enumerate() {
        for _ in 0..2 {
            let caught = catch_unwind(AssertUnwindSafe(|| tactograph::convert(&picture, options)));
            let what = caught.expect_err("a panic");
            assert_eq!(what.downcast_ref::<&str>(), Some(&"of the caller"), "row {at}");
        }
        assert_eq!(tactograph::convert(&picture, &plain()).expect("a page").page.to_svg(), expected);
    }
}
