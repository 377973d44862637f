//! Straight single quotation marks, which keyboards have for apostrophes too.

/// The straight mark, and the two that open and close.
const STRAIGHT: char = '\'';
const OPENS: char = '\u{2018}';
const CLOSES: char = '\u{2019}';
/// Marks behind which a quotation opens, besides a blank, and those before which it closes.
const BEFORE: &str = "([{\"\u{201c}\u{2013}\u{2014}/-";
const BEHIND: &str = ".,;:!?)]}\"\u{201d}\u{2026}\u{2013}\u{2014}/-";
/// Words that begin with an apostrophe, besides decades, without it.
const SHORTENED: [&str; 4] = ["tis", "twas", "em", "til"];

/// Turns straight marks that open and close a quotation into those that do: the first behind a blank or at the
/// beginning and the next behind a word. One of which the other is missing is an apostrophe, as of 'tis and the boys',
/// and so are the two around a single letter, as in rock 'n' roll, and the two of 'tis the boys' bike.
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
        if are_apostrophes(text, open, close) {
            from = open + 1;
            continue;
        }
        if close > open + 2 || text[open + 1].0.is_numeric() {
            text[open].0 = OPENS;
            text[close].0 = CLOSES;
        }
        from = close + 1;
    }
}

/// Whether two marks are those of a word that begins with an apostrophe and of one that ends in s and another. A
/// quotation of such a word alone is one.
fn are_apostrophes(text: &[(char, usize)], open: usize, close: usize) -> bool {
    let inside = &text[open + 1..close];
    let word: String = inside.iter().map(|(sign, _)| *sign).take_while(|sign| sign.is_alphanumeric()).collect();
    let years = word.strip_suffix('s').filter(|years| years.len() == 2);
    let is_decade = years.is_some_and(|years| years.bytes().all(|digit| digit.is_ascii_digit()));
    let is_shortened = is_decade || SHORTENED.iter().any(|of| word.eq_ignore_ascii_case(of));
    let ends_in_s = inside.last().is_some_and(|(sign, _)| sign.eq_ignore_ascii_case(&'s'));
    is_shortened && ends_in_s && word.chars().count() < inside.len()
}

#[cfg(test)]
mod tests;
