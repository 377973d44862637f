//! A reader of just those PDF files that the program writes: found by their table of contents, as a viewer does.

use std::collections::BTreeMap;
use std::io::Read;

/// A file taken apart.
pub(crate) struct Reader {
    /// Each object's text by its number; a stream's bytes are apart.
    pub objects: BTreeMap<u32, String>,
    /// Streams by the number of their object, unpacked.
    pub streams: BTreeMap<u32, Vec<u8>>,
    /// Where the table of contents begins: after everything that is shown.
    pub table: usize,
    pub trailer: String,
}

/// One mark of a content stream, in hundredths of a millimetre.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mark {
    Stroke { layers: Vec<String>, width: i64, points: Vec<[i64; 2]>, closed: bool },
    Fill { layers: Vec<String>, subpaths: Vec<Vec<[i64; 2]>> },
}

impl Mark {
    pub(crate) fn layer(&self) -> &str {
        let (Self::Stroke { layers, .. } | Self::Fill { layers, .. }) = self;
        layers.last().expect("every mark is in a layer")
    }
}

impl Reader {
    #[track_caller]
    pub(crate) fn new(bytes: &[u8]) -> Self {
        assert!(bytes.starts_with(b"%PDF-1.7\n") && bytes.ends_with(b"%%EOF"), "no PDF");
        let start = number_after(bytes, rfind(bytes, b"startxref\n") + 10);
        let table = &bytes[start..];
        assert!(table.starts_with(b"xref\n0 "), "no table of contents where the file says");
        let trailer_at = rfind(table, b"trailer");
        let trailer = String::from_utf8_lossy(&table[trailer_at..]).into_owned();
        let (mut objects, mut streams) = (BTreeMap::new(), BTreeMap::new());
        let entries = String::from_utf8_lossy(&table[..trailer_at]).into_owned();
        for (number, entry) in entries.lines().skip(2).enumerate().skip(1) {
            let offset: usize = entry[..10].parse().expect("ten digits");
            let head = format!("{number} 0 obj");
            assert!(bytes[offset..].starts_with(head.as_bytes()), "object {number} is not where the table says");
            let body = &bytes[offset + head.len()..];
            let end = find(body, b"endobj");
            if let Some(at) = body[..].windows(7).position(|w| w == b"stream\n").filter(|&at| at < end) {
                let dict = String::from_utf8_lossy(&body[..at]).into_owned();
                let length = number_after(dict.as_bytes(), find(dict.as_bytes(), b"/Length ") + 8);
                let raw = &body[at + 7..at + 7 + length];
                assert!(body[at + 7 + length..].starts_with(b"\nendstream"), "a stream of another length");
                let mut stream = Vec::new();
                if dict.contains("/FlateDecode") {
                    flate2::read::ZlibDecoder::new(raw).read_to_end(&mut stream).expect("zlib");
                } else {
                    stream.extend(raw);
                }
                objects.insert(number as u32, dict);
                streams.insert(number as u32, stream);
            } else {
                objects.insert(number as u32, String::from_utf8_lossy(&body[..end]).trim().into());
            }
        }
        Self { objects, streams, table: start, trailer }
    }

    /// The objects that have this in them.
    pub(crate) fn with(&self, what: &str) -> Vec<(u32, &str)> {
        self.objects.iter().filter(|(_, text)| text.contains(what)).map(|(&number, text)| (number, &**text)).collect()
    }

    /// The one object that has this in it.
    #[track_caller]
    pub(crate) fn only(&self, what: &str) -> &str {
        let [(_, text)] = self.with(what)[..] else { panic!("not one object with {what}") };
        text
    }

    /// The object that `key` of `dict` refers to.
    #[track_caller]
    pub(crate) fn follow(&self, dict: &str, key: &str) -> u32 {
        let at = dict.find(&format!("/{key} ")).unwrap_or_else(|| panic!("no {key} in {dict}"));
        number_after(dict.as_bytes(), at + key.len() + 2) as u32
    }

