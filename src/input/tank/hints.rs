//! Keys that users look for under another name.

/// What users look for under another name.
pub(super) struct Hint {
    /// Their words, lower case.
    words: &'static [&'static str],
    /// The objects in which they write them; an index and a name within a path are not compared.
    sections: &'static [&'static str],
    /// The key of that object which is meant, so that it is not reported as missing too; empty without one.
    pub(super) meant: &'static str,
    /// How it is supported, or that it is not.
    pub(super) help: &'static str,
}

/// The objects at the top.
const TOP: &[&str] = &["", "tank", "liquid", "site"];

const fn hint(
    words: &'static [&'static str],
    sections: &'static [&'static str],
    meant: &'static str,
    help: &'static str,
) -> Hint {
    Hint {
        words,
        sections,
        meant,
        help,
    }
}

const HINTS: &[Hint] = &[
    hint(
        &["diameter", "inner_diameter"],
        TOP,
        "radius",
        "give `tank.radius`, the inner radius: half of the diameter",
    ),
    hint(
        &["soil", "ground", "subsoil"],
        TOP,
        "",
        "give `tank.foundation` with `shear_wave_velocity` for a slab on soil, or with `stiffness` for the bedding of the bottom plate; the \
         ground type of a design spectrum is `site.ec8.ground`",
    ),
    hint(
        &["piles", "pile", "pile_foundation"],
        TOP,
        "",
        "piles are not modelled; a slab on soil is (`tank.foundation` with `shear_wave_velocity`)",
    ),
    hint(
        &["isolated", "isolation", "base_isolation", "isolator"],
        TOP,
        "",
        "give `tank.isolators`: friction pendulums, rubber bearings with lead, or springs and dampers under the slab",
    ),
    hint(
        &["floating", "floating_roof"],
        TOP,
        "",
        "give `tank.roof` with \"type\": \"floating\", `mass` and `rim`",
    ),
    hint(
        &["height", "wall_height", "tank_height"],
        TOP,
        "",
        "the height of the wall is the sum of the heights of `tank.courses`; that of the liquid is `liquid.fill_height`",
    ),
    hint(
        &["level", "liquid_level", "water_level", "filling", "height", "depth"],
        &["", "tank", "liquid"],
        "fill_height",
        "give `liquid.fill_height`, above the bottom",
    ),
    hint(
        &["pga", "zone", "seismic_zone"],
        TOP,
        "",
        "give `site.ec8.ag` or `site.api650`; the peak of a record is `record.scale_to`",
    ),
    hint(
        &["width"],
        &["tank"],
        "breadth",
        "give `tank.breadth`, across the shaking, or \"strip\": true",
    ),
    hint(
        &["thickness"],
        &["tank"],
        "",
        "give the thickness of each course in `tank.courses`",
    ),
    hint(
        &["material"],
        &["tank"],
        "",
        "give the material of each course in `tank.courses`",
    ),
    hint(
        &["weight", "self_weight"],
        &["tank.roof"],
        "mass",
        "give `mass`, such as \"12 t\"",
    ),
    hint(
        &["number", "bolts", "n"],
        &["tank.anchors"],
        "count",
        "give `count`, the number of anchors",
    ),
    hint(
        &["q", "behavior_factor"],
        &["site.ec8"],
        "behaviour_factor",
        "give `behaviour_factor`",
    ),
    hint(
        &["agr", "pga"],
        &["site.ec8"],
        "ag",
        "give `ag`, with `importance` for γ_I",
    ),
    hint(
        &["gamma_i", "importance_factor", "importance_class"],
        &["site.ec8"],
        "importance",
        "give `importance`, the factor γ_I",
    ),
    hint(
        &["importance", "importance_factor", "use_group", "seismic_use_group"],
        &["site.api650"],
        "sug",
        "give `sug`, the seismic use group 1, 2 or 3, from which the importance factor follows; `importance_1993` is that of the zone method alone",
    ),
    hint(
        &["specific_gravity", "sg", "relative_density"],
        &["liquid"],
        "density",
        "give `density`: 1000 kg/m3 times the specific gravity, such as \"870 kg/m3\" for 0.87",
    ),
    hint(
        &["soil_class", "ground_type", "soil"],
        &["site.ec8"],
        "ground",
        "give `ground`, A to E",
    ),
    hint(&["type"], &["site.ec8"], "spectrum", "give `spectrum`, 1 or 2"),
    hint(
        &["e", "elastic_modulus", "young", "youngs_mod"],
        &["materials"],
        "youngs_modulus",
        "give `youngs_modulus`",
    ),
    hint(
        &["nu", "poisson", "poissons_ratio"],
        &["materials"],
        "poisson_ratio",
        "give `poisson_ratio`",
    ),
    hint(
        &["rho", "unit_weight"],
        &["materials", "liquid"],
        "density",
        "give `density`, such as \"7850 kg/m3\"",
    ),
    hint(
        &["fy", "f_y", "yield", "yield_stress"],
        &["materials"],
        "yield_strength",
        "give `yield_strength`",
    ),
];

/// Help for a key that is missing in an object, where another way is likelier than to add it.
///
/// * `text`: the text of another key of the object, or an empty one
pub(super) fn missing<'t>(path: &str, key: &str, text: impl Fn(&str) -> &'t str) -> Option<&'static str> {
    match (path, key, text("type")) {
        ("tank.roof", "mass", "open") => Some(
            "remove `roof` from a tank without one; or add \"mass\": \"2 t\", that of the girders on top of the wall",
        ),
        _ => None,
    }
}

/// What a user looks for under this key in an object.
pub(super) fn looked_for(key: &str, path: &str) -> Option<&'static Hint> {
    // `materials["A 36"]` is one of the materials.
    let section = path.split('[').next().unwrap_or_default();
    let section = match section.starts_with("materials.") {
        true => "materials",
        false => section,
    };
    let folded = key.to_lowercase().replace(['-', ' '], "_");
    let fits = |hint: &&Hint| hint.words.contains(&folded.as_str()) && hint.sections.contains(&section);
    // The level of the liquid before that of the wall.
    let own = |hint: &&Hint| fits(hint) && section == "liquid";
    HINTS.iter().rev().find(own).or_else(|| HINTS.iter().find(fits))
}
