//! Figures as Enhanced Metafiles: vector drawings that Word, LibreOffice and PowerPoint show without further programs.
//!
//! Records are those of [MS-EMF], "Enhanced Metafile Format". A record is its kind, its length in bytes and its content, all little-endian.
//! The drawing is the plain SVG of [`super::plain`]: paths, rectangles, circles and texts with their looks as properties. What a metafile does
//! not have is set as near to it as it can: a translucent area in the colour that it has on white paper, halos of texts not at all.
//!
//! [MS-EMF]: https://learn.microsoft.com/openspecs/windows_protocols/ms-emf/

use std::collections::BTreeMap;

use super::plain::attribute;

mod path;
mod text;

/// Units of the metafile in a user unit of the drawing.
const SCALE: f64 = 10.0;
/// Hundredths of a millimetre in a user unit: 720 of them are 16 cm.
const HUNDREDTHS: f64 = 16_000.0 / super::WIDE;
/// Size of the reference device in its dots, one a unit.
const DOTS: u32 = 32_000;
/// Font size where a text has none [user units].
const FONT: f64 = 11.0;

/// Kinds of records.
mod kind {
    pub(super) const HEADER: u32 = 1;
    pub(super) const SET_WINDOW_EXTENT: u32 = 9;
    pub(super) const SET_WINDOW_ORIGIN: u32 = 10;
    pub(super) const SET_VIEWPORT_EXTENT: u32 = 11;
    pub(super) const SET_VIEWPORT_ORIGIN: u32 = 12;
    pub(super) const END: u32 = 14;
    pub(super) const SET_MAP_MODE: u32 = 17;
    pub(super) const SET_BACKGROUND_MODE: u32 = 18;
    pub(super) const SET_FILL_MODE: u32 = 19;
    pub(super) const SET_TEXT_ALIGN: u32 = 22;
    pub(super) const SET_TEXT_COLOUR: u32 = 24;
    pub(super) const SELECT_OBJECT: u32 = 37;
    pub(super) const CREATE_BRUSH: u32 = 39;
    pub(super) const ELLIPSE: u32 = 42;
    pub(super) const CREATE_FONT: u32 = 82;
    pub(super) const TEXT: u32 = 84;
    pub(super) const POLYLINE: u32 = 87;
    pub(super) const POLYGONS: u32 = 91;
    pub(super) const CREATE_PEN: u32 = 95;
}

/// Objects that need not be created: nothing to fill with, nothing to draw with.
const NO_BRUSH: u32 = 0x8000_0005;
const NO_PEN: u32 = 0x8000_0008;
/// A geometric pen with flat ends and round corners; solid or dashed.
const SOLID: u32 = 0x0001_0200;
const DASHED: u32 = SOLID | 7;

/// The metafile of a drawing in plain SVG.
pub fn emf(svg: &str) -> Vec<u8> {
    let size: Vec<f64> = svg
        .split_once("viewBox=\"")
        .map_or("", |(_, after)| after.split('"').next().unwrap_or_default())
        .split(' ')
        .filter_map(|number| number.parse().ok())
        .collect();
    let (width, height) = match size.as_slice() {
        [_, _, width, height] => (*width, *height),
        _ => (1.0, 1.0),
    };
    let mut drawing = Drawing::new(width, height);
    let mut rest = svg;
    while let Some((_, after)) = rest.split_once('<') {
        let Some((tag, after)) = after.split_once('>') else { break };
        rest = after;
        let number = |name: &str| attribute(tag, name).and_then(|text| text.parse::<f64>().ok()).unwrap_or_default();
        match tag.split([' ', '/']).next().unwrap_or_default() {
            "path" => drawing.shape(&path::of(attribute(tag, "d").unwrap_or_default()), &Looks::of(tag)),
            "rect" => {
                let (x, y) = (number("x"), number("y"));
                let (right, low) = (x + number("width"), y + number("height"));
                let corners = vec![(x, y), (right, y), (right, low), (x, low)];
                drawing.shape(&[path::Line { points: corners, closed: true }], &Looks::of(tag));
            }
            "circle" => drawing.circle((number("cx"), number("cy")), number("r"), &Looks::of(tag)),
            "text" => {
                let (inside, after) = rest.split_once("</text>").unwrap_or((rest, ""));
                rest = after;
                text::draw(&mut drawing, tag, inside);
            }
            _ => {}
        }
    }
    drawing.finish()
}

