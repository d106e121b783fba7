//! From the layers of a course to the shells of its cells.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use fem::element::shell::layered::{Bar, LayeredSection, Ply};
use fem::element::solid8::{Elastic as Core, Kinematics};
use fem::element::wall::place::{Build, Leaf};
use fem::element::wall::{Layer as Between, LayerMass};
use materials::Law;
use materials::concrete::{CrackedConcrete, CrackedParameters, Envelope, ShearRetention, fracture_energy, peak_strain};
use materials::dougill::Fracturing;
use materials::elastic::Elastic;
use materials::plane_stress::PlaneStress;
use materials::plastic_fracturing::{Parameters, PlasticFracturing};
use materials::two_surface::TwoSurface;
use materials::von_mises::VonMises;
use tank::{BarDirection, Behaviour, BiaxialEnvelope, Concrete, ConcreteLaw, Layer, LayerKind, WallTemperature};

use super::super::lasting::Wall;
use super::super::laws::{CRUSHING, bar_law, quadrature, refused, tension, unsupported};
use crate::FeError;
use crate::error::failed;
use tank::options::nonlinear::{Integration, ThicknessRule};

/// Material of a point of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// Elastic.
    Elastic,
    /// Steel plate, with its tensile strength [Pa] where it is known.
    Steel(Option<f64>),
    /// Concrete.
    Concrete {
        /// Lengths around and up the wall over which cracks are smeared [m].
        band: [f64; 2],
        /// Compressive strength [Pa].
        strength: f64,
    },
    /// Bars, with their strain at rupture where it is known.
    Bar(Option<f64>),
}

/// The cells of a row.
#[derive(Clone)]
pub(crate) struct RowBuild {
    /// Shells and the layer between them.
    pub build: Build,
    /// Parts of each leaf, in the order in which its section shows its points: layers, then bars.
    pub parts: Vec<Vec<Part>>,
    /// Thickness of all shells [m].
    pub thickness: f64,
    /// Distance from the inner to the outer reference surface [m]; 0 of one shell.
    pub gap: f64,
}

/// Shells and layer of a course with these layers, from inside to outside, in cells of [length, height] `element` [m], with the free strains
/// of a temperature at rest.
///
/// Errors: more than one interlayer, or one at a face; a law that shells do not have; parameters out of range.
pub(crate) fn row(
    layers: &[Layer],
    element: [f64; 2],
    integration: &Integration,
    temperature: Option<WallTemperature>,
) -> Result<RowBuild, FeError> {
    let wall = Wall::of(layers, temperature);
    let leaves: Vec<&[Layer]> = layers.split(|l| l.kind == LayerKind::Interlayer).collect();
    let half = |leaf: &[Layer]| 0.5 * leaf.iter().map(|l| l.thickness).sum::<f64>();
    let thickness: f64 = leaves.iter().map(|l| 2.0 * half(l)).sum();
    match leaves.as_slice() {
        [only] => {
            let (section, parts) = leaf(only, element, integration, (wall, 0.0))?;
            Ok(RowBuild { build: Build::Shell(section), parts: vec![parts], thickness, gap: 0.0 })
        }
        [inner, outer] if !inner.is_empty() && !outer.is_empty() => {
            let Some(between) = layers.iter().find(|l| l.kind == LayerKind::Interlayer) else {
                return unsupported("a wall without layers");
            };
            let (first, own) = leaf(inner, element, integration, (wall, 0.0))?;
            let face = 2.0 * half(inner) + between.thickness;
            let (second, others) = leaf(outer, element, integration, (wall, face))?;
            Ok(RowBuild {
                build: Build::Layered([first, second], interlayer(between)?),
                parts: vec![own, others],
                thickness,
                gap: half(inner) + between.thickness + half(outer),
            })
        }
        _ => unsupported("the nonlinear engine models walls of one shell, or of two with one interlayer between them"),
    }
}

/// Law of the layer between two shells.
///
/// Errors: one that the engine does not model.
pub(crate) fn interlayer(layer: &Layer) -> Result<Between, FeError> {
    let material = &layer.material;
    let law = match material.behaviour {
        Behaviour::Interlayer(i) if i.e_parallel == 0.0 && i.shear_modulus == 0.0 => match i.tension {
            true => Core::normal_only(i.e_normal, material.density),
            false => Core::pressed_only(i.e_normal, material.density),
        },
        Behaviour::Interlayer(i) if i.tension => {
            Core::transverse([i.e_normal, i.shear_modulus, i.e_parallel], material.density)
        }
        Behaviour::Elastic => Core::isotropic(material.youngs_modulus, material.poisson_ratio, material.density),
        _ => {
            return unsupported(format!(
                "interlayer `{}`: the nonlinear engine models layers that are elastic and isotropic, stiff along the normal \
                 alone (with or without tension), or also in transverse shear and in their plane with tension",
                material.name
            ));
        }
    };
    Ok(Between { material: law, kinematics: Kinematics::GreenLagrange, mass: LayerMass::Halves })
}

