//! README and docs: every command works as it stands there, every page is found, and every link leads somewhere.
//!
//! A command is a line `tactograph ...` (or `cargo run --release -- ...`) in an indented or fenced block, or stands at
//! the beginning of a line of a list. Each is run in a place where the sample pictures lie under their own names, in
//! the order of its page. Commands in a fenced block of `text` are not run (they need hardware, take minutes or are
//! patterns), nor are those of lists whose picture is not there or that need another program; their options must exist
//! all the same.

use std::fs;
use std::path::{Path, PathBuf};

use super::common::*;

/// One command of a page.
struct Shown {
    line: usize,
    words: Vec<String>,
    only_parsed: bool,
    is_listed: bool,
}

impl Shown {
    /// Whether it is run: of a list, if there is the picture that it names first and it needs no other program.
    fn is_run(&self, place: &Place) -> bool {
        let is_there = || self.words.get(1).is_none_or(|file| place.path(file).exists());
        let needs_program = || self.words.iter().any(|word| OF_OTHER_PROGRAMS.contains(&word.as_str()));
        !self.only_parsed && (!self.is_listed || is_there() && !needs_program())
    }
}

/// What needs Tesseract or liblouis.
const OF_OTHER_PROGRAMS: [&str; 2] = ["--ocr", "braille.grade=2"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README.md and the pages in docs, by their paths from the root.
fn pages() -> Vec<PathBuf> {
    let docs = fs::read_dir(root().join("docs")).expect("the pages");
    let docs =
        docs.map(|entry| entry.expect("an entry").path()).filter(|path| path.extension().is_some_and(|e| e == "md"));
    let mut pages: Vec<_> =
        docs.map(|path| path.strip_prefix(root()).expect("it lies in the root").to_owned()).collect();
    pages.sort();
    pages.insert(0, "README.md".into());
    pages
}

fn text_of(page: &Path) -> String {
    fs::read_to_string(root().join(page)).unwrap_or_else(|error| panic!("{}: {error}", page.display()))
}

/// The words of a command; those in quotation marks are one.
fn words_of(command: &str) -> Vec<String> {
    let parts = command.split('"').enumerate();
    let words = parts.flat_map(|(i, part)| match i % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    words.map(str::to_owned).collect()
}

/// The commands in a page's blocks and lists.
fn commands(text: &str) -> Vec<Shown> {
    let (mut shown, mut fenced, mut only_parsed) = (Vec::new(), false, false);
    for (i, line) in text.lines().enumerate() {
        // "* `tactograph ...`: what it does"
        let listed = line.strip_prefix("* `").and_then(|rest| rest.split_once("`: ")).map(|(command, _)| command);
        let in_block = fenced || line.starts_with("    ") || listed.is_some();
        if let Some(language) = line.strip_prefix("```") {
            fenced = !fenced;
            only_parsed = fenced && language == "text";
        }
        let command = listed.unwrap_or(line).trim();
        let command = command.strip_prefix("cargo run --release -- ").or_else(|| command.strip_prefix("tactograph "));
        if let Some(command) = command.filter(|_| in_block) {
            let words = words_of(command);
            shown.push(Shown { line: i + 1, words, only_parsed, is_listed: listed.is_some() });
        }
    }
    shown
}

/// A place with the sample pictures, as `coffee.png` and as `samples/coffee.png`, a page `coffee.svg`, and the files
/// that the pages speak of.
fn prepared() -> Place {
    let place = Place::new();
    for entry in fs::read_dir(root().join("samples")).expect("the samples") {
        let path = entry.expect("a sample").path();
        if path.is_dir() {
            continue; // what samples are made of
        }
        let (name, bytes) = (path.file_name().expect("a name").to_string_lossy().into_owned(), fs::read(&path));
        let bytes = bytes.expect("its bytes");
        place.put(&name, &bytes);
        place.put(&format!("samples/{name}"), &bytes);
    }
    place.put("my.toml", b"inherits = \"our-school.toml\"\n[lines]\nwidth_max = 1.2\n");
    place.put("labels.csv", b"20%,35%,tree\n50%,35%,roof\n");
    place.put("titles.csv", b"file,title,alt\ncoffee.png,A cup of coffee,A cup\nrocket.jpg,The rocket starts,\n");
    let own = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='400'><g id='lines'><path d='M30,30h200' \
               stroke='#000' fill='none'/></g></svg>";
    place.put("own.svg", own.as_bytes());
    place.put("our-school.toml", b"inherits = \"swell-a4\"\n");
    let run = place.run(&["convert", "coffee.png", "-q", "-o", "coffee.svg"]);
    assert_eq!(run.code, 0, "{}", run.err);
    place
}

#[test]
fn every_command_works_as_it_is_shown() {
    let (place, mut faults, mut count, mut listed) = (prepared(), String::new(), 0, 0);
    for page in pages() {
        for shown in commands(&text_of(&page)) {
            let (line, is_run) = (shown.line, shown.is_run(&place));
            let words: Vec<_> = shown.words.iter().map(String::as_str).collect();
            count += 1;
            listed += usize::from(is_run && shown.is_listed);
            if !is_run {
                let help = place.run(&[words[0], "--help"]).out;
                let unknown = words.iter().filter(|word| word.starts_with("--") && !help.contains(**word));
                unknown.for_each(|word| faults += &format!("{}, line {line}: no option {word}\n", page.display()));
                continue;
            }
            let run = place.run(&words);
            if run.code != 0 {
                faults += &format!("{}, line {line}: {}\n{}", page.display(), words.join(" "), run.err);
            }
        }
    }
    assert!(faults.is_empty(), "{faults}");
    assert!(count >= 12 && listed >= 25, "only {count} commands were found, and {listed} of lists run");
}

/// Measuring programs are not run here, but they are there.
#[test]
fn every_measuring_program_is_there() {
    for page in pages() {
        for (i, line) in text_of(&page).lines().enumerate() {
            for rest in line.split("-p tactograph-tools --bin ").skip(1) {
                let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
                let bins = root().join("tools/src/bin");
                let there = bins.join(name).join("main.rs").exists() || bins.join(format!("{name}.rs")).exists();
                assert!(there, "{}, line {}: there is no program {name}", page.display(), i + 1);
            }
        }
    }
}

/// The targets of the links and pictures in a page, without those on the net.
fn links(text: &str) -> Vec<String> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')').map(|(target, _)| target.to_owned()));
    targets.filter(|target| !target.starts_with("http")).collect()
}

