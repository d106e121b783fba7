//! The tank and its contents.

mod behaviour;
mod details;
mod family;
mod foundation;
mod isolators;
mod joint;
mod layers;
mod parts;
mod plane;
mod staging;
mod volume_change;

pub use behaviour::{
    Bar, BarBond, Behaviour, BiaxialEnvelope, Concrete, ConcreteLaw, Interlayer, SLOPE, STRESS, Softening, Steel,
};
pub use details::{BottomConnections, Details, Joint, Presence, ShellSupport, Snow};
pub use family::Family;
pub use foundation::{FRICTION, Foundation, FoundationKind, SoilLayer, Subsoil};
pub use isolators::{Bearing, Isolators};
pub use joint::WallBase;
pub use layers::{BarDirection, EQUIVALENT, Layer, LayerKind, Reinforcement};
pub use parts::{Attachment, Insulation, Pipes, RimSupport, Ring, Roof, RoofKind, SnowLoad};
pub use plane::PLANE_WALLS;
pub use staging::{Staging, StagingKind};
pub use volume_change::{VolumeChange, WallTemperature};

use crate::keys::{Density, Field, Force, Length, Limits, LineForce, Opt, Or, Stress, Whole, keys};
use crate::words;
use serde::{Deserialize, Serialize};

/// Plan shape of an upright tank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Shape {
    /// Circular cylinder.
    Cylinder {
        /// Inner radius R [m].
        radius: f64,
    },
    /// Rectangle, shaken along its length.
    Rectangle {
        /// Full inner length 2L in the direction of shaking [m].
        length: f64,
        /// Inner breadth across the direction of shaking [m]; 1 m for a strip.
        breadth: f64,
        /// True if this is a strip of a long tank (plane strain), results per metre of breadth.
        strip: bool,
    },
}

impl Shape {
    /// Inner radius of a cylinder [m].
    pub fn radius(self) -> Option<f64> {
        match self {
            Shape::Cylinder { radius } => Some(radius),
            Shape::Rectangle { .. } => None,
        }
    }

    /// R, or the half length L [m].
    pub fn half_length(self) -> f64 {
        match self {
            Shape::Cylinder { radius } => radius,
            Shape::Rectangle { length, .. } => length / 2.0,
        }
    }

    /// Plan area [m²].
    pub fn plan_area(self) -> f64 {
        match self {
            Shape::Cylinder { radius } => std::f64::consts::PI * radius * radius,
            Shape::Rectangle { length, breadth, .. } => length * breadth,
        }
    }
}

words! {
    /// Support of the wall.
    pub Support {
        /// Held down; the wall is clamped at its base.
        Anchored = "anchored",
        /// Resting on its bottom plate. The codes have their rules for uplift; `compare` lifts and, with friction, slides a cylinder on
        /// `tank.bottom` and `tank.foundation`.
        Unanchored = "unanchored",
    }
}

/// Material of a course, a layer or bars.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name in the input file.
    pub name: String,
    /// Family, where it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub family: Option<Family>,
    /// Young's modulus E [Pa].
    pub youngs_modulus: f64,
    /// Poisson's ratio ν [-].
    pub poisson_ratio: f64,
    /// Density ρ_s [kg/m³].
    pub density: f64,
    /// Yield strength f_y [Pa], needed by stability checks only.
    pub yield_strength: Option<f64>,
    /// Allowable design stress S_d [Pa] (API 650 table 5-2), needed by the API hoop check only.
    pub allowable_stress: Option<f64>,
    /// Behaviour beyond its elastic range (nonlinear engine).
    #[serde(default, skip_serializing_if = "Behaviour::is_elastic")]
    pub behaviour: Behaviour,
    /// Changes of volume at rest (nonlinear engine).
    #[serde(default, skip_serializing_if = "VolumeChange::is_none")]
    pub volume_change: VolumeChange,
}

