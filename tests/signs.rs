//! Signs that mark places, as those of a scatter plot, and their legend.

use std::fmt::Write;

use tactograph::marks::Line;
use tactograph::{Drawing, Fonts, Options, Profile};

const PLACES: [(u32, u32); 8] =
    [(150, 300), (240, 370), (300, 210), (420, 290), (500, 180), (620, 260), (690, 110), (800, 230)];

/// The page of a drawing of 1000 by 500 with two axes.
fn page_of(drawn: &str) -> Drawing {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 500'><rect width='1000' height='500' fill='#fff'/>\
         <path d='M90 30V460H960' fill='none' stroke='#000' stroke-width='3'/>{drawn}</svg>"
    );
    let profile = Profile::named("swell-a4").expect("the default profile is there");
    tactograph::convert(svg.as_bytes(), &Options::new(profile).fonts(Fonts::system())).expect("a page")
}

/// How many discs and rings there are that stand for points.
fn points(page: &Drawing) -> [usize; 2] {
    let is_ring = |line: &&Line| matches!(&line.runs[..], [run] if run.closed && line.length() < 14.0);
    let (discs, rings): (Vec<&Line>, Vec<&Line>) =
        page.page.figure.lines.iter().filter(is_ring).partition(|line| line.length() < 6.0);
    [discs.len(), rings.len()]
}

fn told(page: &Drawing) -> String {
    page.notes.iter().map(|note| format!("{note}\n")).collect()
}

/// As markers of Matplotlib: they were left out as too small, all of them or those without room for an outline.
#[test]
fn triangles_squares_and_crosses_of_a_scatter_plot_are_discs_each_at_its_place() {
    let shapes = [
        ("a triangle", "<path id='m' d='M0 -8L-8 8H8Z' fill='#17b' stroke='#17b'/>"),
        ("a square", "<rect id='m' x='-7' y='-7' width='14' height='14' fill='#17b'/>"),
        ("a cross", "<path id='m' d='M-7 -7L7 7M-7 7L7 -7' fill='none' stroke='#17b' stroke-width='3'/>"),
    ];
    for (name, shape) in shapes {
        let all: String = PLACES.into_iter().map(|(x, y)| format!("<use href='#m' x='{x}' y='{y}'/>")).collect();
        let page = page_of(&format!("<defs>{shape}</defs>{all}"));
        assert_eq!(points(&page), [8, 0], "{name}: {}", told(&page));
    }
}

/// As of Matplotlib: both series may have one colour.
#[test]
fn the_samples_of_a_legend_are_no_points() {
    let disc = |(x, y): (u32, u32)| format!("<circle cx='{x}' cy='{y}' r='8' fill='#17b'/>");
    let mut drawn: String = PLACES.into_iter().map(disc).collect();
    drawn += "<path d='M680 340H840V450H680Z' fill='#fff' stroke='#ccc' stroke-width='2'/>";
    for (y, word) in [(370, "Boys"), (420, "Girls")] {
        write!(drawn, "{}<text x='740' y='{}' font-size='28'>{word}</text>", disc((710, y)), y + 9)
            .expect("it is a string");
    }
    let page = page_of(&drawn);
    assert_eq!(points(&page), [8, 0], "{}", told(&page));
    assert!(told(&page).contains("left out: the legend in the figure (\"Boys\", \"Girls\")"), "{}", told(&page));
    assert!(told(&page).contains("; say in the title or a label what the points stand for"), "{}", told(&page));
}

/// Without a frame, one sign of each kind is in line with the other.
#[test]
fn the_words_of_a_legend_are_told_with_what_their_signs_are_on_the_page() {
    let disc = |x: u32, y: u32| format!("<circle cx='{x}' cy='{y}' r='8' fill='#17b'/>");
    let cross = |x: u32, y: u32| {
        let (left, top, right, bottom) = (x - 7, y - 7, x + 7, y + 7);
        format!(
            "<path d='M{left} {top}L{right} {bottom}M{left} {bottom}L{right} {top}' stroke='#e70' stroke-width='3'/>"
        )
    };
    let mut drawn: String = PLACES.into_iter().map(|(x, y)| disc(x, y)).collect();
    drawn.extend([(190, 90), (330, 120), (560, 400), (640, 350), (870, 340)].map(|(x, y)| cross(x, y)));
    drawn += &(disc(110, 20) + "<text x='140' y='28' font-size='24'>Boys</text>");
    drawn += &(cross(300, 20) + "<text x='330' y='28' font-size='24'>Girls</text>");
    let page = page_of(&drawn);
    assert_eq!(points(&page), [8, 5], "{}", told(&page));
    let wanted = "8 (\"Boys\") are filled points on the page, and 5 (\"Girls\") are rings";
    assert!(told(&page).contains(wanted), "{}", told(&page));
    assert_eq!(told(&page).matches("say in the title or a label what").count(), 1, "{}", told(&page));
}
