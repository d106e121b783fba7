//! Corners of low-cut filters in the words of headers.

use super::number::parse;

/// Words before the corner in capitals. Of a ramp, `.050- .100`, the upper end counts: below it the record is weakened.
const CORNERS: [(&str, bool); 9] = [
    ("LOW-CUT FILTER", false),
    ("FILTERED BELOW", false),
    ("3 DB PTS AT", false),
    ("FREQUENCY RANGE", false),
    ("LOW CUT", false),
    ("HP", false),
    ("FILTERED WITH RAMPS AT", true),
    ("FILTERED BETWEEN", true),
    ("TRANSITION BANDS ARE", true),
];

/// The corner [Hz] that a line of a header states.
pub(super) fn corner(line: &str) -> Option<f64> {
    let upper = line.to_ascii_uppercase();
    let found = CORNERS.iter().find_map(|(words, ramp)| {
        let at = upper.find(words)?;
        let before = upper.get(..at)?.chars().next_back();
        let rest = upper.get(at + words.len()..)?;
        if before.is_some_and(char::is_alphabetic) || rest.starts_with(char::is_alphabetic) {
            return None;
        }
        let (first, rest) = number(rest)?;
        let end = rest.trim_start().strip_prefix('-').and_then(number);
        Some(end.filter(|_| *ramp).map_or(first, |(end, _)| end))
    });
    found.filter(|corner| *corner > 0.0)
}

/// The number at the beginning of a text, and what follows it.
fn number(text: &str) -> Option<(f64, &str)> {
    let text = text.trim_start_matches([' ', '=', ':', '\t']);
    let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    Some((parse(text.get(..end)?).ok()?, text.get(end..)?))
}

#[cfg(test)]
mod tests {
    #[test]
    fn corners_as_written() {
        for (line, expected) in [
            ("ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz LP=15.0 Hz", Some(0.2)),
            ("Record filtered below  0.10 Hz (periods over 10.00 secs)", Some(0.1)),
            ("ACCELEROGRAM BANDPASS FILTERED WITH RAMPS AT .050- .100 AND 23.00-25.00 CYC/SEC", Some(0.1)),
            ("ACCELEROGRAM IS BAND-PASS FILTERED BETWEEN  .225- .325 AND 25.00-27.00 HZ.", Some(0.325)),
            ("Band-pass filter transition bands are .10-.25 Hz and 24.50-25.50 Hz", Some(0.25)),
            ("Accelerogram bandpass filtered with 3 dB pts at   .10 and 40.00 cyc/sec", Some(0.1)),
            ("Frequency range: 0.07-50.0 Hz", Some(0.07)),
            (" low-cut filter: 0.2 Hz", Some(0.2)),
            ("FILTER POINTS: HP=Null LP=Null", None),
            ("SHP=2", None),
            ("Data is unfiltered", None),
        ] {
            assert_eq!(super::corner(line), expected, "{line}");
        }
    }
}
