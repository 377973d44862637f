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
    better: Better,
    families: &'static [Family],
    value: fn(&Sums) -> f64,
}

/// Which values of a figure are better than others.
#[derive(Debug, Clone, Copy)]
enum Better {
    More,
    Less,
    NearOne,
}
use Better::{Less, More, NearOne};

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
    better: Better,
    families: &'static [Family],
    value: fn(&Sums) -> f64,
) -> Figure {
    Figure { name, wanted, digits, better, families, value }
}

const FIGURES: &[Figure] = &[
    figure("localisation RMS, px", ".03 / .12 / .20", 3, Less, &Family::SMOOTH, Sums::rms),
    figure("localisation p95, px", "", 3, Less, &Family::SMOOTH, Sums::p95),
    figure("- straight, RMS", ".012 / /", 3, Less, &[Family::Straight], Sums::rms),
    figure("- discs r 5-30, RMS", "", 3, Less, &[Family::SmallDisc], Sums::rms),
    figure("- discs r 45-200, RMS", "", 3, Less, &[Family::LargeDisc], Sums::rms),
    figure("- sines, RMS", "", 3, Less, &[Family::Sine], Sums::rms),
    figure("recall within 1 px", ".997 / .997 / .990", 4, More, FOUND, Sums::recall),
    figure("precision within 1 px", ".999 / .999 / .99", 4, More, FOUND, Sums::precision),
    figure("traced length / true length", "1", 3, NearOne, &Family::SMOOTH, |s| s.right_length / s.found_length),
    figure("pieces per contour", "1.00", 2, NearOne, WHOLE, |s| s.pieces / s.contours),
    figure("rings closed", "1.00", 2, More, WHOLE, |s| s.closed_rings / s.rings),
    figure("corner error, px", "1.0", 2, Less, &[Family::Polygon], |s| Sums::mean(&s.corners)),
    figure("junction gap, px", ".25", 2, Less, &[Family::Junction], |s| Sums::mean(&s.junctions)),
    figure("branch missing at junction, px", "", 2, Less, &[Family::Junction], |s| Sums::mean(&s.branches)),
    figure("bars 1-6 px, recall", "", 3, More, &[Family::Bar], Sums::recall),
    figure("parallel 2-20 px, recall", "", 3, More, &[Family::Parallel], Sums::recall),
    figure("stairs 4-12 px, recall", "", 3, More, &[Family::Stair], Sums::recall),
    figure("equal luminance, recall", "1", 3, More, &[Family::IsoColour], Sums::recall),
    figure("strength rank correlation", ".998", 4, More, &[Family::Ramp], |s| Sums::mean(&s.ranks)),
    figure("smallest step found, code values", "", 0, Less, &[Family::Ramp], Sums::smallest_step),
    figure("false px/MP, flat", "0", 0, Less, &[Family::Flat], Sums::per_megapixel),
    figure("false px/MP, shading", "0", 0, Less, &[Family::Shading], Sums::per_megapixel),
    figure("false px/MP, texture", "", 0, Less, &[Family::Texture], Sums::per_megapixel),
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

/// The figures that are worse in one column than in another one, to the digits of the table.
pub(crate) fn worse(psf: f64, column: &Column, than: &Column) -> String {
    let mut rows = String::new();
    for figure in FIGURES {
        for (condition, other) in than.results.iter().filter(|(c, _)| c.psf.total_cmp(&psf).is_eq()) {
            let Some((_, own)) = column.results.iter().find(|(c, _)| c == condition) else { continue };
            if figure.fault(own) > figure.fault(other) {
                let [noise, own, other] = [condition.label(), figure.text(own), figure.text(other)];
                let _ = writeln!(rows, "| {} | {noise} | {own} | {other} |", figure.name);
            }
        }
    }
    let [name, than] = [&column.name, &than.name];
    if rows.is_empty() {
        return format!("\nNo figure of {name} is worse than that of {than}.\n");
    }
    format!(
        "\nThese are worse of {name} than of {than}:\n\n| measure | noise | {name} | {than} |\n|---|---|---|---|\n{rows}"
    )
}

fn time(time: Option<Time>) -> String {
    time.map_or("-".into(), |time| format!("{:.1} ({:.1})", time.median, time.best))
}

impl Figure {
    fn value(&self, by_family: &BTreeMap<Family, Sums>) -> f64 {
        (self.value)(&Sums::over(by_family, self.families))
    }

    /// How bad the value is, in units of its last digit in the table.
    fn fault(&self, by_family: &BTreeMap<Family, Sums>) -> f64 {
        let one = 10_f64.powi(self.digits as i32);
        let value = (one * self.value(by_family)).round();
        match self.better {
            More => -value,
            Less => value,
            NearOne => (value - one).abs(),
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::condition::TIMED;

    /// A detector that found so much of 1000 px, and so much in a megapixel where there is nothing.
    fn column(name: &str, found: f64, wrong: f64) -> Column {
        let lengths = Sums { true_length: 1000.0, found_length: found, right_length: 1000.0, ..Sums::default() };
        let texture = Sums { all_length: wrong, area: 1e6, ..Sums::default() };
        let by_family = BTreeMap::from([(Family::Straight, lengths), (Family::Texture, texture)]);
        Column { name: name.into(), time: None, results: vec![(TIMED, by_family)] }
    }

    #[test]
    fn what_is_worse_is_named_and_what_the_table_does_not_show_is_not() {
        let worse = |found: f64, wrong: f64| worse(TIMED.psf, &column("a", found, wrong), &column("b", 990.0, 600.0));
        for (found, wrong) in [(990.0, 600.0), (995.0, 500.0), (989.99, 600.4)] {
            assert_eq!(worse(found, wrong), "\nNo figure of a is worse than that of b.\n", "{found} {wrong}");
        }
        let rows = [
            "| recall within 1 px | 5 | 0.9800 | 0.9900 |",
            "| traced length / true length | 5 | 1.020 | 1.010 |",
            "| false px/MP, texture | 5 | 700 | 600 |",
        ];
        let told = worse(980.0, 700.0);
        assert_eq!(told.lines().filter(|line| line.contains("| 5 |")).collect::<Vec<_>>(), rows, "{told}");
    }
}
