//! Lines and areas of a page that a person corrected, given to a new conversion of its picture.

use tactograph::marks::{Line, Parts, Pen, Run};
use tactograph::{
    Crop, DotFormat, Embossing, Error, MmPoint, Options, Page, PageOptions, Profile, RenderOptions, SheetGrid,
};

pub(crate) const PICTURE: &str = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
    <rect width='300' height='200' fill='#fff'/>\
    <path d='M30 30H140V170H30Z' fill='#c00' stroke='#000' stroke-width='3'/>\
    <path d='M190 60L270 150H190Z' fill='#06c' stroke='#000' stroke-width='3'/></svg>";

pub(crate) fn options() -> Options {
    Options::new(Profile::named("swell-a4").expect("it is built in"))
}

pub(crate) fn page(options: &Options) -> Page {
    tactograph::convert(PICTURE.as_bytes(), options).expect("a page").page
}

/// All points of the figure's lines, and the places of its signs by class.
fn marks(page: &Page) -> (Vec<MmPoint>, Vec<(String, Vec<MmPoint>)>) {
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    let points = runs.flat_map(|run| run.points.iter().copied()).collect();
    let textures = page.figure.textures.iter();
    let signs = |texture: &tactograph::marks::Texture| texture.glyphs.iter().map(|glyph| glyph.at).collect();
    (points, textures.map(|texture| (texture.class.name().to_owned(), signs(texture))).collect())
}

/// Whether each of some places is near one of the others.
fn are_near(some: &[MmPoint], others: &[MmPoint]) -> bool {
    !some.is_empty() && some.iter().all(|at| others.iter().any(|other| (*other - *at).length() < 0.1))
}

#[test]
fn a_page_for_the_back_of_the_sheet_is_taken_as_its_picture_lies() {
    let [own, back] = [false, true].map(|mirrored| page(&options().mirrored(mirrored)).to_svg());
    for mirrored in [false, true] {
        let with = |svg: &String| {
            let all = options().lines(svg).and_then(|options| options.areas(svg)).expect("a page of the program");
            let made = page(&all.mirrored(mirrored));
            marks(&if mirrored { made.mirrored() } else { made })
        };
        let ((lines, signs), (of_back, signs_of_back)) = (with(&own), with(&back));
        assert!(are_near(&lines, &of_back) && are_near(&of_back, &lines), "mirrored: {mirrored}");
        assert_eq!((signs.len(), signs_of_back.len()), (2, 2));
        for ((class, at), (class_of_back, at_of_back)) in signs.iter().zip(&signs_of_back) {
            assert_eq!(class, class_of_back);
            assert!(are_near(at, at_of_back) && are_near(at_of_back, at), "{class}, mirrored: {mirrored}");
        }
    }
}

#[test]
fn areas_drawn_beside_lines_that_are_given_are_told() {
    let own = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><g fill='none' stroke='#000'>\
               <path d='M20 20H280'/></g><path d='M160 40H180V180H160Z' fill='#06c'/></svg>";
    let told = |options: Options| {
        let drawing = tactograph::convert(PICTURE.as_bytes(), &options).expect("a page");
        drawing.notes.iter().map(ToString::to_string).filter(|note| note.contains("1 area that was drawn")).count()
    };
    assert_eq!(told(options().add_lines(own).expect("a drawing")), 1);
    assert_eq!(told(options().lines(own).expect("a drawing")), 1);
    let other = page(&options()).to_svg();
    assert_eq!(told(options().add_lines(own).and_then(|options| options.areas(&other)).expect("a page")), 1);
    // of a page that is given as both, its area is taken
    let both = other.replacen("</svg>", "<rect x='90' y='60' width='20' height='30' fill='#06c'/></svg>", 1);
    assert_eq!(told(options().lines(&both).expect("a page")), 1);
    assert_eq!(told(options().lines(&both).and_then(|options| options.areas(&both)).expect("a page")), 0);
}

