//! Lists within a sentence, as they are read aloud.

/// "a", "a and b", "a, b and c"; or with another word in place of "and".
pub(crate) fn list<T: AsRef<str>>(items: &[T], and: &str) -> String {
    let items: Vec<&str> = items.iter().map(AsRef::as_ref).collect();
    match &items[..] {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}

/// The first of a list, at most so many, and how many more there are: "a, b and 3 more".
pub(crate) fn first_few<T>(all: &[T], most: usize, said: impl Fn(&T) -> String) -> String {
    let shown = all.iter().take(most).map(said).collect::<Vec<_>>().join(", ");
    match all.len().saturating_sub(most) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

/// What is shown of a list, and how many more such things there are: "a; b and 1 more place".
pub(crate) fn and_more(shown: &str, more: usize, thing: &str) -> String {
    match more {
        0 => shown.to_owned(),
        more => format!("{shown} and {}", counted(more, &format!("more {thing}"))),
    }
}

/// "1 line", "2 lines", for things that have a plain plural.
pub(crate) fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests;
