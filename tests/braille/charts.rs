//! Charts and diagrams as teachers make them: numbers at their gridlines, bars of one series alike, legends in the key,
//! leader lines only where their words are.

use super::labels::{labels_of, options, place};
use super::worksheets::{drawn, notes, svg};
use std::fmt::Write as _;
use tactograph::marks::Line;
use tactograph::medium::Medium;
use tactograph::{Class, Drawing, KeySheets, MmPoint, MmRect, Profile, RenderOptions, convert};

const PROFILES: [&str; 4] = ["swell-a4", "index-basic-d", "viewplus-columbia", "pins-120x60"];
const SIZE: [f32; 2] = [720.0, 480.0];
/// Left and upper end of the axis, where it meets its base, and the right end of that.
const AXIS: [f32; 4] = [70.0, 70.0, 410.0, 690.0];

/// A chart of the axis up to `top` in steps, with a gridline at each; `below` is how far below its gridline a number
/// is written. `bars` are from, to, value and colour.
fn chart(top: f32, step: f32, below: f32, bars: &[(f32, f32, f32, &str)], more: &str) -> String {
    let [left, up, base, right] = AXIS;
    let y = |value: f32| base - (base - up) * value / top;
    let mut marks = String::new();
    let mut value = 0.0;
    while value <= top {
        let (at, text) = (y(value), y(value) + 6.0 + below);
        if value > 0.0 {
            write!(marks, "<path d='M{left} {at}H{right}' stroke='#ccc'/>").expect("text");
        }
        write!(marks, "<text x='{}' y='{text}' text-anchor='end'>{value}</text>", left - 10.0).expect("text");
        value += step;
    }
    for (from, to, value, colour) in bars {
        let (at, width, height) = (y(*value), to - from, base - y(*value));
        let stroke = "stroke='#000' stroke-width='2'";
        write!(marks, "<rect x='{from}' y='{at}' width='{width}' height='{height}' fill='{colour}' {stroke}/>")
            .expect("text");
    }
    let axis = format!("<path d='M{left} {up}V{base}H{right}' fill='none' stroke='#000' stroke-width='3'/>");
    svg(SIZE, &(marks + &axis + more))
}

fn on_page(figure: MmRect, x: f32, y: f32) -> MmPoint {
    figure.min + MmPoint::new(x / SIZE[0] * figure.width(), y / SIZE[1] * figure.height()).to_vector()
}

/// Heights of the level lines of a page near to this one, within 1.5 mm.
fn heights(lines: &[Line], y: f32) -> Vec<f32> {
    let pairs = lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.windows(2));
    let level = pairs.filter(|pair| (pair[0].y - pair[1].y).abs() < 0.01 && (pair[0].y - y).abs() < 1.5);
    level.map(|pair| pair[0].y).collect()
}

/// Numbers of an axis stand at their gridlines, also where print stands above or below them, where there are only two,
/// and where a word stands over the first. Those that do not are left out, and told.
#[test]
fn numbers_of_an_axis_stand_at_their_gridlines() {
    let bars = [(120.0, 190.0, 12.0, "#1f77b4"), (300.0, 370.0, 18.0, "#1f77b4"), (480.0, 550.0, 7.0, "#1f77b4")];
    let title = "<text x='20' y='46'>Books read</text>";
    let cases = [(5.0, 0.0, ""), (5.0, -9.0, ""), (5.0, 11.0, ""), (20.0, 0.0, ""), (10.0, 0.0, title)];
    for (step, below, more) in cases {
        let svg = chart(20.0, step, below, &bars, more);
        for profile in PROFILES {
            let drawing = drawn(&svg, profile);
            let (figure, of) = (drawing.page.figure.place, format!("step {step}, {below} below, {more} on {profile}"));
            let [_, up, base, _] = AXIS;
            let pitch = match &drawing.page.medium {
                Medium::Dots(dots) => dots.pitch,
                _ => 0.0,
            };
            let all = labels_of(&drawing);
            let numbers = all.iter().filter_map(|label| Some((label, label.text.parse::<f32>().ok()?)));
            let mut count = 0;
            for (label, value) in numbers {
                count += 1;
                let y = on_page(figure, 0.0, base - (base - up) * value / 20.0).y;
                let lines = heights(&drawing.page.figure.lines, y);
                let off = lines.into_iter().chain([y]).map(|y| (place(label).center().y - y).abs());
                let off = off.fold(f32::INFINITY, f32::min);
                assert!(off <= 1.3 + 0.5 * pitch, "{of}: {} is {off} mm off", label.text);
            }
            let wanted = (20.0 / step) as usize + 1;
            let is_told = || notes(&drawing).contains("left out, as there is");
            assert!(count == wanted || count > 1 && is_told(), "{of}: {count}\n{}", notes(&drawing));
            assert!(count == wanted || profile.starts_with("pins"), "{of}: {count}\n{}", notes(&drawing));
        }
    }
}

