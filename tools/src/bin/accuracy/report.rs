//! Tables of figures, as Markdown and as CSV.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::condition::{Condition, PSFS};
use crate::detector::Time;
use crate::scene::Family;
use crate::sums::Sums;

/// What one detector reached.
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) time: Option<Time>,
    pub(crate) results: Vec<(Condition, BTreeMap<Family, Sums>)>,
}

/// A row of the table.
struct Figure {
    name: &'static str,
    /// What is wanted at noise 0 / 5 / 10 and point spread 0.7.
    wanted: &'static str,
    digits: usize,
    families: &'static [Family],
    value: fn(&Sums) -> f64,
}

/// Contours that are found or not: the smooth ones, corners and junctions.
const FOUND: &[Family] = &[
    Family::Straight,
    Family::SmallDisc,
    Family::LargeDisc,
    Family::Ellipse,
    Family::Sine,
    Family::Polygon,
    Family::Junction,
];
const WHOLE: &[Family] =
    &[Family::Straight, Family::SmallDisc, Family::LargeDisc, Family::Ellipse, Family::Sine, Family::Polygon];

const fn figure(
    name: &'static str,
    wanted: &'static str,
    digits: usize,
    families: &'static [Family],
    value: fn(&Sums) -> f64,
) -> Figure {
    Figure { name, wanted, digits, families, value }
}

const FIGURES: &[Figure] = &[
    figure("localisation RMS, px", ".03 / .12 / .20", 3, &Family::SMOOTH, Sums::rms),
    figure("localisation p95, px", "", 3, &Family::SMOOTH, Sums::p95),
    figure("- straight, RMS", ".012 / /", 3, &[Family::Straight], Sums::rms),
    figure("- discs r 5-30, RMS", "", 3, &[Family::SmallDisc], Sums::rms),
    figure("- discs r 45-200, RMS", "", 3, &[Family::LargeDisc], Sums::rms),
    figure("- sines, RMS", "", 3, &[Family::Sine], Sums::rms),
    figure("recall within 1 px", ".997 / .997 / .990", 4, FOUND, Sums::recall),
    figure("precision within 1 px", ".999 / .999 / .99", 4, FOUND, Sums::precision),
    figure("traced length / true length", "1", 3, &Family::SMOOTH, |s| s.right_length / s.found_length),
    figure("pieces per contour", "1.00", 2, WHOLE, |s| s.pieces / s.contours),
    figure("rings closed", "1.00", 2, WHOLE, |s| s.closed_rings / s.rings),
    figure("corner error, px", "1.0", 2, &[Family::Polygon], |s| Sums::mean(&s.corners)),
    figure("junction gap, px", ".25", 2, &[Family::Junction], |s| Sums::mean(&s.junctions)),
    figure("branch missing at junction, px", "", 2, &[Family::Junction], |s| Sums::mean(&s.branches)),
    figure("bars 1-6 px, recall", "", 3, &[Family::Bar], Sums::recall),
    figure("parallel 2-20 px, recall", "", 3, &[Family::Parallel], Sums::recall),
    figure("stairs 4-12 px, recall", "", 3, &[Family::Stair], Sums::recall),
    figure("equal luminance, recall", "1", 3, &[Family::IsoColour], Sums::recall),
    figure("strength rank correlation", ".998", 4, &[Family::Ramp], |s| Sums::mean(&s.ranks)),
    figure("smallest step found, code values", "", 0, &[Family::Ramp], Sums::smallest_step),
    figure("false px/MP, flat", "0", 0, &[Family::Flat], Sums::per_megapixel),
    figure("false px/MP, shading", "0", 0, &[Family::Shading], Sums::per_megapixel),
    figure("false px/MP, texture", "", 0, &[Family::Texture], Sums::per_megapixel),
];

