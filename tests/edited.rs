//! Pages that a person edited: what is drawn of them, and what is told.

use crate::corrections::{PICTURE, found, options, page};
use tactograph::internals::reading::{Reading, read};
use tactograph::marks::TextRole;
use tactograph::{
    Checked, Crop, Drawing, Error, MmPoint, MmRect, Note, Options, Page, PageOptions, Profile, RenderOptions, SheetGrid,
};

fn reading(svg: &str) -> Reading {
    read(svg.as_bytes()).expect("a page")
}

/// A page with something drawn on top of it.
fn with(svg: &str, added: &str) -> String {
    svg.replacen("</svg>", &format!("{added}</svg>"), 1)
}

/// A page with something drawn in its layer of lines.
fn with_line(svg: &str, added: &str) -> String {
    let begin = svg.find("id=\"lines\"").expect("it has lines");
    let inside = begin + svg[begin..].find('>').expect("it begins") + 1;
    [&svg[..inside], added, &svg[inside..]].concat()
}

fn render(svg: &str) -> Drawing {
    tactograph::render(svg, &RenderOptions::new()).expect("a page")
}

fn render_for(svg: &str, profile: &str) -> Drawing {
    let profile = Profile::named(profile).expect("it is built in");
    tactograph::render(svg, &RenderOptions::new().profile(profile)).expect("a page")
}

fn told(notes: &[Note]) -> String {
    notes.iter().map(|note| format!("{note}\n")).collect()
}

/// A rectangle around a place of the figure, in shares of it and mm: a stroke of this width.
fn rectangle(id: &str, page: &Page, [left, top, right, bottom]: [f32; 4], beyond: f32, width: f32) -> String {
    let place = page.figure.place;
    let at = |x: f32, y: f32| MmPoint::new(place.min.x + x * place.width(), place.min.y + y * place.height());
    let MmRect { min, max } = MmRect::new(at(left, top), at(right, bottom)).inflate(beyond, beyond);
    let (side, down) = (max.x - min.x, max.y - min.y);
    format!(
        "<path id='{id}' d='M{} {}h{side}v{down}h-{side}z' fill='none' stroke='#000' stroke-width='{width}'/>",
        min.x, min.y
    )
}

const RED: [f32; 4] = [0.1, 0.15, 0.4667, 0.85];

fn overview_box(page: &Page) -> MmRect {
    let overview = page.overview.as_ref().expect("it has an overview");
    let points = overview.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied());
    let scale = page.figure.place.width() / overview.place.width();
    MmRect::from_points(points.map(|at| page.figure.place.min + (at - overview.place.min) * scale))
}

#[test]
fn a_closed_line_of_a_person_comes_first_in_the_overview() {
    // a sheet that lies across has no room for a larger overview
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("page.orientation", "landscape").expect("it lies so");
    let options = || Options::new(profile.clone());
    let before = page(&options());
    let drawing = |svg: &str| {
        let options = options().lines(svg).expect("a page");
        tactograph::convert(PICTURE.as_bytes(), &options).expect("a page")
    };
    let beyond = |page: &Page| overview_box(&before).min.x - overview_box(page).min.x;
    // around the red box, so near to its line that a small picture has room for one of the two only; as thin as the pen
    // of an editor draws
    let thin = with_line(&before.to_svg(), &rectangle("mine", &before, RED, 5.0, 0.26));
    let with_one = drawing(&thin);
    assert!((beyond(&with_one.page) - 5.0).abs() < 1.0, "the outer line is {} mm off", beyond(&with_one.page));
    assert!(!told(&with_one.notes).contains("that you drew"), "{}", told(&with_one.notes));
    // of two by hand the larger one, and the other is told
    let with_two = drawing(&with_line(&thin, &rectangle("outer", &before, RED, 10.0, 0.26)));
    assert!((beyond(&with_two.page) - 10.0).abs() < 1.0, "the outer line is {} mm off", beyond(&with_two.page));
    let told = told(&with_two.notes);
    assert!(told.contains("the closed line that you drew, in the overview: line \"mine\" ("), "{told}");
}

