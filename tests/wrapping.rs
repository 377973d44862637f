//! The face as others see it: that its types can be wrapped for other languages, and that what it takes and gives agrees.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use tactograph::{
    Class, Crop, Dpi, Drawing, Error, Event, Fault, Fonts, Label, Limits, MmPoint, Note, Options, Page, PageOptions,
    Picture, Position, Profile, RenderOptions, Size, Stage, Tracing,
};

/// What a `#[wasm_bindgen]` struct asks of its fields (they live as long as they like) and a `#[pyclass]` (any thread may hold
/// and drop them, and several may look at them at once).
fn can_be_wrapped<T: Send + Sync + 'static>() {}

#[test]
fn types_of_the_face_can_be_held_by_classes_of_other_languages() {
    // all but `Picture`, which borrows pixels; `tests/tidy/face.rs` compares them with `src/lib.rs`
    macro_rules! can_be_wrapped {
        ($($type:ty),+ $(,)?) => { $(can_be_wrapped::<$type>();)+ };
    }
    use tactograph::*;
    can_be_wrapped!(Options, PageOptions, RenderOptions, Tracing, Fonts, Limits, Profile, BuiltIn, Key, Value);
    can_be_wrapped!(NumberRange, Fault, Crop, Position, Label, SheetGrid, KeySheets, Depth, Dpi, Embossing);
    can_be_wrapped!(Format, DotFormat, DrawingFormat, Drawing, Sheets, Page, Text, Traced, Trace, Polyline);
    can_be_wrapped!(Felt, Checked, Finding, Rule, Severity, Verdict, Description, Calibration, Class);
    can_be_wrapped!(
        Event, Stage, Error, Note, About, GivenFile, Reason, Told, Length, Mm, MmPoint, MmRect, Px, PxPoint, Size
    );
    can_be_wrapped!(marks::BrailleText, marks::Dots, marks::Figure, marks::Glyph, marks::Height, marks::Line);
    can_be_wrapped!(marks::Overview, marks::Parts, marks::Pen, marks::PrintText, marks::Run, marks::Shape);
    can_be_wrapped!(marks::Sign, marks::TextRole, marks::Texture);
    can_be_wrapped!(medium::Device, medium::DotArea, medium::DotMedium, medium::Grid, medium::Medium);
    can_be_wrapped!(medium::Pitches, medium::Print, felt::Areas, felt::FeltAs, felt::OfClass, felt::Report);
    can_be_wrapped!(felt::Textures, Box<dyn std::error::Error + Send + Sync>);
}

/// What a class of another language gives as often as it is asked for.
fn can_be_copied<T: Clone>() {}

#[test]
fn what_is_asked_for_again_can_be_cloned() {
    can_be_copied::<Options>();
    can_be_copied::<RenderOptions>();
    can_be_copied::<PageOptions>();
    can_be_copied::<Profile>();
    can_be_copied::<Label>();
    can_be_copied::<Page>();
    can_be_copied::<Drawing>();
    can_be_copied::<Note>();
    can_be_copied::<Fault>();
    can_be_copied::<Tracing>();
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

    /// A setter that fails takes the options with it, so that a class changes a clone of its own.
    fn add_lines(&mut self, svg: &[u8]) -> Result<(), Error> {
        self.options = self.options.clone().add_lines(svg)?;
        Ok(())
    }
}

#[test]
fn options_that_a_class_holds_outlive_a_setter_that_fails() {
    let mut converter = Converter { options: options(), last: None };
    let before = converter.convert(&png()).expect("a page").to_svg();
    assert!(converter.add_lines(b"<svg").is_err());
    assert_eq!(converter.convert(&png()).expect("a page").to_svg(), before);
    converter.add_lines(before.as_bytes()).expect("its own lines");
    assert!(converter.convert(&png()).is_ok());
}

