//! Details of construction that the codes ask for and no number describes: answers of the tank file.

use crate::words;
use serde::{Deserialize, Serialize};

words! {
    /// Whether something is there.
    pub Presence {
        /// There is none.
        None = "none",
        /// There is; what the code requires of it is not implemented.
        Present = "present",
    }
}

words! {
    /// Snow on a roof.
    pub Snow {
        /// No snow falls there.
        None = "none",
        /// The mass of the roof contains the share of the code: 10 % of the balanced design snow load in API 650, ψ_E times the snow load in
        /// EN 1998-1.
        Included = "included",
    }
}

words! {
    /// What lies between the bottom plate under the shell and a foundation of concrete.
    pub ShellSupport {
        /// Shims and grout.
        Grouted = "grouted",
        /// Fibreboard or another pad.
        Padding = "padding",
        /// Butt-welded plates directly on the concrete.
        ButtWelded = "butt_welded",
        /// Shims without grout.
        Shims = "shims",
    }
}

words! {
    /// Weld between the plates under the shell.
    pub Joint {
        /// Butt weld.
        Butt = "butt",
        /// Lap weld.
        Lap = "lap",
    }
}

/// Connections through the bottom.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BottomConnections {
    /// There are none.
    None,
    /// Least distance from the inside of the shell to the edge of a reinforcement [m].
    Within(f64),
}

/// Answers about the construction; none where the file does not give one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Details {
    /// Equipment within the liquid that wall or bottom carry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub internals: Option<Presence>,
    /// Structures that are connected to the tank, such as walkways.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adjacent_structures: Option<Presence>,
    /// Snow on the roof.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub snow: Option<Snow>,
    /// What the shell stands on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shell_support: Option<ShellSupport>,
    /// Weld between the plates under the shell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub annular_weld: Option<Joint>,
    /// Leg of each of the two fillet welds between shell and bottom [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shell_weld: Option<f64>,
    /// Connections through the bottom.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bottom_connections: Option<BottomConnections>,
    /// Design temperature of wall and bottom [°C]; the materials have their values at it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub design_temperature: Option<f64>,
}

impl Details {
    /// Whether the file gives no answer.
    pub fn is_empty(&self) -> bool {
        *self == Details::default()
    }
}
