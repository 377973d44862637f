//! The picture of a row: a picture beside its pages, as they are and blurred by a fingertip.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

use base64::Engine;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{self, Options, Tree};

use crate::Fault;
use crate::pages::{Made, Page};

/// Blank between the parts of a row, mm.
pub(crate) const GAP: f32 = 6.0;
/// Width and height of the picture itself, mm; pages have the size that they have on the sheet.
pub(crate) const PICTURE: f32 = 180.0;
/// Sigma of the fingertip, mm.
const FINGERTIP: f32 = 1.0;

/// Draws the row of a picture. `widths` are those of the columns of each program, mm.
pub(crate) fn draw(picture: &Path, made: &[Made], widths: &[f32], per_mm: f32) -> Result<Pixmap, Fault> {
    let mut content = image(picture)?;
    let (mut across, mut down) = (PICTURE + GAP, PICTURE);
    for (made, width) in made.iter().zip(widths) {
        let mut y = 0.0;
        for page in made.pages.iter().flatten() {
            y = columns(page, [across, y], width + GAP, &mut content)?;
        }
        down = down.max(y);
        across += 2.0 * (width + GAP);
    }
    let row = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{across}\" \
         height=\"{down}\"><defs><filter id=\"finger\" filterUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"1000\" \
         height=\"1000\" color-interpolation-filters=\"sRGB\"><feGaussianBlur stdDeviation=\"{FINGERTIP}\"/></filter>\
         </defs>{content}</svg>"
    );
    rendered(&row, per_mm)
}

/// A picture as it is, in its square.
fn image(picture: &Path) -> Result<String, Fault> {
    let bytes = std::fs::read(picture)?;
    let kind = match &bytes[..] {
        [0xff, 0xd8, ..] => "jpeg",
        [0x89, b'P', ..] => "png",
        [b'G', b'I', b'F', ..] => "gif",
        [b'R', b'I', b'F', b'F', ..] => "webp",
        _ => "svg+xml",
    };
    Ok(embedded(kind, &bytes, &format!("width=\"{PICTURE}\" height=\"{PICTURE}\" preserveAspectRatio=\"xMidYMin\"")))
}

fn embedded(kind: &str, bytes: &[u8], place: &str) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    format!("<image {place} xlink:href=\"data:image/{kind};base64,{data}\"/>")
}

/// Puts a page's figure and overview from a place on, sharp and, by `step` further to the right, blurred. Returns how
/// far down they reach, with the gap below them, mm.
fn columns(page: &Page, [across, mut y]: [f32; 2], step: f32, content: &mut String) -> Result<f32, Fault> {
    let [width, height] = page.size;
    let whole = embedded("svg+xml", page.svg.as_bytes(), &format!("width=\"{width}\" height=\"{height}\""));
    for [left, top, wide, high] in &page.parts {
        for (x, filter) in [(across, ""), (across + step, " filter=\"url(#finger)\"")] {
            write!(
                content,
                "<svg x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" viewBox=\"{left} {top} {wide} {high}\"><g\
                 {filter}>{whole}</g></svg>"
            )?;
        }
        y += high + GAP;
    }
    Ok(y)
}

fn rendered(svg: &str, per_mm: f32) -> Result<Pixmap, Fault> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_system_fonts();
    let tree = Tree::from_str(svg, &Options { fontdb: Arc::new(fonts), ..Options::default() })?;
    let side = |side: f32| (side * per_mm).round().max(1.0) as u32;
    let mut canvas = Pixmap::new(side(tree.size().width()), side(tree.size().height()))
        .ok_or("it is too large for a picture; --per-mm makes it smaller")?;
    canvas.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(per_mm, per_mm), &mut canvas.as_mut());
    Ok(canvas)
}
