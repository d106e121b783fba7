//! Concrete that cracks and crushes.

use tank::units::{display_in, unit_for};
use tank::{Concrete, ConcreteLaw, Softening};

use super::super::grades::{Preset, Strengths};
use super::super::{Limits, Resolver, range_fault};
use super::{CONCRETE, ElasticPart, Reader, STRESS, like};
use crate::input::tank::read::Field;
use crate::input::tank::schema;
use crate::input::tank::values::{LineForce, Number, Si, Stress};

/// Strengths, softening and cracks of a concrete; `field` is none where a grade alone supplies it.
pub(super) fn concrete(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: Option<&Field<schema::ConcreteBehaviour>>,
    c: &schema::ConcreteBehaviour,
    (e, _): ElasticPart,
) -> Concrete {
    let law = r.choice(
        &reader.key("law"),
        &c.law,
        schema::ConcreteLaw::Cracked,
        "cracked",
        "fixed cracks at right angles, Drucker-Prager compression",
    );
    let strengths = |p: &Preset| match p.strengths {
        Strengths::Concrete {
            compressive, tensile, ..
        } => (compressive, tensile),
        _ => (f64::NAN, f64::NAN),
    };
    let f_c = reader.needed(r, "compressive_strength", &c.compressive_strength, CONCRETE, |p| {
        strengths(p).0
    });
    let mut f_t = reader.needed(r, "tensile_strength", &c.tensile_strength, STRESS, |p| strengths(p).1);
    if f_t >= f_c
        && let Some(field) = c.tensile_strength.as_ref().or(c.compressive_strength.as_ref())
    {
        let other = if c.tensile_strength.is_some() { f_c } else { f_t };
        let allowed = if c.tensile_strength.is_some() {
            format!("less than the compressive strength, {}", like(field, other))
        } else {
            format!("more than the tensile strength, {}", like(field, other))
        };
        r.faults.push(range_fault(
            field,
            "concrete is weaker in tension than in compression",
            &allowed,
        ));
        // No second fault follows from it.
        f_t = f64::NAN;
    }
    let biaxial_ratio = r.or_default(
        &reader.key("biaxial_ratio"),
        &c.biaxial_ratio,
        Limits::from(1.0).to(1.5),
        Number(1.16),
        "1.16",
        "Kupfer, Hilsdorf and Rüsch 1969",
    );
    let softening = softening(r, reader, field, c, (e, f_c, f_t));
    let shear_retention = r.or_default(
        &reader.key("shear_retention"),
        &c.shear_retention,
        Limits::from(0.0).to(1.0),
        Number(0.1),
        "0.1",
        "more locks fixed cracks",
    );
    let shear_retention_strain = r.or_default(
        &reader.key("shear_retention_strain"),
        &c.shear_retention_strain,
        Limits::above(0.0).to(1.0),
        Number(2e-4),
        "2e-4",
        "more locks fixed cracks",
    );
    let tension_stiffening = r.or_default(
        &reader.key("tension_stiffening"),
        &c.tension_stiffening,
        Limits::from(0.0).below(1.0),
        Number(0.0),
        "0",
        "repeated loading destroys the bond",
    );
    let crack_spacing = r.optional(
        &reader.key("crack_spacing"),
        &c.crack_spacing,
        Limits::above(0.0).to(10.0),
        "the size of the element",
    );
    Concrete {
        law: match law {
            schema::ConcreteLaw::Cracked => ConcreteLaw::Cracked,
            schema::ConcreteLaw::Uniaxial => ConcreteLaw::Uniaxial,
            schema::ConcreteLaw::PlasticFracturing => ConcreteLaw::PlasticFracturing,
        },
        compressive_strength: f_c,
        biaxial_ratio,
        tensile_strength: f_t,
        softening,
        shear_retention,
        shear_retention_strain,
        tension_stiffening,
        crack_spacing,
    }
}

/// Tension of concrete beyond f_t; `elastic` is (E, f_c, f_t) [Pa].
fn softening(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: Option<&Field<schema::ConcreteBehaviour>>,
    c: &schema::ConcreteBehaviour,
    (e, f_c, f_t): (f64, f64, f64),
) -> Softening {
    if let Some(brittle) = &c.brittle {
        r.echo_given(brittle);
    }
    let brittle = c.brittle.as_ref().is_some_and(|b| b.value == Some(true));
    let energy = (c.fracture_energy.as_ref()).map(|f| (f, r.number(f, Limits::above(0.0).to(1e5))));
    let strain = (c.softening_strain.as_ref()).map(|f| (f, r.number(f, Limits::above(0.0).to(1.0))));
    if let (Some(field), true) = (
        field,
        usize::from(brittle) + usize::from(energy.is_some()) + usize::from(strain.is_some()) > 1,
    ) {
        r.faults.push(range_fault(
            field,
            "one softening in tension is wanted",
            "one of fracture_energy, softening_strain and \"brittle\": true",
        ));
    }
    if let Some((field, strain)) = strain {
        let least = f_t / (0.98 * e);
        if strain < least {
            let allowed = format!("at least f_t/E with a margin of 2 %, {least:.2e}");
            r.faults.push(range_fault(
                field,
                "the softening is steeper than the elastic line: a crack would snap back",
                &allowed,
            ));
        }
        return Softening::Strain(strain);
    }
    if brittle {
        r.remarks.push(format!(
            "{}: brittle in tension: results depend on the mesh and the time step",
            reader.path
        ));
        return Softening::Brittle;
    }
    if let Some((_, energy)) = energy {
        return Softening::FractureEnergy(energy);
    }
    // The mean strength is the grade's, unless the file has a strength of its own.
    let mean = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Concrete { mean, .. }) if c.compressive_strength.is_none() => mean,
        _ => f_c,
    };
    let energy = 73.0 * (mean / 1e6).powf(0.18);
    let text = display_in(energy, unit_for(energy, LineForce::DIMENSION), 4);
    let source = format!(
        "fib Model Code 2010, eq. (5.1-9), with f_cm = {}",
        display_in(mean, unit_for(mean, Stress::DIMENSION), 3)
    );
    r.echo_default(&reader.key("fracture_energy"), &text, &source);
    Softening::FractureEnergy(energy)
}
