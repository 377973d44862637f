//! What a fingertip would feel of a page.

use crate::Error;
use crate::touch::{self, Ink, Report};

/// What a fingertip feels of a page's textures; made by [`feel`].
#[derive(Debug, Clone)]
pub struct Felt {
    ink: Ink,
    felt: touch::FeltCells,
    report: Report,
}

/// Feels the textures of a page with a fingertip of `finger` mm (0.3 to 2.5; 1.0 is usual). `page` is an SVG file as
/// [`Page::to_svg`](crate::Page::to_svg) writes it, or as somebody changed it in an editor.
///
/// The textures are blurred as by a fingertip, and then their direction is read. This is a model that compares
/// textures well; it does not replace a reader.
///
/// ```
/// use tactograph::{Options, Profile};
///
/// let options = Options::new(Profile::named("swell-a4")?);
/// let page = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page;
/// let felt = tactograph::feel(page.to_svg(), 1.0)?;
/// for class in &felt.report().classes {
///     let right = 100.0 * class.areas.right_of_judged();
///     println!("{}: {right:.0} % of what is judged is felt right", class.class.name());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::OtherFormat`], [`Error::NotASvgPage`] or [`Error::NoFigure`] if it is no such page,
/// [`Error::TooLargeToFeel`], or [`Error::NoSuchFinger`].
pub fn feel(page: impl AsRef<[u8]>, finger: f32) -> Result<Felt, Error> {
    let ink = Ink::of(svg_text(page.as_ref())?)?;
    let felt = ink.felt(finger)?;
    let report = touch::report(&ink, &felt);
    Ok(Felt { ink, felt, report })
}

impl Felt {
    /// The shares that are felt right, unclear and wrong, class by class. Its `Display` is a text of some sentences.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// A map as a PNG picture: each class that is felt has its pattern and its name, crosses stand where another class
    /// is felt than is meant, rings where it is unclear.
    ///
    /// # Errors
    /// [`Error::NoMemory`] if there is no memory for it.
    pub fn to_png(&self) -> Result<Vec<u8>, Error> {
        touch::map::png(&self.ink, &self.felt).ok_or(Error::NoMemory { what: "the map" })
    }
}

/// The text of an SVG; what is plainly something else is called by its name.
fn svg_text(page: &[u8]) -> Result<&str, Error> {
    const OTHERS: [(&[u8], &str); 6] = [
        (b"%PDF-", "a PDF"),
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"\xff\xd8\xff", "a JPEG picture"),
        (b"RIFF", "a WebP picture"),
        (b"GIF8", "a GIF picture"),
        (b"\x1f\x8b", "a file compressed with gzip"),
    ];
    if let Some((_, what)) = OTHERS.iter().find(|(magic, _)| page.starts_with(magic)) {
        return Err(Error::OtherFormat(what));
    }
    let text = std::str::from_utf8(page).map_err(|_| Error::OtherFormat("no text in UTF-8"))?;
    if text.trim_start_matches('\u{feff}').trim_start().starts_with('<') {
        Ok(text)
    } else {
        Err(Error::OtherFormat("no drawing in SVG"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_svg_is_called_by_its_name() {
        for (bytes, what) in [
            (&b"%PDF-1.7"[..], "a PDF"),
            (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
            (b"\xc3\x28", "no text"),
            (b"dots", "no drawing"),
        ] {
            let told = feel(bytes, 1.0).expect_err("it is no SVG").to_string();
            assert!(told.contains(what) && told.contains("SVG"), "{told}");
        }
    }
}
