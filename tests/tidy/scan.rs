//! Reads Rust sources as text: enough to see every path that begins with `crate`, `super`, `std` or `tactograph`, and no
//! more. Comments, literals and what only tests compile are left out first.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The words of a source file's code, without comments, the insides of literals, and the items under `#[cfg(test)]`.
pub(crate) fn scan(text: &str) -> Vec<Token> {
    tokens(&without_tests(&code_of(text)))
}

/// `text` with comments and the insides of string and character literals turned to spaces; lines stay lines.
fn code_of(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut code = String::with_capacity(text.len());
    let mut at = 0;
    while at < chars.len() {
        let end = match literal_end(&chars, at) {
            Some(end) => end,
            None => {
                code.push(chars[at]);
                at += 1;
                continue;
            }
        };
        code.extend(chars[at..end].iter().map(|&c| if c == '\n' { '\n' } else { ' ' }));
        at = end;
    }
    code
}

/// Where the comment or literal that begins at `at` ends, if one begins there.
fn literal_end(chars: &[char], at: usize) -> Option<usize> {
    let peek = |offset: usize| chars.get(at + offset).copied().unwrap_or('\0');
    let find = |from: usize, wanted: &str| {
        let wanted: Vec<char> = wanted.chars().collect();
        (from..chars.len()).find(|&i| chars[i..].starts_with(&wanted)).map_or(chars.len(), |i| i + wanted.len())
    };
    match (peek(0), peek(1)) {
        ('/', '/') => Some((at..chars.len()).find(|&i| chars[i] == '\n').unwrap_or(chars.len())),
        ('/', '*') => {
            let (mut depth, mut i) = (0, at);
            while i < chars.len() {
                let pair = (chars[i], chars.get(i + 1).copied().unwrap_or('\0'));
                depth += i32::from(pair == ('/', '*')) - i32::from(pair == ('*', '/'));
                i += if pair == ('/', '*') || pair == ('*', '/') { 2 } else { 1 };
                if depth == 0 {
                    return Some(i);
                }
            }
            Some(chars.len())
        }
        ('r', '"' | '#') if at == 0 || !(chars[at - 1].is_alphanumeric() && chars[at - 1] != 'b') => {
            let hashes = chars[at + 1..].iter().take_while(|&&c| c == '#').count();
            (peek(1 + hashes) == '"').then(|| find(at + 2 + hashes, &format!("\"{}", "#".repeat(hashes))))
        }
        ('"', _) => Some(after_escapes(chars, at + 1, '"')),
        ('\'', '\\') => Some(after_escapes(chars, at + 1, '\'')),
        ('\'', _) if peek(2) == '\'' => Some(at + 3),
        _ => None,
    }
}

