//! Pages read back from their SVG: as they were where nobody changed them, and as an editor shows them where somebody
//! did.

use crate::common::{page, samples};
use tactograph::internals::page::{Class, Page, Run, Shape, Sign};
use tactograph::internals::profile::Profile;
use tactograph::internals::reading::{Reading, read};
use tactograph::internals::units::MmPoint;
use tactograph::medium::Medium;
use tactograph::{Error, Label, Note, Options, RenderOptions};

fn reading(svg: &str) -> Reading {
    read(svg.as_bytes()).expect("it is a page")
}

/// Coordinates are written in steps of 0.01 mm.
const STEP: f32 = 0.0051 * std::f32::consts::SQRT_2;

fn same_places(a: &[MmPoint], b: &[MmPoint], what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    for (p, q) in a.iter().zip(b) {
        assert!((*p - *q).length() <= STEP, "{what}: {p:?} became {q:?}");
    }
}

fn same_runs<'a>(a: impl Iterator<Item = &'a Run>, b: impl Iterator<Item = &'a Run>, what: &str) {
    let (a, b): (Vec<_>, Vec<_>) = (a.collect(), b.collect());
    assert_eq!(a.len(), b.len(), "{what}");
    for (p, q) in a.into_iter().zip(b) {
        same_places(&p.points, &q.points, what);
        assert!((p.width - q.width).abs() <= 0.0101 && p.closed == q.closed && p.pen == q.pen, "{what}");
    }
}

/// The same marks, up to the steps in which they are written.
fn same_page(a: &Page, b: &Page, what: &str) {
    assert_eq!((a.sheet, &a.title, &a.origin), (b.sheet, &b.title, &b.origin), "{what}");
    let device = |page: &Page| match &page.medium {
        Medium::Dots(dots) => Some(dots.clone()),
        _ => None,
    };
    assert_eq!((&a.description, device(a)), (&b.description, device(b)), "{what}");
    same_places(&a.frame.at, &b.frame.at, what);
    same_runs(a.orientation_mark.iter(), b.orientation_mark.iter(), what);
    same_runs(a.registration.iter(), b.registration.iter(), what);
    let lines = |page: &Page| page.figure.lines.iter().map(|line| line.runs.len()).collect::<Vec<_>>();
    assert_eq!(lines(a), lines(b), "{what}: one object a contour");
    same_runs(
        a.figure.lines.iter().flat_map(|line| &line.runs),
        b.figure.lines.iter().flat_map(|line| &line.runs),
        what,
    );
    assert_eq!(a.figure.source, b.figure.source, "{what}");
    // a corner and a size are written, each in steps
    let corner_and_size = |page: &Page| [page.figure.place.min, page.figure.place.size().to_vector().to_point()];
    same_places(&corner_and_size(a), &corner_and_size(b), what);
    assert_eq!(a.figure.textures.len(), b.figure.textures.len(), "{what}");
    for (p, q) in a.figure.textures.iter().zip(&b.figure.textures) {
        assert_eq!((p.class, p.sign, p.colour), (q.class, q.sign, q.colour), "{what}");
        assert!((p.area - q.area).abs() < 0.01 && p.glyphs.len() == q.glyphs.len(), "{what}");
        for (p, q) in p.glyphs.iter().zip(&q.glyphs) {
            same_places(&[p.at], &[q.at], what);
            let alike = p.corners().iter().zip(q.corners()).all(|(p, q)| (*p - q).length() <= 3.0 * STEP);
            assert!(alike, "{what}: {p:?} became {q:?}");
        }
    }
    assert_eq!(a.overview.is_some(), b.overview.is_some(), "{what}");
    if let (Some(a), Some(b)) = (&a.overview, &b.overview) {
        same_places(&a.frame.at, &b.frame.at, what);
        same_runs(a.lines.iter().flat_map(|line| &line.runs), b.lines.iter().flat_map(|line| &line.runs), what);
    }
    assert_eq!(a.labels.len(), b.labels.len(), "{what}");
    a.labels.iter().zip(&b.labels).for_each(|(a, b)| same_places(&a.at, &b.at, what));
    assert_eq!(a.braille.len(), b.braille.len(), "{what}");
    for (a, b) in a.braille.iter().zip(&b.braille) {
        assert_eq!((a.role, &a.text, &a.language), (b.role, &b.text, &b.language), "{what}");
        assert_eq!((&a.abbreviation, &a.lines), (&b.abbreviation, &b.lines), "{what}");
        same_places(&a.dots.at, &b.dots.at, what);
        same_runs(a.leader.iter(), b.leader.iter(), what);
    }
}

