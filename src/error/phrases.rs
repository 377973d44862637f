//! Parts of the sentences of errors.

use crate::profile::did_you_mean;

/// How the sentence of an unknown name goes on before the names that there are.
pub(super) fn take_one(nearest: &[String]) -> String {
    let names: Vec<&str> = nearest.iter().map(String::as_str).collect();
    let meant = did_you_mean(&names);
    meant.map_or_else(|| "; take one of".to_owned(), |question| format!(", {question} Take one of"))
}

pub(super) fn or_without(overview: &Option<f32>) -> String {
    overview.map_or_else(String::new, |most| format!(", or {most:.1} mm without the overview (overview = false)"))
}

pub(super) fn has_pages(pages: &usize) -> String {
    match pages {
        1 => "the file has one page; leave the page out, or give 1".to_owned(),
        _ => format!("the document has {pages} pages; give a number from 1 to {pages}"),
    }
}

/// What to do about a file of too much: an object of a page is put right in it.
pub(super) fn simpler(format: &str) -> &'static str {
    match format {
        "page" => "put that right in the program in which it was drawn, or delete it there",
        _ => "simplify it or make it smaller in a drawing program, or convert a picture of it (PNG)",
    }
}

pub(super) fn hint(looks_like: &Option<&'static str>) -> String {
    looks_like.map_or_else(String::new, |what| format!("; it looks like {what}"))
}