/// A ring of the wall with constant thickness.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Course {
    /// Height [m].
    pub height: f64,
    /// Thickness s [m]; of a layered course that of the equivalent homogeneous wall.
    pub thickness: f64,
    /// Thickness that corrosion takes, an allowance or a measured loss [m]; always less than the thickness.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub corrosion: f64,
    /// Material; of a layered course that of the equivalent homogeneous wall.
    pub material: Material,
    /// Layers from inside to outside; empty where the course is of one material.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
}

/// Bottom plate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bottom {
    /// Thickness of the bottom plate under the shell (annular plate where there is one) [m].
    pub thickness: f64,
    /// Thickness that corrosion takes [m]; always less than the thickness.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub corrosion: f64,
    /// Width of the plate of this thickness, from the inside of the shell towards the centre [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Thickness of the plates within that width, as built [m]; the same corrosion takes from them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sketch: Option<f64>,
    /// Projection of the plate outside the wall [m].
    #[serde(default, skip_serializing_if = "is_zero")]
    pub projection: f64,
    /// Subgrade modulus of the ground under the wall [N/m³].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub subgrade_modulus: Option<f64>,
    /// Material.
    pub material: Material,
}

/// Forces of an anchor, from one of a model up.
const FORCE: Limits = Limits::from(1.0).to(1e9);

keys! {
    /// Anchor bolts.
    pub Anchors (Copy, Default) {
        /// Number of anchors around the circumference.
        count (36): Field<Whole> [Limits::count(1, 10_000)],
        /// Design tension capacity of one anchor.
        capacity ("120 kN"): Opt<Force> [FORCE]
            = without("the force of an anchor is given without a check"),
        /// Design tension capacity of the attachment of one anchor to the shell and of its embedment, the lesser.
        @"Option::is_none" attachment_capacity ("300 kN"): Opt<Force> [FORCE]
            = without("the attachment of the anchors is not checked, API 650 E.6.2.1.2"),
        /// Stiffness of one anchor with its chair and embedment, force over elongation: E A/l of the bolt between nut and anchor plate, less
        /// what chair and concrete give way. With it, and with tank.bottom, the base lifts on its anchors in the time history of the
        /// harmonic engine where one yields.
        @"Option::is_none" stiffness ("80 MN/m"): Opt<LineForce> [Limits::from(1e4).to(1e12)]
            = Absent::Follows("the wall is held down also where an anchor yields"),
        /// Force at which one anchor yields, at least capacity.
        @"Option::is_none" yield_force ("150 kN"): Opt<Force> [FORCE] = Absent::Follows("capacity"),
        /// Play of the nut: the uplift of the rim before the anchor pulls.
        @"Option::is_none" gap ("1 mm"): Opt<Length> [Limits::from(0.0).to(0.1)] = Absent::Follows("no play"),
        /// Elongation at which one anchor breaks, play not counted; the uniform elongation of its steel over the free length.
        @"Option::is_none" rupture_elongation ("40 mm"): Opt<Length> [Limits::from(1e-6).to(10.0)] = Absent::Follows("anchors do not break"),
    }
}

keys! {
    /// Gas or vapour above the liquid while the earthquake acts, against the atmosphere.
    pub Pressure (Copy, Default) {
        /// Largest overpressure.
        internal ("2 kPa"): Or<Stress> [Limits::from(0.0).to(1e6).usual(0.0, 50e3)] = default(Stress(0.0)).because("no overpressure"),
        /// Largest vacuum, as a positive number.
        vacuum ("0.5 kPa"): Or<Stress> [Limits::from(0.0).to(101_325.0).usual(0.0, 6.9e3)] = default(Stress(0.0)).because("no vacuum"),
    }
}

impl Pressure {
    /// Whether the tank is atmospheric.
    pub fn is_none(&self) -> bool {
        self.internal == 0.0 && self.vacuum == 0.0
    }
}