#[test]
fn a_sheet_of_several_keeps_its_name_on_another_device() {
    let grid = SheetGrid::new(2, 1).expect("a grid");
    let sheets = tactograph::convert_to_sheets(PICTURE.as_bytes(), Some(grid), &options()).expect("sheets");
    for sheet in &sheets.pages {
        let name = sheet.part_of_set();
        for profile in ["index-basic-d", "swell-a3"] {
            let drawing = render_for(&sheet.to_svg(), profile);
            assert_eq!((drawing.page.part_of_set(), drawing.all().count()), (name.clone(), 1), "{profile}");
            let dots: usize = drawing.page.labels.iter().map(|dots| dots.at.len()).sum();
            let before: usize = sheet.labels.iter().map(|dots| dots.at.len()).sum();
            assert_eq!(dots, before, "{profile}: its name in braille");
            let told = told(&drawing.notes);
            assert!(told.contains(&format!("this is sheet {name} of a picture")), "{profile}: {told}");
            assert!(!told.contains("drawn by hand"), "{profile}: {told}");
            assert_eq!(found(&drawing.page.to_svg()), [], "{profile}");
        }
    }
}

#[test]
fn a_text_typed_outside_of_the_figure_has_no_leader_line() {
    let page = page(&options());
    let below = page.figure.place.max.y + 12.0;
    for string in ["Below", "\u{2803}\u{2811}"] {
        let text = format!("<g id='labels-text'><text x='60' y='{below}'>{string}</text></g>");
        let drawing = render(&with(&page.to_svg(), &text));
        let label = drawing.page.braille.iter().find(|text| text.text == string).expect("it is written");
        assert_eq!(label.leader, None, "{string}");
        assert!(!told(&drawing.notes).contains("within"), "{}", told(&drawing.notes));
    }
}

#[test]
fn a_label_in_a_closed_line_names_what_that_surrounds() {
    let hollow = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
                  <rect width='300' height='200' fill='#fff'/><g fill='none' stroke='#000' stroke-width='3'>\
                  <path d='M30 30H140V170H30Z'/><path d='M280 20V180'/><path d='M180 190H270'/></g></svg>";
    let page = tactograph::convert(hollow.as_bytes(), &options()).expect("a page").page;
    let place = page.figure.place;
    let told = |x: f32, y: f32| {
        let at = MmPoint::new(place.min.x + x * place.width(), place.min.y + y * place.height());
        let text = format!("<g id='labels-text'><text x='{}' y='{}'>Tree</text></g>", at.x, at.y);
        told(&render(&with(&page.to_svg(), &text)).notes)
    };
    let nothing = "no line or texture is within 12 mm";
    assert!(!told(0.28, 0.5).contains(nothing), "{}", told(0.28, 0.5));
    // between the box and the line on the right, where nothing is drawn
    assert!(told(0.7, 0.5).contains(nothing), "{}", told(0.7, 0.5));
}

#[test]
fn a_stroke_on_a_page_of_dots_is_judged_as_its_dots() {
    let options = Options::new(Profile::named("index-basic-d").expect("it is built in"));
    let page = page(&options);
    let svg = with_line(&page.to_svg(), &rectangle("mine", &page, RED, -4.0, 0.5));
    let rules = |svg: &str| found(svg).into_iter().map(|(rule, _)| rule).collect::<Vec<_>>();
    let (mut edited, rendered) = (rules(&svg), rules(&render(&svg).page.to_svg()));
    assert!(edited.contains(&"line-gap") && edited.contains(&"texture-gap"), "{edited:?}");
    // render leaves marks of textures out that are too near to it
    edited.retain(|rule| *rule != "texture-gap");
    assert_eq!(edited, rendered);
    let checked = tactograph::check(&svg, &PageOptions::new()).expect("a page");
    assert!(told(&checked.notes).contains("made dots"), "{}", told(&checked.notes));
    assert!(checked.findings.iter().any(|finding| finding.what.contains("\"mine\"")), "{checked}");
}

