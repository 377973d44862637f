//! Keeps the house in order: which module may use which, what the library stays away from, and the shape of the files.
//!
//! Each fault names its file and line, and all of them are told at once. `scan.rs` reads the sources, `circles.rs`
//! finds circles of imports, `overview.rs` looks for files that the overview lacks, `shapes.rs` judges files as texts,
//! `face.rs` counts what users see.

mod circles;
mod face;
mod overview;
mod scan;
mod shapes;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use scan::{Token, Use, compiled, exports, module_of, paths, scan};

/// The library's modules from the spring downhill, each with what it may use beside itself and [`EVERYWHERE`]. The way
/// is
/// `units -> geom -> raster -> edges, classes -> lines, textures -> page -> output, touch -> profile ->
/// pipeline -> lib`; a stage is left out of a row where the stage below must not know of it.
const MAY_USE: &[(&str, &[&str])] = &[
    ("units", &[]),
    ("braille", &["units"]), // text to cells, cells to dots
    // What stops everything: faults of a profile, of a part or a grid of sheets as written, of a page that is felt.
    ("error", &["units", "raster", "page", "touch", "profile"]),
    ("listing", &[]),
    ("ranked", &[]),                 // entries of heaps
    ("note", &["units", "braille"]), // names the codes that there are
    ("picture", &["units"]),         // as it is given: a file or pixels
    ("geom", &["units"]),
    ("wording", &["braille"]), // sentences in several languages; colours are called as in braille
    ("devices", &["units"]),   // embossers and pin displays: only what they can do
    ("raster", &["units", "picture", "geom"]),
    ("lettering", &["units", "geom", "raster"]), // text in pixels; the picture without it
    ("paper", &["units", "geom", "raster"]),     // light and colour of what a drawing is on
    ("regions", &["units", "ranked", "geom", "raster"]), // knows traces, not how they are found
    ("edges", &["units", "geom", "raster", "regions"]),
    ("classes", &["units", "geom", "raster"]),
    ("lines", &["units", "ranked", "geom", "raster", "regions", "edges"]),
    // Density and the white gap follow the lines.
    ("textures", &["units", "geom", "raster", "classes", "lines"]),
    // The same textures and lines as dots.
    ("dots", &["units", "geom", "raster", "classes", "lines", "textures", "devices"]),
    // No raster: a page has no pixels.
    ("page", &["units", "geom", "braille", "edges", "classes", "lines", "textures", "devices"]),
    // Words of the figure, beside its lines.
    ("labels", &["units", "geom", "braille", "page"]),
    // Contours as data, back in the pixels of the source.
    ("contours", &["units", "geom", "edges", "lines"]),
    // Whoever comes after the page reads nothing but the page, or contours.
    ("output", &["units", "geom", "devices", "page", "contours"]),
    // A page from its SVG, with the layers that the writer gives it.
    ("reading", &["units", "geom", "raster", "devices", "page", "output"]),
    ("touch", &["units", "geom", "raster", "page"]), // feels the page as ink
    // Rules over finished marks, by the names that the file of the page has.
    ("legibility", &["units", "geom", "braille", "wording", "devices", "page", "reading", "touch"]),
    ("description", &["units", "geom", "wording", "lines", "page", "legibility"]), // a page in sentences
    (
        "profile",
        &[
            "units",
            "geom",
            "braille",
            "raster",
            "regions",
            "edges",
            "classes",
            "lines",
            "textures",
            "devices",
            "dots",
            "page",
            "contours",
            "output",
            "touch",
            "legibility",
        ],
    ),
    // Samples on sheets: from a profile straight to pages.
    (
        "calibration",
        &["units", "braille", "raster", "devices", "classes", "lines", "textures", "dots", "page", "profile"],
    ),
    (
        "pipeline",
        &[
            "units",
            "geom",
            "wording",
            "braille",
            "raster",
            "lettering",
            "paper",
            "regions",
            "edges",
            "classes",
            "lines",
            "textures",
            "devices",
            "dots",
            "page",
            "labels",
            "contours",
            "output",
            "reading",
            "touch",
            "legibility",
            "description",
            "profile",
            "picture",
        ],
    ),
    // The face: profiles checked, the pipeline run, pages handed to their writers.
    (
        "api",
        &[
            "units",
            "braille",
            "raster",
            "contours",
            "output",
            "page",
            "touch",
            "reading",
            "legibility",
            "description",
            "wording",
            "profile",
            "calibration",
            "pipeline",
            "picture",
        ],
    ),
];
/// What any module may use.
const EVERYWHERE: &[&str] = &["error", "listing", "note"];
/// The modules of the program; it sees the library only from outside, as `tactograph::`.
const PROGRAM: &[&str] = &["cli"];

