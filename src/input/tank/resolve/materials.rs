//! Materials: elastic values, grades, and behaviour beyond the elastic range.

mod concrete;

use std::collections::BTreeMap;

use tank::units::{display_in, unit_for};
use tank::{Bar, Behaviour, Interlayer, Material, Steel};

use super::grades::{self, Preset, Strengths};
use super::{Limits, Resolver, plausible, range_fault};
use crate::input::tank::behaviour;
use crate::input::tank::read::{Field, FromNode, list, nearest};
use crate::input::tank::schema;
use crate::input::tank::syntax::join;
use crate::input::tank::values::{Named, Number, Si, Stress};

/// Moduli and strengths; "rigid" walls of benchmarks are allowed.
const STRESS: Limits = Limits::above(0.0).to(1e18);
/// Moduli from soft plastics (0.8 GPa) up: `210 MPa` for steel is a slip of the unit. From 1e17 Pa on the motion of a wall is lost in
/// the rounding of its stiffness: the shear of example 01 was 2.4 times that of a rigid wall at 2e17 Pa.
const MODULUS: Limits = Limits::above(0.5e9).to(1e16);
/// Wall materials.
const DENSITY: Limits = Limits::above(0.0).to(30_000.0);
/// Strengths of concrete: `35 kPa` is a slip of the unit.
const CONCRETE: Limits = Limits::above(1e6).to(500e6);
/// Stiffer than any material [Pa]: `3.0e9 kN/m2` for 3.0e9 N/m2 is a slip of the unit.
const STIFFEST_INTERLAYER: f64 = 1e11;

/// Most materials of a file.
pub(super) const MAX_MATERIALS: usize = 200;
/// Longest name of a material, in characters: every place that uses it carries a copy.
pub(super) const MAX_NAME: usize = 100;

/// Materials by name; `None` for a faulty one, so that its users are not blamed.
pub(super) type Materials = BTreeMap<String, Option<Material>>;

/// Reads all materials.
pub(super) fn materials(r: &mut Resolver<'_>, field: &Field<Named<schema::Material>>) -> Materials {
    let mut all = Materials::new();
    let Some(named) = &field.value else {
        return all;
    };
    if named.0.is_empty() {
        r.faults
            .push(range_fault(field, "no material", "at least one material"));
    }
    if named.0.len() > MAX_MATERIALS {
        let fault = range_fault(
            field,
            "too many materials",
            &format!("at most {MAX_MATERIALS} materials"),
        );
        r.faults.push(fault.found(format!("{} materials", named.0.len())));
        return named.0.iter().map(|(name, _)| (name.clone(), None)).collect();
    }
    for (name, field) in &named.0 {
        if name.chars().count() > MAX_NAME {
            let allowed = format!("a name of at most {MAX_NAME} characters");
            r.faults
                .push(range_fault(field, "the name of a material is too long", &allowed).found(name.as_str()));
            all.insert(name.clone(), None);
            continue;
        }
        let material = field.value.as_ref().and_then(|m| material(r, name, field, m));
        all.insert(name.clone(), material);
    }
    all
}

fn material(
    r: &mut Resolver<'_>,
    name: &str,
    field: &Field<schema::Material>,
    m: &schema::Material,
) -> Option<Material> {
    let mut reader = Reader {
        preset: preset(r, m.grade.as_ref())?,
        path: field.path.clone(),
        head: field.span.start..field.span.start + 1,
    };
    let kinds = match m.behaviour.as_ref().map(|f| (f, f.value.as_ref())) {
        None => None,
        Some((_, None)) => return None,
        Some((f, Some(value))) => Some((f, value)),
    };
    let interlayer = kinds
        .as_ref()
        .is_some_and(|(_, value)| matches!(value, behaviour::Behaviour::Kinds(kinds) if kinds.interlayer.is_some()));
    let (youngs_modulus, poisson_ratio) = if interlayer {
        let foreign = [
            ("youngs_modulus", m.youngs_modulus.as_ref().map(Field::place)),
            ("poisson_ratio", m.poisson_ratio.as_ref().map(Field::place)),
        ];
        for (key, given) in foreign {
            if let Some(given) = given {
                let message = format!("an interlayer has no {key} beside its e_normal");
                let allowed = "e_normal, e_parallel and shear_modulus alone";
                r.faults.push(range_fault(&given, &message, allowed));
            }
        }
        (f64::NAN, 0.0)
    } else {
        let e = reader.needed(r, "youngs_modulus", &m.youngs_modulus, MODULUS, |p| p.youngs_modulus);
        let limits = Limits::from(0.0).below(0.5);
        (
            e,
            reader.needed(r, "poisson_ratio", &m.poisson_ratio, limits, |p| p.poisson_ratio),
        )
    };
    let density = reader.needed(r, "density", &m.density, DENSITY, |p| p.density);
    let characteristic = |p: &Preset| match p.strengths {
        Strengths::Steel { yielding, .. } | Strengths::Bars { yielding, .. } => Some(yielding),
        Strengths::Concrete { .. } => None,
    };
    let yield_strength = match reader.preset.as_ref().and_then(characteristic) {
        Some(yielding) => Some(reader.supplied(r, "yield_strength", &m.yield_strength, STRESS, yielding)),
        None => r.optional(
            &reader.key("yield_strength"),
            &m.yield_strength,
            STRESS,
            "checks that need it are left out",
        ),
    };
    if let (Some(field), Some(strength)) = (&m.yield_strength, yield_strength) {
        plausible::yielding(r, field, strength, youngs_modulus);
    }
    let allowable_stress = r.optional(
        &reader.key("allowable_stress"),
        &m.allowable_stress,
        STRESS,
        "the API hoop-stress check is left out",
    );
    reader.path = join(&field.path, "behaviour");
    let elastic = (youngs_modulus, yield_strength);
    let behaviour = match kinds {
        None => from_grade(r, &reader, elastic),
        Some((field, behaviour::Behaviour::Elastic)) => {
            r.echo_given(field);
            Behaviour::Elastic
        }
        Some((field, behaviour::Behaviour::Kinds(kinds))) => kind(r, &reader, field, kinds, elastic)?,
    };
    Some(Material {
        name: name.into(),
        youngs_modulus: match behaviour {
            Behaviour::Interlayer(layer) => layer.e_normal,
            _ => youngs_modulus,
        },
        poisson_ratio,
        density,
        yield_strength,
        allowable_stress,
        behaviour,
    })
}