#[test]
fn lines_that_are_found_beside_added_ones_are_told() {
    let own = |x: u32| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
             <path d='M{x} 20V180' fill='none' stroke='#000' stroke-width='3'/></svg>"
        )
    };
    let told = |x: u32| {
        let options = options().add_lines(own(x)).expect("a drawing");
        told(&tactograph::convert(PICTURE.as_bytes(), &options).expect("a page").notes)
    };
    let beside = "beside lines that you drew and added";
    let far = told(165);
    assert!(!far.contains(beside), "{far}");
    let open = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
                <rect width='300' height='200' fill='#fff'/>\
                <path d='M30 20V180M120 30V170' fill='none' stroke='#000' stroke-width='3'/></svg>";
    let options = options().add_lines(own(42)).expect("a drawing");
    let drawing = tactograph::convert(open.as_bytes(), &options).expect("a page");
    let told = self::told(&drawing.notes);
    assert!(told.contains("1 line (") && told.contains(beside), "{told}");
}

#[test]
fn a_closed_line_stays_closed_where_an_added_one_ends_before_it() {
    let ring = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
                <rect width='300' height='200' fill='#fff'/>\
                <circle cx='180' cy='100' r='60' fill='none' stroke='#000' stroke-width='3'/></svg>";
    // 3 px before it, about 2 mm; on it; and into it
    for to in [117, 120, 150] {
        let own = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
             <path d='M20 100H{to}' fill='none' stroke='#000' stroke-width='3'/></svg>"
        );
        let options = options().add_lines(own).expect("a drawing");
        let drawing = tactograph::convert(ring.as_bytes(), &options).expect("a page");
        let place = drawing.page.figure.place;
        let lines = drawing.page.figure.lines.iter();
        let rings: Vec<_> = lines.filter(|line| line.length() > 1.1 * place.width()).collect();
        assert_eq!(rings.len(), 1, "to {to}: {} lines", drawing.page.figure.lines.len());
        let points: Vec<_> = rings[0].runs.iter().flat_map(|run| &run.points).collect();
        let ends = (*points[0] - *points[points.len() - 1]).length();
        let is_closed = rings[0].runs.iter().any(|run| run.closed) || ends < 0.05;
        assert!(is_closed, "to {to}: its ends are {ends} mm apart");
        assert!(!told(&drawing.notes).contains("open on the page"), "{}", told(&drawing.notes));
    }
}

#[test]
fn the_overview_is_told_of_as_what_becomes_of_it() {
    let page = page(&options());
    let svg = with_line(&page.to_svg(), &rectangle("mine", &page, [0.53, 0.02, 0.99, 0.33], 0.0, 1.5));
    let own = told(&render(&svg).notes);
    assert!(own.contains("the overview is as it was: ") && own.contains("change it there too, or delete it"), "{own}");
    let dots = told(&render_for(&svg, "index-basic-d").notes);
    assert!(dots.contains("the overview, on a sheet of its own, is drawn of that of the page that was read"), "{dots}");
    assert!(!dots.contains("as it was"), "{dots}");
    // an overview that is deleted is drawn of the figure
    let begin = svg.find("<g id=\"overview\"").or_else(|| svg.find("id=\"overview\"")).expect("it has an overview");
    let begin = svg[..=begin].rfind('<').expect("it is an element");
    let without = [&svg[..begin], "<g display=\"none\">", &svg[begin..].replacen("</svg>", "</g></svg>", 1)].concat();
    let drawing = render_for(&without, "index-basic-d");
    assert!(!told(&drawing.notes).contains("is drawn of that"), "{}", told(&drawing.notes));
    assert!(drawing.overview.is_some());
    // of a page whose overview has a sheet of its own
    let of_dots = page_of_dots();
    let edited = with_line(&of_dots.to_svg(), &rectangle("mine", &of_dots, [0.53, 0.02, 0.99, 0.33], 0.0, 1.5));
    let told = told(&render(&edited).notes);
    assert!(told.contains("the overview of this page has a sheet of its own, and is as it was"), "{told}");
}

