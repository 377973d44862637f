//! "Did you mean": of the names that exist, those nearest to one that does not.

use crate::listing::list;

/// How many letters of a name are compared; no real one has as many.
const LONGEST: usize = 40;

/// How many names are offered at most: more are no help.
const MOST: usize = 4;

/// What lies nearest to a wrong name.
pub(crate) struct Nearest<'a> {
    /// Slips between the wrong name and these; `usize::MAX` when nothing is near.
    pub(crate) distance: usize,
    /// What to offer.
    pub(crate) offers: Vec<&'a str>,
}

/// Of pairs (name, what to offer for it), those nearest to `wrong`, if any is near at all.
pub(crate) fn nearest<'a>(wrong: &str, names: impl Iterator<Item = (&'a str, &'a str)>) -> Nearest<'a> {
    let wrong = wrong.chars().take(LONGEST).collect::<String>().to_lowercase().replace('-', "_");
    let sorted_wrong = sorted_words(&wrong);
    let mut near = Nearest { distance: usize::MAX, offers: Vec::new() };
    for (name, offer) in names {
        let known = name.replace('-', "_");
        // The same words in another order (max_width) are one slip, however many letters moved.
        let distance =
            strsim::osa_distance(&wrong, &known).min(1 + strsim::osa_distance(&sorted_wrong, &sorted_words(&known)));
        // A third of the letters wrong is about as far as a slip goes.
        if distance > known.chars().count().div_ceil(3).min(3) || distance > near.distance {
            continue;
        }
        if distance < near.distance {
            near = Nearest { distance, offers: Vec::new() };
        }
        near.offers.push(offer);
    }
    near
}

fn sorted_words(name: &str) -> String {
    let mut words: Vec<_> = name.split('_').collect();
    words.sort_unstable();
    words.join("_")
}

/// A question that offers the nearest names, if there are any.
pub(crate) fn did_you_mean(near: &[&str]) -> Option<String> {
    let near = &near[..near.len().min(MOST)];
    (!near.is_empty()).then(|| format!("did you mean {}?", list(near, "or")))
}

/// The end of what is said of a value that is none of these: the nearest ones.
pub(super) fn nearest_value<'a>(wrong: &str, values: impl Iterator<Item = &'a str>) -> Option<String> {
    let near = nearest(wrong, values.map(|value| (value, value)));
    let quoted: Vec<_> = near.offers.iter().map(|value| format!("\"{value}\"")).collect();
    did_you_mean(&quoted.iter().map(String::as_str).collect::<Vec<_>>())
}

/// Whether a typed word is a known one, or, where both are long enough, one slip away from it.
pub(super) fn is_misspelt(known: &str, typed: &str) -> bool {
    let typed: String = typed.chars().take(LONGEST).collect();
    known == typed || known.len() >= 4 && strsim::osa_distance(known, &typed) <= 1
}

#[cfg(test)]
mod tests;
