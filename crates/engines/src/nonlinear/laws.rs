//! From the behaviour of a material to its law.

use std::sync::Arc;

use fem::element::shell::rule::Rule;
use materials::bar::Rupture;
use materials::concrete::bond::model_code_1990;
use materials::concrete::{
    Bond, Compression, Conditions, PostPeak, Softening as Falls, Stiffening, Tension, UniaxialConcrete,
    fracture_energy, peak_strain,
};
use materials::elastic::Elastic;
use materials::{Law, LawError};
use tank::{Bar, BarBond, BarDirection, Behaviour, Concrete, ConcreteLaw, Layer, Material, Softening};

use crate::FeError;
use tank::options::nonlinear::ThicknessRule;

/// Crushing energy over fracture energy (theory of the laws of concrete).
pub(crate) const CRUSHING: f64 = 250.0;

/// An error for something that the engine does not model.
pub(crate) fn unsupported<T>(what: impl Into<String>) -> Result<T, FeError> {
    Err(FeError::Unsupported(what.into()))
}

/// An error of a law as one of the engine.
pub(crate) fn refused(error: LawError) -> FeError {
    match error {
        LawError::Parameter { law, parameter, found, allowed } => {
            FeError::Option { option: format!("{law}: {parameter}"), found, allowed }
        }
        other => FeError::Analysis(other.to_string()),
    }
}

/// Quadrature over a layer.
pub(crate) fn quadrature(rule: ThicknessRule) -> Rule {
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
pub(crate) fn uniaxial_concrete(
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
            post_peak: PostPeak::Crushing { crushing_energy: CRUSHING * fracture_energy(strength), size: element },
        },
        ConcreteLaw::PlasticFracturing => {
            return unsupported(
                "plastic-fracturing concrete is for shells only: choose `cracked` or `uniaxial` for a strip",
            );
        }
        ConcreteLaw::TwoSurface | ConcreteLaw::Fracturing => {
            return unsupported(
                "this law of concrete is for shells only: choose `cracked` or `uniaxial` for a strip of fibres, or `wall` as shell",
            );
        }
    };
    let tension = tension(concrete, layer, Some(BarDirection::Vertical), element);
    UniaxialConcrete::new(young, compression, Some(tension)).map_err(refused)
}

/// Tension of concrete in a cell of size `element` [m]; tension stiffening ends where the bars of `direction` (of any without)
/// yield, bond is that of these bars (the weaker of both directions without).
pub(crate) fn tension(concrete: &Concrete, layer: &Layer, direction: Option<BarDirection>, element: f64) -> Tension {
    let size = concrete.band(element);
    let softening = match concrete.softening {
        Softening::FractureEnergy(fracture_energy) => Falls::Energy { fracture_energy, size },
        Softening::Strain(softening_strain) => Falls::Strain { softening_strain },
        Softening::Brittle => Falls::Brittle,
    };
    let counts = |d: BarDirection| direction.is_none_or(|wanted| d == wanted);
    let yields = layer.reinforcement.iter().filter_map(|bars| match bars.material.behaviour {
        Behaviour::Reinforcement(Bar { yield_strength, .. }) if counts(bars.direction) => {
            Some(yield_strength / bars.material.youngs_modulus)
        }
        _ => None,
    });
    let stiffening = (concrete.tension_stiffening > 0.0)
        .then(|| Stiffening { share: concrete.tension_stiffening, yield_strain: yields.fold(f64::INFINITY, f64::min) });
    let directions = [BarDirection::Hoop, BarDirection::Vertical];
    let bonds = directions.into_iter().filter(|&d| counts(d)).filter_map(|d| bond(concrete, layer, d));
    // At half a thousandth cracks are stabilised and bars elastic.
    let held = |b: &Bond| b.stresses(layer.material.youngs_modulus, 5e-4)[0];
    Tension {
        strength: concrete.tensile_strength,
        softening,
        stiffening,
        bond: bonds.reduce(|a, b| if held(&b) < held(&a) { b } else { a }),
    }
}

/// f_cm − f_ck [Pa], EN 1992-1-1 table 3.1.
const MEAN_LESS_CHARACTERISTIC: f64 = 8e6;