fn page_of_dots() -> Page {
    page(&Options::new(Profile::named("index-basic-d").expect("it is built in")))
}

#[test]
fn clones_of_a_line_have_names_of_their_own() {
    let svg = page(&options()).to_svg();
    let clones = "<use id='use9' href='#line-1' x='9'/><use href='#line-1' y='9'/>\
                  <use id='b' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' inkscape:label='twin' \
                  href='#line-1' x='-9'/>";
    let read = reading(&with_line(&svg, clones));
    let ours = reading(&svg).names.lines.len();
    for name in ["line 1 (\"line-1\")", "line 1 (\"use9\")", "line \"twin\""] {
        assert!(read.names.lines.iter().any(|line| line == name), "{name}: {:?}", read.names.lines);
    }
    assert!(read.names.lines.iter().any(|line| line.starts_with("line 1 (copy ")), "{:?}", read.names.lines);
    assert_eq!((read.names.lines.len(), read.names.by_hand.len()), (ours + 3, 3));
}

#[test]
fn a_page_from_which_all_is_erased_is_told_so_and_no_more() {
    let with_text = PICTURE.replacen("</svg>", "<path d='M160 20H280' fill='none' stroke='#999'/></svg>", 1);
    let all: Crop = "0,0,100%,100%".parse().expect("a part");
    let corner: Crop = "0,0,2%,2%".parse().expect("a part");
    for options in [options().erase(all), options().keep(corner)] {
        let drawing = tactograph::convert(with_text.as_bytes(), &options).expect("a page");
        assert_eq!(drawing.notes, [Note::AllErased]);
        let grid = SheetGrid::new(2, 1).expect("a grid");
        let sheets = tactograph::convert_to_sheets(with_text.as_bytes(), Some(grid), &options).expect("sheets");
        assert_eq!(sheets.notes, [Note::AllErased]);
    }
}

#[test]
fn what_a_check_marked_is_no_part_of_the_page() {
    let page = page(&options());
    let crowded = with_line(&page.to_svg(), &rectangle("mine", &page, RED, 3.0, 1.5));
    for svg in [page.to_svg(), crowded] {
        let check = |svg: &str| -> Checked { tactograph::check(svg, &PageOptions::new()).expect("a page") };
        let checked = check(&svg);
        let marked = checked.marked(&svg).expect("a page");
        assert!(marked.contains("id=\"findings\""));
        let again = check(&marked);
        assert_eq!((again.to_string(), again.findings.len()), (checked.to_string(), checked.findings.len()));
        assert_eq!(again.marked(&marked).expect("a page"), marked, "marks take the place of the old ones");
        assert_eq!(reading(&marked).is_changed, reading(&svg).is_changed);
        assert_eq!(render(&marked).page.to_svg(), render(&svg).page.to_svg());
    }
}

#[test]
fn a_line_with_a_filter_that_is_missing_or_has_no_extent_is_there() {
    let page = page(&options());
    let place = page.figure.place;
    let (x, y) = (place.min.x + 0.6 * place.width(), place.min.y + 8.0);
    let ours = page.figure.lines.len();
    for attributes in [
        "filter='url(#gone)'",
        "style='fill:none;stroke:#000;filter:url(#gone)'",
        "clip-path='url(#gone)'",
        "mask='url(&quot;#gone&quot;)'",
        "marker-end='url(#gone)'",
        "filter='url(#soft)'",
        "mask='url(#dim)'",
    ] {
        let added = format!(
            "<defs><filter id='soft'><feGaussianBlur stdDeviation='1'/></filter>\
             <mask id='dim'><rect width='1' height='1'/></mask></defs>\
             <path id='mine' d='M{x} {y}h40' fill='none' stroke='#000' stroke-width='1.5' {attributes}/>"
        );
        let drawing = render(&with_line(&page.to_svg(), &added));
        assert_eq!(drawing.page.figure.lines.len(), ours + 1, "{attributes}");
        let is_told = told(&drawing.notes).contains("clip paths, masks and filters (1): what they cut off is there");
        assert_eq!(is_told, !attributes.starts_with("marker"), "{attributes}: {}", told(&drawing.notes));
    }
}

