//! Drawings of one number against another on logarithmic axes, as SVG: black on white.

use std::fmt::Write as _;
use std::ops::Range;

/// A point of the drawing, x to the right and y down, in its own units.
pub type At = [f64; 2];

/// Height of a line of small text; labels keep this far apart.
pub const LINE: f64 = 13.0;
/// Width of a digit of small text, at most.
const DIGIT: f64 = 7.0;

/// The beginning of the document: its size, its title and description for screen readers, and a white ground.
pub fn head([width, height]: [f64; 2], title: &str, description: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\" role=\"img\" aria-labelledby=\"title desc\">\n\
         <title id=\"title\">{title}</title>\n\
         <desc id=\"desc\">{description}</desc>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    )
}

/// A logarithmic axis.
#[derive(Debug, Clone, Copy)]
pub struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    /// An axis that holds these values, with a little more at both ends; values that are not above 0 have no place.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        let wanted = values.filter(|value| *value > 0.0);
        let [low, high] = wanted.fold([f64::MAX, f64::MIN], |[low, high], v| [low.min(v), high.max(v)]);
        if low > high {
            return Self { low: 1.0, high: 10.0 };
        }
        Self { low: low / 1.25, high: high * 1.25 }
    }

    /// Where a value lies, 0 at the low end and 1 at the high one.
    fn share(&self, value: f64) -> f64 {
        (value / self.low).ln() / (self.high / self.low).ln()
    }

    /// These digits times the powers of ten, as far as they lie on the axis.
    fn marks(&self, digits: &[&str]) -> Vec<f64> {
        let all = (-4..6).flat_map(|power: i32| digits.iter().map(move |digit| format!("{digit}e{power}")));
        all.filter_map(|text| text.parse().ok()).filter(|mark| (self.low..self.high).contains(mark)).collect()
    }
}

/// The area of a plot, with an axis across and one up.
#[derive(Debug, Clone, Copy)]
pub struct Panel {
    /// Left, top, right and bottom.
    pub area: [f64; 4],
    /// The axis across and the axis up.
    pub axes: [Axis; 2],
}

impl Panel {
    /// Where a pair of values lies.
    pub fn place(&self, at: At) -> At {
        let [left, top, right, bottom] = self.area;
        let [across, up] = &self.axes;
        [left + across.share(at[0]) * (right - left), bottom - up.share(at[1]) * (bottom - top)]
    }

    /// Grey lines with numbers at these digits times the powers of ten.
    pub fn grid(&self, svg: &mut String, digits: &[&str]) {
        let [left, top, right, bottom] = self.area;
        let [across, up] = &self.axes;
        let line = |svg: &mut String, path: String| {
            let _ = writeln!(svg, "<path d=\"{path}\" stroke=\"#bbb\" stroke-width=\"0.6\"/>");
        };
        let mut free_from = f64::MIN;
        for mark in across.marks(digits) {
            let x = self.place([mark, up.low])[0];
            line(svg, format!("M{x:.1} {top}V{bottom}"));
            let half = 0.5 * DIGIT * mark.to_string().len() as f64;
            // a number that would run into the one before it is left out
            if x - half >= free_from {
                let y = bottom + 18.0;
                let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{mark}</text>");
                free_from = x + half + DIGIT;
            }
        }
        for mark in up.marks(digits) {
            let y = self.place([across.low, mark])[1];
            line(svg, format!("M{left} {y:.1}H{right}"));
            let (x, y) = (left - 8.0, y + 4.0);
            let _ = writeln!(svg, "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"end\">{mark}</text>");
        }
    }
}

/// Labels beside dots, moved up or down until they are free of one another.
#[derive(Debug, Clone)]
pub struct Labels {
    /// Left, right and baseline of what is there.
    taken: Vec<[f64; 3]>,
    right: f64,
    baselines: Range<f64>,
}

impl Labels {
    /// For dots at these places, each of which takes as much as a letter. Labels that would reach beyond `right` lie to
    /// the left of their dot; baselines lie within `baselines`.
    pub fn beside(dots: impl Iterator<Item = At>, right: f64, baselines: Range<f64>) -> Self {
        Self { taken: dots.map(|[x, y]| [x - 4.0, x + 4.0, y + 4.0]).collect(), right, baselines }
    }

    /// Writes a label beside the dot at this place, unless there is no free place near it. `attributes` are those of the
    /// text element, with a space after each.
    pub fn add(&mut self, svg: &mut String, name: &str, [x, y]: At, attributes: &str) {
        let width = 6.6 * name.len() as f64; // a generous mean of a sans serif of 12
        let left = if x + 9.0 + width > self.right { x - 9.0 - width } else { x + 9.0 };
        let is_free = |baseline: &f64| {
            let apart = |t: &[f64; 3]| left > t[1] || left + width < t[0] || (baseline - t[2]).abs() >= LINE;
            self.baselines.contains(baseline) && self.taken.iter().all(apart)
        };
        let mut tries = (0..20).flat_map(|k| [y + 4.0 - f64::from(k) * 4.0, y + 4.0 + f64::from(k) * 4.0]);
        let Some(baseline) = tries.find(is_free) else { return };
        self.taken.push([left, left + width, baseline]);
        // a white seam keeps a line behind the letters from them
        let seam = "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";
        let _ = writeln!(svg, "<text x=\"{left:.1}\" y=\"{baseline:.1}\" {attributes}{seam}>{name}</text>");
    }
}
