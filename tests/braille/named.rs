//! Words of worksheets stand at what they name: stops of a map, cells of a table, sectors of a pie.

use super::labels::{labels_of, place};
use super::worksheets::{MAP, PIE, PROFILES, STOPS, drawn, map, notes, pie, svg};
use std::fmt::Write as _;
use tactograph::internals::geom::nearest_on_segment;
use tactograph::marks::{BrailleText, TextRole};
use tactograph::{Drawing, MmPoint, MmRect};

/// Where a place of the drawing lies on the sheet.
fn at(drawing: &Drawing, [width, height]: [f32; 2], (x, y): (f32, f32)) -> MmPoint {
    let figure = drawing.page.figure.place;
    figure.min + figure.size().to_vector().component_mul(MmPoint::new(x / width, y / height).to_vector())
}

/// A name stands nearer to its own stop than to any other, or has a leader line that ends at its own.
#[test]
fn names_of_a_map_stand_at_their_own_stops() {
    let map = map(["#d22", "#22c", "#191"]);
    for profile in PROFILES {
        let drawing = drawn(&map, profile);
        let labels = labels_of(&drawing);
        assert_eq!(labels.len(), STOPS.len(), "{profile}: {}", notes(&drawing));
        let stops: Vec<MmPoint> = STOPS.iter().map(|(_, stop, _)| at(&drawing, MAP, *stop)).collect();
        for label in labels {
            let own = STOPS.iter().position(|(name, ..)| *name == label.text).expect("a stop");
            let box_of = place(label);
            let far = |stop: &MmPoint| match &label.leader {
                None => (*stop - stop.clamp(box_of.min, box_of.max)).length(),
                Some(leader) => {
                    let ends = [leader.points.first(), leader.points.last()];
                    let to_end = |end: &MmPoint| (*stop - *end).length();
                    ends.into_iter().flatten().map(to_end).fold(f32::INFINITY, f32::min)
                }
            };
            // points are moved a little where lines become dots
            let nearest = stops.iter().map(far).fold(f32::INFINITY, f32::min);
            assert!(far(&stops[own]) <= nearest + 1.0, "{profile}: {} stands at another stop", label.text);
            assert!(far(&stops[own]) <= 20.0, "{profile}: {} is {} mm away", label.text, far(&stops[own]));
        }
    }
}

const TABLE: [f32; 2] = [800.0, 400.0];

/// A table of words, and the cell of each on the sheet.
fn table(rows: &[&[&str]]) -> String {
    let (count, columns) = (rows.len(), rows[0].len());
    let (width, height) = (720.0 / columns as f32, 320.0 / count as f32);
    let mut marks = "<g stroke='#000' stroke-width='2'>".to_owned();
    for column in 0..=columns {
        let x = 40.0 + width * column as f32;
        write!(marks, "<line x1='{x}' x2='{x}' y1='40' y2='360'/>").expect("text");
    }
    for row in 0..=count {
        let y = 40.0 + height * row as f32;
        write!(marks, "<line y1='{y}' y2='{y}' x1='40' x2='760'/>").expect("text");
    }
    marks += "</g><g text-anchor='middle'>";
    for (row, words) in rows.iter().enumerate() {
        for (column, word) in words.iter().enumerate() {
            let (x, y) = (40.0 + width * (column as f32 + 0.5), 46.0 + height * (row as f32 + 0.5));
            write!(marks, "<text x='{x}' y='{y}'>{word}</text>").expect("text");
        }
    }
    svg(TABLE, &(marks + "</g>"))
}

/// What a word in a table says, it says by its row and its column: it stands in its cell, in full or abbreviated, or
/// not at all, which is told.
#[test]
fn words_of_a_table_stay_in_their_cells() {
    let lessons: &[&[&str]] = &[
        &["Day", "Morning", "Afternoon", "Evening"],
        &["Monday", "Maths", "Music", "Reading"],
        &["Tuesday", "English", "Sport", "Games"],
        &["Wednesday", "Science", "Art", "Swimming"],
    ];
    let classes: &[&[&str]] = &[
        &["Class", "Red", "Blue", "Green", "Total"],
        &["4 a", "71", "91", "41", "203"],
        &["5 a", "61", "81", "82", "224"],
        &["6 a", "101", "51", "62", "214"],
    ];
    for (rows, profile) in [lessons, classes].into_iter().flat_map(|rows| PROFILES.map(|profile| (rows, profile))) {
        let drawing = drawn(&table(rows), profile);
        let (width, height) = (720.0 / rows[0].len() as f32, 320.0 / rows.len() as f32);
        let told = notes(&drawing);
        let labels = labels_of(&drawing);
        let of = |word: &str| labels.iter().find(|label| label.text == word).copied();
        for (row, words) in rows.iter().enumerate() {
            for (column, word) in words.iter().enumerate() {
                let corner = |column: usize, row: usize| {
                    at(&drawing, TABLE, (40.0 + width * column as f32, 40.0 + height * row as f32))
                };
                let cell = MmRect::new(corner(column, row), corner(column + 1, row + 1));
                match of(word) {
                    Some(label) => {
                        assert!(cell.contains_box(&place(label)), "{profile}: {word} is not in its cell\n{told}");
                    }
                    None => {
                        assert!(told.contains(&format!("\"{word}\"")) || told.contains("more"), "{profile}: {word}")
                    }
                }
            }
        }
        // no finger's rows are as narrow as those of this table on a grid of 2 mm; on pins its names of classes, four cells
        // with their blank, have no room in theirs, and beside the table they would be headings
        let least = match profile {
            "index-basic-d" => rows[0].len(),
            "dot-pad" => rows.len() * rows[0].len() - 3,
            _ => rows.len() * rows[0].len(),
        };
        assert!(labels.len() >= least, "{profile}: {told}");
    }
}

