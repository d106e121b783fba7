//! Figures for programs that know neither variables nor media of style sheets (text processors, converters): every element carries its looks
//! itself, those of the screen in daylight.

use std::collections::BTreeMap;

/// One rule: compounds from the outside in, and the declarations.
struct Rule {
    compounds: Vec<Compound>,
    declarations: Vec<(String, String)>,
}

/// A name of an element, empty for any, and classes.
struct Compound {
    element: String,
    classes: Vec<String>,
}

/// An open element.
struct Open {
    element: String,
    classes: Vec<String>,
    variables: BTreeMap<String, String>,
}

/// SVG with the looks of a style sheet as attributes `style`; sheet and classes are removed. Selectors of elements and classes, one within
/// the other, are understood; rules of media are left out.
pub fn plain(svg: &str, css: &str) -> String {
    let rules = rules(css);
    let mut open: Vec<Open> = Vec::new();
    let mut out = String::with_capacity(svg.len());
    let mut rest = svg;
    while let Some(at) = rest.find('<') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if rest.starts_with("<style>") {
            rest = rest.split_once("</style>").map_or("", |(_, after)| after);
            continue;
        }
        let Some(end) = rest.find('>') else { break };
        let tag = &rest[..=end];
        rest = &rest[end + 1..];
        if tag.starts_with("</") {
            open.pop();
            out.push_str(tag);
        } else if tag.starts_with("<?") || tag.starts_with("<!") {
            out.push_str(tag);
        } else {
            let element = element(tag, &open, &rules);
            out.push_str(&element.1);
            if !tag.ends_with("/>") {
                open.push(element.0);
            }
        }
    }
    out.push_str(rest);
    out
}

/// A start tag with its looks.
fn element(tag: &str, open: &[Open], rules: &[Rule]) -> (Open, String) {
    let name: String = tag[1..].chars().take_while(|c| c.is_ascii_alphanumeric()).collect();
    let classes: Vec<String> =
        attribute(tag, "class").unwrap_or_default().split_whitespace().map(str::to_owned).collect();
    let mut this = Open {
        element: name,
        classes,
        variables: open.last().map_or_else(BTreeMap::new, |outer| outer.variables.clone()),
    };
    let mut found: Vec<(usize, &Rule)> =
        rules.iter().filter(|rule| rule.meets(&this, open)).map(|rule| (rule.weight(), rule)).collect();
    // Stable: of rules of one weight the later one wins.
    found.sort_by_key(|(weight, _)| *weight);
    let declarations = || found.iter().flat_map(|(_, rule)| &rule.declarations);
    for (property, value) in declarations().filter(|(property, _)| property.starts_with("--")) {
        if let Some(value) = resolved(value, &this.variables) {
            this.variables.insert(property.clone(), value);
        }
    }
    let mut looks: BTreeMap<&str, String> = BTreeMap::new();
    for (property, value) in declarations().filter(|(property, _)| !property.starts_with("--")) {
        match resolved(value, &this.variables) {
            Some(value) => drop(looks.insert(property, value)),
            None => drop(looks.remove(property.as_str())),
        }
    }
    let own = attribute(tag, "style").unwrap_or_default().to_owned();
    let style: Vec<String> = looks.iter().map(|(property, value)| format!("{property}:{value}")).collect();
    let style = [style.join(";"), own].iter().filter(|s| !s.is_empty()).cloned().collect::<Vec<_>>().join(";");
    let mut text = without(&without(tag, "class"), "style");
    if !style.is_empty() {
        let at = 1 + this.element.len();
        text.insert_str(at, &format!(" style=\"{}\"", style.replace('"', "'")));
    }
    (this, text)
}

impl Compound {
    fn meets(&self, element: &Open) -> bool {
        let named = self.element.is_empty() || self.element == element.element;
        named && self.classes.iter().all(|class| element.classes.contains(class))
    }
}

impl Rule {
    /// Whether it is of an element within others.
    fn meets(&self, element: &Open, open: &[Open]) -> bool {
        let Some((last, outer)) = self.compounds.split_last() else { return false };
        if !last.meets(element) {
            return false;
        }
        // From the inside out, each compound at the nearest element that it is of.
        let mut around = open.iter().rev();
        outer.iter().rev().all(|compound| around.any(|element| compound.meets(element)))
    }