fn comes_back(page: &Page, what: &str) {
    let svg = page.to_svg();
    let Reading { page: back, notes, .. } = reading(&svg);
    assert_eq!(notes, [], "{what}");
    same_page(page, &back, what);
    let again = back.to_svg();
    let other = svg.lines().zip(again.lines()).find(|(a, b)| a != b);
    assert!(again == svg, "{what}: other bytes when it is written again: {other:?}");
}

#[test]
fn pages_that_nobody_changed_come_back_to_the_byte() {
    for sample in samples::names() {
        for profile in ["swell-a4", "index-basic-d", "graphiti", "viewplus-columbia", "braillerap"] {
            let others = ["viewplus-columbia", "braillerap"];
            if others.contains(&profile) && !["coffee.png", "landscape.svg"].contains(&sample.as_str()) {
                continue;
            }
            let drawing = page::of_sample(&sample, profile);
            comes_back(&drawing.page, &format!("{sample} for {profile}"));
            drawing.overview.iter().for_each(|page| comes_back(page, &format!("overview of {sample} for {profile}")));
        }
    }
}

#[test]
fn words_keys_mirrors_and_odd_directions_come_back() {
    let place = |percent: f32| tactograph::Position::percent(percent.into()).expect("a number");
    let label = |text: &str, x: f32| Label { x: place(x), y: place(50.0), text: text.to_owned() };
    for (profile, mirrored) in [("swell-a4", false), ("index-basic-d", true), ("viewplus-columbia", false)] {
        let mut profile = Profile::named(profile).expect("it is built in");
        profile.set("textures.palette.blue", "rhombus 10").expect("there is such a key");
        profile.set("print.swell", "0.2").expect("there is such a key");
        let name = profile.name.clone();
        let options = Options::new(profile)
            .title("Wiese & <Haus>\u{201e}")
            .language("de")
            .labels((0..9).map(|i| label("eine sehr lange Beschriftung", 10.0 * i as f32)).collect())
            .key(tactograph::KeySheets::Always)
            .mirrored(mirrored);
        let drawing = tactograph::convert(&samples::read("landscape.svg"), &options).expect("it can be converted");
        assert!(drawing.page.braille.len() > 1 && !drawing.key.is_empty());
        comes_back(&drawing.page, &name);
        drawing.key.iter().for_each(|page| comes_back(page, &format!("key for {name}")));
    }
}

/// A drawing with six gridlines, an axis and a line, and where the gridlines lie, mm below its upper edge.
const GRIDLINES: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400"><g stroke="#e0e0e0">
    <path d="M60 30H560M60 70H560M60 110H560M60 150H560M60 190H560M60 230H560"/></g>
    <g stroke="#000" stroke-width="3" fill="none"><path d="M60 10V350H570"/><path d="M200 300H500"/></g></svg>"##;

