//! Drawings that are far too dense for a page: they make more work than they have lines, where each line is compared
//! with those beside it, or each label with all others.

use std::f64::consts::TAU;
use std::fmt::Write as _;

/// All of them, with what they are of.
pub(crate) fn drawings() -> Vec<(&'static str, String)> {
    let mut all = lines();
    all.extend(signs());
    all.extend(words());
    all
}

/// A drawing 800 by 600 units large.
fn drawing(elements: impl Iterator<Item = String>) -> String {
    let head = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='600'><defs><marker id='m' markerWidth='6' \
                markerHeight='6' refX='5' refY='3' orient='auto'><path d='M0 0L6 3L0 6z'/></marker></defs>\
                <rect width='800' height='600' fill='#fff'/>";
    elements.fold(head.to_owned(), |mut text, element| {
        text.push_str(&element);
        text
    }) + "</svg>"
}

/// A stroke as wide as this.
fn stroke(width: f64, path: &str) -> String {
    format!("<path d='{path}' stroke='#000' stroke-width='{width}' fill='none'/>")
}

fn text(x: f64, y: f64, size: u32, text: &str) -> String {
    format!("<text x='{x:.1}' y='{y:.1}' font-size='{size}'>{text}</text>")
}

fn circle(x: f64, y: f64, radius: f64) -> String {
    format!("<circle cx='{x:.1}' cy='{y:.1}' r='{radius:.2}' stroke='#000' stroke-width='0.8' fill='none'/>")
}

/// So many places in rows of so many, each with its number.
fn in_rows(count: u32, across: u32, first: [f64; 2], step: [f64; 2]) -> impl Iterator<Item = (u32, f64, f64)> {
    (0..count).map(move |i| (i, first[0] + step[0] * f64::from(i % across), first[1] + step[1] * f64::from(i / across)))
}

/// So many places that look random and are the same every time, each with its number.
fn anywhere(count: u32) -> impl Iterator<Item = (u32, f64, f64)> {
    let mut state = 1_u32;
    let mut next = move |below: f64| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        below * f64::from(state >> 8) / f64::from(1 << 24)
    };
    (0..count).map(move |i| (i, 20.0 + next(760.0), 20.0 + next(560.0)))
}

/// A line through so many points.
fn line(width: f64, count: u32, at: impl Fn(f64) -> [f64; 2]) -> String {
    let path = (0..count).fold(String::new(), |mut path, i| {
        let [x, y] = at(f64::from(i));
        let _ = write!(path, "{}{x:.2} {y:.2}", if i == 0 { 'M' } else { 'L' });
        path
    });
    stroke(width, &path)
}

fn lines() -> Vec<(&'static str, String)> {
    let spiral = |i: f64| [400.0 + 0.0145 * i * (0.05 * i).cos(), 300.0 + 0.0145 * i * (0.05 * i).sin()];
    let meander = |i: f64| {
        let row = (0.5 * i).floor();
        [if (row + i) % 2.0 < 1.0 { 10.0 } else { 790.0 }, 1.0 + 1.99 * row]
    };
    let mut ends = anywhere(1200);
    let mut end = move || ends.next().map_or([0.0; 2], |(_, x, y)| [x, y]);
    let long = (0..600).map(move |_| {
        let [from, to] = [end(), end()];
        line(1.0, 2, |i| if i < 1.0 { from } else { to })
    });
    vec![
        ("500 rings one in the other", drawing((0..500).map(|i| circle(400.0, 300.0, 1.0 + 0.58 * f64::from(i))))),
        ("1000 strokes side by side", drawing((0..1000).map(|i| line(0.4, 2, |y| [0.8 * f64::from(i), 600.0 * y])))),
        (
            "1000 strokes aslant",
            drawing((0..1000).map(|i| stroke(0.7, &format!("M{} 0l600 600", 1.4 * f64::from(i) - 600.0)))),
        ),
        (
            "a grid of 600 lines",
            drawing((0..300).map(|i| stroke(0.5, &format!("M0 {}H800M{} 0V600", 2 * i, 2.67 * f64::from(i))))),
        ),
        (
            "100 waves",
            drawing((0..100).map(|k| line(1.0, 800, |i| [i, 5.0 + 6.0 * f64::from(k) + 8.0 * (0.7 * i).sin()]))),
        ),
        ("600 long strokes anywhere", drawing(long)),
        ("a spiral of 160 turns", drawing(std::iter::once(line(0.3, 20_000, spiral)))),
        ("a line to and fro", drawing(std::iter::once(line(0.9, 600, meander)))),
        ("3000 dashes anywhere", drawing(anywhere(3000).map(|(_, x, y)| stroke(1.5, &format!("M{x:.1} {y:.1}l5 3"))))),
    ]
}

