//! Tests of `palette`.

use super::*;

#[test]
fn signs_read_back_as_they_are_written() {
    for text in ["dot", "rhombus 0", "rhombus 22.5", "rhombus 135"] {
        assert_eq!(text.parse::<Sign>().map(|sign| sign.to_string()), Ok(text.to_owned()));
    }
    for text in ["", "dots", "dot 1", "rhombus", "rhombus 180", "rhombus -1", "rhombus NaN", "rhombus 1 2", "45"] {
        assert_eq!(text.parse::<Sign>(), Err(Error::NotASign), "{text}");
    }
}

#[test]
fn near_directions_are_alike_across_the_horizontal() {
    let rhombus = |degrees| Sign::Rhombus { degrees };
    assert!(!rhombus(170.0).differs_from(rhombus(10.0)) && rhombus(170.0).differs_from(rhombus(20.0)));
    assert!(!Sign::Dot.differs_from(Sign::Dot) && Sign::Dot.differs_from(rhombus(0.0)));
    let signs = Palette::PAPER.signs;
    assert!((0..5).all(|i| (0..i).all(|j| signs[i].differs_from(signs[j]))));
}
