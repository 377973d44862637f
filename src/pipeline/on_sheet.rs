//! Contours where they lie on the sheet.

use crate::edges::{ChainRange, Edges};
use crate::units::{MmPoint, PageTransform};

/// The points of a contour on the sheet, in their order.
pub(super) fn on_sheet(edges: &Edges, chain: &ChainRange, transform: &PageTransform) -> impl Iterator<Item = MmPoint> {
    edges.chain(chain).vertices.iter().map(move |edgel| transform.to_mm(edgel.at))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edges::Edgel;
    use crate::units::{MmRect, PxPoint, Size};

    #[test]
    fn each_contour_has_its_own_points() {
        let mut edges = Edges::none(Size::new(100, 50));
        let edgel = |at: [f32; 2]| Edgel { at: PxPoint::new(at[0], at[1]), strength: 1.0, contrast: [0.0; 3] };
        edges.push([[0.0, 0.0], [100.0, 50.0]].map(edgel).into_iter(), false);
        edges.push([[50.0, 25.0]].map(edgel).into_iter(), false);
        let place = MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(220.0, 130.0));
        let transform = PageTransform::new(edges.size, place);
        let points = |chain: usize| on_sheet(&edges, &edges.chains[chain], &transform).collect::<Vec<_>>();
        assert_eq!(points(0), [place.min, place.max]);
        assert_eq!(points(1), [place.center()]);
    }
}
