//! What was felt, in numbers and in sentences that can be read aloud.

use std::fmt;

use super::measure::{CELLS_PER_MM, PX_PER_MM};
use super::{Felt, Ink, JUDGED_FROM, Place, count};
use crate::page::Class;

/// What was felt on a page.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Size of the fingertip, mm.
    pub finger: f32,
    /// One for each class that is on the page, in the order of [`Class::ALL`].
    pub classes: Vec<OfClass>,
}

/// What was felt of one class's textures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OfClass {
    /// The class that is meant.
    pub class: Class,
    /// The area of its textures, mm^2.
    pub area: f32,
    /// The part of it that is far enough from lines and borders to be judged, mm^2.
    pub judged: f32,
    /// Share of the judged area that is clearly felt as the class, 0..=1; 0 where nothing is judged.
    pub right: f32,
    /// Share that is clearly felt as another.
    pub wrong: f32,
    /// Share that could as well be felt as another; the three sum to 1.
    pub unclear: f32,
    /// The class that most of the wrong part is felt as, and `None` in it for blank.
    pub mostly_felt_as: Option<Option<Class>>,
    /// Ink in the area, 0..=1.
    pub ink: f32,
    /// Glyphs to a square centimetre.
    pub density: f32,
}

impl Report {
    /// The report on `felt`, which was felt in `ink`.
    pub fn of(ink: &Ink, felt: &Felt) -> Self {
        let classes = ink.textures.iter().map(|(class, plane)| {
            let cell = 1.0 / (CELLS_PER_MM * CELLS_PER_MM) as f32;
            let area_of = |wanted: &dyn Fn(&Place) -> bool| {
                let of_class = felt.places.iter().filter(|place| place.meant == Some(*class));
                of_class.filter(|place| wanted(place)).count() as f32 * cell
            };
            let area = area_of(&|_| true);
            let judged = area_of(&|place| place.judged);
            let right = area_of(&|place| place.judged && place.clear && place.felt == Some(*class));
            let unclear = area_of(&|place| place.judged && !place.clear);
            let share = |part: f32| if judged > 0.0 { part / judged } else { 0.0 };
            let felt_as = |other: Option<Class>| area_of(&|place| place.judged && place.clear && place.felt == other);
            let others = Class::ALL.map(Some).into_iter().chain([None]).filter(|other| *other != Some(*class));
            let mostly = others.map(|other| (felt_as(other), other)).max_by(|a, b| a.0.total_cmp(&b.0));
            let inked = plane.values.iter().sum::<f32>() / (PX_PER_MM * PX_PER_MM) as f32;
            let per_area = |amount: f32| if area > 0.0 { amount / area } else { 0.0 };
            OfClass {
                class: *class,
                area,
                judged,
                right: share(right),
                wrong: share(judged - right - unclear),
                unclear: share(unclear),
                mostly_felt_as: mostly.filter(|(size, _)| *size > 0.0).map(|(_, other)| other),
                ink: per_area(inked).min(1.0),
                density: 100.0 * per_area(count::patches(plane) as f32),
            }
        });
        Self { finger: felt.finger, classes: classes.filter(|of| of.area > 0.0).collect() }
    }

    /// The sums over all classes: area, judged area (mm^2), and the shares of right, wrong and unclear in it.
    pub fn totals(&self) -> (f32, f32, [f32; 3]) {
        let sum = |value: &dyn Fn(&OfClass) -> f32| self.classes.iter().map(value).sum::<f32>();
        let judged = sum(&|of| of.judged);
        let share = |value: f32| if judged > 0.0 { value / judged } else { 0.0 };
        let shares = [
            share(sum(&|of| of.right * of.judged)),
            share(sum(&|of| of.wrong * of.judged)),
            share(sum(&|of| of.unclear * of.judged)),
        ];
        (sum(&|of| of.area), judged, shares)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.classes.is_empty() {
            return writeln!(f, "There are no textures on this page: a fingertip feels blank paper and lines.");
        }
        writeln!(f, "What a fingertip of {} mm feels, colour by colour:", self.finger)?;
        let (area, judged, [right, wrong, unclear]) = self.totals();
        for of in &self.classes {
            write!(f, "{}: {} of the textured area. ", of.class.name(), Percent(of.area / area))?;
            if of.judged > 0.0 {
                write!(f, "Felt right {}, ", Percent(of.right))?;
                write!(f, "unclear {}, wrong {}", Percent(of.unclear), Percent(of.wrong))?;
                if let Some(other) = of.mostly_felt_as {
                    write!(f, " (mostly as {})", other.map_or("blank paper", Class::name))?;
                }
                write!(f, ". ")?;
            } else {
                write!(f, "Too narrow everywhere to be judged. ")?;
            }
            writeln!(f, "Ink {}, {:.1} glyphs to a square centimetre.", Percent(of.ink), of.density)?;
        }
        if judged > 0.0 {
            let shares = format!("right {}, unclear {}, wrong {}", Percent(right), Percent(unclear), Percent(wrong));
            writeln!(f, "All textures: {shares}.")?;
        }
        let share = Percent(judged / area);
        writeln!(
            f,
            "{share} of the textured area is judged: what lies {JUDGED_FROM} mm or more from lines and borders."
        )
    }
}

/// A share as a reader says it. Nothing is called all or none that is not.
struct Percent(f32);

impl fmt::Display for Percent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.0;
        match percent {
            p if p > 0.0 && p < 0.5 => write!(f, "under 1 %"),
            p if (99.5..100.0).contains(&p) => write!(f, "over 99 %"),
            p => write!(f, "{p:.0} %"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_said_as_they_are() {
        for (share, want) in [(0.0, "0 %"), (0.001, "under 1 %"), (0.5, "50 %"), (0.997, "over 99 %"), (1.0, "100 %")] {
            assert_eq!(Percent(share).to_string(), want);
        }
    }

    #[test]
    fn a_page_without_textures_is_told_so() {
        let told = Report { finger: 1.0, classes: Vec::new() }.to_string();
        assert!(told.starts_with("There are no textures"), "{told}");
    }
}
