//! Tests of `fonts`.

use super::*;

#[test]
fn fonts_are_loaded_once_and_shared_by_clones() {
    let fonts = Fonts::from_data(Vec::new()).expect("no file that is no font");
    let clone = fonts.clone();
    assert!(Arc::ptr_eq(&fonts.database(), &clone.database()));
    assert!(fonts.database().is_empty() && Fonts::none().database().is_empty());
}

#[test]
fn bytes_that_are_no_font_are_refused_by_their_number() {
    let files: [&[u8]; 4] = [b"no font", b"", b"wOF2", b"\0\x01\0\0\0\x01"];
    for file in files {
        let refused = Fonts::from_data(vec![file.to_vec()]).expect_err("it is no font");
        assert_eq!(refused, Error::NotAFont { file: 1 });
    }
}