/// How an element looks.
#[derive(Clone, Debug, PartialEq)]
struct Looks {
    fill: Option<u32>,
    stroke: Option<u32>,
    width: f64,
    dashes: Vec<f64>,
    font: f64,
    bold: bool,
}

impl Looks {
    /// Those of an element, by its property `style`.
    fn of(tag: &str) -> Looks {
        let style = attribute(tag, "style").unwrap_or_default();
        let given: BTreeMap<&str, &str> = style
            .split(';')
            .filter_map(|d| d.split_once(':'))
            .map(|(name, value)| (name.trim(), value.trim()))
            .collect();
        let number = |name: &str| -> Option<f64> { given.get(name)?.trim_end_matches("px").parse().ok() };
        let colour = |name: &str, none: Option<u32>| match given.get(name) {
            Some(text) => colour(text, number(&format!("{name}-opacity")).unwrap_or(1.0)),
            None => none,
        };
        Looks {
            fill: colour("fill", Some(0)),
            stroke: colour("stroke", None),
            width: number("stroke-width").unwrap_or(1.0),
            dashes: (given.get("stroke-dasharray").unwrap_or(&"none").split([' ', ',']))
                .filter_map(|length| length.parse().ok())
                .collect(),
            font: number("font-size").unwrap_or(FONT),
            bold: number("font-weight").is_some_and(|weight| weight >= 600.0),
        }
    }
}

/// `#rrggbb` or `#rgb` on white paper as 0x00bbggrr; `None` of anything else.
fn colour(text: &str, opacity: f64) -> Option<u32> {
    let digits = text.strip_prefix('#')?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    let parts = match digits.len() {
        3 => [value >> 8 & 15, value >> 4 & 15, value & 15].map(|part| 17 * part),
        6 => [value >> 16 & 255, value >> 8 & 255, value & 255],
        _ => return None,
    };
    let on_white = |part: u32| (255.0 - (255.0 - f64::from(part)) * opacity.clamp(0.0, 1.0)).round() as u32;
    let [red, green, blue] = parts.map(on_white);
    Some(blue << 16 | green << 8 | red)
}

/// A length in units of the metafile.
fn units(length: f64) -> i32 {
    (SCALE * length).round() as i32
}

/// A metafile under construction.
struct Drawing {
    bytes: Vec<u8>,
    records: u32,
    size: (f64, f64),
    /// Objects by the content that made them; the number of the first is 1.
    objects: BTreeMap<(u32, Vec<u32>), u32>,
    /// Selected pen, brush and font.
    selected: [u32; 3],
}

/// Places among the selected objects.
const PEN: usize = 0;
const BRUSH: usize = 1;
const TYPE: usize = 2;

/// Length of the header [bytes].
const HEADER: usize = 88;

impl Drawing {
    fn new(width: f64, height: f64) -> Drawing {
        let size = (width, height);
        let bytes = vec![0; HEADER];
        let mut drawing = Drawing { bytes, records: 1, size, objects: BTreeMap::new(), selected: [0; 3] };
        let extent = [units(width), units(height)].map(|length| length.max(1) as u32);
        drawing.record(kind::SET_MAP_MODE, &[8]);
        drawing.record(kind::SET_WINDOW_ORIGIN, &[0, 0]);
        drawing.record(kind::SET_WINDOW_EXTENT, &extent);
        drawing.record(kind::SET_VIEWPORT_ORIGIN, &[0, 0]);
        drawing.record(kind::SET_VIEWPORT_EXTENT, &extent);
        drawing.record(kind::SET_BACKGROUND_MODE, &[1]);
        drawing.record(kind::SET_FILL_MODE, &[2]);
        // From the left, on the baseline.
        drawing.record(kind::SET_TEXT_ALIGN, &[24]);
        drawing
    }

    fn record(&mut self, kind: u32, content: &[u32]) {
        let length = 8 + 4 * content.len() as u32;
        for word in [kind, length].iter().chain(content) {
            self.bytes.extend(word.to_le_bytes());
        }
        self.records += 1;
    }