/// What the library has no business with: it gets bytes and gives bytes, and builds for the browser.
const NOT_IN_THE_LIBRARY: &[&str] = &[
    "std::fs",
    "std::time",
    "std::thread",
    "std::env",
    "std::process",
    "std::net",
    "std::io::stdin",
    "std::io::stdout",
    "std::io::stderr",
];
const MACROS_NOT_IN_THE_LIBRARY: &[&str] = &["print", "println", "eprint", "eprintln", "dbg"];

#[test]
fn imports_run_downhill() {
    let house = House::of(&sources());
    assert!(house.code.contains_key("src/lib.rs"), "the sources were not found");
    complain(house.code.iter().flat_map(|(file, tokens)| house.faults(file, tokens)).collect());
}

/// Shared types live in a leaf file; `mod.rs` re-exports and orchestrates (see `tidy/circles.rs`).
#[test]
fn files_of_a_module_form_no_circle() {
    complain(circles::circles(&House::of(&sources()).code));
}

#[test]
fn the_table_itself_runs_downhill() {
    for (index, (module, uses)) in MAY_USE.iter().enumerate().filter(|(_, (module, _))| *module != "error") {
        for used in *uses {
            assert!(
                MAY_USE[..index].iter().any(|(earlier, _)| earlier == used),
                "{module} uses {used}, which is below"
            );
        }
    }
}

// ---------------------------------------------------------------------------------------------- what must not be

/// The code of all source files without comments, texts and tests, and where the crate's re-exports come from.
struct House {
    code: BTreeMap<String, Vec<Token>>,
    exports: BTreeMap<String, String>,
}

impl House {
    fn of(sources: &BTreeMap<String, String>) -> Self {
        let mut code: BTreeMap<_, _> = sources.iter().map(|(file, text)| (file.clone(), scan(text))).collect();
        let compiled = compiled(&code);
        code.retain(|file, _| compiled.contains(file));
        let exports = code.get("src/lib.rs").map(|lib| exports(lib)).unwrap_or_default();
        Self { code, exports }
    }

    fn faults(&self, file: &str, tokens: &[Token]) -> Vec<String> {
        let own = module_of(file);
        let own_top = own.first().map_or("lib", String::as_str);
        let program = file == "src/main.rs" || PROGRAM.contains(&own_top);
        let mut faults = Vec::new();
        for Use { line, path, .. } in paths(tokens, &own) {
            let told = path.join("::");
            let fault = match path[0].as_str() {
                "crate" => self.fault_of_import(own_top, program, path.get(1).map_or("self", String::as_str)),
                "std" if !program => {
                    NOT_IN_THE_LIBRARY.iter().find(|bad| told == **bad || told.starts_with(&format!("{bad}::"))).map(
                        |bad| format!("the library keeps away from `{bad}`; let the program do it and pass the result"),
                    )
                }
                "tactograph" if !program => Some("inside the library write `crate::`".into()),
                _ => None,
            };
            faults.extend(fault.map(|why| format!("{file}:{line}: `{told}`: {why}")));
        }
        for (at, token) in tokens.iter().enumerate() {
            let next_is = |text: &str| tokens.get(at + 1).is_some_and(|next| next.text == text);
            if !program && MACROS_NOT_IN_THE_LIBRARY.contains(&&*token.text) && next_is("!") {
                faults.push(format!("{file}:{}: `{}!`: the library never prints; use a Note", token.line, token.text));
            }
            if ["crate", "std"].contains(&&*token.text) && next_is("as") {
                faults.push(format!("{file}:{}: `{} as`: a new name hides what is used", token.line, token.text));
            }
        }
        if own_top != "lib" && !program && !MAY_USE.iter().any(|(module, _)| *module == own_top) {
            faults.push(format!("{file}:1: module `{own_top}` has no row in the table of tests/tidy/main.rs"));
        }
        faults
    }

    /// Why the module `own` may not use `crate::item`, if it may not.
    fn fault_of_import(&self, own: &str, program: bool, item: &str) -> Option<String> {
        if program {
            return (!PROGRAM.contains(&item)).then(|| "the program uses the library as `tactograph::`".into());
        }
        let used = self.exports.get(item).map_or(item, String::as_str);
        if !MAY_USE.iter().any(|(module, _)| *module == used) {
            return Some("this names no module of the table in tests/tidy/main.rs".into());
        }
        let allowed = MAY_USE.iter().find(|(module, _)| *module == own).map_or(&[][..], |(_, uses)| uses);
        let fine = own == "lib" || own == used || EVERYWHERE.contains(&used) || allowed.contains(&used);
        (!fine).then(|| format!("`{own}` may use only {}", [EVERYWHERE, allowed].concat().join(", ")))
    }
}

