//! Tests of `sniff`.

use super::*;

#[test]
fn drawings_are_known_by_their_root_element() {
    for text in [
        "<svg/>",
        "\u{feff}  <?xml version='1.0'?>\n<!-- <html> -->\n<svg xmlns='x'>",
        "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://x/svg11.dtd'><svg >",
        "<!DOCTYPE svg [ <!ENTITY a '<b>'> ]><svg:svg width='1'>",
    ] {
        assert_eq!(format(text.as_bytes()), Ok(PictureFormat::Svg), "{text}");
    }
}

#[test]
fn other_files_are_named() {
    let german = "Grüße, ".repeat(300); // the first kilobyte ends within a letter
    let cases: [(&[u8], Option<&str>); 9] = [
        (b"Dear reader,\nhello", Some("text")),
        (b"BMW and others", Some("text")),
        (b"P4 is a name", Some("text")),
        (german.as_bytes(), Some("text")),
        (b"<!doctype html><html>", Some("a web page (HTML)")),
        (b"<gpx version='1'>", Some("an XML file that is no SVG drawing")),
        (b"\0\0\0\x18ftypheic", Some("a HEIC photo: save it as JPEG")),
        (b"\0\0\0\x18ftypavif", Some("an AVIF picture: save it as JPEG or PNG")),
        (b"\x00\x01\x02\x03", None),
    ];
    for (bytes, what) in cases {
        assert_eq!(format(bytes).err().flatten(), what, "{}", String::from_utf8_lossy(bytes));
    }
}

#[test]
fn documents_may_begin_late() {
    let late = [b"MIME-Version: 1.0\n\n".as_slice(), b"%PDF-1.4\n"].concat();
    for bytes in [b"%PDF-1.7".as_slice(), &late] {
        #[cfg(feature = "pdf")]
        assert_eq!(format(bytes), Ok(PictureFormat::Pdf));
        #[cfg(not(feature = "pdf"))]
        assert_eq!(format(bytes), Err(Some("a PDF: save the page as a picture")));
    }
    assert_eq!(format(&[&[b' '; 1024][..], b"%PDF-1.7"].concat()), Err(Some("text")));
}
