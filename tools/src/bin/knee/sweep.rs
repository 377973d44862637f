//! Every picture in every setting.

use std::path::Path;

use tactograph::internals::profile::Plan;

use crate::compare::{Sight, compare};
use crate::pictures::Picture;
use crate::rows::{DEFAULT_SCALE, Row, SCALES, Setting, is_same, profile};
use crate::run::{Outcome, classes, run};

/// px for a millimetre of the page.
const RESOLUTIONS: [f32; 8] = [2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0];
/// Where JPEG is also decoded at more than is needed, and first at what is, as all of these come as pixels.
const DECODED: [f32; 4] = [2.0, 3.0, 4.0, 5.0];
/// What pages without a known truth are held against: the most that a profile can ask for. Pictures of 12 MP have 23 on A4.
const REFERENCE: f32 = 12.0;

/// Measures.
///
/// # Errors
/// A picture cannot be made into a page, or a page cannot be written to `draw`.
pub(crate) fn sweep(name: &str, pictures: &[Picture], rounds: usize, draw: Option<&Path>) -> Result<Vec<Row>, String> {
    let plan = |setting: &Setting| {
        let changes = [("figure.resolution", setting.resolution), ("edges.scale", setting.scale)];
        Plan::new(&profile(name, &changes)?).map_err(|error| error.to_string())
    };
    let outcome = |picture: &Picture, setting: &Setting| {
        run(picture, &plan(setting)?, setting.eighths).map_err(|fault| format!("{}: {fault}", picture.name))
    };
    // with its colours, which take time of their own
    let judged = |picture: &Picture, setting: &Setting| -> Result<Outcome, String> {
        let classes = match setting.eighths {
            None => classes(picture, &plan(setting)?).map_err(|fault| format!("{}: {fault}", picture.name))?,
            Some(_) => None,
        };
        Ok(Outcome { classes, ..outcome(picture, setting)? })
    };
    let mut rows: Vec<(usize, Row)> = Vec::new();
    for (number, picture) in pictures.iter().enumerate() {
        for scale in SCALES {
            let reference = judged(picture, &Setting { resolution: REFERENCE, scale, eighths: None })?;
            for setting in settings(picture, &reference).into_iter().filter(|s| is_same(s.scale, scale)) {
                eprintln!("{} {setting:?}", picture.name);
                let page = judged(picture, &setting)?;
                let truth = match &picture.scene {
                    Some(scene) => Sight::of_scene(scene, &page),
                    None => Sight::of_page(&reference, page.place),
                };
                let errors = compare(&truth, &page, is_same(scale, DEFAULT_SCALE))?;
                if let Some(folder) = draw.filter(|_| setting.eighths.is_none()) {
                    let file =
                        folder.join(format!("{}-{}-{scale}.svg", picture.name.replace(':', "-"), setting.resolution));
                    std::fs::write(&file, &page.svg).map_err(|fault| format!("{}: {fault}", file.display()))?;
                }
                let is_scene = picture.scene.is_some();
                let picture = picture.name;
                rows.push((number, Row { picture, is_scene, setting, times: Vec::new(), errors }));
            }
        }
    }
    for round in 0..rounds {
        eprintln!("round {} of {rounds}", round + 1);
        let mut order: Vec<usize> = (0..rows.len()).collect();
        // neighbours in time are the settings of one picture
        order.sort_by_key(|&i| rows[i].0);
        if round % 2 == 1 {
            order.reverse();
        }
        for i in order {
            let (picture, row) = &mut rows[i];
            let times = outcome(&pictures[*picture], &row.setting)?.times;
            row.times.push(times);
        }
    }
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

fn settings(picture: &Picture, reference: &Outcome) -> Vec<Setting> {
    let mut settings = Vec::new();
    for scale in SCALES {
        for resolution in RESOLUTIONS {
            settings.push(Setting { resolution, scale, eighths: None });
            if picture.is_jpeg && is_same(scale, DEFAULT_SCALE) && DECODED.contains(&resolution) {
                let working = resolution * reference.place.width();
                let enough = |eighths: &u32| (reference.source.width * eighths) as f32 >= 8.0 * working;
                let fractions = [1, 2, 4, 8].into_iter().filter(enough);
                settings.extend(fractions.map(|eighths| Setting { resolution, scale, eighths: Some(eighths) }));
            }
        }
    }
    settings
}