// ------------------------------------------------------------------------------------------- that it can complain

/// The faults of `text` as the file `file` of a house whose `lib.rs` declares every module and exports `Error` and
/// `Page`.
fn faults_in(file: &str, text: &str) -> Vec<String> {
    let own = module_of(file);
    let mut sources = BTreeMap::from([
        ("src/lib.rs".into(), "pub mod page; pub use error::Error; pub use crate::page::{Page, Error as M};".into()),
        (file.to_string(), text.to_string()),
    ]);
    for depth in 0..own.len() {
        let parent = if depth == 0 { "src/lib.rs".into() } else { format!("src/{}/mod.rs", own[..depth].join("/")) };
        sources.entry(parent).or_default().push_str(&format!(" mod {};", own[depth]));
    }
    let house = House::of(&sources);
    house.code.get(file).map_or_else(Vec::new, |tokens| house.faults(file, tokens))
}

#[test]
fn a_use_uphill_is_found_wherever_it_hides() {
    for (line, code) in [
        (1, "use crate::output::svg;"),
        (1, "pub use crate::output;"),
        (4, "\n\nuse crate::{units::{Px, Mm},\n output::svg as s};"),
        (2, "use crate::{\n    output::{svg}, units};"),
        (1, "fn f() { crate::output::svg::write(); }"),
        (2, "// crate::units\nfn f(page: &crate::Page) {}"),
        (1, "use super::output::svg;"),
        (1, "mod inner { use super::super::output::svg; }"),
        (1, "mod inner { } use super::output::svg;"),
        (1, "use crate::{self as all};"),
        (1, "use crate as all;"),
        (1, "use crate::*;"),
        (1, "use std::fs;"),
        (2, "use std::{collections::BTreeMap,\n time::Instant};"),
        (1, "fn f() { std::thread::spawn(|| ()); }"),
        (1, "fn f() { ::std::io::stdout(); }"),
        (1, "fn f() { println!(); }"),
        (1, "fn f<'a>(x: &'a str) -> char { eprint!(\"{x}\"); '\"' }"),
        (1, "use tactograph::internals::units::Px;"),
        (2, "#[cfg(test)] mod tests { fn f() {} }\nuse crate::output::svg;"),
        (2, "#[cfg(test)]\nuse crate::units::Px; use crate::output::svg;"),
    ] {
        let faults = faults_in("src/edges/mod.rs", code);
        assert_eq!(faults.len(), 1, "{code}\n{faults:?}");
        assert!(faults[0].starts_with(&format!("src/edges/mod.rs:{line}: ")), "{code}\n{faults:?}");
    }
    assert_eq!(faults_in("src/edges/mod.rs", "use crate::{output, page}; use std::{fs, io};").len(), 3);
    assert_eq!(faults_in("src/edges/thin.rs", "use super::super::output::svg;").len(), 1);
    assert_eq!(faults_in("src/nowhere.rs", "").len(), 1, "a module without a row");
    assert_eq!(faults_in("src/main.rs", "use crate::units::Px; fn main() {}").len(), 1);
    assert_eq!(faults_in("src/cli/report.rs", "use crate::raster;").len(), 1);
}

