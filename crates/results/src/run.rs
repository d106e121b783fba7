//! A finished run of a finite-element engine, as `results.json` holds it.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::listed;
use tank::units::Dimension;

use crate::around::Around;
use crate::base_run::BaseRun;
use crate::channel::Channel;
use crate::directions::Directional;
use crate::fields::Fields;
use crate::modal::ModalPart;
use crate::nonlinear::{End, Event, EventKind, Nonlinear};
use crate::part::Part;

/// Id of the first engine's column in the comparison, the reference of all ratios.
pub const FE: &str = "fe";

listed! {
    /// A finite-element engine.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum EngineId {
        /// Id in input and results.
        id: &'static str,
        /// Name within sentences ("the nonlinear run").
        name: &'static str,
        /// Title of its column in the comparison.
        title: &'static str,
        /// Id of its column in the comparison as a further engine; that of the first one is [`FE`].
        beside: &'static str,
        /// Prefix of its columns in `series.csv` as a further engine; empty for the first one.
        prefix: &'static str,
    }
    /// One Fourier harmonic at a time.
    Harmonic: "harmonic", "harmonic", "Finite elements, time history", "fe-harmonic", "harmonic_";
    /// Three-dimensional elements.
    Solid: "solid", "three-dimensional", "Finite elements in three dimensions, time history", "fe-solid", "solid_";
    /// Walls that yield and crack, in large rotations.
    Nonlinear: "nonlinear", "nonlinear", "Finite elements, nonlinear, time history", "fe-nonlinear", "nonlinear_";
}

impl EngineId {
    /// Short label of its column in the comparison as the run `number` from 0.
    pub fn label(self, number: usize) -> &'static str {
        match (number, self) {
            (0, _) => "Finite elements",
            (_, EngineId::Harmonic) => "Harmonic elements",
            (_, EngineId::Solid) => "3-D elements",
            (_, EngineId::Nonlinear) => "Nonlinear elements",
        }
    }

    /// Class of the colour and dash of its column as the run `number` from 0.
    pub fn figure_key(self, number: usize) -> &'static str {
        match (number, self) {
            (0, _) => "k-fe",
            (_, EngineId::Harmonic) => "k-other",
            (_, EngineId::Solid) => "k-fe-solid",
            (_, EngineId::Nonlinear) => "k-fe-nonlinear",
        }
    }

    /// Id of its column in the comparison as the run `number` from 0.
    pub fn column(self, number: usize) -> &'static str {
        match number {
            0 => FE,
            _ => self.beside(),
        }
    }
}

/// A finished run of an engine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Which engine.
    pub engine: EngineId,
    /// How it ended.
    pub end: End,
    /// Whether something is missing because the user stopped it: the rest of the histories, the second mesh, pictures.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub incomplete: bool,
    /// End of the record [s] where the run goes on with free vibration after it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_end: Option<f64>,
    /// Mesh and unknowns, as label → text ("liquid elements (r × z)" → "5 × 8, quadratic").
    pub mesh: Vec<Labelled>,
    /// Coupled modes of all computed harmonics.
    pub modes: Vec<Mode>,
    /// Response to horizontal motion mode by mode, of the linear engines.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub modal: Vec<ModalPart>,
    /// Height of their hoop stresses [m]: where that of the wall on a base that is held is largest, up to the surface at rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hoop_height: Option<f64>,
    /// Time integration, damping and number of modes, as label → text.
    pub integration: Vec<Labelled>,
    /// Damping ratios that result at the modes with more than 1 % of the mass (Rayleigh only).
    pub damping_table: Vec<DampingRow>,
    /// Estimated discretisation error by quantity id, relative, by Richardson's extrapolation from a second mesh.
    pub mesh_error: BTreeMap<String, f64>,
    /// Balance of masses, as label → relative error.
    pub mass_balance: Vec<Balance>,
    /// Energy balance of the direct integration; absent for modal integration.
    pub energy: Option<EnergyBalance>,
    /// Envelopes over the height at θ = 0.
    pub envelopes: Vec<Envelope>,
    /// Histories in `series.csv`.
    pub histories: Vec<SeriesInfo>,
    /// Extremes under two horizontal components; empty with one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<Directional>,
    /// What it found on the subjects that its tank has.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Part>,
    /// The run with a base that rocks and slides, of an unanchored tank that lifts or slides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<BaseRun>,
    /// Limits of validity and the values found.
    pub limits: Vec<Limit>,
    /// First yield, first crack, first separation and the like, by time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<Event>,
    /// Fields of the three-dimensional engine for pictures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fields: Option<Fields>,
    /// Response of an imperfect wall by waves around the tank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub around: Option<Around>,
    /// State of the wall, of the nonlinear engine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nonlinear: Option<Nonlinear>,
}