#[test]
fn a_page_of_another_part_of_the_picture_is_refused() {
    let part: Crop = "0,0,60%,100%".parse().expect("a part");
    let [whole, piece] = [options(), options().crop(part)].map(|options| page(&options).to_svg());
    let refused = |options: Options| match tactograph::convert(PICTURE.as_bytes(), &options) {
        Err(Error::OtherPart { page, drawn }) => Some((page, drawn)),
        Err(error) => panic!("{error}"),
        Ok(_) => None,
    };
    let (all, of_part) = ("all of it".to_owned(), "the part 0,0,60%,100% of it".to_owned());
    let given = |svg: &String| [options().lines(svg), options().add_lines(svg), options().areas(svg)];
    for options in given(&piece).map(|options| options.expect("a page of the program")) {
        assert_eq!(refused(options.clone()), Some((of_part.clone(), all.clone())));
        assert_eq!(refused(options.crop("0%,0%,60%,100%".parse().expect("a part"))), None, "the same part");
    }
    for options in given(&whole).map(|options| options.expect("a page of the program")) {
        assert_eq!(refused(options.clone().crop(part)), Some((all.clone(), of_part.clone())));
        assert_eq!(refused(options.crop("0,0,100%,100%".parse().expect("a part"))), None, "all of it");
    }
    let grid = SheetGrid::new(2, 1).expect("a grid");
    let sheets = tactograph::convert_to_sheets(PICTURE.as_bytes(), Some(grid), &options()).expect("sheets");
    let sheet = sheets.pages[0].to_svg();
    let (page, _) = refused(options().lines(sheet).expect("a page of the program")).expect("it is a piece");
    assert!(page.contains("sheet a1"), "{page}");
}

/// The rules that a check of a page finds broken, each with what it says.
pub(crate) fn found(svg: &str) -> Vec<(&'static str, String)> {
    let checked = tactograph::check(svg, &PageOptions::new()).expect("a page");
    checked.findings.into_iter().map(|finding| (finding.rule.id, finding.what)).collect()
}

#[test]
fn an_area_in_the_group_of_another_colour_is_found() {
    let svg = page(&options()).to_svg();
    assert_eq!(found(&svg), []);
    let red = svg.find("id=\"texture-red\"").expect("it has a red area");
    let begin = red + svg[red..].find("<path").expect("a path of it");
    let end = begin + svg[begin..].find("/>").expect("it ends") + 2;
    let (area, without) = (&svg[begin..end], [&svg[..begin], &svg[end..]].concat());
    let blue = without.find("id=\"texture-blue\"").expect("it has a blue area");
    let inside = blue + without[blue..].find('>').expect("it begins") + 1;
    let moved = [&without[..inside], area, &without[inside..]].concat();
    let found = found(&moved);
    assert!(matches!(&found[..], [("texture-sign", what)] if what.contains("is blue")), "{found:?}");
    let drawing = tactograph::render(&moved, &RenderOptions::new()).expect("a page");
    assert!(drawing.page.figure.textures.iter().all(|texture| texture.class == tactograph::Class::Blue));
    assert_eq!(self::found(&drawing.page.to_svg()), [], "render draws its marks anew");
}

#[test]
fn an_area_that_was_moved_onto_another_one_is_there() {
    let before = page(&options());
    let moved = "transform=\"translate(-87,0)\" data-class=\"blue\"";
    let moved = before.to_svg().replacen("data-class=\"blue\"", moved, 1);
    let larger = RenderOptions::new().profile(Profile::named("swell-a3").expect("it is built in"));
    let larger = tactograph::render(&moved, &larger).expect("a page").page;
    let again = page(&options().areas(&moved).expect("a page"));
    let share = |page: &Page| page.figure.share(tactograph::Class::Blue);
    for page in [&larger, &again] {
        assert!((share(page) / share(&before) - 1.0).abs() < 0.05, "{} of {}", share(page), share(&before));
        let blue = page.figure.textures.iter().find(|texture| texture.class == tactograph::Class::Blue);
        assert!(blue.is_some_and(|blue| blue.glyphs.len() > 20), "{blue:?}");
    }
}

