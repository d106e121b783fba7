//! `behaviour.concrete` of a material: concrete that cracks and crushes.

use files::code::Code;
use tank::{BarBond, BiaxialEnvelope, Concrete, ConcreteLaw, STRESS, Softening};

use super::reader::{ElasticPart, Reader, like, shown};
use crate::input::tank::choice::choice;
use crate::input::tank::keys::grades::{Preset, Strengths};
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Length, LineForce, Number, Stress};
use tank::keys::{Absent, Limits, default};

/// Strengths of concrete: `35 kPa` is a slip of the unit.
const STRENGTH: Limits = Limits::above(1e6).to(500e6);

/// f_cm − f_ck [Pa], EN 1992-1-1 table 3.1.
const MEAN_LESS_CHARACTERISTIC: f64 = 8e6;

object! {
    /// Concrete that cracks and crushes. Give at most one of fracture_energy, softening_strain and brittle.
    ConcreteBehaviour {
        /// Law.
        law: Opt<ConcreteLaw>
            = default(ConcreteLaw::Cracked).because("fixed cracks at right angles, Drucker-Prager compression"),
        /// Uniaxial compressive strength.
        compressive_strength ("38 MPa"): Opt<Stress> [STRENGTH] = Absent::Follows("that of the grade; needed without one"),
        /// Characteristic cylinder strength f_ck, needed by the checks of EN 1992; the law of the nonlinear engine does not use it.
        characteristic_strength ("30 MPa"): Opt<Stress> [STRENGTH]
            = Absent::Follows("f_cm - 8 MPa of the grade; without one the checks of EN 1992 are left out"),
        /// Biaxial over uniaxial compressive strength.
        biaxial_ratio (1.16): Opt<Number> [Limits::from(1.0).to(1.5)]
            = default(Number(1.16)).because("Kupfer, Hilsdorf and Rüsch 1969"),
        /// Biaxial strength in compression of the law cracked in shells.
        envelope: Opt<BiaxialEnvelope>
            = default(BiaxialEnvelope::DruckerPrager).because("-5.5 to +4.6 % of the curve of Kupfer and Gerstle"),
        /// Tensile strength.
        tensile_strength ("2.9 MPa"): Opt<Stress> [STRESS] = Absent::Follows("that of the grade; needed without one"),
        /// Energy of a crack per area.
        fracture_energy ("140 N/m"): Opt<LineForce> [Limits::above(0.0).to(1e5)] = Absent::Follows(
            "73 N/m times the mean compressive strength in MPa to the power 0.18 (fib Model Code 2010)"
        ),
        /// Strain over which the tensile stress falls to f_t/e, the same in elements of all sizes: results depend on the mesh.
        softening_strain (2e-4): Opt<Number> [Limits::above(0.0).to(1.0)],
        /// True if the tensile stress drops to zero at the first crack: results depend on the mesh and the time step.
        brittle (true): Opt<bool> = default(false),
        /// Least share of the shear stiffness in a cracked point.
        shear_retention (0.1): Opt<Number> [Limits::from(0.0).to(1.0)]
            = default(Number(0.1)).because("more locks fixed cracks"),
        /// Crack strain over which the shear stiffness falls.
        shear_retention_strain (2e-4): Opt<Number> [Limits::above(0.0).to(1.0)]
            = default(Number(2e-4)).shown("2e-4").because("more locks fixed cracks"),
        /// Share of the tensile strength that stays between cracks while the bars across them are elastic.
        tension_stiffening (0.4): Opt<Number> [Limits::from(0.0).below(1.0)]
            = default(Number(0.0)).because("repeated loading destroys the bond"),
        /// Spacing of cracks, where bars set it.
        crack_spacing ("15 cm"): Opt<Length> [Limits::above(0.0).to(10.0)] = Absent::Follows(
            "the size of the element; with bond the mean spacing of CEB-FIP Model Code 1990, 2/3 of diameter/(3.6 effective ratio)"
        ),
        /// Bond of the bars. With a bond law they slip at cracks: the concrete between cracks carries what the bond hands over, until the
        /// bars yield at the crack; needs their diameter. Not together with tension_stiffening, softening_strain or brittle.
        bond: Opt<BarBond> = default(BarBond::Perfect).because("no slip; repeated loading destroys the bond"),
    }
}