    /// Classes count before names.
    fn weight(&self) -> usize {
        let of = |c: &Compound| 100 * c.classes.len() + usize::from(!c.element.is_empty());
        self.compounds.iter().map(of).sum()
    }
}

/// A value with its variables put in; `None` if one is not known and has no default.
fn resolved(value: &str, variables: &BTreeMap<String, String>) -> Option<String> {
    let mut out = String::new();
    let mut rest = value;
    while let Some((before, after)) = rest.split_once("var(") {
        let (inside, after) = after.split_once(')')?;
        let (name, default) = match inside.split_once(',') {
            Some((name, default)) => (name.trim(), Some(default.trim().to_owned())),
            None => (inside.trim(), None),
        };
        out.push_str(before);
        out.push_str(&variables.get(name).cloned().or(default)?);
        rest = after;
    }
    out.push_str(rest);
    Some(out)
}

/// The rules of a style sheet outside of media.
fn rules(css: &str) -> Vec<Rule> {
    let mut text = String::with_capacity(css.len());
    let mut rest = css;
    while let Some((before, after)) = rest.split_once("/*") {
        text.push_str(before);
        rest = after.split_once("*/").map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    let mut rules = Vec::new();
    let mut rest = text.as_str();
    while let Some((head, after)) = rest.split_once('{') {
        if head.trim_start().starts_with('@') {
            rest = beyond(after);
            continue;
        }
        let Some((body, after)) = after.split_once('}') else { break };
        let declarations: Vec<(String, String)> = body
            .split(';')
            .filter_map(|d| d.split_once(':'))
            .map(|(property, value)| (property.trim().to_owned(), value.trim().to_owned()))
            .collect();
        for selector in head.split(',') {
            rules.push(Rule {
                compounds: selector.split_whitespace().map(compound).collect(),
                declarations: declarations.clone(),
            });
        }
        rest = after;
    }
    rules
}

/// What follows the end of an open block.
fn beyond(text: &str) -> &str {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &text[at + 1..];
        }
    }
    ""
}

fn compound(text: &str) -> Compound {
    let mut parts = text.split('.');
    Compound { element: parts.next().unwrap_or_default().to_owned(), classes: parts.map(str::to_owned).collect() }
}

/// Value of an attribute.
pub(super) fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let (_, after) = tag.split_once(&format!(" {name}=\""))?;
    after.split_once('"').map(|(value, _)| value)
}

/// A tag without an attribute.
fn without(tag: &str, name: &str) -> String {
    let Some((before, after)) = tag.split_once(&format!(" {name}=\"")) else { return tag.to_owned() };
    let after = after.split_once('"').map_or("", |(_, after)| after);
    format!("{before}{after}")
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn looks_are_those_of_the_sheet() {
        let css = "/* a */ .fig { --k: #111; color: red; } @media screen { .fig { --k: #fff; } }\n.fig path, .fig g { fill: none; } .fig .ln { stroke: \
                   var(--k); stroke-width: var(--w, 2); } .fig .ln.thin { stroke-width: 1; } .fig .red { --k: #f00; } .ot .ln { fill: blue; }";
        let svg = "<svg class=\"fig\"><style>x</style><g class=\"red\"><path class=\"ln\" d=\"M0 0\"/></g><path class=\"thin ln\"/><text>a &lt; \
                   b</text></svg>";
        assert_eq!(
            plain(svg, css),
            "<svg style=\"color:red\"><g style=\"fill:none\"><path style=\"fill:none;stroke:#f00;stroke-width:2\" d=\"M0 0\"/></g><path \
             style=\"fill:none;stroke:#111;stroke-width:1\"/><text>a &lt; b</text></svg>"
        );
    }

    #[test]
    fn a_looks_with_an_unknown_variable_is_left_out() {
        assert_eq!(plain("<path class=\"a\"/>", ".a { stroke: var(--x); fill: #123; }"), "<path style=\"fill:#123\"/>");
    }
}
