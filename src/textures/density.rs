//! How many lines are near: where textures stand dense.

use crate::lines::Line;
use crate::raster::plane::Plane;
use crate::units::{MmRect, Size};

/// Cells of the map, mm. The blur is several times wider.
const CELL: f32 = 1.0;
/// Lines are marked in steps of this, mm.
const STEP: f32 = 0.25;

/// The map over `area`; its pixels are [`CELL`] wide. The paper marks every line and blurs the marks with `sigma`
/// millimetres. The result is divided by the value that a lone straight line has on itself, `1 / (sqrt(tau) sigma)`, and
/// cut at 1: the local density, whatever the resolution.
pub(crate) fn map(lines: &[Line], area: MmRect, sigma: f32) -> Plane {
    let cells = |mm: f32| (mm / CELL).ceil().max(1.0) as u32;
    let mut map = Plane::filled(Size::new(cells(area.width()), cells(area.height())), 0.0);
    if lines.is_empty() {
        return map;
    }
    for (&a, &b) in lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.polyline().segments()) {
        let (way, length) = (b - a, (b - a).length());
        let steps = (length / STEP).ceil().max(1.0);
        for k in 0..steps as u32 {
            let at = a + way * ((k as f32 + 0.5) / steps) - area.min.to_vector();
            let x = ((at.x / CELL) as u32).min(map.size.width - 1);
            let y = ((at.y / CELL) as u32).min(map.size.height - 1);
            map.values[(y * map.size.width + x) as usize] += length / steps;
        }
    }
    let mut map = map.blurred(sigma / CELL);
    let lone_line = CELL / (std::f32::consts::TAU.sqrt() * sigma / CELL);
    map.values.iter_mut().for_each(|value| *value = (*value / lone_line).min(1.0));
    map
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lines::Run;
    use crate::units::MmPoint;

    #[test]
    fn a_lone_line_has_density_one_on_itself_and_half_at_1_18_sigma() {
        let area = MmRect::new(MmPoint::new(5.0, 5.0), MmPoint::new(105.0, 105.0));
        let points = vec![MmPoint::new(55.0, 5.0), MmPoint::new(55.0, 105.0)];
        let line = Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] };
        let map = map(&[line], area, 8.0);
        let at = |x: f32| map.at(x - 5.0, 50.0);
        assert!((at(55.0) - 1.0).abs() < 0.02, "{}", at(55.0));
        assert!((at(55.0 + 9.42) - 0.5).abs() < 0.04, "{}", at(64.42));
    }
}