#[test]
fn what_is_allowed_passes() {
    for (file, code) in [
        ("src/edges/mod.rs", "use crate::units::{Px, Size}; use crate::{Error, note::Note, raster::Raster};"),
        ("src/edges/thin.rs", "use super::Gradient; use super::super::raster::Raster; use crate::edges::chain;"),
        ("src/edges/mod.rs", "/* /* crate::output */ use std::fs; */ // println!()\n/// crate::output::svg\nfn f() {}"),
        (
            "src/edges/mod.rs",
            r##"const A: &str = "crate::output::a \" std::fs"; const B: &str = r#"crate::"output"#;"##,
        ),
        ("src/edges/mod.rs", "#[cfg(test)]\nmod tests { use crate::output::svg; fn f() { println!(); } }"),
        ("src/edges/mod.rs", "mod inner { use super::Gradient; pub(crate) fn f() {} }"),
        ("src/edges/mod.rs", "use std::{collections::BTreeMap, io::Write}; use other::std::fs; mod fs {}"),
        (
            "src/main.rs",
            "mod cli; use tactograph::Page; fn main() { crate::cli::run(); println!(); std::fs::read(\"\"); }",
        ),
        ("src/cli/mod.rs", "use super::cli::args; use std::time::Instant;"),
        ("src/pipeline.rs", "use crate::{Error, Page, edges, profile::Plan};"),
    ] {
        assert_eq!(faults_in(file, code), [""; 0], "{code}");
    }
    // A file that only tests reach.
    let sources = [
        ("src/lib.rs", "mod edges;"),
        ("src/edges.rs", "#[cfg(test)] mod cases;"),
        ("src/edges/cases.rs", "use crate::output::svg;"),
    ];
    let house = House::of(&sources.map(|(file, text)| (file.into(), text.into())).into());
    assert_eq!(house.code.keys().collect::<Vec<_>>(), ["src/edges.rs", "src/lib.rs"]);
}

#[test]
fn circles_are_found_and_only_circles() {
    let circles = |files: &[(&str, &str)]| {
        let sources = [&[("src/lib.rs", "mod a;")], files].concat();
        let house = House::of(&sources.iter().map(|(file, text)| (file.to_string(), text.to_string())).collect());
        circles::circles(&house.code)
    };
    for (parent, child) in [
        ("mod b; pub struct P; fn f() { b::g() }", "use super::P; pub fn g() {}"),
        ("mod b; use b::g; pub struct P;", "pub fn g(p: super::P) {}"),
        ("mod b; use self::b::{g as h}; pub struct P;", "use crate::a::{self as all, P}; pub fn g() {}"),
        ("mod b; pub use b::g; pub struct P; fn f() { g() }", "use crate::a; pub fn g(p: a::P) {}"),
        ("mod b; mod inner { use super::b::g; } fn p() {}", "use super::*; pub fn g() { p() }"),
    ] {
        let found = circles(&[("src/a/mod.rs", parent), ("src/a/b.rs", child)]);
        assert_eq!(found.len(), 1, "{parent} | {child}");
        assert_eq!(found[0].lines().count(), 3, "{found:?}");
    }
    for (parent, child) in [
        ("mod b; pub struct P;", "use super::P; pub fn g() {}"),
        ("mod b; pub use b::g; pub struct P;", "use super::P; pub fn g() {}"),
        ("mod b; mod c; pub use c::P; fn f() { b::g(P) }", "use super::P; pub fn g(p: super::c::P) {}"),
        ("mod b; mod c; use c::*; fn f() { b::g() }", "use super::P; pub fn g() {}"),
        ("mod b; use b::g;", "#[cfg(test)] mod tests { use super::super::f; } pub fn g() {}"),
    ] {
        let c = ("src/a/c.rs", "pub struct P;");
        assert_eq!(circles(&[("src/a/mod.rs", parent), ("src/a/b.rs", child), c]), [""; 0], "{parent} | {child}");
    }
    let three = [("src/a/mod.rs", "mod b; mod c; mod d;"), ("src/a/b.rs", "use super::c::C; pub struct B;")];
    let rest = [("src/a/c.rs", "use super::d::D; pub struct C;"), ("src/a/d.rs", "use super::b::B; pub struct D;")];
    assert_eq!(circles(&[three, rest].concat()).len(), 1);
}

// ------------------------------------------------------------------------------------------------------ the tree

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn name_of(file: &Path) -> String {
    file.strip_prefix(root()).unwrap_or(file).to_string_lossy().replace('\\', "/")
}

fn sources() -> BTreeMap<String, String> {
    let mut files = Vec::new();
    walk(&root().join("src"), &mut files);
    let rust = files.iter().filter(|file| file.extension().is_some_and(|end| end == "rs"));
    rust.map(|file| (name_of(file), std::fs::read_to_string(file).expect("a source file is readable text"))).collect()
}

/// All files of the project: hidden folders other than `.ci` and what cargo builds belong to the machine.
fn walk(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("the project's folders are readable") {
        let path = entry.expect("the project's folders are readable").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name == ".git" {
            continue; // in a worktree a file, with the path of the repository
        }
        if !path.is_dir() {
            files.push(path);
        } else if name == ".ci" || !(name == "target" || name.starts_with('.')) {
            walk(&path, files);
        }
    }
}

#[track_caller]
fn complain(faults: Vec<String>) {
    assert!(faults.is_empty(), "{} fault(s)\n{}", faults.len(), faults.join("\n"));
}
