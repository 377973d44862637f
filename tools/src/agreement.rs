//! How far the marks of two pages of one picture agree.

use usvg::roxmltree::{Document, Node};

/// What says how a page was made and what is on it, in words.
const WORDS: [&str; 3] = ["title", "desc", "metadata"];

/// How far the marks of two pages agree that have the same ones.
#[derive(Debug, PartialEq)]
pub struct Agreement {
    /// How many there are on each.
    pub marks: usize,
    /// How many have another number.
    pub different: usize,
    /// Largest difference between two numbers, mm.
    pub most: f64,
}

/// Compares two pages, as SVG.
///
/// # Errors
/// If one cannot be read, or the two have other marks.
pub fn compare(a: &str, b: &str) -> Result<Agreement, String> {
    let documents = [a, b].map(|text| Document::parse(text).map_err(|error| error.to_string()));
    let [a, b] = documents;
    let (a, b) = (a?, b?);
    let (a, b) = (marks(&a), marks(&b));
    if a.len() != b.len() {
        return Err(format!("there are {} marks on one page and {} on the other", a.len(), b.len()));
    }
    let mut agreement = Agreement { marks: a.len(), different: 0, most: 0.0 };
    for (a, b) in a.iter().zip(&b) {
        let [(own_words, own), (other_words, other)] = [split(a), split(b)];
        if own_words != other_words || own.len() != other.len() {
            return Err(format!("these are other marks: {a} and {b}"));
        }
        let apart = own.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        agreement.different += usize::from(apart > 0.0);
        agreement.most = agreement.most.max(apart);
    }
    Ok(agreement)
}

/// Every element that draws, with its attributes.
fn marks(document: &Document<'_>) -> Vec<String> {
    let is_words = |node: Node<'_, '_>| node.ancestors().any(|above| WORDS.contains(&above.tag_name().name()));
    let drawn = document.descendants().filter(|node| node.is_element() && !is_words(*node));
    drawn
        .map(|node| {
            let attributes = node.attributes().map(|attribute| format!(" {}={}", attribute.name(), attribute.value()));
            node.tag_name().name().to_owned() + &attributes.collect::<String>()
        })
        .collect()
}

/// What is written apart from its numbers, and these.
fn split(text: &str) -> (String, Vec<f64>) {
    let is_of_number = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '-');
    let (mut words, mut numbers) = (String::new(), Vec::new());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|letter| is_of_number(letter) != is_of_number(first)).unwrap_or(rest.len());
        match rest[..end].parse() {
            Ok(number) => numbers.push(number),
            Err(_) => words.push_str(&rest[..end]),
        }
        rest = &rest[end..];
    }
    (words, numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(title: &str, d: &str) -> String {
        format!("<svg><title>{title}</title><g id=\"lines\"><path d=\"{d}\"/></g></svg>")
    }

    #[test]
    fn numbers_may_differ_and_marks_may_not() {
        let a = page("a", "M1,2.5L-3,4");
        let agreement = |marks, different, most| Ok(Agreement { marks, different, most });
        assert_eq!(compare(&a, &page("b", "M1,2.5L-3,4")), agreement(3, 0, 0.0));
        assert_eq!(compare(&a, &page("b", "M1,2L-3,4")), agreement(3, 1, 0.5));
        assert!(compare(&a, &page("b", "M1,2.5L-3,4 5,6")).is_err());
        assert!(compare(&a, &page("b", "M1,2.5C-3,4")).is_err());
        assert!(compare(&a, &a.replace("</g>", "<path d=\"M0,0\"/></g>")).is_err());
    }
}
