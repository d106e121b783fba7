//! Heads of columns and labels of rows, legends and axes.

/// Number of a figure.
pub const FIGURE: &str = "Figure";
/// Number of a table.
pub const TABLE: &str = "Table";
/// Vertical line at the end of the record.
pub const RECORD_END: &str = "end of the record";
/// Membrane stress where an imperfect wall stands.
pub const BASE_STRESS: &str = "Axial membrane stress at the base";
/// Ratio to the finite-element value.
pub const RATIO_TO_ENGINE: &str = "Ratio to FE";
/// Relative difference between two meshes.
pub const MESH_ERROR: &str = "Estimated discretisation error";
/// The same of the three-dimensional engine.
pub const SPATIAL_MESH_ERROR: &str = "Estimated error of the spatial mesh";
/// Energies at the end of a linear run.
pub const ENERGY_AT_END: &str = "Energy at the end";
/// Parts of the energy balance: work, kinetic, potential, dissipated.
pub const ENERGIES: [&str; 4] =
    ["Work of the base motion", "Kinetic", "Elastic and gravity potential", "Dissipated by damping"];
/// Largest absolute value of a history, as the head of a column and in a row.
pub const LARGEST: [&str; 2] = ["Largest absolute value", "largest absolute value"];
/// Peak acceleration of the file.
pub const PEAK_AS_RECORDED: &str = "Peak acceleration of the file, unprocessed";
/// CAV.
pub const CUMULATIVE_VELOCITY: &str = "Cumulative absolute velocity";
/// Energies of a nonlinear run: work of the loads, internal, materials, damping, kinetic, time integration.
pub const NONLINEAR_ENERGIES: [&str; 6] =
    ["work of the loads", "internal", "materials (part of internal)", "damping", "kinetic", "time integration"];
/// Energies of a nonlinear run at its end, and as parts of the work.
pub const AT_END: [&str; 2] = ["At the end", "At the end, part of the work"];
/// Largest bending moment of the lowest section.
pub const LARGEST_OF_SECTION: &str = "Largest of the section";
/// Range of the finite elements in a legend.
pub const ENGINE_RANGE: &str = "Finite elements, range";
/// Static state and seismic range in a legend.
pub const COMBINED_RANGE: &str = "static + seismic range";
/// Smallest and largest value of the finite elements.
pub const ENGINE_EXTREMES: [&str; 2] = ["Finite elements min", "Finite elements max"];
/// Drawn parts of a three-dimensional mesh: nodes, elements of the wall, elements of the surface.
pub const MESH: [&str; 3] = ["nodes of wall and free surface", "elements of the wall", "elements of the free surface"];
/// Largest difference of two histories.
pub const SAMPLE_DIFFERENCE: &str = "largest difference of two samples";
/// Direction of a crack.
pub const CRACK_DIRECTION: &str = "Direction from the hoop";
/// Largest width of a crack.
pub const LARGEST_SO_FAR: &str = "Largest so far";
/// Titles of the tables of an engine: damping, discretisation error, masses, energies.
pub fn engine_tables(engine: &str) -> [String; 4] {
    ["Damping", "Discretisation error", "Balance of masses", "Energy balance"]
        .map(|title| format!("{title}, {engine} engine"))
}
/// Axis along the developed walls of a box.
pub const WALLS_AXIS: &str = "Position s along the walls";
/// Axis around the developed wall.
pub const ANGLE_AXIS: &str = "Angle θ from the direction of shaking [°]";

/// Histories of a linear and a nonlinear run.
pub const BOTH_RUNS: &str = "linear and nonlinear";

/// A number that depends on what the model cannot say.
pub const OUTSIDE: &str = "outside the model";

/// The tank.
pub mod tank {
    /// Plan of a strip.
    pub const STRIP: &str = "strip of a long rectangular tank";
    /// Support without anchors.
    pub const ON_GROUND: &str = "resting on the ground";
    /// Mass of a roof that the liquid carries.
    pub const FLOATING_ROOF: &str = "Mass of the floating roof";
    /// Label of a mass.
    pub const SNOW_MASS: &str = "Snow in the roof mass";
    /// Label of a mass.
    pub const ROOF_ON_WALL: &str = "Roof mass that stands on the wall";
    /// Label of a mass.
    pub const INSULATION: &str = "Insulation in the wall mass";
    /// Caption of a table.
    pub const CARRIED: &str = "Rings and attachments of the wall";
    /// Head of a column.
    pub const COMPONENT: &str = "Component";
    /// A ring among the parts.
    pub const RING: &str = "ring";
    /// Height of the roof's centre of mass.
    pub const ROOF_HEIGHT: &str = "Height of the roof's centre of mass";
    /// g.
    pub const GRAVITY: &str = "Acceleration of free fall";
    /// Bottom plate.
    pub const BOTTOM_PLATE: &str = "Thickness of the bottom plate under the shell";
    /// Anchors.
    pub const ANCHORS: &str = "Number of anchors";
    /// Deformability parameter.
    pub const DEFORMABILITY: &str = "Deformability √(H/s) of the filled wall, s of its lowest course";
    /// Anchors.
    pub const ANCHOR_CAPACITY: &str = "Capacity of one anchor";
    /// Table of masses and heights.
    pub const MASSES: &str = "Masses, and what is derived";
    /// Table of courses.
    pub const COURSES: &str = "Courses from the base up";
    /// Table of layers.
    pub const LAYERS: &str = "Layers from inside to outside; the table above has the equivalent homogeneous wall";
    /// Place of a bar.
    pub const BAR_DEPTH: &str = "Distance from the inner face";
    /// Table of bars.
    pub const BARS: &str = "Bars of the wall";
}
