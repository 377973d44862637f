//! The format of a picture from its first bytes; the name of a file is not looked at.

/// The formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PictureFormat {
    Jpeg,
    Png,
    WebP,
    Tiff,
    Bmp,
    Gif,
    Pnm,
    Svg,
    #[cfg(feature = "pdf")]
    Pdf,
    /// Something compressed with gzip, as SVGZ drawings are.
    Gzip,
}

impl PictureFormat {
    /// Its name in messages.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Jpeg => "JPEG",
            Self::Png => "PNG",
            Self::WebP => "WebP",
            Self::Tiff => "TIFF",
            Self::Bmp => "BMP",
            Self::Gif => "GIF",
            Self::Pnm => "PNM",
            Self::Svg => "SVG",
            #[cfg(feature = "pdf")]
            Self::Pdf => "PDF",
            Self::Gzip => "SVGZ",
        }
    }
}

impl PictureFormat {
    /// Whether it is a format of documents, which have pages.
    pub(super) fn has_pages(self) -> bool {
        #[cfg(feature = "pdf")]
        return matches!(self, Self::Pdf);
        #[cfg(not(feature = "pdf"))]
        false
    }
}

/// The format, or what the bytes look like instead if that is known.
pub(super) fn format(bytes: &[u8]) -> Result<PictureFormat, Option<&'static str>> {
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    let at = |offset: usize, magic: &[u8]| bytes.get(offset..).is_some_and(|rest| rest.starts_with(magic));
    Ok(match () {
        () if starts(b"\xFF\xD8\xFF") => PictureFormat::Jpeg,
        () if starts(b"\x89PNG\r\n\x1A\n") => PictureFormat::Png,
        () if starts(b"RIFF") && at(8, b"WEBP") => PictureFormat::WebP,
        () if starts(b"II*\0") || starts(b"MM\0*") || starts(b"II+\0") || starts(b"MM\0+") => PictureFormat::Tiff,
        () if is_bmp(bytes) => PictureFormat::Bmp,
        () if starts(b"GIF87a") || starts(b"GIF89a") => PictureFormat::Gif,
        () if is_pnm(bytes) => PictureFormat::Pnm,
        () if starts(b"\x1F\x8B") => PictureFormat::Gzip,
        #[cfg(feature = "pdf")]
        () if is_pdf(bytes) => PictureFormat::Pdf,
        () => return root_element(bytes).map_or_else(|| Err(other(bytes)), |name| svg_or_not(&name)),
    })
}

/// "BM" alone proves nothing, since texts begin so as well. The size of the second header is one of a few.
fn is_bmp(bytes: &[u8]) -> bool {
    const HEADERS: [u8; 8] = [12, 16, 40, 52, 56, 64, 108, 124];
    bytes.starts_with(b"BM") && matches!(bytes.get(14..18), Some([size, 0, 0, 0]) if HEADERS.contains(size))
}

fn is_pnm(bytes: &[u8]) -> bool {
    let [b'P', kind @ b'1'..=b'7', rest @ ..] = bytes else { return false };
    let spaced = rest.first().is_some_and(|b| b.is_ascii_whitespace() || *b == b'#');
    let next = rest.trim_ascii_start().first();
    spaced && next.is_some_and(|b| b.is_ascii_digit() || *b == b'#' || (*kind == b'7' && b.is_ascii_uppercase()))
}

/// PDF documents may have other bytes before their header, such as those of a mail.
fn is_pdf(bytes: &[u8]) -> bool {
    find(bytes.get(..1024).unwrap_or(bytes), b"%PDF-").is_some()
}

