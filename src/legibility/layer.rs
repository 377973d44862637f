//! The findings as a layer on top of the page: a box around each, with its rule and words as title, which editors show.

use std::fmt::Write;

use usvg::roxmltree::Document;

use super::finding::Finding;
use super::report::Checked;
use crate::reading::FINDINGS;
use crate::units::{MM_PER_CSS_PX, MmRect};

/// Room between what was found and the box around it, mm.
const ROOM: f32 = 1.5;

/// The SVG of a page with a layer of what was found on it; `document` is the page's own.
pub fn marked(document: &Document<'_>, checked: &Checked) -> String {
    let text = document.input_text();
    let root = document.root_element();
    // from mm to the units of the drawing
    let view: Vec<f32> = root
        .attribute("viewBox")
        .map(|view| view.split([' ', ',']).filter_map(|number| number.parse().ok()).collect())
        .unwrap_or_default();
    let mm = |length: &str| {
        let digits = length.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '%');
        let number = digits.trim().parse::<f32>().ok()?;
        Some(match &length[digits.len()..] {
            "mm" => number,
            "cm" => 10.0 * number,
            "in" => 25.4 * number,
            "pt" => number * 25.4 / 72.0,
            "" | "px" => number * MM_PER_CSS_PX,
            _ => return None,
        })
    };
    let (x, y, scale) = match (view[..].as_ref(), root.attribute("width").and_then(mm)) {
        ([x, y, width, _], Some(sheet)) if sheet > 0.0 => (*x, *y, width / sheet),
        _ => (0.0, 0.0, 1.0 / MM_PER_CSS_PX),
    };
    let mut layer = format!(
        "<g xmlns=\"http://www.w3.org/2000/svg\" \
         xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" id=\"{FINDINGS}\" inkscape:groupmode=\"layer\" \
         inkscape:label=\"Findings\" fill=\"none\" stroke=\"#d00000\" stroke-width=\"0.6\" \
         transform=\"translate({x} {y}) scale({scale})\">\n"
    );
    for finding in &checked.findings {
        if let Some(extent) = finding.extent {
            push(&mut layer, finding, extent);
        }
    }
    layer.push_str("</g>\n");
    let end = root.range().end;
    let close = text[..end].rfind("</").unwrap_or(end);
    format!("{}{layer}{}", &text[..close], &text[close..])
}

fn push(layer: &mut String, finding: &Finding, extent: MmRect) {
    let place = extent.inflate(ROOM, ROOM);
    let dashes = if finding.is_error() { "" } else { " stroke-dasharray=\"2 1\"" };
    let title = escaped(&finding.to_string());
    // Writing to a String cannot fail.
    let _ = writeln!(
        layer,
        "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" rx=\"1\" \
         inkscape:label=\"{}\"{dashes}><title>{title}</title></rect>",
        place.min.x,
        place.min.y,
        place.width(),
        place.height(),
        finding.rule.id
    );
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