#[test]
fn a_layer_that_is_renamed_to_another_colour_has_that_and_it_is_told() {
    let svg = page(&options()).to_svg();
    let renamed = svg.replacen("inkscape:label=\"Texture red\"", "inkscape:label=\"Texture yellow\"", 1);
    let told = "the layer \"Texture yellow\" was that of red: the areas in it are yellow now";
    for (svg, class, count) in [(&svg, "red", 0), (&renamed, "yellow", 1)] {
        let drawing = tactograph::render(svg, &RenderOptions::new()).expect("a page");
        let classes: Vec<&str> = drawing.page.figure.textures.iter().map(|texture| texture.class.name()).collect();
        assert!(classes.len() == 2 && classes.contains(&class), "{classes:?}");
        assert_eq!(drawing.notes.iter().filter(|note| note.to_string().contains(told)).count(), count);
        assert_eq!(found(&drawing.page.to_svg()), [], "its signs are those of {class}");
    }
}

#[test]
fn a_copy_of_another_colour_takes_the_place_of_what_it_lies_on() {
    let svg = page(&options()).to_svg();
    let begin = svg[..svg.find("data-class=\"red\"").expect("a red area")].rfind('<').expect("it is an element");
    let end = begin + svg[begin..].find("/>").expect("it ends") + 2;
    let copy = svg[begin..end].replace("id=\"region-", "id=\"copy-");
    let blue = svg.find("id=\"texture-blue\"").expect("it has a blue area");
    let inside = blue + svg[blue..].find('>').expect("it begins") + 1;
    let edited = [&svg[..inside], &copy, &svg[inside..]].concat();
    let drawing = tactograph::render(&edited, &RenderOptions::new()).expect("a page");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("the texture of red area 1 (under ")), "{told:?}");
    assert!(drawing.page.figure.textures.iter().all(|texture| texture.class == tactograph::Class::Blue));
    assert_eq!(found(&drawing.page.to_svg()), []);
    let again = tactograph::convert(PICTURE.as_bytes(), &options().areas(&edited).expect("a page")).expect("a page");
    let told: Vec<String> = again.notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("the texture of red area 1 (under ")), "{told:?}");
    assert!(again.page.figure.textures.iter().all(|texture| texture.class == tactograph::Class::Blue));
}

#[test]
fn how_a_typed_text_stands_is_told_of_the_page_that_is_written_only() {
    let page = page(&options());
    let at = page.figure.place.center();
    let text = format!("<g id='labels-text'><text x='{}' y='{}'>Roof</text></g></svg>", at.x, at.y);
    let svg = page.to_svg().replacen("</svg>", &text, 1);
    let told = |options: RenderOptions| {
        let drawing = tactograph::render(&svg, &options).expect("a page");
        drawing.notes.iter().map(|note| format!("{note}\n")).collect::<String>()
    };
    let dots = Profile::named("index-basic-d").expect("it is built in");
    let [own, anew] = [RenderOptions::new(), RenderOptions::new().profile(dots)].map(told);
    assert!(own.contains("1 text that was typed is written in braille beside its place"), "{own}");
    assert!(anew.contains("1 text that was typed is taken as a label in braille"), "{anew}");
    assert!(!anew.contains("beside its place"), "{anew}");
    assert!(!own.contains("taken as a label"), "{own}");
}

