//! Arrays of numbers: as text, or bytes in base 64, plain or packed by zlib.
//!
//! Plain bytes stand behind their count. Packed ones are cut into blocks and stand behind the number of blocks, the size of a
//! block, that of the last one if it is smaller, and the packed size of each. Counts and sizes have 4 or 8 bytes.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use roxmltree::Node;

use crate::error::ReadError;
use crate::place::Place;

/// Why an array has no numbers.
pub(super) enum Refused {
    /// A way of writing that is not read.
    Encoding(&'static str),
    /// Something else than a number.
    Value(String),
    /// Bytes that are not as many as they say, or are no numbers.
    Damaged(&'static str),
}

impl Refused {
    pub(super) fn at(self, at: Place) -> ReadError {
        match self {
            Self::Encoding(what) => ReadError::Encoding { at, what },
            Self::Value(found) => ReadError::Value {
                at,
                what: "an array of numbers",
                found,
            },
            Self::Damaged(what) => ReadError::Damaged { at, what },
        }
    }
}

/// How the arrays of a file hold their bytes.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    is_big_endian: bool,
    /// Bytes of a count.
    count: usize,
    is_packed: bool,
}

impl Layout {
    /// What the root of the document says.
    pub(super) fn of(file: Node<'_, '_>) -> Result<Self, Refused> {
        let is_packed = match file.attribute("compressor") {
            None | Some("") => false,
            Some("vtkZLibDataCompressor") => true,
            Some(_) => {
                let what = "its arrays are packed by another way than zlib";
                return Err(Refused::Encoding(what));
            }
        };
        let is_big_endian = match file.attribute("byte_order") {
            None | Some("LittleEndian") => false,
            Some("BigEndian") => true,
            Some(_) => return Err(Refused::Encoding("its byte order is unknown")),
        };
        let count = match file.attribute("header_type") {
            None | Some("UInt32") => 4,
            Some("UInt64") => 8,
            Some(_) => return Err(Refused::Encoding("its header type is unknown")),
        };
        Ok(Self {
            is_big_endian,
            count,
            is_packed,
        })
    }
}

/// Numbers of an array.
pub(super) enum Array {
    Integers(Vec<i64>),
    Reals(Vec<f64>),
}

impl Array {
    pub(super) fn reals(self) -> Vec<f64> {
        match self {
            Self::Reals(values) => values,
            Self::Integers(values) => values.into_iter().map(|value| value as f64).collect(),
        }
    }
}

/// The type of the numbers of an array, and how many bytes each has.
#[derive(Clone, Copy)]
struct Type {
    is_real: bool,
    is_signed: bool,
    size: usize,
}

impl Type {
    fn of(name: &str) -> Option<Self> {
        let (family, bits) = name.split_at(name.find(|letter: char| letter.is_ascii_digit())?);
        let size = match bits {
            "8" => 1,
            "16" => 2,
            "32" => 4,
            "64" => 8,
            _ => return None,
        };
        let is_real = family == "Float" && size >= 4;
        let is_signed = family == "Int";
        (is_real || is_signed || family == "UInt").then_some(Self {
            is_real,
            is_signed,
            size,
        })
    }
}

/// Whether an array has integers.
pub(super) fn has_integers(node: Node<'_, '_>) -> bool {
    let own = node.attribute("type").and_then(Type::of);
    own.is_some_and(|own| !own.is_real)
}

/// Reads an array of at most `most` numbers.
pub(super) fn read(node: Node<'_, '_>, layout: Layout, most: usize) -> Result<Array, Refused> {
    let name = node.attribute("type").unwrap_or_default();
    let own = Type::of(name).ok_or_else(|| Refused::Value(format!("type=\"{name}\"")))?;
    let text = node.text().unwrap_or_default();
    match node.attribute("format").unwrap_or("ascii") {
        "ascii" => of_text(own, text),
        "binary" => of_bytes(own, layout, text, most),
        _ => Err(Refused::Encoding("its arrays stand behind the mesh")),
    }
}

fn of_text(own: Type, text: &str) -> Result<Array, Refused> {
    fn all<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, Refused> {
        let words = text.split_ascii_whitespace();
        let number = |word: &str| word.parse().map_err(|_| Refused::Value(shown(word)));
        words.map(number).collect()
    }
    Ok(if own.is_real {
        Array::Reals(all(text)?)
    } else {
        Array::Integers(all(text)?)
    })
}

fn of_bytes(own: Type, layout: Layout, text: &str, most: usize) -> Result<Array, Refused> {
    let bytes = decoded(text).ok_or(Refused::Damaged("it is not valid base 64"))?;
    let bytes = if layout.is_packed {
        unpacked(&bytes, layout, most.saturating_mul(own.size))?
    } else {
        let plain = plain(&bytes, layout).map(<[u8]>::to_vec);
        plain.ok_or(Refused::Damaged("it has fewer bytes than it states"))?
    };
    if bytes.len() % own.size != 0 {
        let what = "its bytes make no whole numbers";
        return Err(Refused::Damaged(what));
    }
    let words = bytes.chunks_exact(own.size);
    let bits = words.map(|word| bits(word, layout));
    if own.is_real {
        let real = |bits: u64| match own.size {
            4 => f64::from(f32::from_bits(bits as u32)),
            _ => f64::from_bits(bits),
        };
        return Ok(Array::Reals(bits.map(real).collect()));
    }
    let unused = 64 - 8 * own.size as u32;
    let integer = |bits: u64| {
        let shifted = bits << unused;
        if own.is_signed {
            return Ok(shifted.cast_signed() >> unused);
        }
        let value = shifted >> unused;
        i64::try_from(value).map_err(|_| Refused::Value(value.to_string()))
    };
    Ok(Array::Integers(
        bits.map(integer).collect::<Result<_, _>>()?,
    ))
}

/// The beginning of a text, for messages.
fn shown(text: &str) -> String {
    text.chars().take(20).collect()
}

/// Bytes of a text in base 64. The count before an array may be padded on its own.
fn decoded(text: &str) -> Option<Vec<u8>> {
    let text: String = text.split_ascii_whitespace().collect();
    let mut bytes = Vec::new();
    let mut rest = text.as_str();
    while !rest.is_empty() {
        let padded = rest.find('=').unwrap_or(rest.len());
        let padding = rest[padded..].bytes().take_while(|&byte| byte == b'=');
        let (part, others) = rest.split_at(padded + padding.count());
        STANDARD.decode_vec(part, &mut bytes).ok()?;
        rest = others;
    }
    Some(bytes)
}

/// The number that `word`, of at most 8 bytes, holds.
fn bits(word: &[u8], layout: Layout) -> u64 {
    let join = |bits: u64, &byte: &u8| bits << 8 | u64::from(byte);
    if layout.is_big_endian {
        word.iter().fold(0, join)
    } else {
        word.iter().rev().fold(0, join)
    }
}

/// The count at the beginning of `bytes`, and what follows.
fn count(bytes: &[u8], layout: Layout) -> Option<(usize, &[u8])> {
    let (word, rest) = bytes.split_at_checked(layout.count)?;
    Some((usize::try_from(bits(word, layout)).ok()?, rest))
}

fn plain(bytes: &[u8], layout: Layout) -> Option<&[u8]> {
    let (size, rest) = count(bytes, layout)?;
    rest.get(..size)
}

/// The bytes of blocks that are packed, at most `most`: a packed block may claim a thousand times its own size.
fn unpacked(bytes: &[u8], layout: Layout, most: usize) -> Result<Vec<u8>, Refused> {
    const SHORT: Refused = Refused::Damaged("it has fewer packed bytes than it states");
    let (blocks, rest) = count(bytes, layout).ok_or(SHORT)?;
    if blocks == 0 {
        return Ok(Vec::new());
    }
    let (size, rest) = count(rest, layout).ok_or(SHORT)?;
    let (last, rest) = count(rest, layout).ok_or(SHORT)?;
    let last = if last == 0 { size } else { last };
    let total = (blocks - 1)
        .checked_mul(size)
        .and_then(|full| full.checked_add(last));
    if last > size {
        let what = "its last block is larger than the others";
        return Err(Refused::Damaged(what));
    }
    if total.is_none_or(|total| total > most) {
        let what = "it unpacks to more numbers than the grid has points or cells for, or than a file of this length can hold";
        return Err(Refused::Damaged(what));
    }
    let sizes = blocks.checked_mul(layout.count).ok_or(SHORT)?;
    let (mut sizes, mut packed) = rest.split_at_checked(sizes).ok_or(SHORT)?;
    let mut found = Vec::new();
    for block in 1..=blocks {
        let (own, others) = count(sizes, layout).ok_or(SHORT)?;
        sizes = others;
        let (part, others) = packed.split_at_checked(own).ok_or(SHORT)?;
        packed = others;
        let expected = if block == blocks { last } else { size };
        let bytes = decompress_to_vec_zlib_with_limit(part, expected);
        let bytes = bytes.ok().filter(|bytes| bytes.len() == expected);
        let what = "a packed block does not unpack to its size";
        found.extend(bytes.ok_or(Refused::Damaged(what))?);
    }
    Ok(found)
}
