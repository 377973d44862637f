//! The classes over hue, saturation and value: one panel for each of six saturations, hue to the right, value upwards, every
//! place in its own colour, with the borders of the classes as lines and their names.

use std::error::Error;
use std::fmt::Write;

use tactograph::internals::classes::class_of;
use tactograph::internals::pipeline::colours;
use tactograph::internals::profile::{Plan, Profile};

const SATURATIONS: [f32; 6] = [1.0, 0.75, 0.5, 0.35, 0.22, 0.12];
/// Steps of a panel along hue (2 degrees) and value, and the size of a step.
const STEPS: (usize, usize) = (180, 60);
const STEP: f32 = 2.0;
/// Blank around the panels.
const LEFT: f32 = 60.0;
const TOP: f32 = 34.0;
const BETWEEN: f32 = 34.0;
const BELOW: f32 = 26.0;

pub(super) fn draw() -> Result<String, Box<dyn Error>> {
    let profile = Profile::named("swell-a4").map_err(|faults| format!("{faults:?}"))?;
    let params = colours::params(&Plan::new(&profile).map_err(|faults| format!("{faults:?}"))?);
    let (panel_width, panel_height) = (STEP * STEPS.0 as f32, STEP * STEPS.1 as f32);
    let (width, height) = (2.0 * (LEFT + panel_width) + 20.0, TOP + 3.0 * (panel_height + BETWEEN) + BELOW);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<title>Classes of colours</title>\n<desc>Six panels, one for each saturation from 1 to 0.12. Hue \
         runs from left to right, from 0 to 360 degrees, value upwards from 0 to 1. Lines part red, yellow, green, blue, \
         grey and white. The darker and the less saturated, the more is grey; dark yellow belongs to green, dark orange to \
         yellow.</desc>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n<linearGradient id=\"dark\" x2=\"0\" \
         y2=\"1\"><stop stop-opacity=\"0\"/><stop offset=\"1\"/></linearGradient>\n"
    );
    for (number, saturation) in SATURATIONS.into_iter().enumerate() {
        let x = LEFT + (number % 2) as f32 * (panel_width + LEFT);
        let y = TOP + (number / 2) as f32 * (panel_height + BETWEEN);
        writeln!(out, "<linearGradient id=\"hue{number}\">")?;
        for sixth in 0..=6_u8 {
            let [r, g, b] = rgb(60.0 * f32::from(sixth), saturation, 1.0).map(|channel| (255.0 * channel).round());
            writeln!(out, "<stop offset=\"{:.4}\" stop-color=\"rgb({r},{g},{b})\"/>", f32::from(sixth) / 6.0)?;
        }
        writeln!(out, "</linearGradient>\n<g transform=\"translate({x} {y})\">")?;
        for fill in [format!("hue{number}"), "dark".to_owned()] {
            writeln!(out, "<rect width=\"{panel_width}\" height=\"{panel_height}\" fill=\"url(#{fill})\"/>")?;
        }
        let names = names(saturation, &params);
        writeln!(out, "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"3\" d=\"{0}\"/>", borders(&names))?;
        writeln!(out, "<path fill=\"none\" stroke=\"#000\" stroke-width=\"1.2\" d=\"{0}\"/>", borders(&names))?;
        for (name, column, row) in places(&names) {
            let (x, y) = (STEP * column, STEP * row + 4.5);
            writeln!(
                out,
                "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"middle\" stroke=\"#fff\" stroke-width=\"3\" \
                 paint-order=\"stroke\">{name}</text>"
            )?;
        }
        axes(&mut out, number, saturation, panel_width, panel_height)?;
        writeln!(out, "</g>")?;
    }
    out += "</svg>\n";
    Ok(out)
}