/// The grade; the outer `None` if it is unknown, which has been noted.
fn preset(r: &mut Resolver<'_>, field: Option<&Field<String>>) -> Option<Option<Preset>> {
    let Some(field) = field else { return Some(None) };
    r.echo_given(field);
    let name = field.value.as_ref()?;
    if let Some(preset) = grades::find(name) {
        return Some(Some(preset));
    }
    let names = grades::names();
    let mut fault = range_fault(field, &format!("unknown grade `{name}`"), &list(&names, "or"));
    if let Some(near) = nearest(name, names) {
        fault = fault.help(format!("did you mean \"{near}\"?"));
    }
    r.faults.push(fault);
    None
}

/// Where the values of a material come from.
struct Reader {
    preset: Option<Preset>,
    /// Path of the object that is read.
    path: String,
    /// Place to underline for what is missing.
    head: std::ops::Range<usize>,
}

impl Reader {
    fn key(&self, key: &str) -> String {
        join(&self.path, key)
    }

    /// A number that the file gives, or else the grade; NaN if it is faulty or missing, which is a fault.
    fn needed<T: Si + FromNode>(
        &self,
        r: &mut Resolver<'_>,
        key: &str,
        field: &Option<Field<T>>,
        limits: Limits,
        of: impl Fn(&Preset) -> f64,
    ) -> f64 {
        match (field, &self.preset) {
            (None, None) => self.missing::<T>(r, key, ""),
            (_, Some(preset)) => self.supplied(r, key, field, limits, of(preset)),
            (Some(field), None) => r.number(field, limits),
        }
    }

    /// A number that the file gives, or else this one of the grade.
    fn supplied<T: Si>(
        &self,
        r: &mut Resolver<'_>,
        key: &str,
        field: &Option<Field<T>>,
        limits: Limits,
        value: f64,
    ) -> f64 {
        match (field, &self.preset) {
            (Some(field), _) => r.number(field, limits),
            (None, preset) => {
                let text = display_in(value, unit_for(value, T::DIMENSION), 4);
                let source = match preset {
                    Some(preset) => format!("grade {}: {}", preset.name, preset.source),
                    None => String::new(),
                };
                r.echo_default(&self.key(key), &text, &source);
                value
            }
        }
    }

    /// Notes that a key is missing.
    fn missing<T: FromNode>(&self, r: &mut Resolver<'_>, key: &str, otherwise: &str) -> f64 {
        // A misspelt key has been noted already, with this one as the suggestion.
        if !r.faults.suggest(&format!("did you mean `{key}`?")) {
            let field = Field::<T> {
                value: None,
                span: self.head.clone(),
                path: self.key(key),
                text: String::new(),
            };
            r.faults.push(
                range_fault(&field, &format!("the key `{key}` is missing"), &T::allowed())
                    .help(format!("add \"{key}\": {}{otherwise}", T::example())),
            );
        }
        f64::NAN
    }
}

/// Young's modulus [Pa], and the yield strength of the material [Pa].
type ElasticPart = (f64, Option<f64>);

