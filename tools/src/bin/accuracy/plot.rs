//! A drawing of run time against error, both on logarithmic axes: black on white, and told apart by shape, not by colour.

use std::fmt::Write as _;

use tactograph_tools::plot::{self, Axis, Labels, Panel};

/// A detector in the drawing.
pub(crate) struct Dot {
    pub(crate) name: String,
    /// Milliseconds per megapixel, RMS error in px.
    pub(crate) at: [f64; 2],
    /// Ours are full, others' empty.
    pub(crate) ours: bool,
    /// Whether nothing of ours beats it in both.
    pub(crate) best: bool,
}

const SIZE: [f64; 2] = [760.0, 520.0];
/// Left, top, right and bottom of the area of the dots.
const AREA: [f64; 4] = [80.0, 56.0, 736.0, 456.0];

/// The drawing as SVG.
pub(crate) fn plot(dots: &[Dot]) -> String {
    let panel = Panel { area: AREA, axes: [0, 1].map(|axis| Axis::around(dots.iter().map(|dot| dot.at[axis]))) };
    let place = |at| panel.place(at);
    let mut svg = head();
    panel.grid(&mut svg, &["1", "2", "3", "5", "7"]);
    let mut front: Vec<[f64; 2]> = dots.iter().filter(|dot| dot.best).map(|dot| place(dot.at)).collect();
    front.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let front: Vec<String> = front.iter().map(|at| format!("{:.1},{:.1}", at[0], at[1])).collect();
    let _ =
        writeln!(svg, "<polyline points=\"{}\" fill=\"none\" stroke=\"#000\" stroke-width=\"1.4\"/>", front.join(" "));
    for dot in dots {
        let [x, y] = place(dot.at);
        let _ = if dot.ours {
            writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{}\"/>", if dot.best { 4.5 } else { 2.5 })
        } else {
            writeln!(
                svg,
                "<path d=\"M{:.1} {:.1}h8v8h-8z\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"1.4\"/>",
                x - 4.0,
                y - 4.0
            )
        };
    }
    let mut labels = Labels::beside(dots.iter().map(|dot| place(dot.at)), AREA[2], f64::MIN..f64::MAX);
    for dot in dots.iter().filter(|dot| dot.best || !dot.ours) {
        labels.add(&mut svg, &dot.name, place(dot.at), "");
    }
    svg + "</svg>\n"
}

fn head() -> String {
    let height = SIZE[1];
    let [left, top, right, bottom] = AREA;
    let (across, down) = (0.5 * (left + right), 0.5 * (top + bottom));
    let title = "Run time against error of edges";
    let description = "Across: milliseconds per megapixel of the source, one thread. Up: root of the mean square distance of \
        traced lines from the true contours in pixels of the source, noise 5 of 255. Full dots: tactograph, labelled with \
        source pixels per working pixel : scale in working pixels; the line joins those that no other of them beats in \
        both. Empty squares: other detectors. The figures are in sweep.csv.";
    plot::head(SIZE, title, description)
        + &format!(
            "<text x=\"{left}\" y=\"22\" font-size=\"14\">Run time against error (blur 0.7 px, noise 5 of 255)</text>\n\
             <text x=\"{left}\" y=\"41\">full: tactograph, source px per working px : scale in working px; empty: other \
             detectors</text>\n\
             <rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#000\"/>\n\
             <text x=\"{across}\" y=\"{}\" text-anchor=\"middle\">time, ms per megapixel of the source, one thread</text>\n\
             <text transform=\"translate(24 {down}) rotate(-90)\" text-anchor=\"middle\">error of place (RMS), px of the \
             source</text>\n",
            right - left,
            bottom - top,
            height - 18.0
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dot_is_inside_and_the_drawing_is_well_formed() {
        let dot =
            |name: &str, time: f64, error: f64, ours| Dot { name: name.into(), at: [time, error], ours, best: ours };
        let svg = plot(&[
            dot("1.0 : 1.5", 40.0, 0.12, true),
            dot("2.0 : 1.0", 9.0, 0.3, true),
            dot("canny", 20.0, 0.3, false),
        ]);
        let tree = roxmltree::Document::parse(&svg).unwrap();
        for circle in tree.descendants().filter(|node| node.has_tag_name("circle")) {
            let number = |name| circle.attribute(name).unwrap().parse::<f64>().unwrap();
            assert!((AREA[0]..AREA[2]).contains(&number("cx")) && (AREA[1]..AREA[3]).contains(&number("cy")));
        }
        let words: Vec<&str> = tree.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text()).collect();
        assert!(["1.0 : 1.5", "2.0 : 1.0", "canny", "0.2", "10"].iter().all(|word| words.contains(word)), "{words:?}");
    }
}