#[test]
fn options_go_on_with_another_profile() {
    let of = |options: &Options| tactograph::convert(&png(), options).expect("a page").page;
    let letter = of(&options().with_profile(Profile::named("swell-letter").expect("it is built in")));
    assert_eq!((letter.sheet, letter.title.as_str()), ([215.9, 279.4], of(&options()).title.as_str()));
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
        tactograph::feel(page.to_svg(), &PageOptions::new())?;
        page.to_png(Dpi::new(96)?, Default::default(), &Fonts::none())
    }
    assert!(all().is_ok_and(|png| png.starts_with(b"\x89PNG")));
    fn boxed() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        Profile::named("swell-a5")?;
        Ok(())
    }
    let told = boxed().expect_err("there is no such profile").to_string();
    assert!(told.contains("swell-a4"), "{told}");
    fn labels() -> Result<Vec<Label>, Error> {
        let x: Position = "30%".parse()?;
        let mut labels = Label::from_csv("10%,20%,apple")?;
        labels.push(Label { x, y: "12.5".parse()?, text: "pear".into() });
        Ok(labels)
    }
    assert_eq!(labels().map(|labels| labels.len()), Ok(2));
    assert_eq!("here".parse::<Position>(), Err(Error::NotAPosition));
    let no_finger = tactograph::feel(
        tactograph::convert(&png(), &options()).expect("a page").page.to_svg(),
        &PageOptions::new().finger_mm(9.0),
    );
    assert_eq!(no_finger.err().map(|error| error.id()), Some("no-such-finger"));
    let refused = tactograph::convert(b"", &options()).expect_err("an empty file");
    assert_eq!(
        (refused.id(), Error::NotACrop.id(), Error::Profile(Vec::new()).id()),
        ("empty", "not-a-crop", "profile")
    );
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

/// Hears of progress, and keeps the shares of the work that were done.
fn listener() -> (impl Fn(Event) + Send + Sync + 'static, impl Fn() -> Vec<f32>) {
    let told = Arc::new(Mutex::new(Vec::new()));
    let heard = Arc::clone(&told);
    let listen = move |event| {
        if let Event::Done(share) = event {
            heard.lock().expect("nobody panicked").push(share);
        }
    };
    let shares = move || {
        let shares = told.lock().expect("nobody panicked").clone();
        assert!(shares.is_sorted() && shares.len() > 2, "{shares:?}");
        assert!(shares.iter().all(|share| (0.0..=1.0).contains(share)) && shares.last() == Some(&1.0), "{shares:?}");
        shares
    };
    (listen, shares)
}

#[test]
fn the_share_of_the_work_that_is_done_never_goes_back() {
    let shares = |work: &dyn Fn(&Options)| {
        let (listen, shares) = listener();
        work(&options().progress(listen));
        let shares = shares();
        assert!(shares.len() > 3, "{shares:?}");
        shares
    };
    let photo = std::fs::read("samples/chelsea.png").expect("a sample");
    let drawing = std::fs::read("samples/bars.svg").expect("a sample");
    for picture in [&photo, &drawing, &png()] {
        shares(&|options| drop(tactograph::convert(picture, options).expect("a page")));
    }
    shares(&|options| drop(tactograph::convert_to_sheets(&photo, None, options).expect("sheets")));
    for tracing in [Tracing::contours(), Tracing::lines()] {
        let shares = shares(&|options| drop(tactograph::trace(&photo, &tracing, options).expect("contours")));
        // what no trace takes is not waited for
        assert!(shares[shares.len() - 2] > 0.7, "{tracing:?}: {shares:?}");
    }
}

#[test]
fn rendering_tells_how_far_it_is() {
    let svg = tactograph::convert(&png(), &options()).expect("a page").page.to_svg();
    let embosser = Profile::named("index-basic-d").expect("it is built in");
    for rendering in [RenderOptions::new(), RenderOptions::new().profile(embosser)] {
        let (listen, shares) = listener();
        tactograph::render(&svg, &rendering.progress(listen)).expect("a page");
        shares();
    }
}

#[test]
fn what_cannot_be_lines_is_refused_when_it_is_given() {
    let page = tactograph::convert(&png(), &options()).expect("a page").page.to_svg();
    let broken = [&b"\x89PNG\r\n\x1a\n"[..], b"cut off"].concat();
    let id = |given: Result<Options, Error>| given.err().map(|error| error.id());
    for (bytes, lines, others) in [
        (&b""[..], "empty", "not-a-page"),
        (b"a letter to somebody", "unknown-format", "not-a-page"),
        (&broken, "undecodable", "not-a-page"),
        (b"<svg", "undecodable", "undecodable"),
        (b"P1 2 2 1 0 0 1", "too-few-pixels", "not-a-page"),
    ] {
        let told = String::from_utf8_lossy(bytes);
        assert_eq!(id(options().lines(bytes)), Some(lines), "{told}");
        assert_eq!(id(options().add_lines(bytes)), Some(others), "{told}");
        assert_eq!(id(options().areas(bytes)), Some(others), "{told}");
    }
    assert_eq!([id(options().lines(png())), id(options().lines(&page)), id(options().areas(&page))], [None; 3]);
}