fn signs() -> Vec<(&'static str, String)> {
    let lamp = |(_, x, y): (u32, f64, f64)| {
        let cross = format!("M{} {}l7 7m0 -7l-7 7", x - 3.5, y - 3.5);
        circle(x, y, 5.0) + &stroke(1.5, &cross)
    };
    let arrow = |(i, x, y): (u32, f64, f64)| {
        let (sin, cos) = f64::from(i).sin_cos();
        format!(
            "<path d='M{x:.1} {y:.1}l{:.1} {:.1}' stroke='#000' stroke-width='1' marker-end='url(#m)'/>",
            15.0 * cos,
            15.0 * sin
        )
    };
    let box_with_line = |(_, x, y): (u32, f64, f64)| {
        let path = format!("M{x} {y}h6v6h-6zM{} {}h9.6", x + 6.0, y + 3.0);
        stroke(1.5, &path)
    };
    vec![
        ("2500 lamps", drawing(in_rows(2500, 50, [10.0, 8.0], [15.8, 11.8]).map(lamp))),
        ("3000 arrows", drawing(anywhere(3000).map(arrow))),
        ("2000 boxes and connectors", drawing(in_rows(2000, 50, [10.0, 8.0], [15.6, 14.6]).map(box_with_line))),
        ("2000 points", drawing(anywhere(2000).map(|(_, x, y)| circle(x, y, 3.0)))),
    ]
}

/// Those with texts.
fn words() -> Vec<(&'static str, String)> {
    let pair = |(_, x, y): (u32, f64, f64)| {
        text(x, y, 10, "Saint") + &text(x, y + 12.0, 10, "Gallen") + &circle(x - 6.0, y, 3.0)
    };
    let fan = |count: u32| {
        drawing((0..count).map(move |i| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(count)).sin_cos();
            let [x, y] = [400.0 + 280.0 * cos, 300.0 + 280.0 * sin];
            stroke(1.5, &format!("M400 300L{x:.1} {y:.1}")) + &text(x + 5.0 * cos, y + 5.0 * sin, 6, &format!("s{i}"))
        }))
    };
    let bar = |(i, x, _): (u32, f64, f64)| {
        let height = 20 + 37 * i % 500;
        stroke(0.3, &format!("M{x:.2} 590v-{height}h1.2v{height}")) + &text(x, 598.0, 1, &i.to_string())
    };
    let tick =
        |(i, x, _): (u32, f64, f64)| stroke(1.0, &format!("M{x:.1} 290V310")) + &text(x, 320.0, 3, &format!("n{i}"));
    let in_box = |(i, x, y): (u32, f64, f64)| {
        stroke(1.5, &format!("M{x} {y}h36v20h-36z")) + &text(x + 3.0, y + 14.0, 8, &format!("box {i}"))
    };
    let in_cell = |(i, x, y): (u32, f64, f64)| {
        stroke(1.0, &format!("M{x} {y}h13v9.6h-13z")) + &text(x + 1.0, y + 8.0, 7, ["ab", "cd", "ox"][i as usize % 3])
    };
    vec![
        ("290 names in two lines", drawing(in_rows(290, 20, [10.0, 20.0], [39.0, 38.0]).map(pair))),
        ("2000 names in two lines", drawing(in_rows(2000, 50, [10.0, 10.0], [15.0, 14.0]).map(pair))),
        ("a fan of 150 strokes with names", fan(150)),
        ("a fan of 290 strokes with names", fan(290)),
        ("500 bars with numbers", drawing(in_rows(500, 500, [10.0, 0.0], [1.56, 0.0]).map(bar))),
        ("150 ticks with names", drawing(in_rows(150, 150, [10.0, 0.0], [5.2, 0.0]).map(tick))),
        ("290 ticks with names", drawing(in_rows(290, 290, [10.0, 0.0], [2.6, 0.0]).map(tick))),
        ("280 boxes with names", drawing(in_rows(280, 20, [5.0, 5.0], [39.0, 38.0]).map(in_box))),
        ("a table of 3600 words", drawing(in_rows(3600, 60, [10.0, 10.0], [13.0, 9.6]).map(in_cell))),
        ("300 texts at one place", drawing((0..300).map(|i| text(400.0, 300.0, 10, &format!("name{i}"))))),
        (
            "2000 points with names",
            drawing(anywhere(2000).map(|(i, x, y)| circle(x, y, 2.0) + &text(x + 4.0, y - 3.0, 8, &format!("P{i}")))),
        ),
    ]
}