/// Plan dimensions and the height of the roof, from the smallest laboratory tank up; the upper bound catches mm written as m.
pub const SIZE: Limits = Limits::from(1e-3).to(1000.0);
/// Heights of courses and of the liquid, from the smallest laboratory tank up. The smallest for an engine depends on the radius; the engine
/// checks it.
pub const HEIGHT: Limits = Limits::from(1e-3).to(1000.0);

/// Young's modulus from which a material of unknown family counts as metal [Pa].
pub const METAL: f64 = 60e9;

/// An upright tank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tank {
    /// Plan shape and dimensions.
    pub shape: Shape,
    /// Support of the wall.
    pub support: Support,
    /// Courses from the base up; never empty.
    pub courses: Vec<Course>,
    /// Joint between the wall and its base.
    #[serde(default, skip_serializing_if = "WallBase::is_fixed")]
    pub wall_base: WallBase,
    /// Roof.
    pub roof: Roof,
    /// Stiffening rings and wind girders.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rings: Vec<Ring>,
    /// Masses that the wall carries at a height.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub attachments: Vec<Attachment>,
    /// Insulation of the wall, whose mass the densities of the courses contain.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub insulation: Option<Insulation>,
    /// Bottom plate, where given.
    pub bottom: Option<Bottom>,
    /// Foundation, where given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foundation: Option<Foundation>,
    /// Layers, embedment and damping of the soil under a slab.
    #[serde(default, skip_serializing_if = "Subsoil::is_plain")]
    pub subsoil: Subsoil,
    /// Isolators under the slab, where given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub isolators: Option<Isolators>,
    /// Staging of an elevated tank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub staging: Option<Staging>,
    /// Anchors, where given.
    pub anchors: Option<Anchors>,
    /// Pressure above the liquid.
    #[serde(default, skip_serializing_if = "Pressure::is_none")]
    pub pressure: Pressure,
    /// Pipes, where given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pipes: Option<Pipes>,
    /// Answers about the construction.
    #[serde(default, skip_serializing_if = "Details::is_empty")]
    pub details: Details,
}

/// Liquids, from hydrogen (71 kg/m³) to mercury (13 600 kg/m³): `1 kg/m3` for water is a slip of the unit.
const LIQUID_DENSITY: Limits = Limits::above(50.0).to(15_000.0).usual(400.0, 2000.0);

/// Bulk modulus of a liquid, from liquefied gases to mercury (28.5 GPa).
const BULK_MODULUS: Limits = Limits::from(1e7).to(1e11).usual(3e8, 5e9);

keys! {
    /// The stored liquid.
    pub Liquid (Copy) {
        /// Density.
        density: Field<Density> [LIQUID_DENSITY],
        /// Depth of the liquid above the tank bottom.
        fill_height ("9 m"): Field<Length> [HEIGHT],
        /// Bulk modulus, of a liquid of displacement elements and of the limit of compressibility; other liquids are incompressible.
        @"Option::is_none" bulk_modulus ("2.06 GPa"): Opt<Stress> [BULK_MODULUS] = without("water, 2.06 GPa; c = 1435 m/s in the limit of compressibility"),
    }
}

impl Liquid {
    /// Bulk modulus [Pa]; 2.06 GPa of water where it is not given.
    pub fn compression_modulus(&self) -> f64 {
        self.bulk_modulus.unwrap_or(2.06e9)
    }

    /// Velocity of sound √(K/ρ) [m/s]; where K is not given, that of water for any density.
    pub fn sound(&self) -> f64 {
        self.bulk_modulus.map_or(1435.0, |modulus| (modulus / self.density).sqrt())
    }
}

/// Whether a length or mass is left out of a file.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde calls")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// Whether courses are those of a metal shell, as [`Tank::is_metal`].
pub fn is_metal(courses: &[Course]) -> bool {
    courses.iter().all(|c| c.layers.is_empty() && c.material.is_metal())
}

impl Course {
    /// Thickness less corrosion [m]: it carries stresses and resists; mass and stiffness are those of the whole thickness.
    pub fn net_thickness(&self) -> f64 {
        self.thickness - self.corrosion
    }
}

