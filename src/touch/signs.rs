//! Which sign stands for which class on a page, and which class a fingertip reads.

use super::measure::{BLANK, Feel, directed_from};
use crate::page::{Class, Palette, Sign};

/// A reading is unclear where the coherence is this near to the threshold, as a share of it.
const NEAR_COHERENCE: f32 = 0.15;
/// A reading is unclear, too, where the direction is this near to the middle between two classes, degrees.
const NEAR_DEGREES: f32 = 4.0;

/// The signs that a reader of a page expects: a class that has none is never felt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Signs {
    /// In the order of [`Class::ALL`].
    of: [Option<Sign>; Class::COUNT],
}

impl Signs {
    /// The signs of a page with these layers, each with the sign that it states. A layer that states none has that of
    /// the default palette. So has a class without a layer, unless a layer has a sign that cannot be told from it.
    pub(super) fn of_layers(layers: &[(Class, Option<Sign>)]) -> Self {
        let present: Vec<(Class, Sign)> =
            layers.iter().map(|&(class, stated)| (class, stated.unwrap_or(Palette::PAPER.sign(class)))).collect();
        let of_class = |class: Class| {
            let own = present.iter().find(|(other, _)| *other == class).map(|(_, sign)| *sign);
            let paper = Palette::PAPER.sign(class);
            own.or_else(|| present.iter().all(|(_, sign)| sign.differs_from(paper)).then_some(paper))
        };
        Self { of: Class::ALL.map(of_class) }
    }

    /// The sign of a class; `None` if the page leaves it none.
    pub fn sign(&self, class: Class) -> Option<Sign> {
        self.all().find(|(other, _)| *other == class).map(|(_, sign)| sign)
    }

    /// The class whose rows run nearest to `degrees` (as [`Feel::degrees`]); `None` if no class has rows.
    pub fn along(&self, degrees: f32) -> Option<Class> {
        self.nearest(degrees).map(|(class, _)| class)
    }

    /// The class that a fingertip of `finger` mm reads, `None` for blank, and whether that is far from another reading.
    pub(super) fn read(&self, feel: &Feel, finger: f32) -> (Option<Class>, bool) {
        if feel.ink < BLANK {
            return (None, true);
        }
        let threshold = directed_from(finger);
        let far = (feel.coherence - threshold).abs() >= NEAR_COHERENCE * threshold;
        let dots = self.all().find(|(_, sign)| *sign == Sign::Dot).map(|(class, _)| class);
        match (dots, self.nearest(feel.degrees)) {
            (Some(dots), _) if feel.coherence < threshold => (Some(dots), far),
            (_, Some((class, room))) => (Some(class), far && feel.coherence >= threshold && room >= NEAR_DEGREES),
            // rows where the page has none, or the other way round
            (dots, None) => (dots, false),
        }
    }

    fn all(&self) -> impl Iterator<Item = (Class, Sign)> {
        Class::ALL.into_iter().zip(self.of).filter_map(|(class, sign)| Some((class, sign?)))
    }

    /// The class whose rows run nearest to `degrees`, and how far that is from the middle to the next one, degrees.
    fn nearest(&self, degrees: f32) -> Option<(Class, f32)> {
        let (mut best, mut second) = (None, f32::INFINITY);
        for (class, sign) in self.all() {
            let Sign::Rhombus { degrees: own } = sign else { continue };
            let apart = (degrees - own).rem_euclid(180.0);
            let off = apart.min(180.0 - apart);
            match best {
                Some((_, least)) if off >= least => second = second.min(off),
                _ => second = best.replace((class, off)).map_or(second, |(_, least)| least),
            }
        }
        best.map(|(class, least)| (class, 0.5 * (second - least)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signs(layers: &[(Class, &str)]) -> Signs {
        let said: Vec<_> = layers.iter().map(|(class, sign)| (*class, Sign::named(sign))).collect();
        Signs::of_layers(&said)
    }

    #[test]
    fn directions_mean_the_nearest_class() {
        for (degrees, class) in [
            (0.0, Class::Blue),
            (22.0, Class::Blue),
            (23.0, Class::Green),
            (90.0, Class::Yellow),
            (135.0, Class::Red),
            (157.0, Class::Red),
            (158.0, Class::Blue),
            (179.9, Class::Blue),
        ] {
            assert_eq!(signs(&[]).along(degrees), Some(class), "{degrees}");
        }
    }

    #[test]
    fn layers_say_their_signs_and_push_out_those_that_are_like_them() {
        let swapped = signs(&[(Class::Blue, "rhombus 90")]);
        assert_eq!(swapped.along(85.0), Some(Class::Blue));
        assert_eq!(swapped.sign(Class::Yellow), None, "nothing is known of it but that it is not blue's");
        assert_eq!(swapped.sign(Class::Red), Some(Sign::Rhombus { degrees: 135.0 }));
        let dots = signs(&[(Class::Red, "dot"), (Class::Green, "nonsense")]);
        assert_eq!((dots.sign(Class::Red), dots.sign(Class::Grey)), (Some(Sign::Dot), None));
        assert_eq!(dots.sign(Class::Green), Some(Sign::Rhombus { degrees: 45.0 }));
    }

    #[test]
    fn a_direction_is_clear_away_from_the_middle_between_two_signs() {
        let feel = |degrees, coherence| Feel { ink: 0.1, coherence, degrees };
        let paper = signs(&[]);
        // the middles: 30 between blue and green, 80 between green and yellow
        let leaning = signs(&[(Class::Green, "rhombus 60"), (Class::Yellow, "rhombus 100")]);
        for (signs, degrees, class, clear) in [
            (paper, 18.0, Class::Blue, true),
            (paper, 19.0, Class::Blue, false),
            (paper, 26.0, Class::Green, false),
            (paper, 27.0, Class::Green, true),
            (leaning, 25.0, Class::Blue, true),
            (leaning, 27.0, Class::Blue, false),
            (leaning, 75.0, Class::Green, true),
            (leaning, 77.0, Class::Green, false),
            (leaning, 85.0, Class::Yellow, true),
        ] {
            assert_eq!(signs.read(&feel(degrees, 0.9), 1.0), (Some(class), clear), "{degrees}");
        }
        assert_eq!(paper.read(&feel(0.0, 0.1), 1.0), (Some(Class::Grey), true));
        assert_eq!(paper.read(&feel(0.0, 0.29), 1.0), (Some(Class::Grey), false));
    }

    #[test]
    fn where_no_sign_fits_nothing_is_clear() {
        let feel = |coherence| Feel { ink: 0.1, coherence, degrees: 2.0 };
        let rows = ["0", "36", "72", "108", "144"].map(|degrees| format!("rhombus {degrees}"));
        let layers: Vec<_> = Class::ALL.into_iter().zip(rows.iter().map(String::as_str)).collect();
        assert_eq!(signs(&layers).read(&feel(0.1), 1.0), (Some(Class::Blue), false));
        assert_eq!(signs(&layers).read(&feel(0.9), 1.0), (Some(Class::Blue), true));
        let dots = signs(&Class::ALL.map(|class| (class, "dot")));
        assert!(!dots.read(&feel(0.9), 1.0).1);
        let alike = signs(&[(Class::Blue, "rhombus 0"), (Class::Red, "rhombus 0")]);
        assert!(!alike.read(&feel(0.9), 1.0).1, "either could be meant");
    }
}
