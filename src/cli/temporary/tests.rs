//! Tests of `temporary`.

use super::*;

#[test]
fn what_is_left_over_goes_and_what_lives_stays() {
    let dir = tempfile::tempdir().expect("a directory");
    let (left, other) = (dir.path().join(".tactograph-abc.tmp"), dir.path().join(".tactograph-abc.svg"));
    for path in [&left, &other] {
        fs::write(path, b"half").expect("a file");
    }
    let mut first = Temporary::new_in(dir.path()).expect("a file");
    assert!(!left.exists() && other.exists(), "what was left over goes, and nothing else");
    sweep(dir.path());
    let lives = first.0.as_ref().is_some_and(|file| file.path().exists());
    assert!(lives && first.file().is_ok(), "what lives stays");
    let page = dir.path().join("page.svg");
    first.persist(&page).expect("its name");
    assert!(page.exists());
    drop(Temporary::new_in(dir.path()).expect("a file"));
    assert_eq!(fs::read_dir(dir.path()).expect("the directory").count(), 2, "something is left over");
}
