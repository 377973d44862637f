//! What was measured, as a table and as CSV.

use std::fmt::Write as _;

use tactograph::internals::profile::Profile;
use tactograph_tools::median::median;

use crate::compare::Errors;
use crate::run::STAGES;

/// Scales of edges that are measured, mm: a finer one, the default, and a coarser one.
pub(crate) const SCALES: [f32; 3] = [0.3, DEFAULT_SCALE, 0.6];
pub(crate) const DEFAULT_SCALE: f32 = 0.45;

/// Whether two scales are one.
pub(crate) fn is_same(one: f32, other: f32) -> bool {
    (one - other).abs() < 1e-6
}

/// One way to work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Setting {
    /// px for a millimetre of the page.
    pub(crate) resolution: f32,
    /// Scale of edges, mm.
    pub(crate) scale: f32,
    /// At how many eighths of its size a JPEG is decoded, and handed over as pixels; as the program does without.
    pub(crate) eighths: Option<u32>,
}

/// One picture in one setting.
pub(crate) struct Row {
    pub(crate) picture: &'static str,
    /// Whether the truth is what was drawn.
    pub(crate) is_scene: bool,
    pub(crate) setting: Setting,
    pub(crate) times: Vec<[f64; STAGES.len()]>,
    pub(crate) errors: Errors,
}

impl Row {
    /// Median of a stage, ms.
    fn stage(&self, name: &str) -> f64 {
        let of = |times: &[f64; STAGES.len()]| {
            STAGES.iter().zip(times).find(|(stage, _)| **stage == name).map(|(_, ms)| *ms)
        };
        median(self.times.iter().filter_map(of)).unwrap_or(f64::NAN)
    }

    /// Median of the whole, ms.
    pub(crate) fn all(&self) -> f64 {
        median(self.times.iter().map(|times| times.iter().sum::<f64>())).unwrap_or(f64::NAN)
    }
}

/// A built-in profile with other values.
///
/// # Errors
/// There is no such profile or key.
pub(crate) fn profile(name: &str, changes: &[(&str, f32)]) -> Result<Profile, String> {
    let told = |error: tactograph::Error| error.to_string();
    let mut profile = Profile::named(name).map_err(told)?;
    for (key, value) in changes {
        profile.set(key, value).map_err(told)?;
    }
    Ok(profile)
}

/// Every figure.
pub(crate) fn csv(rows: &[Row]) -> String {
    let stages = STAGES.map(|stage| format!("ms_{stage}")).join(",");
    let mut text =
        format!("picture,px_per_mm,edge_scale_mm,jpeg_decoded_at,ms_all,{stages},{}\n", Errors::NAMES.join(","));
    for row in rows {
        let Setting { resolution, scale, eighths } = row.setting;
        let eighths = eighths.map_or("as needed".into(), |eighths| format!("{eighths}/8"));
        let stages: Vec<String> = STAGES.iter().map(|stage| format!("{:.2}", row.stage(stage))).collect();
        let errors = row.errors.all().map(|e| if e.is_nan() { String::new() } else { format!("{e:.4}") }).join(",");
        let _ = writeln!(
            text,
            "{},{resolution},{scale},{eighths},{:.2},{},{errors}",
            row.picture,
            row.all(),
            stages.join(",")
        );
    }
    text
}

/// Scenes together and every other picture by itself, as Markdown.
pub(crate) fn table(rows: &[Row]) -> String {
    let mut text = String::new();
    let mut names: Vec<&str> = rows.iter().filter(|row| !row.is_scene).map(|row| row.picture).collect();
    names.dedup();
    let groups = [("drawn scenes", None)].into_iter().chain(names.into_iter().map(|name| (name, Some(name))));
    for (title, name) in groups {
        let _ = writeln!(
            text,
            "\n{title}\n\n| px/mm | scale | decoded at | ms | decode | edges | rms mm | p95 mm | missing | extra | strength | class | read |\n\
             |---|---|---|---|---|---|---|---|---|---|---|---|---|"
        );
        let wanted = |row: &&Row| name.map_or(row.is_scene, |name| row.picture == name);
        for setting in settings(rows) {
            let of: Vec<&Row> = rows.iter().filter(wanted).filter(|row| row.setting == setting).collect();
            if of.is_empty() {
                continue;
            }
            let mean = |value: &dyn Fn(&Row) -> f64| of.iter().map(|row| value(row)).sum::<f64>() / of.len() as f64;
            let errors = mean_errors(&of);
            let eighths = setting.eighths.map_or("as needed".into(), |eighths| format!("{eighths}/8"));
            let _ = writeln!(
                text,
                "| {} | {} | {eighths} | {:.1} | {:.1} | {:.1} | {:.4} | {:.4} | {:.4} | {:.4} | {:.4} | {:.4} | {:.4} |",
                setting.resolution,
                setting.scale,
                mean(&|row| row.all()),
                mean(&|row| row.stage("decode")),
                mean(&|row| row.stage("edges")),
                errors.rms,
                errors.p95,
                errors.missing,
                errors.extra,
                errors.strength,
                errors.class,
                errors.read,
            );
        }
    }
    text
}

/// Settings in the order in which they came.
pub(crate) fn settings(rows: &[Row]) -> Vec<Setting> {
    let mut settings: Vec<Setting> = Vec::new();
    for row in rows {
        if !settings.contains(&row.setting) {
            settings.push(row.setting);
        }
    }
    settings
}

/// Figure by figure, the mean.
pub(crate) fn mean_errors(rows: &[&Row]) -> Errors {
    let mut sums = [0.0; 7];
    for row in rows {
        sums.iter_mut().zip(row.errors.all()).for_each(|(sum, error)| *sum += error / rows.len() as f64);
    }
    Errors::from(sums)
}
