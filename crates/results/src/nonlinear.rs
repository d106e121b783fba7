//! How a run ended, its events, and the state of the wall after a nonlinear run.
//!
//! Places on the wall are cells of a grid over the developed wall, rows from the base up. Values are SI.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// Results that only a nonlinear run has.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Nonlinear {
    /// Cells of the wall.
    pub grid: WallGrid,
    /// Quantities over the wall: plastic strain, utilisation, largest crack, …
    pub maps: Vec<CellMap>,
    /// Cracks at chosen times.
    pub cracks: Vec<CrackPicture>,
    /// Moment over curvature, force over displacement and the like.
    pub loops: Vec<Loop>,
    /// Energies over time.
    pub energies: Energies,
    /// Cost, as label and number: steps, halvings, iterations, factorisations.
    pub cost: Vec<Count>,
    /// Largest moment at the base of each wall of a strip, with its parts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub moments: Vec<BaseMoment>,
    /// Limits of the model that the run has passed, the first of each kind by time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub departures: Vec<Departure>,
    /// Extremes of both signs, at both sides of the tank, and at both faces of its wall.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extremes: Vec<TwoSided>,
}

/// Smallest and largest value of a quantity, as changes from the state at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TwoSided {
    /// Title, with side or face.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Value at rest.
    pub rest: f64,
    /// Smallest; quantities that cannot be negative (cracks, gaps) have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<At>,
    /// Largest.
    pub max: At,
}

/// A value, and when it was reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct At {
    /// Value, a change from that at rest.
    pub value: f64,
    /// Time [s], where it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
}

/// A limit of the model that a run has passed; later values are marked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Departure {
    /// Which limit.
    #[serde(rename = "id")]
    pub kind: DepartureKind,
    /// Time [s].
    pub time: f64,
    /// Angle of the wall from the direction of shaking [rad], where there are several walls.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub theta: Option<f64>,
    /// Height above the base [m].
    pub height: f64,
    /// Value and limit, where both are known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passed: Option<Passed>,
}

/// A value beyond its limit, both in the unit of their [`DepartureKind`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Passed {
    /// Found.
    pub value: f64,
    /// Allowed.
    pub limit: f64,
}

/// Limits of the nonlinear models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DepartureKind {
    /// Strain of a bar beyond its strain at rupture.
    BarStrain,
    /// Moment of damping and inertia at the base over that of the section.
    MomentBalance,
    /// Acceleration of the wall [m/s²].
    Acceleration,
    /// Energy that the wall stores below the least possible one [J/m]: the time integration gains energy, and the run is stopped.
    StoredEnergy,
}

impl DepartureKind {
    /// Id as in `ida.csv`.
    pub fn id(self) -> &'static str {
        match self {
            DepartureKind::BarStrain => "bar_strain",
            DepartureKind::MomentBalance => "moment_balance",
            DepartureKind::Acceleration => "acceleration",
            DepartureKind::StoredEnergy => "stored_energy",
        }
    }

    /// Whether a run is stopped there.
    pub fn stops(self) -> bool {
        self == DepartureKind::StoredEnergy
    }
}

/// A moment at the base of a wall and its parts [N m/m], signed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BaseMoment {
    /// The wall.
    pub place: String,
    /// Time [s].
    pub time: f64,
    /// The reaction, sum of the parts.
    pub reaction: f64,
    /// Stresses of the section, extrapolated from the lowest element to the base.
    pub section: f64,
    /// Viscous damping.
    pub damping: f64,
    /// Inertia of the lowest element and dynamic pressure on it.
    pub inertia: f64,
    /// Static pressure on the base itself.
    pub load: f64,
    /// Largest bending moment of the lowest section in the whole run, absolute.
    pub largest_section: f64,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum End {
    /// At the end of the record.
    Completed,
    /// By the user.
    Interrupted {
        /// Time reached [s].
        time: f64,
    },
    /// The run has left its model (see [`Nonlinear::departures`]) and was stopped: the results end here.
    Left {
        /// Time [s].
        time: f64,
        /// The limit at which it was stopped.
        departure: Departure,
    },
    /// No equilibrium was found with the shortest step: the results end here and are lower bounds.
    Collapsed {
        /// Time of the last equilibrium [s]; before 0 there is none.
        time: f64,
        /// Part of weight and static pressure that the wall carries, where it does not carry all.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        load_factor: Option<f64>,
        /// Reason.
        reason: String,
        /// Where the forces are furthest from equilibrium, in words.
        place: String,
    },
}