/// A shell of these layers; `face`: distance of its inner face from that of the wall [m].
fn leaf(
    layers: &[Layer],
    element: [f64; 2],
    integration: &Integration,
    (wall, face): (Option<Wall>, f64),
) -> Result<(Leaf, Vec<Part>), FeError> {
    let thickness: f64 = layers.iter().map(|l| l.thickness).sum();
    let (mut plies, mut bars) = (Vec::new(), Vec::new());
    let (mut parts, mut bar_parts) = (Vec::new(), Vec::new());
    let (mut states, mut free) = (Vec::new(), Vec::new());
    let mut inner = -0.5 * thickness;
    for layer in layers {
        let (law, rule) = plane_law(layer, element, integration)?;
        let rule = quadrature(rule);
        if let Some(wall) = wall {
            let (state, of_bars) = wall.states(layer, face + 0.5 * thickness + inner);
            states.push(state);
            free.extend(of_bars);
        }
        let points = rule.points().map_err(failed)?.len();
        parts.extend(std::iter::repeat_n(part(layer, element), points));
        plies.push(Ply { law, thickness: layer.thickness, density: layer.material.density, rule });
        for bar in &layer.reinforcement {
            bars.push(Bar {
                law: bar_law(&bar.material)?,
                area: bar.area,
                depth: inner + bar.depth,
                angle: match bar.direction {
                    BarDirection::Hoop => 0.0,
                    BarDirection::Vertical => FRAC_PI_2,
                },
                // As in the mass of the tank, bars are ignored.
                density: 0.0,
            });
            bar_parts.push(Part::Bar(match bar.material.behaviour {
                Behaviour::Reinforcement(b) => b.rupture_strain,
                _ => None,
            }));
        }
        inner += layer.thickness;
    }
    parts.extend(bar_parts);
    let mut section = LayeredSection::new(&plies, &bars).map_err(failed)?;
    if wall.is_some() {
        section = section.lasting(&states, &free).map_err(failed)?;
    }
    let leaf = Leaf { section: Arc::new(section), face: 0.5 * thickness };
    Ok((leaf, parts))
}

fn part(layer: &Layer, element: [f64; 2]) -> Part {
    match layer.material.behaviour {
        Behaviour::Steel(steel) => Part::Steel(steel.ultimate_strength),
        Behaviour::Concrete(concrete) => {
            Part::Concrete { band: element.map(|side| concrete.band(side)), strength: concrete.compressive_strength }
        }
        _ => Part::Elastic,
    }
}

/// Law of a layer in plane stress, and its quadrature.
///
/// * `element`: [length, height] of the cell [m]; a crack is smeared over the side next to its normal, or over their spacing
///
/// Errors: a law that shells do not have; parameters out of range.
fn plane_law(
    layer: &Layer,
    element: [f64; 2],
    integration: &Integration,
) -> Result<(Arc<dyn Law<3>>, ThicknessRule), FeError> {
    let material = &layer.material;
    let (young, nu) = (material.youngs_modulus, material.poisson_ratio);
    Ok(match material.behaviour {
        Behaviour::Elastic => (Arc::new(Elastic::new(young, nu).map_err(refused)?), integration.elastic),
        Behaviour::Steel(steel) => {
            let law = VonMises::new(young, nu, steel.yield_strength, steel.tangent_modulus, steel.kinematic_share);
            (Arc::new(law.map_err(refused)?), integration.steel)
        }
        Behaviour::Concrete(concrete) => (plane_concrete(&concrete, young, nu, layer, element)?, integration.concrete),
        Behaviour::Reinforcement(_) => return unsupported(format!("`{}` is for bars, not for a layer", material.name)),
        Behaviour::Interlayer(_) => {
            return unsupported(format!("`{}` is for an interlayer, not for a shell", material.name));
        }
    })
}

/// Law of concrete in plane stress in a cell of [length, height] `element` [m].
///
/// Errors: a law that shells do not have; parameters out of range.
pub(crate) fn plane_concrete(
    concrete: &Concrete,
    young: f64,
    nu: f64,
    layer: &Layer,
    element: [f64; 2],
) -> Result<Arc<dyn Law<3>>, FeError> {
    let strength = concrete.compressive_strength;
    let size = element[0].max(element[1]);
    Ok(match concrete.law {
        ConcreteLaw::Cracked => {
            let mut parameters = CrackedParameters::new(young, nu, strength, tension(concrete, layer, None, size));
            parameters.biaxial_ratio = concrete.biaxial_ratio;
            parameters.sides = Some(element.map(|side| concrete.band(side)));
            parameters.envelope = match concrete.envelope {
                BiaxialEnvelope::DruckerPrager => Envelope::DruckerPrager,
                BiaxialEnvelope::Kupfer => Envelope::Kupfer,
            };
            parameters.retention =
                ShearRetention { least: concrete.shear_retention, strain: concrete.shear_retention_strain };
            Arc::new(CrackedConcrete::new(&parameters).map_err(refused)?)
        }
        ConcreteLaw::PlasticFracturing => {
            let law = PlasticFracturing::new(&Parameters {
                young_modulus: young,
                poisson_ratio: nu,
                strength,
                biaxial: concrete.biaxial_ratio * strength,
                peak_strain: peak_strain(strength),
                crushing_energy: CRUSHING * fracture_energy(strength),
                length: size,
            });
            Arc::new(law.map_err(refused)?)
        }
        ConcreteLaw::TwoSurface => {
            let biaxial = concrete.biaxial_ratio * strength;
            let law = TwoSurface::new(young, nu, strength, biaxial, concrete.tensile_strength);
            Arc::new(PlaneStress::new(law.map_err(refused)?))
        }
        ConcreteLaw::Fracturing => {
            let energy = CRUSHING * fracture_energy(strength) / size;
            let law = Fracturing::of_energy(young, nu, strength, concrete.biaxial_ratio, energy);
            Arc::new(PlaneStress::new(law.map_err(refused)?))
        }
        ConcreteLaw::Uniaxial => {
            return unsupported("uniaxial concrete is for strips only: choose another law for shells");
        }
    })
}
