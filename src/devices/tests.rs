//! Where dots can be, on every device; faults of sheets and pitches.

use super::*;

fn grid(id: &str, sheet: [f32; 2], pitch: f32) -> Grid {
    match Device::named(id).expect("in the table").dot_area(sheet, pitch) {
        Ok(DotArea::Grid(grid)) => grid,
        other => panic!("{id}: {other:?}"),
    }
}

fn size(grid: &Grid) -> (usize, usize) {
    (grid.columns.len(), grid.rows.len())
}

#[test]
fn ids_are_different_and_found() {
    for (i, device) in Device::ALL.iter().enumerate() {
        assert!(Device::ALL[..i].iter().all(|other| other.id != device.id), "{}", device.id);
        assert_eq!(Device::named(device.id), Ok(device));
        assert!(device.id.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-'));
    }
    let refused = Device::named("index").expect_err("it is none").to_string();
    assert!(refused.contains("no device called \"index\"") && refused.contains("index-basic-d-v4"), "{refused}");
}

/// Every device, on its largest sheet, on a small one and on one between, with each of its pitches.
#[test]
fn dots_lie_on_the_sheet_in_ascending_order() {
    for device in Device::ALL {
        let sheets: Vec<[f32; 2]> = match device.field() {
            Some(field) => vec![field],
            None => vec![[device.widest, device.longest], [25.4, 74.0], [148.0, 210.0], [101.37, 203.31]],
        };
        let pitches = match device.pitches() {
            Pitches::Listed(pitches) => pitches.to_vec(),
            Pitches::Between(least, most) => vec![least, 2.4, most],
        };
        for (sheet, pitch) in sheets.iter().flat_map(|sheet| pitches.iter().map(move |pitch| (*sheet, *pitch))) {
            let room = device.dot_area(sheet, pitch).unwrap_or_else(|faults| panic!("{}: {faults:?}", device.id));
            let (bounds, radius) = (room.bounds(), 0.5 * device.diameter());
            assert!(
                bounds.min.x >= radius - 1e-3 && bounds.min.y >= radius - 1e-3,
                "{} {sheet:?}: {bounds:?}",
                device.id
            );
            assert!(
                bounds.max.x <= sheet[0] - radius + 1e-3 && bounds.max.y <= sheet[1] - radius + 1e-3,
                "{} {sheet:?}: {bounds:?}",
                device.id
            );
            let DotArea::Grid(grid) = room else { continue };
            assert!(!grid.columns.is_empty() && !grid.rows.is_empty(), "{} {sheet:?}", device.id);
            for lines in [&grid.columns, &grid.rows] {
                assert!(lines.windows(2).all(|pair| pair[1] - pair[0] >= pitch - 1e-3), "{} {sheet:?}", device.id);
            }
        }
    }
}

#[test]
fn grids_have_the_sizes_that_drivers_count() {
    assert_eq!(size(&grid("index-basic-d-v5", [210.0, 297.0], 2.0)), (98, 140));
    assert_eq!(size(&grid("index-basic-d-v3", [210.0, 297.0], 2.5)), (82, 112));
    // A4 has 165 pixels of 20 to the inch and a third of one.
    assert_eq!(size(&grid("viewplus-max", [210.0, 297.0], 1.27)), (165, 233));
    assert_eq!(size(&grid("viewplus-max", [215.9, 279.4], 1.27)), (170, 220));
    assert_eq!(size(&grid("graphiti", [150.0, 100.0], 2.5)), (60, 40));
    assert_eq!(size(&grid("monarch", [240.0, 100.0], 2.5)), (96, 40));
    // Cells: 2 columns of 3 rows each.
    assert_eq!(size(&grid("braille-cells", [292.1, 279.4], 2.34)), (80, 75));
    assert_eq!(size(&grid("braille-cells", [210.0, 297.0], 2.34)), (62, 84));
}

#[test]
fn the_head_of_an_index_goes_no_further_than_it_can() {
    // The driver would count 152 columns, which is 302 mm.
    let grid = grid("romeo-60", [317.5, 609.6], 2.0);
    assert_eq!(grid.columns.len(), 150);
    assert!((grid.columns[0] + grid.columns[149] - 317.5).abs() < 0.02);
}

/// The three usable areas of DesktopBrailleRAP, where a dot of 1.6 mm would not lie off the sheet.
#[test]
fn the_stylus_of_a_braillerap_reaches_what_its_program_says() {
    for (id, sheet, want) in [
        ("braillerap-a4", [210.0, 297.0], [190.0, 250.0]),
        ("braillerap-xl", [210.0, 297.0], [208.4, 250.0]),
        ("braillerap-xl", [297.0, 420.0], [295.4, 373.0]),
    ] {
        let room = Device::named(id).ok().and_then(|device| device.dot_area(sheet, 2.4).ok());
        let bounds = room.expect("room").bounds();
        let size = [bounds.width(), bounds.height()];
        assert!((0..2).all(|i| (size[i] - want[i]).abs() < 1e-3), "{id}: {size:?}");
        assert!((bounds.min.x + bounds.max.x - sheet[0]).abs() < 1e-3);
    }
}

/// The largest and the smallest sheet are taken, and 0.05 mm or 0.1 mm beyond them none is.
#[test]
fn limits_are_exact() {
    for device in Device::ALL.iter().filter(|device| device.field().is_none()) {
        let pitch = match device.pitches() {
            Pitches::Listed(pitches) => pitches[0],
            Pitches::Between(_, most) => most,
        };
        let fine = |sheet| device.dot_area(sheet, pitch).is_ok();
        let [wide, long] = [device.widest, device.longest];
        assert!(fine([wide, long]) && !fine([wide + 0.05, long]) && !fine([wide, long + 0.05]), "{}", device.id);
        assert!(fine([25.4, 100.0]) && !fine([25.3, 100.0]) && !fine([100.0, 25.3]), "{}", device.id);
    }
}

#[test]
fn cells_stand_apart_and_in_the_middle() {
    let grid = grid("braille-cells", [292.1, 279.4], 2.34);
    let steps = |lines: &[f32]| -> Vec<i32> {
        lines.windows(2).take(5).map(|pair| ((pair[1] - pair[0]) * 100.0).round() as i32).collect()
    };
    assert_eq!(steps(&grid.columns), [234, 386, 234, 386, 234]);
    assert_eq!(steps(&grid.rows), [234, 234, 532, 234, 234]);
    let bounds = grid.bounds();
    assert!((bounds.min.x + bounds.max.x - 292.1).abs() < 0.01 && (bounds.min.y + bounds.max.y - 279.4).abs() < 0.01);
    assert_eq!(grid.at(79, 74), Some(bounds.max));
    assert_eq!((grid.at(80, 0), grid.at(0, 75)), (None, None));
}

#[test]
fn all_faults_are_told_with_what_the_device_can_do() {
    let faults =
        |id: &str, sheet, pitch| Device::named(id).expect("in the table").dots_on(sheet, pitch).expect_err("a fault");
    assert_eq!(
        faults("index-everest-d-v5", [300.0, 700.0], 1.8),
        [
            "the sheet is 300 mm wide; Index Everest-D V5 takes sheets 25.4 to 297 mm wide",
            "the sheet is 700 mm long; Index Everest-D V5 takes sheets 25.4 to 590 mm long",
            "Index Everest-D V5 has no dots 1.8 mm apart; it has 1.6, 2 or 2.5 mm",
        ]
    );
    assert_eq!(
        faults("index-everest-d-v5", [420.0, 297.0], 2.0),
        ["the sheet is 420 mm wide; Index Everest-D V5 takes sheets 25.4 to 297 mm wide; turned, as 297 x 420 mm, \
         the sheet fits"]
    );
    assert_eq!(
        faults("braillerap-a4", [210.0, 297.0], 1.0),
        ["BrailleRAP has no dots 1 mm apart; it has any from 1.6 to 5 mm"]
    );
    assert_eq!(
        faults("braillerap-a4", [148.0, 50.0], 2.4),
        ["the sheet is 50 mm long; BrailleRAP takes sheets 74 to 297 mm long; turned, as 50 x 148 mm, the sheet fits"]
    );
    assert_eq!(
        faults("graphiti", [210.0, 297.0], 2.0),
        [
            "Orbit Graphiti shows 150 x 100 mm, 60 x 40 pins; the sheet is 210 x 297 mm",
            "Orbit Graphiti has no dots 2 mm apart; it has 2.5 mm"
        ]
    );
    for odd in [f32::NAN, f32::INFINITY, -1.0, 0.0] {
        for device in Device::ALL {
            assert_eq!(
                device.dots_on([odd, odd], odd).map_err(|faults| faults.is_empty()),
                Err(false),
                "{}",
                device.id
            );
        }
    }
}

/// Devices know nothing of braille, so the measures stand in both modules.
#[test]
fn cells_have_the_measures_of_american_braille() {
    let us = crate::braille::CellSize::named("us").expect("in the table");
    let grid = grid("braille-cells", [210.0, 297.0], us.dot);
    let step = |centres: &[f32], from: usize, to: usize| centres[to] - centres[from];
    let steps = [step(&grid.columns, 0, 1), step(&grid.columns, 0, 2), step(&grid.rows, 0, 3)];
    for (step, wanted) in steps.into_iter().zip([us.dot, us.cell, us.line]) {
        assert!((step - wanted).abs() < 1e-4, "{steps:?}");
    }
}
