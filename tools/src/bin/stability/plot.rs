//! The table of lines as a plot: a column of marks for each change.

use std::fmt::Write as _;

use tactograph_tools::plot;

use crate::Changed;

/// Left, top, right and bottom of the area.
const AREA: [f64; 4] = [70.0, 30.0, 690.0, 330.0];
/// Shares below this are drawn here: on paper nothing has changed.
const LEAST: f64 = 0.0005;

/// All changes across, shares of lines up on a logarithmic axis.
pub(crate) fn plot(names: &[String], rows: &[(&str, &[Changed])]) -> String {
    let [left, top, right, bottom] = AREA;
    let mut svg = plot::head(
        [720.0, 380.0],
        "How much pages change",
        "For each small change of a picture, the share of the lines that changed, one mark a picture. The table says the same.",
    );
    let up = |share: f64| bottom - (bottom - top) * (share.max(LEAST) / LEAST).ln() / (1.0 / LEAST).ln();
    for share in [0.001, 0.01, 0.05, 0.1, 0.5, 1.0] {
        let y = up(share);
        let _ = writeln!(
            svg,
            "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#bbb\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{} %</text>",
            left - 6.0,
            y + 4.0,
            100.0 * share
        );
    }
    let step = (right - left) / names.len() as f64;
    for (i, name) in names.iter().enumerate() {
        let x = left + (i as f64 + 0.5) * step;
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{name}</text>",
            bottom + 1.6 * plot::LINE
        );
        for (j, (picture, changes)) in rows.iter().enumerate() {
            let x = x + (j as f64 / (rows.len() - 1).max(1) as f64 - 0.5) * 0.6 * step;
            let y = up(changes[i].lines);
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\"><title>{picture}, {name}: {:.3}</title></circle>",
                changes[i].lines
            );
        }
    }
    svg + "</svg>\n"
}