#[test]
fn a_shape_drawn_in_place_of_another_is_missing_in_the_overview() {
    let round = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><rect width='300' height='200' fill='#fff'/>\
                 <circle cx='150' cy='100' r='60' fill='none' stroke='#000' stroke-width='3'/></svg>";
    let page = tactograph::convert(round.as_bytes(), &options()).expect("a page").page;
    let svg = page.to_svg();
    let place = page.figure.place;
    let mm = |px: f32| px * place.width() / 300.0;
    let [x, y, side] = [place.min.x + mm(90.0), place.min.y + mm(40.0), mm(120.0)];
    let square = format!("<path fill='none' stroke='#000' stroke-width='1.5' d='M{x} {y}h{side}v{side}h-{side}z'/>");
    let begin = svg.find("id=\"lines\"").expect("it has lines");
    let inside = begin + svg[begin..].find('>').expect("it begins") + 1;
    let end = inside + svg[inside..].find("</g>").expect("it ends");
    let redrawn = [&svg[..inside], &square, &svg[end..]].concat();
    let ids: Vec<&str> = found(&redrawn).into_iter().map(|(id, _)| id).collect();
    assert!(ids.contains(&"overview-lacks"), "{ids:?}");
}

#[test]
fn a_disc_in_the_layer_of_lines_is_a_dot_on_all_media() {
    for (profile, with_stroke) in [("swell-a4", 2.5), ("index-basic-d", 1.5)] {
        let page = page(&Options::new(Profile::named(profile).expect("it is built in")));
        let (svg, place) = (page.to_svg(), page.figure.place);
        // right of the triangle, where nothing is
        let at = MmPoint::new(place.max.x - 8.0, place.min.y + 15.0);
        let begin = svg.find("id=\"lines\"").expect("it has lines");
        let inside = begin + svg[begin..].find('>').expect("it begins") + 1;
        for (stroke, diameter) in [("", with_stroke), (" stroke='none'", 1.5)] {
            let disc = format!("<circle cx='{}' cy='{}' r='0.75' fill='#000'{stroke}/>", at.x, at.y);
            let edited = [&svg[..inside], &disc, &svg[inside..]].concat();
            let drawing = tactograph::render(edited, &RenderOptions::new()).expect("a page");
            assert_eq!(drawing.page.figure.lines.len(), page.figure.lines.len(), "{profile}");
            let dots = drawing.page.labels.iter().filter(|dots| dots.at.len() == 1 && (dots.at[0] - at).length() < 0.1);
            let diameters: Vec<f32> = dots.map(|dots| dots.diameter).collect();
            assert!(matches!(diameters[..], [one] if (one - diameter).abs() < 0.02), "{profile}: {diameters:?}");
            assert!(drawing.notes.iter().all(|note| !note.to_string().contains("without a name")), "{profile}");
        }
    }
}

#[test]
fn a_coloured_shape_that_is_too_small_for_a_texture_is_told_as_that() {
    let page = page(&options());
    let at = page.figure.place.max;
    let told = |fill: &str| {
        let mark = format!("<rect x='{}' y='{}' width='4' height='4' fill='{fill}'/></svg>", at.x - 12.0, at.y - 8.0);
        let edited = page.to_svg().replacen("</svg>", &mark, 1);
        let notes = tactograph::render(edited, &RenderOptions::new()).expect("a page").notes;
        notes.iter().map(|note| format!("{note}\n")).collect::<String>()
    };
    let (red, black) = (told("#f00"), told("#000"));
    assert!(red.contains("smaller than 25 square mm, too small for a texture, drawn as a line around it"), "{red}");
    assert!(!red.contains("without the colour"), "{red}");
    assert!(black.contains("without the colour of a texture, drawn as a line around it"), "{black}");
}

#[test]
fn a_filled_shape_in_the_overview_is_told_as_a_line() {
    let svg = page(&options()).to_svg();
    let begin = svg.find("id=\"overview\"").expect("it has an overview");
    let inside = begin + svg[begin..].find('>').expect("it begins") + 1;
    let told = |mark: &str| {
        let edited = [&svg[..inside], mark, &svg[inside..]].concat();
        let notes = tactograph::render(edited, &RenderOptions::new()).expect("a page").notes;
        let told: String = notes.iter().map(|note| format!("{note}\n")).collect();
        (told.contains("1 filled shape"), told.contains("in grey or colour"))
    };
    assert_eq!(told("<rect x='90' y='200' width='20' height='15' fill='#00f'/>"), (true, true));
    assert_eq!(told("<circle cx='100' cy='205' r='5' fill='#000'/>"), (true, false));
    assert_eq!(told("<rect x='90' y='200' width='20' height='15'/>"), (false, false), "it has no fill");
}

