//! The dots of a line on a device that can press them anywhere: evenly spaced along the line.

use lyon::path::Path;
use lyon::walk::{RegularPattern, WalkerEvent, walk_along_path};

use crate::geom::polyline::PolylineRef;
use crate::units::MmPoint;

/// Tolerance of flattening curves, mm; a polyline has none.
const TOLERANCE: f32 = 0.01;

/// Dots along a line in equal steps as near to `pitch` mm as fit: on both ends of an open line, all round a closed one.
pub(super) fn evenly(line: PolylineRef<'_, MmPoint>, pitch: f32) -> Vec<MmPoint> {
    let length = line.length();
    let mut points = line.path();
    let Some(&first) = points.next() else { return Vec::new() };
    let last = line.path().last().copied().unwrap_or(first);
    let steps = (length / pitch).round();
    if steps < 1.0 {
        return vec![first];
    }
    let mut path = Path::builder();
    path.begin(first.cast_unit());
    points.for_each(|at| {
        path.line_to(at.cast_unit());
    });
    path.end(false);
    let mut dots = Vec::with_capacity(steps as usize + 1);
    let mut pattern = RegularPattern {
        callback: |event: WalkerEvent<'_>| {
            dots.push(event.position.cast_unit());
            true
        },
        interval: length / steps,
    };
    walk_along_path(path.build().iter(), 0.0, TOLERANCE, &mut pattern);
    // Whether the walker reaches the very end depends on rounding.
    dots.truncate(steps as usize);
    if !line.closed {
        dots.push(last);
    }
    dots
}

#[cfg(test)]
mod tests;