/// The behaviour that a grade brings along.
fn from_grade(r: &mut Resolver<'_>, reader: &Reader, elastic: ElasticPart) -> Behaviour {
    let Some(preset) = &reader.preset else {
        return Behaviour::Elastic;
    };
    let reader = reader.inside(preset.strengths.kind());
    match preset.strengths {
        Strengths::Steel { .. } => Behaviour::Steel(steel(r, &reader, &NO_STEEL, elastic)),
        Strengths::Concrete { .. } => Behaviour::Concrete(concrete::concrete(r, &reader, None, &NO_CONCRETE, elastic)),
        Strengths::Bars { .. } => Behaviour::Reinforcement(bars(r, &reader, &NO_BARS, elastic)),
    }
}

const NO_STEEL: schema::SteelBehaviour = schema::SteelBehaviour {
    yield_strength: None,
    tangent_modulus: None,
    hardening_modulus: None,
    kinematic_share: None,
    ultimate_strength: None,
};
const NO_BARS: schema::BarBehaviour = schema::BarBehaviour {
    yield_strength: None,
    tangent_modulus: None,
    rupture_strain: None,
};
const NO_CONCRETE: schema::ConcreteBehaviour = schema::ConcreteBehaviour {
    law: None,
    compressive_strength: None,
    biaxial_ratio: None,
    tensile_strength: None,
    fracture_energy: None,
    softening_strain: None,
    brittle: None,
    shear_retention: None,
    shear_retention_strain: None,
    tension_stiffening: None,
    crack_spacing: None,
};

impl Reader {
    /// The same for an object inside this one.
    fn inside(&self, key: &str) -> Reader {
        Reader {
            preset: self.preset.clone(),
            path: self.key(key),
            head: self.head.clone(),
        }
    }
}

/// The behaviour that the file gives.
fn kind(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: &Field<behaviour::Behaviour>,
    kinds: &schema::BehaviourKinds,
    elastic: ElasticPart,
) -> Option<Behaviour> {
    let given = [
        kinds.steel.as_ref().map(|f| ("steel", f.value.is_some())),
        kinds.concrete.as_ref().map(|f| ("concrete", f.value.is_some())),
        kinds
            .reinforcement
            .as_ref()
            .map(|f| ("reinforcement", f.value.is_some())),
        kinds.interlayer.as_ref().map(|f| ("interlayer", f.value.is_some())),
    ];
    let mut given = given.into_iter().flatten();
    let (Some((word, sound)), None) = (given.next(), given.next()) else {
        r.faults.push(range_fault(
            field,
            "one behaviour is wanted",
            "one of steel, concrete, reinforcement and interlayer, or \"elastic\"",
        ));
        return None;
    };
    if !sound {
        return None;
    }
    let mut reader = reader.inside(word);
    reader.head = field.span.start..field.span.start + 1;
    if let Some(preset) = &reader.preset
        && preset.strengths.kind() != word
    {
        let message = format!("the grade {} is {}", preset.name, preset.strengths.kind());
        let allowed = format!("\"elastic\" or {} with this grade", preset.strengths.kind());
        r.faults.push(range_fault(field, &message, &allowed).found(word));
        return None;
    }
    if let Some(Field { value: Some(s), .. }) = &kinds.steel {
        return Some(Behaviour::Steel(steel(r, &reader, s, elastic)));
    }
    if let Some(f) = &kinds.concrete
        && let Some(c) = &f.value
    {
        return Some(Behaviour::Concrete(concrete::concrete(r, &reader, Some(f), c, elastic)));
    }
    if let Some(Field { value: Some(b), .. }) = &kinds.reinforcement {
        return Some(Behaviour::Reinforcement(bars(r, &reader, b, elastic)));
    }
    let layer = kinds.interlayer.as_ref()?.value.as_ref()?;
    Some(Behaviour::Interlayer(interlayer(r, &reader, layer)))
}

/// The yield strength of a law: its own, or that of the material.
fn yielding(r: &mut Resolver<'_>, reader: &Reader, field: &Option<Field<Stress>>, (e, material): ElasticPart) -> f64 {
    match (field, material) {
        (Some(field), _) => {
            let strength = r.number(field, STRESS);
            plausible::yielding(r, field, strength, e);
            strength
        }
        (None, Some(strength)) => {
            let text = display_in(strength, unit_for(strength, Stress::DIMENSION), 4);
            r.echo_default(&reader.key("yield_strength"), &text, "yield_strength of the material");
            strength
        }
        (None, None) => reader.missing::<Stress>(r, "yield_strength", ", here or in the material"),
    }
}

