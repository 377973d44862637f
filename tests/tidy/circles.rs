//! Which file of a module uses what another file of it defines, and the circles among them.
//!
//! A path is followed to the file that *defines* what it names: `super::Type` leads through `pub use leaf::Type` in
//! `mod.rs` to `leaf.rs`. So a `mod.rs` may use its children and they may use types that it re-exports from a leaf; but a
//! child that uses what `mod.rs` itself defines, while `mod.rs` uses the child, makes a circle. A re-export that the file
//! does not use itself is no use.

use std::collections::{BTreeMap, BTreeSet};

use super::scan::{Import, Token, definitions, imports, module_of, paths};

/// One file uses an item of another.
#[derive(Debug, Clone)]
struct Edge {
    line: usize,
    item: String,
}

/// What is known of one file.
struct File<'a> {
    name: &'a str,
    tokens: &'a [Token],
    defined: BTreeSet<String>,
    imports: Vec<Import>,
}

/// All circles, each with the uses that close it: `file:line: uses item of file`.
pub(crate) fn circles(code: &BTreeMap<String, Vec<Token>>) -> Vec<String> {
    let mut files: BTreeMap<Vec<String>, File> = BTreeMap::new();
    for (name, tokens) in code.iter().filter(|(name, _)| *name != "src/main.rs") {
        let own = module_of(name);
        let (defined, imports) = (definitions(tokens), imports(tokens, &own));
        files.insert(own, File { name, tokens, defined, imports });
    }
    let mut edges: BTreeMap<&str, BTreeMap<&str, Edge>> = BTreeMap::new();
    for (own, file) in files.iter().filter(|(own, _)| !own.is_empty()) {
        for (line, path) in uses(&files, own, file) {
            let Some(used) = resolve(&files, &path, 0).filter(|used| used.first() == own.first() && *used != own)
            else {
                continue;
            };
            let to = edges.entry(file.name).or_default().entry(files[used].name);
            to.or_insert(Edge { line, item: path.join("::") });
        }
    }
    groups(&edges).iter().map(|group| told(group, &edges)).collect()
}

/// Every path that a file uses, from the crate's root on, with its line.
fn uses(files: &BTreeMap<Vec<String>, File>, own: &[String], file: &File) -> Vec<(usize, Vec<String>)> {
    let used_here = |name: &str| {
        let text = |at: usize| file.tokens.get(at).map_or("", |token| &*token.text);
        let inside: Vec<_> = file.imports.iter().map(|import| import.tokens.clone()).collect();
        (0..file.tokens.len()).any(|at| text(at) == name && !inside.iter().any(|range| range.contains(&at)))
    };
    let named = file.imports.iter().filter(|import| !import.public || used_here(&import.name));
    let mut found: Vec<_> = named.map(|import| (import.line, import.path.clone())).collect();
    let in_import = |at: usize| file.imports.iter().any(|import| import.tokens.contains(&at));
    // Paths in the code: from `crate` and `super`, and from a name that is a child module or was imported.
    let absolute = paths(file.tokens, own).into_iter().filter(|path| path.path[0] == "crate" && !in_import(path.at));
    found.extend(absolute.map(|path| (path.line, path.path[1..].to_vec())));
    for (at, three) in file.tokens.windows(3).enumerate() {
        let follows = at > 0 && file.tokens[at - 1].text == "::";
        if follows || three[1].text != "::" || in_import(at) {
            continue;
        }
        let child = [own, &[three[0].text.clone()]].concat();
        let imported = file.imports.iter().find(|import| import.name == three[0].text);
        let base = imported.map(|import| import.path.clone()).or_else(|| files.contains_key(&child).then_some(child));
        found.extend(base.map(|base| (three[0].line, [base, vec![three[2].text.clone()]].concat())));
    }
    found
}

/// The module whose file defines what `path` names, if it is an item: a bare module is none.
fn resolve<'a>(files: &'a BTreeMap<Vec<String>, File>, path: &[String], depth: usize) -> Option<&'a Vec<String>> {
    let known = (0..=path.len()).rev().find(|&length| files.contains_key(&path[..length]))?;
    let (module, file) = files.get_key_value(&path[..known])?;
    let item = path.get(known)?;
    if item == "*" || file.defined.contains(item) || depth > 8 {
        return Some(module);
    }
    if let Some(import) = file.imports.iter().find(|import| import.name == *item) {
        return resolve(files, &[&import.path[..], &path[known + 1..]].concat(), depth + 1);
    }
    let globs = file.imports.iter().filter(|import| import.name == "*");
    for glob in globs {
        let base = &glob.path[..glob.path.len() - 1];
        if files.get(base).is_some_and(|file| file.defined.contains(item)) {
            return files.get_key_value(base).map(|(module, _)| module);
        }
    }
    Some(module) // made by a macro of that file
}

/// The groups of files that reach one another.
fn groups(edges: &BTreeMap<&str, BTreeMap<&str, Edge>>) -> Vec<BTreeSet<String>> {
    let reached = |from: &str| {
        let (mut seen, mut waiting) = (BTreeSet::new(), vec![from.to_string()]);
        while let Some(file) = waiting.pop() {
            for next in edges.get(&*file).into_iter().flat_map(BTreeMap::keys) {
                if seen.insert(next.to_string()) {
                    waiting.push(next.to_string());
                }
            }
        }
        seen
    };
    let all: BTreeMap<String, BTreeSet<String>> = edges.keys().map(|file| (file.to_string(), reached(file))).collect();
    let back = |file: &str, to: &str| all.get(to).is_some_and(|seen| seen.contains(file));
    let mut groups: Vec<BTreeSet<String>> = Vec::new();
    for (file, seen) in all.iter().filter(|(file, seen)| seen.contains(*file)) {
        if !groups.iter().any(|group| group.contains(file)) {
            groups.push(seen.iter().filter(|to| back(file, to)).cloned().collect());
        }
    }
    groups
}

fn told(group: &BTreeSet<String>, edges: &BTreeMap<&str, BTreeMap<&str, Edge>>) -> String {
    let mut lines = vec![format!("circle of {} files:", group.len())];
    for file in group {
        for (to, edge) in edges[&**file].iter().filter(|(to, _)| group.contains(**to)) {
            lines.push(format!("    {file}:{}: uses `{}` of {to}", edge.line, edge.item));
        }
    }
    lines.join("\n")
}
