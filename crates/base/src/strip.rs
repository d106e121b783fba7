//! The strip: plate, ground, edge of the wall.

use crate::edge::Edge;
use crate::element::Cubics;
use crate::error::{BaseError, positive};
use crate::mesh;
use crate::plate::Bands;

/// Elements of the plate outside the wall.
const OUTSIDE: usize = 4;

/// In plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plan {
    /// A straight strip, one of many side by side.
    Strip,
    /// The whole round plate under an uplift that is the same all around. Elastic.
    Round,
}

/// What holds the rim in its plane and in rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rim {
    /// The edge of the wall.
    Wall(Edge),
    /// Free to move inwards and to turn.
    Hinged,
    /// Free to move inwards, held in rotation.
    Clamped,
}

/// A bottom plate that can be lifted at its rim.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    pub(crate) bands: Bands,
    pub(crate) modulus: f64,
    pub(crate) pressure: f64,
    pub(crate) rim: Rim,
    pub(crate) plan: Plan,
    /// Nodes from the centre outwards [m].
    pub(crate) nodes: Vec<f64>,
    /// What the lengths of the elements between them give.
    pub(crate) cubics: Vec<Cubics>,
    /// Number of them outside the wall.
    pub(crate) outside: usize,
}

impl Strip {
    /// * `length` from the rim to the centre, where the plate can neither move sideways nor turn [m]
    /// * `modulus` k of the ground [N/m³]
    /// * `pressure` p of the liquid on the plate [Pa]
    ///
    /// Errors: parameters without meaning; a round plate with a yield stress.
    pub fn new(
        bands: Bands,
        rim: Rim,
        length: f64,
        modulus: f64,
        pressure: f64,
        plan: Plan,
    ) -> Result<Strip, BaseError> {
        bands.check()?;
        positive("radius", length)?;
        positive("modulus of the ground", modulus)?;
        positive("pressure on the plate", pressure)?;
        if let Rim::Wall(edge) = &rim {
            positive("thickness of the wall", edge.thickness)?;
        }
        let alike = bands.rim().yield_stress.is_some() == bands.at(f64::INFINITY).yield_stress.is_some();
        if !alike {
            return Err(BaseError::Parameter {
                name: "yield stress of the plate",
                value: f64::NAN,
                allowed: "one for the annular and the sketch plates, or for none",
            });
        }
        let yields = bands.rim().yield_stress.or(bands.at(f64::INFINITY).yield_stress);
        if let (Plan::Round, Some(value)) = (plan, yields) {
            return Err(BaseError::Parameter {
                name: "yield stress of the plate",
                value,
                allowed: "none for a round plate, which is elastic",
            });
        }
        let nodes = places(&bands, modulus, length, (1.0, mesh::FINE));
        Ok(Strip { cubics: cubics(&nodes), nodes, outside: 0, bands, modulus, pressure, rim, plan })
    }

    /// The same strip with a plate that projects outside the wall [m]; it lies on the ground without liquid on it.
    #[must_use]
    pub fn projecting(mut self, projection: f64) -> Strip {
        let count = if projection > 0.0 { OUTSIDE } else { 0 };
        let rim = self.length();
        self.nodes.truncate(self.nodes.len() - self.outside);
        self.nodes.extend((1..=count).map(|i| rim + projection * i as f64 / count as f64));
        self.outside = count;
        self.cubics = cubics(&self.nodes);
        self
    }

    /// The same strip with all elements shorter by a factor; before [`Strip::projecting`].
    #[must_use]
    pub fn refined(self, factor: f64) -> Strip {
        self.spaced(factor, mesh::FINE)
    }

    /// The same with elements that stay short up to the distance `fine` from the rim alone [m].
    #[must_use]
    pub(crate) fn spaced(self, factor: f64, fine: f64) -> Strip {
        let nodes = places(&self.bands, self.modulus, self.length(), (factor, fine));
        Strip { cubics: cubics(&nodes), nodes, ..self }
    }

    /// Thickness of the plate under the wall [m].
    pub(crate) fn thickness(&self) -> f64 {
        self.bands.rim().thickness
    }

    /// Pressure of the liquid on the plate [Pa].
    pub fn pressure(&self) -> f64 {
        self.pressure
    }

    /// Length from the centre to the rim [m].
    pub fn length(&self) -> f64 {
        self.nodes[self.nodes.len() - 1 - self.outside]
    }

    /// The same strip under another pressure on the plate [Pa]; the wall keeps its own.
    ///
    /// Errors: a pressure that is not positive.
    pub fn under(&self, pressure: f64) -> Result<Strip, BaseError> {
        Ok(Strip { pressure: positive("pressure on the plate", pressure)?, ..self.clone() })
    }
}

fn cubics(nodes: &[f64]) -> Vec<Cubics> {
    nodes.windows(2).map(|ends| Cubics::new(ends[1] - ends[0])).collect()
}

fn places(bands: &Bands, modulus: f64, length: f64, widths: (f64, f64)) -> Vec<f64> {
    let mut nodes = mesh::nodes(bands, modulus, length, widths);
    nodes.iter_mut().for_each(|x| *x = length - *x);
    nodes.reverse();
    nodes
}
