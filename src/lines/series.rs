//! Points of one series, as the months of a curve in a chart. A few of them, where there is no room for all, are felt
//! as special ones; without them the line still says where it bends.

/// So many points that are alike on one line are a series.
pub(super) const SERIES: usize = 4;
/// A series is drawn if there is room for at least this share of its points.
const MOSTLY: f32 = 0.75;

/// Which points are drawn, where there is room for these: none of a series of which too few have room. `series` has the
/// number of the series of each point.
pub fn whole_series(series: &[Option<usize>], has_room: &[bool]) -> Vec<bool> {
    let is_whole = |of: usize| {
        let own = || series.iter().zip(has_room).filter(|(series, _)| **series == Some(of));
        own().filter(|(_, has_room)| **has_room).count() as f32 >= MOSTLY * own().count() as f32
    };
    series.iter().zip(has_room).map(|(of, has_room)| *has_room && of.is_none_or(is_whole)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_series_without_room_nothing_is_drawn() {
        let series = [Some(7), Some(7), None, Some(7), Some(7), Some(2), Some(2), Some(2), Some(2)];
        let has_room = [true, false, true, false, true, true, true, false, true];
        let drawn = [false, false, true, false, false, true, true, false, true];
        assert_eq!(whole_series(&series, &has_room), drawn);
    }
}
