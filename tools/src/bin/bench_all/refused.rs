//! When tables are not written into the pages: a program is missing or failed, or the machine was busy.

use crate::targets::{Beside, Row};

/// Work in both tables, and a program of one thread that does it: with one core or more, it takes as long.
const STEADY: [&str; 2] = ["12 MP JPEG", "djpeg -scale 1/4"];
/// The longer of its two times may be so many times the shorter.
const MOST: f64 = 1.1;

/// Refuses where programs are missing, whose rows would be gone from the pages.
///
/// # Errors
/// There is one.
pub(crate) fn missing(programs: &[String]) -> Result<(), String> {
    match programs {
        [] => Ok(()),
        some => Err(format!("--write needs all rows; not installed: {}", some.join(", "))),
    }
}

/// Refuses where somebody failed, or [`STEADY`] took another time in one table than in the other.
///
/// # Errors
/// That is so.
pub(crate) fn check(tables: [&[Row]; 2]) -> Result<(), String> {
    let failed = tables.into_iter().flatten().find_map(|row| match &row.beside {
        _ if row.ours[0].is_none() => Some(format!("{}: tactograph failed", row.work)),
        Beside::Peer { name, figures: [None, ..], .. } => Some(format!("{}: {name}", row.work)),
        _ => None,
    });
    if let Some(fault) = failed {
        return Err(format!("{fault}; nothing is written"));
    }
    let [work, steady] = STEADY;
    let [Some(one), Some(other)] = tables.map(|rows| rows.iter().find_map(time)) else {
        return Err(format!("{steady} did not run for {work}; nothing is written"));
    };
    if one.max(other) > MOST * one.min(other) {
        return Err(format!(
            "{steady} took {one:.1} ms in one table and {other:.1} ms in the other: the machine was busy; nothing is written"
        ));
    }
    Ok(())
}

/// How long [`STEADY`] took, if this is its row.
fn time(row: &Row) -> Option<f64> {
    match &row.beside {
        Beside::Peer { name, figures, .. } if [row.work.as_str(), name.as_str()] == STEADY => figures[0],
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(work: &str, peer: &str, time: Option<f64>) -> Row {
        Row {
            work: work.into(),
            ours: [Some(100.0); 3],
            beside: Beside::Peer { name: peer.into(), figures: [time; 3], ratios: [None; 2] },
            wanted: String::new(),
            met: None,
            is_short: false,
        }
    }

    fn rows(djpeg: f64, vips: Option<f64>) -> Vec<Row> {
        let [work, steady] = STEADY;
        // the same program is slower with other work
        vec![
            row("12 MP progressive JPEG", steady, Some(900.0 - djpeg)),
            row(work, steady, Some(djpeg)),
            row(work, "vips thumbnail", vips),
        ]
    }

    #[test]
    fn a_busy_machine_is_refused() {
        let quiet = rows(30.0, Some(170.0));
        assert_eq!(check([&quiet, &rows(32.9, Some(140.0))]), Ok(()));
        for [one, other] in [[30.0, 33.1], [33.1, 30.0]] {
            let fault = check([&rows(one, Some(170.0)), &rows(other, Some(140.0))]).unwrap_err();
            assert!(fault.contains("30.0 ms") && fault.contains("33.1 ms") && fault.contains("busy"), "{fault}");
        }
    }

    #[test]
    fn a_program_that_is_missing_or_fails_is_refused() {
        let quiet = rows(30.0, Some(170.0));
        let fault = check([&quiet, &rows(30.0, None)]).unwrap_err();
        assert!(fault.contains("vips thumbnail"), "{fault}");
        let fault = check([&quiet, &quiet[..1]]).unwrap_err();
        assert!(fault.contains("did not run"), "{fault}");
        assert_eq!(missing(&[]), Ok(()));
        assert!(missing(&["potrace".into(), "vips".into()]).unwrap_err().contains("potrace, vips"));
    }
}