/// A gridline that bars interrupt is at one height in all its pieces.
#[test]
fn pieces_of_a_gridline_are_at_one_height() {
    let bars = [
        (110.0, 190.0, 14.4, "#2ca02c"),
        (250.0, 330.0, 18.0, "#2ca02c"),
        (390.0, 470.0, 9.3, "#2ca02c"),
        (530.0, 610.0, 5.6, "#2ca02c"),
    ];
    for (step, grey) in [(5.0, "#ccc"), (4.0, "#999"), (2.5, "#bbb")] {
        let drawing = drawn(&chart(20.0, step, 0.0, &bars, "").replace("#ccc", grey), "swell-a4");
        let [_, up, base, _] = AXIS;
        let mut value = step;
        while value <= 20.0 {
            let y = on_page(drawing.page.figure.place, 0.0, base - (base - up) * value / 20.0).y;
            let heights = heights(&drawing.page.figure.lines, y);
            let (low, high) = heights.iter().fold((f32::MAX, f32::MIN), |(low, high), &y| (low.min(y), high.max(y)));
            assert!(heights.is_empty() || high - low < 0.1, "{grey}: {value} from {low} to {high}");
            value += step;
        }
    }
}

/// Two series, each of a colour, with a legend in one line: the word of the first patch is beside the second too.
fn grouped(first: [f32; 4], second: [f32; 4], colours: [&str; 2]) -> String {
    let mut bars = Vec::new();
    for (number, (a, b)) in first.into_iter().zip(second).enumerate() {
        let from = 90.0 + 150.0 * number as f32;
        bars.push((from, from + 50.0, a, colours[0]));
        bars.push((from + 50.0, from + 100.0, b, colours[1]));
    }
    let entry = |(x, colour, word): (f32, &str, &str)| {
        format!(
            "<rect x='{x}' y='22' width='22' height='22' fill='{colour}' stroke='#000' stroke-width='2'/>\
             <text x='{}' y='40'>{word}</text>",
            x + 30.0
        )
    };
    let legend = [(420.0, colours[0], "Girls"), (535.0, colours[1], "Boys")].map(entry).concat();
    chart(16.0, 4.0, 0.0, &bars, &legend)
}

/// In how many of the bars of a series there are signs of its texture: every second from this one on.
fn textured(drawing: &Drawing, from: usize, heights: [f32; 4], class: Class) -> usize {
    let figure = &drawing.page.figure;
    let [_, up, base, _] = AXIS;
    let has_sign = |(number, value): (usize, f32)| {
        let left = 90.0 + 150.0 * number as f32 + 50.0 * from as f32;
        let bar = MmRect::new(
            on_page(figure.place, left, base - (base - up) * value / 16.0),
            on_page(figure.place, left + 50.0, base),
        );
        let own = figure.textures.iter().filter(|texture| texture.class == class);
        own.flat_map(|texture| &texture.glyphs).any(|glyph| bar.contains(glyph.at))
    };
    heights.into_iter().enumerate().filter(|of| has_sign(*of)).count()
}