/// A leader line from outside of a pie ends at the arc of its own sector, off the borders to the next ones.
#[test]
fn leader_lines_end_off_the_borders_of_sectors() {
    let parts = [("Walk", 45.0, "#c84"), ("Bus", 28.0, "#48c"), ("Bicycle", 17.0, "#4a4"), ("Car", 10.0, "#d44")];
    let svg = pie(&parts, false);
    let mut seen = 0;
    for profile in PROFILES {
        let drawing = drawn(&svg, profile);
        let told = notes(&drawing);
        let middle = at(&drawing, PIE, (240.0, 240.0));
        let borders = parts.iter().scan(0.0_f32, |sum, (_, share, _)| {
            *sum += std::f32::consts::TAU * share / 100.0;
            let (sin, cos) = sum.sin_cos();
            Some(at(&drawing, PIE, (240.0 + 180.0 * sin, 240.0 - 180.0 * cos)))
        });
        let borders: Vec<MmPoint> = borders.collect();
        let led = |label: &&BrailleText| label.role == TextRole::Label && label.leader.is_some();
        for label in labels_of(&drawing).into_iter().filter(led) {
            let points = &label.leader.as_ref().expect("a leader line").points;
            let tip = points.iter().min_by(|a, b| (**a - middle).length().total_cmp(&(**b - middle).length()));
            let tip = *tip.expect("two ends");
            let near = borders.iter().map(|border| nearest_on_segment(tip, middle, *border).0);
            let near = near.fold(f32::INFINITY, f32::min);
            assert!(near >= 2.5, "{profile}: that of {} ends {near} mm from a border\n{told}", label.text);
            seen += 1;
        }
    }
    assert!(seen > 0, "there are leader lines to look at");
}

/// Two labels one above the other are further apart than the lines of one text: 5 mm of blank, 10 from line to line.
#[test]
fn labels_one_above_the_other_are_not_read_as_one() {
    for (sample, profile) in ["cell.svg", "map.svg"].into_iter().flat_map(|sample| PROFILES.map(|of| (sample, of))) {
        let svg = std::fs::read_to_string(format!("samples/{sample}")).expect("a sample");
        let drawing = drawn(&svg, profile);
        let places: Vec<MmRect> = labels_of(&drawing).into_iter().map(place).collect();
        for (number, a) in places.iter().enumerate() {
            for b in &places[number + 1..] {
                let across = a.max.x.min(b.max.x) - a.min.x.max(b.min.x);
                let blank = (b.min.y - a.max.y).max(a.min.y - b.max.y);
                assert!(across <= 0.0 || blank >= 6.0, "{sample}, {profile}: {blank} mm of blank");
            }
        }
    }
}

/// On dots, what is left of a texture beside a label is higher than two lines of braille, as which it would be read.
#[test]
fn textures_beside_labels_are_not_read_as_braille() {
    let svg = std::fs::read_to_string("samples/map.svg").expect("a sample");
    let drawing = drawn(&svg, "dot-pad");
    let labels: Vec<MmRect> = labels_of(&drawing).into_iter().map(place).collect();
    assert!(!drawing.page.figure.textures.is_empty());
    for texture in &drawing.page.figure.textures {
        let extent = MmRect::from_points(texture.glyphs.iter().map(|glyph| glyph.at));
        let near = labels.iter().any(|label| label.inflate(12.0, 12.0).intersects(&extent));
        assert!(!near || extent.height() >= 17.4, "{extent:?}");
    }
    assert!(notes(&drawing).contains("as labels stand in their places"), "{}", notes(&drawing));
}

/// Where dots can stand anywhere, the name of an area stands in it though there is room in one place only.
#[test]
fn a_name_stands_in_its_area_on_a_braillerap() {
    let svg = std::fs::read_to_string("samples/map.svg").expect("a sample");
    let drawing = drawn(&svg, "braillerap");
    let south = labels_of(&drawing).into_iter().find(|label| label.text == "South").expect("it has a place");
    assert!(south.leader.is_none() && south.abbreviation.is_none(), "{:?}", south.abbreviation);
    assert!(place(south).max.y < at(&drawing, [800.0, 600.0], (300.0, 520.0)).y, "above its coast");
}
