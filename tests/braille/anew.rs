//! Words of pages that are laid out anew or were edited: labels with the lines that lead to them, typed words beside
//! what is there, arrows beside words, and treads of stairs.

use super::labels::{labels_of, options, place};
use tactograph::internals::geom::{nearest_on_segment, segment_distance};
use tactograph::internals::units::MmVector;
use tactograph::{Drawing, MmPoint, MmRect, Page, Profile, RenderOptions, convert};

/// A flower and a box, each with a word and a line that leads to it, and a word in the box.
const LED: &str = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 800'><g font-size='22'>\
    <rect width='600' height='800' fill='#fff'/><g fill='none' stroke='#000' stroke-width='4'>\
    <circle cx='300' cy='170' r='55'/><rect x='40' y='560' width='520' height='200'/>\
    <path d='M435 118L347 150M110 325L180 558' stroke-width='2'/></g>\
    <text x='440' y='120'>flower</text><text x='60' y='320'>ground</text><text x='270' y='680'>soil</text></g></svg>";

fn page_with_words(svg: &str, profile: &str) -> Drawing {
    convert(svg.as_bytes(), &options(profile).label_texts(true)).expect("a page")
}

fn laid_anew(page: &Page, profile: &str) -> Drawing {
    let profile = Profile::named(profile).expect("it is built in");
    tactograph::render(page.to_svg(), &RenderOptions::new().profile(profile)).expect("a page")
}

fn told(drawing: &Drawing) -> String {
    drawing.notes.iter().map(|note| format!("{note}\n")).collect()
}

fn to_box(at: MmPoint, place: MmRect) -> f32 {
    (at - at.clamp(place.min, place.max)).length()
}

/// How far a label lies from the nearest line of the figure, and the middle of it in shares of the figure.
fn of_label(drawing: &Drawing, text: &str) -> (f32, [f32; 2]) {
    let label = labels_of(drawing).into_iter().find(|label| label.text == text).expect("it is there");
    let (own, figure) = (place(label), drawing.page.figure.place);
    let runs = drawing.page.figure.lines.iter().flat_map(|line| &line.runs);
    let sides = runs.flat_map(|run| run.path().zip(run.path().skip(1)));
    let points = sides.flat_map(|(a, b)| (0..=100).map(move |step| a.lerp(b, 0.01 * step as f32)));
    let nearest = points.map(|at| to_box(at, own)).fold(f32::INFINITY, f32::min);
    let middle = own.center() - figure.min;
    (nearest, [middle.x / figure.width(), middle.y / figure.height()])
}

#[test]
fn labels_stay_at_the_lines_that_lead_to_them_on_another_device() {
    let page = page_with_words(LED, "swell-a4").page;
    for profile in ["index-basic-d", "viewplus-columbia", "swell-a3"] {
        let anew = laid_anew(&page, profile);
        for text in ["flower", "ground"] {
            let (nearest, _) = of_label(&anew, text);
            assert!(nearest < 12.0, "{profile}: \"{text}\" is {nearest} mm from any line");
        }
        let told = told(&anew);
        assert!(!told.contains("not on the page") && !told.contains("no room"), "{profile}: {told}");
    }
}

#[test]
fn a_label_stays_where_it_stood_on_another_device() {
    let before = page_with_words(LED, "swell-a4");
    let (_, at) = of_label(&before, "soil");
    for profile in ["index-basic-d", "viewplus-columbia"] {
        let (_, anew) = of_label(&laid_anew(&before.page, profile), "soil");
        let off = (anew[0] - at[0]).hypot(anew[1] - at[1]);
        assert!(off < 0.05, "{profile}: {at:?} became {anew:?}");
    }
}

/// A circle as large as this, with a word on each of its four sides.
fn among_words(radius: u32) -> String {
    let (above, below, left, right) = (286 - radius, 330 + radius, 240 - radius, 314 + radius);
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 800'><g font-size='22'>\
         <rect width='600' height='800' fill='#fff'/><g fill='none' stroke='#000' stroke-width='4'>\
         <circle cx='300' cy='300' r='{radius}'/><path d='M20 780H580M20 20H580'/></g>\
         <text x='275' y='{above}'>north</text><text x='275' y='{below}'>south</text>\
         <text x='{left}' y='308'>west</text><text x='{right}' y='308'>east</text></g></svg>"
    )
}

#[test]
fn the_leader_line_of_a_typed_word_keeps_clear_of_braille_and_of_other_leader_lines() {
    let typed = |drawing: &Drawing, word: &str, at: MmPoint| {
        let typed = format!("<g id='labels-text'><text x='{}' y='{}'>{word}</text></g>", at.x, at.y);
        let svg = drawing.page.to_svg().replacen("</svg>", &format!("{typed}</svg>"), 1);
        tactograph::render(svg, &RenderOptions::new()).expect("a page")
    };
    let leader_of = |drawing: &Drawing, word: &str| {
        let label = labels_of(drawing).into_iter().find(|label| label.text == word)?;
        let points = &label.leader.as_ref()?.points;
        Some((points[0], points[points.len() - 1]))
    };
    let mut seen = 0;
    for radius in [14, 28, 36, 44, 60] {
        let page = page_with_words(&among_words(radius), "swell-a4");
        let figure = page.page.figure.place;
        let middle = figure.min + MmVector::new(0.5, 0.375).component_mul(figure.size().to_vector());
        let first = typed(&page, "seed", middle);
        let second = typed(&first, "root", middle + MmVector::new(2.0, -2.0));
        for (drawing, word) in [(&first, "seed"), (&second, "root")] {
            let Some((from, to)) = leader_of(drawing, word) else { continue };
            seen += 1;
            for other in labels_of(drawing).into_iter().filter(|other| other.text != word) {
                let dots = other.dots.at.iter().map(|at| nearest_on_segment(*at, from, to).0);
                let near = dots.fold(f32::INFINITY, f32::min);
                assert!(near >= 3.0, "{radius}: the line of \"{word}\" is {near} mm from \"{}\"", other.text);
                if let Some(other) = leader_of(drawing, &other.text) {
                    let near = segment_distance((from, to), other);
                    assert!(near >= 3.0, "{radius}: the line of \"{word}\" is {near} mm from another");
                }
            }
        }
    }
    assert!(seen > 1, "words have no leader lines");
}

