//! `interactive.html`: a result with the viewer of the desk in one file, for sending. It opens from a disk, without a network.
//!
//! ```text
//! <script type="application/json">   results, histories, scene, figures, and the texts of the modules, dependencies first
//! <script>                           the loader: makes each module a blob and imports the last one
//! ```
//!
//! Modules of one file cannot import each other by name. Concatenation needs a parser of JavaScript for names that several modules have, and an
//! import map with `data:` addresses needs `data:` in the policy and a third more bytes for base64. The loader only replaces `./name.js` by the
//! address of a blob, so that the modules are those of the desk, letter by letter, and the policy of the file allows one script by its hash, and
//! blobs.
//!
//! Size: the viewer takes about 0.7 MB; histories have at most 20,000 samples, and a scene above [`MOST_SCENE`] is left out.

use std::fmt::Write;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::page::FILES;
use crate::series;

/// Largest scene that is embedded, in bytes.
pub const MOST_SCENE: usize = 32_000_000;

/// The module that the page begins with.
const ENTRY: &str = "interactive.js";
/// Its styles, in this order.
const STYLES: [&str; 3] = ["style.css", "vendor/uplot.css", "viewer.css"];
/// Reads the modules, dependencies first, and imports the last one.
const LOADER: &str = r#"(async () => {
  const read = (id) => JSON.parse(document.getElementById(id).textContent);
  const addresses = {};
  let last = '';
  for (const [name, text] of read('modules')) {
    const linked = text.replace(/(from\s*|import\s*\(?\s*)'\.\/([\w./-]+\.js)'/g, (whole, before, other) => `${before}'${addresses[other]}'`);
    last = addresses[name] = URL.createObjectURL(new Blob([linked], { type: 'text/javascript' }));
  }
  await import(last);
})();"#;

/// What the file shows.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// Title of the case.
    pub name: &'a str,
    /// `results.json`.
    pub results: &'a str,
    /// `series.csv`; none where the result has no histories.
    pub series: Option<&'a str>,
    /// `scene.json`; none where the result has no scene.
    pub scene: Option<&'a str>,
    /// Figures: name and SVG.
    pub figures: &'a [(String, String)],
    /// Language at the beginning: `en` or `de`.
    pub language: &'a str,
    /// Units at the beginning: `si` or `us`.
    pub units: &'a str,
}