#[test]
fn braille_that_is_typed_on_a_gridline_changes_no_other_line() {
    let profile = Profile::named("swell-a4").expect("it is built in");
    let page = tactograph::convert(GRIDLINES.as_bytes(), &Options::new(profile)).expect("it can be converted").page;
    let gridlines = page.figure.lines.iter().filter(|line| line.strength < 10.0);
    let ends = |line: &tactograph::marks::Line| [line.runs[0].points[0], *line.runs[0].points.last().expect("a line")];
    let mut gridlines: Vec<[MmPoint; 2]> = gridlines.map(ends).collect();
    gridlines.sort_by(|a, b| a[0].y.total_cmp(&b[0].y));
    assert_eq!(gridlines.len(), 6);
    let at = gridlines[2][0].lerp(gridlines[2][1], 0.4);
    let wall = "<path id=\"wall\" d=\"M40,20v30\" stroke=\"#000\" stroke-width=\"1\" fill=\"none\"/>";
    let text = format!("<text x=\"{}\" y=\"{}\">\u{2801}\u{2803}\u{2807}</text>", at.x, at.y + 2.0);
    let typed = format!("{wall}<g id=\"labels-text\">{text}</g></svg>");
    let edited = page.to_svg().replace("</svg>", &typed);
    let rendered = tactograph::render(&edited, &RenderOptions::new()).expect("it is a page").page;
    assert_eq!(rendered.braille.len(), 1);
    let lines = |page: &Page| page.figure.lines.iter().map(|line| line.runs[0].points.clone()).collect::<Vec<_>>();
    let is_there = |of: &[MmPoint], page: &Page| {
        lines(page)
            .iter()
            .any(|line| line.len() == of.len() && line.iter().zip(of).all(|(a, b)| (*a - *b).length() < 0.02))
    };
    let changed: Vec<_> = lines(&page).into_iter().filter(|line| !is_there(line, &rendered)).collect();
    assert_eq!(changed.len(), 1, "only the gridline below the braille: {changed:?}");
    assert!(is_there(&[MmPoint::new(40.0, 20.0), MmPoint::new(40.0, 50.0)], &rendered), "the line of a person");
    assert_eq!(rendered.figure.lines.len(), page.figure.lines.len() + 2, "it is in two parts");
    // their names stay with them
    let pins = RenderOptions::new().profile(Profile::named("dot-pad").expect("it is built in"));
    let told = tactograph::render(&edited, &pins).expect("it has room").notes;
    let told: Vec<String> = told.iter().map(ToString::to_string).filter(|told| told.contains("\"wall\"")).collect();
    // a part of it is outside of the figure, and what is inside has no room among the pins
    assert!(told.len() <= 2 && told.iter().all(|told| told.contains("left out")), "{told:?}");
}

#[test]
fn a_mirrored_page_is_laid_out_anew_as_it_is_felt() {
    let picture = samples::read("coffee.png");
    let made = |profile: &str, mirrored: bool| {
        let options = Options::new(Profile::named(profile).expect("it is built in")).title("A cup of tea");
        tactograph::convert(&picture, &options.mirrored(mirrored)).expect("it can be converted").page
    };
    let rendered = |page: &Page, profile: &str| {
        let options = RenderOptions::new().profile(Profile::named(profile).expect("it is built in"));
        tactograph::render(page.to_svg(), &options).expect("it has room")
    };
    for (from, to) in [("swell-a4", "swell-letter"), ("swell-a4", "index-basic-d")] {
        let (plain, mirrored) = (made(from, false), made(from, true));
        let check = tactograph::check(mirrored.to_svg(), &tactograph::PageOptions::new()).expect("it is a page");
        assert_eq!(check.findings.iter().filter(|finding| finding.rule.id == "braille-cell").count(), 0);
        let (plain, mirrored) = (rendered(&plain, to), rendered(&mirrored, to));
        let is_for_dots = matches!(plain.page.medium, Medium::Dots(_));
        assert_eq!(mirrored.page.is_mirrored(), is_for_dots);
        let is_told = mirrored.notes.iter().any(|note| note.to_string().contains("exchanged again"));
        assert_eq!(is_told, !is_for_dots, "{:?}", mirrored.notes);
        let felt = if is_for_dots { mirrored.page.clone().mirrored() } else { mirrored.page.clone() };
        let shares = |page: &Page| {
            let middle = page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
            let (count, sum) = middle.fold((0, 0.0), |(count, sum), at| (count + 1, sum + at.x));
            (page.figure.lines.len(), sum / count as f32)
        };
        let ((lines, middle), (of_plain, middle_of_plain)) = (shares(&felt), shares(&plain.page));
        assert!(lines.abs_diff(of_plain) <= 1 && (middle - middle_of_plain).abs() < 0.5, "{middle} {middle_of_plain}");
        let signs = |page: &Page| page.figure.textures.iter().map(|of| (of.class, of.sign)).collect::<Vec<_>>();
        assert_eq!(signs(&felt), signs(&plain.page));
    }
}

