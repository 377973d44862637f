//! Where the signs of capitals stand.

use super::table::{CapitalPassage, Capitals};

/// What is written before and after a character for the sake of capitals.
#[derive(Debug, Clone, Default)]
pub(super) struct CapitalContext {
    pub(super) before: Vec<u8>,
    pub(super) after: Vec<u8>,
}

/// The signs of capitals around each character.
pub(super) fn signs(text: &[char], capitals: &Capitals) -> Vec<CapitalContext> {
    let mut around = vec![CapitalContext::default(); text.len()];
    let words = words(text);
    let mut next = 0;
    while next < words.len() {
        let in_passage =
            capitals.passage.as_ref().and_then(|passage| Some((passage, length(text, &words[next..], passage)?)));
        match in_passage {
            Some((passage, count)) => {
                mark_passage(text, &words[next..next + count], passage, &mut around);
                next += count;
            }
            None => {
                mark_word(text, words[next].clone(), capitals, &mut around);
                next += 1;
            }
        }
    }
    around
}

/// Where the words of a text lie.
fn words(text: &[char]) -> Vec<std::ops::Range<usize>> {
    let mut words = Vec::new();
    let mut from = 0;
    for (i, &letter) in text.iter().chain([&' ']).enumerate() {
        if letter == ' ' {
            if i > from {
                words.push(from..i);
            }
            from = i + 1;
        }
    }
    words
}

fn has_capital(word: &[char]) -> bool {
    word.iter().any(|letter| letter.is_uppercase())
}

/// How many words from the first on are a passage of capitals, if they are. Words without letters may lie in it.
fn length(text: &[char], words: &[std::ops::Range<usize>], passage: &CapitalPassage) -> Option<usize> {
    let of = |word: &std::ops::Range<usize>| &text[word.clone()];
    has_capital(of(words.first()?)).then_some(())?;
    let without_small = words.iter().take_while(|word| !of(word).iter().any(|letter| letter.is_lowercase())).count();
    let last = words[..without_small].iter().rposition(|word| has_capital(of(word)))?;
    let count = words[..=last].iter().filter(|word| has_capital(of(word))).count();
    (count >= passage.words).then_some(last + 1)
}

fn mark_passage(
    text: &[char],
    words: &[std::ops::Range<usize>],
    passage: &CapitalPassage,
    around: &mut [CapitalContext],
) {
    let first_capital = |word: &std::ops::Range<usize>| word.clone().find(|&i| text[i].is_uppercase());
    let (Some(first), Some(last)) = (words.first(), words.last()) else { return };
    if let Some(at) = first_capital(first) {
        around[at].before.extend(&passage.begin);
    }
    if passage.before_last {
        if let Some(at) = first_capital(last) {
            around[at].before.extend(&passage.end);
        }
    } else {
        around[last.end - 1].after.extend(&passage.end);
    }
}

fn mark_word(text: &[char], word: std::ops::Range<usize>, capitals: &Capitals, around: &mut [CapitalContext]) {
    let mut i = word.start;
    while i < word.end {
        if !text[i].is_uppercase() {
            i += 1;
            continue;
        }
        let end = end_of_run(text, i, word.end, &capitals.through);
        let count = text[i..end].iter().filter(|letter| letter.is_uppercase()).count();
        let through = text[end..word.end].iter().take_while(|sign| capitals.through.contains(sign)).count();
        let small = text.get(end + through).filter(|letter| end + through < word.end && letter.is_lowercase());
        match (&capitals.end, small) {
            _ if count == 1 => around[i].before.extend(&capitals.letter),
            (None, Some(_)) => {
                let each = (i..end).filter(|&at| text[at].is_uppercase());
                each.for_each(|at| around[at].before.extend(&capitals.letter));
            }
            (ending, _) => {
                around[i].before.extend(&capitals.word);
                if let (Some(ending), Some(_)) = (ending, small) {
                    around[end + through].before.extend(ending);
                }
            }
        }
        i = end;
    }
}

/// Where capitals that begin at `from` end, with signs that they go through.
fn end_of_run(text: &[char], from: usize, word_end: usize, through: &[char]) -> usize {
    let mut end = from;
    let mut i = from;
    while i < word_end && (text[i].is_uppercase() || through.contains(&text[i])) {
        i += 1;
        if text[i - 1].is_uppercase() {
            end = i;
        }
    }
    end
}