#[test]
fn braille_that_was_moved_is_told_where_it_is_placed_anew() {
    let label = "30%,50%,Box".parse::<String>().expect("a text");
    let labels = tactograph::Label::from_csv(&label).expect("a label");
    let svg = page(&options().labels(labels).title("Shapes")).to_svg();
    assert!(!told(&render_for(&svg, "swell-a3").notes).contains("was moved"));
    let begin = svg.find("aria-label=\"Box\"").expect("the label");
    let moved = [&svg[..begin], "transform=\"translate(4,3)\" ", &svg[begin..]].concat();
    for profile in ["swell-a3", "index-basic-d"] {
        let told = told(&render_for(&moved, profile).notes);
        assert!(told.contains("\"Box\" was moved on the page, and it has its place anew here"), "{profile}: {told}");
        assert!(!told.contains("the title"), "{profile}: {told}");
    }
    assert!(!told(&render(&moved).notes).contains("was moved"), "on its own paper it stays");
}

#[test]
fn areas_of_another_page_are_others_however_many_they_are() {
    let own = |x: u32| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><g fill='none' stroke='#000'>\
             <path d='M20 20H280'/></g><path d='M{x} 40H{}V180H{x}Z' fill='#06c'/></svg>",
            x + 40
        )
    };
    let page = page(&options()).to_svg();
    let areas = with(&page, "<rect x='90' y='60' width='20' height='30' fill='#06c'/>");
    let told = |options: Result<Options, Error>| {
        let drawing = tactograph::convert(PICTURE.as_bytes(), &options.expect("a page")).expect("a page");
        told(&drawing.notes)
    };
    let others = told(options().lines(own(160)).and_then(|options| options.areas(&areas)));
    assert!(others.contains("1 area that was drawn beside the lines given"), "{others}");
    let twice = told(options().lines(own(160)).and_then(|options| options.add_lines(own(160))));
    assert!(twice.contains("1 area that was drawn beside the lines given"), "{twice}");
}

#[test]
fn a_layer_that_a_person_made_has_the_signs_of_its_page() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("textures.palette.yellow", "rhombus 100").expect("a sign");
    let svg = page(&Options::new(profile)).to_svg();
    let begin = svg.find("data-class=\"red\"").expect("a red area");
    let start = svg[..begin].rfind('<').expect("it is an element");
    let end = start + svg[start..].find("/>").expect("it ends") + 2;
    let layer = format!("<g id='texture-yellow'>{}</g>", &svg[start..end]);
    let moved = with(&[&svg[..start], &svg[end..]].concat(), &layer);
    let textures = &reading(&moved).page.figure.textures;
    let yellow = textures.iter().find(|texture| texture.class == tactograph::Class::Yellow).expect("it is yellow");
    assert_eq!(yellow.sign.to_string(), "rhombus 100");
}

#[test]
fn lines_outside_of_the_figure_are_told_once_and_by_name() {
    let page = page(&options());
    let y = page.figure.place.max.y + 9.0;
    let added = format!("<path id='off' d='M60 {y}h40' fill='none' stroke='#000' stroke-width='1.5'/>");
    let told = told(&render_for(&with_line(&page.to_svg(), &added), "index-basic-d").notes);
    assert!(told.contains("40 mm of lines outside of the figure (line \"off\")"), "{told}");
    assert!(!told.contains("too short for this page"), "{told}");
}

