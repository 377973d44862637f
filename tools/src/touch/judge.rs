//! Is what is felt what was painted?

use tactograph::internals::geom::distance::distances;
use tactograph::internals::page::{Class, Page};
use tactograph::internals::touch::FeltCells;
use tactograph::internals::units::{MmPoint, Size};

use super::scenes::{Scene, Truth};

/// Places nearer to a border than this are not judged, mm.
const INSIDE: f32 = 7.0;
/// A change of a colour channel from one pixel to the next from which there is a border, 0..=1: wheels and ramps change by
/// 0.02 at most.
const JUMP: f32 = 0.04;
/// Lighter places need not be felt.
const LIGHTEST: f32 = 0.88;
/// Places are judged this far from one another, mm.
const EVERY: f32 = 1.0;

/// The place of white in a tally: after all classes.
const BLANK: usize = Class::ALL.len();
/// The places of all classes in a tally.
pub const CLASSES: std::ops::Range<usize> = 0..BLANK;

/// How many places of each class (white is the last) were judged, and as what they were felt.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Tally {
    /// For each class painted, how often each was felt.
    pub felt: [[u32; BLANK + 1]; BLANK + 1],
}

/// The place of a class in a tally; blank is the last.
pub fn index(class: Option<Class>) -> usize {
    class.and_then(|class| Class::ALL.iter().position(|other| *other == class)).unwrap_or(BLANK)
}

/// The place of one class, or of white, in a tally, for [`Tally::share`].
pub fn only(class: Option<Class>) -> std::ops::Range<usize> {
    index(class)..index(class) + 1
}

impl Tally {
    /// Adds what another scene gave.
    pub fn add(&mut self, other: &Self) {
        for (row, more) in self.felt.iter_mut().zip(other.felt) {
            row.iter_mut().zip(more).for_each(|(count, more)| *count += more);
        }
    }

    /// How many places of these classes were judged, and the share that was felt right.
    pub fn share(&self, classes: std::ops::Range<usize>) -> (u32, f32) {
        let judged: u32 = classes.clone().flat_map(|class| self.felt[class]).sum();
        let right: u32 = classes.map(|class| self.felt[class][class]).sum();
        (judged, if judged > 0 { right as f32 / judged as f32 } else { f32::NAN })
    }
}

/// Places of a scene that are judged: pixel and class, and where it lies in the picture.
fn judged(scene: &Scene, mm_per_px: f32) -> Vec<(usize, usize, Option<Class>)> {
    let side = scene.side;
    let every = ((EVERY / mm_per_px).round() as usize).max(1);
    let class = |truth: Truth| match truth {
        Truth::Colour(class, _) => index(Some(class)),
        Truth::White => BLANK,
        Truth::Unknown => BLANK + 1,
    };
    let border: Vec<bool> = (0..side * side)
        .map(|i| {
            let (x, y) = (i % side, i / side);
            let jump = |other: usize| {
                let pairs = scene.colours[other].iter().zip(scene.colours[i]);
                pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max) > JUMP
            };
            let differs = |other: usize| class(scene.truth[other]) != class(scene.truth[i]) || jump(other);
            let edge = x == 0 || y == 0 || x + 1 == side || y + 1 == side;
            edge || differs(i - 1) || differs(i - side) || differs(i + 1) || differs(i + side)
        })
        .collect();
    let far = distances(&border, Size::new(side as u32, side as u32));
    let wanted = |truth| match truth {
        Truth::Colour(class, lightness) => (lightness <= LIGHTEST).then_some(Some(class)),
        Truth::White => Some(None),
        Truth::Unknown => None,
    };
    let places = (0..side).step_by(every).flat_map(|y| (0..side).step_by(every).map(move |x| (x, y)));
    let inside = places.filter(|(x, y)| far[y * side + x] * mm_per_px > INSIDE);
    inside.filter_map(|(x, y)| wanted(scene.truth[y * side + x]).map(|class| (x, y, class))).collect()
}

/// Holds what is felt on the page of a scene against the scene.
pub fn judge(scene: &Scene, page: &Page, felt: &FeltCells) -> Tally {
    let place = page.figure.place;
    let mm_per_px = place.width() / scene.side as f32;
    let mut tally = Tally::default();
    for (x, y, class) in judged(scene, mm_per_px) {
        let at = MmPoint::new((x as f32 + 0.5) * mm_per_px, (y as f32 + 0.5) * mm_per_px) + place.min.to_vector();
        let felt = felt.at(at).and_then(|place| place.felt);
        tally.felt[index(class)][index(felt)] += 1;
    }
    tally
}

/// One texture all over a page, and what is felt of it: the share of places, further than [`INSIDE`] from its edge, that are
/// felt as `class`.
pub fn share_of_sample(class: Class, felt: &FeltCells, place: tactograph::internals::units::MmRect) -> f32 {
    let inner = place.inflate(-INSIDE, -INSIDE);
    let (mut judged, mut right) = (0, 0);
    let steps = |side: f32| (side / EVERY) as u32;
    for j in 0..steps(inner.height()) {
        for i in 0..steps(inner.width()) {
            let at = MmPoint::new(inner.min.x + i as f32 * EVERY, inner.min.y + j as f32 * EVERY);
            judged += 1;
            right += u32::from(felt.at(at).and_then(|place| place.felt) == Some(class));
        }
    }
    right as f32 / judged.max(1) as f32
}
