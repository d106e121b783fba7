//! Observables: linear functionals of the unknowns.

use results::Channel;
use results::channel::OnWall;

/// A scalar output y(t) = d·x(t) + a·ẍ_total(t) + b a_g(t), where x are the unknowns relative to the ground and
/// ẍ_total = ẍ + ι a_g their absolute acceleration.
///
/// Wall displacements and stresses use `displacement` only; pressures and base reactions `absolute_acceleration` and
/// `ground_acceleration`. With m = 0 pressures also use `displacement` (the surface sinks when the wall bulges), and axial
/// stresses the accelerations (the wall's weight within an element).
/// Vectors have the length of the model's unknowns; an empty vector stands for zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Channel of y.
    pub channel: Channel,
    /// Number of its place on a line over the height; none for a scalar of the tank.
    pub place: Option<usize>,
    /// Coefficients d.
    pub displacement: Vec<f64>,
    /// Coefficients a.
    pub absolute_acceleration: Vec<f64>,
    /// Coefficient b of the ground acceleration: parts that move rigidly with the ground and are not unknowns, such as the
    /// clamped edge of the wall, rigid side walls or, with vertical motion, the bottom.
    pub ground_acceleration: f64,
    /// Value in the static state (hydrostatic pressure and self-weight), 0 if it has none.
    pub static_value: f64,
    /// Which modes count.
    pub modes: ModeSelection,
    /// Unknowns that move with every mode, also those that `modes` leaves out, with their coefficients: the rim of a wall that moves up and down.
    pub rim: Vec<(usize, f64)>,
    /// Where around the tank it is, of an internal force.
    pub turn: Option<Turn>,
}

/// Factors on the amplitude of harmonic 1 at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Under motion along x: cos θ, or sin θ of a quantity that is odd about the plane of shaking.
    pub along: f64,
    /// Under motion along y, the same turned by 90°: sin θ or −cos θ.
    pub across: f64,
}

impl Turn {
    /// Turn for a quantity of the wall at θ [rad].
    pub fn of(what: OnWall, theta: f64) -> Turn {
        let (sine, cosine) = theta.sin_cos();
        match what {
            OnWall::Shear | OnWall::Twist => Turn { along: sine, across: -cosine },
            _ => Turn { along: cosine, across: sine },
        }
    }
}

impl Probe {
    /// An empty probe of `channel`.
    pub fn new(channel: Channel) -> Probe {
        Probe {
            channel,
            place: None,
            displacement: Vec::new(),
            absolute_acceleration: Vec::new(),
            ground_acceleration: 0.0,
            static_value: 0.0,
            modes: ModeSelection::All,
            rim: Vec::new(),
            turn: None,
        }
    }

    /// Name that no other probe of a model has: two places of a line may be at one height, on both sides of a joint.
    pub fn key(&self) -> String {
        match self.place {
            Some(place) => format!("{}[{place}]", self.channel.id()),
            None => self.channel.id(),
        }
    }
}

/// Which modes count for a probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeSelection {
    /// All computed modes, plus the missing mass.
    All,
    /// The first n sloshing modes only (wave heights: more modes chase the logarithmic corner singularity).
    FirstSloshing(usize),
}

/// Probes along the height that together make an envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeLine {
    /// Output.
    pub what: OnWall,
    /// Heights [m], ascending.
    pub z: Vec<f64>,
    /// One probe a height.
    pub probes: Vec<Probe>,
}

impl ProbeLine {
    /// The probe of a place of the line.
    pub fn probe(what: OnWall, place: usize, z: f64) -> Probe {
        Probe { place: Some(place), ..Probe::new(Channel::At { what, z }) }
    }
}
