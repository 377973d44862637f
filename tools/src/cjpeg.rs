//! JPEG files as cameras write them, through libjpeg-turbo's `cjpeg`.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Writes three bytes a pixel as JPEG of quality 90 with colour at half resolution; `options` are further ones of
/// `cjpeg`.
///
/// # Errors
/// `cjpeg` is missing or cannot write the file.
pub fn cjpeg(rgb: &[u8], [width, height]: [usize; 2], options: &[&str], file: &Path) -> Result<(), String> {
    let needs = |fault| {
        format!(
            "cjpeg, which makes the pictures, does not run ({fault}): install libjpeg-turbo, or run \
             tools/src/bin/bench_all/peers.sh"
        )
    };
    let mut child = Command::new("cjpeg")
        .args(["-quality", "90", "-sample", "2x2"])
        .args(options)
        .arg("-outfile")
        .arg(file)
        .stdin(Stdio::piped())
        .spawn()
        .map_err(needs)?;
    let written = child.stdin.take().map(|mut pipe| {
        pipe.write_all(format!("P6 {width} {height} 255\n").as_bytes())?;
        pipe.write_all(rgb)
    });
    let ended = child.wait().map_err(needs)?;
    match written {
        Some(Ok(())) if ended.success() => Ok(()),
        _ => Err("cjpeg could not write a picture".into()),
    }
}
