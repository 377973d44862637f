//! How a page replaces an old one, and what is left when it cannot.

use std::fs;

use crate::cli::common::*;

#[test]
fn an_old_page_is_replaced_when_the_new_one_is_complete() {
    let place = Place::with_picture("a.png");
    place.put("p.svg", b"old");
    assert_eq!(place.run(&["convert", "a.png", "-o", "p.svg"]).code, 0);
    place.has_page("p.svg");
    assert_eq!(place.names(), ["a.png", "p.svg"]);
}

#[test]
fn an_old_page_stays_when_there_is_no_new_one() {
    let place = Place::new();
    let truncated = &picture()[..60];
    for (name, bytes) in [("empty.png", &b""[..]), ("text.png", b"hello\n"), ("cut.png", truncated)] {
        place.put(name, bytes);
        place.put("p.svg", b"old");
        assert_eq!(place.run(&["convert", name, "-o", "p.svg"]).code, 1, "{name}");
        assert_eq!(place.text("p.svg"), "old", "{name}");
    }
    place.refuses(&["convert", "none.png", "-o", "p.svg"], 1, &["none.png: there is no such file; check the name"]);
    assert_eq!(place.run(&["convert", "text.png", "-o", "p.svg", "--set", "nonsense=1"]).code, 2);
    assert_eq!(place.text("p.svg"), "old");
    assert_eq!(place.names(), ["cut.png", "empty.png", "p.svg", "text.png"], "something is left over");
}

#[cfg(unix)]
#[test]
fn permissions_and_links_survive() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let place = Place::with_picture("a.png");
    let mode = |name: &str| fs::metadata(place.path(name)).expect("a file").permissions().mode() & 0o777;
    // A new page has what any new file has here.
    assert_eq!(place.run(&["convert", "a.png"]).code, 0);
    assert_eq!(mode("a.svg"), mode("a.png"));
    // An old one keeps its own.
    fs::set_permissions(place.path("a.svg"), PermissionsExt::from_mode(0o640)).expect("a change");
    assert_eq!(place.run(&["convert", "a.png"]).code, 0);
    assert_eq!(mode("a.svg"), 0o640);
    // A link stays one; the file it leads to is replaced, or made.
    place.put("d/real.svg", b"old");
    symlink("d/real.svg", place.path("link.svg")).expect("a link");
    symlink("d/new.svg", place.path("dangling.svg")).expect("a link");
    symlink("round.svg", place.path("round.svg")).expect("a link");
    assert_eq!(place.run(&["convert", "a.png", "-o", "link.svg"]).code, 0);
    assert_eq!(place.run(&["convert", "a.png", "-o", "dangling.svg"]).code, 0);
    place.has_page("d/real.svg");
    place.has_page("d/new.svg");
    for link in ["link.svg", "dangling.svg"] {
        assert!(fs::symlink_metadata(place.path(link)).expect("a link").is_symlink(), "{link} is no link any more");
    }
    let line = "round.svg: the page cannot be written here, as this link leads round in a circle; choose another name";
    place.refuses(&["convert", "a.png", "-o", "round.svg"], 1, &[line]);
}

#[test]
fn where_no_page_can_be_written() {
    let place = Place::with_picture("a.png");
    place.put("file", b"x");
    place.put("d/x", b"x");
    let cases = [
        ("d", "as this is a directory; name a file, or use --out-dir"),
        ("no/p.svg", "as the directory is missing; make it, or use --out-dir"),
        ("file/p.svg", "as a part of this path is a file, not a directory; check the name"),
    ];
    for (page, why) in cases {
        let line = format!("{page}: the page cannot be written here, {why}");
        place.refuses(&["convert", "a.png", "-o", page], 1, &[&line]);
    }
    let line = "file: this directory cannot be made, as a file has its name; choose another name";
    place.refuses(&["convert", "a.png", "--out-dir", "file"], 1, &[line]);
    let line = "file/d: this directory cannot be made, as a file has its name; choose another name";
    place.refuses(&["convert", "a.png", "--out-dir", "file/d"], 1, &[line]);
    place.put("p.svg", b"old");
    let mut permissions = fs::metadata(place.path("p.svg")).expect("a file").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(place.path("p.svg"), permissions).expect("a change");
    let why = "as this file is write-protected; lift that or choose another name";
    let line = format!("p.svg: the page cannot be written here, {why}");
    place.refuses(&["convert", "a.png", "-o", "p.svg"], 1, &[&line]);
    assert_eq!((place.text("p.svg"), place.text("file")), ("old".into(), "x".into()));
    assert_eq!(place.names(), ["a.png", "d", "file", "p.svg"], "something is left over");
}

#[cfg(target_os = "linux")]
#[test]
fn devices_are_written_to_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    let place = Place::with_picture("a.png");
    let full = "the page cannot be written, as the disk is full; make room and try again";
    place.refuses(&["convert", "a.png", "-o", "/dev/full"], 1, &[&format!("/dev/full: {full}")]);
    assert_eq!(place.run(&["convert", "a.png", "-o", "/dev/null"]).code, 0);
    assert!(fs::metadata("/dev/null").expect("/dev/null").file_type().is_char_device());
    let mut command = place.command(&["convert", "a.png", "-o", "-"]);
    let full_disk = fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
    let run = ended(command.stdout(full_disk).output().expect("the program starts"));
    assert_eq!((run.code, run.err), (1, format!("tactograph: standard output: {full}\n")));
    // What a shell gives for >(cat), and a program for its own standard output.
    let run = place.run(&["convert", "a.png", "-o", "/dev/stdout"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote /dev/stdout\n"));
    assert_is_page(&run.out, "/dev/stdout");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let place = Place::with_picture("a.png");
    for args in [&["convert", "a.png", "-q", "-o", "-"][..], &["profiles", "show", "swell-a4"], &["--help"]] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let run = ended(place.command(args).stdout(writer).output().expect("the program starts"));
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{args:?}");
    }
    // Nor is it one when nobody wants to hear messages.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let status = place.command(&["convert", "a.png"]).stderr(writer).status().expect("the program starts");
    assert_eq!(status.code(), Some(0));
    place.has_page("a.svg");
}
