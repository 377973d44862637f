//! A drawing of run time against error, both on logarithmic axes: black on white, and told apart by shape, not by colour.

use std::fmt::Write as _;

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
/// Height of a line of small text; labels keep this far apart.
const LINE: f64 = 13.0;

/// The drawing as SVG.
pub(crate) fn plot(dots: &[Dot]) -> String {
    let axes = [0, 1].map(|axis| Axis::around(dots.iter().map(|dot| dot.at[axis])));
    let place = |at: [f64; 2]| {
        [AREA[0] + axes[0].share(at[0]) * (AREA[2] - AREA[0]), AREA[3] - axes[1].share(at[1]) * (AREA[3] - AREA[1])]
    };
    let mut svg = head();
    for (axis, range) in axes.iter().enumerate() {
        for mark in range.marks() {
            let at = place(if axis == 0 { [mark, axes[1].low] } else { [axes[0].low, mark] });
            let (line, text) = if axis == 0 {
                (
                    format!("M{:.1} {}V{}", at[0], AREA[1], AREA[3]),
                    format!("x=\"{:.1}\" y=\"{}\"", at[0], AREA[3] + 18.0),
                )
            } else {
                (
                    format!("M{} {:.1}H{}", AREA[0], at[1], AREA[2]),
                    format!("x=\"{}\" y=\"{:.1}\"", AREA[0] - 8.0, at[1] + 4.0),
                )
            };
            let anchor = if axis == 0 { "middle" } else { "end" };
            let _ = writeln!(svg, "<path d=\"{line}\" stroke=\"#bbb\" stroke-width=\"0.6\"/>");
            let _ = writeln!(svg, "<text {text} text-anchor=\"{anchor}\">{mark}</text>");
        }
    }
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
    labels(&mut svg, dots, place);
    svg + "</svg>\n"
}

fn head() -> String {
    let [width, height] = SIZE;
    let [left, top, right, bottom] = AREA;
    let (across, down) = (0.5 * (left + right), 0.5 * (top + bottom));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\" role=\"img\" aria-labelledby=\"title desc\">\n\
         <title id=\"title\">Run time against error of edges</title>\n\
         <desc id=\"desc\">Across: milliseconds per megapixel of the source, one thread. Up: root of the mean square \
         distance of traced lines from the true contours in pixels of the source, noise 5 of 255. Full dots: tactograph, \
         labelled with source pixels per working pixel : scale in working pixels; the line joins those that no other of \
         them beats in both. Empty squares: other detectors. The figures are in sweep.csv.</desc>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <text x=\"{left}\" y=\"22\" font-size=\"14\">Run time against error (blur 0.7 px, noise 5 of 255)</text>\n\
         <text x=\"{left}\" y=\"41\">full: tactograph, source px per working px : scale in working px; empty: other detectors</text>\n\
         <rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#000\"/>\n\
         <text x=\"{across}\" y=\"{}\" text-anchor=\"middle\">time, ms per megapixel of the source, one thread</text>\n\
         <text transform=\"translate(24 {down}) rotate(-90)\" text-anchor=\"middle\">error of place (RMS), px of the source</text>\n",
        right - left,
        bottom - top,
        height - 18.0
    )
}

/// Labels beside the best and the others' dots, moved up or down until they are free of one another.
fn labels(svg: &mut String, dots: &[Dot], place: impl Fn([f64; 2]) -> [f64; 2]) {
    // left, right and baseline; a dot takes the room of a letter
    let letter = |[x, y]: [f64; 2]| [x - 4.0, x + 4.0, y + 4.0];
    let mut taken: Vec<[f64; 3]> = dots.iter().map(|dot| letter(place(dot.at))).collect();
    for dot in dots.iter().filter(|dot| dot.best || !dot.ours) {
        let [x, y] = place(dot.at);
        let width = 6.6 * dot.name.len() as f64; // a generous mean of a sans serif of 12
        let left = if x + 9.0 + width > AREA[2] { x - 9.0 - width } else { x + 9.0 };
        let free =
            |baseline: f64| taken.iter().all(|t| left > t[1] || left + width < t[0] || (baseline - t[2]).abs() >= LINE);
        // a white seam keeps a line behind the letters from them
        let seam = "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";
        let tries = (0..20).flat_map(|k| [y + 4.0 - f64::from(k) * 4.0, y + 4.0 + f64::from(k) * 4.0]);
        let Some(baseline) = tries.into_iter().find(|&baseline| free(baseline)) else { continue };
        taken.push([left, left + width, baseline]);
        let _ = writeln!(svg, "<text x=\"{left:.1}\" y=\"{baseline:.1}\" {seam}>{}</text>", dot.name);
    }
}

/// A logarithmic axis.
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let [low, high] = values.fold([f64::MAX, f64::MIN], |[low, high], v| [low.min(v), high.max(v)]);
        if low > high {
            return Self { low: 1.0, high: 10.0 };
        }
        Self { low: low / 1.25, high: high * 1.25 }
    }

    fn share(&self, value: f64) -> f64 {
        (value / self.low).ln() / (self.high / self.low).ln()
    }

    /// 1, 2, 3, 5 and 7 times the powers of ten.
    fn marks(&self) -> Vec<f64> {
        let all = (-4..6).flat_map(|power: i32| [1, 2, 3, 5, 7].map(|digit| format!("{digit}e{power}")));
        all.filter_map(|text| text.parse().ok()).filter(|mark| (self.low..self.high).contains(mark)).collect()
    }
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
