//! The scans of a progressive JPEG: a picture at an eighth of its size needs the means of blocks only, and most scans
//! hold nothing of them.

/// The parts of a file without the scans of finer detail: those that begin beyond the first coefficient of blocks, the
/// mean. None depends on what they hold. A file that is not built as it should be comes whole: the decoder names the
/// fault.
pub(super) fn of_means(file: &[u8]) -> Vec<&[u8]> {
    parts(file).unwrap_or_else(|| vec![file])
}

fn parts(file: &[u8]) -> Option<Vec<&[u8]>> {
    let mut parts = Vec::new();
    let (mut start, mut at) = (0, 2);
    // A segment: FF (any number of times), its kind, its length with the two bytes of the length, its data.
    while at < file.len() {
        let [0xFF, kind, after @ ..] = file.get(at..)? else { return None };
        match (*kind, after) {
            (0xFF, _) => at += 1,
            (0xD9, _) => break,
            (0x01 | 0xD0..=0xD8, _) => at += 2,
            (kind, [high, low, ..]) => {
                let length = usize::from(u16::from_be_bytes([*high, *low]));
                let segment = after.get(2..length)?;
                let end = at + 2 + length;
                if kind != 0xDA {
                    at = end;
                    continue;
                }
                let next = end + length_of_data(&file[end..]);
                // how many components, two bytes for each, then the first coefficient
                let first = *segment.get(1 + 2 * usize::from(*segment.first()?))?;
                if first > 0 {
                    parts.push(&file[start..at]);
                    start = next;
                }
                at = next;
            }
            _ => return None,
        }
    }
    parts.push(&file[start..]);
    Some(parts)
}

/// How many bytes come before the next mark: FF, and neither the 0 that stands for FF in data, nor a restart.
fn length_of_data(bytes: &[u8]) -> usize {
    let mut at = 0;
    while let Some(found) = bytes[at..].iter().position(|byte| *byte == 0xFF) {
        at += found;
        match bytes.get(at + 1) {
            Some(0x00 | 0xD0..=0xD7) => at += 2,
            Some(_) => return at,
            None => break,
        }
    }
    bytes.len()
}

#[cfg(test)]
mod tests;