/// What lies on the border of two ninths of the figure, and colours of one share, are told alike before and after.
#[test]
fn descriptions_of_pages_with_keys_come_back() {
    for sample in ["map.svg", "worksheet.pdf"] {
        for profile in ["swell-a4", "swell-letter", "index-basic-d"] {
            let options = Options::new(Profile::named(profile).expect("it is built in"));
            let options = options.title("Test page").label_texts(true).key(tactograph::KeySheets::Always);
            let drawing = tactograph::convert(&samples::read(sample), &options).expect("it can be converted");
            assert!(!drawing.key.is_empty(), "{sample} for {profile}");
            let (pages, what) = (drawing.into_pages(), format!("{sample} with its key for {profile}"));
            for page in pages {
                let read = reading(&page.to_svg()).page;
                let again = tactograph::render(page.to_svg(), &tactograph::RenderOptions::new()).expect("a page").page;
                assert_eq!(again.description, page.description, "{what}");
                assert!(again.to_svg() == page.to_svg(), "{what}: other bytes when it is written again");
                same_page(&page, &read, &what);
            }
        }
    }
}

#[test]
fn a_label_may_be_called_as_a_layer_is() {
    let place = |percent| tactograph::Position::percent(percent).expect("a number");
    let label = Label { x: place(50.0), y: place(50.0), text: "Frame".to_owned() };
    let options = Options::new(Profile::named("swell-a4").expect("it is built in")).labels(vec![label]);
    let page = tactograph::convert(&samples::read("landscape.svg"), &options).expect("it can be converted").page;
    assert_eq!(page.braille.len(), 1);
    comes_back(&page, "a label called as the frame is");
}

#[test]
fn calibration_sheets_and_sheets_of_a_large_picture_come_back() {
    let profile = Profile::named("swell-a4").expect("it is built in");
    for page in tactograph::calibrate(&profile).expect("there is room").pages {
        comes_back(&page, "calibration");
    }
    let grid = "1x2".parse().expect("it is a grid");
    let sheets = tactograph::convert_to_sheets(&samples::read("coffee.png"), Some(grid), &Options::new(profile));
    sheets.expect("there is room").all().for_each(|page| comes_back(page, "a sheet of several"));
}

/// A sample is as thin as it says, whatever the profile has as the least width.
#[test]
fn calibration_sheets_are_rendered_as_they_are() {
    let widths = |page: &Page| -> Vec<f32> {
        page.figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.width).collect()
    };
    let profile = Profile::named("swell-a4").expect("it is built in");
    let mut thinnest = f32::INFINITY;
    for page in tactograph::calibrate(&profile).expect("there is room").pages {
        let made = tactograph::render(page.to_svg(), &RenderOptions::new()).expect("it is a page");
        let (before, after) = (widths(&page), widths(&made.page));
        assert_eq!(before.len(), after.len(), "{:?}", made.notes);
        let is_kept = |(a, b): (&f32, &f32)| (a - b).abs() < 0.006;
        assert!(before.iter().zip(&after).all(is_kept), "{before:?} {after:?}");
        assert!(!made.notes.iter().any(|note| note.to_string().contains("mm wide, the")), "{:?}", made.notes);
        thinnest = after.into_iter().fold(thinnest, f32::min);
    }
    assert!(thinnest < 0.5, "there are samples that the profile would not draw: {thinnest}");
}

/// A page of a coffee cup, as an editor gets it.
fn coffee() -> String {
    page::of_sample("coffee.png", "swell-a4").page.to_svg()
}

#[test]
fn what_an_editor_does_is_read_as_it_shows() {
    let svg = coffee();
    let before = reading(&svg).page;
    let edited = |from: &str, to: &str| {
        assert!(svg.contains(from), "{from}");
        reading(&svg.replacen(from, to, 1))
    };
    let hidden = edited("id=\"line-2\"", "id=\"line-2\" style=\"display:none\"").page;
    assert_eq!(hidden.figure.lines.len(), before.figure.lines.len() - 1);
    assert_eq!(hidden.figure.lines[1], before.figure.lines[2]);

    let moved = edited("id=\"line-1\"", "id=\"line-1\" transform=\"translate(2 -3)\"").page;
    let (was, is) = (&before.figure.lines[0].runs[0].points[0], &moved.figure.lines[0].runs[0].points[0]);
    assert!((is.x - was.x - 2.0).abs() < 1e-3 && (is.y - was.y + 3.0).abs() < 1e-3);

    let restyled = edited("id=\"lines\"", "id=\"lines\" class=\"thin\"");
    assert_eq!(restyled.page.figure.lines, before.figure.lines);
    let grey = edited("<g fill=\"none\" id=\"lines\"", "<g style=\"opacity:0.5\" fill=\"none\" id=\"lines\"");
    assert!(grey.notes.iter().any(|note| note.to_string().contains("grey")), "{:?}", grey.notes);
    assert_eq!(grey.page.figure.lines, before.figure.lines);

    let turned = edited("id=\"texture-red\"", "id=\"texture-red\" transform=\"rotate(-45 100 100)\"").page;
    let of = |page: &Page| {
        let red = page.figure.textures.iter().find(|texture| texture.class == Class::Red).expect("there is red");
        match red.glyphs[0].shape {
            Shape::Rhombus { degrees, .. } => degrees,
            Shape::Dot { .. } => unreachable!("red has rhombuses"),
        }
    };
    assert!((of(&before) - 135.0).abs() < 1e-3 && (of(&turned) - 0.0).abs() < 0.5, "{}", of(&turned));
}

