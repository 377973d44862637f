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
mod tests;
