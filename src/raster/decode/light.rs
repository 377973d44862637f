//! Rows of a file's samples become rows of linear light, over white.

use std::sync::Arc;

use moxcms::Transform16BitExecutor;

use super::colour::{ColourKind, Matrix, Meaning, ToneTable, curve_table, srgb_table};
use crate::raster::planes::Planes;

/// How the samples of a pixel follow one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SampleLayout {
    /// What they mean; inks are 0 for none and the largest number for full.
    pub(super) kind: ColourKind,
    /// Whether opacity follows them (0 for clear, not multiplied into the colours).
    pub(super) alpha: bool,
    /// Their size and order of bytes.
    pub(super) depth: SampleDepth,
}

/// Size of a sample and its order of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SampleDepth {
    Eight,
    SixteenBigEndian,
    /// As this machine has it.
    SixteenNative,
}

impl SampleLayout {
    /// 8 bits, no opacity.
    pub(super) fn plain(kind: ColourKind) -> Self {
        Self { kind, alpha: false, depth: SampleDepth::Eight }
    }

    /// Samples of a pixel without opacity.
    fn colours(self) -> usize {
        match self.kind {
            ColourKind::Grey => 1,
            ColourKind::Rgb => 3,
            ColourKind::Cmyk => 4,
        }
    }

    fn channels(self) -> usize {
        self.colours() + usize::from(self.alpha)
    }

    /// Bytes for a row of `width` pixels.
    pub(super) fn row_bytes(self, width: u32) -> usize {
        let bytes = if self.depth == SampleDepth::Eight { 1 } else { 2 };
        width as usize * self.channels() * bytes
    }
}

/// One row in linear light, over white.
#[derive(Clone)]
pub(super) struct Light {
    pub(super) layout: SampleLayout,
    to_light: ToLight,
    /// To be applied to the working picture.
    pub(super) matrix: Option<Matrix>,
    /// The row as whole numbers, for samples of 16 bits.
    wide: Vec<u16>,
}

/// From samples to light, and the row that came last.
#[derive(Clone)]
enum ToLight {
    Grey { table: ToneTable, row: Vec<f32> },
    Colour { conversion: Conversion, row: [Vec<f32>; 3] },
}

#[derive(Clone)]
enum Conversion {
    /// A table for each channel.
    Tables([ToneTable; 3]),
    /// Inks by the plain formula: light passes where there is neither the colour nor black. The table takes the product
    /// of two 8-bit transparencies.
    Inks(ToneTable),
    /// moxcms, with its input and output, and the table of 16-bit sRGB.
    Transform { transform: Arc<Transform16BitExecutor>, from: Vec<u16>, to: Vec<u16>, table: ToneTable },
}

impl Light {
    pub(super) fn new(layout: SampleLayout, meaning: Meaning, width: u32) -> Self {
        let last = if layout.depth == SampleDepth::Eight { 255 } else { 65535 };
        let width = width as usize;
        let row = vec![0.0; width];
        let (to_light, matrix) = match layout.kind {
            ColourKind::Grey => (ToLight::Grey { table: grey_table(meaning, last), row }, None),
            kind => {
                let (conversion, matrix) = match (meaning, kind) {
                    (Meaning::Transform(transform), _) => {
                        let (from, to) = (vec![0; width * layout.colours()], vec![0; width * 3]);
                        (Conversion::Transform { transform, from, to, table: srgb_table(65535) }, None)
                    }
                    // Profiles of inks are never curves.
                    (_, ColourKind::Cmyk) => (Conversion::Inks(srgb_table(255 * 255)), None),
                    (Meaning::Srgb, _) => {
                        let table = srgb_table(last);
                        (Conversion::Tables([table.clone(), table.clone(), table]), None)
                    }
                    (Meaning::Curves(curves, matrix), _) => {
                        (Conversion::Tables(curves.as_ref().map(|curve| curve_table(curve, last)).as_colour()), matrix)
                    }
                };
                (ToLight::Colour { conversion, row: [row.clone(), row.clone(), row] }, matrix)
            }
        };
        Self { layout, to_light, matrix, wide: Vec::new() }
    }

    /// How many planes there are, as what stands for each.
    pub(super) fn planes(&self) -> Planes<()> {
        match self.to_light {
            ToLight::Grey { .. } => Planes::Grey(()),
            ToLight::Colour { .. } => Planes::Colour([(); 3]),
        }
    }

    /// The row that came last, plane by plane.
    pub(super) fn row(&self) -> &[Vec<f32>] {
        match &self.to_light {
            ToLight::Grey { row, .. } => std::slice::from_ref(row),
            ToLight::Colour { row, .. } => row,
        }
    }