#[test]
fn markers_of_an_editor_are_drawn_as_heads_of_arrows() {
    let page = page(&options());
    let begin = page.figure.place.min + (page.figure.place.max - page.figure.place.min) * 0.5;
    let added = format!(
        "<defs><marker id='Triangle' style='overflow:visible' refX='0' refY='0' orient='auto-start-reverse' \
         markerWidth='1' markerHeight='1'><path transform='scale(0.5)' style='fill:context-stroke' \
         d='m 5.77,0 -8.65,5 V -5 Z'/></marker></defs><path id='mine' d='M{} {}h-22' \
         style='fill:none;stroke:#000;stroke-width:1;marker-end:url(#Triangle)'/>",
        begin.x, begin.y
    );
    let arrows = |page: &Page| tactograph::internals::lines::arrows(&page.figure.lines).len();
    assert_eq!(arrows(&page), 0);
    let svg = with(&page.to_svg(), &added);
    assert_eq!(arrows(&render(&svg).page), 1, "{}", told(&render(&svg).notes));
    let dots = render_for(&svg, "index-basic-d");
    assert_eq!(arrows(&dots.page), 1, "{}", told(&dots.notes));
}

/// Editors keep the transform of a rectangle or an ellipse that was turned.
#[test]
fn a_line_with_a_transform_or_opacity_of_its_own_is_read_wherever_it_stands() {
    let page = page(&options());
    let at = page.figure.place.min;
    let added = format!(
        "<g transform='translate({} {})' style='fill:none;stroke:#000;stroke-width:1.5'><path id='a' d='M10 10h30'/>\
         <rect id='b' x='10' y='20' width='30' height='10' transform='rotate(5)'/>\
         <path id='c' d='M50 10h30' transform='translate(0 1)'/>\
         <ellipse id='d' cx='65' cy='30' rx='12' ry='8' transform='rotate(10 65 30)' opacity='0.6'/>\
         <path id='e' d='M50 45h30' opacity='0.8'/></g>",
        at.x, at.y
    );
    let read = |svg: &str| reading(svg).page.figure.lines.clone();
    let (before, after) = (read(&page.to_svg()), read(&with_line(&page.to_svg(), &added)));
    assert_eq!(after.len(), before.len() + 5);
    let ellipse = MmPoint::new(at.x + 65.0, at.y + 30.0);
    let is_around = |line: &&tactograph::marks::Line| {
        line.runs.iter().any(|run| run.closed && run.points.iter().all(|point| (*point - ellipse).length() < 12.5))
    };
    assert_eq!(after.iter().filter(is_around).count(), 1, "in its place");
}

#[test]
fn strokes_in_the_overview_of_a_page_of_dots_become_dots() {
    let options = Options::new(Profile::named("index-basic-d").expect("it is built in"));
    let page = tactograph::convert(PICTURE.as_bytes(), &options).expect("a page").page;
    let MmRect { min, .. } = page.figure.place;
    let lines = format!("<path d='M{} {}h40v20' fill='none' stroke='#000'/>", min.x + 10.0, min.y + 10.0);
    let overview = format!("<g id='overview' data-box='{} {} 60 60'>{lines}</g>", min.x, min.y);
    let drawing = render(&with(&page.to_svg(), &overview));
    let overview = drawing.page.overview.as_ref().expect("it has one");
    let runs: Vec<_> = overview.lines.iter().flat_map(|line| &line.runs).collect();
    assert!(overview.lines.len() == 1 && runs.iter().all(|run| run.points.len() >= 20), "{runs:?}");
    assert_eq!(drawing.page.figure.lines.len(), page.figure.lines.len());
    assert!(told(&drawing.notes).contains("1 line of the overview on a page of dots made dots"));
}

#[test]
fn a_dot_drawn_on_a_texture_gets_room() {
    for page in [page(&options()), page_of_dots()] {
        let texture = &page.figure.textures[0];
        let at = texture.glyphs[texture.glyphs.len() / 2].at;
        let dot = format!("<circle cx='{}' cy='{}' r='0.8'/>", at.x, at.y);
        let svg = with(&page.to_svg(), &dot);
        let checked = tactograph::check(&svg, &PageOptions::new()).expect("a page");
        assert_eq!(checked.errors(), 0, "{checked}");
        let told = checked.to_string();
        assert!(told.contains("warning texture-gap") && told.contains("a dot that was drawn"), "{told}");
        let drawing = render(&svg);
        assert!(self::told(&drawing.notes).contains("too near to a line or dot that was drawn"), "{:?}", drawing.notes);
        assert_eq!(found(&drawing.page.to_svg()), []);
        let dots = drawing.page.labels.iter().flat_map(|dots| &dots.at);
        assert!(dots.into_iter().any(|dot| (*dot - at).length() < 0.02), "the dot is there");
    }
}

