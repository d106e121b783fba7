//! `behaviour` of a material beyond its elastic range.

use files::code::Code;
use tank::{Bar, Interlayer, SLOPE, STRESS, Steel};

use super::concrete::{self, ConcreteBehaviour};
use super::reader::{ElasticPart, Reader, like, shown};
use super::yielding;
use crate::input::diagnostic::Faults;
use crate::input::tank::given::Given;
use crate::input::tank::keys::grades::Strengths;
use crate::input::tank::read::{Field, FromNode, Object, Opt, object, other_kind, wrong_value};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Number, Stress};
use tank::keys::{Absent, Limits, default, without};

/// Stiffer than any material [Pa]: `3.0e9 kN/m2` for 3.0e9 N/m2 is a slip of the unit.
const STIFFEST_INTERLAYER: f64 = 1e11;

object! {
    /// Behaviour of a material beyond its elastic range. Give one of them.
    BehaviourKinds {
        /// Steel that yields.
        steel: Opt<SteelBehaviour>,
        /// Concrete that cracks and crushes.
        concrete: Opt<ConcreteBehaviour>,
        /// Bars in concrete.
        reinforcement: Opt<BarBehaviour>,
        /// Elastic layer between two shells.
        interlayer: Opt<Given<Interlayer>>,
    }

    /// Steel that yields: von Mises, linear hardening.
    SteelBehaviour {
        /// Yield strength of the law.
        yield_strength ("355 MPa"): Opt<Stress> [STRESS] = Absent::Follows("yield_strength of the material"),
        /// Slope of the stress-strain line beyond yielding; a grade supplies its own. Give either this or hardening_modulus.
        tangent_modulus ("2.1 GPa"): Opt<Stress> [SLOPE] = default(Stress(0.0)).because("no hardening"),
        /// Slope of the stress against the plastic strain.
        hardening_modulus ("2.1 GPa"): Opt<Stress> [SLOPE],
        /// Share of kinematic hardening, from 0 (isotropic) to 1 (kinematic).
        kinematic_share (0.5): Opt<Number> [Limits::from(0.0).to(1.0)]
            = default(Number(1.0)).because("kinematic hardening, for cyclic loading"),
        /// Tensile strength: larger stresses are reported. A grade supplies its own.
        ultimate_strength ("490 MPa"): Opt<Stress> [STRESS] = without("no limit"),
    }

    /// Bars in concrete: uniaxial, linear kinematic hardening.
    BarBehaviour {
        /// Yield strength of the law.
        yield_strength ("500 MPa"): Opt<Stress> [STRESS] = Absent::Follows("yield_strength of the material"),
        /// Slope of the stress-strain line beyond yielding; a grade supplies its own.
        tangent_modulus ("1 GPa"): Opt<Stress> [SLOPE] = default(Stress(0.0)).because("no hardening"),
        /// Strain at rupture: larger strains are reported. A grade supplies its own.
        rupture_strain (0.05): Opt<Number> [Limits::above(0.0).to(1.0)] = without("no limit"),
    }
}

/// The word `"elastic"`, or an object with the parameters of another behaviour.
#[derive(Debug)]
pub(crate) enum Behaviour {
    Elastic,
    Kinds(Box<BehaviourKinds>),
}

impl FromNode for Behaviour {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Text(text) if text == "elastic" => Some(Behaviour::Elastic),
            Kind::Object(_) => BehaviourKinds::from_node(node, faults).map(|kinds| Behaviour::Kinds(Box::new(kinds))),
            Kind::Text(text) => {
                let mut fault =
                    wrong_value(Code::UnknownChoice, node, &format!("unknown behaviour `{text}`"), &Self::allowed());
                if ["steel", "concrete", "reinforcement", "interlayer"].contains(&text.as_str()) {
                    fault = fault.help(format!("write {{ \"{text}\": {{ … }} }}"));
                }
                faults.push(fault);
                None
            }
            _ => other_kind(node, faults),
        }
    }
    fn allowed() -> String {
        "\"elastic\", or an object with steel, concrete, reinforcement or interlayer".into()
    }
    fn example() -> String {
        "{ \"steel\": { … } }".into()
    }
    fn shape(book: &mut Book) -> Shape {
        Shape::Either("elastic", Box::new(BehaviourKinds::shape(book)))
    }
}

/// The behaviour of a grade.
pub(super) fn of_grade(r: &mut Resolver<'_>, reader: &Reader, elastic: ElasticPart) -> tank::Behaviour {
    let Some(preset) = &reader.preset else { return tank::Behaviour::Elastic };
    let reader = reader.inside(preset.strengths.kind());
    match preset.strengths {
        Strengths::Steel { .. } => {
            tank::Behaviour::Steel(steel(r, &reader, &SteelBehaviour::absent(&reader.path), elastic))
        }
        Strengths::Concrete { .. } => {
            let absent = ConcreteBehaviour::absent(&reader.path);
            tank::Behaviour::Concrete(concrete::concrete(r, &reader, None, &absent, elastic))
        }
        Strengths::Bars { .. } => {
            tank::Behaviour::Reinforcement(bars(r, &reader, &BarBehaviour::absent(&reader.path), elastic))
        }
    }
}