/// Slope beyond yielding, from 0 to below Young's modulus.
fn tangent(r: &mut Resolver<'_>, reader: &Reader, field: &Option<Field<Stress>>, e: f64) -> f64 {
    let limits = Limits::from(0.0).to(1e18);
    let key = "tangent_modulus";
    let slope = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Steel { tangent, .. } | Strengths::Bars { tangent, .. }) => {
            reader.supplied(r, key, field, limits, tangent)
        }
        _ => r.or_default(&reader.key(key), field, limits, Stress(0.0), "0 Pa", "no hardening"),
    };
    if let (Some(field), true) = (field, slope >= e) {
        let allowed = format!("at least 0, less than Young's modulus, {}", like(field, e));
        r.faults.push(range_fault(
            field,
            "beyond yielding the stress would rise faster than before",
            &allowed,
        ));
        return f64::NAN;
    }
    slope
}

fn steel(r: &mut Resolver<'_>, reader: &Reader, s: &schema::SteelBehaviour, (e, strength): ElasticPart) -> Steel {
    let yield_strength = yielding(r, reader, &s.yield_strength, (e, strength));
    let tangent_modulus = match (&s.hardening_modulus, &s.tangent_modulus) {
        (Some(field), Some(_)) => {
            r.faults.push(range_fault(
                field,
                "two slopes beyond yielding",
                "either tangent_modulus or hardening_modulus",
            ));
            f64::NAN
        }
        (Some(field), None) => {
            let h = r.number(field, Limits::from(0.0).to(1e18));
            e * h / (e + h)
        }
        (None, given) => tangent(r, reader, given, e),
    };
    let kinematic_share = r.or_default(
        &reader.key("kinematic_share"),
        &s.kinematic_share,
        Limits::from(0.0).to(1.0),
        Number(1.0),
        "1",
        "kinematic hardening, for cyclic loading",
    );
    let ultimate_strength = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Steel { ultimate, .. }) => {
            Some(reader.supplied(r, "ultimate_strength", &s.ultimate_strength, STRESS, ultimate))
        }
        _ => r.optional(
            &reader.key("ultimate_strength"),
            &s.ultimate_strength,
            STRESS,
            "no limit",
        ),
    };
    if let (Some(field), Some(ultimate)) = (&s.ultimate_strength, ultimate_strength)
        && ultimate <= yield_strength
    {
        let allowed = format!("more than the yield strength, {}", like(field, yield_strength));
        r.faults.push(range_fault(
            field,
            "the tensile strength is not above the yield strength",
            &allowed,
        ));
    }
    Steel {
        yield_strength,
        tangent_modulus,
        kinematic_share,
        ultimate_strength,
    }
}

fn bars(r: &mut Resolver<'_>, reader: &Reader, b: &schema::BarBehaviour, (e, strength): ElasticPart) -> Bar {
    let yield_strength = yielding(r, reader, &b.yield_strength, (e, strength));
    let tangent_modulus = tangent(r, reader, &b.tangent_modulus, e);
    let limits = Limits::above(0.0).to(1.0);
    let rupture_strain = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Bars { rupture, .. }) => {
            Some(reader.supplied(r, "rupture_strain", &b.rupture_strain, limits, rupture))
        }
        _ => r.optional(&reader.key("rupture_strain"), &b.rupture_strain, limits, "no limit"),
    };
    if let (Some(field), Some(rupture)) = (&b.rupture_strain, rupture_strain)
        && rupture <= yield_strength / e
    {
        let allowed = format!("more than the strain at yielding, {:.2e}", yield_strength / e);
        r.faults
            .push(range_fault(field, "the bars would break before they yield", &allowed));
    }
    Bar {
        yield_strength,
        tangent_modulus,
        rupture_strain,
    }
}

fn interlayer(r: &mut Resolver<'_>, reader: &Reader, l: &schema::InterlayerBehaviour) -> Interlayer {
    let e_normal = r.number(&l.e_normal, STRESS);
    if e_normal > STIFFEST_INTERLAYER {
        r.remarks.push(format!(
            "{}: found \"{}\", which is stiffer than concrete and steel and above 1e8 kN/m2: kN/m2 for N/m2?",
            l.e_normal.path, l.e_normal.text
        ));
    }
    let e_parallel = r.or_default(
        &reader.key("e_parallel"),
        &l.e_parallel,
        Limits::from(0.0).to(1e18),
        Stress(0.0),
        "0 Pa",
        "stiff along the normal only",
    );
    let shear_modulus = r.or_default(
        &reader.key("shear_modulus"),
        &l.shear_modulus,
        Limits::from(0.0).to(1e18),
        Stress(0.0),
        "0 Pa",
        "passes no shear",
    );
    if let Some(tension) = &l.tension {
        r.echo_given(tension);
    } else {
        r.echo_default(&reader.key("tension"), "true", "glued");
    }
    Interlayer {
        e_normal,
        e_parallel,
        shear_modulus,
        tension: l.tension.as_ref().is_none_or(|t| t.value != Some(false)),
    }
}

/// A stress in the unit in which a field gives it.
fn like(field: &Field<Stress>, stress: f64) -> String {
    super::like_unit(field, stress, Stress::DIMENSION)
}
