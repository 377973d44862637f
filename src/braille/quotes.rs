//! Straight single quotation marks, which keyboards have for apostrophes too.

/// The straight mark, and the two that open and close.
const STRAIGHT: char = '\'';
const OPENS: char = '\u{2018}';
const CLOSES: char = '\u{2019}';
/// Marks behind which a quotation opens, besides a blank, and those before which it closes.
const BEFORE: &str = "([{\"\u{201c}\u{2013}\u{2014}/-";
const BEHIND: &str = ".,;:!?)]}\"\u{201d}\u{2026}\u{2013}\u{2014}/-";

/// Turns straight marks that open and close a quotation into those that do: the first behind a blank or at the
/// beginning and the next behind a word. One of which the other is missing is an apostrophe, as of 'tis and the boys',
/// and so are the two around a single letter, as in rock 'n' roll.
pub(super) fn paired(text: &mut [(char, usize)]) {
    let at = |text: &[(char, usize)], i: Option<usize>| i.and_then(|i| text.get(i)).map(|(character, _)| *character);
    let mut from = 0;
    while let Some(open) = (from..text.len()).find(|&i| {
        let (before, behind) = (at(text, i.checked_sub(1)), at(text, Some(i + 1)));
        let is_free = before.is_none_or(|before| before == ' ' || BEFORE.contains(before));
        text[i].0 == STRAIGHT && is_free && behind.is_some_and(char::is_alphanumeric)
    }) {
        let closing = (open + 2..text.len()).find(|&i| {
            let (before, behind) = (at(text, Some(i - 1)), at(text, Some(i + 1)));
            let is_free = behind.is_none_or(|behind| behind == ' ' || BEHIND.contains(behind));
            text[i].0 == STRAIGHT && is_free && before.is_some_and(|before| before != ' ' && before != STRAIGHT)
        });
        let Some(close) = closing else { return };
        if close > open + 2 || text[open + 1].0.is_numeric() {
            text[open].0 = OPENS;
            text[close].0 = CLOSES;
        }
        from = close + 1;
    }
}

#[cfg(test)]
mod tests;
