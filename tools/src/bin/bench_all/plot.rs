//! A drawing of the time that each stage takes, one bar for each kind of picture: grey, and told apart by numbers.

use std::fmt::Write as _;

use tactograph_tools::plot;

use crate::ours::{STAGES, stage};
use crate::rounds::Outcome;

/// Width of the drawing, height of a bar with the room above it, the longest bar.
const WIDTH: f64 = 940.0;
const ROW: f64 = 22.0;
const LEFT: f64 = 200.0;
const LONGEST: f64 = 640.0;
/// Where the first bar begins.
const TOP: f64 = 66.0;
/// A bar that would be longer is cut, and says how long it is: one picture of 50 megapixels would hide all others.
const MOST: f64 = 250.0;
/// Parts of bars narrower than this have no number in them, px.
const NARROW: f64 = 14.0;

/// What the number at a bar is.
pub(crate) fn about_numbers() -> String {
    format!(
        "The number at a bar is the sum of its stages, which is more than the time where stages run side by side. Bars \
         are cut at {MOST} ms; their numbers are not."
    )
}

/// The drawing as SVG. Stages that run side by side have their own time each.
pub(crate) fn plot(outcomes: &[Outcome]) -> String {
    let height = TOP + ROW * outcomes.len() as f64 + 10.0;
    let says = "One bar for each kind of picture, made of the time of each stage in turn.";
    let says = format!("{says} {} The figures are in the table above it.", about_numbers());
    let mut svg = plot::head([WIDTH, height], "Time by stage", &says);
    for (number, name) in (1..).zip(STAGES) {
        let (x, y) = (10.0 + 150.0 * ((number - 1) % 6) as f64, 20.0 + 20.0 * ((number - 1) / 6) as f64);
        swatch(&mut svg, [x, y - 11.0, 14.0, 14.0], number);
        let _ = writeln!(svg, "<text x=\"{}\" y=\"{y}\">{number} {name}</text>", x + 20.0);
    }
    let longest = outcomes.iter().map(all).fold(1.0, f64::max).min(MOST);
    for (i, outcome) in outcomes.iter().enumerate() {
        let y = TOP + ROW * i as f64;
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
            LEFT - 8.0,
            y + 13.0,
            outcome.name.replace('&', "&amp;").replace('<', "&lt;")
        );
        let mut x = LEFT;
        for (number, name) in (1..).zip(STAGES) {
            let time = outcome.median(|run| stage(run, name)).unwrap_or(0.0);
            let width = (time / longest * LONGEST).min(LEFT + LONGEST - x).max(0.0);
            if width > 0.0 {
                swatch(&mut svg, [x, y, width, ROW - 6.0], number);
            }
            if width >= NARROW {
                let [_, fill] = grey_of(number);
                let middle = x + 0.5 * width;
                let _ = writeln!(
                    svg,
                    "<text x=\"{middle:.1}\" y=\"{}\" text-anchor=\"middle\" font-size=\"11\" fill=\"{fill}\">{number}</text>",
                    y + 12.0
                );
            }
            x += width;
        }
        let _ = writeln!(svg, "<text x=\"{:.1}\" y=\"{}\">{:.0} ms</text>", x + 6.0, y + 13.0, all(outcome));
    }
    svg + "</svg>\n"
}

/// The time of all stages.
fn all(outcome: &Outcome) -> f64 {
    STAGES.iter().filter_map(|name| outcome.median(|run| stage(run, name))).sum()
}

/// A rectangle in the grey of a stage.
fn swatch(svg: &mut String, [x, y, width, height]: [f64; 4], number: usize) {
    let [grey, _] = grey_of(number);
    let _ = writeln!(
        svg,
        "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{grey}\" stroke=\"#000\" \
         stroke-width=\"0.5\"/>"
    );
}

/// Greys in an order in which neighbours differ much, each with what is written on it.
const GREYS: [[&str; 2]; 4] = [["#fff", "#000"], ["#777", "#fff"], ["#ddd", "#000"], ["#444", "#fff"]];

/// The grey of a stage, and what is written on it.
fn grey_of(number: usize) -> [&'static str; 2] {
    GREYS[(number - 1) % GREYS.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::Run;

    #[test]
    fn a_bar_has_a_part_for_each_stage_that_took_time() {
        let said = "timings of a.jpg:\n  decode 30.0 ms\n  edges 20.0 ms\n  total 50.0 ms\n";
        let run = Run { round: 1, wall: 50.0, cpu: 50.0, peak: 1.0, said: said.into() };
        let svg = plot(&[Outcome { name: "a & b".into(), runs: Ok(vec![run]) }]);
        // one for each stage in the legend, the white ground, and the two of the bar
        assert_eq!(svg.matches("<rect").count(), STAGES.len() + 1 + 2);
        assert!(svg.contains("a &amp; b") && svg.contains(">50 ms<"), "{svg}");
    }
}
