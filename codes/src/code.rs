//! A code as the judge of a run of an engine knows it: which limit states the run has to satisfy under it, and their capacities.
//!
//! Each code implements [`Code`] in its folder; [`crate::time_history`] knows no other.

use tank::Course;
use tank::assessment::{Check, CheckStatus};
use tank::case::{Case, Site};

use crate::limit_state::LimitStateDef;
use crate::procedure::Procedure;
use crate::record_set::standard::Standard;
use crate::sheet::Sheet;

/// A limit state of a run with its place in the list.
pub type Placed = (u8, LimitStateDef);

/// A code whose capacities judge a run.
pub trait Code: Sync {
    /// Its procedures.
    fn procedures(&self) -> &'static [&'static dyn Procedure];
    /// The edition in force, whose limit states a run has to answer that decides without it.
    fn in_force(&self) -> &'static dyn Procedure;
    /// Whether the site gives its data.
    fn named(&self, site: &Site) -> bool;
    /// The limit states that a run has to satisfy under it, with their places in the list.
    fn of_run(&self) -> &'static [Placed];
    /// How such a run answers limit states of the edition in force that its own list does not have under the same id. It leaves all
    /// others open.
    fn answers(&self) -> &'static [(&'static str, Answer)];
    /// Checks of the edition in force that are the same under every action.
    fn apart(&self, _case: &Case) -> Vec<Check> {
        Vec::new()
    }
    /// Whether a tank stated anchored needs anchors also where nothing pulls at them.
    fn always_anchors(&self) -> bool {
        false
    }
    /// Its limits of the wall of a metal cylinder of this radius [m].
    fn wall<'a>(&self, case: &'a Case, radius: f64) -> Vec<WallLimit<'a>>;
    /// Friction under the base, or why there is none.
    fn friction(&self, case: &Case) -> Result<Friction, Open>;
    /// Largest plastic rotation of the joint of a bottom plate that lifts [rad], or why the code does not limit it: a clause.
    fn joint_rotation(&self) -> Result<f64, &'static str>;
    /// Bearing resistance of the ground [Pa], or the path of the missing input; none where a run is not judged by it.
    fn bearing_resistance(&self, _case: &Case) -> Option<Result<f64, &'static str>> {
        None
    }
    /// Factor on the displacement of isolators; none where a run is not judged by it.
    fn isolator_factor(&self) -> Option<f64> {
        None
    }
    /// Rules for sets of records.
    fn record_rules(&self) -> Standard;
    /// Whether the site asks for vertical motion.
    fn asks_vertical(&self, _site: &Site) -> bool {
        false
    }
    /// What it asks of such an analysis, a sentence each.
    fn notes(&self, _case: &Case) -> Vec<String> {
        Vec::new()
    }
}

/// How a run that decides alone answers a limit state of a code.
#[derive(Clone, Copy, Debug)]
pub enum Answer {
    /// The run checks the limit state of its own list that has this id.
    Run(&'static str),
    /// The answer of the code holds for the run too: the action does not change it.
    Code,
    /// The run leaves it open. It has an id of its own, because another code uses the same one.
    Open(LimitStateDef),
}

/// Adds the lines of a limit at a course under an interior pressure [Pa], on which that of compression alone depends. Returns the limit [Pa].
pub type Limit<'a> = Box<dyn Fn(&mut Sheet, &Course, f64) -> f64 + 'a>;

/// A limit of the wall.
pub struct WallLimit<'a> {
    /// Limit state, with the name of its check.
    pub state: LimitStateDef,
    /// What it limits.
    pub stress: WallStress,
    /// Path of an input without which it is not known.
    pub missing: Option<String>,
    /// The limit.
    pub limit: Limit<'a>,
}

/// A stress of the wall that is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallStress {
    /// Equivalent membrane stress.
    Equivalent,
    /// Range of the equivalent stress of a face at the base.
    RangeAtBase,
    /// Hoop stress below the surface at rest.
    Hoop,
    /// Axial compression, whose limit depends on the interior pressure of the instant.
    Compression,
}

/// Friction under the base.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// Id of the check.
    pub id: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Coefficient.
    pub coefficient: f64,
    /// Clause.
    pub clause: &'static str,
}

/// Why nothing is compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// How the limit state ends.
    pub status: CheckStatus,
    /// Why.
    pub reason: String,
    /// Path of the missing input.
    pub input: Option<&'static str>,
}

/// Path of the yield strength of the first course without one.
pub(crate) fn without_strength(case: &Case) -> Option<String> {
    let course = case.tank.courses.iter().find(|c| c.material.yield_strength.is_none())?;
    Some(format!("materials.{}.yield_strength", course.material.name))
}
