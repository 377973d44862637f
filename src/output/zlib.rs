//! Compression, for the formats that have it.

use flate2::{Compress, Compression, FlushCompress, Status};

/// A zlib stream that is written piece by piece.
pub(super) struct Stream {
    compress: Compress,
    out: Vec<u8>,
}

/// Room that is made for compressed bytes at a time.
const ROOM: usize = 64 << 10;

impl Stream {
    /// An empty stream; `level` is 1..=9.
    pub(super) fn new(level: u32) -> Self {
        Self { compress: Compress::new(Compression::new(level), true), out: Vec::new() }
    }

    /// Adds `bytes`.
    pub(super) fn push(&mut self, mut bytes: &[u8]) {
        while !bytes.is_empty() {
            bytes = &bytes[self.step(bytes, FlushCompress::None).0..];
        }
    }

    /// The whole stream.
    pub(super) fn finish(mut self) -> Vec<u8> {
        while !self.step(&[], FlushCompress::Finish).1 {}
        self.out
    }

    /// How many of the bytes are taken, and whether the stream is at its end.
    fn step(&mut self, bytes: &[u8], flush: FlushCompress) -> (usize, bool) {
        if self.out.capacity() - self.out.len() < ROOM / 2 {
            self.out.reserve(ROOM);
        }
        let before = self.compress.total_in();
        // Compressing fails only where it is asked for what it cannot do, such as going on after the end.
        let ended =
            !matches!(self.compress.compress_vec(bytes, &mut self.out, flush), Ok(Status::Ok | Status::BufError));
        let taken = usize::try_from(self.compress.total_in() - before).unwrap_or(bytes.len());
        (if ended { bytes.len() } else { taken }, ended)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    #[test]
    fn what_is_pushed_comes_back() {
        // Numbers that do not repeat, so that the output outgrows its first room.
        let mut state = 1_u32;
        let noise = std::iter::repeat_with(|| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        });
        let bytes: Vec<u8> = noise.take(300_000).collect();
        for pieces in [1, 7, 70_000, 300_000] {
            let mut stream = Stream::new(6);
            bytes.chunks(pieces).for_each(|piece| stream.push(piece));
            let mut back = Vec::new();
            flate2::read::ZlibDecoder::new(&*stream.finish()).read_to_end(&mut back).expect("a zlib stream");
            assert!(back == bytes, "in pieces of {pieces}");
        }
    }
}
