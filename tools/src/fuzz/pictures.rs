//! Pictures in, format by format.

use tactograph::Error;
use tactograph::internals::raster::decode::{DecodeOptions, Header, Limits, decode};
use tactograph::internals::units::Size;

/// Working pixels along the longer side: all of decoding, little of shrinking.
const LONGEST: u32 = 64;
/// As the program's own limits, but smaller, so that an input is done in milliseconds.
const LIMITS: Limits = Limits { megapixels: 1, memory_mb: 32 };

macro_rules! formats {
    ($($name:ident: $is:expr;)*) => {
        $(
            #[doc = concat!("Bytes that begin like a file of ", stringify!($name), ".")]
            pub(super) fn $name(bytes: &[u8]) {
                let is: fn(&[u8]) -> bool = $is;
                if is(bytes) {
                    decoded(bytes);
                }
            }
        )*
    };
}

// Bytes of other formats are left to their own targets.
formats! {
    png: |bytes| bytes.starts_with(b"\x89PNG");
    jpeg: |bytes| bytes.starts_with(b"\xff\xd8");
    webp: |bytes| bytes.starts_with(b"RIFF");
    tiff: |bytes| bytes.starts_with(b"II") || bytes.starts_with(b"MM");
    bmp: |bytes| bytes.starts_with(b"BM");
    gif: |bytes| bytes.starts_with(b"GIF");
    pnm: |bytes| bytes.starts_with(b"P");
    pdf: |bytes| bytes.starts_with(b"%PDF");
}

/// Any text, and what is packed by gzip.
pub(super) fn svg(bytes: &[u8]) {
    let is_other = [&b"\x89PNG"[..], b"\xff\xd8", b"RIFF", b"II", b"MM", b"BM", b"GIF", b"%PDF"];
    if !is_other.iter().any(|start| bytes.starts_with(start)) {
        decoded(bytes);
    }
}

fn decoded(bytes: &[u8]) {
    let working_size = |source: Header| -> Result<Size, Error> {
        let scale = (LONGEST as f32 / source.size.width.max(source.size.height) as f32).min(1.0);
        let side = |pixels: u32| ((pixels as f32 * scale) as u32).max(1);
        Ok(Size::new(side(source.size.width), side(source.size.height)))
    };
    let options =
        DecodeOptions { limits: LIMITS, keep_text: bytes.len() % 2 == 1, ..DecodeOptions::whole(&working_size) };
    match decode(bytes, &options) {
        Ok(picture) => {
            let size = picture.raster.size();
            assert!(size.width.max(size.height) <= LONGEST && size.area() > 0, "{size}");
            let is_light = |value: &f32| value.is_finite() && (-1e-3..=1.001).contains(value);
            let planes = picture.raster.planes();
            assert!(planes.as_ref().iter().all(|plane| plane.iter().all(is_light)), "samples that are no light");
        }
        Err(fault) => super::is_clear(&fault),
    }
}
