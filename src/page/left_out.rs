//! What a page's maker left out of it, kept in the page among how it was made, so that whoever checks or describes the
//! page later can tell.

use super::parts::Page;
use crate::geom::ninths::most_of;

const CONTOURS: &str = "contours left out in mm";
const PLACES: &str = "contours left out in mm by ninths";
const SHAPES: &str = "closed shapes not in the overview";

/// Contours that were worth a line and are not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    /// Their length, whole mm.
    pub millimetres: u32,
    /// Length of all that was worth a line, whole mm.
    pub of: u32,
    /// Their length in each of nine parts of the figure, row by row from the top left, whole mm.
    pub by_place: Option<[u32; 9]>,
    /// Closed shapes of a drawing that are not in its overview.
    pub shapes: u32,
}

impl LeftOut {
    /// As entries of a page's origin; nothing of nothing.
    pub fn to_origin(self) -> Vec<(String, String)> {
        let Self { millimetres, of, by_place, shapes } = self;
        let mut origin = Vec::new();
        if millimetres > 0 {
            origin.push((CONTOURS.to_owned(), format!("{millimetres} of {of}")));
            let list = |places: [u32; 9]| places.map(|mm| mm.to_string()).join(" ");
            origin.extend(by_place.map(|places| (PLACES.to_owned(), list(places))));
        }
        if shapes > 0 {
            origin.push((SHAPES.to_owned(), shapes.to_string()));
        }
        origin
    }

    /// What a page says of itself.
    pub fn of(page: &Page) -> Self {
        let value = |name: &str| page.origin.iter().find(|(of, _)| of == name).map(|(_, value)| value.as_str());
        let whole = |text: &str| text.trim().parse::<u32>().ok();
        let contours = value(CONTOURS).and_then(|text| text.split_once(" of "));
        let (millimetres, of) = contours.and_then(|(a, b)| Some((whole(a)?, whole(b)?))).unwrap_or_default();
        let places = value(PLACES).and_then(|text| text.split(' ').map(whole).collect::<Option<Vec<u32>>>());
        let by_place = places.and_then(|places| places.try_into().ok());
        let shapes = value(SHAPES).and_then(whole).unwrap_or_default();
        Self { millimetres, of, by_place, shapes }
    }

    /// Share of what was worth a line, 0..=1.
    pub fn share(&self) -> f32 {
        if self.of > 0 { (self.millimetres as f32 / self.of as f32).min(1.0) } else { 0.0 }
    }

    /// The ninth of the figure in which most of it is, if there is one and that is known.
    pub fn most_in(&self) -> Option<usize> {
        most_of(self.by_place?.map(|mm| mm as f32))
    }
}
