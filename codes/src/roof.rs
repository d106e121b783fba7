//! Roofs that the liquid carries.

use tank::units::Dimension::{Length, Mass};
use tank::{RoofKind, Tank};

use crate::sheet::{Sheet, with_unit};

/// What the procedures assume of a floating roof; none for another.
pub(crate) fn assumption(tank: &Tank) -> Option<String> {
    if tank.roof.kind != RoofKind::Floating {
        return None;
    }
    let rim = match tank.roof.rim > 0.0 {
        true => {
            format!(" The freeboard is counted from its rim, {} above the liquid.", with_unit(tank.roof.rim, Length))
        }
        false => String::new(),
    };
    Some(format!(
        "The floating roof hangs on the liquid, not on the wall: it displaces its own mass of liquid below the level of fill_height, so the \
         mass of the liquid contains it. The wave is that of a free surface; a floating roof damps it.{rim}"
    ))
}

/// The line of its mass, for information.
pub(crate) fn line(sheet: &mut Sheet, tank: &Tank) {
    if tank.roof.afloat > 0.0 {
        let name = "mass of the floating roof, within the mass of the liquid";
        sheet.input("m_f", name, tank.roof.afloat, Mass, "tank.roof");
    }
}
