//! Tests of `dot_layout`.

use super::*;
use crate::devices::Device;

#[test]
fn a_figure_begins_in_the_nearest_middle_between_two_rows() {
    let device = Device::named("index-basic-d-v5").expect("in the table");
    let medium = DotMedium::on(device, 2.5, [210.0, 297.0]).expect("its own sheet");
    let DotArea::Grid(grid) = &medium.area else { panic!("it has a grid") };
    let middle = 0.5 * (grid.rows[20] + grid.rows[21]);
    for off in [-1.1, -0.4, 0.0, 0.4, 1.1] {
        let min = MmPoint::new(30.0, middle + off);
        let figure = on_grid(MmRect::new(min, min + MmVector::new(60.0, 80.0)), &medium);
        assert!((figure.min.y - middle).abs() < 1e-3, "{} is not {middle}", figure.min.y);
        assert!((figure.height() - 80.0).abs() < 1e-3);
        assert!((figure.center().x - grid.bounds().center().x).abs() < 1e-3);
    }
}