/// Of a series all bars have its texture or none, and the key says what blank ones mean; the legend is in the key only.
#[test]
fn bars_of_a_series_are_alike_and_the_key_tells_of_blank_ones() {
    let cases = [
        ([12.0, 9.0, 14.0, 11.0], [10.0, 13.0, 3.0, 1.2], ["#d62728", "#f2c811"], [Class::Red, Class::Yellow]),
        ([4.0, 2.0, 1.0, 3.0], [15.0, 12.0, 10.0, 13.0], ["#1f77b4", "#2ca02c"], [Class::Blue, Class::Green]),
        ([12.0, 9.0, 14.0, 11.0], [10.0, 13.0, 8.0, 9.0], ["#1f77b4", "#ff7f0e"], [Class::Blue, Class::Yellow]),
    ];
    for (first, second, colours, classes) in cases {
        let svg = grouped(first, second, colours);
        for profile in ["swell-a4", "index-basic-d", "viewplus-columbia"] {
            let drawing = drawn(&svg, profile);
            let of = format!("{colours:?} on {profile}:\n{}", notes(&drawing));
            let key: Vec<&str> =
                drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
            let blank = key.iter().find(|text| text.starts_with("blank: ")).copied().unwrap_or_default();
            let mut blanks = 0;
            for (number, (heights, word)) in [(first, "Girls"), (second, "Boys")].into_iter().enumerate() {
                let count = textured(&drawing, number, heights, classes[number]);
                let colour = format!("{}: {word}", classes[number].name());
                assert_eq!(count > 0, key.contains(&colour.as_str()), "{key:?} {of}");
                assert_eq!(count < 4, blank.contains(word), "{count} {key:?} {of}");
                blanks += usize::from(count == 0);
                // of one series only where the other has no blank ones either
                assert!(count == 0 || count == 4 || blank == "blank: Girls, Boys", "{count} {key:?} {of}");
            }
            assert!(blank.is_empty() != notes(&drawing).contains("bars of the chart, "), "{key:?} {of}");
            assert!(blanks < 2 || notes(&drawing).contains("all 4"), "{of}");
            assert!(!labels_of(&drawing).iter().any(|label| ["Girls", "Boys"].contains(&label.text.as_str())), "{of}");
            assert!(notes(&drawing).contains("the legend in the figure (\"Girls\", \"Boys\")"), "{of}");
            // there are no patches
            let legend = MmRect::new(
                on_page(drawing.page.figure.place, 412.0, 0.0),
                on_page(drawing.page.figure.place, 590.0, 50.0),
            );
            let lines = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
            assert_eq!(lines.filter(|at| legend.contains(**at)).count(), 0, "{of}");
        }
    }
}

/// A frame around a legend goes with it: nothing is left in it. One with something else in it stays.
#[test]
fn the_frame_of_a_legend_goes_with_it() {
    let chart = grouped([12.0, 9.0, 14.0, 11.0], [10.0, 13.0, 8.0, 9.0], ["#1f77b4", "#ff7f0e"]);
    let frame = "<rect x='404' y='10' width='216' height='44' rx='4' fill='#fff' stroke='#888' stroke-width='2'/>";
    let cross = "<path d='M505 26L525 40M525 26L505 40' stroke='#000' stroke-width='2'/>";
    let lines = |more: &str, profile: &str| {
        let svg = chart.replacen("<rect x='420'", &format!("{more}<rect x='420'"), 1);
        let drawing = drawn(&svg, profile);
        assert!(notes(&drawing).contains("the legend in the figure (\"Girls\", \"Boys\")"), "{}", notes(&drawing));
        let place = drawing.page.figure.place;
        let legend = MmRect::new(on_page(place, 396.0, 0.0), on_page(place, 630.0, 58.0));
        let points = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        (points.filter(|at| legend.contains(**at)).count(), notes(&drawing))
    };
    for profile in ["swell-a4", "index-basic-d"] {
        let (points, told) = lines(frame, profile);
        assert_eq!(points, 0, "{profile}: {told}");
        assert!(!told.contains("small shape"), "{profile}: {told}");
    }
    assert!(lines(&[frame, cross].concat(), "swell-a4").0 > 4, "a cross is no part of a legend");
}