#[test]
fn a_stroke_too_broad_for_the_sheet_is_told_with_its_place() {
    let svg = |width: &str| {
        let page = page(&options()).to_svg();
        with_line(&page, &format!("<path id='broad' d='M60 90H120' stroke='#000' stroke-width='{width}'/>"))
    };
    for width in ["400", "5000", "1e6"] {
        let svg = svg(width);
        let told = self::told(&reading(&svg).notes);
        assert!(told.contains("1 line (the first at 60, 90 mm) whose stroke is too broad for the sheet"), "{told}");
        let checked = tactograph::check(&svg, &PageOptions::new()).expect("a page").to_string();
        assert!(checked.contains("\"broad\"") && checked.contains("render leaves it out"), "{checked}");
    }
    let refused = read(svg("1e9").as_bytes()).expect_err("it cannot be computed with").to_string();
    assert!(refused.contains("stroke-width of \"broad\" has a place or size too large to compute with"), "{refused}");
    assert!(refused.contains("delete it there") && !refused.contains("PNG"), "{refused}");
}

#[test]
fn texts_that_flow_are_read() {
    let page = page(&options());
    let place = page.figure.place.min;
    let [x, y] = [place.x + 20.0, place.y + 30.0];
    let region = format!("<rect id='region' x='{x}' y='{y}' width='60' height='30'/>");
    let path = format!("<path d='m{x},{y} h60 v30 h-60 z'/>");
    let para = "<flowPara>hello</flowPara><flowPara>world</flowPara>";
    let flowing = [
        format!("<flowRoot><flowRegion>{region}</flowRegion>{para}</flowRoot>"),
        format!("<flowRoot><flowRegion>{path}</flowRegion>{para}</flowRoot>"),
        format!("<defs>{region}</defs><text style='shape-inside:url(#region)'>hello world</text>"),
    ];
    for text in flowing {
        let labels = with(&page.to_svg(), &format!("<g id='labels-text'>{text}</g>"));
        let read = reading(&labels);
        let typed: Vec<(&str, MmPoint)> = read.texts.iter().map(|text| (text.string.as_str(), text.at)).collect();
        let [(string, at)] = typed[..] else { panic!("{text}: {typed:?}") };
        assert_eq!(string, "hello world");
        assert!((at - MmPoint::new(x, y)).length() < 0.1, "{text}: {at:?}");
        let outside = told(&reading(&with(&page.to_svg(), &text)).notes);
        assert!(outside.contains("text \"hello world\" at"), "{outside}");
    }
}

#[test]
fn a_page_is_given_another_title_and_in_braille_where_it_is_laid_out_anew() {
    let svg = page(&options().title("One")).to_svg();
    let is_title = |text: &&tactograph::marks::BrailleText| text.role == TextRole::Title;
    let in_braille = |page: &Page| page.braille.iter().find(is_title).map(|text| text.text.clone());
    let renamed = |render: RenderOptions| tactograph::render(&svg, &render.title("Two")).expect("a page");
    let as_it_is = renamed(RenderOptions::new());
    assert_eq!(as_it_is.page.title, "Two");
    assert_eq!(in_braille(&as_it_is.page).as_deref(), Some("One"), "its cells stay");
    let stays = "the title in braille is as it was (One)";
    assert!(told(&as_it_is.notes).contains(stays), "{}", told(&as_it_is.notes));
    for name in ["swell-a4", "index-basic-d"] {
        let profile = Profile::named(name).expect("it is built in");
        let anew = renamed(RenderOptions::new().profile(profile));
        assert_eq!((anew.page.title.as_str(), in_braille(&anew.page).as_deref()), ("Two", Some("Two")), "{name}");
        assert!(!told(&anew.notes).contains(stays), "{name}: {}", told(&anew.notes));
    }
}
