//! `materials`: elastic values and grades.

mod concrete;
mod family;
pub(super) mod laws;
mod reader;
mod yielding;

use files::code::Code;
use std::collections::BTreeMap;

use super::grades::{self, Found, Preset, Strengths};
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::syntax::join;
use crate::input::tank::values::{Density, Named, Number, Stress};
use laws::Behaviour;
use reader::Reader;
use tank::keys::{Absent, Limits, without};
use tank::{STRESS, VolumeChange};

/// Moduli from soft plastics (0.8 GPa) up: `210 MPa` for steel is a slip of the unit. From 1e17 Pa on the motion of a wall is lost in
/// the rounding of its stiffness: the shear of example 01 was 2.4 times that of a rigid wall at 2e17 Pa.
const MODULUS: Limits = Limits::above(0.5e9).to(1e16);
/// Wall materials.
const DENSITY: Limits = Limits::from(1.0).to(30_000.0);
/// Largest number of materials in a file.
pub(super) const MAX_MATERIALS: usize = 200;
/// Longest name of a material [characters]; every place that uses it stores a copy.
pub(super) const MAX_NAME: usize = 100;

object! {
    /// A material. Its elastic values serve the code procedures and the linear engines; its behaviour beyond them the
    /// nonlinear engine.
    Material {
        /// Grade that supplies the values missing here. Strengths of steel and aluminium are those of the thickest plate of this
        /// material: give plates of other thicknesses a material of their own to use all of their strength. Case, blanks, hyphens and
        /// words such as "ASTM" and "Gr." do not count; `docs/grades.md` has values, sources and further names.
        ///
        /// Plates: S235, S275, S355 (EN 1993-1-1), S235JR, S275JR, S355JR, P235GH, P265GH, P295GH, P355N, P460NH, 1.4301, 1.4307,
        /// 1.4541, 1.4401, 1.4404, 1.4571, 1.4462, A36, A131 A, A283 C, A285 C, A516 55, A516 60, A516 65, A516 70, A537 1, A537 2,
        /// A573 58, A573 65, A573 70, A633 C, A662 B, A662 C, A678 A, A678 B, A737 B, A841 1, A841 2, G40.21 260W, G40.21 350W,
        /// G40.21 350WT, A553 I, A240 304, A240 304L, A240 316, A240 316L, EN AW-5083, EN AW-6061-T6, EN AW-6061-T6 welded.
        ///
        /// Concrete: C20/25, C25/30, C30/37, C35/45, C40/50, C45/55, C50/60, B25, B35, B45. Bars: B500, B500A, B500B, B500C, BSt500.
        grade ("S355"): Opt<String>,
        /// Family. Each code has rules for some families, and the checks of a wall of an unknown one stay open. Moduli and densities of
        /// carbon steel, stainless steel, aluminium, concrete and plastics decide where no other family has them.
        family ("carbon_steel"): Opt<tank::Family>
            = Absent::Follows("that of the grade or behaviour, or the only one with this Young's modulus and density"),
        /// Young's modulus. Not for an interlayer, which has e_normal.
        youngs_modulus ("210 GPa"): Opt<Stress> [MODULUS] = Absent::Follows("that of the grade; needed without one"),
        /// Poisson's ratio. Not for an interlayer, which has e_normal.
        poisson_ratio (0.3): Opt<Number> [Limits::from(0.0).below(0.5)]
            = Absent::Follows("that of the grade; needed without one"),
        /// Density. Usual for walls are 500 to 20000 kg/m3.
        density ("7850 kg/m3"): Opt<Density> [DENSITY] = Absent::Follows("that of the grade; needed without one"),
        /// Yield strength (characteristic), needed by the stability and anchorage checks. Usual is up to 2 GPa and up to 1 % of
        /// Young's modulus (plastics: 5 %); more than a tenth of it is rejected. A grade supplies its own.
        yield_strength ("235 MPa"): Opt<Stress> [STRESS] = without("checks that need it are left out"),
        /// Allowable design stress S_d (API 650 table 5-2; annex S or AL), needed by the API hoop-stress check. A grade of table 5-2 or of ASTM A240
        /// supplies its own.
        allowable_stress ("160 MPa"): Opt<Stress> [STRESS] = without("the API hoop-stress check is left out"),
        /// Values at `tank.design_temperature`, which then take the place of those at room temperature.
        hot: Opt<Hot> = Absent::Follows("the values at room temperature"),
        /// Behaviour beyond the elastic range.
        behaviour: Opt<Behaviour> = Absent::Follows("that of the grade; elastic without one"),
        /// Expansion, shrinkage and creep of walls of shells in the state at rest of the nonlinear engine.
        volume_change: Opt<Given<VolumeChange>> = Absent::Follows("neither shrinkage nor creep"),
    }
}

