//! Pages of few shapes, and textures that agree with outlines.

use tactograph::marks::Line;
use tactograph::{MmPoint, MmRect, Note, Options, Profile};

use crate::common::samples;

/// The page of a sample with at most so many shapes; 0 is no limit.
fn with(sample: &str, most: usize) -> tactograph::Drawing {
    let mut profile = Profile::named("swell-a4").expect("the default profile is there");
    profile.set("lines.shapes", most).expect("the key is there");
    tactograph::convert(&samples::read(sample)[..], &Options::new(profile)).expect("a page")
}

/// What the page says was left out: shapes, and other lines.
fn told(drawing: &tactograph::Drawing) -> Option<(usize, usize)> {
    drawing.notes.iter().find_map(|note| match note {
        Note::Simplified { shapes, lines, .. } => Some((*shapes, *lines)),
        _ => None,
    })
}

fn length(lines: &[Line]) -> f32 {
    lines.iter().map(|line| line.length()).sum()
}

#[test]
fn a_photograph_of_few_shapes_has_few_lines_and_says_so() {
    for sample in ["coffee.png", "astronaut.png"] {
        let [few, more, all] = [2, 5, 0].map(|most| with(sample, most));
        let lengths = [&few, &more, &all].map(|drawing| length(&drawing.page.figure.lines));
        assert!(lengths[0] < 0.8 * lengths[1] && lengths[1] < 0.95 * lengths[2], "{sample}: {lengths:?}");
        let (of_few, of_more) = (told(&few).expect("it is told"), told(&more).expect("it is told"));
        assert!(of_few.0 > of_more.0 && of_few.1 > of_more.1, "{sample}: {of_few:?} and {of_more:?}");
        assert_eq!(told(&all), None);
        assert!(all.notes.iter().all(|note| note.id() != "simplified"));
        // two outlines may be in several pieces where they meet others or the frame, two other lines are not
        assert!(few.page.figure.lines.len() <= 12, "{sample}: {}", few.page.figure.lines.len());
    }
}

/// A page of few shapes is not to have all contours: it does not say that they have no room.
#[test]
fn a_photograph_of_few_shapes_is_not_said_to_lack_contours_for_want_of_room() {
    let drawing = with("astronaut.png", 3);
    let checked = tactograph::check(drawing.page.to_svg(), &tactograph::PageOptions::new()).expect("it can be read");
    for notes in [&drawing.notes, &checked.notes] {
        assert!(notes.iter().all(|note| note.id() != "lines-left-out"), "{notes:?}");
    }
    let is_known = drawing.page.origin.iter().any(|(_, value)| value == "a photograph");
    assert!(is_known, "a photograph: {:?}", drawing.page.origin);
}

#[test]
fn the_overview_of_few_shapes_is_mostly_made_of_those_of_the_figure() {
    for sample in ["coffee.png", "astronaut.png", "chelsea.png"] {
        let page = with(sample, 3).page;
        let overview = page.overview.as_ref().expect("an overview");
        // the lines of the overview, laid on the figure
        let (from, to) = (overview.place, page.figure.place);
        let scale = to.width() / from.width();
        let laid = |at: &MmPoint| to.min + (*at - from.min) * scale;
        let of_figure: Vec<[MmPoint; 2]> = page
            .figure
            .lines
            .iter()
            .flat_map(|line| &line.runs)
            .flat_map(|run| run.points.windows(2).map(|pair| [pair[0], pair[1]]))
            .collect();
        let is_near = |at: &MmPoint| {
            of_figure.iter().any(|[a, b]| {
                let (along, from_a) = (*b - *a, *at - *a);
                let share = (from_a.dot(along) / along.square_length().max(1e-6)).clamp(0.0, 1.0);
                (from_a - along * share).length() < 6.0
            })
        };
        let of_overview: Vec<MmPoint> =
            overview.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points).map(laid).collect();
        assert!(!of_overview.is_empty());
        let near = of_overview.iter().filter(|at| is_near(at)).count();
        assert!(near as f32 >= 0.75 * of_overview.len() as f32, "{sample}: {near} of {}", of_overview.len());
    }
}

/// How many lines of one part of a page have less than half of them within `near` mm of those of another part.
fn lacking([lines, others]: [&[Line]; 2], [from, to]: [MmRect; 2], near: f32) -> usize {
    let (scale, others) = (to.width() / from.width(), places(others));
    let is_there = |at: &MmPoint| {
        let laid = to.min + (*at - from.min) * scale;
        others.iter().any(|other| (laid - *other).length() < near)
    };
    let is_lacking = |line: &&Line| {
        let own = places(std::slice::from_ref(*line));
        2 * own.iter().filter(|at| is_there(at)).count() < own.len()
    };
    lines.iter().filter(is_lacking).count()
}

/// Places along lines, at most a millimetre apart.
fn places(lines: &[Line]) -> Vec<MmPoint> {
    let mut places = Vec::new();
    for run in lines.iter().flat_map(|line| &line.runs) {
        let path: Vec<MmPoint> = run.path().collect();
        for pair in path.windows(2) {
            let steps = (pair[1] - pair[0]).length().ceil().max(1.0);
            places.extend((0..=steps as u32).map(|step| pair[0].lerp(pair[1], step as f32 / steps)));
        }
    }
    places
}