    /// Selects an object, which is created where it does not exist yet.
    fn object(&mut self, place: usize, kind: u32, content: Vec<u32>) {
        let next = self.objects.len() as u32 + 1;
        let number = *self.objects.entry((kind, content.clone())).or_insert(next);
        if number == next {
            self.record(kind, &[&[number][..], &content].concat());
        }
        self.select(place, number);
    }

    fn select(&mut self, place: usize, number: u32) {
        if self.selected[place] != number {
            self.selected[place] = number;
            self.record(kind::SELECT_OBJECT, &[number]);
        }
    }

    fn pen(&mut self, looks: &Looks) {
        let Some(colour) = looks.stroke.filter(|_| looks.width > 0.0) else { return self.select(PEN, NO_PEN) };
        let lengths: Vec<u32> = looks.dashes.iter().map(|length| units(*length).max(1) as u32).collect();
        let style = if lengths.is_empty() { SOLID } else { DASHED };
        let width = units(looks.width).max(1) as u32;
        // No bitmap; a solid brush.
        let mut content = vec![0, 0, 0, 0, style, width, 0, colour, 0, lengths.len() as u32];
        content.extend(lengths);
        self.object(PEN, kind::CREATE_PEN, content);
    }

    fn brush(&mut self, fill: Option<u32>) {
        match fill {
            Some(colour) => self.object(BRUSH, kind::CREATE_BRUSH, vec![0, colour, 0]),
            None => self.select(BRUSH, NO_BRUSH),
        }
    }

    /// Lines, and the areas within them.
    fn shape(&mut self, lines: &[path::Line], looks: &Looks) {
        let closed: Vec<&path::Line> = lines.iter().filter(|line| line.closed || looks.fill.is_some()).collect();
        if !closed.is_empty() && (looks.fill.is_some() || looks.stroke.is_some()) {
            self.brush(looks.fill);
            match closed.iter().all(|line| line.closed) {
                true => self.pen(looks),
                false => self.select(PEN, NO_PEN),
            }
            let total: usize = closed.iter().map(|line| line.points.len()).sum();
            let mut content = bounds(closed.iter().flat_map(|line| &line.points));
            content.extend([closed.len() as u32, total as u32]);
            content.extend(closed.iter().map(|line| line.points.len() as u32));
            content.extend(closed.iter().flat_map(|line| &line.points).map(point));
            self.record(kind::POLYGONS, &content);
        }
        for line in lines.iter().filter(|line| !line.closed && looks.stroke.is_some()) {
            self.pen(looks);
            let mut content = bounds(&line.points);
            content.push(line.points.len() as u32);
            content.extend(line.points.iter().map(point));
            self.record(kind::POLYLINE, &content);
        }
    }

    fn circle(&mut self, (x, y): (f64, f64), radius: f64, looks: &Looks) {
        self.brush(looks.fill);
        self.pen(looks);
        let sides = [x - radius, y - radius, x + radius, y + radius];
        self.record(kind::ELLIPSE, &sides.map(|side| units(side) as u32));
    }

    /// Closes the file: its end, and the header that counts what is in it.
    fn finish(mut self) -> Vec<u8> {
        self.record(kind::END, &[0, 16, 20]);
        let (width, height) = self.size;
        let last = |length: f64| (units(length) - 1).max(1) as u32;
        let frame = |length: f64| (HUNDREDTHS * length).round().max(1.0) as u32;
        let millimetres = (f64::from(DOTS) * HUNDREDTHS / SCALE / 100.0).round() as u32;
        let handles = self.objects.len() as u32 + 1;
        let header = [
            kind::HEADER,
            HEADER as u32,
            0,
            0,
            last(width),
            last(height),
            0,
            0,
            frame(width),
            frame(height),
            u32::from_le_bytes(*b" EMF"),
            0x0001_0000,
            self.bytes.len() as u32,
            self.records,
            handles,
            0,
            0,
            0,
            DOTS,
            DOTS,
            millimetres,
            millimetres,
        ];
        for (place, word) in header.into_iter().enumerate() {
            self.bytes[4 * place..4 * place + 4].copy_from_slice(&word.to_le_bytes());
        }
        self.bytes
    }
}

