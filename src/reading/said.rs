//! What a page says of itself: for which paper or device it is made, its signs, and where its layers lie.

use resvg::tiny_skia::{Point, Transform};

use super::document::{Elements, not_a_page, numbers};
use super::subpath::clean;
use super::words::PageWords;
use crate::Error;
use crate::devices::Device;
use crate::output::layer::Layer;
use crate::page::{Class, DotMedium, Medium, Palette, Print, Sign};
use crate::units::{MmPoint, MmRect, Size};

/// What the page is made for, as it says itself.
pub(super) fn medium(words: &PageWords, sheet: [f32; 2]) -> Result<Medium, Error> {
    match words.value("dots.device").filter(|id| *id != "none") {
        None => Ok(Medium::Print(Print {
            swell: words.number("print.swell").unwrap_or(0.0),
            max_black: words.number("print.max_black").unwrap_or(0.0).max(0.0),
        })),
        Some(id) => {
            let found = Device::named(id).ok().and_then(|device| {
                let pitch = device.pitches().find(words.number("dots.pitch")?)?;
                DotMedium::on(device, pitch, sheet).ok()
            });
            found.map(Medium::Dots).ok_or_else(|| {
                not_a_page("it is a page of dots for a device that is not known, or that does not take its sheet")
            })
        }
    }
}

/// The signs of the page's own profile, as they are seen on it; what it does not say is that of the paper.
pub(super) fn palette(words: &PageWords) -> Palette {
    let sign = |class: Class| {
        let own = words.value(&format!("textures.palette.{}", class.name())).and_then(Sign::named);
        let sign = own.unwrap_or_else(|| Palette::PAPER.sign(class));
        if words.is_mirrored() { sign.mirrored() } else { sign }
    };
    Palette { signs: Class::ALL.map(sign) }
}

/// Where a layer says that its picture lies.
pub(super) fn place_of(layer: Layer, elements: &Elements<'_>, transform: Option<&Transform>) -> Option<MmRect> {
    let node = elements.layer(layer)?;
    let [x, y, width, height]: [f32; 4] = numbers(node, "data-box")?.try_into().ok()?;
    let mut corners = [Point::from_xy(x, y), Point::from_xy(x + width, y + height)];
    if let Some(transform) = transform {
        transform.map_points(&mut corners);
    }
    let [a, b] = corners.map(|p| MmPoint::new(clean(p.x), clean(p.y)));
    let place = MmRect::new(a.min(b), a.max(b));
    (place.width() > 0.0 && place.height() > 0.0).then_some(place)
}

/// A place as far as it lies on the sheet; all of the sheet if there is none.
pub(super) fn on_sheet(place: Option<MmRect>, sheet: [f32; 2]) -> MmRect {
    let all = MmRect::new(MmPoint::zero(), sheet.into());
    place.and_then(|place| place.intersection(&all)).unwrap_or(all)
}

pub(super) fn source(elements: &Elements<'_>) -> Option<Size> {
    let text = elements.layer(Layer::Figure)?.attribute("data-source")?;
    let (width, height) = text.split_once(' ')?;
    Some(Size::new(width.parse().ok()?, height.parse().ok()?)).filter(|size| size.area() > 0)
}