fn axes(out: &mut String, number: usize, saturation: f32, width: f32, height: f32) -> std::fmt::Result {
    writeln!(out, "<text y=\"-8\">saturation {saturation}</text>")?;
    for (value, y) in [(1.0, 0.0), (0.5, 0.5), (0.0, 1.0)] {
        writeln!(out, "<text x=\"-6\" y=\"{:.0}\" text-anchor=\"end\">{value}</text>", y * height + 4.5)?;
    }
    writeln!(
        out,
        "<text x=\"-30\" y=\"{0:.0}\" text-anchor=\"middle\" transform=\"rotate(-90 -30 {0:.0})\">value</text>",
        0.5 * height
    )?;
    if number >= SATURATIONS.len() - 2 {
        for hue in (0..=360_u16).step_by(60) {
            let x = f32::from(hue) / 360.0 * width;
            writeln!(out, "<text x=\"{x:.0}\" y=\"{:.0}\" text-anchor=\"middle\">{hue}</text>", height + 18.0)?;
        }
        writeln!(out, "<text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"middle\">hue</text>", 0.5 * width, height + 36.0)?;
    }
    Ok(())
}

/// The name of the class of every step, rows from the top.
fn names(saturation: f32, params: &tactograph::internals::classes::Params) -> Vec<&'static str> {
    let (columns, rows) = STEPS;
    (0..columns * rows)
        .map(|i| {
            let hue = ((i % columns) as f32 + 0.5) / columns as f32 * 360.0;
            let value = 1.0 - ((i / columns) as f32 + 0.5) / rows as f32;
            class_of(rgb(hue, saturation, value), params).map_or("white", |class| class.name())
        })
        .collect()
}

/// The lines between steps of different classes, whole runs at once.
fn borders(names: &[&str]) -> String {
    let (columns, rows) = STEPS;
    let name = |column: usize, row: usize| names[row * columns + column];
    let mut d = String::new();
    let mut runs = |count: usize, along: usize, differs: &dyn Fn(usize, usize) -> bool, upright: bool| {
        for line in 1..count {
            let mut start = None;
            for place in 0..=along {
                match (start, place < along && differs(line, place)) {
                    (None, true) => start = Some(place),
                    (Some(from), false) => {
                        let at = |n: usize| STEP * n as f32;
                        let (x, y) = if upright { (at(line), at(from)) } else { (at(from), at(line)) };
                        let way = at(place - from);
                        d += &if upright { format!("M{x},{y}v{way}") } else { format!("M{x},{y}h{way}") };
                        start = None;
                    }
                    _ => (),
                }
            }
        }
    };
    runs(columns, rows, &|column, row| name(column - 1, row) != name(column, row), true);
    runs(rows, columns, &|row, column| name(column, row - 1) != name(column, row), false);
    d
}

/// A run of steps of one class in one row.
#[derive(Clone, Copy)]
struct Run {
    name: &'static str,
    from: usize,
    to: usize,
    row: usize,
}

/// Where to write the name of each connected area that has room for it: in the middle of its widest rows.
fn places(names: &[&'static str]) -> Vec<(&'static str, f32, f32)> {
    let (columns, rows) = STEPS;
    let mut areas: Vec<Vec<Run>> = Vec::new();
    for row in 0..rows {
        let mut from = 0;
        for steps in names[row * columns..][..columns].chunk_by(|a, b| a == b) {
            let run = Run { name: steps[0], from, to: from + steps.len(), row };
            from = run.to;
            let above = |area: &&mut Vec<Run>| {
                area.iter().any(|r| r.name == run.name && r.row + 1 >= row && r.from < run.to && run.from < r.to)
            };
            match areas.iter_mut().find(above) {
                Some(area) => area.push(run),
                None => areas.push(vec![run]),
            }
        }
    }
    let middle = |area: Vec<Run>| {
        let widest = area.iter().map(|run| run.to - run.from).max()?;
        let wide: Vec<Run> = area.into_iter().filter(|run| 10 * (run.to - run.from) >= 9 * widest).collect();
        let run = wide[wide.len() / 2];
        // 11 steps hold three letters.
        (widest >= 11 && wide.len() >= 4).then_some((run.name, 0.5 * (run.from + run.to) as f32, run.row as f32 + 0.5))
    };
    areas.into_iter().filter_map(middle).collect()
}

/// HSV to sRGB, hue in degrees.
fn rgb(hue: f32, saturation: f32, value: f32) -> [f32; 3] {
    [5.0, 3.0, 1.0].map(|n| {
        let k = (n + hue / 60.0) % 6.0;
        value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
    })
}
