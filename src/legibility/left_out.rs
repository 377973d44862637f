//! Contours of the picture that are not on the page, as whoever made the page wrote into it.

use super::finding::FoundBreach;
use super::rules::LEFT_OUT;
use crate::geom::ninths;
use crate::page::{LeftOut, Page};
use crate::units::{MmPoint, MmRect, MmVector};

/// Less than this share of the contours, or than this length in mm, is what joins and corners cost.
const SHARE: f32 = 0.05;
const LENGTH: u32 = 20;

pub(super) fn findings(page: &Page) -> Option<FoundBreach> {
    let left = LeftOut::of(page);
    if left.share() < SHARE || left.millimetres < LENGTH {
        return None;
    }
    let percent = 100.0 * left.share();
    let what = format!("{} mm of contours of the picture, {percent:.0} %, are not on the page", left.millimetres);
    let Some(ninth) = left.most_in() else { return Some(FoundBreach::of_page(LEFT_OUT, Some(percent), what)) };
    let place = page.figure.place;
    let size = MmVector::new(place.width() / 3.0, place.height() / 3.0);
    let corner = place.min + MmVector::new((ninth % 3) as f32 * size.x, (ninth / 3) as f32 * size.y);
    let extent = MmRect::new(corner, corner + size);
    let at = MmPoint::new(0.5 * (extent.min.x + extent.max.x), 0.5 * (extent.min.y + extent.max.y));
    let what = format!("{what}, most of them in the {}", ninths::NAMES[ninth]);
    Some(FoundBreach::at(LEFT_OUT, at, extent, percent, what))
}
