//! Tests of `session`.

use super::*;

#[test]
fn what_was_seen_or_written_is_no_news() {
    let place = tempfile::tempdir().expect("a directory");
    let session = Session::default();
    let (picture, page) = (place.path().join("a.png"), place.path().join("a.svg"));
    std::fs::write(&picture, b"one").expect("a file");
    assert!(session.is_news(&picture).expect("read") && !session.is_news(&picture).expect("read"));
    std::fs::write(&picture, b"two").expect("a file");
    assert!(session.is_news(&picture).expect("read"), "other bytes are news");
    let long = vec![b'x'; 200_000]; // more than one part
    assert_eq!(session.writes(&page, &long, &picture), None);
    std::fs::write(&page, &long).expect("a file");
    assert!(session.is_own(&page) && !session.is_own(&picture));
    assert!(!session.is_news(&page).expect("read") && session.is_own(&page), "own files are no news");
    std::fs::write(&page, b"edited").expect("a file");
    assert!(!session.is_own(&page) && session.is_news(&page).expect("read") && !session.is_own(&page));
    assert_eq!(session.writes(&page, b"again", &picture), None, "what a person wrote was made of no picture");
    assert_eq!(session.writes(&page, b"again", Path::new("b.png")), Some(picture));
    assert!(session.is_news(&place.path().join("gone.png")).is_err());
}

#[test]
fn a_picture_that_failed_is_news_again_until_it_is_mended() {
    let place = tempfile::tempdir().expect("a directory");
    let session = Session::default();
    let picture = place.path().join("a.png");
    std::fs::write(&picture, b"one").expect("a file");
    assert!(session.is_news(&picture).expect("read"));
    session.settle(&picture, true);
    session.settle(&picture, true);
    assert_eq!(session.counts(), (0, 1));
    assert!(session.is_news(&picture).expect("read"), "the same bytes are tried again");
    session.settle(&picture, false);
    session.count_page();
    assert_eq!(session.counts(), (1, 0));
    assert!(!session.is_news(&picture).expect("read"), "what is done is done");
}
