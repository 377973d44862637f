//! Sentences among the texts of a drawing, such as the instructions of a worksheet. They name nothing: a leader line
//! from one would lead to what stands beside it by chance.

/// Fewest words of a sentence that ends like one, or has its number.
const WITH_MARK: usize = 3;
/// Fewest words of one without either: a name is shorter, or most of its words begin with capitals.
const WITHOUT_MARK: usize = 4;
/// From so many words on a text is no name, whatever its words begin with.
const MANY: usize = 7;
/// Places to write on: characters of a row of which there are at least so many.
const TO_WRITE_ON: [&str; 2] = ["__", "...."];

/// Whether a text is a sentence, or a line to write on; one `beside_line` may be a long name of that, and is a sentence
/// only if it ends like one, or has a number.
pub(super) fn is_sentence(text: &str, beside_line: bool) -> bool {
    let text = text.trim();
    let is_word = |word: &&str| word.chars().any(char::is_alphabetic);
    let mut all = text.split_whitespace().peekable();
    let has_number = all.next_if(|first| is_number(first)).is_some();
    let words: Vec<&str> = all.filter(is_word).collect();
    let is_ended = text.ends_with(['.', '?', '!', '…']);
    let begins_low = |word: &&str| !word.chars().find(|sign| sign.is_alphabetic()).is_some_and(char::is_uppercase);
    let is_like_one = || words.first().is_some_and(|first| !begins_low(first)) && words.iter().skip(1).all(begins_low);
    let is_long = || words.len() >= MANY || words.len() >= WITHOUT_MARK && is_like_one();
    TO_WRITE_ON.iter().any(|row| text.contains(row))
        || words.len() >= WITH_MARK && (is_ended || has_number)
        || !beside_line && is_long()
}

/// Whether a word is the number of a task: "1.", "2)", "(a)", "b)".
fn is_number(word: &str) -> bool {
    let of = word.trim_start_matches('(').trim_end_matches([')', '.']);
    let is_letter = || of.chars().count() == 1 && of.chars().all(char::is_alphabetic);
    let is_digits = || !of.is_empty() && of.chars().all(|sign| sign.is_ascii_digit());
    word.ends_with([')', '.']) && (is_digits() || is_letter())
}

#[cfg(test)]
mod tests;