#[test]
fn what_is_drawn_by_hand_is_read_by_its_kind() {
    let drawn = |marks: &str| {
        let end = coffee().replace("</svg>", &format!("{marks}</svg>"));
        let Reading { page, notes, .. } = reading(&end);
        (page, notes.iter().map(Note::to_string).collect::<Vec<_>>().join("\n"))
    };
    let (before, none) = drawn("");
    assert_eq!(none, "");
    let count = before.figure.lines.len();

    let (page, told) = drawn(
        "<style>.own { stroke: black; stroke-width: 1.2; fill: none }</style>\
         <g transform=\"scale(2)\"><path id=\"a\" class=\"own\" d=\"M20,20 c5,-5 10,-5 15,0\"/></g>\
         <use href=\"#a\" x=\"10\" y=\"30\" transform=\"scale(1.5)\"/>\
         <rect x=\"30\" y=\"30\" width=\"20\" height=\"10\" fill=\"none\" stroke=\"#000\"/>",
    );
    let new = &page.figure.lines[count..];
    assert_eq!(new.len(), 3, "{told}");
    assert!((new[0].runs[0].width - 2.4).abs() < 1e-3 && new[0].runs[0].points.len() > 4);
    assert_eq!(new[0].runs[0].points[0], MmPoint::new(40.0, 40.0));
    assert!((new[1].runs[0].width - 1.8).abs() < 1e-3);
    assert_eq!(new[1].runs[0].points[0], MmPoint::new(45.0, 75.0));
    assert!(new[2].runs[0].closed && new[2].runs[0].points.len() == 4);
    assert!(told.contains("3 lines") && told.contains("outside of the layers"), "{told}");

    let (page, told) = drawn(
        "<circle cx=\"100\" cy=\"100\" r=\"0.75\"/><path d=\"M20,20h6v6z\" fill=\"#c00\"/>\
         <text x=\"20\" y=\"20\">Cup</text><path d=\"M-20,20h10\" stroke=\"#000\"/><image href=\"x.png\"/>",
    );
    let dots = page.labels.last().expect("a dot");
    assert_eq!((dots.diameter, dots.at.as_slice()), (1.5, &[MmPoint::new(100.0, 100.0)][..]));
    assert_eq!(page.figure.lines.len(), count + 1);
    let around = &page.figure.lines[count].runs[0];
    let corners = [(20.0, 20.0), (26.0, 20.0), (26.0, 26.0)].map(|(x, y)| MmPoint::new(x, y));
    assert!(around.closed && around.points == corners, "{around:?}");
    let widths = before.figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.width);
    assert!(widths.into_iter().any(|width| (width - around.width).abs() < 0.006), "{}", around.width);
    for what in ["1 disc", "1 filled shape", "in grey or colour", "\"Cup\"", "beyond the sheet", "1 picture"] {
        assert!(told.contains(what), "{what}: {told}");
    }
}

#[test]
fn a_region_in_another_group_has_its_class() {
    let svg = coffee();
    let document = roxmltree::Document::parse(&svg).expect("a page is well-formed");
    let region = document.descendants().find(|node| node.attribute("data-class") == Some("red")).expect("red");
    let text = &svg[region.range()];
    let without = svg.replacen(text, "", 1);
    let yellow = without.find("id=\"texture-yellow\"").expect("there is yellow");
    let inside = yellow + without[yellow..].find('>').expect("the group begins") + 1;
    let moved = format!("{}{text}{}", &without[..inside], &without[inside..]);
    let count = |page: &Page, class| page.figure.textures.iter().filter(|texture| texture.class == class).count();
    let (before, after) = (reading(&svg).page, reading(&moved).page);
    assert_eq!(count(&after, Class::Yellow), count(&before, Class::Yellow) + 1);
    assert_eq!(count(&after, Class::Red) + 1, count(&before, Class::Red));
    let signs = after.figure.textures.iter().filter(|texture| texture.class == Class::Yellow);
    assert!(signs.into_iter().all(|texture| texture.sign == Sign::Rhombus { degrees: 90.0 }));
}