#[test]
fn white_marks_are_told_and_a_white_ground_is_not() {
    let svg = page(&options()).to_svg();
    let told = |mark: &str| {
        let edited = svg.replacen("</svg>", &format!("{mark}</svg>"), 1);
        let notes = tactograph::render(edited, &RenderOptions::new()).expect("a page").notes;
        notes.iter().any(|note| note.to_string().contains("1 white mark"))
    };
    assert!(told("<rect x='20' y='20' width='120' height='150' fill='#fff'/>"));
    assert!(told("<path d='M20 20H120' fill='none' stroke='#fff' stroke-width='5'/>"));
    assert!(!told("<rect width='210' height='297' fill='#fff'/>"), "a ground");
    assert!(!told("<path d='M20 20H120' fill='none'/>"), "nothing is painted");
}

#[test]
fn groups_that_take_too_much_memory_are_refused() {
    let groups = "<g opacity='.9'>".repeat(60) + "<path d='M10 10h500v500z'/>" + &"</g>".repeat(60);
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='690mm' height='690mm' viewBox='0 0 690 690'>\
         <g id='texture-red'>{groups}</g></svg>"
    );
    let refused = |error: Option<Error>| matches!(error, Some(Error::TooMuchMemory { .. }));
    assert!(refused(tactograph::check(&svg, &PageOptions::new()).err()));
    assert!(refused(tactograph::feel(&svg, &PageOptions::new()).err()));
}

#[test]
fn of_lines_given_twice_the_last_ones_count_and_are_told() {
    let outside = |x: u32| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><text x='{x}' y='40'>Word</text>\
                 <path d='M20 20H280' fill='none' stroke='#000'/></svg>"
        )
    };
    let told = |options: Options| {
        let drawing = tactograph::convert(PICTURE.as_bytes(), &options).expect("a page");
        drawing.notes.iter().filter(|note| note.to_string().contains("Word")).count()
    };
    let [first, last] = [20, 60].map(outside);
    assert_eq!(told(options().lines(&first).expect("a drawing")), 1);
    assert_eq!(told(options().lines(&first).and_then(|options| options.lines(&last)).expect("a drawing")), 1);
    // the same file as two things is told once
    assert_eq!(told(options().lines(&first).and_then(|options| options.add_lines(&first)).expect("a drawing")), 1);
}

#[test]
fn a_page_of_dots_with_strokes_is_written_for_no_device() {
    let options = Options::new(Profile::named("index-basic-d").expect("it is built in"));
    let page = tactograph::convert(PICTURE.as_bytes(), &options).expect("a page").page;
    let write =
        |page: &Page| tactograph::write_dots("dots", [page.clone()].as_slice(), DotFormat::Ubrl, Embossing::default());
    assert!(write(&page).is_ok());
    let mut parts = Parts::clone(&page);
    let run = Run { pen: Pen::Stroke, ..parts.figure.lines[0].runs[0].clone() };
    parts.figure.lines.push(Line { strength: 1.0, runs: vec![run] });
    let refused = write(&Page::new(parts).expect("its marks lie on the sheet"));
    assert_eq!(refused, Err(Error::NotAllDots));
}

