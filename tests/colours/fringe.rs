//! Fringe classes through the fingertip: rows still say the class, rhombuses the side that a colour leans to.

use tactograph::internals::output::svg;
use tactograph::internals::page::{Class, Shape};
use tactograph::internals::touch;

use crate::common::page;

/// Colours that are typical of their class or lean to a neighbour: class, the neighbour, and three shades, sRGB.
const COLOURS: [(Class, Option<Class>, [u32; 3]); 12] = [
    (Class::Red, None, [0xd01818, 0xf08090, 0x801018]),
    (Class::Red, Some(Class::Yellow), [0xff5010, 0xf08060, 0xb03810]),
    (Class::Red, Some(Class::Blue), [0xc020c0, 0xe090e0, 0x801080]),
    (Class::Yellow, None, [0xf0d010, 0xf0e080, 0xd0a820]),
    (Class::Yellow, Some(Class::Red), [0xff9010, 0xf0b070, 0xc06810]),
    (Class::Yellow, Some(Class::Green), [0xf0ff00, 0xf0ff80, 0xc8c000]),
    (Class::Green, None, [0x20a030, 0x90e090, 0x106010]),
    (Class::Green, Some(Class::Yellow), [0x90f010, 0xb0f060, 0x80c010]),
    (Class::Green, Some(Class::Blue), [0x10e0a0, 0x80f0c8, 0x108060]),
    (Class::Blue, None, [0x2040d0, 0x80b0f0, 0x102880]),
    (Class::Blue, Some(Class::Green), [0x10d0d0, 0x80e8f0, 0x108088]),
    (Class::Blue, Some(Class::Red), [0x6020d0, 0xb090f0, 0x401080]),
];

/// A smaller sheet, so that there is less to feel.
const SETTINGS: [(&str, &str); 5] = [
    ("textures.fringe", "true"),
    ("overview", "false"),
    ("mark", "false"),
    ("page.width", "130"),
    ("page.height", "130"),
];

/// How many places were judged, the share whose class a fingertip of 1.0 mm reads from the rows, and the share whose leaning
/// one of 0.5 mm reads from the rhombuses: the direction that it feels is nearest to that of the class leant to, or for a
/// typical colour to that of the class itself.
fn read(picture: &str, truth: impl Fn(f32, f32) -> Option<(Class, Option<Class>)>) -> (u32, f32, f32) {
    let page = page::page_of(picture.as_bytes(), "fringe", &SETTINGS, &mut |_| ()).page;
    let ink = touch::Ink::of(&svg::write(&page)).expect("a page");
    let (broad, fine) = (ink.felt(1.0).expect("a finger"), ink.felt(0.5).expect("a finger"));
    let fine_columns = fine.size.width as usize;
    let place = page.figure.place;
    let (mut all, mut class_read, mut leaning_read) = (0, 0, 0);
    for (i, (broad, fine)) in broad.cells.iter().zip(&fine.cells).enumerate() {
        let mm = |cell: usize| (cell as f32 + 0.5) / touch::CELLS_PER_MM as f32;
        let (column, row) = (i % fine_columns, i / fine_columns);
        let x = (ink.area.min.x + mm(column) - place.min.x) / place.width();
        let y = (ink.area.min.y + mm(row) - place.min.y) / place.height();
        let Some((class, leaning)) = truth(x, y).filter(|_| broad.judged && broad.meant.is_some()) else { continue };
        all += 1;
        class_read += u32::from(broad.felt == Some(class));
        leaning_read += u32::from(ink.signs.along(fine.feel.degrees) == leaning.or(Some(class)));
    }
    (all, class_read as f32 / all as f32, leaning_read as f32 / all as f32)
}

#[test]
fn fringes_are_told_and_the_class_stays() {
    for (class, leaning, shades) in COLOURS {
        for (number, shade) in shades.into_iter().enumerate() {
            // White lines make the texture dense in one of the three.
            let bars = if number == 0 { "<path d='M0 33h100M0 66h100' stroke='#fff' stroke-width='2'/>" } else { "" };
            let picture = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>\
                 <rect width='100' height='100' fill='#{shade:06x}'/>{bars}</svg>"
            );
            let (all, class_read, leaning_read) = read(&picture, |_, _| Some((class, leaning)));
            assert!(all > 5000, "{shade:06x}: only {all} places");
            assert!(class_read >= 0.95, "{shade:06x}: {class:?} is read at {class_read} of {all} places");
            assert!(leaning_read >= 0.9, "{shade:06x}: {leaning:?} is read at {leaning_read} of {all} places");
        }
    }
}

/// Centre and fringe in one area, passing softly into one another: red on the left, orange red on the right.
#[test]
fn a_fringe_is_a_part_of_its_area() {
    let picture = "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><linearGradient id='g'>\
                   <stop offset='.4' stop-color='#d82020'/><stop offset='.6' stop-color='#ff5810'/></linearGradient>\
                   <rect width='100' height='100' fill='url(#g)'/></svg>";
    let page = page::page_of(picture.as_bytes(), "fringe", &SETTINGS, &mut |_| ()).page;
    assert_eq!(page.figure.textures.len(), 1, "one region, one path");
    let truth = |x: f32, _| {
        let leaning = if x < 0.5 { None } else { Some(Class::Yellow) };
        ((x - 0.5).abs() > 0.2).then_some((Class::Red, leaning))
    };
    let (all, class_read, leaning_read) = read(picture, truth);
    assert!(all > 3000 && class_read >= 0.95 && leaning_read >= 0.9, "{all} {class_read} {leaning_read}");
}

#[test]
fn without_fringes_all_rhombuses_lie_along_their_rows() {
    let picture = "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>\
                   <rect width='100' height='100' fill='#ff5010'/></svg>";
    let directions = |settings: &[(&str, &str)]| {
        let page = page::page_of(picture.as_bytes(), "fringe", settings, &mut |_| ()).page;
        let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
        let mut all: Vec<String> = glyphs
            .map(|glyph| match glyph.shape {
                Shape::Rhombus { degrees, .. } => degrees.to_string(),
                Shape::Dot { .. } => "dot".into(),
            })
            .collect();
        all.dedup();
        all
    };
    assert_eq!(directions(&[]), ["135"]);
    assert_eq!(directions(&[("textures.fringe", "true")]), ["90"]);
}