/// Bond of the bars of a direction; `None` without bars or slip. What the bars lack is NaN, which the law rejects.
fn bond(concrete: &Concrete, layer: &Layer, direction: BarDirection) -> Option<Bond> {
    let conditions = match concrete.bond {
        BarBond::Perfect => return None,
        BarBond::Good => Conditions::Good,
        BarBond::Other => Conditions::Other,
    };
    let bars = || layer.reinforcement.iter().filter(|b| b.direction == direction);
    let area: f64 = bars().map(|b| b.area).sum();
    if area == 0.0 {
        return None;
    }
    let f_ck = concrete.characteristic_strength.unwrap_or(concrete.compressive_strength - MEAN_LESS_CHARACTERISTIC);
    let [strength, slip, exponent] = model_code_1990(f_ck, conditions);
    // Bars that yield first limit the bond of all.
    let yields = |b: &tank::Reinforcement| match b.material.behaviour {
        Behaviour::Reinforcement(bar) => bar.yield_strength,
        _ => f64::INFINITY,
    };
    let first = bars().min_by(|a, b| {
        let strain = |b: &tank::Reinforcement| yields(b) / b.material.youngs_modulus;
        strain(a).total_cmp(&strain(b))
    })?;
    Some(Bond {
        ratio: area / layer.thickness,
        diameter: layer.bar_diameter(direction).unwrap_or(f64::NAN),
        bar_modulus: first.material.youngs_modulus,
        yield_stress: yields(first),
        strength,
        slip,
        exponent,
        spacing: concrete.crack_spacing.unwrap_or(f64::NAN),
    })
}

/// Law along a bar.
///
/// Errors: parameters out of range.
pub(crate) fn bar_law(material: &Material) -> Result<Arc<dyn Law<1>>, FeError> {
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

#[cfg(test)]
mod tests {
    use tank::{BiaxialEnvelope, LayerKind, Reinforcement};

    use super::*;

    fn material(behaviour: Behaviour, youngs_modulus: f64) -> Material {
        Material {
            family: None,
            name: "m".into(),
            youngs_modulus,
            poisson_ratio: 0.2,
            density: 2500.0,
            yield_strength: None,
            allowable_stress: None,
            behaviour,
            volume_change: Default::default(),
        }
    }

    fn wall(bond: BarBond) -> (Layer, Concrete) {
        let concrete = Concrete {
            law: ConcreteLaw::Cracked,
            compressive_strength: 38e6,
            characteristic_strength: None,
            biaxial_ratio: 1.16,
            envelope: BiaxialEnvelope::DruckerPrager,
            tensile_strength: 2.9e6,
            softening: Softening::FractureEnergy(140.0),
            shear_retention: 0.1,
            shear_retention_strain: 2e-4,
            tension_stiffening: 0.0,
            crack_spacing: Some(0.2),
            bond,
        };
        let steel = Behaviour::Reinforcement(Bar { yield_strength: 500e6, tangent_modulus: 0.0, rupture_strain: None });
        let bars = |direction, area| Reinforcement {
            direction,
            area,
            depth: 0.04,
            diameter: Some(0.016),
            prestress: 0.0,
            material: material(steel, 200e9),
        };
        let layer = Layer {
            kind: LayerKind::Shell,
            thickness: 0.2,
            material: material(Behaviour::Concrete(concrete), 33e9),
            reinforcement: vec![bars(BarDirection::Hoop, 30e-4), bars(BarDirection::Vertical, 15e-4)],
        };
        (layer, concrete)
    }

    /// By hand: ρ = 15 cm²/m/20 cm up the wall and twice that around it; τ_max = 2 √30 MPa; a shell takes the weaker direction.
    #[test]
    fn bond_of_a_layer() {
        let (layer, concrete) = wall(BarBond::Good);
        let up = tension(&concrete, &layer, Some(BarDirection::Vertical), 0.5).bond.unwrap();
        assert!((up.ratio - 0.0075).abs() < 1e-12 && up.spacing == 0.2 && up.diameter == 0.016);
        assert!((up.strength - 2e6 * 30f64.sqrt()).abs() < 1.0);
        let around = tension(&concrete, &layer, Some(BarDirection::Hoop), 0.5).bond.unwrap();
        assert!((around.ratio - 0.015).abs() < 1e-12);
        assert_eq!(tension(&concrete, &layer, None, 0.5).bond, Some(up));
        let (layer, concrete) = wall(BarBond::Perfect);
        assert_eq!(tension(&concrete, &layer, None, 0.5).bond, None);
    }

    /// A wall drawn up its bars carries more with bond than without while they are elastic, and never more than they at yield.
    #[test]
    fn bond_in_the_law_of_a_strip() {
        let force = |bond, strain: f64| {
            let (layer, concrete) = wall(bond);
            let law = uniaxial_concrete(&concrete, 33e9, &layer, 0.5).unwrap();
            let mut new = vec![0.0; law.history_len()];
            law.respond(&[strain], &vec![0.0; new.len()], &mut new).unwrap().stress[0] * 0.2
        };
        let bars = |strain: f64| (200e9 * strain).min(500e6) * 15e-4;
        let plain = force(BarBond::Perfect, 1e-3);
        assert!(force(BarBond::Good, 1e-3) > plain + 0.05 * bars(1e-3));
        assert!(force(BarBond::Other, 1e-3) < force(BarBond::Good, 1e-3));
        for strain in [2e-3, 2.3e-3, 2.5e-3, 4e-3] {
            let most = 500e6 * 15e-4;
            // Cohesion of wide cracks is 1 % of the yield force at 2 ‰.
            assert!(force(BarBond::Good, strain) + bars(strain) < 1.01 * most, "{strain}");
        }
    }
}
