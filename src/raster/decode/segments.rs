//! The segments of a JPEG: what it holds beside the data of its pixels.

/// The kind of a segment behind which the data of a scan follow.
pub(super) const START_OF_SCAN: u8 = 0xDA;

/// A header or a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct JpegSegment<'a> {
    pub(super) kind: u8,
    /// Where its mark stands in the file.
    pub(super) start: usize,
    /// What follows its length.
    pub(super) data: &'a [u8],
}

/// Where a segment should be there is none, or one that the file does not hold whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NoSegment;

/// The segments of a file up to its end mark. Data of a scan are none: behind a [`START_OF_SCAN`] who goes on calls
/// [`JpegSegments::skip_data`].
#[derive(Debug, Clone)]
pub(super) struct JpegSegments<'a> {
    file: &'a [u8],
    at: usize,
}

impl<'a> JpegSegments<'a> {
    /// Those of a file, which begins with the mark of a JPEG.
    pub(super) fn of(file: &'a [u8]) -> Self {
        Self { file, at: 2 }
    }

    /// Goes over the data of a scan. Returns where they end.
    pub(super) fn skip_data(&mut self) -> usize {
        self.at += length_of_data(&self.file[self.at..]);
        self.at
    }

    /// The next segment, none at the end.
    fn read(&mut self) -> Result<Option<JpegSegment<'a>>, NoSegment> {
        let file = self.file;
        // A segment: FF (any number of times), its kind, its length with the two bytes of the length, its data.
        while self.at < file.len() {
            let [0xFF, kind, after @ ..] = &file[self.at..] else { return Err(NoSegment) };
            match (*kind, after) {
                (0xFF, _) => self.at += 1,
                (0xD9, _) => break,
                (0x01 | 0xD0..=0xD8, _) => self.at += 2,
                (kind, [high, low, ..]) => {
                    let length = usize::from(u16::from_be_bytes([*high, *low]));
                    let data = after.get(2..length).ok_or(NoSegment)?;
                    let start = self.at;
                    self.at += 2 + length;
                    return Ok(Some(JpegSegment { kind, start, data }));
                }
                _ => return Err(NoSegment),
            }
        }
        Ok(None)
    }
}

impl<'a> Iterator for JpegSegments<'a> {
    type Item = Result<JpegSegment<'a>, NoSegment>;

    fn next(&mut self) -> Option<Self::Item> {
        self.read().transpose()
    }
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