/// Three curves whose first points lie on the axis, each beside a number: these are no words of a legend.
#[test]
fn numbers_beside_the_first_points_of_curves_are_no_legend() {
    let [left, _, base, _] = AXIS;
    let mut curves = String::new();
    for (number, (colour, rise)) in [("#1f77b4", -30.0), ("#d62728", 20.0), ("#2ca02c", -12.0)].into_iter().enumerate()
    {
        let y = base - 80.0 * (number as f32 + 1.0);
        let points: Vec<String> =
            (0..5).map(|i| format!("{} {}", left + 140.0 * i as f32, y + rise * i as f32)).collect();
        write!(curves, "<path d='M{}' fill='none' stroke='{colour}' stroke-width='3'/>", points.join("L"))
            .expect("text");
        for point in &points {
            let (x, y) = point.split_once(' ').expect("two numbers");
            write!(curves, "<circle cx='{x}' cy='{y}' r='5' fill='{colour}'/>").expect("text");
        }
        let value = 20 * (number + 1);
        write!(curves, "<text x='{}' y='{}' text-anchor='end'>{value}</text>", left - 14.0, y + 5.0).expect("text");
    }
    let axes = "<path d='M70 70V410H690' fill='none' stroke='#000' stroke-width='2'/>";
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = drawn(&svg(SIZE, &format!("{axes}{curves}")), profile);
        assert!(!notes(&drawing).contains("the legend in the figure"), "{profile}: {}", notes(&drawing));
        let labels = labels_of(&drawing);
        for number in ["20", "40", "60"] {
            assert!(labels.iter().any(|label| label.text == number), "{number} on {profile}: {labels:?}");
        }
    }
}

/// The words of a legend of lines stand at their curves, and its samples with their frame are left out.
#[test]
fn the_words_of_a_legend_of_lines_stand_at_their_curves() {
    let lines = |frame: &str, profile: &str| {
        let curve = |colour: &str, points: &str| {
            format!("<path d='M{points}' fill='none' stroke='{colour}' stroke-width='4'/>")
        };
        let sample = |y: u32, colour: &str, word: &str| {
            let text = format!("<text x='382' y='{}'>{word}</text>", y + 6);
            curve(colour, &format!("342 {y}H372")) + &text
        };
        let marks = [
            "<path d='M70 70V410H690' fill='none' stroke='#000' stroke-width='2'/>",
            &curve("#1f77b4", "80 380L230 300L380 330L530 180L670 130"),
            &curve("#d62728", "80 130L230 230L380 190L530 290L670 370"),
            frame,
            &sample(94, "#1f77b4", "London"),
            &sample(120, "#d62728", "Moscow"),
        ];
        drawn(&svg(SIZE, &marks.concat()), profile)
    };
    let frame = "<rect x='330' y='80' width='140' height='54' rx='4' fill='#fff' stroke='#888' stroke-width='2'/>";
    for (frame, profile) in [(frame, "swell-a4"), ("", "swell-a4"), (frame, "index-basic-d")] {
        let drawing = lines(frame, profile);
        let (figure, told) = (drawing.page.figure.place, notes(&drawing));
        assert!(told.contains("the legend of lines in the figure (\"London\", \"Moscow\")"), "{profile}: {told}");
        assert!(!told.contains("fingers feel no colour of a line"), "{profile}: {told}");
        let legend = MmRect::new(on_page(figure, 326.0, 76.0), on_page(figure, 474.0, 138.0));
        let points = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        assert_eq!(points.filter(|at| legend.contains(**at)).count(), 0, "{profile}: {told}");
        // from the nearer end of a curve
        let off = |word: &str, ends: [[f32; 2]; 2]| {
            let labels = labels_of(&drawing);
            let label = labels.into_iter().find(|label| label.text == word);
            let place = place(label.unwrap_or_else(|| panic!("{word} on {profile}: {told}")));
            let off = |[x, y]: [f32; 2]| on_page(figure, x, y) - on_page(figure, x, y).clamp(place.min, place.max);
            ends.map(|end| off(end).length()).into_iter().fold(f32::MAX, f32::min)
        };
        let (london, moscow) = ([[80.0, 380.0], [670.0, 130.0]], [[80.0, 130.0], [670.0, 370.0]]);
        for (word, own, other) in [("London", london, moscow), ("Moscow", moscow, london)] {
            assert!(off(word, own) < off(word, other), "{word} on {profile}: {told}");
        }
    }
}

