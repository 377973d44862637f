//! A drawing of run time against error, both on logarithmic axes: black on white, and told apart by shape, not by colour.

use std::fmt::Write as _;

use tactograph_tools::plot::{self, Axis, LINE, Labels, Panel};

use crate::rows::{DEFAULT_SCALE, Row, SCALES, Setting, is_same, mean_errors, settings};

/// A way to work in the drawing.
struct Dot {
    setting: Setting,
    /// Milliseconds, error in mm.
    at: [f64; 2],
}

/// Width and height of the whole drawing.
const SIZE: [f64; 2] = [900.0, 470.0];
/// Left edges and width of the two panels, their top and bottom.
const LEFTS: [f64; 2] = [76.0, 506.0];
const WIDTH: f64 = 376.0;
const TOP: f64 = 84.0;
const BOTTOM: f64 = 408.0;

/// The drawing as SVG.
pub(crate) fn plot(rows: &[Row]) -> String {
    let mut svg = head();
    let panels: [(&str, Vec<&Row>); 2] = [
        ("Drawn scenes, error against what was drawn", rows.iter().filter(|row| row.is_scene).collect()),
        ("Photo, error against 12 px/mm", rows.iter().filter(|row| row.picture == "photo-12").collect()),
    ];
    for ((title, of), left) in panels.into_iter().zip(LEFTS) {
        let dots: Vec<Dot> = settings(rows)
            .into_iter()
            .map(|setting| (setting, of.iter().copied().filter(|row| row.setting == setting).collect::<Vec<_>>()))
            .filter(|(_, of)| !of.is_empty())
            .map(|(setting, of)| {
                let ms = of.iter().map(|row| row.all()).sum::<f64>() / of.len() as f64;
                Dot { setting, at: [ms, mean_errors(&of).rms] }
            })
            .collect();
        panel(&mut svg, title, left, &dots);
    }
    svg + "</svg>\n"
}

fn panel(svg: &mut String, title: &str, left: f64, dots: &[Dot]) {
    let axes = [0, 1].map(|axis| Axis::around(dots.iter().map(|dot| dot.at[axis])));
    let panel = Panel { area: [left, TOP, left + WIDTH, BOTTOM], axes };
    let place = |at| panel.place(at);
    let _ = writeln!(svg, "<text x=\"{left}\" y=\"{}\" font-size=\"13\">{title}</text>", TOP - 10.0);
    panel.grid(svg, &["1", "1.5", "2", "3", "5", "7"]);
    let height = BOTTOM - TOP;
    let _ = writeln!(
        svg,
        "<rect x=\"{left}\" y=\"{TOP}\" width=\"{WIDTH}\" height=\"{height}\" fill=\"none\" stroke=\"#000\"/>"
    );
    for (scale, dash) in SCALES.iter().zip(["2 3", "none", "7 4"]) {
        let of: Vec<String> = dots
            .iter()
            .filter(|dot| is_same(dot.setting.scale, *scale) && dot.setting.eighths.is_none())
            .map(|dot| place(dot.at).map(|v| format!("{v:.1}")).join(","))
            .collect();
        let of = of.join(" ");
        let _ = writeln!(
            svg,
            "<polyline points=\"{of}\" fill=\"none\" stroke=\"#000\" stroke-width=\"1.2\" stroke-dasharray=\"{dash}\"/>"
        );
    }
    for dot in dots {
        mark(svg, dot.setting, place(dot.at));
    }
    let mut labels = Labels::beside(dots.iter().map(|dot| place(dot.at)), left + WIDTH, TOP + LINE..BOTTOM - 2.0);
    // crosses lie together where a name would stand far from its own
    let full = |dot: &&Dot| is_same(dot.setting.scale, DEFAULT_SCALE) && dot.setting.eighths.is_none();
    for dot in dots.iter().filter(full) {
        labels.add(svg, &dot.setting.resolution.to_string(), place(dot.at), "font-weight=\"bold\" ");
    }
}

/// The default scale is a full dot, a smaller one a triangle, a larger one a square; where the fraction of a JPEG is
/// given, a cross.
fn mark(svg: &mut String, setting: Setting, [x, y]: [f64; 2]) {
    let outline = "fill=\"#fff\" stroke=\"#000\" stroke-width=\"1.3\"";
    let _ = match setting {
        Setting { eighths: Some(_), .. } => {
            let (x, y) = (x - 4.0, y - 4.0);
            writeln!(svg, "<path d=\"M{x:.1} {y:.1}l8 8m0 -8l-8 8\" stroke=\"#000\" stroke-width=\"1.6\"/>")
        }
        Setting { scale, .. } if is_same(scale, DEFAULT_SCALE) => {
            writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"/>")
        }
        Setting { scale, .. } if scale < DEFAULT_SCALE => {
            writeln!(svg, "<path d=\"M{x:.1} {:.1}l4.5 8h-9z\" {outline}/>", y - 5.0)
        }
        _ => writeln!(svg, "<path d=\"M{:.1} {:.1}h7v7h-7z\" {outline}/>", x - 3.5, y - 3.5),
    };
}

fn head() -> String {
    let down = 0.5 * (TOP + BOTTOM);
    let title = "Run time against error on the page";
    let [finer, usual, coarser] = SCALES;
    let description = format!(
        "Two panels. Across: milliseconds of one core for a page of a picture of 9 to 12 megapixels. Up: root of \
        the mean square distance of lines from where they should be, in millimetres on the page. Left, drawn scenes whose \
        outlines are known; right, a photo-like picture beside its page at 12 px for a millimetre. Labels are pixels for a \
        millimetre of the page. Full dots, joined by a line: edges at a scale of {usual} mm; triangles {finer} mm, squares \
        {coarser} mm; crosses: a JPEG decoded at an eighth, a quarter, half or all of its size, and handed over as pixels. \
        The figures are in knee.csv."
    );
    let mut svg = plot::head(SIZE, title, &description)
        + &format!(
            "<text x=\"{0}\" y=\"22\" font-size=\"14\">Run time against error on an A4 page, pictures of 9 to 12 \
             megapixels</text>\n\
             <text x=\"{0}\" y=\"44\">labels: px for a mm of the page; full dots: edges at a scale of {usual} mm; triangles: \
             {finer} mm; squares: {coarser} mm;</text>\n\
             <text x=\"{0}\" y=\"60\">crosses: JPEG decoded at 1/8, 2/8, 4/8 or 8/8 of its size, and handed over as pixels</text>\n\
             <text transform=\"translate(22 {down}) rotate(-90)\" text-anchor=\"middle\">distance of lines (RMS), mm on \
             the page</text>\n",
            LEFTS[0],
        );
    for left in LEFTS {
        let (x, y) = (left + 0.5 * WIDTH, SIZE[1] - 20.0);
        let _ = writeln!(svg, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">time, ms of one core</text>");
    }
    svg
}
