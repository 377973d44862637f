//! Tests of `report`.

use super::*;
use crate::units::Size;

#[test]
fn glyphs_are_connected_by_sides_and_corners() {
    let picture = ["#..#", ".#.#", "....", "#..#"];
    let values = picture.iter().flat_map(|row| row.chars().map(|c| f32::from(u8::from(c == '#')))).collect();
    assert_eq!(glyphs(&Plane { size: Size::new(4, 4), values }), 4);
}

fn of(class: Class, [right, unclear, wrong, not_judged]: [f32; 4]) -> OfClass {
    let areas = Areas { right, unclear, wrong, not_judged };
    OfClass { class, areas, mostly_felt_as: (wrong > 0.0).then_some(FeltAs::Blank), ink: 0.06, density: 10.25 }
}

#[test]
fn shares_are_written_as_they_are() {
    for (share, want) in [(0.0, "0 %"), (0.001, "under 1 %"), (0.5, "50 %"), (0.997, "over 99 %"), (1.0, "100 %")] {
        assert_eq!(Percent(share).to_string(), want);
    }
}

#[test]
fn a_page_without_textures_is_told_so() {
    let text = Report { finger: 1.0, classes: Vec::new() }.to_string();
    assert!(text.starts_with("There are no textures"), "{text}");
}

#[test]
fn the_total_is_the_mean_of_the_lines_by_textured_area_and_counts_what_is_not_judged() {
    let classes = vec![of(Class::Blue, [5.0, 0.0, 0.0, 95.0]), of(Class::Red, [150.0, 30.0, 60.0, 60.0])];
    let report = Report { finger: 1.0, classes };
    let lines = [
        "What a fingertip of 1 mm feels, in shares of the textured area of each colour:",
        "blue, 25 % of all textures: right 5 %, unclear 0 %, wrong 0 %, not judged 95 %. \
         Ink 6 %, 10.2 glyphs to a square centimetre.",
        "red, 75 % of all textures: right 50 %, unclear 10 %, wrong 20 %, not judged 20 %. \
         Wrong is mostly felt as blank paper. Ink 6 %, 10.2 glyphs to a square centimetre.",
        "All textures: right 39 %, unclear 8 %, wrong 15 %, not judged 39 %.",
        "What lies nearer than 7 mm to a line or a border is not judged: a fingertip feels both sides there.",
    ];
    assert_eq!(report.to_string(), lines.join("\n") + "\n");
    assert!((report.total().right_of_judged() - 155.0 / 245.0).abs() < 1e-6);
}