#[test]
fn a_page_of_a_picture_of_another_size_is_told_as_it_may_be_another_picture() {
    let (own, larger) = (page(&options()).to_svg(), PICTURE.replace("viewBox='0 0 300 200'", "viewBox='0 0 600 400'"));
    let told = |picture: &str, options: Options| {
        let drawing = tactograph::convert(picture.as_bytes(), &options).expect("a page");
        let is_other = |note: &String| note.contains("of a picture of 300 x 200 pixels, and this one has 600 x 400");
        drawing.notes.iter().map(ToString::to_string).filter(is_other).count()
    };
    for with in [Options::lines, Options::add_lines, Options::areas] {
        let options = with(options(), &own).expect("a page of the program");
        assert_eq!((told(PICTURE, options.clone()), told(&larger, options)), (0, 1));
    }
    let both = options().lines(&own).and_then(|options| options.areas(&own)).expect("a page of the program");
    assert_eq!(told(&larger, both), 1, "once");
}

#[test]
fn places_in_a_file_of_added_lines_are_told_as_those_of_that_file() {
    let own = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200' width='300' height='200'>\
               <path d='M150 20V500' fill='none' stroke='#000' stroke-width='3'/></svg>";
    let drawing =
        tactograph::convert(PICTURE.as_bytes(), &options().add_lines(own).expect("a drawing")).expect("a page");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    let of_file = "(said of the file of added lines, in its own mm)";
    assert!(told.iter().any(|note| note.contains("beyond the sheet") && note.contains(of_file)), "{told:?}");
}

#[test]
fn areas_of_a_page_that_nobody_changed_are_as_large_as_before() {
    // two areas with pockets behind lines, in which there is no sign
    let picture = std::fs::read("samples/coffee.png").expect("a sample");
    let convert = |options: &Options| tactograph::convert(&picture, options).expect("a page").page;
    let before = convert(&options());
    let again = |page: Page| convert(&options().areas(page.to_svg()).expect("a page"));
    let after = (0..3).fold(before.clone(), |page, _| again(page));
    let areas = |page: &Page| -> Vec<(&str, f32)> {
        page.figure.textures.iter().map(|texture| (texture.class.name(), texture.area)).collect()
    };
    let (before, after) = (areas(&before), areas(&after));
    assert_eq!(before.len(), after.len(), "{before:?} {after:?}");
    for ((class, area), (class_after, area_after)) in before.iter().zip(&after) {
        assert_eq!(class, class_after);
        assert!((area_after / area - 1.0).abs() < 0.01, "{class}: {area} and {area_after} square mm");
    }
}

#[test]
fn lines_that_are_too_short_are_told_with_name_and_place() {
    let own = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><g fill='none' stroke='#000'>\
               <path d='M20 20H280'/><path id='hair' d='M150 100h5'/><path d='M150 120h5'/></g></svg>";
    for options in [options().lines(own), options().add_lines(own)] {
        let drawing = tactograph::convert(PICTURE.as_bytes(), &options.expect("a drawing")).expect("a page");
        let at = drawing.page.figure.place.center();
        let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
        let named = format!("2 lines of those given (the first, line \"hair\", at {:.0}, {:.0} mm)", at.x, at.y);
        assert!(told.iter().any(|note| note.contains(&named)), "{named}: {told:?}");
    }
}

/// A letter C whose opening a line that is added points at, 3 mm before it: nothing of it gave way.
#[test]
fn a_line_that_is_open_in_the_picture_is_not_told_as_opened() {
    let at = |degrees: u16| {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        format!("{:.2} {:.2}", 300.0 + 120.0 * cos, 200.0 + 120.0 * sin)
    };
    let letter: Vec<String> = (186..=534).step_by(2).map(at).collect();
    let svg = |inner: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='400'><g id='lines' fill='none' \
             stroke='#000' stroke-width='5'>{inner}</g></svg>"
        )
    };
    let picture = svg(&format!("<path d='M{}'/>", letter.join("L")));
    let own = svg("<path d='M60 200H168'/>");
    let drawing =
        tactograph::convert(picture.as_bytes(), &options().add_lines(&own).expect("a drawing")).expect("a page");
    assert_eq!(drawing.page.figure.lines.len(), 2, "the letter, and what was added");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    assert!(!told.iter().any(|note| note.contains("open on the page")), "{told:?}");
}