choice!(BiaxialEnvelope, BarBond, ConcreteLaw);

/// Strengths, softening and cracks of a concrete; `field` is `None` if only a grade supplies them.
pub(super) fn concrete(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: Option<&Field<ConcreteBehaviour>>,
    c: &ConcreteBehaviour,
    (e, _): ElasticPart,
) -> Concrete {
    let law = r.or_default(&c.law);
    let strengths = |p: &Preset| match p.strengths {
        Strengths::Concrete { compressive, tensile, .. } => (compressive, tensile),
        _ => (f64::NAN, f64::NAN),
    };
    let f_c = reader.needed(r, &c.compressive_strength, |p| strengths(p).0);
    let mut f_t = reader.needed(r, &c.tensile_strength, |p| strengths(p).1);
    let (given_c, given_t) = (&c.compressive_strength.given, &c.tensile_strength.given);
    if f_t >= f_c
        && let Some(field) = given_t.as_ref().or(given_c.as_ref())
    {
        let other = if given_t.is_some() { f_c } else { f_t };
        let allowed = if given_t.is_some() {
            format!("less than the compressive strength, {}", like(field, other))
        } else {
            format!("more than the tensile strength, {}", like(field, other))
        };
        let message = "concrete is weaker in tension than in compression";
        r.refuse(Code::Contradiction, field, message, &allowed);
        // Avoids a second fault with the same cause.
        f_t = f64::NAN;
    }
    let characteristic = |p: &Preset| match p.strengths {
        Strengths::Concrete { mean, .. } => mean - MEAN_LESS_CHARACTERISTIC,
        _ => f64::NAN,
    };
    let characteristic_strength = match reader.preset.as_ref().map(characteristic) {
        Some(f_ck) => Some(reader.supplied(r, &c.characteristic_strength, f_ck)),
        None => r.optional(&c.characteristic_strength),
    };
    let biaxial_ratio = r.or_default(&c.biaxial_ratio);
    let softening = softening(r, reader, field, c, (e, f_c, f_t));
    let envelope = envelope(r, c, law);
    without_cracks(r, reader, c, law);
    let bond = bond(r, reader, c, (law, softening), f_c);
    Concrete {
        law,
        compressive_strength: f_c,
        characteristic_strength,
        biaxial_ratio,
        tensile_strength: f_t,
        softening,
        shear_retention: r.or_default(&c.shear_retention),
        shear_retention_strain: r.or_default(&c.shear_retention_strain),
        tension_stiffening: r.or_default(&c.tension_stiffening),
        crack_spacing: r.optional(&c.crack_spacing),
        envelope,
        bond,
    }
}

/// Biaxial strength in compression: the curve is for the law `cracked`.
fn envelope(r: &mut Resolver<'_>, c: &ConcreteBehaviour, law: ConcreteLaw) -> BiaxialEnvelope {
    let envelope = r.or_default(&c.envelope);
    if let (Some(field), true) = (&c.envelope.given, envelope == BiaxialEnvelope::Kupfer && law != ConcreteLaw::Cracked)
    {
        let message = "the envelope of Kupfer and Gerstle belongs to the law `cracked`";
        r.refuse(Code::DoesNotApply, field, message, "with \"law\": \"cracked\" only");
    }
    envelope
}

