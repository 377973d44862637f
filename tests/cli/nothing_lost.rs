//! Runs that are stopped, killed or have no room: every file that stands is whole, nothing else is left, and one line
//! says what happened.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use tactograph_tools::killing;

use crate::cli::common::*;

/// Sends a signal, as a terminal does for Ctrl-C.
fn signal(child: &Child, signal: &str) {
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill").success());
}

/// The program started by a shell, which prepares something for it.
fn in_shell(place: &Place, script: &str, args: &[&str]) -> Run {
    let mut command = Command::new("sh");
    let script = format!("{script}\nexec \"$0\" \"$@\"");
    command.args(["-c", &script, env!("CARGO_BIN_EXE_tactograph")]).args(args);
    ended(command.current_dir(place.path("")).stdin(Stdio::null()).output().expect("a shell"))
}

/// Twelve here; `kills` of the tools does it a thousand times.
#[test]
fn killed_runs_leave_whole_files_and_the_next_run_tidies_up() {
    let tally = killing::kill(Path::new(env!("CARGO_BIN_EXE_tactograph")), 12, 5).expect("nothing is lost");
    assert!(tally.killed == 12 && tally.old > 0, "{tally:?}");
}

#[test]
fn the_next_run_removes_what_a_killed_one_left_and_nothing_of_others() {
    let place = Place::with_picture("a.png");
    place.put(".tactograph-Ab12.tmp", b"half a page");
    place.put(".tactograph-notes", b"somebody's");
    assert_eq!(place.run(&["convert", "a.png"]).code, 0);
    assert_eq!(place.names(), [".tactograph-notes", "a.png", "a.svg"]);
}

#[test]
fn ctrl_c_stops_a_batch_which_says_how_far_it_came() {
    let place = Place::new();
    let names: Vec<String> = (0..60).map(|i| format!("p{i}.png")).collect();
    names[..59].iter().for_each(|name| place.put(name, &picture()));
    // the last never comes, so that the run is not over before it is stopped
    assert!(Command::new("mkfifo").arg(place.path(&names[59])).status().expect("mkfifo").success());
    let args: Vec<&str> = ["convert", "--out-dir", "out"].into_iter().chain(names.iter().map(String::as_str)).collect();
    for word in ["-INT", "-TERM"] {
        let mut child = place.command(&args).stderr(Stdio::piped()).spawn().expect("the program starts");
        let mut messages = BufReader::new(child.stderr.take().expect("its messages"));
        let mut first = String::new();
        messages.read_line(&mut first).expect("a line");
        signal(&child, word);
        let mut rest = String::new();
        messages.read_to_string(&mut rest).expect("text");
        assert_eq!(child.wait().expect("its end").code(), Some(130), "{rest}");
        // a run before this one wrote some of them, too
        let last = rest.lines().last().expect("a last word");
        let done: usize = last
            .strip_prefix("tactograph: stopped; ")
            .and_then(|rest| rest.strip_suffix(" of 60 pictures converted"))
            .and_then(|number| number.parse().ok())
            .unwrap_or_else(|| panic!("{last}"));
        let pages: Vec<_> =
            fs::read_dir(place.path("out")).expect("out").map(|page| page.expect("it").path()).collect();
        assert!((1..60).contains(&done) && pages.len() >= done, "{done} of {pages:?}");
        if word == "-INT" {
            assert_eq!(pages.len(), done);
        }
        pages
            .iter()
            .for_each(|page| assert_is_page(&fs::read_to_string(page).expect("text"), &page.display().to_string()));
    }
}

