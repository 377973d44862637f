//! The table of `--quality` in docs/speed.md: three settings of all that were measured.

use std::fmt::Write as _;

use crate::rows::{DEFAULT_SCALE, Row, Setting, mean_errors};

/// The page, and the mark between whose lines the table stands.
pub(crate) const PAGE: &str = "docs/speed.md";
pub(crate) const MARK: &str = "knee";

/// What `--quality` takes (`src/cli/args/shared.rs`), what it sets, and which setting that is of swell-a4: px for a
/// millimetre, and the scale of edges, mm.
const QUALITIES: [(&str, &[&str], [f32; 2]); 3] = [
    ("draft", &["figure.resolution=2", "edges.scale=0.6"], [2.0, 0.6]),
    ("standard", &[], [4.0, DEFAULT_SCALE]),
    ("fine", &["figure.resolution=8"], [8.0, DEFAULT_SCALE]),
];

/// The table, and what its figures are; `made` says when and of which sources.
pub(crate) fn table(rows: &[Row], made: &str) -> String {
    let mut text = String::from(
        "| `--quality` | the same as `--set` | drawn scenes, known truth | photo of 12 megapixels, beside 12 px/mm | missing \
         and extra there |\n|---|---|---|---|---|\n",
    );
    for (name, sets, [resolution, scale]) in QUALITIES {
        let setting = Setting { resolution, scale, eighths: None };
        let [mut scenes, mut photo] = [Vec::new(), Vec::new()];
        for row in rows.iter().filter(|row| row.setting == setting) {
            match row.picture {
                _ if row.is_scene => scenes.push(row),
                "photo-12" => photo.push(row),
                _ => {}
            }
        }
        let sets = match sets {
            [] => format!("nothing: {resolution} px/mm, {scale} mm"),
            sets => sets.iter().map(|set| format!("`{set}`")).collect::<Vec<_>>().join(", "),
        };
        let there = mean_errors(&photo);
        let _ = writeln!(
            text,
            "| `{name}` | {sets} | {} | {} | {:.1} and {:.1} % |",
            cell(&scenes),
            cell(&photo),
            1e2 * there.missing,
            1e2 * there.extra
        );
    }
    let _ = writeln!(
        text,
        "\nMade {made}. Time is working time of one core, from the file in memory to the page. The distance is how far lines \
         lie from where they should, on the page: RMS, and in brackets what 95 percent keep within."
    );
    text
}

/// Time and distance, as the means of some pictures.
fn cell(of: &[&Row]) -> String {
    let ms = of.iter().map(|row| row.all()).sum::<f64>() / of.len() as f64;
    let errors = mean_errors(of);
    format!("{ms:.0} ms, {:.2} mm ({:.2})", errors.rms, errors.p95)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::Errors;
    use crate::run::STAGES;

    fn row(picture: &'static str, [resolution, scale]: [f32; 2], eighths: Option<u32>, ms: f64, rms: f64) -> Row {
        let mut times = [0.0; STAGES.len()];
        times[0] = ms;
        Row {
            picture,
            is_scene: picture.starts_with("scene"),
            setting: Setting { resolution, scale, eighths },
            times: vec![times],
            errors: Errors::from([rms, 2.0 * rms, 0.25 * rms, 0.5 * rms, 0.0, 0.0, 0.0]),
        }
    }

    #[test]
    fn a_quality_has_the_means_of_its_own_rows() {
        let mut rows = Vec::new();
        for (_, _, of) in QUALITIES {
            let ms = f64::from(10.0 * of[0]);
            rows.push(row("scene-4:3", of, None, ms, 0.04));
            rows.push(row("scene-3:2", of, None, ms + 20.0, 0.06));
            rows.push(row("photo-12", of, None, ms + 1.0, 0.1));
            rows.push(row("photo-12", of, Some(4), 900.0, 0.9));
            rows.push(row("coffee.png", of, None, 900.0, 0.9));
            rows.push(row("photo-12", [of[0], 0.3], None, 900.0, 0.9));
        }
        let text = table(&rows, "on a day");
        let lines: Vec<&str> = text.lines().skip(2).take(3).collect();
        let figures =
            |ms: [u32; 2]| format!("{} ms, 0.05 mm (0.10) | {} ms, 0.10 mm (0.20) | 2.5 and 5.0 % |", ms[0], ms[1]);
        assert_eq!(lines[0], format!("| `draft` | `figure.resolution=2`, `edges.scale=0.6` | {}", figures([30, 21])));
        assert_eq!(lines[1], format!("| `standard` | nothing: 4 px/mm, 0.45 mm | {}", figures([50, 41])));
        assert_eq!(lines[2], format!("| `fine` | `figure.resolution=8` | {}", figures([90, 81])));
        assert!(text.contains("Made on a day."), "{text}");
    }

    #[test]
    fn the_qualities_are_those_of_the_program() {
        let text = |file: &str| std::fs::read_to_string(format!("{}/{file}", tactograph_tools::ROOT)).unwrap();
        let program = text("src/cli/args/shared.rs");
        for (name, sets, _) in QUALITIES {
            let mut variant = name.to_owned();
            variant[..1].make_ascii_uppercase();
            let sets = sets.iter().map(|set| format!("\"{set}\"")).collect::<Vec<_>>().join(", ");
            assert!(program.contains(&format!("Self::{variant} => &[{sets}]")), "{name}");
        }
        tactograph_tools::marks::exchanged(PAGE, &text(PAGE), MARK, "").unwrap();
    }
}
