//! The face as others see it: that its types can be wrapped for other languages, and that what it takes and gives agrees.

use std::sync::{Arc, Mutex};

use tactograph::{
    Crop, Drawing, Error, Event, FeelReport, Felt, Fonts, Limits, Note, Options, Page, Picture, Profile, Sheets, Size,
    Stage, Trace, Traced, Tracing,
};

/// What a `#[wasm_bindgen]` struct asks of its fields (they live as long as they like) and a `#[pyclass]` (any thread may hold
/// and drop them, and several may look at them at once).
fn can_be_wrapped<T: Send + Sync + 'static>() {}

#[test]
fn types_of_the_face_can_be_held_by_classes_of_other_languages() {
    can_be_wrapped::<Options>();
    can_be_wrapped::<Profile>();
    can_be_wrapped::<Drawing>();
    can_be_wrapped::<Sheets>();
    can_be_wrapped::<Page>();
    can_be_wrapped::<Traced>();
    can_be_wrapped::<Trace>();
    can_be_wrapped::<Felt>();
    can_be_wrapped::<FeelReport>();
    can_be_wrapped::<Fonts>();
    can_be_wrapped::<Note>();
    can_be_wrapped::<Error>();
    can_be_wrapped::<Box<dyn std::error::Error + Send + Sync>>();
}

/// As a class of another language holds it: no lifetimes, no type parameters.
struct Converter {
    options: Options,
    last: Option<Drawing>,
}

impl Converter {
    fn convert(&mut self, picture: &[u8]) -> Result<&Page, Error> {
        Ok(&self.last.insert(tactograph::convert(picture, &self.options)?).page)
    }
}

fn options() -> Options {
    Options::new(Profile::named("swell-a4").expect("it is built in")).title("face")
}

const SIZE: Size = Size::new(120, 90);

/// A disc on white that fades to clear at its right: red, green, blue and opacity.
fn pixels() -> Vec<u8> {
    let pixel = |x: u32, y: u32| {
        let far = (f64::from(x) - 60.0).hypot(f64::from(y) - 45.0);
        if far < 30.0 { [200, 30, 20, 255 - x as u8] } else { [250, 250, 255, 255] }
    };
    (0..SIZE.height).flat_map(|y| (0..SIZE.width).flat_map(move |x| pixel(x, y))).collect()
}

fn png() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIZE.width, SIZE.height);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&pixels()).expect("the pixels");
    writer.finish().expect("the end");
    bytes
}

#[test]
fn pixels_give_the_page_of_their_png() {
    let mut converter = Converter { options: options(), last: None };
    let of_file = converter.convert(&png()).expect("a page").to_svg();
    let pixels = pixels();
    let picture = Picture::rgba8(SIZE.width, SIZE.height, &pixels).expect("as many as there should be");
    let of_pixels = tactograph::convert(picture, &options()).expect("a page").page;
    assert!(!of_pixels.is_empty());
    assert!(of_file == of_pixels.to_svg(), "the pages differ");
    // A part of the pixels, and pixels over a limit, are as those of a file.
    let crop: Crop = "25%,0,75%,100%".parse().expect("a part");
    let part =
        |picture: Picture<'_>| tactograph::convert(picture, &options().crop(crop)).expect("a page").page.to_svg();
    assert!(part(picture) == part(Picture::file(&png())), "the parts differ");
    let limits = Limits { megapixels: 0, ..Limits::default() };
    let refused = tactograph::convert(picture, &options().limits(limits)).expect_err("over the limit");
    assert!(matches!(refused, Error::TooManyPixels { size: SIZE, .. }), "{refused}");
}

#[test]
fn question_marks_work_from_a_name_to_a_page() {
    fn all() -> Result<Vec<u8>, Error> {
        let mut profile = Profile::named("swell-a4")?;
        profile.set("lines.width_max", "1.2")?;
        let options = Options::new(profile).crop("0,0,100%,50%".parse()?);
        let page = tactograph::convert(&png(), &options)?.page;
        tactograph::feel(page.to_svg(), 1.0)?;
        page.to_png(96.try_into()?, Default::default())
    }
    assert!(all().is_ok_and(|png| png.starts_with(b"\x89PNG")));
    fn boxed() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        Profile::named("swell-a5")?;
        Ok(())
    }
    let told = boxed().expect_err("there is no such profile").to_string();
    assert!(told.contains("swell-a4"), "{told}");
}

#[test]
fn a_width_that_is_no_length_is_refused() {
    for wanted in [f32::NAN, f32::INFINITY, 0.0, -5.0] {
        let refused = tactograph::convert(&png(), &options().width_mm(wanted));
        assert!(matches!(refused, Err(Error::NoWidth { .. })), "{wanted}: {refused:?}");
    }
}

#[test]
fn all_faults_of_a_profile_are_told_at_once() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.lines.width_max = -1.0;
    profile.edges.low = f32::NAN;
    let error = tactograph::convert(&png(), &Options::new(profile)).expect_err("two faults");
    let Error::Profile(faults) = &error else { panic!("{error}") };
    assert!(faults.len() >= 2, "{error}");
}

#[test]
fn progress_is_told_of_and_tracing_takes_the_same_options() {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let events = Arc::clone(&seen);
    let options = options().progress(move |event| events.lock().expect("nobody panicked").push(event));
    let traced = tactograph::trace(&png(), &Tracing::contours(), &options).expect("contours");
    assert_eq!(traced.trace.size, SIZE);
    assert!(traced.trace.to_json().starts_with("{\"program\":\"tactograph "));
    let first = seen.lock().expect("nobody panicked").first().cloned(); // unlocked again: the next run tells of events too
    assert_eq!(first, Some(Event::Begin(Stage::Decode)));
    // Points of a part are in pixels of the part.
    let crop: Crop = "60,0,60,90".parse().expect("a part");
    let part = tactograph::trace(&png(), &Tracing::contours(), &options.crop(crop)).expect("contours").trace;
    assert_eq!(part.size, Size::new(60, 90));
}
