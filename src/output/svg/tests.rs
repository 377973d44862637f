//! Tests of `svg`.

use super::*;

#[test]
fn paths_are_written_in_millimetres() {
    let at = |x, y| MmPoint::new(x, y);
    assert_eq!(line_path(&[at(0.0, 0.0), at(1.25, -2.0), at(3.0, 4.0)], false), "M0,0L1.25,-2 3,4");
    let mut d = String::new();
    DiscPath::of(1.0).push(&mut d, at(5.0, 5.0));
    assert_eq!(d, "M4.5,5a0.5 0.5 0 1 0 1 0a0.5 0.5 0 1 0-1 0z");
    d.clear();
    DiscPath::of(1.294).push(&mut d, at(5.0, 5.0));
    assert_eq!(d, "M4.35,5a0.65 0.65 0 1 0 1.3 0a0.65 0.65 0 1 0-1.3 0z", "half circles");
}