#[test]
fn contours_are_those_of_the_page_that_a_person_corrects() {
    let right: Crop = "0,0,50%,100%".parse().expect("a part");
    let traced = |tracing: Tracing, options: &Options| {
        let traced = tactograph::trace(&png(), &tracing, options).expect("contours");
        traced.trace.polylines.into_iter().flat_map(|line| line.points).map(|at| at.x).collect::<Vec<f32>>()
    };
    let least = |xs: Vec<f32>| xs.into_iter().fold(f32::INFINITY, f32::min);
    for tracing in [Tracing::contours(), Tracing::contours_at_full_resolution(), Tracing::lines()] {
        assert!(least(traced(tracing, &options())) < 40.0);
        assert!((59.0..89.0).contains(&least(traced(tracing, &options().erase(right)))), "{tracing:?}");
    }
    // lines of a page in place of what the picture has
    let page = tactograph::convert(&png(), &options()).expect("a page").page;
    let moved = page.to_svg().replace("id=\"lines\"", "transform=\"translate(3 0)\" id=\"lines\"");
    let by = least(traced(Tracing::lines(), &options().lines(&moved).expect("a page")))
        - least(traced(Tracing::lines(), &options()));
    let px = 3.0 * 120.0 / page.figure.place.width();
    assert!((by - px).abs() < 0.5, "{by} px in place of {px}");
}

#[test]
fn what_is_around_the_subject_is_left_calm() {
    let coffee = std::fs::read("samples/coffee.png").expect("a sample");
    let percent = |at| Position::percent(at).expect("a number");
    let at = |x: f64, y: f64| options().subject(percent(x), percent(y));
    let convert = |options: &Options| tactograph::convert(&coffee, options).expect("a page");
    let (plain, subject) = (convert(&options()), convert(&at(40.0, 20.0)));
    let lines = |drawing: &Drawing| drawing.page.figure.lines.iter().map(|line| line.length()).sum::<f32>();
    let change = lines(&subject) / lines(&plain);
    assert!((change - 1.0).abs() < 0.02, "what tells most anyway changes no other line: {change}");
    let cat = std::fs::read("samples/chelsea.png").expect("a sample");
    let of_cat = |options: &Options| tactograph::convert(&cat, options).expect("a page").page.figure.lines.clone();
    assert!(of_cat(&options()) != of_cat(&at(50.0, 55.0)), "another outline comes first");
    assert!(subject.notes.iter().all(|note| !matches!(note, Note::NoSubject(..) | Note::BackgroundCalmed(_))));
    let found = subject.notes.iter().find(|note| note.id() == "subject");
    assert!(
        matches!(found, Some(Note::Subject { at: [40, 20], mm: [20..120, 20..120], is_first: true, .. })),
        "{found:?}"
    );
    let calm = convert(&at(40.0, 20.0).calm_background(true));
    let left_out = calm.notes.iter().find_map(|note| match note {
        Note::BackgroundCalmed(millimetres) => Some(*millimetres),
        _ => None,
    });
    assert!(left_out.is_some_and(|mm| mm > 100), "{:?}", calm.notes);
    let glyphs = |drawing: &Drawing| -> Vec<MmPoint> {
        drawing.page.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(|glyph| glyph.at).collect()
    };
    let (all, few) = (glyphs(&subject), glyphs(&calm));
    assert!(!few.is_empty() && few.len() < all.len() / 4, "{} of {}", few.len(), all.len());
    // a place where there is nothing, and one in a drawing
    let white = Picture::rgba8(120, 90, &[255; 4 * 120 * 90]).expect("a picture");
    let of_white = tactograph::convert(white, &at(40.0, 20.0)).expect("a page");
    let nothing = Note::NoSubject(tactograph::Reason::NothingThere, "40 %, 20 %".to_owned());
    assert!(of_white.notes.contains(&nothing), "{:?}", of_white.notes);
    let disc = tactograph::convert(&png(), &at(50.0, 50.0).calm_background(true)).expect("a page");
    assert!(!disc.notes.iter().any(|note| matches!(note, Note::NoSubject(..))), "{:?}", disc.notes);
    assert!(!glyphs(&disc).is_empty());
}

#[test]
fn a_page_is_no_picture_wherever_one_is_asked_for() {
    let made = tactograph::convert(&png(), &options()).expect("a page").page;
    let page = made.to_svg();
    let page = page.as_bytes();
    assert_eq!(tactograph::convert(page, &options()).err(), Some(Error::IsAPage));
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut packed, page).expect("it is in memory");
    let packed = packed.finish().expect("it is in memory");
    assert_eq!(tactograph::convert(&packed, &options()).err(), Some(Error::IsAPage), "as SVGZ");
    let pdf = made.to_pdf();
    assert_eq!(tactograph::convert(&pdf, &options()).err(), Some(Error::IsAPageIn { format: "PDF" }));
    let dpi = Dpi::new(96).expect("a resolution");
    let preview = made.to_png(dpi, Default::default(), &Fonts::none()).expect("a PNG");
    assert_eq!(tactograph::convert(&preview, &options()).err(), Some(Error::IsAPageIn { format: "PNG" }));
    assert_eq!(tactograph::convert_to_sheets(page, None, &options()).err(), Some(Error::IsAPage));
    assert_eq!(tactograph::trace(page, &Tracing::contours(), &options()).err(), Some(Error::IsAPage));
}