object! {
    /// Values of a metal at the design temperature of the tank, from the standard of the material or API 650 annex M or S.
    Hot {
        /// Young's modulus there; at most that at room temperature.
        youngs_modulus ("195 GPa"): Field<Stress> [MODULUS],
        /// Yield strength there; at most that at room temperature.
        yield_strength ("205 MPa"): Field<Stress> [STRESS],
        /// Allowable design stress S_d there, needed by the API hoop-stress check.
        allowable_stress ("137 MPa"): Opt<Stress> [STRESS]
            = Absent::Follows("the lesser of that at room temperature and 2/3 of the yield strength there (API 650 M.3.2)"),
    }
}

/// Materials by name; `None` for a faulty one, so that places that use it are not reported as well.
pub(super) type Materials = BTreeMap<String, Option<tank::Material>>;

/// Reads all materials.
///
/// * `plates`: thickness of the thickest plate [m] by the name of the material
pub(super) fn materials(
    r: &mut Resolver<'_>,
    field: &Field<Named<Material>>,
    plates: &BTreeMap<&str, f64>,
) -> Materials {
    let mut all = Materials::new();
    let Some(named) = &field.value else { return all };
    if named.0.is_empty() {
        let message = "the list of materials is empty";
        r.refuse(Code::ItemCount, field, message, "at least one material");
    }
    if named.0.len() > MAX_MATERIALS {
        let message = "too many materials";
        let allowed = format!("at most {MAX_MATERIALS} materials");
        let fault = range_fault(Code::ItemCount, field, message, &allowed);
        r.faults.push(fault.found(format!("{} materials", named.0.len())));
        return named.0.iter().map(|(name, _)| (name.clone(), None)).collect();
    }
    for (name, field) in &named.0 {
        if name.chars().count() > MAX_NAME {
            let allowed = format!("a name of at most {MAX_NAME} characters");
            r.faults.push(
                range_fault(Code::BadForm, field, "the name of a material is too long", &allowed).found(name.as_str()),
            );
            all.insert(name.clone(), None);
            continue;
        }
        let thickness = plates.get(name.as_str()).copied().unwrap_or(0.0);
        let material = (field.value.as_ref()).and_then(|m| material(r, name, field, m, thickness));
        all.insert(name.clone(), material);
    }
    all
}

fn material(
    r: &mut Resolver<'_>,
    name: &str,
    field: &Field<Material>,
    m: &Material,
    thickness: f64,
) -> Option<tank::Material> {
    let mut reader = Reader {
        preset: preset(r, m.grade.given.as_ref(), thickness)?,
        path: field.path.clone(),
        head: field.span.start..field.span.start + 1,
    };
    let kinds = match &m.behaviour.given {
        None => None,
        Some(field) => Some((field, field.value.as_ref()?)),
    };
    let interlayer = kinds
        .as_ref()
        .is_some_and(|(_, value)| matches!(value, Behaviour::Kinds(kinds) if kinds.interlayer.given.is_some()));
    let (youngs_modulus, poisson_ratio) = if interlayer {
        let allowed = "only e_normal, e_parallel and shear_modulus";
        for (key, given) in [("youngs_modulus", m.youngs_modulus.place()), ("poisson_ratio", m.poisson_ratio.place())] {
            if let Some(given) = given {
                let message = format!("{key} does not apply to an interlayer with e_normal");
                r.refuse(Code::DoesNotApply, &given, &message, allowed);
            }
        }
        (f64::NAN, 0.0)
    } else {
        let e = reader.needed(r, &m.youngs_modulus, |p| p.youngs_modulus);
        (e, reader.needed(r, &m.poisson_ratio, |p| p.poisson_ratio))
    };
    let density = reader.needed(r, &m.density, |p| p.density);
    let characteristic = |p: &Preset| match p.strengths {
        Strengths::Steel { yielding, .. } | Strengths::Bars { yielding, .. } => Some(yielding),
        Strengths::Concrete { .. } => None,
    };
    let yield_strength = match reader.preset.as_ref().and_then(characteristic) {
        Some(yielding) => Some(reader.supplied(r, &m.yield_strength, yielding)),
        None => r.optional(&m.yield_strength),
    };
    if let (Some(field), Some(strength)) = (&m.yield_strength.given, yield_strength) {
        yielding::check(r, field, strength, youngs_modulus);
    }
    let allowable_stress = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Steel { allowable: Some(stress), .. }) => Some(reader.supplied(r, &m.allowable_stress, stress)),
        _ => r.optional(&m.allowable_stress),
    };
    let (youngs_modulus, yield_strength, allowable_stress) = match m.hot.value() {
        Some(hot) => at_temperature(r, hot, youngs_modulus, yield_strength, allowable_stress),
        None => (youngs_modulus, yield_strength, allowable_stress),
    };
    reader.path = join(&field.path, "behaviour");
    let elastic = (youngs_modulus, yield_strength);
    let behaviour = match kinds {
        None => laws::of_grade(r, &reader, elastic),
        Some((field, Behaviour::Elastic)) => {
            r.echo_given(field);
            tank::Behaviour::Elastic
        }
        Some((field, Behaviour::Kinds(kinds))) => laws::of_file(r, &reader, field, kinds, elastic)?,
    };
    let family = family::family(r, m, &reader, &behaviour, [youngs_modulus, poisson_ratio, density]);
    let volume_change = volume_change(r, &m.volume_change, &behaviour);
    Some(tank::Material {
        family,
        name: name.into(),
        youngs_modulus: match behaviour {
            tank::Behaviour::Interlayer(layer) => layer.e_normal,
            _ => youngs_modulus,
        },
        poisson_ratio,
        density,
        yield_strength,
        allowable_stress,
        behaviour,
        volume_change,
    })
}

