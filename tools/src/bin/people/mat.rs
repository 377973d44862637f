//! Reads the files in which the benchmark keeps what people outlined: MAT-files of level 5 (MathWorks, "MAT-File
//! Format"), as far as they use it: cells and structures of matrices of small whole numbers, compressed or not.

use std::io::Read;

use flate2::read::ZlibDecoder;

/// Types of data elements and classes of arrays, by their numbers in the format.
const INT8: u32 = 1;
const UINT8: u32 = 2;
const UINT16: u32 = 4;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
const CELL: u32 = 1;
const STRUCTURE: u32 = 2;
const OF_UINT8: u32 = 9;
const OF_UINT16: u32 = 11;
/// Bytes before the first element.
const HEADER: usize = 128;
/// Longest file that is read when unpacked, bytes.
const MOST: u64 = 100_000_000;

/// A value in a file.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Array {
    Cells(Vec<Array>),
    /// Of structures the fields of all, one after the other.
    Fields(Vec<(String, Array)>),
    Numbers(Matrix),
}

/// Whole numbers in rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Matrix {
    pub(super) width: usize,
    pub(super) height: usize,
    /// Row by row.
    pub(super) values: Vec<u16>,
}

/// The variables of a file.
///
/// # Errors
/// What in it is not as the format has it, or is none of what is read here.
pub(super) fn read(file: &[u8]) -> Result<Vec<Array>, String> {
    if file.get(HEADER - 2..HEADER) != Some(b"IM") {
        return Err("this is no MAT-file of level 5 in little-endian order".into());
    }
    let mut elements = Elements { bytes: &file[HEADER..] };
    let mut found = Vec::new();
    while let Some((kind, bytes)) = elements.next()? {
        match kind {
            COMPRESSED => {
                let mut unpacked = Vec::new();
                let packed = ZlibDecoder::new(bytes).take(MOST);
                { packed }.read_to_end(&mut unpacked).map_err(|error| error.to_string())?;
                found.extend(Elements { bytes: &unpacked }.array()?);
            }
            MATRIX => found.push(array(bytes)?),
            _ => {}
        }
    }
    Ok(found)
}

/// Elements one after the other, each with a tag.
struct Elements<'b> {
    bytes: &'b [u8],
}

impl<'b> Elements<'b> {
    /// Type and data of the next one.
    fn next(&mut self) -> Result<Option<(u32, &'b [u8])>, String> {
        if self.bytes.is_empty() {
            return Ok(None);
        }
        let cut = || "the file ends in the middle of an element".to_owned();
        let word = |at: usize| {
            let bytes = self.bytes.get(at..at + 4)?;
            Some(u32::from_le_bytes(bytes.try_into().ok()?))
        };
        let first = word(0).ok_or_else(cut)?;
        // up to four bytes stand in the tag itself
        let (kind, from, length, padded) = match first >> 16 {
            0 => {
                let length = word(4).ok_or_else(cut)? as usize;
                let padded = if first == COMPRESSED { length } else { length.next_multiple_of(8) };
                (first, 8, length, 8 + padded)
            }
            length => (first & 0xffff, 4, length as usize, 8),
        };
        let data = self.bytes.get(from..from + length).ok_or_else(cut)?;
        self.bytes = self.bytes.get(padded..).unwrap_or_default();
        Ok(Some((kind, data)))
    }

    /// The data of the next one, which there must be.
    fn data(&mut self) -> Result<(u32, &'b [u8]), String> {
        self.next()?.ok_or_else(|| "an element is missing".into())
    }

    /// The array in the next one, if there is one.
    fn array(&mut self) -> Result<Option<Array>, String> {
        match self.next()? {
            None => Ok(None),
            Some((MATRIX, bytes)) => array(bytes).map(Some),
            Some((kind, _)) => Err(format!("an element of type {kind} stands where an array should")),
        }
    }

    /// The array in the next one.
    fn an_array(&mut self) -> Result<Array, String> {
        self.array()?.ok_or_else(|| "an array is missing".into())
    }
}

