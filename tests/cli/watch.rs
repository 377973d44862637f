//! A directory that is watched. Nothing is timed: the tests wait for files and messages, however long they take, up to
//! a time after which something must be wrong.
#![cfg(unix)]

use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::common::*;

/// How long anything may take on a machine that has much else to do.
const PATIENCE: Duration = Duration::from_secs(180);

/// A run that goes on, and what it has said.
struct Watching {
    child: Child,
    said: Arc<Mutex<Vec<String>>>,
}

impl Watching {
    /// Starts the program and waits until it watches.
    fn start(place: &Place, args: &[&str]) -> Self {
        Self::start_with(place, args, &std::env::var_os("PATH").unwrap_or_default())
    }

    /// The same with programs in other places.
    fn start_with(place: &Place, args: &[&str], path: &OsStr) -> Self {
        let mut command = place.command(&[&["convert", "--watch", "in"], args].concat());
        command.env("PATH", path);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts");
        let (said, stderr) = (Arc::new(Mutex::new(Vec::new())), child.stderr.take().expect("its messages"));
        let hears = Arc::clone(&said);
        thread::spawn(move || {
            for line in BufReader::new(stderr).lines().map_while(Result::ok) {
                hears.lock().expect("nobody panics").push(line);
            }
        });
        let watching = Self { child, said };
        watching.wait_for("that it watches", |said| said.iter().any(|line| line.starts_with("watching in ")));
        watching
    }