#[test]
fn ctrl_c_while_the_picture_is_still_to_come() {
    let place = Place::new();
    place.put("p.svg", b"old");
    let mut command = place.command(&["convert", "-", "-o", "p.svg", "--force"]);
    let mut child = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    let mut input = child.stdin.take().expect("its input");
    // the program listens once it reads: a pipe holds 64 kB, so more than that has been read
    input.write_all(&[b'P'; 1 << 20]).expect("it reads");
    signal(&child, "-INT");
    let run = ended(child.wait_with_output().expect("it ends"));
    assert_eq!((run.code, run.err.as_str()), (130, "tactograph: stopped; nothing was written\n"));
    drop(input);
    assert_eq!((place.text("p.svg").as_str(), place.names()), ("old", vec!["p.svg".to_owned()]));
}

#[test]
fn a_file_longer_than_the_system_takes_is_told() {
    let place = Place::with_picture("a.png");
    place.put("a.svg", b"");
    // 512 or 1024 bytes, and no signal for it
    let run = in_shell(&place, "trap '' XFSZ; ulimit -f 1", &["convert", "a.png"]);
    let line = "tactograph: a.svg: the page cannot be written, as the system takes no file of this length here; raise \
                that limit (ulimit -f) or choose another place with -o\n";
    assert_eq!((run.code, run.err.as_str()), (1, line));
    assert_eq!((place.text("a.svg").as_str(), place.names().len()), ("", 2), "something is left over");
}

/// A file system of our own, where the system lets anybody mount one; elsewhere there is nothing to test with.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_and_one_that_cannot_be_written_to() {
    let can_mount = "mkdir -p m && mount -t tmpfs -o size=64k tmpfs m";
    let place = Place::with_picture("a.png");
    let in_namespace = |script: &str, args: &[&str]| {
        let script = format!("{can_mount} && {script}\n\"$0\" \"$@\"; code=$?; ls -A m >&2; exit $code");
        let mut command = Command::new("unshare");
        command.args(["-rm", "sh", "-c", &script, env!("CARGO_BIN_EXE_tactograph")]).args(args);
        ended(command.current_dir(place.path("")).stdin(Stdio::null()).output().expect("it starts"))
    };
    let mounts = Command::new("unshare").args(["-rm", "sh", "-c", can_mount]).current_dir(place.path("")).output();
    if !mounts.is_ok_and(|mounts| mounts.status.success()) {
        return;
    }
    let full = "tactograph: m/a.svg: the page cannot be written, as the disk is full; make room and try again\n";
    let run = in_namespace("head -c 62000 /dev/zero >m/big", &["convert", "a.png", "-o", "m/a.svg"]);
    assert_eq!((run.code, run.err), (1, format!("{full}big\n")));
    let run = in_namespace("echo old >m/a.svg; head -c 58000 /dev/zero >m/big", &["convert", "a.png", "-o", "m/a.svg"]);
    assert_eq!((run.code, run.err), (1, format!("{full}a.svg\nbig\n")), "the old page stays");
    let not = "tactograph: m/a.svg: the page cannot be written here, as you have no permission; choose another place \
               with -o\n";
    let run = in_namespace("mount -o remount,ro m", &["convert", "a.png", "-o", "m/a.svg"]);
    assert_eq!((run.code, run.err.as_str()), (1, not));
}

#[test]
fn a_picture_that_vanishes_while_others_are_worked_on() {
    let place = Place::with_picture("z.png");
    // as many pictures as are worked on at once, which are still to come
    let waiting = std::thread::available_parallelism().map_or(1, usize::from);
    let pipes: Vec<String> = (0..waiting).map(|i| format!("pipe{i}.png")).collect();
    for pipe in &pipes {
        assert!(Command::new("mkfifo").arg(place.path(pipe)).status().expect("mkfifo").success());
    }
    let names: Vec<&str> = pipes.iter().map(String::as_str).chain(["z.png"]).collect();
    let mut command = place.command(&[&["convert", "--out-dir", "out"], &names[..]].concat());
    let child = command.stderr(Stdio::piped()).spawn().expect("the program starts");
    // opening a pipe for writing waits until the program reads it
    let mut inputs: Vec<_> =
        pipes.iter().map(|pipe| fs::OpenOptions::new().write(true).open(place.path(pipe)).expect("a pipe")).collect();
    fs::remove_file(place.path("z.png")).expect("it goes");
    for input in &mut inputs {
        input.write_all(&picture()).expect("the program reads");
    }
    drop(inputs);
    let run = ended(child.wait_with_output().expect("it ends"));
    let last: Vec<&str> = run.err.lines().skip(waiting).collect();
    let count = waiting + 1;
    let summary = format!("tactograph: 1 of {count} pictures could not be converted");
    let expected = ["tactograph: z.png: there is no such file; check the name", &summary];
    assert_eq!((run.code, &last[..]), (1, &expected[..]), "{}", run.err);
    pipes.iter().for_each(|pipe| place.has_page(&format!("out/{}", pipe.replace("png", "svg"))));
}

