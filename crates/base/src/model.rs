//! The base of a tank from its data.
//!
//! The ground under the rim is that of `tank.foundation` or of `tank.bottom`, else an assumption that is named. As nobody knows it well,
//! results are also given for a third and for three times the modulus.

use tank::{Bottom, Case, FoundationKind, STANDARD_GRAVITY, Shape};

use crate::curve::Curve;
use crate::edge::Edge;
use crate::error::BaseError;
use crate::ground::{Soil, subgrade_modulus};
use crate::halves::side_by_side;
use crate::march::Point;
use crate::mesh;
use crate::plate::{Bands, Plate};
use crate::rocking::Rocking;
use crate::strip::{Plan, Rim, Strip};
use crate::warp::{Top, Warping};

/// Modulus of soil without data [N/m³]: compacted gravel.
pub const SOIL: f64 = 1e8;
/// Modulus of concrete under the rim [N/m³].
pub const CONCRETE: f64 = 1e10;

/// Largest bottom pressure of the motion over that at rest that the curves follow.
pub const FOLLOWED: f64 = 0.5;
/// Shares of the pressure at rest on the plate for which curves are kept, that at rest first: suction lowers it.
const LEVELS: [f64; 4] = [1.0, 1.0 + FOLLOWED, 0.75, 1.0 - FOLLOWED];

/// Where the modulus of the ground comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It is given.
    Given,
    /// From the velocity of shear waves, after Vesic.
    Waves,
    /// It is assumed for this kind of foundation.
    Assumed(FoundationKind),
}

/// Why a tank has no such base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The tank is not a cylinder.
    Cylinder,
    /// No bottom plate is given.
    Plate,
    /// The bottom is not a metal plate: it turns as a whole.
    Metal,
}

/// The base of a cylinder on its bottom plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Base {
    bands: Bands,
    edge: Edge,
    projection: f64,
    /// Radius R [m].
    pub radius: f64,
    /// Pressure of the liquid on the plate at rest [Pa].
    pub pressure: f64,
    /// Weight w_t of wall and roof [N/m].
    pub weight: f64,
    /// Modulus of the ground under the rim [N/m³].
    pub modulus: f64,
    /// Its origin.
    pub origin: Origin,
    /// Yield strength of the lowest course [Pa], where it is known.
    pub wall_yield: Option<f64>,
    /// What resists the waves of the foot; none of one that stays plane.
    pub(crate) warping: Option<Warping>,
    /// Whether strips that rock have elements twice as long.
    long: bool,
}

impl Base {
    /// The base of a tank at its fill; plates and wall as built.
    ///
    /// Errors: a tank without such a base.
    pub fn of(case: &Case) -> Result<Base, Missing> {
        Base::built(case, false, STANDARD_GRAVITY)
    }

    /// The base of a tank at its fill as the codes see it: plates and wall less corrosion, the weight that of the whole thickness, in the
    /// gravity of the case.
    ///
    /// Errors: a tank without such a base.
    pub fn net(case: &Case) -> Result<Base, Missing> {
        Base::built(case, true, case.gravity)
    }

    fn built(case: &Case, net: bool, gravity: f64) -> Result<Base, Missing> {
        let tank = &case.tank;
        let Shape::Cylinder { radius } = tank.shape else { return Err(Missing::Cylinder) };
        let bottom = tank.bottom.as_ref().ok_or(Missing::Plate)?;
        if !bottom.material.is_metal() {
            return Err(Missing::Metal);
        }
        let bands = bands(bottom, if net { bottom.corrosion } else { 0.0 });
        let wall = &tank.courses[0];
        let gradient = case.liquid.density * gravity;
        let pressure = gradient * case.liquid.fill_height;
        let (modulus, origin) = ground(case, bands.rim());
        Ok(Base {
            edge: Edge {
                radius,
                thickness: if net { wall.net_thickness() } else { wall.thickness },
                young_modulus: wall.material.youngs_modulus,
                poisson_ratio: wall.material.poisson_ratio,
                pressure,
                gradient,
            },
            bands,
            projection: bottom.projection,
            radius,
            pressure,
            weight: tank.weight_above(0.0) * gravity / (std::f64::consts::TAU * radius),
            modulus,
            origin,
            wall_yield: wall.material.yield_strength,
            warping: Warping::built(case, net, gravity),
            long: false,
        })
    }

    /// The same base with plates that do not yield.
    #[must_use]
    pub fn elastic(self) -> Base {
        Base { bands: self.bands.elastic(), ..self }
    }

    /// The same base on another ground [N/m³].
    #[must_use]
    pub fn on(&self, modulus: f64) -> Base {
        Base { modulus, ..self.clone() }
    }

    /// The same base whose strips rock on elements twice as long, which change their forces by less than 1 %.
    #[must_use]
    pub fn with_long_elements(self) -> Base {
        Base { long: true, ..self }
    }

    /// The same base with a foot that stays plane.
    #[must_use]
    pub fn plane(self) -> Base {
        Base { warping: None, ..self }
    }

    /// The same base with liquid that does not pull on the wall where its pressure falls below that of the air.
    #[must_use]
    pub fn without_pull(self) -> Base {
        Base { warping: self.warping.map(Warping::without_pull), ..self }
    }

    /// What keeps the top edge of the wall round; `None` of a foot that stays plane.
    pub fn top(&self) -> Option<Top> {
        self.warping.as_ref().map(Warping::top)
    }

