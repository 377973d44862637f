//! Where things lie on the sheet.
//!
//! ```text
//!  +--------- sheet ----------+
//!  |  margin                \ |   The orientation mark cuts the top right corner of what can be printed.
//!  |   ::::::: frame :::::::  |   The frames hug the pictures, so that a finger on the frame
//!  |   ::  gap             :: |   knows the picture's shape.
//!  |   ::    figure        :: |
//!  |   ::                  :: |
//!  |   :::::::::::::::::::::: |
//!  |      substantial gap     |
//!  |        ::::::::::::      |
//!  |        :: overview::     |
//!  |        ::::::::::::      |
//!  +--------------------------+
//! ```

use super::cells::CellGrid;
use super::dot_layout;
use super::heading::Heading;
use super::medium::{DotMedium, Medium, MediumParams, Print};
use super::sheet::{Sheet, beside};
use crate::devices::Device;
use crate::units::MmRect;

pub use super::sheet::{FrameParams, Layout, MarkParams, Orientation, OverviewParams, Params};

/// Lays out a picture whose width is `aspect` times its height, as large as the sheet allows but not wider than
/// `widest`, centred from left to right and beginning at the top margin, or as far below it as the orientation mark
/// needs.
pub fn fit(aspect: f32, widest: f32, params: &Params) -> Layout {
    let [a, b] = params.sheet;
    let upright = [a.min(b), a.max(b)];
    match params.medium {
        MediumParams::Print(print) => fit_print(aspect, widest, upright, params, print),
        MediumParams::Dots { device, pitch } => fit_dots(aspect, widest, upright, params, (device, pitch)),
    }
}

fn fit_print(aspect: f32, widest: f32, [short, long]: [f32; 2], params: &Params, print: Print) -> Layout {
    let on = |size: [f32; 2]| {
        let heading = params.heading.and_then(|heading| {
            let cells = CellGrid::printed(heading.cell);
            Heading::on(&heading, &cells, size, params.margin, beside(params.mark, &cells))
        });
        (Sheet::new(size, params, heading.as_ref()), heading)
    };
    let (upright, across) = (on([short, long]), on([long, short]));
    let (sheet, heading) = match params.orientation {
        Orientation::Portrait => upright,
        Orientation::Landscape => across,
        Orientation::Auto if across.0.figure_width(aspect) > upright.0.figure_width(aspect) => across,
        Orientation::Auto => upright,
    };
    let at = sheet.lay_out(aspect, sheet.figure_width(aspect).min(widest));
    let medium = Medium::Print(print);
    let (figure, room) = (at.figure, at.figure);
    let (overview, mark) = (at.overview, at.mark);
    Layout { sheet: sheet.size, figure, room, overview, mark, heading, medium, sheets: None }
}

/// The same for dots. On a sheet that the device takes in none of the orientations allowed, the figure is empty.
fn fit_dots(
    aspect: f32,
    widest: f32,
    [short, long]: [f32; 2],
    params: &Params,
    (device, pitch): (&'static Device, f32),
) -> Layout {
    let orientations = match params.orientation {
        Orientation::Portrait => &[[short, long]][..],
        Orientation::Landscape => &[[long, short]],
        Orientation::Auto => &[[short, long], [long, short]],
    };
    let on_sheet = |&size: &[f32; 2]| {
        let medium = DotMedium::on(device, pitch, size).ok()?;
        Some(dot_layout::fit(aspect, widest, size, params, medium))
    };
    let larger = |a: Layout, b: Layout| if b.figure.width() > a.figure.width() { b } else { a };
    orientations.iter().filter_map(on_sheet).reduce(larger).unwrap_or_else(|| Layout {
        sheet: orientations[0],
        figure: MmRect::zero(),
        room: MmRect::zero(),
        overview: None,
        mark: None,
        heading: None,
        medium: Medium::Dots(DotMedium::without_dots(device, pitch)),
        sheets: None,
    })
}

#[cfg(test)]
mod tests;