#[test]
fn standard_input_that_ends_early_or_is_closed() {
    let place = Place::new();
    let run = place.run_with_input(&["convert", "-", "-o", "p.svg"], &picture()[..100]);
    assert_eq!((run.code, run.err.lines().count()), (1, 1), "{}", run.err);
    assert!(run.err.starts_with("tactograph: standard input: the PNG picture cannot be read: "), "{}", run.err);
    let run = in_shell(&place, "exec <&-", &["convert", "-", "-o", "p.svg"]);
    assert_eq!((run.code, run.err.as_str()), (1, "tactograph: standard input: the file is empty; give a picture\n"));
    // a directory as input can be opened and not read
    let run = in_shell(&place, "exec <.", &["convert", "-", "-o", "p.svg"]);
    assert_eq!((run.code, run.err.lines().count()), (1, 1), "{}", run.err);
    assert_eq!(place.names(), Vec::<String>::new());
}

/// Before the program begins, `/dev/null` is opened in its place, so that no page gets into another file.
#[test]
fn standard_output_that_was_closed_before_the_program_began() {
    let place = Place::with_picture("a.png");
    let run = in_shell(&place, "exec >&-", &["convert", "a.png", "--quiet", "-o", "-"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert_eq!(place.names(), ["a.png"]);
    let run = in_shell(&place, "exec >&-", &["convert", "a.png", "--quiet"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    place.has_page("a.svg");
}

#[test]
fn the_output_is_the_input_or_a_directory() {
    let place = Place::new();
    place.put("a.svg", DRAWING.as_bytes());
    place.put("d.svg/x", b"");
    fs::hard_link(place.path("a.svg"), place.path("b.svg")).expect("a link");
    std::os::unix::fs::symlink("a.svg", place.path("c.svg")).expect("a link");
    for output in ["a.svg", "./a.svg", "d.svg/../a.svg", "c.svg"] {
        let run = place.run(&["convert", "a.svg", "-o", output, "--force"]);
        assert_eq!((run.code, run.err.lines().count()), (2, 1), "{output}: {}", run.err);
        assert!(run.err.contains("the page would overwrite the picture itself"), "{output}: {}", run.err);
    }
    let run = place.run(&["convert", "a.svg", "-o", "d.svg"]);
    assert_eq!((run.code, run.err.lines().count()), (1, 1), "{}", run.err);
    assert_eq!(place.text("a.svg"), DRAWING);
    // by another name of the same file the page is a file of its own
    assert_eq!(place.run(&["convert", "a.svg", "-o", "b.svg"]).code, 0);
    assert_eq!(place.text("a.svg"), DRAWING);
    place.has_page("b.svg");
}

#[test]
fn a_death_by_signal_is_none_of_ours() {
    // so that the tests above would notice: a killed run has no exit code
    let place = Place::new();
    let mut child = place.command(&["convert", "-"]).stdin(Stdio::piped()).spawn().expect("the program starts");
    signal(&child, "-KILL");
    let status = child.wait().expect("its end");
    assert_eq!((status.code(), status.signal()), (None, Some(9)));
}