    /// The foot in a sentence.
    pub fn foot(&self) -> &'static str {
        match self.top() {
            None => "The foot of the wall stays plane.",
            Some(Top::Round) => {
                "The roof keeps the rim of the wall round (`tank.roof.holds`): its foot stays plane but for the membrane of the wall."
            }
            Some(Top::Rings) => "The rim of the wall is free but for `tank.rings`: its foot warps.",
            Some(Top::Free) => "The rim of the wall is free (`tank.roof.holds`): its foot warps.",
        }
    }

    /// Most uplift that a rotation gives, over ψ R: twice that of a plane foot that turns about its toe, and more of one that warps.
    pub fn rise(&self) -> f64 {
        if matches!(self.top(), None | Some(Top::Round)) { 2.0 } else { 3.0 }
    }

    /// Whether the plate has a yield stress.
    pub fn yields(&self) -> bool {
        self.bands.rim().yield_stress.is_some()
    }

    /// The plate under the wall.
    pub fn plate(&self) -> &Plate {
        self.bands.rim()
    }

    /// The plate at a distance from the wall [m].
    pub(crate) fn plate_at(&self, distance: f64) -> &Plate {
        self.bands.at(distance)
    }

    /// Radial stiffness k₁₁ of the wall's edge [N/m²].
    pub(crate) fn edge_stiffness(&self) -> f64 {
        self.edge.stiffness().k[0][0]
    }

    /// Thickness of the lowest course [m].
    pub fn wall_thickness(&self) -> f64 {
        self.edge.thickness
    }

    /// Largest von Mises stress of the lowest course at the joint, in a state of the strips, whose wall is elastic [Pa]. Beyond the
    /// yield strength the joint turns in the wall, too, and the plate's part of the plastic rotation is smaller than that of the strips.
    pub fn wall_stress(&self, point: &Point) -> f64 {
        self.edge.stress([point.axial_force, point.rim_moment, point.hold_down], point.rotation)
    }

    /// A strip under a pressure on the plate [Pa], which the foot of the wall has, too: liquid that moves widens it and turns it.
    ///
    /// Errors: data without meaning.
    pub fn strip(&self, pressure: f64) -> Result<Strip, BaseError> {
        Ok(self.bare(pressure)?.projecting(self.projection))
    }

    /// The same with elements twice as long, which stay short only where a plate lifts that yields: over the width of the mechanism with
    /// two hinges, l = 3.41 √(M_p/p), and as much again for membrane force and soft ground.
    pub(crate) fn coarse_strip(&self, pressure: f64) -> Result<Strip, BaseError> {
        let mechanism =
            |plate: &Plate| plate.plastic_moment().map(|m| crate::closed::MECHANISM * (m / pressure).sqrt());
        let fine = mechanism(self.bands.rim()).map_or(f64::INFINITY, |l| 2.0 * l).min(mesh::FINE);
        Ok(self.bare(pressure)?.spaced(0.5, fine).projecting(self.projection))
    }

    fn bare(&self, pressure: f64) -> Result<Strip, BaseError> {
        let rim = Rim::Wall(Edge { pressure, ..self.edge });
        Strip::new(self.bands.clone(), rim, self.radius, self.modulus, pressure, Plan::Strip)
    }

    /// The base with a rim that is known between two displacements [m]; with `suction` also under lower pressures on the plate.
    ///
    /// Errors: no equilibrium.
    pub fn rocking(&self, from: f64, to: f64, suction: bool) -> Result<Rocking, BaseError> {
        let levels = if suction { &LEVELS[..] } else { &LEVELS[..1] };
        let curves = side_by_side(levels, |level| {
            let pressure = level * self.pressure;
            let strip = if self.long { self.coarse_strip(pressure)? } else { self.strip(pressure)? };
            Ok((pressure, Curve::of(&strip, self.weight, from, to)?))
        })?;
        Ok(Rocking::new(self.radius, self.weight, curves)?.warping(self.warping.clone()))
    }
}

/// Plates less `corrosion` [m].
fn bands(bottom: &Bottom, corrosion: f64) -> Bands {
    let material = &bottom.material;
    let plate = |thickness: f64| Plate {
        thickness: thickness - corrosion,
        young_modulus: material.youngs_modulus,
        poisson_ratio: material.poisson_ratio,
        yield_stress: material.yield_strength,
    };
    match (bottom.sketch, bottom.width) {
        (Some(sketch), Some(width)) => Bands::annular(plate(bottom.thickness), width, plate(sketch)),
        _ => Bands::uniform(plate(bottom.thickness)),
    }
}

fn ground(case: &Case, plate: &Plate) -> (f64, Origin) {
    let foundation = case.tank.foundation.as_ref();
    let bottom = case.tank.bottom.as_ref();
    let given = foundation.and_then(|f| f.stiffness).or(bottom.and_then(|b| b.subgrade_modulus));
    if let Some(k) = given {
        return (k, Origin::Given);
    }
    let kind = foundation.map_or(FoundationKind::Soil, |f| f.kind);
    if let (Some(f), FoundationKind::Soil) = (foundation, kind)
        && let Some(velocity) = f.shear_wave_velocity
        && let Ok(k) = subgrade_modulus(Soil::of_waves(velocity, f.soil_density, f.soil_poisson_ratio), plate)
    {
        return (k, Origin::Waves);
    }
    let k = if kind == FoundationKind::Soil { SOIL } else { CONCRETE };
    (k, Origin::Assumed(kind))
}