/// The table of options has every option of `convert` that its help has.
#[test]
fn every_option_of_convert_is_in_the_table() {
    let help = Place::new().run(&["convert", "--help"]);
    let table: String =
        text_of(&root().join("docs/converting.md")).lines().filter(|row| row.starts_with("| `")).collect();
    let options = help.out.lines().filter_map(|line| {
        let line = line.trim_start();
        let line = line.strip_prefix("-").filter(|line| !line.starts_with('-')).map_or(line, |line| &line[1..]);
        let name = line.trim_start_matches([',', ' ']).strip_prefix("--")?;
        Some(format!("--{}", name.split([' ', '.', '[', '=']).next().unwrap_or(name)))
    });
    let options: Vec<String> = options.filter(|name| name != "--help").collect();
    assert!(options.len() > 30, "{options:?}");
    let has = |name: &str| {
        table.match_indices(name).any(|(at, _)| {
            let after = table[at + name.len()..].chars().next();
            after.is_some_and(|letter| !letter.is_alphanumeric() && letter != '-')
        })
    };
    // the file is named by -o in the table
    let missing: Vec<&String> = options.iter().filter(|name| !has(name) && *name != "--output").collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn every_link_leads_somewhere() {
    for page in pages() {
        let folder = root().join(page.parent().unwrap_or(Path::new("")));
        for link in links(&text_of(&page)) {
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let path = if file.is_empty() { root().join(&page) } else { folder.join(file) };
            assert!(path.exists(), "{}: {link} leads nowhere", page.display());
            if !heading.is_empty() {
                let text = fs::read_to_string(&path).unwrap_or_default();
                let slugs = text.lines().filter(|line| line.starts_with('#')).map(slug);
                assert!(
                    slugs.into_iter().any(|slug| slug == heading),
                    "{}: {link} has no such heading",
                    page.display()
                );
            }
        }
    }
}

/// A heading as links name it.
fn slug(heading: &str) -> String {
    let letters = heading.trim_start_matches('#').trim().to_lowercase();
    letters
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}

#[test]
fn the_readme_is_short_and_leads_to_every_page_and_back() {
    let readme = text_of(Path::new("README.md"));
    assert!(readme.lines().count() <= 155, "the README has {} lines", readme.lines().count());
    let linked = links(&readme);
    for page in pages().iter().skip(1) {
        let path = page.to_string_lossy().replace('\\', "/");
        assert!(linked.contains(&path), "the README does not lead to {path}");
        let back = links(&text_of(page));
        assert!(back.iter().any(|link| link == "../README.md"), "{path} does not lead back");
        assert!(
            back.iter().filter(|link| link.ends_with(".md")).count() >= 3,
            "{path} does not lead to its neighbours"
        );
    }
}
