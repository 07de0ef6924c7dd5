//! Mutants of bytes, of lines and tokens, of values in a tree, and of the chunks of a PNG.

use std::sync::LazyLock;

use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::corpus::{Form, Target};
use crate::publish::compiled_in;
use crate::torture::draw::Draw;

/// What is put into texts.
#[derive(Deserialize)]
struct Mutations {
    tokens: Vec<String>,
    units: Vec<String>,
}

static MUTATIONS: LazyLock<Mutations> =
    LazyLock::new(|| compiled_in(toml::from_str(include_str!("mutations.toml"))));

const LONGEST: usize = 200_000;

/// A text that readers stumble over, or a quantity.
fn token(draw: &mut Draw) -> &'static str {
    &MUTATIONS.tokens[draw.below(MUTATIONS.tokens.len())]
}

fn quantity(draw: &mut Draw) -> &'static str {
    &MUTATIONS.units[draw.below(MUTATIONS.units.len())]
}

/// Mutant `index` of a seed: the same bytes every time.
pub(super) fn of(target: &Target, seed: u64, index: usize) -> Vec<u8> {
    let own = seed
        .wrapping_mul(0x9E37_79B9_7F4A_7C15)
        .wrapping_add(index as u64);
    let mut draw = Draw::seeded(own);
    let choice = draw.below(64);
    let original = target.original(choice);
    let turns = 1 + draw.below(3);
    let mut bytes = if target.form == Form::Tree {
        tree(&original, turns, &mut draw)
    } else {
        let mut bytes = original;
        for _ in 0..turns {
            match (target.form, draw.below(3)) {
                (Form::Png, 0 | 1) => chunk(&mut bytes, &mut draw),
                (Form::Png | Form::Binary, _) | (_, 0) => raw(&mut bytes, &mut draw),
                _ => lines(&mut bytes, &mut draw),
            }
        }
        bytes
    };
    bytes.truncate(LONGEST);
    bytes
}

/// What is mutated, in the form of its mutants.
#[cfg(test)]
pub(super) fn unchanged(target: &Target, choice: usize) -> Vec<u8> {
    let original = target.original(choice);
    if target.form == Form::Tree {
        tree(&original, 0, &mut Draw::seeded(0))
    } else {
        original
    }
}

/// A place and a length within `bytes`.
fn span(bytes: &[u8], longest: usize, draw: &mut Draw) -> (usize, usize) {
    let start = draw.below(bytes.len());
    let end = (start + 1 + draw.below(longest)).min(bytes.len());
    (start, end)
}

fn raw(bytes: &mut Vec<u8>, draw: &mut Draw) {
    if bytes.is_empty() {
        return;
    }
    let (start, end) = span(bytes, 64, draw);
    match draw.below(7) {
        0 => bytes[start] ^= 1 << draw.below(8),
        1 => bytes[start] = draw.below(256) as u8,
        2 => drop(bytes.drain(start..end)),
        3 => bytes.truncate(start),
        4 => {
            let copy = bytes[start..end].to_vec();
            let place = draw.below(bytes.len());
            bytes.splice(place..place, copy);
        }
        5 => {
            let noise: Vec<u8> = (start..end).map(|_| draw.below(256) as u8).collect();
            bytes.splice(start..end, noise);
        }
        _ => {
            let fill = [0, 0xff, 0x7f, 0x80][draw.below(4)];
            bytes[start..end].fill(fill);
        }
    }
}

/// Mutates whole lines and the numbers and words in them.
fn lines(bytes: &mut Vec<u8>, draw: &mut Draw) {
    let text = String::from_utf8_lossy(bytes).into_owned();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    if lines.is_empty() {
        return;
    }
    let (here, there) = (draw.below(lines.len()), draw.below(lines.len()));
    match draw.below(8) {
        0 => drop(lines.remove(here)),
        1 => lines.swap(here, there),
        2 => {
            let copy = lines[here].clone();
            lines.insert(there, copy);
        }
        3 => {
            let copy = vec![lines[here].clone(); 1 + draw.below(2000)];
            lines.splice(here..here, copy);
        }
        4 => lines[here] += token(draw),
        _ => lines[here] = with_token(&lines[here], draw),
    }
    *bytes = (lines.join("\n") + "\n").into_bytes();
}

/// The line with one of its words or numbers replaced.
fn with_token(line: &str, draw: &mut Draw) -> String {
    let is_part = |letter: char| letter.is_alphanumeric() || "+-._".contains(letter);
    let mut tokens = Vec::new();
    let mut start = None;
    for (place, letter) in line.char_indices().chain([(line.len(), ' ')]) {
        match (is_part(letter), start) {
            (true, None) => start = Some(place),
            (false, Some(begin)) => {
                tokens.push((begin, place));
                start = None;
            }
            _ => {}
        }
    }
    if tokens.is_empty() {
        return line.to_owned() + token(draw);
    }
    let (begin, end) = tokens[draw.below(tokens.len())];
    let other = match draw.below(3) {
        0 => quantity(draw).to_owned(),
        1 => "9".repeat(1 + draw.below(400)),
        _ => token(draw).to_owned(),
    };
    format!("{}{other}{}", &line[..begin], &line[end..])
}

