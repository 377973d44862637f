//! Entities that a document declares, as Illustrator does for its namespaces, replaced by what they stand for: elements
//! that come out of an entity have no place in the text, and ids are added there.

use std::collections::HashMap;

/// Entities in entities.
const DEEPEST: usize = 10;
/// How much longer a text may become, bytes: those of Illustrator take a few thousand.
const MOST_MORE: usize = 1 << 20;

fn too_much() -> String {
    format!("its entities stand for too much text: more than {MOST_MORE} bytes, or over {DEEPEST} one inside the other")
}

/// The text without its declarations, each entity of which is replaced.
///
/// # Errors
/// If that makes it too long. Loops must have been refused before.
pub(super) fn replaced(text: &str) -> Result<String, String> {
    let Some((before, declarations, after)) = parts(text) else { return Ok(text.to_owned()) };
    let entities = declared(declarations);
    let mut out = before.to_owned();
    expand(after, &entities, 0, &mut out, text.len() + MOST_MORE)?;
    Ok(out)
}

/// What stands before the document type, its declarations, and what stands after it.
fn parts(text: &str) -> Option<(&str, &str, &str)> {
    let start = text.find("<!DOCTYPE")?;
    let open = start + outside_quotes(&text[start..], &['[', '>'])?;
    let inner = text[open..].strip_prefix('[')?;
    let at = outside_quotes(inner, &[']'])?;
    let end = at + inner[at..].find('>')? + 1;
    Some((&text[..start], &inner[..at], &inner[end..]))
}

/// Where the first of these letters stands that is in no quotation marks and in no comment.
fn outside_quotes(text: &str, wanted: &[char]) -> Option<usize> {
    let mut at = 0;
    loop {
        let rest = &text[at..];
        let letter = rest.chars().next()?;
        at += match letter {
            _ if wanted.contains(&letter) => return Some(at),
            '"' | '\'' => 2 + rest[1..].find(letter)?,
            '<' if rest.starts_with("<!--") => rest.find("-->")? + 3,
            _ => letter.len_utf8(),
        };
    }
}

/// Names and texts of declared entities; the first of two counts. Those of other files are not read.
fn declared(declarations: &str) -> HashMap<&str, String> {
    let mut entities = HashMap::new();
    for declaration in declarations.split("<!ENTITY").skip(1) {
        let declaration = declaration.trim_start();
        let Some((name, rest)) = declaration.split_once(char::is_whitespace) else { continue };
        let rest = rest.trim_start();
        let Some(quote) = rest.chars().next().filter(|quote| ['"', '\''].contains(quote)) else { continue };
        let Some(value) = rest[1..].split(quote).next() else { continue };
        // a quotation mark in a value ends no attribute that the entity stands in
        let value = match value.contains('<') {
            true => value.to_owned(),
            false => value.replace('"', "&quot;").replace('\'', "&apos;"),
        };
        entities.entry(name).or_insert(value);
    }
    entities
}

/// Writes a text with its entities replaced; those that are not declared, and comments and literal text, as they are.
fn expand(
    text: &str,
    entities: &HashMap<&str, String>,
    depth: usize,
    out: &mut String,
    most: usize,
) -> Result<(), String> {
    let mut rest = text;
    while let Some(at) = rest.find(['&', '<']) {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        let literal = [("<!--", "-->"), ("<![CDATA[", "]]>")].into_iter().find(|(begin, _)| from.starts_with(begin));
        let entity = from.strip_prefix('&').and_then(|from| from.split_once(';'));
        let entity = entity.and_then(|(name, after)| Some((entities.get(name)?, after)));
        rest = match (literal, entity) {
            (Some((_, end)), _) => {
                let length = from.find(end).map_or(from.len(), |at| at + end.len());
                out.push_str(&from[..length]);
                &from[length..]
            }
            (None, Some((value, after))) => {
                if depth >= DEEPEST || out.len() + value.len() > most {
                    return Err(too_much());
                }
                expand(value, entities, depth + 1, out, most)?;
                after
            }
            (None, None) => {
                out.push_str(&from[..1]);
                &from[1..]
            }
        };
    }
    out.push_str(rest);
    if out.len() > most { Err(too_much()) } else { Ok(()) }
}

#[cfg(test)]
mod tests;
