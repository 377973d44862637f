//! Where things lie on the sheet.
//!
//! ```text
//!  +--------- sheet ----------+
//!  |  margin                  |
//!  |   ::::::: frame :::::::  |   The frames hug the pictures, so that a finger on the frame knows the picture's shape.
//!  |   ::  gap             :: |
//!  |   ::    figure        :: |
//!  |   ::                  :: |
//!  |   :::::::::::::::::::::: |
//!  |      substantial gap     |
//!  |        ::::::::::::      |
//!  |        :: overview::     |
//!  |        ::::::::::::      |
//!  +--------------------------+
//! ```

use crate::units::{MmPoint, MmRect, MmVector};

/// Measures of the sheet, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Width and height of the sheet.
    pub sheet: [f32; 2],
    /// Blank on all four sides.
    pub margin: f32,
    /// Frames, if there are any.
    pub frame: Option<FrameParams>,
    /// The overview, if there is one.
    pub overview: Option<OverviewParams>,
}

/// Measures of a frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameParams {
    /// Width of the band of dots.
    pub width: f32,
    /// Diameter of a dot.
    pub dot: f32,
    /// Distance of dots.
    pub pitch: f32,
    /// Blank between the band and the picture.
    pub gap: f32,
}

/// Measures of the overview.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverviewParams {
    /// Its width and height as a share of the figure's.
    pub scale: f32,
    /// Blank between the two frames, mm.
    pub gap: f32,
}

/// Places on the sheet, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// The picture itself.
    pub figure: MmRect,
    /// The overview's picture.
    pub overview: Option<MmRect>,
}

/// Lays out a picture whose width is `aspect` times its height, as large as the sheet allows, centred from left to right
/// and beginning at the top margin.
pub fn fit(aspect: f32, params: &Params) -> Layout {
    let border = params.frame.map_or(0.0, |frame| frame.width + frame.gap);
    let [width, height] = params.sheet.map(|side| side - 2.0 * params.margin);
    let (borders, gap, scale) = match params.overview {
        Some(overview) => (4.0 * border, overview.gap, overview.scale),
        None => (2.0 * border, 0.0, 0.0),
    };
    let free = [(width - 2.0 * border).max(0.0), ((height - borders - gap) / (1.0 + scale)).max(0.0)];
    let figure_width = free[0].min(free[1] * aspect);
    let size = MmVector::new(figure_width, figure_width / aspect);
    let middle = 0.5 * params.sheet[0];
    let place = |top: f32, size: MmVector| {
        let corner = MmPoint::new(middle - 0.5 * size.x, top);
        MmRect::new(corner, corner + size)
    };
    let figure = place(params.margin + border, size);
    let overview =
        params.overview.map(|overview| place(figure.max.y + overview.gap + 2.0 * border, size * overview.scale));
    Layout { figure, overview }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn params() -> Params {
        Params {
            sheet: [210.0, 297.0],
            margin: 10.0,
            frame: Some(FrameParams { width: 3.0, dot: 0.8, pitch: 1.6, gap: 5.0 }),
            overview: Some(OverviewParams { scale: 0.4, gap: 12.0 }),
        }
    }

    #[test]
    fn everything_keeps_inside_the_margins_at_any_shape() {
        for aspect in [0.05, 0.3, 0.7, 1.0, 1.5, 4.0, 20.0] {
            for (frame, overview) in [(true, true), (true, false), (false, true), (false, false)] {
                let mut params = params();
                params.frame = params.frame.filter(|_| frame);
                params.overview = params.overview.filter(|_| overview);
                let layout = fit(aspect, &params);
                let border = if frame { 8.0 } else { 0.0 };
                let bottom = layout.overview.map_or(layout.figure.max.y, |o| o.max.y) + border;
                assert!(bottom <= 287.01 && layout.figure.min.x - border >= 9.99, "{aspect}: {layout:?}");
                let tight = (bottom - 287.0).abs() < 0.01 || (layout.figure.min.x - border - 10.0).abs() < 0.01;
                assert!(tight, "the picture could be larger: {layout:?}");
                assert!((layout.figure.width() / layout.figure.height() / aspect - 1.0).abs() < 1e-3);
            }
        }
    }
}
