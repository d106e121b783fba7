//! The datasheet: names of the keys of the tank file.

/// Gaps that are accepted.
pub const ACCEPTANCE: &str = "Acceptance";
/// Head of the numbers of courses.
pub const COURSE: &str = "Course";
/// Head of the corrosion.
pub const ALLOWANCE: &str = "Allowance";
/// Head of the thickness less the corrosion.
pub const NET: &str = "Net";
/// Title of the table of courses.
pub const COURSES: &str = "Courses from the base up, with their hoop forces and stresses";
/// Axis and title of the figure.
pub const HOOP: &str = "Hoop stress, static and seismic";
/// Caption of the figure.
pub const HOOP_CAPTION: &str = "Largest values; dotted: limits of the courses.";
/// Description of the figure.
pub const HOOP_DESCRIPTION: &str = "Largest hoop stress of the static state and the earthquake together over the height of the wall, by method, with the \
                                    limits of the courses as lines with steps.";

/// The limit of a method in a legend.
pub fn limit(method: &str) -> String {
    format!("Limit, {method}")
}

/// Name of a key, without the part of the path that its group names; empty for a key without one.
pub fn label(key: &str) -> &'static str {
    LABELS.iter().find(|(known, _)| *known == key).map_or("", |(_, label)| label)
}