/// Changes of volume: bars and interlayers neither shrink nor creep.
fn volume_change(r: &mut Resolver<'_>, option: &Opt<Given<VolumeChange>>, behaviour: &tank::Behaviour) -> VolumeChange {
    let Some(given) = option.value() else { return VolumeChange::NONE };
    let Some(found) = given.resolve(r) else { return VolumeChange::NONE };
    if matches!(behaviour, tank::Behaviour::Reinforcement(_) | tank::Behaviour::Interlayer(_)) {
        let message = "bars and interlayers neither shrink nor creep";
        let allowed = "shrinkage and creep_coefficient of the material of a shell";
        r.inapplicable(&given.shrinkage, message, allowed);
        r.inapplicable(&given.creep_coefficient, message, allowed);
    } else if found.lasts() {
        r.remarks.push(format!(
            "{}: acts in the state at rest of the nonlinear engine; code procedures and linear engines leave it out",
            option.path
        ));
    }
    found
}

/// E, f_y and S_d [Pa] at the design temperature, from those at room temperature.
fn at_temperature(
    r: &mut Resolver<'_>,
    hot: &Hot,
    youngs_modulus: f64,
    yield_strength: Option<f64>,
    allowable_stress: Option<f64>,
) -> (f64, Option<f64>, Option<f64>) {
    let mut below = |field: &Field<Stress>, cold: Option<f64>| {
        let value = r.number(field);
        if let Some(cold) = cold.filter(|cold| value > *cold) {
            let allowed = format!("at most {}, that at room temperature", reader::like(field, cold));
            r.refuse(
                Code::Contradiction,
                field,
                "the value at the design temperature is above that at room temperature",
                &allowed,
            );
        }
        value
    };
    let e = below(&hot.youngs_modulus, Some(youngs_modulus));
    let yielding = below(&hot.yield_strength, yield_strength);
    let allowable = match &hot.allowable_stress.given {
        Some(field) => Some(below(field, allowable_stress)),
        None => allowable_stress.map(|cold| {
            let stress = cold.min(yielding / 1.5);
            let text = reader::shown::<Stress>(stress, 4);
            r.or_else(
                &hot.allowable_stress,
                stress,
                &text,
                "the lesser of S_d and 2/3 of the yield strength, API 650 M.3.2",
            )
        }),
    };
    (e, Some(yielding), allowable)
}

/// The grade; the outer `None` if it is unknown or the plates are too thick for it (already reported).
fn preset(r: &mut Resolver<'_>, field: Option<&Field<String>>, thickness: f64) -> Option<Option<Preset>> {
    let Some(field) = field else { return Some(None) };
    r.echo_given(field);
    let name = field.value.as_ref()?;
    let fault = match grades::find(name, thickness) {
        Found::Grade(preset) => return Some(Some(preset)),
        Found::TooThick(grade, thickest) => {
            let message = format!("the grade {grade} has no strengths for plates so thick");
            range_fault(Code::Contradiction, field, &message, &format!("plates of at most {} mm", 1e3 * thickest))
                .found(format!("\"{name}\" with a plate of {} mm", shown_thickness(thickness)))
                .help("give the values of the steel instead of `grade`, or a grade that has them")
        }
        Found::Unknown => {
            let (near, meant) = grades::near(name);
            let message = format!("unknown grade `{name}`");
            let fault = range_fault(Code::UnknownChoice, field, &message, &grades::allowed(&near));
            match meant {
                Some(meant) => fault.help(format!("did you mean \"{meant}\"?")),
                None => fault,
            }
        }
    };
    r.faults.push(fault);
    None
}

/// Millimetres without the rounding of a unit.
fn shown_thickness(thickness: f64) -> f64 {
    (thickness * 1e6).round() / 1e3
}
