//! Tests of `shares`.

use super::*;

/// In whole percent.
fn percents(shares: &[f32]) -> Vec<i64> {
    told(shares).iter().map(|share| (100.0 * share).round() as i64).collect()
}

#[test]
fn colours_and_what_is_blank_add_up() {
    // rounded one by one they made 102 percent
    assert_eq!(percents(&[0.316, 0.186, 0.166, 0.136, 0.106, 0.09]), [31, 18, 17, 14, 11, 9]);
    // and these 98
    assert_eq!(percents(&[0.314, 0.184, 0.164, 0.134, 0.104, 0.1]), [32, 19, 16, 13, 10, 10]);
    assert_eq!(percents(&[0.6974, 0.1773, 0.1253]), [70, 18, 12]);
    assert_eq!(percents(&[0.4, 0.1]), [40, 10], "the blank is not among them");
}

#[test]
fn equal_shares_are_told_alike() {
    // the bars of a chart, of which 5 times 9 and 57 are 102 percent
    assert_eq!(percents(&[0.0862, 0.0862, 0.0862, 0.0862, 0.0862, 0.569]), [9, 9, 9, 9, 9, 56]);
    assert_eq!(percents(&[0.4866, 0.4866, 0.0268]), [49, 49, 2], "one percent cannot be shared out between two");
}

#[test]
fn nothing_is_told_as_nothing_or_as_all() {
    let shares = [0.996, 0.004];
    assert_eq!(told(&shares), shares.to_vec(), "over 99 and under 1 percent");
    assert_eq!(percents(&[0.5046, 0.4854, 0.0055, 0.0045]), [50, 49, 1, 0]);
    assert!(told(&[]).is_empty());
}
