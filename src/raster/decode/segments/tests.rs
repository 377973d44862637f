//! Tests of `segments`.

use super::*;

/// Kind, place and data of each segment, up to the first that is none.
fn read(file: &[u8]) -> Vec<Option<(u8, usize, Vec<u8>)>> {
    let mut segments = JpegSegments::of(file);
    let mut all = Vec::new();
    while let Some(segment) = segments.next() {
        all.push(segment.ok().map(|of| (of.kind, of.start, of.data.to_vec())));
        match segment {
            Ok(JpegSegment { kind: START_OF_SCAN, .. }) => _ = segments.skip_data(),
            Ok(_) => (),
            Err(NoSegment) => break,
        }
    }
    all
}

#[test]
fn segments_come_with_their_places_and_data_of_scans_are_none() {
    let table = [0xFF, 0xC4, 0, 4, 7, 8];
    let fill = [0xFF, 0xFF, 0xFF, 0xFE, 0, 3, 9];
    let scan = [0xFF, START_OF_SCAN, 0, 3, 5, 1, 0xFF, 0, 2, 0xFF, 0xD3, 3];
    let file = [&[0xFF, 0xD8][..], &table, &fill, &scan, &table, &[0xFF, 0xD9], &table].concat();
    let expected = [(0xC4, 2, vec![7, 8]), (0xFE, 10, vec![9]), (START_OF_SCAN, 15, vec![5]), (0xC4, 27, vec![7, 8])];
    assert_eq!(read(&file), expected.map(Some));
    assert_eq!(read(&file[..27]).len(), 3, "a file may end behind a segment");
}

#[test]
fn what_is_no_segment_or_none_that_is_whole_is_told() {
    for bytes in [&[0_u8][..], &[0xFF], &[0xFF, 0xC4], &[0xFF, 0xC4, 0], &[0xFF, 0xC4, 0, 1, 7], &[0xFF, 0xC4, 0, 4, 7]]
    {
        assert_eq!(read(&[&[0xFF, 0xD8][..], bytes].concat()), [None], "{bytes:?}");
    }
    assert!(read(&[]).is_empty());
}