#[test]
fn what_is_no_page_or_beyond_a_limit_is_refused_in_one_line() {
    let bomb = format!(
        "<!DOCTYPE svg [<!ENTITY a \"{}\">{}]><svg xmlns='http://www.w3.org/2000/svg'><g id='lines'>&z;</g></svg>",
        "x".repeat(100),
        ('b'..='z')
            .zip('a'..)
            .map(|(n, o)| format!("<!ENTITY {n} \"{}\">", format!("&{o};").repeat(9)))
            .collect::<String>()
    );
    let deep = format!(
        "<svg xmlns='http://www.w3.org/2000/svg'>{}{}</svg>",
        "<g id='lines'>".repeat(1000),
        "</g>".repeat(1000)
    );
    for bytes in [
        &b"%PDF-1.7"[..],
        b"hello",
        b"",
        b"\xff\xfe",
        b"<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><path d='M0,0h9'/></svg>",
        bomb.as_bytes(),
        deep.as_bytes(),
        b"<svg xmlns='http://www.w3.org/2000/svg'><g id='lines'>",
    ] {
        let fault = read(bytes).expect_err("it is refused");
        assert!(
            matches!(fault, Error::NotAPage { .. } | Error::Undecodable { .. } | Error::TooComplex { .. }),
            "{fault:?}"
        );
        assert!(!fault.to_string().contains('\n'), "{fault}");
    }
}

/// Bytes of a page changed at random: refused or read, never a panic.
#[test]
fn damaged_pages_are_refused_or_read() {
    let svg = page::of_sample("chart.svg", "swell-a4").page.to_svg();
    let words =
        ["1e38", "-1e38", "NaN", "0", "99999999", "\"", ">", "<g>", "</g>", "Z", "M", "transform=\"scale(0)\" "];
    let mut rng = tactograph_tools::rng::Rng::new(7);
    let mut read_well = 0;
    for _ in 0..80 {
        let mut damaged = svg.clone().into_bytes();
        for _ in 0..1 + rng.below(4) {
            let at = rng.below(damaged.len());
            let word = words[rng.below(words.len())].bytes();
            let end = (at + rng.below(6)).min(damaged.len());
            damaged.splice(at..end, word);
        }
        if let Ok(page) = read(&damaged) {
            read_well += 1;
            assert!(!page.page.to_svg().is_empty());
        }
    }
    assert!(read_well > 0, "nothing was read at all");
}

#[test]
fn sheets_beyond_all_paper_are_refused() {
    let svg = coffee().replacen("width=\"210mm\"", "width=\"900000mm\"", 1);
    assert!(matches!(read(svg.as_bytes()), Err(Error::NotAPage { .. })));
    let wide = coffee().replacen("data-box=\"18 ", "data-box=\"-9e30 ", 1);
    let page = reading(&wide).page;
    assert!(page.figure.place.min.x >= 0.0 && page.figure.place.max.x <= 210.0);
}

#[test]
fn a_description_that_was_made_follows_what_was_changed() {
    let svg = coffee();
    let less = svg.replacen("id=\"line-1\"", "id=\"line-1\" display=\"none\"", 1);
    let unchanged = tactograph::render(&svg, &RenderOptions::new()).expect("it is a page").page;
    assert_eq!(unchanged.description, reading(&svg).page.description);
    let count = reading(&svg).page.figure.lines.len();
    let rendered = tactograph::render(&less, &RenderOptions::new()).expect("it is a page").page;
    assert!(rendered.description.contains(&format!("{} lines", count - 1)), "{}", rendered.description);
    let own = less.replacen(">A sheet upright,", ">My cup,", 1);
    assert!(
        tactograph::render(&own, &RenderOptions::new()).expect("it is a page").page.description.starts_with("My cup,")
    );
}
