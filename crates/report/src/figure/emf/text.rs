//! Texts of a drawing: font, place, and the advance of each character, by which programs that lack the font keep the width.

use super::{Drawing, HUNDREDTHS, Looks, SCALE, TYPE, attribute, kind, units};

/// The font: its widths are those of [`WIDTHS`], as are those of Helvetica and Liberation Sans.
const FACE: &str = "Arial";

/// Advances of the characters from the blank to `~`, in thousandths of the font size.
#[rustfmt::skip]
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// Bold letters are wider by about this.
const BOLD: f64 = 1.06;

/// Advance of a character in units of the font size.
fn advance(c: char) -> f64 {
    let place = (c as u32).checked_sub(' ' as u32).and_then(|place| WIDTHS.get(place as usize));
    let thousandths = match (place, c) {
        (Some(width), _) => *width,
        (None, '\u{a0}' | '·' | '²' | '³') => 333,
        (None, '\u{202f}') => 200,
        (None, '−' | '×' | '≤' | '≥') => 584,
        (None, '°') => 400,
        (None, _) => 556,
    };
    f64::from(thousandths) / 1000.0
}

/// A piece of a text: what it says, how it looks, how far it is lowered.
struct Piece {
    text: String,
    looks: Looks,
    lowered: f64,
}

impl Piece {
    fn advance(&self, c: char) -> f64 {
        advance(c) * self.looks.font * if self.looks.bold { BOLD } else { 1.0 }
    }

    fn width(&self) -> f64 {
        self.text.chars().map(|c| self.advance(c)).sum()
    }
}

/// Draws a text; `inside`: what stands between its tags.
pub(super) fn draw(drawing: &mut Drawing, tag: &str, inside: &str) {
    let number = |name: &str| attribute(tag, name).and_then(|text| text.parse::<f64>().ok()).unwrap_or_default();
    let pieces = pieces(&Looks::of(tag), inside);
    let total: f64 = pieces.iter().map(Piece::width).sum();
    let share = match attribute(tag, "text-anchor") {
        Some("middle") => 0.5,
        Some("end") => 1.0,
        _ => 0.0,
    };
    // `rotate(−90 20 30)`, clockwise about the place of the text.
    let turned = attribute(tag, "transform").and_then(|text| text.strip_prefix("rotate("));
    let degrees: f64 = turned.and_then(|text| text.split(' ').next()?.parse().ok()).unwrap_or_default();
    let (sin, cos) = degrees.to_radians().sin_cos();
    let mut along = -share * total;
    for piece in pieces {
        let place = (number("x") + along * cos - piece.lowered * sin, number("y") + along * sin + piece.lowered * cos);
        along += piece.width();
        put(drawing, &piece, place, degrees);
    }
}

/// The pieces of a text: its own words, and those of each `tspan` with its looks.
fn pieces(looks: &Looks, inside: &str) -> Vec<Piece> {
    let mut found = Vec::new();
    let (mut own, mut lowered) = (looks.clone(), 0.0);
    for part in inside.split('<') {
        let text = match part.split_once('>') {
            Some((tag, text)) => {
                if tag.starts_with("tspan") {
                    lowered += attribute(tag, "dy").and_then(|text| text.parse::<f64>().ok()).unwrap_or_default();
                    let font = if tag.contains("font-size") { Looks::of(tag).font } else { looks.font };
                    own = Looks { font, ..looks.clone() };
                } else {
                    own = looks.clone();
                }
                text
            }
            None => part,
        };
        if !text.is_empty() {
            found.push(Piece { text: unescaped(text), looks: own.clone(), lowered });
        }
    }
    found
}

/// Text without the escapes of XML.
fn unescaped(text: &str) -> String {
    let known = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&apos;", "'"), ("&amp;", "&")];
    known.iter().fold(text.to_owned(), |text, (escape, sign)| text.replace(escape, sign))
}