/// A word at either end of an arrow is no name at a leader line.
#[test]
fn an_arrow_beside_a_word_is_drawn_with_its_head() {
    let arrow = |head: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 500'><g font-size='22'>\
             <rect width='600' height='500' fill='#fff'/><path d='M60 60H540V440H60ZM60 190H540' fill='none' stroke='#000' \
             stroke-width='5'/><path d='M300 330V200' stroke='#000' stroke-width='3'/>{head}\
             <text x='290' y='360'>up</text></g></svg>"
        )
    };
    for head in [
        "<path d='M300 194l-10 24h20z'/>",
        "<path d='M290 218L300 196L310 218' fill='none' stroke='#000' stroke-width='3'/>",
    ] {
        for profile in ["swell-a4", "index-basic-d"] {
            let drawing = page_with_words(&arrow(head), profile);
            let arrows = tactograph::internals::lines::arrows(&drawing.page.figure.lines);
            assert_eq!(arrows.len(), 1, "{profile}: {}", told(&drawing));
            assert!(!told(&drawing).contains("leader line"), "{profile}: {}", told(&drawing));
        }
    }
    // the same line without a head leads to the wall
    assert!(told(&page_with_words(&arrow(""), "swell-a4")).contains("1 leader line of words"));
}

/// A circle in which its name has no room, drawn as two rows of dots.
#[test]
fn the_name_of_a_small_shape_of_heavy_lines_stands_beside_it() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 500'><g font-size='22'>\
        <rect width='800' height='500' fill='#fff'/>\
        <circle cx='200' cy='170' r='40' fill='#ffd000' stroke='#000' stroke-width='3'/>\
        <text x='182' y='178'>sun</text>\
        <path d='M30 300L200 350L330 420L500 340L770 300V490H30Z' fill='none' stroke='#000' stroke-width='4'/></g></svg>";
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = page_with_words(svg, profile);
        assert!(labels_of(&drawing).iter().any(|label| label.text == "sun"), "{profile}: {}", told(&drawing));
    }
}

#[test]
fn the_name_of_a_river_stands_at_the_middle_of_its_text() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 500'><g font-size='22'>\
        <rect width='800' height='500' fill='#fff'/><path d='M30 60H770' stroke='#000' stroke-width='4'/>\
        <path d='M200 480L600 120' stroke='#2060c0' stroke-width='5'/>\
        <text x='220' y='440' transform='rotate(-42 220 440)'>The Long River of the North</text></g></svg>";
    let drawing = page_with_words(svg, "swell-a4");
    let [label] = labels_of(&drawing)[..] else { panic!("{}", told(&drawing)) };
    // the text is about 290 px long
    let figure = drawing.page.figure.place;
    let middle = figure.min + MmVector::new(328.0, 343.0) * (figure.width() / 800.0);
    let tip = label.leader.as_ref().and_then(|leader| leader.points.last());
    let off = tip.map_or_else(|| to_box(middle, place(label)), |tip| (*tip - middle).length());
    assert!(off < 10.0, "it names a place {off} mm off");
}

#[test]
fn treads_of_stairs_are_no_gridlines() {
    let treads: String = (0..9).map(|step| format!("<path d='M500 {0}H620'/>", 290 + 20 * step)).collect();
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 500'><rect width='800' height='500' fill='#fff'/>\
         <path d='M20 20H780V480H20ZM20 250H300M380 250H780M400 20V170' fill='none' stroke='#000' stroke-width='7'/>\
         <g stroke='#000' stroke-width='1.5'><path d='M500 270V470M620 270V470'/>{treads}</g></svg>"
    );
    let drawing = page_with_words(&svg, "swell-a4");
    assert!(!told(&drawing).contains("gridlines"), "{}", told(&drawing));
}

/// Two of one text, of which only one has room for it.
#[test]
fn labels_of_one_text_are_all_abbreviated_or_none_is() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 500'><rect width='800' height='500' fill='#fff'/>\
        <g fill='none' stroke='#000' stroke-width='4'><path d='M20 20H780V480H20ZM130 20V480M20 250H130'/></g></svg>";
    let list = "x,y,text\n9%,25%,Chloroplast\n9%,75%,Mitochondrion\n60%,50%,Chloroplast\n";
    let labels = tactograph::Label::from_csv(list).expect("a list");
    let drawing = convert(svg.as_bytes(), &options("swell-a4").labels(labels)).expect("a page");
    let of = |text: &str| -> Vec<bool> {
        let all = labels_of(&drawing).into_iter().filter(|label| label.text == text);
        all.map(|label| label.abbreviation.is_some()).collect()
    };
    assert_eq!((of("Chloroplast"), of("Mitochondrion")), (vec![true, true], vec![true]), "{}", told(&drawing));
}