    #[track_caller]
    fn wait_for(&self, what: &str, is_there: impl Fn(&[String]) -> bool) {
        let start = Instant::now();
        while !is_there(&self.said.lock().expect("nobody panics")) {
            assert!(start.elapsed() < PATIENCE, "waited in vain for {what}: {:?}", self.said);
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits for a message.
    #[track_caller]
    fn wait_to_hear(&self, message: &str) {
        self.wait_for(message, |said| said.iter().any(|line| line == message));
    }

    /// Asks it to end. Returns everything that it said, once it has.
    #[track_caller]
    fn stop(self, signal: &str) -> Vec<String> {
        self.stop_with(signal, 0)
    }

    /// The same of one that has failed pictures.
    #[track_caller]
    fn stop_with(mut self, signal: &str, code: i32) -> Vec<String> {
        let kill = Command::new("kill").args([signal, &self.child.id().to_string()]).status();
        assert!(kill.expect("kill").success());
        let start = Instant::now();
        let status = loop {
            if let Some(status) = self.child.try_wait().expect("its status") {
                break status;
            }
            assert!(start.elapsed() < PATIENCE, "it does not end: {:?}", self.said);
            thread::sleep(Duration::from_millis(20));
        };
        assert_eq!(status.code(), Some(code), "{:?}", self.said);
        self.wait_for("the last word", |said| said.last().is_some_and(|line| line.starts_with("stopped; ")));
        self.said.lock().expect("nobody panics").clone()
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill(); // has ended, mostly
        let _ = self.child.wait();
    }
}

/// As editors save: a file of another name first.
fn save(place: &Place, name: &str, bytes: &[u8]) {
    place.put("in/.saving.tmp", bytes);
    fs::rename(place.path("in/.saving.tmp"), place.path(format!("in/{name}"))).expect("renamed");
}

#[test]
fn what_is_saved_is_converted_and_own_files_are_not() {
    let place = Place::new();
    place.put("in/old.png", &picture());
    // pages and previews lie in the directory itself
    let watching = Watching::start(&place, &["--preview", "png"]);
    save(&place, "a.png", &picture());
    watching.wait_to_hear("in/a.png: wrote in/a.svg and in/a.svg.preview.png");
    save(&place, "bad.png", b"no picture");
    watching
        .wait_for("a message on bad.png", |said| said.iter().any(|line| line.starts_with("tactograph: in/bad.png: ")));
    place.put("in/notes.txt", b"for later");
    watching
        .wait_for("a note", |said| said.iter().any(|line| line.starts_with("tactograph: in/notes.txt: note: passed")));
    // a picture that is mended is converted, and so is one that was not complete when it was first seen
    let (whole, half) = (png(60, 60, &[200; 60 * 60 * 3]), picture());
    save(&place, "bad.png", &whole);
    watching.wait_to_hear("in/bad.png: wrote in/bad.svg and in/bad.svg.preview.png");
    place.put("in/slow.png", &half[..half.len() / 2]);
    place.put("in/slow.png", &half);
    watching.wait_to_hear("in/slow.png: wrote in/slow.svg and in/slow.svg.preview.png");
    // had its own files been taken for news, that would be heard before this
    save(&place, "z.jpg", &jpeg());
    watching.wait_to_hear("in/z.jpg: wrote in/z.svg and in/z.svg.preview.png");
    let said = watching.stop("-TERM");
    let wrote: Vec<&String> = said.iter().filter(|line| line.contains(": wrote ")).collect();
    assert_eq!(wrote.len(), 4, "{said:#?}");
    // all that failed was mended
    assert_eq!(said.last().map(String::as_str), Some("stopped; 4 pages written"), "{said:#?}");
    assert!(!place.path("in/old.svg").exists(), "what lay there was not saved");
    for (name, bytes) in [("a", &half), ("bad", &whole), ("slow", &half)] {
        place.put(&format!("again/{name}.png"), bytes);
        assert_eq!(place.run(&["convert", &format!("again/{name}.png"), "-q"]).code, 0);
        assert!(
            place.text(&format!("in/{name}.svg")) == place.text(&format!("again/{name}.svg")),
            "{name} is another page"
        );
    }
}

#[test]
fn a_page_that_is_edited_is_rendered_anew() {
    let place = Place::with_picture("a.png");
    place.put("in/nothing.tmp", b"");
    assert_eq!(place.run(&["convert", "a.png", "-o", "page.svg", "-q", "--title", "Red"]).code, 0);
    place.put("titles.csv", b"file,title\na.png,A square\n");
    let args = ["--out-dir", "out", "--format", "pdf", "--titles", "titles.csv"];
    let watching = Watching::start(&place, &args);
    save(&place, "page.svg", place.text("page.svg").as_bytes());
    watching.wait_to_hear("in/page.svg: wrote out/page.pdf");
    // its frame is taken out, as in an editor
    let page = place.text("page.svg");
    let (before, rest) = page.split_once("<g id=\"frame\"").expect("the layer of the frame");
    let (_, after) = rest.split_once("</g>").expect("its end");
    let edited = format!("{before}<g id=\"frame\"/>{after}");
    save(&place, "page.svg", edited.as_bytes());
    watching.wait_for("the second page", |said| {
        said.iter().filter(|line| line.ends_with("wrote out/page.pdf")).count() == 2
    });
    place.put("edited.svg", edited.as_bytes());
    let run = place.run(&["render", "edited.svg", "-o", "rendered.pdf", "-q"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let bytes = |name: &str| fs::read(place.path(name)).expect("a PDF");
    assert!(bytes("out/page.pdf") == bytes("rendered.pdf"), "not what render makes of it");
    // a picture beside it has its title from the table
    save(&place, "a.png", &picture());
    watching.wait_to_hear("in/a.png: wrote out/a.pdf");
    assert_eq!(watching.stop("-INT").last().map(String::as_str), Some("stopped; 3 pages written"));
    assert_eq!(place.run(&["convert", "a.png", "--title", "A square", "-o", "a.pdf", "-q"]).code, 0);
    assert!(bytes("out/a.pdf") == bytes("a.pdf"));
}

#[test]
fn other_programs_are_asked_once_for_what_they_have() {
    let place = Place::with_picture("a.png");
    place.put("in/nothing.tmp", b"");
    let script = b"#!/bin/sh\necho asked >>asked.txt\necho eng\n";
    place.put("programs/tesseract", script);
    let all = fs::Permissions::from_mode(0o755);
    fs::set_permissions(place.path("programs/tesseract"), all).expect("a program");
    let path = std::env::join_paths([place.path("programs"), "/bin".into(), "/usr/bin".into()]).expect("a path");
    let watching = Watching::start_with(&place, &["--out-dir", "out", "--ocr"], &path);
    for name in ["a", "b"] {
        save(&place, &format!("{name}.png"), &picture());
        watching.wait_to_hear(&format!("in/{name}.png: wrote out/{name}.svg"));
    }
    watching.stop("-INT");
    assert_eq!(place.text("asked.txt"), "asked\n");
}

#[test]
fn pictures_that_failed_count_and_are_tried_again_when_they_are_saved_again() {
    let place = Place::with_picture("a.png");
    place.put("in/nothing.tmp", b"");
    place.put("titles.csv", b"file,title\na.png,A square\n");
    let watching = Watching::start(&place, &["--out-dir", "out", "--titles", "titles.csv"]);
    // somebody edits the table, and it is wrong for a while
    place.put("titles.csv", b"file,name\na.png,A square\n");
    save(&place, "a.png", &picture());
    watching.wait_for("a fault of the table", |said| said.iter().any(|line| line.contains("no column \"name\"")));
    place.put("titles.csv", b"file,title\na.png,A square\n");
    save(&place, "a.png", &picture());
    watching.wait_to_hear("in/a.png: wrote out/a.svg");
    assert!(place.text("out/a.svg").contains("<title>A square</title>"));
    for times in 1..=2 {
        save(&place, "bad.png", b"no picture");
        let is_bad = |line: &&String| line.starts_with("tactograph: in/bad.png: ") && !line.contains(": note: ");
        watching.wait_for("a message on bad.png", |said| said.iter().filter(is_bad).count() == times);
    }
    let said = watching.stop_with("-INT", 1);
    let last = "stopped; 1 page written, 1 picture could not be converted";
    assert_eq!(said.last().map(String::as_str), Some(last), "{said:#?}");
}

#[test]
fn what_cannot_be_watched_is_told() {
    let place = Place::with_picture("a.png");
    let line = "none: there is no such directory; make it, or check the name";
    place.refuses(&["convert", "--watch", "none"], 2, &[line]);
    place.refuses(
        &["convert", "--watch", "a.png"],
        2,
        &["a.png: this is no directory; name the one into which pictures are saved"],
    );
    let run = place.run(&["convert", "--watch", ".", "--profile", "nope", "--set", "x=1"]);
    assert_eq!((run.code, run.err.lines().count()), (2, 2), "{}", run.err);
    let line = "--lines: this is of one picture, and --watch is for many; convert it by itself";
    place.refuses(&["convert", "--watch", ".", "--lines", "a.png"], 2, &[line]);
    let line = "--number: this page number is for one picture, and --watch is for many; convert it by itself";
    place.refuses(&["convert", "--watch", ".", "--number", "3"], 2, &[line]);
    let run = place.run(&["convert", "--watch", ".", "a.png"]);
    assert_eq!((run.code, run.err.lines().count()), (2, 1), "{}", run.err);
}