/// Something that happened for the first time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Kind of event.
    #[serde(rename = "id")]
    pub kind: EventKind,
    /// Title (`first crack`).
    pub title: String,
    /// Time [s]; 0 is the static state.
    pub time: f64,
    /// Where, in words.
    pub place: String,
    /// Further remark, one sentence; may be empty.
    pub note: String,
}

/// Kind of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EventKind {
    /// A crack.
    FirstCrack,
    /// Yielding of a plate or of concrete in compression.
    FirstYield,
    /// Yielding of a bar.
    FirstBarYield,
    /// A bar passes its strain at rupture.
    BarRupture,
    /// A plate passes its tensile strength.
    AboveStrength,
    /// Concrete reaches its compressive strength.
    Crushing,
    /// The liquid leaves the wall, which it may leave.
    Separation,
    /// The pressure of the liquid falls below that of the air; the model keeps the liquid at the wall.
    LowPressure,
}

impl EventKind {
    /// Whether the wall cracks.
    pub fn cracks(self) -> bool {
        self == EventKind::FirstCrack
    }

    /// Whether something yields.
    pub fn yields(self) -> bool {
        matches!(self, EventKind::FirstYield | EventKind::FirstBarYield)
    }
}

/// Columns of the grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Columns {
    /// Sectors of a cylinder.
    Sectors {
        /// Radius [m].
        radius: f64,
        /// Edges [rad] from the direction of shaking, ascending: one more than there are columns.
        edges: Vec<f64>,
        /// Whether the half from π to 2π is the mirror image of the given one.
        mirrored: bool,
    },
    /// Plane walls side by side.
    Walls {
        /// Their names.
        names: Vec<String>,
    },
}

impl Columns {
    /// Number of columns.
    pub fn count(&self) -> usize {
        match self {
            Columns::Sectors { edges, .. } => edges.len().saturating_sub(1),
            Columns::Walls { names } => names.len(),
        }
    }
}

/// Cells of the developed wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WallGrid {
    /// Columns.
    pub columns: Columns,
    /// Heights of the edges of the rows [m], ascending: one more than there are rows.
    pub z: Vec<f64>,
    /// Static height of the surface [m].
    pub surface: f64,
}

impl WallGrid {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.z.len().saturating_sub(1)
    }

    /// Number of cells: a value a cell, row by row from the base.
    pub fn cells(&self) -> usize {
        self.rows() * self.columns.count()
    }
}

/// A value in each cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CellMap {
    /// Id: `plastic_strain`, `utilisation`, `crack_width`, `bar_stress`, `bar_plastic_strain`, `separation`.
    pub id: String,
    /// Title, with the face or layer where there are several.
    pub title: String,
    /// Dimension of the values.
    pub dimension: Dimension,
    /// Values, row by row from the base.
    pub values: Vec<f64>,
    /// Value at which something happens (yield: utilisation 1), where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mark: Option<f64>,
    /// Description, one sentence.
    pub note: String,
}

/// A crack in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crack {
    /// Number of the cell.
    pub cell: usize,
    /// Direction of the crack (along it, not its normal): angle from the hoop direction towards the top [rad].
    pub angle: f64,
    /// Width now [m].
    pub width: f64,
    /// Largest width so far [m].
    pub largest: f64,
}

/// All cracks of a face at one time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CrackPicture {
    /// Reason for the time (`largest base moment`).
    pub title: String,
    /// Face or layer (`inner face`).
    pub face: String,
    /// Time [s].
    pub time: f64,
    /// At most two a cell.
    pub cracks: Vec<Crack>,
}

/// One axis of a loop.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoopAxis {
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
}

/// Two quantities over each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loop {
    /// Id: `moment_curvature_theta_0`, `shear_displacement`, …
    pub id: String,
    /// Title, with the place.
    pub title: String,
    /// Abscissa.
    pub x: LoopAxis,
    /// Ordinate.
    pub y: LoopAxis,
    /// Points in the order of time.
    pub points: Vec<[f64; 2]>,
}

/// Energies over time [J].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// Times [s].
    pub time: Vec<f64>,
    /// Work of all loads.
    pub input: Vec<f64>,
    /// Kinetic.
    pub kinetic: Vec<f64>,
    /// Work done on the internal forces: stored and dissipated.
    pub internal: Vec<f64>,
    /// Dissipated by viscous damping.
    pub damping: Vec<f64>,
    /// Dissipated by the time integration.
    pub numerical: Vec<f64>,
    /// Dissipated by the materials; a part of `internal`.
    pub hysteretic: Vec<f64>,
    /// Largest |residual| of the balance over the largest energy.
    pub error: f64,
}

/// A number of the computation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Count {
    /// Name.
    pub label: String,
    /// How many.
    pub value: f64,
    /// Dimension.
    pub dimension: Dimension,
}
