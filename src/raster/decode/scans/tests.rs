//! Tests of `scans`.

use super::*;

/// A scan of one component from a coefficient on, with its data.
fn scan(first: u8, data: &[u8]) -> Vec<u8> {
    [&[0xFF, 0xDA, 0, 8, 1, 1, 0, first, first, 0][..], data].concat()
}

#[test]
fn scans_beyond_the_mean_are_left_out_and_all_else_stays() {
    let head = [0xFF, 0xD8, 0xFF, 0xC4, 0, 4, 7, 7];
    let means = scan(0, &[1, 0xFF, 0, 2, 0xFF, 0xD3, 3]);
    let fine = scan(1, &[4, 0xFF, 0, 5, 0xFF, 0xD0, 6]);
    let end = [0xFF, 0xFF, 0xD9];
    let file = [&head[..], &means, &fine, &head[2..], &fine, &means, &end].concat();
    let kept = [&head[..], &means, &head[2..], &means, &end].concat();
    assert_eq!(of_means(&file).concat(), kept);
    let cut = &file[..file.len() - end.len() - 2];
    assert_eq!(of_means(cut).concat(), kept[..kept.len() - end.len() - 2], "a file that ends early still does");
}

#[test]
fn a_file_that_is_not_built_as_it_should_be_comes_whole() {
    for file in [&b""[..], &[0xFF, 0xD8, 0, 0], &[0xFF, 0xD8, 0xFF, 0xDA, 0, 9], &[0xFF, 0xD8, 0xFF, 0xDA, 0, 2, 1]] {
        assert_eq!(of_means(file).concat(), file);
    }
}
