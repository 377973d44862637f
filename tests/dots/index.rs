//! The language of Index embossers on random pages, against a model that turns text into text as the driver does;
//! faults.

use tactograph::Embossing;
use tactograph::internals::devices::Device;
use tactograph::internals::output::dots::{index, ubrl};

use super::Random;

/// What the driver makes of a file of Unicode braille: each line's cells become two letters each, ends of `@` go, and
/// lines end with CR LF, the last one, which holds the form feed, with CR.
fn model(text: &str) -> String {
    let letters = |c: char| -> Vec<char> {
        let Some(cell) = u32::from(c).checked_sub(0x2800) else { return vec![c] };
        // Dots 1 2 3 7 are the left column, 4 5 6 8 the right one.
        let dot = |number: u32| cell >> (number - 1) & 1;
        let column = |dots: [u32; 4]| dots.iter().enumerate().map(|(bit, &number)| dot(number) << bit).sum::<u32>();
        [[1, 2, 3, 7], [4, 5, 6, 8]].map(|dots| char::from_u32(0x40 + column(dots)).expect("a letter")).to_vec()
    };
    let line = |line: &str| line.chars().flat_map(letters).collect::<String>().trim_end_matches('@').to_owned() + "\r";
    text.split('\n').filter(|line| !line.is_empty()).map(line).collect::<Vec<_>>().join("\n")
}

#[test]
fn random_pages_are_what_the_driver_would_make() {
    let params = index::Params::new(v5(), [210.0, 297.0], 2.0, Embossing::default()).expect("no fault");
    let empty = index::write(&[], &params);
    let (start, end) = empty.split_at(empty.len() - 3);
    let mut random = Random(11);
    for _ in 0..300 {
        let pages: Vec<_> = random.pages().into_iter().filter(|page| page.columns() > 0).collect();
        let want = [start, model(&ubrl::write(&pages)).as_bytes(), end].concat();
        let bytes = index::write(&pages, &params);
        assert!(bytes == want, "{}\n{}", String::from_utf8_lossy(&bytes), String::from_utf8_lossy(&want));
    }
}

#[test]
fn all_faults_are_told() {
    let faults = |id: &str, sheet, pitch| {
        let device = Device::named(id).expect("in the table");
        index::Params::new(device, sheet, pitch, Embossing::default()).expect_err("a fault")
    };
    assert_eq!(
        faults("index-basic-d-v5", [0.0, f32::NAN], 1.27),
        [
            "Index Basic-D V5 has no dots 1.27 mm apart; it has 1.6, 2 or 2.5 mm",
            "the sheet is 0 x NaN mm; sides can be 25.4 to 10000 mm",
        ]
    );
    for other in ["monarch", "braillerap-a4", "viewplus-max", "braille-cells"] {
        assert_eq!(faults(other, [210.0, 297.0], 2.0).len(), 1, "{other}");
    }
}

fn v5() -> &'static Device {
    Device::named("index-basic-d-v5").expect("in the table")
}
