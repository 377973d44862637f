//! Tests of `watch`.

use super::*;

#[test]
fn pictures_are_told_from_what_programs_leave() {
    for name in ["a.png", "A.JPG", "my photo.jpeg", "page.svg", "sheet.pdf"] {
        assert!(is_picture(Path::new(name)) && is_finished(Path::new(name)), "{name}");
    }
    for name in [".a.png", "a.png~", "a.png.part", ".goutputstream-X1", "a.svg.tmp", "~lock.png"] {
        assert!(!is_finished(Path::new(name)), "{name}");
    }
    for name in ["notes.txt", "png", "a.idx", "a.heic"] {
        assert!(is_finished(Path::new(name)) && !is_picture(Path::new(name)), "{name}");
    }
}

#[test]
fn reading_a_file_is_no_change() {
    let event = |kind| Event::new(kind).add_path("d/a.png".into());
    let mut waiting = Waiting::default();
    for kind in [AccessKind::Read, AccessKind::Open(AccessMode::Any), AccessKind::Close(AccessMode::Read)] {
        waiting.add(&event(EventKind::Access(kind)));
    }
    assert!(waiting.0.is_empty());
    waiting.add(&event(EventKind::Access(AccessKind::Close(AccessMode::Write))));
    assert_eq!(waiting.0.len(), 1);
    assert!(waiting.take_settled().is_empty(), "it may not be complete yet");
}