    /// The marks of a page, given by its dictionary, drawn as a viewer does it; what else is in the stream must be what is
    /// expected there.
    #[track_caller]
    pub(crate) fn marks(&self, page: &str) -> Vec<Mark> {
        let text = String::from_utf8(self.streams[&self.follow(page, "Contents")].clone()).expect("text");
        let text =
            without_words(&text).replace("( )Tj", " Tj").replace("<<", " << ").replace(">>", " >> ").replace('/', " /");
        let (mut operands, mut marks) = (Vec::<&str>::new(), Vec::new());
        let (mut open, mut width, mut colours) = (Vec::<Option<String>>::new(), 0, Vec::new());
        let mut subpaths: Vec<Vec<[i64; 2]>> = Vec::new();
        for word in text.split_ascii_whitespace() {
            let is_operator = word.starts_with(|c: char| c.is_ascii_alphabetic());
            if !is_operator {
                operands.push(word);
                continue;
            }
            let numbers =
                || operands.iter().map(|word| word.parse::<i64>().expect("a whole number")).collect::<Vec<_>>();
            let layers = || open.iter().flatten().cloned().collect::<Vec<_>>();
            match word {
                "cm" => assert_eq!(operands.len(), 6),
                "g" | "G" => colours.push(format!("{} {word}", operands.join(" "))),
                "J" | "j" => assert_eq!(operands, ["1"], "lines and corners are round"),
                "w" => width = numbers()[0],
                "BDC" => open.push(match operands[..] {
                    ["/OC", name] => Some(self.layer_name(page, name)),
                    ["/Figure", "<<", "/MCID", "0", ">>"] | ["/Span", "<<", ">>"] => None,
                    _ => panic!("marked content {operands:?}"),
                }),
                "EMC" => drop(open.pop().expect("EMC without BDC")),
                "m" => subpaths.push(vec![[numbers()[0], numbers()[1]]]),
                "l" => subpaths.last_mut().expect("m before l").push([numbers()[0], numbers()[1]]),
                "c" => subpaths.last_mut().expect("m before c").push([numbers()[4], numbers()[5]]),
                "h" => {}
                // of words that take no ink
                "q" | "Q" | "BT" | "ET" | "Tf" | "Tz" | "Tm" | "Tj" => {}
                "Tr" => assert_eq!(operands, ["3"], "words are not seen"),
                "S" | "s" => {
                    assert!(open[0].is_none(), "a mark outside the figure");
                    assert_eq!(subpaths.len(), 1, "one line a stroke");
                    let points = subpaths.pop().expect("one");
                    marks.push(Mark::Stroke { layers: layers(), width, points, closed: word == "s" });
                }
                "f" => {
                    assert!(open[0].is_none(), "a mark outside the figure");
                    marks.push(Mark::Fill { layers: layers(), subpaths: std::mem::take(&mut subpaths) });
                }
                _ => panic!("operator {word} was not expected"),
            }
            operands.clear();
        }
        assert!(open.is_empty() && subpaths.is_empty());
        assert_eq!(colours, ["0 g", "0 G"], "colours other than DeviceGray black, or set more than once");
        marks
    }

    /// The words that stand for marks on a page, given by its dictionary.
    #[track_caller]
    pub(crate) fn words(&self, page: &str) -> Vec<String> {
        let text = String::from_utf8(self.streams[&self.follow(page, "Contents")].clone()).expect("text");
        let spans = text.split("/Span").skip(1);
        spans.map(|span| string_of(span.split("BDC").next().expect("its properties"), "ActualText")).collect()
    }

    fn layer_name(&self, page: &str, name: &str) -> String {
        let layer = &self.objects[&self.follow(page, &name[1..])];
        assert!(layer.contains("/Type/OCG"), "{layer}");
        string_of(layer, "Name")
    }
}

/// A content stream without the words of its marks, which are no operators.
fn without_words(text: &str) -> String {
    let mut parts = text.split("/ActualText(");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once(')').expect("an end of the words").1)
}

/// What stands in brackets after a key, without the escapes of brackets and backslashes.
#[track_caller]
pub(crate) fn string_of(dict: &str, key: &str) -> String {
    let (_, rest) = dict.split_once(&format!("/{key}")).unwrap_or_else(|| panic!("no {key} in {dict}"));
    if let Some(hex) = rest.strip_prefix("<FEFF") {
        let digits = hex.split('>').next().expect("an end");
        let units = (0..digits.len()).step_by(4).map(|at| u16::from_str_radix(&digits[at..at + 4], 16).expect("hex"));
        return String::from_utf16(&units.collect::<Vec<_>>()).expect("UTF-16");
    }
    let (mut text, mut depth, mut escaped) = (String::new(), 0, false);
    for c in rest.chars() {
        match c {
            '\\' if !escaped => {
                escaped = true;
                continue;
            }
            '(' if !escaped => {
                depth += 1;
                if depth == 1 {
                    continue;
                }
            }
            ')' if !escaped => {
                depth -= 1;
                if depth == 0 {
                    return text;
                }
            }
            _ => {}
        }
        escaped = false;
        assert!(depth > 0, "no text after {key}: {rest:.40}");
        text.push(c);
    }
    panic!("no end of {key}")
}

#[track_caller]
fn find(bytes: &[u8], what: &[u8]) -> usize {
    bytes.windows(what.len()).position(|w| w == what).unwrap_or_else(|| panic!("no {}", String::from_utf8_lossy(what)))
}

#[track_caller]
fn rfind(bytes: &[u8], what: &[u8]) -> usize {
    bytes.windows(what.len()).rposition(|w| w == what).unwrap_or_else(|| panic!("no {}", String::from_utf8_lossy(what)))
}

#[track_caller]
fn number_after(bytes: &[u8], at: usize) -> usize {
    let digits: Vec<u8> = bytes[at..].iter().copied().take_while(u8::is_ascii_digit).collect();
    String::from_utf8(digits).expect("digits").parse().expect("a number")
}