/// The file, as HTML.
pub fn interactive(shown: &Shown<'_>) -> String {
    let style = STYLES.iter().map(|name| text(name)).collect::<Vec<_>>().join("\n");
    let policy = format!(
        "default-src 'none'; script-src '{}' blob:; style-src '{}'; img-src data: blob:; base-uri 'none'; form-action 'none'",
        hash(LOADER),
        hash(&style)
    );
    let mut blocks = String::new();
    let mut block = |id: &str, json: &str| {
        let _ = writeln!(blocks, r#"<script type="application/json" id="{id}">{}</script>"#, inert(json));
    };
    block("settings", &json!({ "language": shown.language, "units": shown.units }).to_string());
    block("results", shown.results);
    if let Some(csv) = shown.series {
        block("series", &series::columns(csv).to_string());
    }
    if let Some(scene) = shown.scene.filter(|scene| scene.len() <= MOST_SCENE) {
        block("scene", scene);
    }
    block("figures", &json!(shown.figures).to_string());
    block("modules", &modules().to_string());
    let (name, language) = (escaped(shown.name), escaped(shown.language));
    format!(
        r#"<!doctype html>
<html lang="{language}" data-theme="auto">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{name}</title>
<style>{style}</style>
</head>
<body>
<header class="top" id="top"></header>
<main id="main" tabindex="-1"></main>
<noscript>This file shows a result with scripts; report.html next to it needs none.</noscript>
{blocks}<script>{LOADER}</script>
</body>
</html>
"#
    )
}

/// The modules from [`ENTRY`] on, each after those that it imports: name and text.
fn modules() -> Value {
    let mut found = Vec::new();
    add(ENTRY, &mut Vec::new(), &mut found);
    found.into_iter().map(|name| json!([name, text(name)])).collect()
}

/// Adds a module after its imports; `open` are the modules that are being added, which end a circle.
fn add(name: &'static str, open: &mut Vec<&'static str>, found: &mut Vec<&'static str>) {
    if found.contains(&name) || open.contains(&name) {
        return;
    }
    open.push(name);
    for other in imports(text(name)) {
        add(other, open, found);
    }
    open.pop();
    found.push(name);
}

/// Names of the modules that a text imports.
fn imports(text: &'static str) -> impl Iterator<Item = &'static str> {
    let named = text.split("'./").skip(1).filter_map(|rest| rest.split_once('\'').map(|(name, _)| name));
    named.filter(|name| name.ends_with(".js"))
}

/// The text of a file of the page.
fn text(name: &str) -> &'static str {
    let file = FILES.iter().find(|(own, _)| *own == name);
    file.and_then(|(_, bytes)| std::str::from_utf8(bytes).ok()).unwrap_or_default()
}

/// JSON that no reader of HTML takes for markup: `<` only stands in texts, where its code means the same.
fn inert(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// Text within markup or an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A script or style as its policy names it.
fn hash(text: &str) -> String {
    format!("sha256-{}", base64(&Sha256::digest(text)))
}

/// Base64 (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::new();
    for group in bytes.chunks(3) {
        let bits = group.iter().fold(0_u32, |bits, byte| (bits << 8) | u32::from(*byte)) << (8 * (3 - group.len()));
        for i in 0..4 {
            let digit = usize::try_from((bits >> (18 - 6 * i)) & 63).unwrap_or(0);
            out.push(if i <= group.len() { char::from(DIGITS[digit]) } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(results: &str) -> String {
        let figures = [("figures/a.svg".to_owned(), "<svg></svg>".to_owned())];
        interactive(&Shown {
            name: "A <b> & \"c\"",
            results,
            series: Some("time_s,a [m]\n0,1\n"),
            scene: None,
            figures: &figures,
            language: "de",
            units: "us",
        })
    }

    /// RFC 4648, section 10; SHA-256 of the empty text by FIPS 180-4.
    #[test]
    fn policy_hashes() {
        let pairs = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (text, coded) in pairs {
            assert_eq!(base64(text.as_bytes()), coded);
        }
        assert_eq!(hash(""), "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
    }

    /// A name or note of a tank file cannot end the block that it stands in.
    #[test]
    fn texts_are_no_markup() {
        let hostile = json!({ "name": "</script><script>alert(1)</script><!--" }).to_string();
        let html = shown(&hostile);
        assert!(!html.contains("alert(1)</script>") && !html.contains("<!--"), "{html}");
        let (_, rest) = html.split_once(r#"id="results">"#).unwrap();
        let (block, _) = rest.split_once("</script>").unwrap();
        assert_eq!(serde_json::from_str::<Value>(block).unwrap(), serde_json::from_str::<Value>(&hostile).unwrap());
        assert!(html.contains("<title>A &lt;b&gt; &amp; &quot;c&quot;</title>"));
    }

    /// Every import leads to a module that stands before; styles do not end their element.
    #[test]
    fn modules_follow_their_imports() {
        let modules = modules();
        let modules = modules.as_array().unwrap();
        let names: Vec<&str> = modules.iter().filter_map(|module| module[0].as_str()).collect();
        assert_eq!(names.last(), Some(&ENTRY));
        for needed in ["viewer.js", "scene-panel.js", "vendor/three.js", "vendor/uplot.js", "words.js"] {
            assert!(names.contains(&needed), "{needed}");
        }
        for (i, name) in names.iter().enumerate() {
            assert!(!text(name).is_empty(), "{name} is not among the files of the page");
            for other in imports(text(name)) {
                assert!(names[..i].contains(&other), "{name} imports {other}");
            }
        }
        assert!(STYLES.iter().all(|name| !text(name).is_empty() && !text(name).contains("</style")));
    }

    /// The file without results is as large as the viewer: a library more would show here.
    #[test]
    fn size_of_the_viewer() {
        let size = shown("{}").len();
        assert!((500_000..800_000).contains(&size), "{size}");
    }

    #[test]
    fn a_large_scene_is_left_out() {
        let scene = format!("\"{}\"", "x".repeat(MOST_SCENE));
        let html = interactive(&Shown {
            name: "",
            results: "{}",
            series: None,
            scene: Some(&scene),
            figures: &[],
            language: "en",
            units: "si",
        });
        assert!(!html.contains(r#"id="scene""#) && html.len() < 1_000_000);
    }
}