/// The array in the data of a matrix element: its class, its dimensions, its name, and what it has.
fn array(bytes: &[u8]) -> Result<Array, String> {
    let mut parts = Elements { bytes };
    let class = u32::from(*parts.data()?.1.first().ok_or("an array without a class")?);
    let sides: Vec<usize> = whole(parts.data()?.1).collect();
    let count: usize = sides.iter().product();
    let _name = parts.data()?;
    match class {
        CELL => (0..count).map(|_| parts.an_array()).collect::<Result<_, _>>().map(Array::Cells),
        STRUCTURE => {
            let longest = whole(parts.data()?.1).next().filter(|longest| *longest > 0).ok_or("fields without names")?;
            let (_, names) = parts.data()?;
            let name = |bytes: &[u8]| {
                let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
                String::from_utf8_lossy(&bytes[..end]).into_owned()
            };
            let names: Vec<String> = names.chunks(longest).map(name).collect();
            let fields = (0..count).flat_map(|_| &names).map(|name| Ok((name.clone(), parts.an_array()?)));
            fields.collect::<Result<_, String>>().map(Array::Fields)
        }
        OF_UINT8 | OF_UINT16 => {
            let [height, width] = sides[..] else { return Err("a matrix of other than two dimensions".into()) };
            let (kind, data) = parts.data()?;
            let columns: Vec<u16> = match kind {
                INT8 | UINT8 => data.iter().map(|byte| u16::from(*byte)).collect(),
                UINT16 => data.chunks_exact(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect(),
                _ => return Err(format!("numbers of type {kind}")),
            };
            if columns.len() != width * height {
                return Err(format!("{} numbers in a matrix of {height} x {width}", columns.len()));
            }
            let values = (0..height).flat_map(|y| (0..width).map(move |x| x * height + y)).map(|at| columns[at]);
            Ok(Array::Numbers(Matrix { width, height, values: values.collect() }))
        }
        _ => Err(format!("an array of class {class}")),
    }
}

/// The whole numbers of four bytes in an element.
fn whole(bytes: &[u8]) -> impl Iterator<Item = usize> {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn element(kind: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = [kind.to_le_bytes(), (data.len() as u32).to_le_bytes()].concat();
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    }

    /// A matrix of bytes, two high and three wide, given column by column; its numbers in an element or in its tag.
    fn matrix(columns: &[u8], in_tag: bool) -> Vec<u8> {
        let numbers = if in_tag {
            let tag = UINT8 | (columns.len() as u32) << 16;
            [&tag.to_le_bytes()[..], columns].concat()
        } else {
            element(UINT8, columns)
        };
        let sides = [(columns.len() / 3).to_le_bytes()[..4].to_vec(), 3_u32.to_le_bytes().to_vec()].concat();
        let parts = [element(6, &[OF_UINT8 as u8, 0, 0, 0, 0, 0, 0, 0]), element(5, &sides), element(1, b""), numbers];
        element(MATRIX, &parts.concat())
    }

    fn file(elements: &[u8]) -> Vec<u8> {
        let mut bytes = vec![0; HEADER];
        bytes[HEADER - 2..].copy_from_slice(b"IM");
        [&bytes, elements].concat()
    }

    #[test]
    fn columns_become_rows() {
        let all = read(&file(&matrix(&[1, 2, 3, 4, 5, 6], false))).expect("a file");
        let [Array::Numbers(found)] = &all[..] else { panic!("{all:?}") };
        assert_eq!((found.width, found.height, &found.values[..]), (3, 2, &[1, 3, 5, 2, 4, 6][..]));
    }

    #[test]
    fn short_elements_stand_in_their_tag() {
        let found = read(&file(&matrix(&[7, 8, 9], true))).expect("a file");
        assert_eq!(found, [Array::Numbers(Matrix { width: 3, height: 1, values: vec![7, 8, 9] })]);
    }

    #[test]
    fn what_is_cut_or_of_another_kind_is_refused() {
        let whole = file(&matrix(&[1, 2, 3, 4, 5, 6], false));
        for length in HEADER + 1..whole.len() {
            assert!(read(&whole[..length]).is_err(), "{length} bytes");
        }
        assert!(read(b"no file").is_err());
    }
}