impl Run {
    /// An empty completed run of an engine.
    pub fn new(engine: EngineId) -> Run {
        Run {
            engine,
            end: End::Completed,
            incomplete: false,
            record_end: None,
            mesh: Vec::new(),
            modes: Vec::new(),
            modal: Vec::new(),
            hoop_height: None,
            integration: Vec::new(),
            damping_table: Vec::new(),
            mesh_error: BTreeMap::new(),
            mass_balance: Vec::new(),
            energy: None,
            envelopes: Vec::new(),
            histories: Vec::new(),
            directions: Vec::new(),
            parts: Vec::new(),
            base: None,
            limits: Vec::new(),
            events: Vec::new(),
            fields: None,
            around: None,
            nonlinear: None,
        }
    }

    /// What it found on a subject.
    pub fn part(&self, id: &str) -> Option<&Part> {
        self.parts.iter().find(|part| part.id == id)
    }

    /// Whether the liquid has left the wall.
    pub fn parted(&self) -> bool {
        self.events.iter().any(|e| e.kind == EventKind::Separation)
    }
}

/// A label and its text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Labelled {
    /// Label.
    pub label: String,
    /// Text.
    pub text: String,
}

/// A coupled mode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mode {
    /// Circumferential harmonic m; 1 for a plane strip's antisymmetric modes.
    pub harmonic: u32,
    /// Axial wave number of a wall mode (half waves over the height), where the engine counts it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axial: Option<u32>,
    /// `sloshing` or `structural`.
    pub kind: String,
    /// Number within harmonic and kind, from 1.
    pub number: usize,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Period [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Participation factor of the M-normalised mode [√kg].
    pub participation: f64,
    /// Effective mass in the direction of shaking [kg].
    pub effective_mass: f64,
    /// Height of the effective mass above the base [m], wall pressure only; 0 if the effective mass vanishes.
    pub effective_height: f64,
    /// Shape: radial displacement of the wall over the height, and surface elevation over the radius, scaled to max 1.
    pub shape: ModeShape,
}

/// Shape of a mode at θ = 0.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModeShape {
    /// Heights [m].
    pub z: Vec<f64>,
    /// Radial (outward) displacement of the wall.
    pub wall: Vec<f64>,
    /// Radii (or x from the centre) [m].
    pub r: Vec<f64>,
    /// Surface elevation.
    pub surface: Vec<f64>,
}

/// Damping that results at a mode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DampingRow {
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// `sloshing` or `structural`.
    pub kind: String,
    /// Resulting ratio.
    pub ratio: f64,
    /// Remark ("over-critical: the mode is switched off").
    pub note: String,
}

/// A balance that must close.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// Name.
    pub label: String,
    /// Relative error.
    pub error: f64,
}

/// Energy balance of a direct integration, each at the end of the run [J].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Work of the base motion.
    pub input: f64,
    /// Kinetic.
    pub kinetic: f64,
    /// Elastic and gravity potential.
    pub elastic: f64,
    /// Dissipated by damping.
    pub damping: f64,
    /// Largest |residual| over time, relative to the largest input.
    pub error: f64,
}

/// Envelope over the height at θ = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Envelope {
    /// Id: `pressure`, `hoop_stress`, `axial_membrane_stress`, `bending_stress`, `radial_displacement`.
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Heights [m], ascending.
    pub z: Vec<f64>,
    /// Static state (hydrostatic and self-weight).
    pub static_: Vec<f64>,
    /// Smallest seismic value over time.
    pub min: Vec<f64>,
    /// Largest seismic value over time.
    pub max: Vec<f64>,
}

/// A column of `series.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SeriesInfo {
    /// Column name (`wave_height_theta_0`, `base_shear`, …).
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Value of the static state (not contained in the column).
    pub static_value: f64,
    /// Largest absolute value of the history between and at samples.
    pub peak: f64,
    /// Time of the peak [s].
    pub time: f64,
}

impl SeriesInfo {
    /// The channel; none for a column that this version does not write.
    pub fn channel(&self) -> Option<Channel> {
        Channel::from_id(&self.id)
    }

    /// The series of a channel.
    ///
    /// * `static_value`: value of the static state
    /// * `peak`: largest absolute value, with its time [s]
    pub fn of(channel: Channel, static_value: f64, (peak, time): (f64, f64)) -> SeriesInfo {
        SeriesInfo {
            id: channel.id(),
            title: channel.title(),
            dimension: channel.dimension(),
            static_value,
            peak,
            time,
        }
    }
}

/// A limit of validity and whether it is kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Stable id (`wave_against_radius`, `wave_against_freeboard`, `suction`, `uplift_tension`, …).
    pub id: String,
    /// The tested quantity.
    pub name: String,
    /// Found.
    pub value: f64,
    /// Allowed.
    pub limit: f64,
    /// Dimension of both.
    pub dimension: Dimension,
    /// Whether it is kept.
    pub holds: bool,
    /// Consequence, where and when.
    pub note: String,
}
