//! Changes to inputs that keep most of their shape: random bytes seldom get past a parser.
//!
//! An input is one document, or two with a zero byte between them: JSON first, text after it.

use super::document::Json;

/// Random numbers (xorshift64*, Vigna 2016): the same seed gives the same inputs.
#[derive(Clone, Debug)]
pub struct Rng(u64);

impl Rng {
    /// A generator.
    pub fn new(seed: u64) -> Rng {
        Rng(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `n`; 0 for `n` = 0.
    pub fn below(&mut self, n: usize) -> usize {
        if n == 0 { 0 } else { (self.bits() >> 16) as usize % n }
    }

    /// True once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of them.
    pub fn one_of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }
}

/// Numbers at which readers stumble.
const NUMBERS: [&str; 24] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "7",
    "10",
    "100",
    "0.5",
    "1e-3",
    "1e-6",
    "1e-9",
    "1e-12",
    "1e-300",
    "5e-324",
    "1e3",
    "1e6",
    "1e12",
    "1e154",
    "1e300",
    "1.7976931348623157e308",
    "1e309",
    "0.1000000000000000055511151231257827",
];
/// Texts at which readers and writers stumble.
const TEXTS: [&str; 22] = [
    "",
    " ",
    "m",
    "1",
    "NaN",
    "-inf m",
    "1 m",
    "1,5 m",
    "0 mm",
    "<script>alert(1)</script>",
    "</title>\"'&amp;",
    "]]>",
    "{{ name }}",
    "{% raw %}",
    "\u{1b}[31m",
    "\u{9b}2J",
    "\u{202e}txt",
    "\u{0}",
    "\u{feff}",
    "a\nb\tc",
    "µ²√⅓ 𝄞",
    "1e400 GPa",
];

/// Changes an input in place, one to four times; it stays below `most` bytes.
pub fn mutate(data: &mut Vec<u8>, most: usize, rng: &mut Rng) {
    for _ in 0..=rng.below(4) {
        let middle = data.iter().position(|b| *b == 0);
        match middle {
            Some(at) if rng.once_in(2) => {
                let mut tail = data.split_off(at + 1);
                lines(&mut tail, rng);
                data.extend(tail);
            }
            _ => {
                let end = middle.unwrap_or(data.len());
                let tail = data.split_off(end);
                let json = data.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'{');
                if !(json && !rng.once_in(5) && document(data, rng)) {
                    lines(data, rng);
                }
                data.extend(tail);
            }
        }
    }
    data.truncate(most);
}

/// Changes a JSON document; false if the text is not one.
fn document(data: &mut Vec<u8>, rng: &mut Rng) -> bool {
    let Some(mut root) = std::str::from_utf8(data).ok().and_then(Json::parse) else { return false };
    for _ in 0..=rng.below(3) {
        let size = root.size();
        let other = root.nth(rng.below(size)).cloned().unwrap_or(Json::Null);
        if let Some(node) = root.nth(rng.below(size)) {
            change(node, other, rng);
        }
    }
    *data = root.print().into_bytes();
    true
}

fn change(node: &mut Json, other: Json, rng: &mut Rng) {
    if rng.once_in(12) {
        *node = if rng.once_in(3) { Json::Null } else { other };
        return;
    }
    match node {
        Json::Null => *node = other,
        Json::Bool(value) => *value = !*value,
        Json::Number(text) => *text = number(text, rng),
        Json::Text(text) => {
            // A quantity keeps its unit most of the time.
            let end = text.find(|c: char| !matches!(c, '0'..='9' | '.' | '-' | '+' | 'e' | 'E')).unwrap_or(text.len());
            *text = match rng.below(8) {
                0 => rng.one_of(&TEXTS).to_owned(),
                1 => match other {
                    Json::Text(other) => other,
                    _ => format!("{text}{text}"),
                },
                _ if end > 0 => format!("{}{}", number(&text[..end], rng), &text[end..]),
                _ => rng.one_of(&TEXTS).to_owned(),
            };
        }
        Json::List(items) => {
            let at = rng.below(items.len());
            match rng.below(5) {
                _ if items.is_empty() => items.push(other),
                0 => items.clear(),
                1 | 2 => drop(items.remove(at)),
                3 => items.insert(at, items[at].clone()),
                _ => items.push(other),
            }
        }
        Json::Object(members) => {
            let at = rng.below(members.len());
            match rng.below(5) {
                _ if members.is_empty() => members.push(("name".into(), other)),
                0 => members.push((rng.one_of(&TEXTS).to_owned(), other)),
                1 => members[at].0.push('s'),
                2 => members[at].1 = other,
                3 => members.reverse(),
                _ => drop(members.remove(at)),
            }
        }
    }
}

/// Another number: an awkward one, or near the old one.
fn number(text: &str, rng: &mut Rng) -> String {
    let Ok(value) = text.parse::<f64>() else { return rng.one_of(&NUMBERS).to_owned() };
    let factors = [-1.0, 0.1, 0.5, 0.9, 0.999_999, 1.000_001, 1.1, 2.0, 10.0, 1000.0];
    match rng.below(4) {
        0 => rng.one_of(&NUMBERS).to_owned(),
        1 => format!("{}", value.round()),
        _ => format!("{}", value * factors[rng.below(factors.len())]),
    }
}

/// Changes lines, numbers and bytes of a text.
fn lines(data: &mut Vec<u8>, rng: &mut Rng) {
    let line_at = |data: &[u8], rng: &mut Rng| {
        let middle = rng.below(data.len());
        let start = data[..middle].iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
        let end = data[middle..].iter().position(|b| *b == b'\n').map_or(data.len(), |i| middle + i + 1);
        start..end
    };
    match rng.below(9) {
        _ if data.is_empty() => data.extend_from_slice(rng.one_of(&NUMBERS).as_bytes()),
        0 => drop(data.drain(line_at(data, rng))),
        1 => {
            let line = data[line_at(data, rng)].to_vec();
            let at = line_at(data, rng).start;
            data.splice(at..at, line);
        }
        2..=4 => {
            // A number in place of a number.
            let middle = rng.below(data.len());
            let inside = |b: &u8| matches!(b, b'0'..=b'9' | b'.' | b'-' | b'+' | b'e' | b'E');
            let start = data[..middle].iter().rposition(|b| !inside(b)).map_or(0, |i| i + 1);
            let end = data[middle..].iter().position(|b| !inside(b)).map_or(data.len(), |i| middle + i);
            let old = String::from_utf8_lossy(&data[start..end]).into_owned();
            data.splice(start..end, number(&old, rng).into_bytes());
        }
        5 => {
            let at = rng.below(data.len());
            let put = rng.one_of(&[
                ",",
                ";",
                "\t",
                " ",
                "\r",
                "\n",
                "\"",
                "#",
                "E",
                "-",
                "NPTS=",
                "DT=",
                "UNITS OF G",
                "\u{1a}",
                "µ",
            ]);
            data.splice(at..at, put.bytes());
        }
        6 => {
            let at = rng.below(data.len());
            data[at] ^= 1 << rng.below(8);
        }
        7 => {
            let (a, b) = (rng.below(data.len()), rng.below(data.len().min(40)));
            data.drain(a..(a + b).min(data.len()));
        }
        _ => {
            let (from, to) = (rng.below(data.len()), rng.below(data.len()));
            let piece = data[from..(from + rng.below(200)).min(data.len())].to_vec();
            data.splice(to..to, piece);
        }
    }
}
