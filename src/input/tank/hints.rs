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
    hint(
        &[
            "legs",
            "leg",
            "skirt",
            "saddles",
            "pedestal",
            "tower",
            "elevated",
            "columns",
            "support_columns",
            "stand",
            "lugs",
        ],
        TOP,
        "",
        "the wall has to stand on the ground: tanks on legs, columns, a skirt or a tower are not modelled; of columns under a roof, give `tank.roof.mass` \
         with the part that the wall carries",
    ),
    hint(
        &[
            "wind_girder",
            "wind_girders",
            "girder",
            "stiffeners",
            "stiffener",
            "stiffening_rings",
            "ring",
            "rings",
            "top_angle",
            "top_ring",
            "curb_angle",
        ],
        TOP,
        "",
        "rings do not stiffen the wall here; add the mass of those at its top to `tank.roof.mass`",
    ),
    hint(
        &["insulation", "cladding", "lining", "coating", "jacket"],
        TOP,
        "",
        "add the mass of an insulation to the wall: raise `density` of its material by the mass per area over the thickness of the wall",
    ),
    hint(
        &[
            "snow",
            "snow_load",
            "live_load",
            "roof_load",
            "roof_live_load",
            "platform",
            "platforms",
            "ladder",
            "stairs",
            "walkway",
            "agitator",
            "mixer",
        ],
        TOP,
        "",
        "add what acts together with the earthquake to `tank.roof.mass`, at its `height`",
    ),
    hint(
        &[
            "nozzles", "nozzle", "manholes", "manhole", "manway", "openings", "opening", "fittings", "cleanout",
        ],
        TOP,
        "",
        "openings of the wall are not modelled; the displacements that connected pipes can take are `tank.pipes`",
    ),
    hint(
        &[
            "temperature",
            "design_temperature",
            "operating_temperature",
            "design_temp",
            "temp",
        ],
        &["", "tank", "liquid", "site", "materials"],
        "",
        "give the properties at the temperature: `liquid.density`, and `youngs_modulus` and `yield_strength` of the material",
    ),
    hint(
        &["corrosion", "corrosion_allowance", "ca"],
        &["", "tank"],
        "",
        "give `corrosion_allowance` in each course of `tank.courses` and in `tank.bottom`",
    ),
    hint(
        &[
            "design_pressure",
            "internal_pressure",
            "overpressure",
            "vacuum",
            "external_pressure",
        ],
        &["", "tank", "liquid"],
        "",
        "give `tank.pressure` with `internal` and `vacuum`",
    ),
    hint(
        &["wind", "wind_speed", "wind_load", "wind_pressure"],
        TOP,
        "",
        "wind is not checked: remove it",
    ),
    hint(
        &["joint_efficiency", "weld_efficiency"],
        &["tank", "tank.courses", "materials"],
        "",
        "multiply `allowable_stress` of the material by it",
    ),
];

/// Largest specific gravity: that of mercury is 13.6.
const GRAVITY: f64 = 20.0;

/// Help for a density without a unit that is a specific gravity.
///
/// * `path`: its key
pub(super) fn specific_gravity(number: &str, path: &str) -> Option<String> {
    let gravity = number
        .parse::<f64>()
        .ok()
        .filter(|g| path.ends_with("density") && *g > 0.0 && *g < GRAVITY)?;
    let density = (1e6 * gravity).round() / 1e3;
    Some(format!(
        "a specific gravity of {number} is a density of \"{density} kg/m3\""
    ))
}

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