fn put(drawing: &mut Drawing, piece: &Piece, (x, y): (f64, f64), degrees: f64) {
    let Some(colour) = piece.looks.fill else { return };
    drawing.object(TYPE, kind::CREATE_FONT, font(&piece.looks, degrees));
    drawing.record(kind::SET_TEXT_COLOUR, &[colour]);
    let letters: Vec<u16> = piece.text.encode_utf16().collect();
    let mut words: Vec<u32> = letters
        .chunks(2)
        .map(|pair| u32::from(pair[0]) | pair.get(1).map_or(0, |second| u32::from(*second) << 16))
        .collect();
    let string = 76_u32;
    let advances = string + 4 * words.len() as u32;
    for c in piece.text.chars() {
        words.push(units(piece.advance(c)).max(0) as u32);
        // The second half of a pair takes no room.
        words.extend((1..c.len_utf16()).map(|_| 0));
    }
    let scale = ((HUNDREDTHS / SCALE) as f32).to_bits();
    let place = [units(x) as u32, units(y) as u32];
    // Bounds that are not known, and a scale from units to hundredths of a millimetre.
    let mut content = vec![0, 0, u32::MAX, u32::MAX, 1, scale, scale, place[0], place[1], letters.len() as u32, string];
    content.extend([0, 0, 0, u32::MAX, u32::MAX, advances]);
    content.extend(words);
    drawing.record(kind::TEXT, &content);
}

/// A logical font of 320 bytes: height, angle, weight and face; all else is zero.
fn font(looks: &Looks, degrees: f64) -> Vec<u32> {
    let mut content = vec![0; 80];
    let angle = (-10.0 * degrees).round() as i32 as u32;
    content[0] = -units(looks.font) as u32;
    content[2] = angle;
    content[3] = angle;
    content[4] = if looks.bold { 700 } else { 400 };
    // The character set of the system, and quality as it likes: 0; the face begins at byte 28.
    for (i, letter) in FACE.encode_utf16().enumerate() {
        content[7 + i / 2] |= u32::from(letter) << (16 * (i % 2));
    }
    content
}

#[cfg(test)]
mod tests {
    use super::super::{emf, kind};

    /// Contents of the records of a kind.
    fn of(bytes: &[u8], wanted: u32) -> Vec<Vec<u32>> {
        let words: Vec<u32> = bytes.chunks(4).map(|w| u32::from_le_bytes([w[0], w[1], w[2], w[3]])).collect();
        let (mut at, mut found) = (0, Vec::new());
        while at < words.len() {
            let length = words[at + 1] as usize / 4;
            if words[at] == wanted {
                found.push(words[at + 2..at + length].to_vec());
            }
            at += length;
        }
        found
    }

    /// "ab" of size 10 is 11.12 wide: centred on 50 it begins at 44.4, each letter 5.56 wide.
    #[test]
    fn a_text_stands_where_it_is_anchored() {
        let svg = "<svg viewBox=\"0 0 100 50\"><text style=\"fill:#000;font-size:10px\" x=\"50\" y=\"20\" \
                   text-anchor=\"middle\">ab</text></svg>";
        let bytes = emf(svg);
        let text = &of(&bytes, kind::TEXT)[0];
        assert_eq!(text[7..11], [444, 200, 2, 76]);
        assert_eq!(text[16], 80);
        assert_eq!(text[17..], [u32::from(b'b') << 16 | u32::from(b'a'), 56, 56]);
        let font = &of(&bytes, kind::CREATE_FONT)[0];
        assert_eq!(font.len(), 81);
        assert_eq!(font[1] as i32, -100);
        assert_eq!((font[8], font[9], font[10]), (0x0072_0041, 0x0061_0069, 0x6c));
    }

    #[test]
    fn a_turned_text_is_turned_about_its_anchor() {
        let svg = "<svg viewBox=\"0 0 100 50\"><text style=\"font-size:10px\" x=\"50\" y=\"20\" text-anchor=\"end\" \
                   transform=\"rotate(-90 50 20)\">ab</text></svg>";
        let bytes = emf(svg);
        // Upwards: its start is 11.12 below its end.
        assert_eq!(of(&bytes, kind::TEXT)[0][7..9], [500, 311]);
        assert_eq!(of(&bytes, kind::CREATE_FONT)[0][3], 900);
    }

    #[test]
    fn escapes_and_subscripts_are_set() {
        let svg = "<svg viewBox=\"0 0 100 50\"><text x=\"0\" y=\"20\">T<tspan style=\"font-size:8.5px\" dy=\"2\">c</tspan><tspan \
                   dy=\"-2\"> &lt; 2</tspan></text></svg>";
        let bytes = emf(svg);
        let texts = of(&bytes, kind::TEXT);
        assert_eq!(texts.iter().map(|t| t[8]).collect::<Vec<_>>(), [200, 220, 200]);
        assert_eq!(texts[2][9], 4);
        assert_eq!(texts[2][17], u32::from(b'<') << 16 | u32::from(b' '));
        assert_eq!(of(&bytes, kind::CREATE_FONT).len(), 2);
    }
}
