//! Formats of agencies recognised by their first lines, for a clear message that they are not supported.

use crate::input::diagnostic::Fault;
use files::code::Code;

/// A format and the test for its first lines.
struct Foreign {
    name: &'static str,
    looks: fn(&[&str]) -> bool,
}

const FOREIGN: &[Foreign] = &[
    Foreign {
        name: "a USC or Caltech volume 2 file",
        looks: |l| l[0].starts_with("CORRECTED ACCELEROGRAM"),
    },
    Foreign {
        name: "a CSMIP, USC or Caltech volume 1 file",
        looks: |l| l[0].starts_with("UNCORRECTED ACCELEROGRAM"),
    },
    Foreign {
        name: "a miniSEED volume",
        looks: |l| {
            l[0].len() > 8
                && l[0].as_bytes()[..6].iter().all(u8::is_ascii_digit)
                && matches!(l[0].as_bytes()[6], b'D' | b'R' | b'Q')
        },
    },
];

/// The fault for a known but unsupported format; `None` for any other text.
pub fn recognise(text: &str) -> Option<Fault> {
    let lines: Vec<&str> = text.lines().take(4).collect();
    let first = *lines.first()?;
    let foreign = FOREIGN.iter().find(|f| (f.looks)(&lines))?;
    Some(
        Fault::new(
            Code::RecordFormat,
            format!("this is {}, which is not supported", foreign.name),
        )
        .at(0..first.len())
        .allowed("CSV or plain text of one or two columns, PEER .AT2, ESM, K-NET, SMC, COSMOS, CSMIP volume 2")
        .help("convert its acceleration to a CSV file with the header `time_s,acceleration_m_s2`"),
    )
}
