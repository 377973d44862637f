//! Other detectors' lines: the pictures are written for them, and what they traced is read.
//!
//! ```text
//! DIR/scenes/<condition>/<scene>.png          written by --export
//! DIR/mosaic.png                              one megapixel, to measure the time
//! DIR/<peer>/<condition>/<scene>.json         the peer's lines, in pixels of the picture, centres at +0.5:
//!     {"image": [w, h], "polylines": [{"closed": false, "points": [[x, y], ...], "strength": [...]}]}
//! DIR/<peer>/ms_per_megapixel.txt             median and best
//! ```

use std::error::Error;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::condition::Condition;
use crate::detector::Time;
use crate::draw::Picture;
use crate::measure::Traced;
use crate::scene::Scene;

/// Folder of the pictures; any other folder is a peer.
const SCENES: &str = "scenes";
const TIMES: &str = "ms_per_megapixel.txt";

/// Writes the pictures taken under one condition.
pub(crate) fn export(
    folder: &Path,
    condition: Condition,
    scenes: &[Scene],
    pictures: &[Picture],
) -> Result<(), Box<dyn Error>> {
    let folder = folder.join(SCENES).join(condition.name());
    fs::create_dir_all(&folder)?;
    for (scene, picture) in scenes.iter().zip(pictures) {
        write_png(&folder.join(format!("{}.png", scene.name)), picture)?;
    }
    Ok(())
}

/// Writes the picture on which the time is measured.
pub(crate) fn export_mosaic(folder: &Path, picture: &Picture) -> Result<(), Box<dyn Error>> {
    write_png(&folder.join("mosaic.png"), picture)
}

fn write_png(file: &Path, picture: &Picture) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(fs::File::create(file)?, picture.size[0] as u32, picture.size[1] as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    Ok(())
}

/// The peers that have traced something, by name.
pub(crate) fn names(folder: &Path) -> Result<Vec<String>, Box<dyn Error>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(|fault| format!("{}: {fault}", folder.display()))? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().join(TIMES).is_file() && name != SCENES {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}

/// A peer's time.
pub(crate) fn time(folder: &Path, peer: &str) -> Option<Time> {
    let text = fs::read_to_string(folder.join(peer).join(TIMES)).ok()?;
    let mut numbers = text.split_whitespace().map_while(|word| word.parse().ok());
    Some(Time { median: numbers.next()?, best: numbers.next()? })
}

/// A peer's lines in one picture, or nothing if it was not given the picture.
pub(crate) fn lines(
    folder: &Path,
    peer: &str,
    condition: Condition,
    scene: &Scene,
) -> Result<Option<Vec<Traced>>, Box<dyn Error>> {
    let file = folder.join(peer).join(condition.name()).join(format!("{}.json", scene.name));
    if !file.is_file() {
        return Ok(None);
    }
    let lines = read(&fs::read_to_string(&file)?).map_err(|fault| format!("{}: {fault}", file.display()))?;
    Ok(Some(lines))
}

fn read(text: &str) -> Result<Vec<Traced>, String> {
    let value: Value = serde_json::from_str(text).map_err(|fault| fault.to_string())?;
    let polylines = value["polylines"].as_array().ok_or("there are no polylines")?;
    polylines.iter().enumerate().map(|(i, line)| polyline(line).ok_or(format!("polyline {i} is not whole"))).collect()
}

fn polyline(value: &Value) -> Option<Traced> {
    let pair = |value: &Value| Some([value.get(0)?.as_f64()?, value.get(1)?.as_f64()?]);
    let mut line = Traced {
        closed: value["closed"].as_bool()?,
        points: value["points"].as_array()?.iter().map(pair).collect::<Option<_>>()?,
        strength: value["strength"].as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?,
    };
    if line.points.len() != line.strength.len() {
        return None;
    }
    if line.closed && line.points.first() != line.points.last() {
        line.points.push(line.points[0]);
        line.strength.push(line.strength[0]);
    }
    Some(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_ends_where_it_starts_and_faults_are_told() {
        let text = r#"{"image":[9,9],"polylines":[{"closed":true,"points":[[1,2],[3,4.5],[5,6]],"strength":[1,2,3]}]}"#;
        let lines = read(text).unwrap();
        assert_eq!(lines[0].points, [[1.0, 2.0], [3.0, 4.5], [5.0, 6.0], [1.0, 2.0]]);
        assert_eq!(lines[0].strength, [1.0, 2.0, 3.0, 1.0]);
        let short = text.replace("[1,2,3]", "[1,2]");
        assert_eq!(read(&short).unwrap_err(), "polyline 0 is not whole");
    }
}