impl Bottom {
    /// Thickness less corrosion [m].
    pub fn net_thickness(&self) -> f64 {
        self.thickness - self.corrosion
    }
}

impl Tank {
    /// Whether corrosion takes part of the wall or of the bottom plate.
    pub fn corrodes(&self) -> bool {
        self.courses.iter().any(|c| c.corrosion > 0.0) || self.bottom.as_ref().is_some_and(|b| b.corrosion > 0.0)
    }

    /// Height of the wall, the sum of its courses [m].
    pub fn wall_height(&self) -> f64 {
        self.courses.iter().map(|c| c.height).sum()
    }

    /// The course at height `z` [m] above the base (the upper one at a joint; the last one above the wall).
    pub fn course_at(&self, z: f64) -> &Course {
        let mut top = 0.0;
        for course in &self.courses {
            top += course.height;
            if z < top {
                return course;
            }
        }
        &self.courses[self.courses.len() - 1]
    }

    /// Heights [m] for values over the wetted wall, ascending: 40 steps over `depth`, and both sides of each joint of
    /// courses below the surface (the lower side 1e-6 of the depth beneath it).
    pub fn profile_heights(&self, depth: f64) -> Vec<f64> {
        let mut z: Vec<f64> = (0..=40).map(|i| depth * f64::from(i) / 40.0).collect();
        let mut joint = 0.0;
        for course in &self.courses {
            joint += course.height;
            if joint < depth * (1.0 - 1e-6) {
                z.extend([joint - 1e-6 * depth, joint]);
            }
        }
        z.sort_by(f64::total_cmp);
        // A joint that equals a step up to rounding must not appear twice.
        z.dedup_by(|b, a| (*b - *a).abs() < 1e-9 * depth);
        z
    }

    /// Whether the wall is a metal shell throughout, without layers.
    pub fn is_metal(&self) -> bool {
        is_metal(&self.courses)
    }

    /// Whether the wall is monolithic with its floor: not a metal shell, held down, and clamped; or the container of an elevated tank.
    pub fn is_monolithic(&self) -> bool {
        let clamped = !self.is_metal() && self.support == Support::Anchored && self.wall_base.is_fixed();
        clamped || self.staging.is_some()
    }

    /// Materials of the shells of the wall, from the base up.
    pub fn wall_materials(&self) -> impl Iterator<Item = &Material> {
        let layered = |course: &'_ Course| !course.layers.is_empty();
        self.courses.iter().flat_map(move |course| {
            let shells = course.layers.iter().filter(|layer| layer.kind == LayerKind::Shell);
            let whole = (!layered(course)).then_some(&course.material);
            shells.map(|layer| &layer.material).chain(whole)
        })
    }

    /// Masses of rings and attachments, each with its height: [kg], [m].
    pub fn carried(&self) -> impl Iterator<Item = (f64, f64)> {
        let rings = self.rings.iter().map(|ring| (ring.area * ring.material.density * self.perimeter(), ring.height));
        rings.chain(self.attachments.iter().map(|one| (one.mass, one.height)))
    }

    /// Mass of the wall [kg]: circumference × Σ height × thickness × density, and what it carries below the roof. A rectangle counts the
    /// two walls across the shaking and, unless it is a strip, the two along it.
    pub fn wall_mass(&self) -> f64 {
        self.shell_mass() + self.carried().map(|(mass, _)| mass).sum::<f64>()
    }

    /// Mass of the courses alone [kg].
    pub fn shell_mass(&self) -> f64 {
        self.courses.iter().map(|c| self.perimeter() * c.height * c.thickness * c.material.density).sum()
    }

    /// Mass of the insulation [kg], which that of the courses contains.
    pub fn insulation_mass(&self) -> f64 {
        let area = |one: &Insulation| self.perimeter() * one.height.unwrap_or(f64::INFINITY).min(self.wall_height());
        self.insulation.as_ref().map_or(0.0, |one| one.mass * area(one))
    }