/// Keys of cracks have no meaning in solids of concrete that do not crack.
fn without_cracks(r: &mut Resolver<'_>, reader: &Reader, c: &ConcreteBehaviour, law: ConcreteLaw) {
    if !matches!(law, ConcreteLaw::TwoSurface | ConcreteLaw::Fracturing) {
        return;
    }
    let allowed = "with \"law\": \"cracked\" or \"uniaxial\" only";
    macro_rules! refuse {
        ($($key:ident),*) => {$(
            if let Some(field) = &c.$key.given {
                let message = concat!("this law of concrete has no cracks, so that `", stringify!($key), "` does not apply");
                r.refuse(Code::DoesNotApply, field, message, allowed);
            }
        )*};
    }
    refuse!(
        fracture_energy,
        softening_strain,
        brittle,
        shear_retention,
        shear_retention_strain,
        tension_stiffening,
        crack_spacing,
        bond
    );
    r.remarks.push(match law {
        ConcreteLaw::Fracturing => format!(
            "{}: Dougill's fracturing solid does not use tensile_strength, which only the checks use",
            reader.path
        ),
        _ => format!(
            "{}: two-surface plasticity does not soften; it is for limit loads and short histories",
            reader.path
        ),
    });
}

/// Bond of the bars; `f_c` [Pa].
fn bond(
    r: &mut Resolver<'_>,
    reader: &Reader,
    c: &ConcreteBehaviour,
    (law, softening): (ConcreteLaw, Softening),
    f_c: f64,
) -> BarBond {
    let bond = r.or_default(&c.bond);
    if let Some(field) = &c.bond.given
        && bond != BarBond::Perfect
    {
        let stiffened = c.tension_stiffening.value().is_some_and(|share| share.0 > 0.0);
        let energy = matches!(softening, Softening::FractureEnergy(_));
        if stiffened || !energy || law == ConcreteLaw::PlasticFracturing {
            let message = "this concrete cannot take a bond law";
            let allowed = "with softening by fracture_energy, without tension_stiffening, law `cracked` or `uniaxial`";
            r.refuse(Code::Unsupported, field, message, allowed);
        }
        if c.characteristic_strength.given.is_none() && reader.preset.is_none() && f_c <= MEAN_LESS_CHARACTERISTIC {
            let message = "the bond strength follows from f_ck, which is f_cm - 8 MPa without characteristic_strength";
            let allowed = "a compressive strength above 8 MPa, or characteristic_strength";
            r.refuse(Code::Contradiction, field, message, allowed);
        }
    }
    bond
}

/// Tension of concrete beyond f_t; `elastic` is (E, f_c, f_t) [Pa].
fn softening(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: Option<&Field<ConcreteBehaviour>>,
    c: &ConcreteBehaviour,
    (e, f_c, f_t): (f64, f64, f64),
) -> Softening {
    if let Some(brittle) = &c.brittle.given {
        r.echo_given(brittle);
    }
    let brittle = c.brittle.value() == Some(&true);
    let energy = (c.fracture_energy.given.as_ref()).map(|f| (f, r.number(f)));
    let strain = (c.softening_strain.given.as_ref()).map(|f| (f, r.number(f)));
    if let (Some(field), true) =
        (field, usize::from(brittle) + usize::from(energy.is_some()) + usize::from(strain.is_some()) > 1)
    {
        let message = "more than one softening law in tension";
        let allowed = "one of fracture_energy, softening_strain and \"brittle\": true";
        r.refuse(Code::Exclusive, field, message, allowed);
    }
    if let Some((field, strain)) = strain {
        let least = f_t / (0.98 * e);
        if strain < least {
            let allowed = format!("at least f_t/E with a margin of 2 %, {least:.2e}");
            let message = "the softening is steeper than the elastic line (snap-back)";
            r.refuse(Code::Contradiction, field, message, &allowed);
        }
        return Softening::Strain(strain);
    }
    if brittle {
        r.remarks.push(format!("{}: brittle in tension; results depend on the mesh and the time step", reader.path));
        return Softening::Brittle;
    }
    if let Some((_, energy)) = energy {
        return Softening::FractureEnergy(energy);
    }
    // The mean strength of the grade applies unless the file gives a strength.
    let mean = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Concrete { mean, .. }) if c.compressive_strength.given.is_none() => mean,
        _ => f_c,
    };
    let energy = 73.0 * (mean / 1e6).powf(0.18);
    let source = format!("fib Model Code 2010, eq. (5.1-9), with f_cm = {}", shown::<Stress>(mean, 3));
    let energy = r.or_else(&c.fracture_energy, energy, &shown::<LineForce>(energy, 4), &source);
    Softening::FractureEnergy(energy)
}
