//! Pages of few shapes, and textures that agree with outlines.

use tactograph::{MmPoint, Note, Options, Profile};

use crate::common::samples;

/// The page of a sample with at most so many shapes; 0 is no limit.
fn with(sample: &str, most: usize) -> tactograph::Drawing {
    let mut profile = Profile::named("swell-a4").expect("the default profile is there");
    profile.set("lines.shapes", &most.to_string()).expect("the key is there");
    tactograph::convert(&samples::read(sample)[..], &Options::new(profile)).expect("a page")
}

/// What the page says was left out: shapes, and other lines.
fn told(drawing: &tactograph::Drawing) -> Option<(usize, usize)> {
    drawing.notes.iter().find_map(|note| match note {
        Note::Simplified { shapes, lines, .. } => Some((*shapes, *lines)),
        _ => None,
    })
}

fn length(lines: &[tactograph::marks::Line]) -> f32 {
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
fn areas_that_no_colour_holds_are_told() {
    let told =
        |sample: &str| with(sample, 0).notes.iter().any(|note| matches!(note, Note::MixedAreas { count: 1.., .. }));
    let samples = ["astronaut.png", "chelsea.png", "coffee.png", "rocket.jpg"];
    assert!(samples.iter().any(|sample| told(sample)), "some photograph has an area of two colours");
    assert!(!told("map.svg"), "a drawing has no such areas");
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
    let is_level = |line: &tactograph::marks::Line| {
        line.length() > 20.0 && line.runs.iter().flat_map(|run| &run.points).all(|point| (point.y - at).abs() < 1.0)
    };
    assert!(page.figure.lines.iter().any(is_level), "{} lines", page.figure.lines.len());
}