/// A colour of the legend that has no texture in the figure is blank there, and the key says what that means.
#[test]
fn the_key_names_other_areas_of_the_legend_as_blank() {
    let entry = |y: u32, colour: &str, word: &str| {
        format!(
            "<rect x='600' y='{y}' width='22' height='22' fill='{colour}'/><text x='632' y='{}'>{word}</text>",
            y + 18
        )
    };
    // a road with no room for signs
    let areas = "<circle cx='200' cy='250' r='150' fill='#d62728'/>\
        <path d='M420 100H432L560 420H548Z' fill='#1f77b4'/>";
    let legend = entry(60, "#d62728", "Park") + &entry(100, "#1f77b4", "Road");
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = drawn(&svg(SIZE, &format!("{areas}{legend}")), profile);
        let told = notes(&drawing);
        let classes: Vec<Class> = drawing.page.figure.textures.iter().map(|texture| texture.class).collect();
        assert!(classes.contains(&Class::Red) && !classes.contains(&Class::Blue), "{profile}: {classes:?} {told}");
        let key: Vec<&str> = drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
        assert!(key.contains(&"red: Park") && key.contains(&"blank: Road"), "{profile}: {key:?} {told}");
        assert!(told.contains("what the colours of the legend mean (\"Road\"), as no texture"), "{profile}: {told}");
    }
}

/// A chart without a legend, of bars that are too narrow for a texture on an embosser of large dots.
fn without_legend() -> String {
    let bars: String = [(115, 126), (207, 288), (299, 198), (391, 72), (483, 230)]
        .into_iter()
        .map(|(x, height)| {
            let (y, colour) = (420 - height, if x == 483 { "#cc3333" } else { "#3366cc" });
            format!("<rect x='{x}' y='{y}' width='56' height='{height}' fill='{colour}'/>")
        })
        .collect();
    let words: String = [(143, "Mon"), (235, "Tue"), (327, "Wed"), (419, "Thu"), (511, "Fri")]
        .into_iter()
        .map(|(x, day)| format!("<text x='{x}' y='445' text-anchor='middle' font-size='16'>{day}</text>"))
        .collect();
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='620' height='470' font-family='sans-serif'>\
         <rect width='620' height='470' fill='#fff'/>{bars}{words}\
         <path d='M90 50V420H580' fill='none' stroke='#000' stroke-width='2.5'/></svg>"
    )
}

/// What stands on the sheets of a key.
fn key_of(drawing: &Drawing) -> Vec<&str> {
    drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect()
}

fn has_texture(drawing: &Drawing, class: Class) -> bool {
    drawing.page.figure.textures.iter().any(|texture| texture.class == class)
}

/// Bars that are too narrow for a texture, of a chart without a legend: the key names their colour as blank, and not
/// only that of the one bar that has a texture; also where the texts of the drawing are no labels.
#[test]
fn the_key_names_blank_bars_by_their_colour() {
    let svg = without_legend();
    for (profile, is_bare) in [("swell-a4", false), ("braillerap", true)] {
        for texts in [true, false] {
            let options = options(profile).label_texts(texts).key(KeySheets::Always);
            let drawing = convert(svg.as_bytes(), &options).expect("a page");
            let (key, told) = (key_of(&drawing), notes(&drawing));
            assert_eq!(has_texture(&drawing, Class::Blue), !is_bare, "{profile}: {told}");
            // both are named, each as it is on the page
            for (class, name) in [(Class::Blue, "blue"), (Class::Red, "red")] {
                let is_blank = key.iter().any(|text| text.starts_with("blank: ") && text.contains(name));
                let has_texture = has_texture(&drawing, class);
                assert_eq!(has_texture, key.contains(&name), "{profile}, {texts}: {key:?} {told}");
                assert_eq!(has_texture, !is_blank, "{profile}, {texts}: {key:?} {told}");
            }
        }
    }
}