/// The file as JSON with values replaced, removed, doubled and nested.
fn tree(original: &[u8], turns: usize, draw: &mut Draw) -> Vec<u8> {
    let text = String::from_utf8_lossy(original);
    let mut root: Value = toml::from_str(&text).unwrap_or(Value::Null);
    for _ in 0..turns {
        let count = size(&root);
        let mut place = 1 + draw.below(count.saturating_sub(1));
        change(&mut root, &mut place, draw);
    }
    root.to_string().into_bytes()
}

fn size(value: &Value) -> usize {
    1 + match value {
        Value::Array(list) => list.iter().map(size).sum(),
        Value::Object(map) => map.values().map(size).sum(),
        _ => 0,
    }
}

/// Changes the value that is `place` values on, counted depth first.
fn change(value: &mut Value, place: &mut usize, draw: &mut Draw) {
    if *place == 0 {
        *value = other(value, draw);
        *place = usize::MAX;
        return;
    }
    *place -= 1;
    match value {
        Value::Array(list) => {
            for index in 0..list.len() {
                if *place == 0 && draw.below(3) == 0 {
                    let copy = list[index].clone();
                    list.insert(index, copy);
                    *place = usize::MAX;
                }
                if *place == usize::MAX {
                    return;
                }
                change(&mut list[index], place, draw);
            }
        }
        Value::Object(map) => {
            let keys: Vec<String> = map.keys().cloned().collect();
            for key in keys {
                if *place == 0 && draw.below(3) == 0 {
                    renamed(map, &key, draw);
                    *place = usize::MAX;
                }
                if *place == usize::MAX {
                    return;
                }
                if let Some(inner) = map.get_mut(&key) {
                    change(inner, place, draw);
                }
            }
        }
        _ => {}
    }
}

/// Removes a key, gives it another name, or another's value.
fn renamed(map: &mut Map<String, Value>, key: &str, draw: &mut Draw) {
    let keys: Vec<String> = map.keys().cloned().collect();
    match draw.below(3) {
        0 => drop(map.remove(key)),
        1 => {
            if let Some(value) = map.remove(key) {
                map.insert(format!("{key}{}", token(draw)), value);
            }
        }
        _ => {
            let from = &keys[draw.below(keys.len())];
            if let Some(value) = map.get(from).cloned() {
                map.insert(key.to_owned(), value);
            }
        }
    }
}

/// Another value in the place of one.
fn other(value: &Value, draw: &mut Draw) -> Value {
    match draw.below(12) {
        0 => Value::Null,
        1 => json!(true),
        2 => json!([]),
        3 => json!({}),
        4 => json!([value, value]),
        5 => json!({ "a": value }),
        6 => json!(quantity(draw)),
        7 => json!(token(draw)),
        8 => json!("x".repeat(draw.below(100_000))),
        9 => json!([0.0, -1.0, 1e308, 1e-308, 5e-324, 1e18, -1e18][draw.below(7)]),
        10 => json!([0, -1, i64::MAX, i64::MIN, 1 << 31, 1 << 53][draw.below(6)]),
        _ => (0..draw.below(200)).fold(value.clone(), |inner, _| json!([inner])),
    }
}

/// Changes a chunk of a PNG and mends its check value, so that the change is read.
fn chunk(bytes: &mut Vec<u8>, draw: &mut Draw) {
    let mut places = Vec::new();
    let mut place = 8;
    while let Some(length) = bytes.get(place..place + 4) {
        let length = u32::from_be_bytes([length[0], length[1], length[2], length[3]]) as usize;
        let end = place.saturating_add(12).saturating_add(length);
        if end > bytes.len() {
            break;
        }
        places.push((place, end));
        place = end;
    }
    if places.is_empty() {
        return raw(bytes, draw);
    }
    let (start, end) = places[draw.below(places.len())];
    if end - start > 12 {
        let byte = start + 8 + draw.below((end - start - 12).min(40));
        match draw.below(3) {
            0 => bytes[byte] ^= 1 << draw.below(8),
            1 => bytes[byte] = draw.below(256) as u8,
            _ => {
                let stop = (byte + 4).min(end - 4);
                bytes[byte..stop].fill([0, 0x7f, 0xff][draw.below(3)]);
            }
        }
    }
    let sum = check_value(&bytes[start + 4..end - 4]);
    bytes[end - 4..end].copy_from_slice(&sum.to_be_bytes());
}

/// CRC-32 of ISO 3309, as PNG has it.
fn check_value(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ (0xedb8_8320 * (sum & 1))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::torture::readers::corpus::TARGETS;

    #[test]
    fn mutants_are_the_same_every_time_and_differ() {
        for (seed, target) in (0_u64..).zip(&*TARGETS) {
            let first = of(target, seed, 0);
            assert_eq!(first, of(target, seed, 0), "{}", target.name);
            assert!((1..6).any(|index| of(target, seed, index) != first));
        }
    }
}
