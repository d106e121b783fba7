//! Names of the ingredients that an attribution exchanges.

/// Caption of a waterfall.
pub const CAPTION: &str = "Factor by factor.";

/// Title of a waterfall.
pub fn title(quantity: &str, site: bool) -> String {
    match site {
        true => format!("{quantity}: from the finite elements to the site's design values"),
        false => format!("{quantity}: from the finite elements to the procedures"),
    }
}

/// Description of a waterfall.
pub fn description(title: &str, ends: &str) -> String {
    format!("{title}, factor by factor. Ratios to the finite elements: {ends}.")
}

/// The row of factors within `percent` of 1.
pub fn rest(count: usize) -> String {
    match count {
        1 => "1 smaller factor".into(),
        _ => format!("{count} smaller factors"),
    }
}

/// Head of the column of factors' names.
pub const FACTOR: &str = "Exchanged for the procedure's";
/// Last row of a table of factors.
pub const PRODUCT: &str = "product = ratio to FE under the record";

/// Title within a waterfall.
pub fn short_title(quantity: &str, site: bool) -> String {
    if site { format!("{quantity}, site against record") } else { format!("{quantity}, record") }
}
