//! Templates: embedded ones, and a folder of the user's that replaces them by name.

use std::collections::BTreeMap;
use std::path::Path;

use tera::{Context, Tera};

use crate::figure::svg::escape;
use crate::math;
use crate::sections::TEMPLATES;
use files::code::Code;
use files::error::Error;
use files::text::line;

/// The embedded pages and style sheets by name; [`crate::sections::TEMPLATES`] has the sections.
const PAGES: &[(&str, &str)] = &[
    ("report.html", include_str!("../../../templates/report.html")),
    ("cover.html", include_str!("../../../templates/cover.html")),
    ("components.html", include_str!("../../../templates/components.html")),
    ("style.css", include_str!("../../../templates/style.css")),
    ("math.css", include_str!("../../../templates/math.css")),
    ("figure.css", include_str!("../../../templates/figure.css")),
    ("ida.html", include_str!("../../../templates/ida.html")),
    ("push.html", include_str!("../../../templates/push.html")),
    ("study.html", include_str!("../../../templates/study.html")),
    ("fields.css", include_str!("../../../templates/fields.css")),
    ("nonlinear.css", include_str!("../../../templates/nonlinear.css")),
];

/// All embedded templates: name in a folder of templates, and text.
pub fn embedded() -> impl Iterator<Item = &'static (&'static str, &'static str)> {
    PAGES.iter().chain(TEMPLATES)
}

/// The template engine with all templates read.
pub struct Templates {
    tera: Tera,
    sources: BTreeMap<String, String>,
}

impl Templates {
    /// Reads the embedded templates and, where `folder` is given, those in it.
    ///
    /// Errors: a folder without any template of a known name, an unreadable file, a template that does not parse.
    pub fn new(folder: Option<&Path>) -> Result<Templates, Error> {
        let mut sources: BTreeMap<String, String> =
            embedded().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        if let Some(folder) = folder {
            replace(&mut sources, folder)?;
        }
        let mut tera = Tera::new();
        tera.autoescape_on([".html"]);
        tera.register_filter("css_text", |text: &str, _: tera::Kwargs, _: &tera::State| css_text(text));
        tera.register_filter("prose", |text: &str, _: tera::Kwargs, _: &tera::State| math::prose(text));
        tera.register_filter("code", |text: &str, _: tera::Kwargs, _: &tera::State| code(text));
        let pages = sources.iter().filter(|(name, _)| name.ends_with(".html"));
        tera.add_raw_templates(pages.map(|(name, text)| (name.as_str(), text.as_str())))
            .map_err(|e| Error::Report(format!("templates: {e}")))?;
        Ok(Templates { tera, sources })
    }

    /// The same with a page of another crate.
    ///
    /// Errors: a page that does not parse.
    pub fn with(mut self, name: &str, text: &str) -> Result<Templates, Error> {
        let added = self.tera.add_raw_template(name, text);
        added.map_err(|e| Error::Report(format!("templates: {e}")))?;
        Ok(self)
    }

    /// Renders a template.
    pub fn render(&self, name: &str, context: &Context) -> Result<String, Error> {
        self.tera.render(name, context).map_err(|e| Error::Report(format!("template {name}: {e}")))
    }

    /// The template of a section: its own one, else that of all parts.
    pub(crate) fn of_section(&self, id: &str) -> String {
        let own = format!("sections/{id}.html");
        if self.sources.contains_key(&own) { own } else { "sections/part.html".into() }
    }

    /// A style sheet.
    pub fn css(&self, name: &str) -> &str {
        self.sources.get(name).map_or("", String::as_str)
    }
}

/// Puts the files of `folder` in the place of the embedded templates of the same name; other `.html` files are added for
/// `{% include %}`.
fn replace(sources: &mut BTreeMap<String, String>, folder: &Path) -> Result<(), Error> {
    let fault = |path: &Path, e: std::io::Error| Error::unreadable(path, &e);
    let mut replaced = 0;
    for prefix in ["", "sections/"] {
        let place = folder.join(prefix);
        if !prefix.is_empty() && !place.is_dir() {
            continue;
        }
        let entries = std::fs::read_dir(&place).map_err(|e| fault(&place, e))?;
        for entry in entries {
            let path = entry.map_err(|e| fault(&place, e))?.path();
            let Some(file) = path.file_name().and_then(|f| f.to_str()) else { continue };
            let name = format!("{prefix}{file}");
            if !path.is_file() || !(file.ends_with(".html") || sources.contains_key(&name)) {
                continue;
            }
            let text = files::read_text(&path).map_err(|e| fault(&path, e))?;
            replaced += usize::from(sources.insert(name, text).is_some());
        }
    }
    if replaced == 0 {
        let known: Vec<&str> = embedded().map(|(name, _)| *name).collect();
        return Err(Error::File {
            code: Code::NotResults,
            path: folder.into(),
            what: format!("holds no template; known names are {}", known.join(", ")),
        });
    }
    Ok(())
}

/// A sentence as HTML, words in backquotes as code.
fn code(text: &str) -> String {
    let part = |(i, part): (usize, &str)| match i % 2 {
        0 => escape(part),
        _ => format!("<code>{}</code>", escape(part)),
    };
    text.split('`').enumerate().map(part).collect()
}

/// Text as the inside of a CSS string: everything but letters, digits and spaces as an escape.
fn css_text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in line(text).chars() {
        if c.is_alphanumeric() || c == ' ' {
            out.push(c);
        } else {
            out.push_str(&format!("\\{:x} ", c as u32));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn css_strings_hold_no_markup() {
        assert_eq!(css_text("Tank 7"), "Tank 7");
        assert_eq!(css_text("\"</style>"), "\\22 \\3c \\2f style\\3e ");
    }

    #[test]
    fn backquotes_are_code() {
        assert_eq!(code("a < `b`."), "a &lt; <code>b</code>.");
    }

    #[test]
    fn a_folder_without_templates_is_refused() {
        let folder = std::env::temp_dir().join(format!("tankcheck-no-templates-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let fault = Templates::new(Some(&folder)).err().map(|e| e.to_string()).unwrap_or_default();
        std::fs::remove_dir(&folder).unwrap();
        assert!(fault.contains("holds no template") && fault.contains("report.html"), "{fault}");
    }
}