/// The rectangle around points.
fn bounds<'a>(points: impl IntoIterator<Item = &'a (f64, f64)>) -> Vec<u32> {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    let around = points
        .into_iter()
        .fold(start, |[left, top, right, low], (x, y)| [left.min(*x), top.min(*y), right.max(*x), low.max(*y)]);
    around.map(|side| units(side) as u32).to_vec()
}

/// A point in two halves of a word.
fn point((x, y): &(f64, f64)) -> u32 {
    let half = |length: f64| u32::from(units(length).clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16 as u16);
    half(*y) << 16 | half(*x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Records: kind and content.
    fn records(bytes: &[u8]) -> Vec<(u32, Vec<u32>)> {
        let words: Vec<u32> = bytes.chunks(4).map(|w| u32::from_le_bytes([w[0], w[1], w[2], w[3]])).collect();
        let (mut at, mut found) = (0, Vec::new());
        while at < words.len() {
            let length = words[at + 1] as usize / 4;
            found.push((words[at], words[at + 2..at + length].to_vec()));
            at += length;
        }
        found
    }

    fn drawn(inside: &str) -> Vec<(u32, Vec<u32>)> {
        records(&emf(&format!("<svg viewBox=\"0 0 100 50\">{inside}</svg>")))
    }

    /// Signature, lengths, counts and frame, as the specification has them (2.3.4.2).
    #[test]
    fn the_header_counts_the_file() {
        let bytes = emf("<svg viewBox=\"0 0 720 100\"><path style=\"stroke:#000;fill:none\" d=\"M0 0L10 10\"/></svg>");
        assert_eq!(&bytes[40..44], b" EMF");
        let found = records(&bytes);
        let header = &found[0].1;
        // A frame of 16 cm in hundredths of a millimetre.
        assert_eq!(header[4..8], [0, 0, 16_000, 2_222]);
        assert_eq!(header[10] as usize, bytes.len());
        assert_eq!(header[11] as usize, found.len());
        // The pen, and the number 0.
        assert_eq!(header[12], 2);
        assert_eq!(found.last(), Some(&(kind::END, vec![0, 16, 20])));
    }

    #[test]
    fn lines_have_their_pen_and_areas_their_brush() {
        let found = drawn(
            "<path style=\"fill:none;stroke:#123;stroke-width:2;stroke-dasharray:8 3\" d=\"M1 2L3 4\"/><rect \
             style=\"fill:#ff0000;fill-opacity:.5\" x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>",
        );
        let of = |kind: u32| -> Vec<&Vec<u32>> { found.iter().filter(|r| r.0 == kind).map(|r| &r.1).collect() };
        assert_eq!(of(kind::CREATE_PEN), [&vec![1, 0, 0, 0, 0, DASHED, 20, 0, 0x0033_2211, 0, 2, 80, 30]]);
        assert_eq!(of(kind::POLYLINE), [&vec![10, 20, 30, 40, 2, 20 << 16 | 10, 40 << 16 | 30]]);
        assert_eq!(of(kind::CREATE_BRUSH), [&vec![2, 0, 0x0080_80ff, 0]]);
        assert_eq!(of(kind::POLYGONS)[0][..7], [10, 20, 40, 60, 1, 4, 4]);
        // The rectangle has no outline.
        assert!(of(kind::SELECT_OBJECT).contains(&&vec![NO_PEN]));
    }

    #[test]
    fn a_look_that_comes_back_is_not_made_twice() {
        let line = "<path style=\"fill:none;stroke:#000\" d=\"M0 0L1 1\"/>";
        let other = "<path style=\"fill:none;stroke:#fff\" d=\"M0 0L1 1\"/>";
        let found = drawn(&[line, other, line].concat());
        assert_eq!(found.iter().filter(|r| r.0 == kind::CREATE_PEN).count(), 2);
        assert_eq!(found.iter().filter(|r| r.0 == kind::SELECT_OBJECT).count(), 3);
    }

    #[test]
    fn what_is_no_drawing_is_an_empty_metafile() {
        for text in
            ["", "<svg>", "<svg viewBox=\"0 0\"><path d=\"M\"/>", "<svg viewBox=\"0 0 1e9 nan\"><text x=\"1\">a"]
        {
            let found = records(&emf(text));
            assert_eq!(found.last().map(|r| r.0), Some(kind::END), "{text}");
        }
    }
}