/// A remark on blank bars speaks of a key that names them only where there is one.
#[test]
fn a_remark_on_blank_bars_promises_no_key() {
    let svg = without_legend();
    for key in KeySheets::ALL {
        for texts in [true, false] {
            let drawing = convert(svg.as_bytes(), &options("braillerap").label_texts(texts).key(key)).expect("a page");
            let (told, of) = (notes(&drawing), format!("{}, {texts}", key.name()));
            let is_in_key = key_of(&drawing).iter().any(|text| text.starts_with("blank: "));
            assert_eq!(is_in_key, key == KeySheets::Always, "{of}");
            assert!(told.contains("the textures of bars of the chart, all 4 blue bars"), "{of}: {told}");
            assert_eq!(told.contains("; the key names "), is_in_key, "{of}: {told}");
        }
    }
}

/// On a page that is laid out anew blank bars keep their place in the key, by their colour and not as what it means.
#[test]
fn a_key_that_is_made_anew_names_blank_bars_by_their_colour() {
    let options = options("braillerap").label_texts(true).key(KeySheets::Always);
    let svg = without_legend();
    let page = convert(svg.as_bytes(), &options).expect("a page").page;
    let origin = |page: &tactograph::Page| -> Vec<String> {
        page.origin.iter().filter(|(name, _)| name == "blank in the key").map(|(_, value)| value.clone()).collect()
    };
    assert_eq!(origin(&page), ["blue", "red"], "without a meaning");
    // nor is the word of a language one
    let german = convert(svg.as_bytes(), &options.language("de")).expect("a page");
    assert!(key_of(&german).contains(&"leer: blau, rot"), "{:?}", key_of(&german));
    assert_eq!(origin(&german.page), ["blue", "red"]);
    for profile in ["swell-a4", "index-basic-d"] {
        let profile = Profile::named(profile).expect("it is built in");
        let anew = tactograph::render(page.to_svg(), &RenderOptions::new().profile(profile)).expect("a page");
        let key = key_of(&anew);
        assert!(key.contains(&"blank: blue, red") && !key.iter().any(|text| text.contains("blue: ")), "{key:?}");
        assert_eq!(origin(&anew.page), ["blue", "red"]);
    }
}

/// A cell with leader lines from words, and a cloud whose outline is scalloped as small letters are.
fn diagram() -> String {
    let mut marks = "<ellipse cx='330' cy='250' rx='170' ry='120' fill='#cde' stroke='#000' stroke-width='3'/>\
        <circle cx='300' cy='260' r='45' fill='#a36' stroke='#000' stroke-width='3'/>"
        .to_owned();
    let words = [("Wall", (560.0, 120.0), (452.0, 166.0)), ("Nucleus", (560.0, 400.0), (340.0, 280.0))];
    for (word, (x, y), (to_x, to_y)) in words {
        write!(
            marks,
            "<text x='{x}' y='{y}'>{word}</text><path d='M{} {}L{to_x} {to_y}' stroke='#000' stroke-width='2'/>",
            x - 6.0,
            y - 6.0
        )
        .expect("text");
    }
    let scallops: String = (0..12).map(|_| "q4 -9 8 0").collect();
    svg(SIZE, &format!("{marks}<path d='M60 60{scallops}v60h-96z' fill='#fff' stroke='#000' stroke-width='2'/>"))
}

/// Leader lines are in the figure, where their words are, and not in the overview; it is told.
#[test]
fn an_overview_has_no_leader_lines() {
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = drawn(&diagram(), profile);
        let overview = drawing.page.overview.as_ref().map(|overview| (overview.place, &overview.lines));
        let apart = drawing.overview.as_ref().map(|page| (page.figure.place, &page.figure.lines));
        let (place, lines) = overview.or(apart).expect("it has one");
        let beyond = place.min.x + 510.0 / SIZE[0] * place.width();
        let points = lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        assert_eq!(points.filter(|at| at.x > beyond).count(), 0, "{profile}");
        assert!(notes(&drawing).contains("of words in the figure only, as"), "{}", notes(&drawing));
        let beside = on_page(drawing.page.figure.place, 510.0, 0.0).x;
        let points = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        assert!(points.filter(|at| at.x > beside).count() > 0, "{profile}: the figure has them");
    }
}

/// A piece of an outline that looks like a row of small letters is no text.
#[test]
fn a_piece_of_an_outline_is_no_text() {
    for profile in PROFILES {
        let told = notes(&drawn(&diagram(), profile));
        assert!(!told.contains("letters"), "{profile}: {told}");
    }
}