/// One table: a row a measure, a column a detector, with a figure for each noise.
pub(crate) fn table(psf: f64, columns: &[Column]) -> String {
    let mut text = String::new();
    let conditions: Vec<Condition> =
        columns[0].results.iter().map(|(condition, _)| *condition).filter(|c| c.psf.total_cmp(&psf).is_eq()).collect();
    let noises: Vec<String> = conditions.iter().map(|condition| condition.label()).collect();
    let targets = psf.total_cmp(&PSFS[0]).is_eq();
    let heads: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let _ = writeln!(text, "\nPoint spread {psf} px, noise {} of 255.\n", noises.join(" / "));
    let _ = writeln!(text, "| measure | {} | wanted |", heads.join(" | "));
    let _ = writeln!(text, "|---|{}---|", "---|".repeat(heads.len()));
    for figure in FIGURES {
        let values = |column: &Column| -> Vec<String> {
            let result = |c: &Condition| column.results.iter().find(|(condition, _)| condition == c);
            conditions.iter().map(|c| result(c).map_or("-".into(), |(_, sums)| figure.text(sums))).collect()
        };
        let cells: Vec<String> = columns.iter().map(|column| values(column).join(" / ")).collect();
        let _ = writeln!(
            text,
            "| {} | {} | {} |",
            figure.name,
            cells.join(" | "),
            if targets { figure.wanted } else { "" }
        );
    }
    let times: Vec<String> = columns.iter().map(|column| time(column.time)).collect();
    let _ = writeln!(text, "| ms/MP, one thread: median (best) | {} | 45 |", times.join(" | "));
    text
}

fn time(time: Option<Time>) -> String {
    time.map_or("-".into(), |time| format!("{:.1} ({:.1})", time.median, time.best))
}

impl Figure {
    fn value(&self, by_family: &BTreeMap<Family, Sums>) -> f64 {
        (self.value)(&Sums::over(by_family, self.families))
    }

    fn text(&self, by_family: &BTreeMap<Family, Sums>) -> String {
        let value = self.value(by_family);
        if value.is_finite() { format!("{value:.*}", self.digits) } else { "-".into() }
    }
}

/// A table whose rows are kinds of scenes or single scenes, for one detector.
pub(crate) fn rows<'a>(
    name: &str,
    condition: Condition,
    rows: impl IntoIterator<Item = (&'a str, &'a Sums)>,
) -> String {
    let mut text = format!("\n{name}, point spread {} px, noise {}.\n\n", condition.psf, condition.label());
    text += "| scenes | RMS | p95 | recall | precision | pieces | closed | length | px/MP |\n";
    text += "|---|---|---|---|---|---|---|---|---|\n";
    for (row, s) in rows {
        let cells = [
            (s.rms(), 3),
            (s.p95(), 3),
            (s.recall(), 3),
            (s.precision(), 3),
            (s.pieces / s.contours, 2),
            (s.closed_rings / s.rings, 2),
            (s.right_length / s.found_length, 3),
            (s.per_megapixel(), 0),
        ]
        .map(|(value, digits)| if value.is_finite() { format!("{value:.digits$}") } else { "-".into() });
        let _ = writeln!(text, "| {row} | {} |", cells.join(" | "));
    }
    text
}

/// Every figure on a line of its own.
pub(crate) fn csv(columns: &[Column]) -> String {
    let mut text = String::from("detector,psf_px,noise,per_channel,measure,value\n");
    for column in columns {
        for (condition, by_family) in &column.results {
            let Condition { psf, noise, per_channel } = condition;
            for figure in FIGURES {
                let value = figure.value(by_family);
                let _ = writeln!(text, "{},{psf},{noise},{per_channel},\"{}\",{value}", column.name, figure.name);
            }
        }
        if let Some(time) = column.time {
            let _ = writeln!(text, "{},,,,ms per megapixel median,{}", column.name, time.median);
            let _ = writeln!(text, "{},,,,ms per megapixel best,{}", column.name, time.best);
        }
    }
    text
}
