//! Tests of `print`.

use usvg::roxmltree::Document;

use super::*;

/// The size of the letters in mm where a unit is 1 mm, and whether they are light.
fn of(text: &str) -> (f32, bool) {
    let svg = format!("<svg font-size=\"4\">{text}</svg>");
    let document = Document::parse(&svg).expect("it is XML");
    let node = document.descendants().find(|node| node.tag_name().name() == "text").expect("a text");
    (font_size(node, 1.0), is_light(node))
}

#[test]
fn each_part_of_words_in_print_has_to_be_light() {
    for (light, text) in [
        (true, "<text fill=\"#c4c4c4\">a</text>"),
        (true, "<text style=\"fill:#ccc;stroke:none\">a</text>"),
        (true, "<text><tspan fill=\"rgb(200, 200, 200)\">a</tspan></text>"),
        (false, "<text>a</text>"),
        (false, "<text fill=\"#c4c4c4\">a<tspan fill=\"#000\">b</tspan></text>"),
        (false, "<text fill=\"#c4c4c4\" stroke=\"black\">a</text>"),
        (false, "<text style=\"fill:#ccc;fill:#333\">a</text>"),
        (false, "<text fill=\"url(#shade)\">a</text>"),
    ] {
        assert_eq!(of(text).1, light, "{text}");
    }
}

#[test]
fn sizes_of_letters_have_units() {
    for (size, text) in [
        (4.0, "<text>a</text>"),
        (3.0, "<text font-size=\"3px\">a</text>"),
        (96.0 / 25.4, "<text style=\"font-size:1mm\">a</text>"),
        (16.0, "<text font-size=\"12pt\">a</text>"),
        (2.0, "<text font-size=\"50%\">a</text>"),
        (6.0, "<text font-size=\"9\"><tspan font-size=\"6\">a</tspan></text>"),
        (18.0, "<text font-size=\"9\"><tspan font-size=\"2em\">a</tspan></text>"),
        (COMMON_SIZE, "<text font-size=\"large\">a</text>"),
    ] {
        assert!((of(text).0 - size).abs() < 1e-4, "{text}: {}", of(text).0);
    }
}
