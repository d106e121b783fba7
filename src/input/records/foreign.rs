//! Formats of agencies recognised by their first lines, for a clear message that they are not supported.

use crate::input::diagnostic::Fault;

/// A format and the test for its first lines.
struct Foreign {
    name: &'static str,
    looks: fn(&[&str]) -> bool,
}

const FOREIGN: &[Foreign] = &[
    Foreign {
        name: "a K-NET / KiK-net ASCII file",
        looks: |l| l[0].starts_with("Origin Time"),
    },
    Foreign {
        name: "an ESM / ITACA ASCII file",
        looks: |l| l[0].starts_with("EVENT_NAME:"),
    },
    Foreign {
        name: "a USGS SMC file",
        looks: |l| smc(l[0]) && l.get(1).is_some_and(|x| x.trim() == "*"),
    },
    Foreign {
        name: "a COSMOS or CSMIP volume file",
        looks: |l| l[0].contains("(Format v"),
    },
    Foreign {
        name: "a CSMIP, USC or Caltech volume 2 file",
        looks: |l| l[0].starts_with("CORRECTED ACCELEROGRAM"),
    },
    Foreign {
        name: "a CSMIP, USC or Caltech volume 1 file",
        looks: |l| l[0].starts_with("UNCORRECTED ACCELEROGRAM"),
    },
];

/// First line of SMC: a digit and the kind of the file.
fn smc(line: &str) -> bool {
    let words: Vec<&str> = line.split_whitespace().collect();
    matches!(words.as_slice(), [n, "CORRECTED" | "UNCORRECTED", "ACCELEROGRAM", ..] if n.parse::<u8>().is_ok())
}

/// The fault for a known but unsupported format; `None` for any other text.
pub fn recognise(text: &str) -> Option<Fault> {
    let lines: Vec<&str> = text.lines().take(4).collect();
    let first = *lines.first()?;
    let foreign = FOREIGN.iter().find(|f| (f.looks)(&lines))?;
    Some(
        Fault::new(format!("this is {}, which is not supported", foreign.name))
            .at(0..first.len())
            .allowed("CSV or plain text of one or two columns, PEER .AT2")
            .help("convert its acceleration to a CSV file with the header `time_s,acceleration_m_s2`"),
    )
}
