//! Tests of `unpacked`.

use std::io::Write;

use super::*;

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(bytes).expect("written");
    encoder.finish().expect("finished")
}

#[test]
fn parts_that_unpack_beyond_the_limit_are_refused() {
    let limits = Limits { memory_mb: 3, ..Limits::default() };
    let document = |times: u32, length: usize| {
        let part = (0..times).fold(vec![b' '; length], |part, _| packed(&part));
        [b"%PDF-1.4 1 0 obj <<>> stream\r\n".as_slice(), &part, b"\nendstream endobj"].concat()
    };
    for times in 1..=3 {
        assert_eq!(check(&document(times, 2_900_000), limits), Ok(()), "{times} times");
        let told = check(&document(times, 3_100_000), limits).expect_err("too much").to_string();
        assert!(told.contains("unpacks to more than the limit of 3 MB"), "{told}");
    }
}