/// The behaviour in the file.
pub(super) fn of_file(
    r: &mut Resolver<'_>,
    reader: &Reader,
    field: &Field<Behaviour>,
    kinds: &BehaviourKinds,
    elastic: ElasticPart,
) -> Option<tank::Behaviour> {
    let given = [
        kinds.steel.given.as_ref().map(|f| ("steel", f.value.is_some())),
        kinds.concrete.given.as_ref().map(|f| ("concrete", f.value.is_some())),
        (kinds.reinforcement.given.as_ref()).map(|f| ("reinforcement", f.value.is_some())),
        kinds.interlayer.given.as_ref().map(|f| ("interlayer", f.value.is_some())),
    ];
    let mut given = given.into_iter().flatten();
    let (Some((word, sound)), None) = (given.next(), given.next()) else {
        let message = "not exactly one behaviour";
        let allowed = "one of steel, concrete, reinforcement and interlayer, or \"elastic\"";
        r.refuse(Code::Exclusive, field, message, allowed);
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
        r.faults.push(range_fault(Code::UnknownChoice, field, &message, &allowed).found(word));
        return None;
    }
    if let Some(s) = kinds.steel.value() {
        return Some(tank::Behaviour::Steel(steel(r, &reader, s, elastic)));
    }
    if let Some(f) = &kinds.concrete.given
        && let Some(c) = &f.value
    {
        let concrete = concrete::concrete(r, &reader, Some(f), c, elastic);
        return Some(tank::Behaviour::Concrete(concrete));
    }
    if let Some(b) = kinds.reinforcement.value() {
        return Some(tank::Behaviour::Reinforcement(bars(r, &reader, b, elastic)));
    }
    interlayer(r, kinds.interlayer.value()?).map(tank::Behaviour::Interlayer)
}

/// The yield strength of a law: its own, or that of the material.
fn yielding(r: &mut Resolver<'_>, reader: &Reader, option: &Opt<Stress>, (e, material): ElasticPart) -> f64 {
    match (&option.given, material) {
        (Some(field), _) => {
            let strength = r.number(field);
            yielding::check(r, field, strength, e);
            strength
        }
        (None, Some(strength)) => {
            let text = shown::<Stress>(strength, 4);
            r.or_else(option, strength, &text, "yield_strength of the material")
        }
        (None, None) => reader.missing(r, option, ", here or in the material"),
    }
}

/// Slope beyond yielding, from 0 to below Young's modulus.
fn tangent(r: &mut Resolver<'_>, reader: &Reader, option: &Opt<Stress>, e: f64) -> f64 {
    let slope = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Steel { tangent, .. } | Strengths::Bars { tangent, .. }) => reader.supplied(r, option, tangent),
        _ => r.or_default(option),
    };
    if let (Some(field), true) = (&option.given, slope >= e) {
        let allowed = format!("at least 0, less than Young's modulus, {}", like(field, e));
        let message = "the slope after yielding is not smaller than Young's modulus";
        r.refuse(Code::Contradiction, field, message, &allowed);
        return f64::NAN;
    }
    slope
}

fn steel(r: &mut Resolver<'_>, reader: &Reader, s: &SteelBehaviour, (e, strength): ElasticPart) -> Steel {
    let yield_strength = yielding(r, reader, &s.yield_strength, (e, strength));
    let tangent_modulus = match (&s.hardening_modulus.given, &s.tangent_modulus.given) {
        (Some(field), Some(_)) => {
            let message = "two slopes beyond yielding";
            let allowed = "either tangent_modulus or hardening_modulus";
            r.refuse(Code::Exclusive, field, message, allowed);
            f64::NAN
        }
        (Some(field), None) => {
            let h = r.number(field);
            e * h / (e + h)
        }
        (None, _) => tangent(r, reader, &s.tangent_modulus, e),
    };
    let kinematic_share = r.or_default(&s.kinematic_share);
    let ultimate_strength = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Steel { ultimate, .. }) => Some(reader.supplied(r, &s.ultimate_strength, ultimate)),
        _ => r.optional(&s.ultimate_strength),
    };
    if let (Some(field), Some(ultimate)) = (&s.ultimate_strength.given, ultimate_strength)
        && ultimate <= yield_strength
    {
        let allowed = format!("more than the yield strength, {}", like(field, yield_strength));
        let message = "the tensile strength is not above the yield strength";
        r.refuse(Code::Contradiction, field, message, &allowed);
    }
    Steel { yield_strength, tangent_modulus, kinematic_share, ultimate_strength }
}

fn bars(r: &mut Resolver<'_>, reader: &Reader, b: &BarBehaviour, (e, strength): ElasticPart) -> Bar {
    let yield_strength = yielding(r, reader, &b.yield_strength, (e, strength));
    let tangent_modulus = tangent(r, reader, &b.tangent_modulus, e);
    let rupture_strain = match reader.preset.as_ref().map(|p| p.strengths) {
        Some(Strengths::Bars { rupture, .. }) => Some(reader.supplied(r, &b.rupture_strain, rupture)),
        _ => r.optional(&b.rupture_strain),
    };
    if let (Some(field), Some(rupture)) = (&b.rupture_strain.given, rupture_strain)
        && rupture <= yield_strength / e
    {
        let allowed = format!("more than the strain at yielding, {:.2e}", yield_strength / e);
        r.refuse(Code::Contradiction, field, "the bars break before they yield", &allowed);
    }
    Bar { yield_strength, tangent_modulus, rupture_strain }
}

fn interlayer(r: &mut Resolver<'_>, l: &Given<Interlayer>) -> Option<Interlayer> {
    let found = l.resolve(r)?;
    if found.e_normal > STIFFEST_INTERLAYER {
        r.remarks.push(format!(
            "{}: found \"{}\", which is above 1e8 kN/m2 and stiffer than steel; check the unit (kN/m2 instead of N/m2?)",
            l.e_normal.path, l.e_normal.text
        ));
    }
    Some(found)
}
