//! The shape of files: their length and width, the length of functions, and that no machine's paths are in them.

use crate::scan::scan;
use crate::{complain, name_of, root, sources, walk};

/// A file this long has more than one job.
const MOST_LINES: usize = 500;
/// A function this long is read in pieces, and has more than one job.
const MOST_LINES_OF_FUNCTION: usize = 60;
/// As rustfmt breaks code; it leaves comments and long texts alone.
const MOST_COLUMNS: usize = 120;
/// A file this short may belong to the neighbour that it serves. It is listed (`-- --nocapture`), not refused: a
/// concept of its own deserves its file.
const FEW_LINES: usize = 70;

#[test]
#[expect(clippy::print_stdout, reason = "a list for whoever asks for it with --nocapture")]
fn files_are_short_and_say_what_they_are() {
    let sources = sources();
    let short = sources.iter().filter(|(_, text)| text.lines().count() < FEW_LINES);
    short.for_each(|(file, text)| println!("{file}: {} lines", text.lines().count()));
    complain(sources.iter().flat_map(|(file, text)| faults_of_shape(file, text)).collect());
}

#[test]
fn functions_fit_on_a_screen() {
    complain(sources().iter().flat_map(|(file, text)| long_functions(file, text)).collect());
}

#[test]
fn lines_are_not_wide() {
    complain(sources().iter().flat_map(|(file, text)| wide_lines(file, text)).collect());
}

#[test]
fn no_path_of_a_machine_is_in_the_tree() {
    let mut files = Vec::new();
    walk(&root(), &mut files);
    assert!(files.len() > 10, "the tree was not found");
    let texts = files.iter().filter_map(|file| Some((name_of(file), std::fs::read_to_string(file).ok()?)));
    complain(texts.flat_map(|(file, text)| machine_paths(&file, &text)).collect());
}

/// Processors that multiply and add in one rounding would make other pages than those that cannot
/// (`docs/stability.md`).
#[test]
fn nothing_multiplies_and_adds_in_one_rounding() {
    let is_fused = |text: &str| scan(text).iter().any(|token| token.text.contains("mul_add"));
    assert!(is_fused("fn f(a: f32) -> f32 { a.mul_add(2.0, 1.0) }") && !is_fused("// no mul_add\nfn f() {}"));
    let fused = |(file, text): (&String, &String)| is_fused(text).then(|| format!("{file}: mul_add rounds once"));
    complain(sources().iter().filter_map(fused).collect());
}

fn faults_of_shape(file: &str, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    if !(text.starts_with("//! ") || text.starts_with("#![doc = include_str!(")) {
        faults.push(format!("{file}:1: begin with a `//!` line that says what the file is for"));
    }
    let lines = text.lines().count();
    if lines > MOST_LINES {
        faults.push(format!("{file}:{lines}: over {MOST_LINES} lines; find its second job and give it its own file"));
    }
    faults
}

/// Functions that are too long, from their first line to the brace that closes them, as rustfmt sets it.
fn long_functions(file: &str, text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let starts = lines.iter().enumerate().filter(|(_, line)| line.trim_start().split("fn ").count() > 1);
    let functions = starts.filter_map(|(start, line)| {
        let indent = &line[..line.len() - line.trim_start().len()];
        let before = line.trim_start().split("fn ").next()?;
        let is_function = before.split(' ').all(|word| {
            word.is_empty()
                || word.starts_with("pub")
                || ["const", "in", "unsafe"].contains(&word)
                || word.ends_with(')')
        });
        let closing = format!("{indent}}}");
        let length = lines[start..].iter().position(|line| *line == closing)? + 1;
        (is_function && !line.ends_with('}') && length > MOST_LINES_OF_FUNCTION).then_some((start, length))
    });
    functions.map(|(start, length)| format!("{file}:{}: a function of {length} lines", start + 1)).collect()
}

#[test]
fn a_long_function_is_found() {
    let of = |lines: usize| {
        format!(
            "impl A {{\n    pub(super) fn f(\n        a: u8,\n    ) {{\n{}    }}\n}}\n",
            "        a;\n".repeat(lines)
        )
    };
    assert_eq!(long_functions("a.rs", &of(MOST_LINES_OF_FUNCTION - 4)), [""; 0]);
    assert_eq!(long_functions("a.rs", &of(MOST_LINES_OF_FUNCTION - 3)), ["a.rs:2: a function of 61 lines"]);
}

fn wide_lines(file: &str, text: &str) -> Vec<String> {
    let wide = text.lines().enumerate().filter(|(_, line)| line.chars().count() > MOST_COLUMNS);
    wide.map(|(at, _)| format!("{file}:{}: over {MOST_COLUMNS} columns", at + 1)).collect()
}

/// Absolute paths as they look on somebody's machine. The names are kept apart from their slashes so that this file
/// passes its own test.
fn machine_paths(file: &str, text: &str) -> Vec<String> {
    let needles =
        ["home", "root", "Users", "work", "workspace", "builds", "mnt", "srv"].map(|name| format!("/{name}/"));
    let at_start = |line: &str, at: usize| {
        !line[..at].ends_with(|before: char| before.is_alphanumeric() || "_.-/*$}~".contains(before))
    };
    let bad = |line: &str| needles.iter().any(|needle| line.match_indices(&**needle).any(|(at, _)| at_start(line, at)));
    let lines = text.lines().enumerate().filter(|(_, line)| bad(line));
    lines.map(|(at, line)| format!("{file}:{}: path of one machine: {}", at + 1, line.trim())).collect()
}

#[test]
fn shapes_and_paths_of_machines_are_found() {
    assert_eq!(faults_of_shape("src/a.rs", "//! What it is for.\n"), [""; 0]);
    assert_eq!(faults_of_shape("src/a.rs", "use std::fmt;\n").len(), 1);
    assert_eq!(faults_of_shape("src/a.rs", &format!("//! Long.{}", "\n".repeat(MOST_LINES + 1))).len(), 1);
    assert_eq!(wide_lines("src/a.rs", &format!("//! {}\n//! {}", "x".repeat(116), "é".repeat(117))).len(), 1);
    let of_a_machine = ["/home", "/ann/cup.png"].concat();
    for text in [of_a_machine.clone(), format!("see `{of_a_machine}`"), format!("a\nIN={of_a_machine}")] {
        assert_eq!(machine_paths("notes.txt", &text).len(), 1, "{text}");
    }
    for text in [format!("https://example.org{of_a_machine}"), format!("samples{of_a_machine}"), "/usr/bin/env".into()]
    {
        assert_eq!(machine_paths("notes.txt", &text), [""; 0], "{text}");
    }
}