#[test]
fn lines_that_a_profile_leaves_out_are_no_missing_contours() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("figure.lines", "false").expect("a key");
    let notes = |tracing| tactograph::trace(&png(), &tracing, &Options::new(profile.clone())).expect("a trace").notes;
    assert_eq!(notes(Tracing::lines()), [Note::LinesOff]);
    assert!(Note::LinesOff.to_string().contains("figure.lines"));
    assert_eq!(notes(Tracing::contours()), []);
}

#[test]
fn languages_are_listed_and_written() {
    for language in Options::languages() {
        let drawing = tactograph::convert(&png(), &options().language(language)).expect("a page");
        let told = drawing.notes.iter().find(|note| note.id() == "no-braille-code");
        assert!(told.is_none() && !drawing.page.braille.is_empty(), "{language}: {told:?}");
    }
    assert!(tactograph::Description::languages().all(|language| Options::languages().any(|other| other == language)));
}

#[test]
fn classes_are_found_by_their_names() {
    assert_eq!(Class::ALL.map(|class| Class::named(class.name())), Class::ALL.map(Ok));
    let refused = Class::named("Blue").expect_err("names are in lower case");
    let told =
        "there is no class of colours called \"Blue\", did you mean blue? Take one of blue, green, yellow, red, grey";
    assert_eq!((refused.id(), refused.to_string().as_str()), ("no-such-name", told));
}

#[test]
fn work_that_is_cancelled_ends_between_stages() {
    for last in [Stage::Decode, Stage::Edges, Stage::Lines, Stage::Textures] {
        let begun = Arc::new(Mutex::new(Vec::new()));
        let done = Arc::new(AtomicBool::new(false));
        let (told, is_done, asked) = (Arc::clone(&begun), Arc::clone(&done), Arc::clone(&done));
        let options = Options::new(Profile::named("swell-a4").expect("it is built in"))
            .progress(move |event| match event {
                Event::Begin(stage) => told.lock().expect("nothing panics").push(stage),
                Event::End(stage) if stage == last => is_done.store(true, Ordering::Relaxed),
                _ => {}
            })
            .cancelled(move || asked.load(Ordering::Relaxed));
        assert_eq!(tactograph::convert(&png(), &options).err(), Some(Error::Cancelled), "after {last:?}");
        let begun = begun.lock().expect("nothing panics");
        assert!(begun.contains(&last) && !begun.contains(&Stage::Page), "after {last:?}: {begun:?}");
        if last == Stage::Edges {
            assert!(!begun.contains(&Stage::Lines), "{begun:?}");
        }
    }
}

#[test]
fn what_looks_at_a_page_can_be_cancelled_between_any_two_questions() {
    let svg = tactograph::convert(&png(), &options()).expect("a page").page.to_svg();
    type Look = fn(&str, &PageOptions) -> Result<(), Error>;
    let looks: [Look; 3] = [
        |svg, options| tactograph::check(svg, options).map(drop),
        |svg, options| tactograph::describe(svg, options).map(drop),
        |svg, options| tactograph::feel(svg, options).map(drop),
    ];
    for (look, questions) in looks.into_iter().zip([12, 12, 4]) {
        let mut asked = 0;
        loop {
            let left = AtomicUsize::new(asked);
            let answer = move || left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1)).is_err();
            match look(&svg, &PageOptions::new().cancelled(answer)) {
                Ok(()) => break,
                Err(refused) => assert_eq!(refused, Error::Cancelled, "at question {asked}"),
            }
            asked += 1;
        }
        assert!(asked >= questions, "{asked} questions");
    }
}

#[test]
fn rendering_can_be_cancelled() {
    let svg = tactograph::convert(&png(), &options()).expect("a page").page.to_svg();
    let embosser = Profile::named("index-basic-d").expect("it is built in");
    let rendering = RenderOptions::new().profile(embosser).cancelled(|| true);
    assert_eq!(tactograph::render(&svg, &rendering).err(), Some(Error::Cancelled));
    assert!(tactograph::render(&svg, &rendering.cancelled(|| false)).is_ok());
}
