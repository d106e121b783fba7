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

/// A table of hints: words, sections, the key that is meant or an empty text, help.
macro_rules! hints {
    ($([$($word:literal)+] in $sections:expr => $meant:literal, $help:literal;)+) => {
        &[$(Hint { words: &[$($word),+], sections: $sections, meant: $meant, help: $help }),+]
    };
}

const HINTS: &[Hint] = hints! {
    ["diameter" "inner_diameter"] in TOP => "radius",
        "give `tank.radius`, the inner radius: half of the diameter";
    ["soil" "ground" "subsoil"] in TOP => "",
        "give `tank.foundation` with `shear_wave_velocity` for a slab on soil, or with `stiffness` for the bedding of the bottom plate; \
         the ground type of a design spectrum is `site.ec8.ground`";
    ["piles" "pile" "pile_foundation"] in TOP => "",
        "piles are not modelled; a slab on soil is (`tank.foundation` with `shear_wave_velocity`)";
    ["isolated" "isolation" "base_isolation" "isolator"] in TOP => "",
        "give `tank.isolators`: friction pendulums, rubber bearings with lead, or springs and dampers under the slab";
    ["floating" "floating_roof"] in TOP => "",
        "give `tank.roof` with \"type\": \"floating\", `mass` and `rim`; of a roof below a fixed one `internal_floating`";
    ["cone_roof" "dome_roof" "fixed_roof" "roof_type"] in TOP => "",
        "give `tank.roof` with \"type\": \"cone\" or \"dome\", `mass` and `rise`";
    ["slope" "pitch"] in &["tank.roof"] => "rise",
        "give `rise`, the slope times the radius";
    ["floating" "floating_roof" "internal_floating_roof"] in &["tank.roof"] => "internal_floating",
        "give `internal_floating`, the mass of the roof on the liquid below the fixed one";
    ["height" "wall_height" "tank_height"] in TOP => "",
        "the height of the wall is the sum of the heights of `tank.courses`; that of the liquid is `liquid.fill_height`";
    ["level" "liquid_level" "water_level" "filling" "height" "depth"] in &["", "tank", "liquid"] => "fill_height",
        "give `liquid.fill_height`, above the bottom";
    ["pga" "zone" "seismic_zone"] in TOP => "",
        "give `site.ec8.ag` or `site.api650`; the peak of a record is `record.scale_to`";
    ["width"] in &["tank"] => "breadth",
        "give `tank.breadth`, across the shaking, or \"strip\": true";
    ["thickness"] in &["tank"] => "",
        "give the thickness of each course in `tank.courses`";
    ["material"] in &["tank"] => "",
        "give the material of each course in `tank.courses`";
    ["weight" "self_weight"] in &["tank.roof"] => "mass",
        "give `mass`, such as \"12 t\"";
    ["number" "bolts" "n"] in &["tank.anchors"] => "count",
        "give `count`, the number of anchors";
    ["q" "behavior_factor"] in &["site.ec8"] => "behaviour_factor",
        "give `behaviour_factor`";
    ["agr" "pga"] in &["site.ec8"] => "ag",
        "give `ag`, with `importance` for γ_I";
    ["gamma_i" "importance_factor" "importance_class"] in &["site.ec8"] => "importance",
        "give `importance`, the factor γ_I";
    ["importance" "importance_factor" "use_group" "seismic_use_group"] in &["site.api650"] => "sug",
        "give `sug`, the seismic use group 1, 2 or 3, from which the importance factor follows; `importance_1993` is that of the zone \
         method alone";
    ["specific_gravity" "sg" "relative_density"] in &["liquid"] => "density",
        "give `density`, such as \"0.87 SG\" or \"870 kg/m3\" for a specific gravity of 0.87";
    ["soil_class" "ground_type" "soil"] in &["site.ec8"] => "ground",
        "give `ground`, A to E";
    ["type"] in &["site.ec8"] => "spectrum",
        "give `spectrum`, 1 or 2";
    ["e" "elastic_modulus" "young" "youngs_mod"] in &["materials"] => "youngs_modulus",
        "give `youngs_modulus`";
    ["nu" "poisson" "poissons_ratio"] in &["materials"] => "poisson_ratio",
        "give `poisson_ratio`";
    ["rho" "unit_weight"] in &["materials", "liquid"] => "density",
        "give `density`, such as \"7850 kg/m3\"";
    ["fy" "f_y" "yield" "yield_stress"] in &["materials"] => "yield_strength",
        "give `yield_strength`";
    ["legs" "leg" "skirt" "saddles" "pedestal" "tower" "elevated" "columns" "support_columns" "stand" "lugs"] in TOP => "",
        "the wall has to stand on the ground: tanks on legs, columns, a skirt or a tower are not modelled; columns under a roof are \
         `tank.roof.columns`";
    ["wind_girder" "wind_girders" "girder" "stiffeners" "stiffener" "stiffening_rings" "ring" "rings" "top_angle" "top_ring" "curb_angle"]
     in TOP => "rings",
        "give `tank.rings`, each with `height`, `area`, `inertia` and `material`, or as a flat plate with `width` and `thickness`";
    ["insulation" "cladding" "lining" "coating" "jacket"] in TOP => "insulation",
        "give `tank.insulation` with its `mass` per area of wall, such as \"15 kg/m2\"";
    ["snow" "snow_load" "live_load" "roof_load" "roof_live_load"] in TOP => "",
        "give `tank.roof.snow` and `tank.roof.live_load`, loads such as \"1.2 kPa\"";
    ["appurtenances" "accessories" "platform" "platforms" "ladder" "ladders" "stairs" "stairway" "walkway" "agitator" "mixer"] in TOP => "",
        "give `tank.attachments`, each with `name`, `mass` and `height`";
    ["nozzles" "nozzle" "manholes" "manhole" "manway" "openings" "opening" "fittings" "cleanout"] in TOP => "",
        "openings of the wall are not modelled; their masses are `tank.attachments`, and the displacements that connected pipes can take are \
         `tank.pipes`";
    ["temperature" "design_temperature" "operating_temperature" "design_temp" "temp"] in &["", "tank", "liquid", "site", "materials"] => "",
        "give `tank.design_temperature`, and the values of the material there as its `hot`; `liquid.density` is that at the temperature";
    ["corrosion" "corrosion_allowance" "ca"] in &["", "tank"] => "",
        "give `tank.corrosion_allowance`, or `corrosion_allowance` in the courses and the bottom that have their own";
    ["design_pressure" "internal_pressure" "overpressure" "vacuum" "external_pressure"] in &["", "tank", "liquid"] => "",
        "give `tank.pressure` with `internal` and `vacuum`";
    ["wind" "wind_speed" "wind_load" "wind_pressure"] in TOP => "",
        "wind is not checked: remove it";
    ["joint_efficiency" "weld_efficiency"] in &["tank", "tank.courses", "materials"] => "",
        "multiply `allowable_stress` of the material by it";
};

/// Largest specific gravity: that of mercury is 13.6.
const GRAVITY: f64 = 20.0;

/// Help for a density without a unit that is a specific gravity.
///
/// * `path`: its key
pub(super) fn specific_gravity(number: &str, path: &str) -> Option<String> {
    let gravity = number.parse::<f64>().ok().filter(|g| path.ends_with("density") && *g > 0.0 && *g < GRAVITY)?;
    let density = (1e6 * gravity).round() / 1e3;
    Some(format!("a specific gravity of {number} is a density of \"{density} kg/m3\""))
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
    let section = if section.starts_with("materials.") { "materials" } else { section };
    let folded = key.to_lowercase().replace(['-', ' '], "_");
    let fits = |hint: &&Hint| hint.words.contains(&folded.as_str()) && hint.sections.contains(&section);
    // The level of the liquid before that of the wall.
    let own = |hint: &&Hint| fits(hint) && section == "liquid";
    HINTS.iter().rev().find(own).or_else(|| HINTS.iter().find(fits))
}
