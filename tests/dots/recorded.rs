//! Byte for byte what the drivers made.

use tactograph::Embossing;
use tactograph::internals::devices::{Device, DotArea};
use tactograph::internals::output::dots::{brf, index, ubrl};

use super::reading;

const PAGES: &str = include_str!("recorded/pages.ubrl");
const GEOMETRY: &str = include_str!("recorded/geometry.txt");

/// Pages as the drivers name them, mm.
fn sheet(page: &str) -> [f32; 2] {
    match page {
        "A3" => [297.0, 420.0],
        "A4" => [210.0, 297.0],
        "A4TF" => [210.0, 304.8],
        "A5" => [148.5, 210.0],
        "Letter" => [215.9, 279.4],
        "Legal" => [215.9, 355.6],
        "110x115" => [279.4, 292.1],
        "110x120" => [279.4, 304.8],
        "110x170" => [279.4, 431.8],
        "115x110" => [292.1, 279.4],
        "120x120" => [304.8, 304.8],
        _ => panic!("unknown page {page}"),
    }
}

fn device(ppd: &str) -> &'static Device {
    let id = match ppd {
        "ibasicd3" => "index-basic-d-v3",
        "ieveres3" => "index-everest-d-v3",
        "i4waves3" => "index-4waves-v3",
        "ibasicd4" => "index-basic-d-v5",
        "ieveres4" => "index-everest-d-v4",
        _ => panic!("unknown PPD {ppd}"),
    };
    Device::named(id).expect("in the table")
}

#[test]
fn index_documents_are_those_of_the_drivers() {
    let pages = reading::ubrl(PAGES);
    assert_eq!(pages.len(), 3);
    for (ppd, page, pitch, copies, impact, want) in [
        ("ibasicd3", "A4", 2.0, 1, 1, &include_bytes!("recorded/pages.ibasicd3.idx")[..]),
        ("i4waves3", "A4", 2.0, 1, 1, include_bytes!("recorded/pages.i4waves3.idx")),
        ("ieveres3", "A4", 2.0, 2, 3, include_bytes!("recorded/pages.ieveres3.idx")),
        ("ibasicd4", "A3", 1.6, 12, 2, include_bytes!("recorded/pages.ibasicd4.idx")),
    ] {
        let params = index::Params::new(
            device(ppd),
            sheet(page),
            pitch,
            Embossing::new(copies, impact).expect("in their ranges"),
        )
        .expect("no fault");
        let bytes = index::write(&pages, &params);
        assert!(bytes == want, "{ppd}: {}", String::from_utf8_lossy(&bytes));
    }
}

/// Every model, page and pitch: the header, and how many dots there are.
#[test]
fn index_headers_and_grids_are_those_of_the_drivers() {
    let mut too_wide = 0;
    for line in GEOMETRY.lines() {
        let [ppd, page, pitch, size, header] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let (device, sheet) = (device(ppd), sheet(page));
        let pitch = pitch.parse::<f32>().expect("a number") / 100.0;
        let params = index::Params::new(device, sheet, pitch, Embossing::default()).expect("no fault");
        let want = [b"\x1b", header.as_bytes(), b"\x1b\x07\x1b\x06\x1a"].concat();
        assert_eq!(index::write(&[], &params), want, "{line}");
        match device.dot_area(sheet, pitch) {
            Ok(DotArea::Grid(grid)) => {
                assert_eq!(format!("{}x{}", grid.columns.len(), grid.rows.len()), size, "{line}");
            }
            // The drivers do not ask whether the embosser takes the page; we do.
            other => {
                let faults = other.expect_err("no room that is not a grid");
                assert!(sheet[0] > device.widest && faults.to_string().contains("wide"), "{line}: {faults}");
                too_wide += 1;
            }
        }
    }
    assert_eq!((GEOMETRY.lines().count(), too_wide), (132, 6));
}

#[test]
fn cells_are_those_that_cups_makes_of_a_picture() {
    let mut reader = png::Decoder::new(std::io::Cursor::new(include_bytes!("recorded/picture.png")));
    reader.set_transformations(png::Transformations::EXPAND);
    let mut reader = reader.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    reader.next_frame(&mut pixels).expect("a PNG");
    let columns = reader.info().width as usize;
    let mut page = reading::matrix(columns, reader.info().height as usize);
    for (i, _) in pixels.iter().enumerate().filter(|(_, grey)| **grey == 0) {
        page.raise(i % columns, i / columns, 1);
    }
    let want = include_str!("recorded/picture.ubrl");
    assert!(page.count() > 100);
    assert_eq!(ubrl::write(&[page]), want);
    assert_eq!(ubrl::write(&reading::ubrl(PAGES)), PAGES);
}

#[test]
fn ascii_braille_is_in_the_table_of_cups() {
    let mut page = reading::matrix(128, 3);
    for (cell, bit) in (0..64).flat_map(|cell| (0..6).map(move |bit| (cell, bit))) {
        if cell >> bit & 1 == 1 {
            page.raise(2 * cell + bit / 3, bit % 3, 1);
        }
    }
    let table = include_str!("recorded/brf-table.txt").trim_end_matches('\n');
    assert_eq!(brf::write(&[page]), format!("{table}\r\n\u{c}"));
}
