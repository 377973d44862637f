//! Writes pages of random dots in every format of dots to a folder, for tests/clients/dots.sh to try on the programs that
//! read them.
//!
//!     cargo run -p tactograph-tools --bin dot_files -- FOLDER
//!
//! `index.txt` lists a case for the drivers of Index embossers a line: name, PPD, page, pitch in hundredths of a millimetre,
//! copies, impact. `NAME.ubrl` has the dots, `NAME.idx` what the driver must make of them.

use std::fs;
use std::path::Path;

use tactograph::Embossing;
use tactograph::internals::devices::{Device, DotArea};
use tactograph::internals::output::dots::{DocumentWords, DotMatrix, brf, index, pef, pixels, ubrl};

/// Pages as the drivers name them, mm.
const PAGES: [(&str, [f32; 2]); 11] = [
    ("A4", [210.0, 297.0]),
    ("A4TF", [210.0, 304.8]),
    ("A3", [297.0, 420.0]),
    ("A5", [148.5, 210.0]),
    ("Letter", [215.9, 279.4]),
    ("Legal", [215.9, 355.6]),
    ("110x115", [279.4, 292.1]),
    ("110x120", [279.4, 304.8]),
    ("110x170", [279.4, 431.8]),
    ("115x110", [292.1, 279.4]),
    ("120x120", [304.8, 304.8]),
];
/// PPDs, our devices, and on how many of the pages: the first four have headers of their own, the others share theirs.
const MODELS: [(&str, &str, usize); 9] = [
    ("ibasicd3", "index-basic-d-v3", 11),
    ("ieveres3", "index-everest-d-v3", 11),
    ("ibasicd4", "index-basic-d-v5", 11),
    ("ieveres4", "index-everest-d-v5", 11),
    ("i4waves3", "index-4waves-v3", 2),
    ("ibasics3", "index-basic-s-v3", 2),
    ("i4x4pro3", "index-4x4-pro-v3", 2),
    ("ibasics4", "index-basic-s-v5", 2),
    ("ibrlbox4", "index-braillebox-v5", 2),
];

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Outcome<()> {
    let folder = std::env::args().nth(1).ok_or("name a folder")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    let mut random = Random(1);
    index_cases(folder, &mut random)?;
    let put = |name: &str, bytes: &[u8]| fs::write(folder.join(name), bytes);

    // Pictures of a page of dots, for CUPS's own way from pictures to braille: A4 of a Basic-D V3 at 2.0 mm, and the generic
    // embosser of text, whose driver counts 74 x 108 dots.
    let basic = Device::named("index-basic-d-v3")?;
    let params = index::Params::new(basic, [210.0, 297.0], 2.0, Embossing::default()).map_err(|all| all.join("\n"))?;
    let eight = [random.page(104, 144)];
    put("eight.png", &pixels::write(&eight[0], 2.0, false, &DocumentWords::default()))?;
    put("eight.ubrl", ubrl::write(&eight).as_bytes())?;
    put("eight.idx", &index::write(&eight, &params))?;
    let six = [random.page(74, 108)];
    put("six.png", &pixels::write(&six[0], 2.5, false, &DocumentWords::default()))?;
    put("six.brf", brf::write(&six).as_bytes())?;
    // All cells of six dots in the order of Unicode.
    let mut cells = blank(2 * 64, 3);
    for (cell, bit) in (0..64).flat_map(|cell| (0..6).map(move |bit| (cell, bit))) {
        if cell >> bit & 1 == 1 {
            cells.raise(2 * cell + bit / 3, bit % 3, 1);
        }
    }
    put("cells6.brf", brf::write(&[cells]).as_bytes())?;

    // Heights, at 20 to the inch.
    let mut steps = blank(4, 2);
    for x in 1..4 {
        steps.raise(x, 0, x as u8);
        steps.raise(3 - x, 1, x as u8);
    }
    put(
        "heights.png",
        &pixels::write(&steps, 1.27, true, &DocumentWords { title: "Heights", ..DocumentWords::default() }),
    )?;

    let words = [
        (
            "plain",
            DocumentWords {
                title: "A page",
                description: "Of dots.",
                language: "en-GB",
                description_language: "en-GB",
                text: &[],
            },
        ),
        (
            "odd",
            DocumentWords {
                title: "<&>\"' ]]> \u{1}\n\u{fffe} żółć 𝔊",
                description: "--> &amp;",
                language: "no language",
                description_language: "no language",
                text: &[],
            },
        ),
    ];
    for (name, words) in words {
        let pages = [random.page(97, 139), random.page(3, 5), blank(0, 0)];
        put(&format!("{name}.pef"), pef::write(&pages, &words).as_bytes())?;
    }
    put("none.pef", pef::write(&[], &DocumentWords::default()).as_bytes())?;
    Ok(())
}

fn index_cases(folder: &Path, random: &mut Random) -> Outcome<()> {
    let mut list = String::new();
    for (ppd, id, count) in MODELS {
        let device = Device::named(id)?;
        for (page, sheet) in &PAGES[..count] {
            for pitch in [1.6, 2.0, 2.5] {
                let (copies, impact) = (1 + random.below(3) as u16, 1 + random.below(3) as u8);
                let embossing = Embossing::new(copies, impact)?;
                let params = index::Params::new(device, *sheet, pitch, embossing).map_err(|all| all.join("\n"))?;
                // The driver counts dots on sheets that the embosser does not take, too; such a page is a small one here.
                let (columns, rows) = match device.dot_area(*sheet, pitch) {
                    Ok(DotArea::Grid(grid)) => (grid.columns.len(), grid.rows.len()),
                    _ => (16, 16),
                };
                let pages: Vec<DotMatrix> = (0..1 + random.below(2)).map(|_| random.page(columns, rows)).collect();
                let hundredths = (pitch * 100.0).round();
                let name = format!("{ppd}.{page}.{hundredths}");
                fs::write(folder.join(format!("{name}.ubrl")), ubrl::write(&pages))?;
                fs::write(folder.join(format!("{name}.idx")), index::write(&pages, &params))?;
                list += &format!("{name} {ppd} {page} {hundredths} {copies} {impact}\n");
            }
        }
    }
    Ok(fs::write(folder.join("index.txt"), list)?)
}

/// Numbers that are the same on every run: a linear congruential generator, with the constants of Knuth's MMIX.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    /// Dots on some of the rows, so that there are blank rows and blank ends.
    fn page(&mut self, columns: usize, rows: usize) -> DotMatrix {
        let mut page = blank(columns, rows);
        for band in 0..rows.div_ceil(4) {
            let end = [0, columns / 3, columns, columns][self.below(4) as usize];
            for (x, y) in (0..4).flat_map(|y| (0..end).map(move |x| (x, 4 * band + y))) {
                if self.below(3) == 0 {
                    page.raise(x, y, 1 + self.below(3) as u8);
                }
            }
        }
        page
    }
}

/// A matrix without dots.
fn blank(columns: usize, rows: usize) -> DotMatrix {
    DotMatrix::new(columns, rows).expect("not more dots than there can be")
}
