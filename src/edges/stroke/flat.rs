//! Whether a picture is a drawing: how much of it is flat.

use pulp::Arch;

use crate::raster::Raster;
use crate::raster::lab;
use crate::units::Size;

/// A picture with more noise than this standard deviation of a pixel, in units of strength, is taken for a photograph.
const NOISY: f32 = 3.0;
/// Up to this noise pixels tell by themselves what is flat.
const QUIET_ENOUGH: f32 = 1.0;
/// With more noise squares of this side tell, px, whose means differ by no more than this from their neighbours', in
/// units of strength. Scans of worksheets with noise of 4 to 8 of 255 have shares of 0.80 to 0.87 of them, of 100
/// photographs (BSDS500, train and val) none more than 0.45.
const SQUARE: u32 = 4;
const FLAT_SQUARES: f32 = 1.2;
/// With lossy compression chroma has steps where light falls off across tinted paper, and where noise was in colour.
/// There squares also count as flat with this weight of chroma, if so many are of those without a stroke or a border:
/// a page may have any number of these. Of 104 drawings of school books with noise of 3 to 5 of 255 in every channel
/// and JPEG of quality 60 to 85, 96 have that share; 80 had it of all squares. Of 300 photographs of BSDS500 (train and
/// val) all but one, of birds in a clear sky (0.93), have at most 0.79.
const LOSSY_CHROMA: f32 = 0.5;
const LOSSY_SHARE: f32 = 0.8;
/// Squares that differ from a neighbour by more than this, in units of strength, have a stroke or a border.
const LINE: f32 = 8.0;
/// Two neighbouring pixels that differ by no more than this, in units of strength, are flat: a code value and a half.
const FLAT: f32 = 0.6;
/// With noise, two neighbouring pixels are flat that differ by no more than this many standard deviations of it.
const FLAT_NOISE: f32 = 3.0;
/// A picture is a drawing if at least this share of its pixels is flat. Drawings and scanned worksheets have 0.85 to
/// 0.99, photographs rarely more than 0.5.
const FLAT_SHARE: f32 = 0.7;
/// Whether a picture, perhaps one with lossy compression, is a drawing: mostly of flat areas. `noise` is the standard
/// deviation of a pixel.
pub(in crate::edges) fn is_drawing(raster: &Raster, noise: f32, lossy: bool) -> bool {
    let in_colour = Flatness { chroma: 1.0, share: FLAT_SHARE, line: f32::INFINITY };
    if noise <= QUIET_ENOUGH && is_flat(raster, FLAT.max(FLAT_NOISE * noise), in_colour) {
        return true;
    }
    // what a camera and a compression add goes where pixels are averaged, and the texture of a photograph stays
    let Some(squares) = (noise <= NOISY).then(|| shrunk_to_squares(raster)).flatten() else { return false };
    let is_flat = |flatness: Flatness| is_flat(&squares, FLAT_SQUARES, flatness);
    is_flat(in_colour) || lossy && is_flat(Flatness { chroma: LOSSY_CHROMA, share: LOSSY_SHARE, line: LINE })
}

/// Means of squares of [`SQUARE`] px; none of a picture that is too small for some.
pub(super) fn shrunk_to_squares(raster: &Raster) -> Option<Raster> {
    let size = Size::new(raster.size().width / SQUARE, raster.size().height / SQUARE);
    (size.width.min(size.height) >= 2).then(|| raster.shrunk(size))
}

/// When a picture counts as flat.
#[derive(Debug, Clone, Copy)]
struct Flatness {
    /// The weight of chroma.
    chroma: f32,
    /// Least share of pixels that are, of those that differ by no more than `line` from their neighbours.
    share: f32,
    line: f32,
}

/// Whether most neighbouring pixels differ by no more than a tolerance, in units of strength.
fn is_flat(raster: &Raster, tolerance: f32, Flatness { chroma, share, line }: Flatness) -> bool {
    let width = raster.size().width as usize;
    // every third row tells as much
    let rows = || (1..raster.size().height as usize).step_by(3);
    let all = rows().count() * (width - 1);
    let (mut flat, mut lines, mut left) = (0_usize, 0_usize, all);
    let mut lab = [(); 2].map(|()| vec![vec![0.0; width]; lab::planes(raster)]);
    for y in rows() {
        // the rest changes nothing
        let wanted = share * (all - lines) as f32;
        if flat as f32 >= wanted || ((flat + left) as f32) < wanted {
            break;
        }
        let [above, here] = &mut lab;
        lab::row(Arch::new(), raster, y - 1, above);
        lab::row(Arch::new(), raster, y, here);
        for x in 1..width {
            let planes = here.iter().zip(&*above).zip([1.0, chroma, chroma]);
            let step = planes
                .map(|((here, above), weight)| weight * (here[x] - here[x - 1]).abs().max((here[x] - above[x]).abs()));
            let step = step.fold(0.0, f32::max);
            flat += usize::from(step <= tolerance);
            lines += usize::from(step > line);
        }
        left -= width - 1;
    }
    flat as f32 >= share * (all - lines) as f32 && lines <= all / 2
}

#[cfg(test)]
mod tests;