    /// Takes a row of samples as the layout says.
    pub(super) fn take(&mut self, row: &[u8]) {
        match self.layout.depth {
            SampleDepth::Eight => self.to_light.take(self.layout, row),
            depth => {
                let number = if depth == SampleDepth::SixteenNative { u16::from_ne_bytes } else { u16::from_be_bytes };
                self.wide.clear();
                self.wide.extend(row.as_chunks().0.iter().map(|&bytes| number(bytes)));
                self.to_light.take(self.layout, &self.wide);
            }
        }
    }
}

/// Light for the samples 0..=`last` of a grey picture. One with a profile of colours is read by the curve of green;
/// those that are no curves are refused before ([`Meaning::from_profile`]).
fn grey_table(meaning: Meaning, last: u32) -> ToneTable {
    match meaning {
        Meaning::Curves(Planes::Grey(curve) | Planes::Colour([_, curve, _]), _) => curve_table(&curve, last),
        Meaning::Srgb | Meaning::Transform(_) => srgb_table(last),
    }
}

/// A sample as it stands in a file.
trait ChannelSample: Copy + PartialEq {
    const FULL: Self;
    fn index(self) -> usize;
    fn wide(self) -> u16;
}

impl ChannelSample for u8 {
    const FULL: Self = 255;
    fn index(self) -> usize {
        usize::from(self)
    }
    fn wide(self) -> u16 {
        u16::from(self) * 257
    }
}

impl ChannelSample for u16 {
    const FULL: Self = 65535;
    fn index(self) -> usize {
        usize::from(self)
    }
    fn wide(self) -> u16 {
        self
    }
}

impl ToLight {
    fn take<S: ChannelSample>(&mut self, layout: SampleLayout, samples: &[S]) {
        match self {
            Self::Grey { table, row } if layout.alpha => {
                for (out, [grey, opacity]) in row.iter_mut().zip(samples.as_chunks().0) {
                    *out = over_white(table[grey.index()], *opacity);
                }
            }
            Self::Grey { table, row } => {
                for (out, sample) in row.iter_mut().zip(samples) {
                    *out = table[sample.index()];
                }
            }
            Self::Colour { conversion, row } => conversion.take(layout, samples, row),
        }
    }
}

impl Conversion {
    fn take<S: ChannelSample>(&mut self, layout: SampleLayout, samples: &[S], [red, green, blue]: &mut [Vec<f32>; 3]) {
        let out = red.iter_mut().zip(green).zip(blue);
        match self {
            Self::Tables(tables) => {
                let [r, g, b] = tables.each_ref().map(|table| &**table);
                if layout.alpha {
                    for (((red, green), blue), pixel) in out.zip(samples.as_chunks::<4>().0) {
                        (*red, *green, *blue) = (r[pixel[0].index()], g[pixel[1].index()], b[pixel[2].index()]);
                        if pixel[3] != S::FULL {
                            [*red, *green, *blue] = [*red, *green, *blue].map(|light| over_white(light, pixel[3]));
                        }
                    }
                } else {
                    for (((red, green), blue), pixel) in out.zip(samples.as_chunks::<3>().0) {
                        (*red, *green, *blue) = (r[pixel[0].index()], g[pixel[1].index()], b[pixel[2].index()]);
                    }
                }
            }
            Self::Inks(table) => {
                // Pictures of inks have 8 bits; more are cut.
                let eight = |sample: S| 255 - usize::from(sample.wide() >> 8);
                for (((red, green), blue), pixel) in out.zip(samples.chunks_exact(layout.channels())) {
                    let black = eight(pixel[3]);
                    [*red, *green, *blue] = [0, 1, 2].map(|i| table[eight(pixel[i]) * black]);
                }
            }
            Self::Transform { transform, from, to, table } => {
                let (channels, colours) = (layout.channels(), layout.colours());
                for (from, pixel) in from.chunks_exact_mut(colours).zip(samples.chunks_exact(channels)) {
                    from.iter_mut().zip(pixel).for_each(|(from, sample)| *from = sample.wide());
                }
                // Cannot fail: both are as long as moxcms asks for.
                if transform.transform(from, to).is_err() {
                    to.fill(u16::MAX);
                }
                let out = out.zip(to.as_chunks::<3>().0).zip(samples.chunks_exact(channels));
                for ((((red, green), blue), to), pixel) in out {
                    [*red, *green, *blue] = to.map(|sample| table[sample.index()]);
                    if layout.alpha {
                        [*red, *green, *blue] = [*red, *green, *blue].map(|light| over_white(light, pixel[colours]));
                    }
                }
            }
        }
    }
}

/// Light of a pixel of some opacity on white paper.
fn over_white<S: ChannelSample>(light: f32, opacity: S) -> f32 {
    let opacity = opacity.index() as f32 / S::FULL.index() as f32;
    opacity * light + (1.0 - opacity)
}