fn after_escapes(chars: &[char], mut at: usize, quote: char) -> usize {
    while at < chars.len() && chars[at] != quote {
        at += if chars[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(chars.len())
}

/// `code` without the items under `#[cfg(test)]`; lines stay lines.
fn without_tests(code: &str) -> String {
    let mut rest = code;
    let mut kept = String::with_capacity(code.len());
    while let Some(at) = rest.find("#[cfg(test)]") {
        kept.push_str(&rest[..at]);
        let (mut depth, mut brackets) = (0, 0);
        let end = rest[at..].char_indices().find(|&(_, c)| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            brackets += i32::from(c == '[') - i32::from(c == ']');
            brackets == 0 && depth == 0 && (c == '}' || c == ';')
        });
        let end = end.map_or(rest.len(), |(offset, _)| at + offset + 1);
        kept.extend(rest[at..end].chars().filter(|&c| c == '\n'));
        rest = &rest[end..];
    }
    kept + rest
}

/// A word, `::`, or any other single character.
#[derive(Debug)]
pub(crate) struct Token {
    pub(crate) text: String,
    pub(crate) line: usize,
}

fn tokens(code: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    for (line, text) in code.lines().enumerate().map(|(index, text)| (index + 1, text)) {
        let mut rest = text.trim_start();
        while let Some(first) = rest.chars().next() {
            let word = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
            let length = if rest.starts_with("::") { 2 } else { word.max(first.len_utf8()) };
            tokens.push(Token { text: rest[..length].into(), line });
            rest = rest[length..].trim_start();
        }
    }
    tokens
}

/// A path that the code names, from its root `crate`, `std` or `tactograph` on.
#[derive(Debug)]
pub(crate) struct Use {
    /// Number of the token that the rest of the path begins with.
    pub(crate) at: usize,
    pub(crate) line: usize,
    pub(crate) path: Vec<String>,
}

/// Every such path in a file of the module `own`; `super::` is followed up to the crate where it leaves the module.
pub(crate) fn paths(tokens: &[Token], file_module: &[String]) -> Vec<Use> {
    let is = |at: usize, text: &str| tokens.get(at).is_some_and(|token| token.text == text);
    let mut found = Vec::new();
    // The module at the token, and for each inline one (`mod name { }`) how deep its brace lies.
    let (mut own, mut inline, mut depth) = (file_module.to_vec(), Vec::new(), 0);
    for (at, token) in tokens.iter().enumerate() {
        if is(at, "{") {
            if at >= 2 && is(at - 2, "mod") {
                own.push(tokens[at - 1].text.clone());
                inline.push(depth);
            }
            depth += 1;
        } else if is(at, "}") {
            depth -= 1;
            if inline.pop_if(|outside| *outside == depth).is_some() {
                own.pop();
            }
        }
        let inside = at >= 2 && is(at - 1, "::") && tokens[at - 2].text.starts_with(char::is_alphanumeric);
        if inside || !is(at + 1, "::") {
            continue;
        }
        let (root, from) = match &*token.text {
            "crate" | "std" | "tactograph" => (vec![token.text.clone()], at + 2),
            "super" => {
                let climbs = tokens[at..].chunks(2).take_while(|pair| pair[0].text == "super").count();
                let stays = &own[..own.len().saturating_sub(climbs)];
                ([vec!["crate".into()], stays.to_vec()].concat(), at + 2 * climbs)
            }
            _ => continue,
        };
        tree(tokens, from, root, &mut found);
    }
    found
}

/// Reads the rest of a path or a group of paths, `a::{b, c::d}`, from `at` on; gives where it ends.
fn tree(tokens: &[Token], mut at: usize, mut path: Vec<String>, found: &mut Vec<Use>) -> usize {
    let text = |at: usize| tokens.get(at).map_or("", |token| &*token.text);
    loop {
        if text(at) == "{" {
            at += 1;
            while !["}", ""].contains(&text(at)) {
                at = tree(tokens, at, path.clone(), found);
                while ![",", "}", ""].contains(&text(at)) {
                    at += 1; // `as name`
                }
                at += usize::from(text(at) == ",");
            }
            return at + 1;
        }
        let line = tokens.get(at.min(tokens.len() - 1)).map_or(0, |token| token.line);
        if text(at) == "*" || text(at).starts_with(|c: char| c.is_alphanumeric() || c == '_') {
            path.push(text(at).into());
            at += 1;
            if text(at) == "::" {
                at += 1;
                continue;
            }
        }
        found.push(Use { at: at - 1, line, path });
        return at;
    }
}

/// A name that a `use` brings into a file.
#[derive(Debug)]
pub(crate) struct Import {
    pub(crate) line: usize,
    /// The name here: the last of the path, or what stands after `as`; `*` for all.
    pub(crate) name: String,
    /// From the crate's root on, without `crate`.
    pub(crate) path: Vec<String>,
    /// A re-export.
    pub(crate) public: bool,
    /// The tokens of the whole statement.
    pub(crate) tokens: Range<usize>,
}

/// What the `use` statements of a file of the module `own` bring from this crate; those inside `mod name { }` are left to
/// [`paths`].
pub(crate) fn imports(tokens: &[Token], own: &[String]) -> Vec<Import> {
    let text = |at: usize| tokens.get(at).map_or("", |token| &*token.text);
    let mut imports = Vec::new();
    let (mut depth, mut inline) = (0, None);
    for at in 0..tokens.len() {
        depth += i32::from(text(at) == "{") - i32::from(text(at) == "}");
        if text(at) == "{" && at >= 2 && text(at - 2) == "mod" {
            inline = inline.or(Some(depth));
        }
        inline = inline.filter(|begun| depth >= *begun);
        if text(at) != "use" || inline.is_some() {
            continue;
        }
        let end = (at..tokens.len()).find(|&end| text(end) == ";").unwrap_or(tokens.len());
        let before = at.checked_sub(1).map_or("", text);
        let mut found = Vec::new();
        tree(tokens, at + 1, Vec::new(), &mut found);
        for Use { at: last, line, mut path } in found {
            path.pop_if(|last| last == "self");
            let climbs = path.iter().take_while(|part| *part == "super").count();
            let stays = own.len().saturating_sub(climbs);
            let path = match path.first().map(String::as_str) {
                Some("crate") => path[1..].to_vec(),
                Some("self") => [own, &path[1..]].concat(),
                Some("super") => [&own[..stays], &path[climbs..]].concat(),
                Some("std" | "core" | "alloc" | "tactograph") | None => continue,
                Some(_) => [own, &path[..]].concat(), // a child module, or another crate: then it resolves to nothing
            };
            let name = if text(last + 1) == "as" { text(last + 2) } else { path.last().map_or("", |last| last) };
            let public = before == "pub" || before == ")";
            imports.push(Import { line, name: name.into(), path, public, tokens: at..end });
        }
    }
    imports
}

/// The names of the items that a file defines outside of all braces, child modules left out.
pub(crate) fn definitions(tokens: &[Token]) -> BTreeSet<String> {
    const KINDS: [&str; 8] = ["fn", "struct", "enum", "union", "const", "static", "type", "trait"];
    let (mut depth, mut found) = (0, BTreeSet::new());
    for three in tokens.windows(3) {
        depth += i32::from(three[0].text == "{") - i32::from(three[0].text == "}");
        let kind = &*three[0].text;
        if depth == 0 && (KINDS.contains(&kind) || kind == "mod" && three[2].text == "{") {
            found.insert(three[1].text.clone());
        } else if depth == 0 && kind == "macro_rules" {
            found.insert(three[2].text.clone());
        }
    }
    found
}

/// Where the names that `lib.rs` exports come from: `Error` from `error`, and `FeelError` from `touch` if it is `touch::Error`
/// under another name.
pub(crate) fn exports(lib: &[Token]) -> BTreeMap<String, String> {
    let public = imports(lib, &[]).into_iter().filter(|import| import.public);
    public.filter_map(|import| Some((import.name, import.path.first()?.clone()))).collect()
}

/// The files that `lib.rs` and `main.rs` reach by `mod name;`, so without those that only tests reach.
pub(crate) fn compiled(code: &BTreeMap<String, Vec<Token>>) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut waiting: Vec<String> = ["src/lib.rs", "src/main.rs"].map(String::from).into();
    while let Some(file) = waiting.pop() {
        let Some(tokens) = code.get(&file) else { continue };
        let folder = [vec!["src".into()], module_of(&file)].concat().join("/");
        for three in tokens.windows(3).filter(|three| three[0].text == "mod" && three[2].text == ";") {
            waiting.extend(["", "/mod"].map(|end| format!("{folder}/{}{end}.rs", three[1].text)));
        }
        reached.insert(file);
    }
    reached
}

/// `src/raster/decode/mod.rs` is the module `raster`, `decode`; `src/lib.rs` and `src/main.rs` are the root.
pub(crate) fn module_of(file: &str) -> Vec<String> {
    let parts = file.trim_start_matches("src/").trim_end_matches(".rs").split('/');
    parts.filter(|part| !["mod", "lib", "main"].contains(part)).map(String::from).collect()
}
