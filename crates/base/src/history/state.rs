//! What is given to a run, and the state that a step moves on.

use super::body::Body;
use super::friction::Friction;
use super::modes::Modes;
use crate::anchors::{Bolts, Ring};
use crate::heave::{Heave, Lift};
use crate::law::Law;
use crate::waves::{Ovals, Waves};

/// What is given to a run.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    /// The body.
    pub body: &'a Body,
    /// The base; none holds the body upright.
    pub law: Option<&'a Law>,
    /// Anchors on it.
    pub ring: Option<&'a Ring>,
    /// The mass that the foot lifts; none lifts it without inertia.
    pub heave: Option<&'a Heave>,
    /// The rim that ovals in time; none follows at once, or stays round.
    pub waves: Option<&'a Waves>,
    /// Share η of the base's moment that is hysteretic.
    pub hysteretic: f64,
    /// Dashpot c_ψ of the closed base [N m s]; it opens with the contact.
    pub dashpot: f64,
    /// Friction; none keeps the body from sliding.
    pub friction: Option<Friction>,
    /// Rigid parts of the bottom pressure at the rim: per A [Pa s²/m] and per ψ̈ [Pa s²].
    pub rigid_pressure: [f64; 2],
    /// Time step [s].
    pub step: f64,
    /// Ground acceleration at each step [m/s²].
    pub ground: &'a [f64],
}

/// The state at the end of a step.
pub(super) struct State {
    pub modes: Modes,
    pub psi: [f64; 3],
    /// ψ̈ at the next instant, straight on from the last two [rad/s²].
    pub ahead: f64,
    pub slip: [f64; 3],
    /// Direction of the inertia force that friction balances, 0 while the body sticks.
    pub sliding: f64,
    /// Slips of the springs of the base.
    pub springs: Vec<f64>,
    /// Loss of the springs in the last step [J].
    pub lost: f64,
    /// Displacement, velocity and acceleration of the centre of the foot, and what presses on it.
    pub heave: [f64; 3],
    pub lift: Lift,
    /// Waves of a rim that ovals in time.
    pub ovals: Option<Ovals>,
    /// What the damping of the foot loses in the last step [J].
    pub damped: f64,
    /// Anchors, and their loss in the last step [J].
    pub bolts: Bolts,
    pub cost: f64,
    pub pressure: f64,
    /// Moment of the base, without and with its dashpot [N m].
    pub held: f64,
    pub moment: f64,
    /// Inertia force [N].
    pub shear: f64,
    /// s̈ at the instant of the forces [m/s²].
    pub slipping: f64,
    /// Slips of the springs along the ground, and their force [N].
    pub along: Vec<f64>,
    pub drag: f64,
    /// The dashpot along the ground in this step [N s/m], and its force [N].
    pub dashpot: f64,
    pub dashed: f64,
    /// Whether all of the bottom slides.
    pub slides: bool,
}

impl State {
    /// At rest.
    pub(super) fn at_rest(run: &Run<'_>) -> State {
        State {
            modes: Modes::new(run.body, run.step, run.rigid_pressure),
            psi: [0.0; 3],
            ahead: 0.0,
            slip: [0.0; 3],
            sliding: 0.0,
            springs: vec![0.0; run.law.map_or(0, |law| law.springs().len())],
            lost: 0.0,
            heave: [run.heave.map_or(0.0, Heave::rest), 0.0, 0.0],
            lift: Lift::default(),
            ovals: run.waves.map(Waves::at_rest),
            damped: 0.0,
            bolts: run.ring.map_or_else(Bolts::default, Ring::unstretched),
            cost: 0.0,
            pressure: 0.0,
            held: 0.0,
            moment: 0.0,
            shear: 0.0,
            slipping: 0.0,
            along: vec![0.0; run.friction.as_ref().map_or(0, |f| f.springs.len())],
            drag: 0.0,
            dashpot: 0.0,
            dashed: 0.0,
            slides: false,
        }
    }
}
