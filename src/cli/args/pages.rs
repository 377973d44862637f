//! `--page`: which pages of a document.

use std::str::FromStr;

/// A page of a document, or several one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::cli) enum Pages {
    /// One, whose result is called as the document is.
    One(u32),
    /// From the first to the last of these; the names of their results end in the page.
    Range(u32, u32),
}

/// Most pages at once: a slip such as 1-10000 should not begin to fill a disk.
const MOST: u32 = 500;

/// Largest number of a page.
const LARGEST: u32 = 100_000;

impl Pages {
    /// Their numbers in order.
    pub(in crate::cli) fn numbers(self) -> std::ops::RangeInclusive<u32> {
        match self {
            Self::One(page) => page..=page,
            Self::Range(first, last) => first..=last,
        }
    }
}

impl FromStr for Pages {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|number| (1..=LARGEST).contains(number));
        let pages = match text.split_once('-') {
            None => number(text).map(Self::One),
            Some((first, last)) => number(first).zip(number(last)).map(|(first, last)| Self::Range(first, last)),
        };
        match pages {
            Some(Self::Range(first, last)) if first > last => Err(format!("give the lower page first: {last}-{first}")),
            Some(Self::Range(first, last)) if last - first >= MOST => {
                Err(format!("these are {} pages, and {MOST} at once are the most", last - first + 1))
            }
            Some(pages) => Ok(pages),
            None => Err("give a page such as 3, or pages such as 1-4; the first is 1".into()),
        }
    }
}

#[cfg(test)]
mod tests;
