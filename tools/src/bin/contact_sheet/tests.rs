//! Tests of the contact sheet.

use super::*;

#[test]
fn names_and_what_was_said_stand_in_html_as_they_are() {
    let made = Made { said: "a < b\nc".to_owned(), pages: Err("\"no\"".into()) };
    let row = Row { name: "a#1 50%<\"&é.png".to_owned(), made: vec![made], drawn: Ok(()) };
    let text = index(&[row], &["x & y".to_owned()]);
    for part in [
        "<h2>a#1 50%&lt;&quot;&amp;é.png</h2>",
        "src=\"a%231%2050%25%3C%22%26%C3%A9.png.png\"",
        "alt=\"The picture a#1 50%&lt;&quot;&amp;é.png and its pages\"",
        "<p>x &amp; y: a &lt; b<br>c</p>",
        "<p>x &amp; y: No page: &quot;no&quot;</p>",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
}

/// A black figure of 300 by 100 mm on A3, as page and as picture.
#[cfg(unix)]
const PAGE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 420 297\" width=\"420mm\" \
    height=\"297mm\"><g id=\"figure\" data-box=\"10 10 300 100\"><rect x=\"10\" y=\"10\" width=\"300\" \
    height=\"100\"/></g></svg>";
/// Writes two pages of every picture but one.
#[cfg(unix)]
const PROGRAM: &str = "case \"$1\" in */refused.png) echo it is refused >&2; exit 3;; esac\n\
    for n in 1 2; do cp \"$0.svg\" \"${3%.svg}-$n.svg\"; done\n";

#[cfg(unix)]
#[test]
fn several_pages_lie_below_one_another_wide_ones_beside_one_another_and_a_fault_stays_in_its_row() {
    use resvg::tiny_skia::Pixmap;

    let folder = tempfile::tempdir().unwrap();
    let [from, to, program] = ["from", "to", "program"].map(|name| folder.path().join(name));
    std::fs::create_dir(&from).unwrap();
    for name in ["a.png", "a.jpg", "refused.png"] {
        std::fs::write(from.join(name), PAGE).unwrap();
    }
    std::fs::create_dir(from.join("unreadable.svg")).unwrap();
    std::fs::write(&program, PROGRAM).unwrap();
    std::fs::write(folder.path().join("program.svg"), PAGE).unwrap();
    let commands = [format!("sh {}", program.display()), "no/such/program".to_owned()];
    let rows = sheet(&from, &to, &commands, 0.5).unwrap();

    let names: Vec<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names, ["a.jpg", "a.png", "refused.png", "unreadable.svg"]);
    assert_eq!([0, 1, 2, 3].map(|row| rows[row].drawn.is_ok()), [true, true, true, false]);
    let pages = rows.iter().map(|row| row.made[0].pages.as_ref().map_or(0, Vec::len));
    assert_eq!(pages.collect::<Vec<_>>(), [2, 2, 0, 2]);
    assert!(rows.iter().all(|row| row.made[1].pages.is_err()));
    assert_eq!(rows[2].made[0].said, "it is refused");
    let text = std::fs::read_to_string(to.join("index.html")).unwrap();
    assert!(text.contains("it is refused") && text.contains("No picture of this row: "), "{text}");

    // half a pixel for each millimetre; the last 12 mm are the gaps of the program that is not there
    for name in ["a.jpg", "a.png"] {
        let row = Pixmap::load_png(to.join(format!("{name}.png"))).unwrap();
        let wide = row::PICTURE + row::GAP + 2.0 * (300.0 + row::GAP) + 2.0 * row::GAP;
        let high = 2.0 * (100.0 + row::GAP);
        assert_eq!([row.width(), row.height()], [wide, high].map(|side| (0.5 * side) as u32), "{name}");
        let is_black = |x: u32, y: u32| row.pixel(x / 2, y / 2).unwrap().red() < 128;
        let found = [20, 126].map(|y| [300, 480, 489, 600].map(|x| is_black(x, y)));
        assert_eq!(found, [[true, true, false, true]; 2], "{name}: sharp, its right end, the gap, blurred");
    }
}