/// The name of the first element of an XML or HTML text, without its prefix and in lower case.
fn root_element(bytes: &[u8]) -> Option<String> {
    // What a drawing program writes before its root element is shorter by far, comments and document type included.
    const FAR: usize = 64 * 1024;
    let head = bytes.get(..FAR).unwrap_or(bytes);
    let mut rest = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
    loop {
        rest = rest.strip_prefix(b"<")?;
        let closing: &[u8] = match rest {
            [b'?', ..] => b"?>",
            [b'!', b'-', b'-', ..] => b"-->",
            [b'!', ..] if rest.len() > 8 && rest[1..8].eq_ignore_ascii_case(b"doctype") => {
                if find(rest, b"[").is_some_and(|open| find(rest, b">").is_none_or(|end| open < end)) {
                    b"]>"
                } else if rest[8..].trim_ascii_start().get(..4).is_some_and(|n| n.eq_ignore_ascii_case(b"html")) {
                    return Some("html".into());
                } else {
                    b">"
                }
            }
            _ => break,
        };
        let end = find(rest, closing)? + closing.len();
        rest = rest[end..].trim_ascii_start();
    }
    let end = rest.iter().position(|b| !(b.is_ascii_alphanumeric() || b":_-.".contains(b)))?;
    let name = std::str::from_utf8(&rest[..end]).ok()?;
    let name = name.rsplit(':').next().unwrap_or(name).to_ascii_lowercase();
    name.starts_with(|c: char| c.is_ascii_alphabetic()).then_some(name)
}

fn find(text: &[u8], what: &[u8]) -> Option<usize> {
    text.windows(what.len()).position(|window| window == what)
}

fn svg_or_not(root: &str) -> Result<PictureFormat, Option<&'static str>> {
    match root {
        "svg" => Ok(PictureFormat::Svg),
        "html" | "head" | "body" => Err(Some("a web page (HTML)")),
        _ => Err(Some("an XML file that is no SVG drawing")),
    }
}

/// What else it may be, and what to do about it where that helps.
fn other(bytes: &[u8]) -> Option<&'static str> {
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    let brand = bytes.get(8..12).filter(|_| bytes.get(4..8) == Some(b"ftyp"));
    Some(match brand {
        Some(b"heic" | b"heix" | b"hevc" | b"heim" | b"heis" | b"mif1" | b"msf1") => "a HEIC photo: save it as JPEG",
        Some(b"avif" | b"avis") => "an AVIF picture: save it as JPEG or PNG",
        Some(b"crx ") => "a camera's raw file: save it as JPEG",
        Some(_) => "a film",
        None if is_pdf(bytes) => "a PDF: save the page as a picture",
        None if starts(b"%!PS") || starts(b"\xC5\xD0\xD3\xC6") => "PostScript: save it as SVG or PNG",
        None if starts(b"PK\x03\x04") => "a ZIP archive or an Office document: take the picture out of it",
        None if starts(b"\xD0\xCF\x11\xE0") => "an old Office document: take the picture out of it",
        None if starts(b"8BPS") => "a Photoshop file: save it as PNG",
        None if starts(b"gimp xcf") => "a GIMP file: export it as PNG",
        None if starts(b"\0\0\0\x0CJXL ") || starts(b"\xFF\x0A") => "a JPEG XL picture: save it as JPEG or PNG",
        None if starts(b"\0\0\0\x0CjP  ") => "a JPEG 2000 picture: save it as JPEG or PNG",
        None if starts(b"\0\0\x01\0") => "an icon (ICO): save it as PNG",
        None if is_text(bytes) => "text",
        None => return None,
    })
}

/// Text in UTF-8, or in UTF-16 with its mark, by its first kilobyte.
fn is_text(bytes: &[u8]) -> bool {
    let head = bytes.get(..1024).unwrap_or(bytes);
    let sound = match std::str::from_utf8(head) {
        Ok(_) => true,
        Err(fault) => fault.error_len().is_none() && head.len() < bytes.len(),
    };
    let has_control = head.iter().any(|b| b.is_ascii_control() && !b.is_ascii_whitespace());
    (sound && !has_control) || bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF")
}

#[cfg(test)]
mod tests;
