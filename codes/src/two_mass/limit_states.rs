//! Limit states of concrete and metal tanks that the codes of the chain ask for, and whether each applies.
//!
//! The chain gives actions. Resistances of sections follow other codes (ACI 350, IS 3370, IS 456), which are not implemented: those limit
//! states stay open.

use tank::assessment::Requirement::{self, NotApplicable, NotImplemented};
use tank::case::Case;
use tank::{Shape, Support};

/// Resistance of a section, or of the base: asked for and not implemented.
pub(crate) fn open(_case: &Case) -> Requirement {
    NotImplemented
}

/// Limit states of walls of concrete alone.
pub(crate) fn of_concrete(case: &Case) -> Requirement {
    match case.tank.is_metal() {
        true => NotApplicable("the wall is of metal; the clause is for concrete".into()),
        false => NotImplemented,
    }
}

/// A tank that is not held down.
pub(crate) fn unanchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => NotApplicable("the tank is anchored".into()),
        Support::Unanchored => NotImplemented,
    }
}

/// Anchors of a tank that is held down.
pub(crate) fn anchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored if case.tank.staging.is_some() => {
            NotApplicable("the container is fixed to its staging".into())
        }
        Support::Anchored => NotImplemented,
        Support::Unanchored => NotApplicable("the tank is unanchored".into()),
    }
}

/// Members of a staging.
pub(crate) fn on_staging(case: &Case) -> Requirement {
    match case.tank.staging {
        Some(_) => NotImplemented,
        None => NotApplicable("the tank stands on the ground".into()),
    }
}

/// Limit states of metal shells alone.
pub(crate) fn of_shells(case: &Case) -> Requirement {
    match (case.tank.is_metal(), case.tank.shape) {
        (true, Shape::Cylinder { .. }) => NotImplemented,
        (true, Shape::Rectangle { .. }) => {
            NotApplicable("the walls of a box bend as plates; the clause is for cylinders".into())
        }
        (false, _) => NotApplicable("the clause is for metal shells; the wall is not metal".into()),
    }
}

/// Walls that bend: of concrete, and those of a box.
pub(crate) fn of_plates(case: &Case) -> Requirement {
    match (case.tank.is_metal(), case.tank.shape) {
        (true, Shape::Cylinder { .. }) => NotApplicable("the wall is a metal shell and carries membrane forces".into()),
        _ => NotImplemented,
    }
}