/// Keys and their names.
const LABELS: &[(&str, &str)] = &[
    ("shape", "Plan"),
    ("radius", "Radius R"),
    ("length", "Length 2L"),
    ("breadth", "Breadth"),
    ("support", "Support"),
    ("pressure", "Pressure above the liquid"),
    ("roof", "Roof"),
    ("roof.mass", "Roof: mass"),
    ("roof.height", "Roof: height of its centre"),
    ("roof.snow", "Roof: snow"),
    ("roof.type", "Roof: kind"),
    ("roof.rise", "Roof: rise"),
    ("roof.columns", "Roof: radius of its columns"),
    ("roof.shell_share", "Roof: share of its weight on the wall"),
    ("roof.internal_floating", "Internal floating roof: mass"),
    ("roof.snow_combination", "Roof: share of the snow, EN 1998"),
    ("roof.live_load", "Roof: live load"),
    ("roof.rim", "Floating roof: height of its rim"),
    ("insulation.mass", "Insulation: mass per area"),
    ("insulation.height", "Insulation: covers the wall up to"),
    ("bottom.thickness", "Bottom plate: thickness"),
    ("bottom.width", "Bottom plate: width of this thickness"),
    ("bottom.annular_thickness", "Annular plate: thickness"),
    ("bottom.annular_width", "Annular plate: width"),
    ("bottom.projection", "Bottom plate: projection"),
    ("bottom.subgrade_modulus", "Bottom plate: modulus of the ground"),
    ("bottom.material", "Bottom plate: material"),
    ("bottom.connections", "Connections through the bottom"),
    ("foundation", "Foundation"),
    ("anchors.count", "Anchors: number"),
    ("anchors.capacity", "Anchors: capacity of one"),
    ("pipes", "Pipes"),
    ("pipes.support_distance", "Pipes: distance of the first support"),
    ("pipes.allowable_displacement", "Pipes: allowed against the support"),
    ("pipes.uplift", "Pipes: allowed upwards"),
    ("pipes.settlement", "Pipes: allowed downwards"),
    ("pipes.horizontal", "Pipes: allowed horizontally"),
    ("design_temperature", "Design temperature"),
    ("hot.youngs_modulus", "Young's modulus at the design temperature"),
    ("hot.yield_strength", "Yield strength at the design temperature"),
    ("hot.allowable_stress", "S_d at the design temperature"),
    ("corrosion_allowance", "Corrosion allowance"),
    ("strip", "Strip of a long tank"),
    ("wall_base.kind", "Joint between wall and base"),
    ("foundation.kind", "Foundation: kind"),
    ("foundation.stiffness", "Foundation: modulus of the ground"),
    ("foundation.shear_wave_velocity", "Soil: velocity of shear waves"),
    ("foundation.soil_density", "Soil: density"),
    ("foundation.soil_poisson_ratio", "Soil: Poisson’s ratio"),
    ("foundation.soil_damping", "Soil: material damping"),
    ("foundation.embedment", "Foundation: underside below the ground"),
    ("foundation.thickness", "Foundation: thickness, of a ring wall its height"),
    ("foundation.width", "Ring wall: width"),
    ("foundation.shell_support", "Support of the shell"),
    ("foundation.friction", "Friction under the bottom plate"),
    ("isolators.kind", "Isolators: kind"),
    ("isolators.radius", "Isolators: radius"),
    ("isolators.friction", "Isolators: friction in fast sliding"),
    ("isolators.friction_slow", "Isolators: friction at rest"),
    ("isolators.friction_rate", "Isolators: rate of the friction in s/m"),
    ("isolators.slip", "Isolators: elastic slip"),
    ("isolators.lower_bound", "Isolators: lower bound"),
    ("isolators.upper_bound", "Isolators: upper bound"),
    ("isolators.displacement_capacity", "Isolators: capacity of displacement"),
    ("grade", "Grade"),
    ("behaviour.steel.yield_strength", "Beyond yield: strength"),
    ("behaviour.steel.tangent_modulus", "Beyond yield: tangent modulus"),
    ("behaviour.steel.kinematic_share", "Beyond yield: kinematic share"),
    ("behaviour.steel.ultimate_strength", "Tensile strength"),
    ("behaviour.concrete.law", "Concrete: law"),
    ("behaviour.concrete.compressive_strength", "Concrete: compressive strength"),
    ("behaviour.concrete.tensile_strength", "Concrete: tensile strength"),
    ("behaviour.concrete.biaxial_ratio", "Concrete: biaxial over uniaxial strength"),
    ("behaviour.concrete.fracture_energy", "Concrete: fracture energy"),
    ("behaviour.concrete.envelope", "Concrete: biaxial envelope"),
    ("behaviour.concrete.bond", "Concrete: bond of the bars"),
    ("behaviour.concrete.shear_retention", "Concrete: shear retention"),
    ("behaviour.concrete.shear_retention_strain", "Concrete: strain of the shear retention"),
    ("behaviour.concrete.tension_stiffening", "Concrete: tension stiffening"),
    ("behaviour.concrete.crack_spacing", "Concrete: spacing of cracks"),
    ("behaviour.reinforcement.yield_strength", "Bars: yield strength"),
    ("behaviour.reinforcement.tangent_modulus", "Bars: tangent modulus"),
    ("behaviour.reinforcement.rupture_strain", "Bars: strain at rupture"),
    ("behaviour.interlayer.e_normal", "Interlayer: modulus across it"),
    ("behaviour.interlayer.e_parallel", "Interlayer: modulus along it"),
    ("behaviour.interlayer.shear_modulus", "Interlayer: shear modulus"),
    ("behaviour.interlayer.tension", "Interlayer: tension"),
    ("time_factor", "Factor of the time"),
    ("housner.convective", "Housner: convective part"),
    ("housner.combination", "Housner: combination"),
    ("ec8.combination", "Eurocode 8: combination"),
    ("ec8.impulsive", "Eurocode 8: impulsive part"),
    ("internals", "Equipment within the liquid"),
    ("adjacent_structures", "Connected structures"),
    ("fill_height", "Depth H"),
    ("density", "Density ρ"),
    ("youngs_modulus", "Young’s modulus E"),
    ("poisson_ratio", "Poisson’s ratio ν"),
    ("yield_strength", "Yield strength f_y"),
    ("allowable_stress", "Allowable stress S_d"),
    ("family", "Family"),
    ("ground", "Ground type"),
    ("spectrum", "Type of spectrum"),
    ("ag", "Reference acceleration a_gR"),
    ("importance", "Importance factor γ_I"),
    ("behaviour_factor", "Behaviour factor q"),
    ("construction_quality", "Quality of construction"),
    ("vertical", "Vertical motion"),
    ("components", "Horizontal components"),
    ("friction", "Friction μ"),
    ("reduction_factor", "Reduction for damage limitation"),
    ("bearing_capacity", "Bearing resistance"),
    ("ss", "S_S"),
    ("s1", "S_1"),
    ("s0", "S_0"),
    ("site_class", "Site class"),
    ("asce7", "Tables of ASCE 7"),
    ("fa", "F_a"),
    ("fv", "F_v"),
    ("q", "Factor Q"),
    ("sug", "Seismic use group"),
    ("tl", "T_L in s"),
    ("av", "A_v"),
    ("design_pressure", "Design pressure"),
    ("joint_efficiency", "Joint efficiency"),
    ("foundation_weight", "Weight of the foundation"),
    ("zone_factor", "Zone factor Z, 9th edition"),
    ("soil_factor", "Site factor S, 9th edition"),
    ("importance_1993", "Importance I, 9th edition"),
    ("sloshing", "Sloshing"),
    ("impulsive", "Impulsive part"),
    ("scale_to", "Scaled to"),
    ("scale_by", "Scaled by"),
    ("run", "Procedures"),
    ("decide", "Deciding"),
];
