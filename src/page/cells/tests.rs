//! Tests of `cells`.

use super::*;
use crate::braille::Code;
use crate::devices::Device;
use crate::page::Print;

/// On every device cells stand where the table above says.
#[test]
fn cells_come_near_to_standard_ones() {
    for (device, sheet, pitch, expected) in [
        ("viewplus-columbia", [279.4, 292.1], 1.27, [2.54, 6.35, 10.16]),
        ("index-basic-d-v5", [210.0, 297.0], 1.6, [1.6, 6.4, 9.6]),
        ("index-basic-d-v5", [210.0, 297.0], 2.0, [2.0, 6.0, 10.0]),
        ("index-basic-d-v5", [210.0, 297.0], 2.5, [2.5, 7.5, 10.0]),
        ("monarch", [240.0, 100.0], 2.5, [2.5, 7.5, 10.0]),
        ("braille-cells", [292.1, 279.4], 2.34, [2.34, 6.2, 10.0]),
    ] {
        let device = Device::named(device).expect("in the table");
        let medium = Medium::Dots(DotMedium::on(device, pitch, sheet).expect("its own sheet"));
        let cells = CellGrid::of(&medium, CellSize::MARBURG);
        let lines = vec![vec![0b11_1111; 3], vec![0b11_1111; 3]];
        let dots = cells.dots(&lines, MmPoint::new(40.0, 30.0));
        assert_eq!(dots.len(), 36, "{}", device.id);
        let off = |i: usize, j: usize, want: MmVector| (dots[j] - dots[i] - want).length();
        let [dot, cell, line] = expected;
        // dots 1 and 4 of a cell, dot 1 of the next, dot 1 of the next line
        for (to, want) in [(3, (dot, 0.0)), (1, (0.0, dot)), (6, (cell, 0.0)), (18, (0.0, line))] {
            assert!(off(0, to, want.into()) < 0.06, "{}: {:?}", device.id, &dots[..7]);
        }
    }
}

#[test]
fn on_paper_cells_are_standard() {
    let table = Code::of_language("en").and_then(Code::table).expect("a table");
    let medium = Medium::Print(Print::default());
    let cells = CellGrid::of(&medium, CellSize::MARBURG);
    let corner = MmPoint::new(20.0, 30.0);
    let dots = cells.dots(&[table.translate("c").cells, table.translate("ac").cells], corner);
    let expected = [(0.0, 0.0), (2.5, 0.0), (0.0, 10.0), (6.0, 10.0), (8.5, 10.0)];
    assert!(
        dots.len() == 5
            && dots.iter().zip(expected).all(|(at, want)| { (*at - dots[0] - MmVector::from(want)).length() < 1e-4 }),
        "{dots:?}"
    );
    assert!((dots[0] - corner - MmVector::new(0.65, 0.65)).length() < 1e-5);
    let extent = cells.extent(2, 2);
    assert!((extent - MmVector::new(9.8, 16.3)).length() < 1e-4, "{extent:?}");
}

#[test]
fn a_box_is_moved_to_where_its_cells_stand_and_keeps_its_size() {
    let device = Device::named("index-basic-d-v5").expect("in the table");
    let medium = Medium::Dots(DotMedium::on(device, 2.5, [210.0, 297.0]).expect("its own sheet"));
    let cells = CellGrid::of(&medium, CellSize::MARBURG);
    let place = MmRect::new(MmPoint::new(41.0, 31.0), MmPoint::new(55.0, 38.0));
    let snapped = cells.snapped(place);
    assert!((snapped.size() - place.size()).to_vector().length() < 1e-3, "{snapped:?}");
    let dots = cells.dots(&[vec![0b11_1111]], place.min);
    let corner = dots[0] - MmVector::new(0.5 * cells.diameter, 0.5 * cells.diameter);
    assert!((snapped.min - corner).length() < 1e-3, "{snapped:?}, not at {corner:?}");
}