#[test]
fn the_overview_of_few_shapes_has_no_line_that_its_figure_lacks_and_what_it_lacks_is_told() {
    for (sample, most) in
        [("coffee.png", 1), ("coffee.png", 4), ("astronaut.png", 2), ("astronaut.png", 5), ("chelsea.png", 2)]
    {
        let drawing = with(sample, most);
        let (figure, overview) = (&drawing.page.figure, drawing.page.overview.as_ref().expect("an overview"));
        let only_in_overview = lacking([&overview.lines, &figure.lines], [overview.place, figure.place], 6.0);
        assert_eq!(only_in_overview, 0, "{sample}, {most}");
        let only_in_figure = lacking([&figure.lines, &overview.lines], [figure.place, overview.place], 5.5);
        let is_told = drawing.notes.iter().any(|note| note.to_string().contains("of the figure in the overview"));
        assert!(is_told || only_in_figure == 0, "{sample}, {most}: {only_in_figure} lines");
    }
    let is_told = |sample: &str, most: usize| {
        with(sample, most).notes.iter().any(|note| note.to_string().contains("of the figure in the overview"))
    };
    assert!(is_told("astronaut.png", 3) && !is_told("coffee.png", 1) && !is_told("astronaut.png", 0));
}

#[test]
fn a_place_names_the_same_thing_on_all_papers_and_devices() {
    for sample in ["chelsea.png", "coffee.png"] {
        let share = |profile: &str| {
            let half = || tactograph::Position::percent(50.0).expect("a number");
            let options = Options::new(Profile::named(profile).expect("it is built in")).subject(half(), half());
            let drawing = tactograph::convert(&samples::read(sample)[..], &options).expect("a page");
            let place = drawing.page.figure.place;
            let mm = drawing.notes.iter().find_map(|note| match note {
                Note::Subject { mm, is_first: true, .. } => Some(mm.map(|mm| mm as f32)),
                _ => None,
            });
            let [width, height] = mm.expect("something is there");
            [width / place.width(), height / place.height()]
        };
        let first = share("swell-a4");
        for profile in ["swell-letter", "index-basic-d", "graphiti"] {
            let other = share(profile);
            let far = [0, 1].map(|axis: usize| (other[axis] - first[axis]).abs());
            assert!(far.iter().all(|far| *far < 0.02), "{sample}, {profile}: {other:?} and {first:?}");
        }
    }
}

#[test]
fn of_a_drawing_what_hangs_together_is_drawn_whole_or_not_at_all() {
    // five countries that share borders are one shape; the capital is another
    let (one, all) = (with("map.svg", 1), with("map.svg", 0));
    assert_eq!(told(&one), Some((1, 0)));
    assert_eq!(all.page.figure.lines.len() - one.page.figure.lines.len(), 1);
    assert!(length(&one.page.figure.lines) > 0.9 * length(&all.page.figure.lines));
    let cell = with("cell.svg", 2);
    assert_eq!(told(&cell), Some((3, 0)));
}

#[test]
fn outlined_areas_are_said_to_have_several_textures_only_where_the_page_has() {
    for sample in ["astronaut.png", "chelsea.png", "coffee.png", "rocket.jpg", "map.svg"] {
        let made = with(sample, 0);
        let is_told = made.notes.iter().any(|note| matches!(note, Note::MixedAreas { count: 1.., .. }));
        let mut classes: Vec<_> = made.page.figure.textures.iter().map(|texture| texture.class).collect();
        classes.sort_unstable();
        classes.dedup();
        assert!(!is_told || sample != "map.svg" && classes.len() > 1, "{sample}: {classes:?}");
    }
}

#[test]
fn lines_that_a_person_added_are_not_beyond_the_few() {
    let of = |sample: &str, svg: Option<&str>| {
        let mut profile = Profile::named("swell-a4").expect("the default profile is there");
        profile.set("lines.shapes", "1").expect("the key is there");
        let options = Options::new(profile);
        let options = svg.map_or(Ok(options.clone()), |svg| options.add_lines(svg)).expect("they are lines");
        tactograph::convert(&samples::read(sample)[..], &options).expect("a page").page
    };
    let [map, coffee] = [("800' height='600", "M30,30h200M560,30h200M30,570h200"), ("600' height='400", "M30,370H230")]
        .map(|(size, path)| {
            format!(
                "<svg xmlns='http://www.w3.org/2000/svg' width='{size}'><g id='lines'><path d='{path}' fill='none' \
             stroke='#000' stroke-width='3'/></g></svg>"
            )
        });
    let count = |svg: Option<&str>| of("map.svg", svg).figure.lines.len();
    assert_eq!(count(Some(&map)), count(None) + 3);
    // a level line near the lower edge of a photograph
    let page = of("coffee.png", Some(&coffee));
    let at = page.figure.place.min.y + 370.0 / 400.0 * page.figure.place.height();
    let is_level = |line: &Line| {
        line.length() > 20.0 && line.runs.iter().flat_map(|run| &run.points).all(|point| (point.y - at).abs() < 1.0)
    };
    assert!(page.figure.lines.iter().any(is_level), "{} lines", page.figure.lines.len());
    // and so in the overview, where it is half as long
    let overview = page.overview.as_ref().expect("an overview");
    let at = overview.place.min.y + 370.0 / 400.0 * overview.place.height();
    let is_level = |line: &Line| {
        line.length() > 10.0 && line.runs.iter().flat_map(|run| &run.points).all(|point| (point.y - at).abs() < 1.0)
    };
    assert!(overview.lines.iter().any(is_level), "{} lines", overview.lines.len());
}
