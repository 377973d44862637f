//! The scans of a progressive JPEG: a picture at an eighth of its size needs the means of blocks only, and most scans
//! hold nothing of them.

use super::segments::{JpegSegments, START_OF_SCAN};

/// The parts of a file without the scans of finer detail: those that begin beyond the first coefficient of blocks, the
/// mean. None depends on what they hold. A file that is not built as it should be comes whole: the decoder names the
/// fault.
pub(super) fn of_means(file: &[u8]) -> Vec<&[u8]> {
    parts(file).unwrap_or_else(|| vec![file])
}

fn parts(file: &[u8]) -> Option<Vec<&[u8]>> {
    let (mut parts, mut start) = (Vec::new(), 0);
    let mut segments = JpegSegments::of(file);
    while let Some(segment) = segments.next() {
        let segment = segment.ok()?;
        if segment.kind != START_OF_SCAN {
            continue;
        }
        let next = segments.skip_data();
        // how many components, two bytes for each, then the first coefficient
        let first = *segment.data.get(1 + 2 * usize::from(*segment.data.first()?))?;
        if first > 0 {
            parts.push(&file[start..segment.start]);
            start = next;
        }
    }
    parts.push(&file[start..]);
    Some(parts)
}

#[cfg(test)]
mod tests;
