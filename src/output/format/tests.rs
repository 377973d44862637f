//! Tests of `format`.

use super::*;

#[test]
fn extensions_lead_back_to_their_formats() {
    for &format in Format::ALL {
        let back = Format::of_extension(&format.extension().to_uppercase());
        let png = Format::Drawing(DrawingFormat::Png);
        assert_eq!(back, Some(if format == Format::Dots(DotFormat::Pixels) { png } else { format }));
    }
    assert_eq!(Format::of_extension("jpg"), None);
}

#[test]
fn all_formats_are_those_of_drawings_and_those_of_dots() {
    let drawings = DrawingFormat::ALL.iter().copied().map(Format::Drawing);
    let all: Vec<Format> = drawings.chain(DotFormat::ALL.iter().copied().map(Format::Dots)).collect();
    assert_eq!(Format::ALL, all);
}

#[test]
fn names_lead_back_to_their_formats() {
    for &format in Format::ALL {
        assert_eq!(Format::named(format.name()), Ok(format));
    }
    for &format in DotFormat::ALL {
        assert_eq!(DotFormat::named(format.name()), Ok(format));
        assert!(DrawingFormat::named(format.name()).is_err());
    }
    for &format in DrawingFormat::ALL {
        assert_eq!(DrawingFormat::named(format.name()), Ok(format));
    }
}

#[test]
fn every_device_takes_a_format_and_says_which() {
    for device in Device::ALL {
        let takes = DotFormat::ALL.iter().filter(|format| format.check(device).is_ok()).count();
        assert_eq!(takes, DotFormat::of(device).len(), "{}", device.id);
        assert!(takes > 0, "{}", device.id);
    }
    let of = |id| Device::named(id).expect("in the table");
    assert_eq!(
        DotFormat::Brf.check(of("graphiti")).expect_err("it has no cells").to_string(),
        "BRF is not for Orbit Graphiti, which takes pixels, ubrl, pef or txt; take one of these, or SVG, PDF or \
             PNG to look at"
    );
    let told = DotFormat::Txt.check(of("braillerap-a4")).expect_err("it takes no cells").to_string();
    assert!(told.contains("which takes gcode; "), "{told}");
}
