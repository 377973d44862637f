//! What words need to know of the marks beside which they stand.

use super::legend::LegendEntry;
use super::lost_signs;
use super::words::Words;
use crate::lines::LostSign;
use crate::units::MmPoint;

/// What the marks of a picture say to its words.
pub(super) struct ForWords {
    legend: Vec<LegendEntry>,
    lost_points: Vec<MmPoint>,
    coloured_ground: bool,
}

impl ForWords {
    /// That of a drawing with its `own` legend, of which these small shapes are not on the page. If its words are no
    /// labels, a key tells only what the maker of the page gave, and which colours are blank.
    pub(super) fn of(words: &Words<'_>, own: Vec<LegendEntry>, lost: &[LostSign], coloured_ground: bool) -> Self {
        let legend = if words.own_texts {
            own
        } else {
            let given = words.legend.iter().filter(|entry| entry.has_meaning()).cloned();
            given.chain(own.into_iter().filter(|entry| !entry.has_meaning())).collect()
        };
        let lost_points = lost_signs::points(lost, &legend);
        Self { legend, lost_points, coloured_ground }
    }

    /// The words, which know of it.
    pub(super) fn known_to<'a>(&'a self, words: &Words<'a>) -> Words<'a> {
        let Self { legend, lost_points, coloured_ground } = self;
        Words { legend, lost_points, coloured_ground: *coloured_ground, ..*words }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Class;

    #[test]
    fn only_words_that_are_labels_are_told_by_the_legend_of_the_drawing() {
        let entry = |text: &str, class: Class| LegendEntry { text: text.to_owned(), ..LegendEntry::of_blank(class) };
        let given = [entry("forest", Class::Green)];
        let own = || vec![entry("lake", Class::Blue), entry("", Class::Red)];
        let told = |own_texts: bool| {
            let words = Words { own_texts, legend: &given, ..Words::default() };
            let known = ForWords::of(&words, own(), &[], true);
            let words = known.known_to(&words);
            assert!(words.coloured_ground && words.lost_points.is_empty());
            words.legend.iter().map(|entry| entry.text.clone()).collect::<Vec<_>>()
        };
        assert_eq!(told(true), ["lake", ""]);
        assert_eq!(told(false), ["forest", ""]);
    }
}
