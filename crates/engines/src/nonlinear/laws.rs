//! From the behaviour of a material to its law.

use std::sync::Arc;

use fem::element::shell::rule::Rule;
use materials::bar::Rupture;
use materials::concrete::{
    Compression, PostPeak, Softening as Falls, Stiffening, Tension, UniaxialConcrete, fracture_energy, peak_strain,
};
use materials::elastic::Elastic;
use materials::{Law, LawError};
use tank::{Bar, BarDirection, Behaviour, Concrete, ConcreteLaw, Layer, Material, Softening};

use crate::FeError;
use tank::options::nonlinear::ThicknessRule;

/// Crushing energy over fracture energy (theory of the laws of concrete).
pub(super) const CRUSHING: f64 = 250.0;

/// An error for something that the engine does not model.
pub(super) fn unsupported<T>(what: impl Into<String>) -> Result<T, FeError> {
    Err(FeError::Unsupported(what.into()))
}

/// An error of a law as one of the engine.
pub(super) fn refused(error: LawError) -> FeError {
    match error {
        LawError::Parameter {
            law,
            parameter,
            found,
            allowed,
        } => FeError::Option {
            option: format!("{law}: {parameter}"),
            found,
            allowed,
        },
        other => FeError::Analysis(other.to_string()),
    }
}

/// Quadrature over a layer.
pub(super) fn quadrature(rule: ThicknessRule) -> Rule {
    match rule {
        ThicknessRule::Gauss(n) => Rule::Gauss(n as usize),
        ThicknessRule::Lobatto(n) => Rule::Lobatto(n as usize),
        ThicknessRule::MidPoint(n) => Rule::MidPoint(n as usize),
        ThicknessRule::Simpson(n) => Rule::Simpson(n as usize),
        ThicknessRule::Trapezoid(n) => Rule::Trapezoid(n as usize),
    }
}

/// Law of concrete along a strip's wall; `element`: its length [m].
///
/// Errors: a law that strips do not have; parameters out of range.
pub(super) fn uniaxial_concrete(
    concrete: &Concrete,
    young: f64,
    layer: &Layer,
    element: f64,
) -> Result<UniaxialConcrete, FeError> {
    let strength = concrete.compressive_strength;
    let compression = match concrete.law {
        ConcreteLaw::Cracked => Compression::Plastic { strength },
        ConcreteLaw::Uniaxial => Compression::Sargin {
            strength,
            peak_strain: peak_strain(strength),
            post_peak: PostPeak::Crushing {
                crushing_energy: CRUSHING * fracture_energy(strength),
                size: element,
            },
        },
        ConcreteLaw::PlasticFracturing => {
            return unsupported(
                "plastic-fracturing concrete is for shells only: choose `cracked` or `uniaxial` for a strip",
            );
        }
    };
    let tension = tension(concrete, layer, Some(BarDirection::Vertical), element);
    UniaxialConcrete::new(young, compression, Some(tension)).map_err(refused)
}

/// Tension of concrete in a cell of size `element` [m]; tension stiffening ends where the bars of `direction` (of any without)
/// yield.
pub(super) fn tension(concrete: &Concrete, layer: &Layer, direction: Option<BarDirection>, element: f64) -> Tension {
    let size = concrete.band(element);
    let softening = match concrete.softening {
        Softening::FractureEnergy(fracture_energy) => Falls::Energy { fracture_energy, size },
        Softening::Strain(softening_strain) => Falls::Strain { softening_strain },
        Softening::Brittle => Falls::Brittle,
    };
    let counts = |d: BarDirection| direction.is_none_or(|wanted| d == wanted);
    let yields = layer
        .reinforcement
        .iter()
        .filter_map(|bars| match bars.material.behaviour {
            Behaviour::Reinforcement(Bar { yield_strength, .. }) if counts(bars.direction) => {
                Some(yield_strength / bars.material.youngs_modulus)
            }
            _ => None,
        });
    let stiffening = (concrete.tension_stiffening > 0.0).then(|| Stiffening {
        share: concrete.tension_stiffening,
        yield_strain: yields.fold(f64::INFINITY, f64::min),
    });
    Tension {
        strength: concrete.tensile_strength,
        softening,
        stiffening,
    }
}

/// Law along a bar.
///
/// Errors: parameters out of range.
pub(super) fn bar_law(material: &Material) -> Result<Arc<dyn Law<1>>, FeError> {
    let young = material.youngs_modulus;
    let Behaviour::Reinforcement(bar) = material.behaviour else {
        return Ok(Arc::new(Elastic::new(young, 0.0).map_err(refused)?));
    };
    let law = materials::bar::Bar::new(young, bar.yield_strength, bar.tangent_modulus).map_err(refused)?;
    Ok(match bar.rupture_strain {
        Some(strain) => Arc::new(law.with_rupture(strain, Rupture::Recorded).map_err(refused)?),
        None => Arc::new(law),
    })
}
