//! Tests of `crop`.

use super::*;

fn part(text: &str) -> Option<[u32; 4]> {
    let part = text.parse::<Crop>().ok()?.part(Size::new(601, 400)).ok()?;
    Some([part.left, part.top, part.size.width, part.size.height])
}

#[test]
fn parts_are_in_pixels_or_percent() {
    for (text, want) in [
        ("0,0,601,400", [0, 0, 601, 400]),
        ("0%,0%,100%,100%", [0, 0, 601, 400]),
        ("10, 20px ,50%, 12.5%", [10, 20, 301, 50]),
        ("50%,0,50%,1", [301, 0, 300, 1]),
        ("0,0,50%,1", [0, 0, 301, 1]),
    ] {
        assert_eq!(part(text), Some(want), "{text}");
    }
}

#[test]
fn parts_of_numbers_are_those_of_their_texts() {
    let texts = ["1,2,3,4", "0%,12.5%,33.3%,100%", "0mm,5mm,20.5mm,10000mm"];
    let parts = [Crop::pixels(1, 2, 3, 4), Crop::percent(0.0, 12.5, 33.3, 100.0), Crop::mm(0.0, 5.0, 20.5, 10_000.0)];
    for (text, part) in texts.into_iter().zip(parts) {
        assert_eq!(part.as_ref().map(Crop::to_string), Ok(text.to_owned()));
        assert_eq!(part, text.parse());
    }
    let refused = [
        Crop::pixels(0, 0, 0, 5),
        Crop::percent(-0.1, 0.0, 5.0, 5.0),
        Crop::percent(0.0, 0.0, 100.1, 5.0),
        Crop::percent(0.0, 0.0, f64::NAN, 5.0),
        Crop::mm(0.0, 0.0, 5.0, 0.0),
        Crop::mm(0.0, f64::INFINITY, 5.0, 5.0),
    ];
    assert_eq!(refused, [const { Err(Error::NotACrop) }; 6]);
}

#[test]
fn parts_in_mm_are_of_the_figure() {
    let size = Size::new(600, 300);
    let shares = |text: &str| text.parse::<Crop>().expect("a part").shares(size, [150.0, 75.0]);
    assert_eq!(shares("15mm,0mm,30mm,75mm"), Ok([0.1, 0.0, 0.3, 1.0]));
    assert_eq!(shares("60,50%, 15 mm,25%"), Ok([0.1, 0.5, 0.2, 0.75]));
    assert_eq!(shares("0,0,150.2mm,1"), Ok([0.0, 0.0, 1.0, 1.0 / 300.0]), "a ruler's width too long");
    assert!(matches!(shares("0,0,151mm,1"), Err(Error::NotInFigure { .. })));
    assert!(matches!(shares("0,75mm,5mm,1mm"), Err(Error::NotInFigure { .. })));
    let in_mm: Crop = "0,0,5mm,5".parse().expect("a part");
    assert!(matches!(in_mm.part(size), Err(Error::PartInMm { .. })));
    for text in ["0,0,0mm,5", "0,0,nanmm,5", "0,-1mm,5,5", "0,0,1e9mm,5", "0,0,mm,5"] {
        assert!(text.parse::<Crop>().is_err(), "{text}");
    }
}

#[test]
fn what_is_no_part_of_the_picture_is_refused() {
    for text in ["", "1,2,3", "1,2,3,4,5", "0,0,0,5", "0,0,5,0%", "-1,0,5,5", "0,0,101%,5", "0,0,nan%,5", "0,0,1.5,2"] {
        assert!(text.parse::<Crop>().is_err(), "{text}");
    }
    for text in ["1,0,601,400", "50%,0,51%,5", "601,0,1,1", "0,400,1,1", "4294967295,0,4294967295,1", "0,0,0.01%,5"] {
        assert!(text.parse::<Crop>().is_ok() && part(text).is_none(), "{text}");
    }
}
