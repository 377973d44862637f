//! Tests of `picture`.

use super::*;

#[test]
fn pixels_must_be_as_many_as_their_size_says() {
    assert!(Picture::rgba8(2, 3, &[0; 24]).is_ok());
    for (width, height, bytes) in [(2, 3, 23), (2, 3, 25), (2, 3, 18), (0, 3, 0), (3, 0, 0), (u32::MAX, u32::MAX, 4)] {
        let refused = Picture::rgba8(width, height, &vec![0; bytes]).expect_err("a wrong number of bytes");
        assert_eq!(refused, Error::WrongPixels { size: Size::new(width, height), bytes });
    }
}