    /// Height of the centre of mass of the wall with what it carries [m].
    pub fn wall_centroid(&self) -> f64 {
        let (mut moment, mut sum, mut base) = (0.0, 0.0, 0.0);
        for c in &self.courses {
            let weight = c.height * c.thickness * c.material.density;
            moment += weight * (base + c.height / 2.0);
            sum += weight;
            base += c.height;
        }
        for (mass, height) in self.carried() {
            moment += mass / self.perimeter() * height;
            sum += mass / self.perimeter();
        }
        moment / sum
    }

    /// Mass whose weight the wall carries at the height `z` [kg]: that of [`Tank::mass_above`] without what columns carry of the roof.
    pub fn weight_above(&self, z: f64) -> f64 {
        self.mass_above(z).0 - self.roof.on_columns * self.roof.mass
    }

    /// Gives a course another thickness [m]; its insulation keeps its mass.
    pub fn thicken(&mut self, index: usize, thickness: f64) {
        let base: f64 = self.courses.iter().take(index).map(|course| course.height).sum();
        let up_to = self.insulation.map(|one| (one.mass, one.height.unwrap_or(f64::INFINITY)));
        let Some(course) = self.courses.get_mut(index) else { return };
        if let Some((mass, _)) = up_to.filter(|(_, up_to)| base < *up_to * (1.0 - 1e-9)) {
            course.material.density += mass / thickness - mass / course.thickness;
        }
        course.thickness = thickness;
    }

    /// Mass of wall and roof above the height `z` [kg], and its moment about `z` [kg·m]: what moves with the wall there.
    pub fn mass_above(&self, z: f64) -> (f64, f64) {
        let (mut mass, mut moment) = (self.roof.mass, self.roof.mass * (self.roof_height() - z));
        for (one, height) in self.carried().filter(|(_, height)| *height >= z) {
            mass += one;
            moment += one * (height - z);
        }
        let mut base = 0.0;
        for c in &self.courses {
            let top = base + c.height;
            let from = base.max(z);
            if top > from {
                let part = self.perimeter() * (top - from) * c.thickness * c.material.density;
                mass += part;
                moment += part * (0.5 * (top + from) - z);
            }
            base = top;
        }
        (mass, moment)
    }

    /// Mass of a thick wall with what it carries below the roof [kg], and the height of its centre [m]: the courses at the middle of their
    /// thickness, a rectangle with its corners. [`Tank::wall_mass`] has them on the inner face, as engines and thin walls do.
    pub fn thick_wall(&self) -> (f64, f64) {
        let (mut mass, mut moment, mut base) = (0.0, 0.0, 0.0);
        for course in &self.courses {
            let beyond = match self.shape {
                Shape::Cylinder { .. } => std::f64::consts::PI * course.thickness,
                Shape::Rectangle { strip: true, .. } => 0.0,
                Shape::Rectangle { .. } => 4.0 * course.thickness,
            };
            let own = (self.perimeter() + beyond) * course.height * course.thickness * course.material.density;
            mass += own;
            moment += own * (base + 0.5 * course.height);
            base += course.height;
        }
        for (one, height) in self.carried() {
            mass += one;
            moment += one * height;
        }
        (mass, moment / mass)
    }

    /// Height of the roof's centre of mass [m].
    pub fn roof_height(&self) -> f64 {
        self.roof.centre(self.wall_height())
    }

    /// Length of wall in plan that counts for its mass [m].
    pub fn perimeter(&self) -> f64 {
        match self.shape {
            Shape::Cylinder { radius } => 2.0 * std::f64::consts::PI * radius,
            Shape::Rectangle { breadth, strip: true, .. } => 2.0 * breadth,
            Shape::Rectangle { length, breadth, strip: false } => 2.0 * (length + breadth),
        }
    }
}

impl Liquid {
    /// Mass m of the liquid in a tank of this shape [kg].
    pub fn mass(&self, shape: Shape) -> f64 {
        self.density * shape.plan_area() * self.fill_height
    }
}
