//! The samples at the size at which they are worked on.

use tactograph::internals::raster::Raster;
use tactograph::internals::raster::decode::{DecodeOptions, Header, decode};
use tactograph::internals::units::Size;

/// Working pixels along the longer side, as of a figure 174 mm wide.
const LONGEST: f32 = 696.0;
/// Working pixels for a millimetre.
pub const PX_PER_MM: f32 = 4.0;

const NAMES: [&str; 10] = [
    "bars.svg",
    "cell.svg",
    "chart.svg",
    "landscape.svg",
    "map.svg",
    "portrait.svg",
    "astronaut.png",
    "chelsea.png",
    "coffee.png",
    "rocket.jpg",
];

/// Names and pictures: drawings, then photographs.
///
/// # Errors
/// If a sample is not there or cannot be decoded.
pub fn all() -> Result<Vec<(&'static str, Raster)>, Box<dyn std::error::Error>> {
    NAMES.into_iter().map(|name| sample(name).map(|raster| (name, raster))).collect()
}

fn sample(name: &str) -> Result<Raster, Box<dyn std::error::Error>> {
    let bytes = std::fs::read(format!("{}/samples/{name}", crate::ROOT))?;
    let working_size = |source: Header| -> Result<Size, tactograph::Error> {
        let longer = source.size.width.max(source.size.height) as f32;
        let scale = if source.is_drawing { LONGEST / longer } else { (LONGEST / longer).min(1.0) };
        let side = |pixels: u32| (pixels as f32 * scale).round() as u32;
        Ok(Size::new(side(source.size.width), side(source.size.height)))
    };
    Ok(decode(&bytes, &DecodeOptions { keep_text: false, ..DecodeOptions::whole(&working_size) })?.raster)
}

/// The colours of a picture as sRGB values 0..=1.
pub fn codes(raster: &Raster) -> impl Iterator<Item = [f32; 3]> {
    let planes = raster.planes().as_slice();
    let encoded =
        |linear: f32| if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    let plane = move |channel: usize| &planes[channel.min(planes.len() - 1)];
    (0..planes[0].len()).map(move |i| [0, 1, 2].map(|channel| encoded(plane(channel)[i]).clamp(0.0, 1.0)))
}
