//! Addresses of mail and of pages of the net, which some codes announce.

/// Where in a text an address begins: its first letter, digit or sign of mail.
pub(super) fn places(text: &[char]) -> Vec<usize> {
    let mut places = Vec::new();
    let mut begin = 0;
    for word in text.split(|character| *character == ' ') {
        let is_sign = |character: char| character == '@' || character.is_alphanumeric();
        let first = word.iter().position(|&character| is_sign(character));
        places.extend(first.filter(|_| is_address(word)).map(|first| begin + first));
        begin += word.len() + 1;
    }
    places
}

fn is_address(word: &[char]) -> bool {
    let word: String = word.iter().collect::<String>().to_lowercase();
    let begins = word.trim_start_matches(|character: char| !character.is_alphanumeric());
    word.contains('@') || word.contains("://") || begins.starts_with("www.")
}

#[cfg(test)]
mod tests;
