//! `analysis.nonlinear`: options of the nonlinear engine.

use files::code::Code;
use tank::case;
use tank::options::NonlinearOptions;
use tank::options::nonlinear::{
    Contact, Damping, Integration, LiquidForm, MOST_ROWS, MOST_SECTORS, MassProportionalAt, StepLength, StripWall,
    ThicknessRule, WallElements,
};
use tank::{Shape, Tank, WallTemperature};

use super::damping::RATIO;
use super::rayleigh::{Rayleigh, rayleigh};
use crate::input::diagnostic::Faults;
use crate::input::tank::choice::choice;
use crate::input::tank::given::{Given, within};
use crate::input::tank::read::{Field, FromNode, Opt, object, text_of, wrong_value};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::shape::{Book, Shape as Looks};
use crate::input::tank::syntax::Node;
use crate::input::tank::values::{Number, Pitch, Whole};
use tank::keys::{Absent, Limits};

object! {
    /// Numbers of elements of the wall.
    Elements {
        /// Over the height of the wall.
        height (40): Field<Whole> [Limits::count(1, MOST_ROWS)],
        /// Around a cylinder, even unless symmetry is false, or along the whole perimeter of a rectangle. Both need it; it does not
        /// apply to a strip.
        circumference (64): Opt<Whole> [Limits::count(8, MOST_SECTORS)],
    }

    /// Damping of the nonlinear engine. Give one of the three.
    NonlinearDamping {
        /// Stiffness-proportional in the wall, a ratio for every sloshing mode.
        by_group: Opt<ByGroup>,
        /// Rayleigh damping fitted to two ratios.
        rayleigh: Opt<Rayleigh>,
        /// Proportional to the mass. The wall is almost undamped: the ratio at its modes is a hundredth or less of that at the
        /// first sloshing mode.
        mass_proportional: Opt<MassProportional>,
    }

    /// Damping ratios by group.
    ByGroup {
        /// Ratio of the first mode of wall and liquid.
        wall (0.02): Opt<Number> [RATIO] = Absent::Follows("damping.impulsive"),
        /// Ratio of every sloshing mode.
        sloshing (0.005): Opt<Number> [RATIO] = Absent::Follows("damping.sloshing"),
    }

    /// Damping proportional to the mass.
    MassProportional {
        /// Damping ratio.
        ratio (0.02): Field<Number> [RATIO],
        /// Where it holds.
        at ("2.39 rad/s"): Opt<Pitch> = Absent::Follows("at the first sloshing mode"),
    }
}

choice!(Contact, StripWall, LiquidForm, StepLength);

/// Name of a rule, the rule, and the fewest and the most points it has.
type Known = (&'static str, fn(u32) -> ThicknessRule, u32, u32);

/// The rules.
const RULES: [Known; 5] = [
    ("gauss", ThicknessRule::Gauss, 2, 64),
    ("lobatto", ThicknessRule::Lobatto, 3, 64),
    ("midpoint", ThicknessRule::MidPoint, 2, 200),
    ("simpson", ThicknessRule::Simpson, 3, 199),
    ("trapezoid", ThicknessRule::Trapezoid, 2, 200),
];

/// Quadrature through the thickness: a rule and its number of points.
impl FromNode for ThicknessRule {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let text = text_of::<Self>(node, faults)?;
        let mut words = text.split_whitespace();
        let name = words.next().unwrap_or_default().to_lowercase();
        let count: Option<u32> = words.next().and_then(|n| n.parse().ok());
        let message = match (RULES.iter().find(|(rule, ..)| *rule == name), count, words.next()) {
            (Some((_, rule, least, most)), Some(n), None) if (*least..=*most).contains(&n) => match rule(n) {
                ThicknessRule::Simpson(n) if n % 2 == 0 => "Simpson's rule needs an odd number of points",
                rule => return Some(rule),
            },
            (Some(_), Some(_), None) => "too few or too many points",
            _ => "not a rule with its number of points",
        };
        faults.push(wrong_value(Code::BadForm, node, message, &Self::allowed()));
        None
    }
    fn allowed() -> String {
        "a rule with its number of points such as \"gauss 5\" (2 to 64), \"lobatto 7\" (3 to 64), \"midpoint 20\" (2 to 200), \
         \"simpson 9\" (3 to 199, odd) or \"trapezoid 9\" (2 to 200)"
            .into()
    }
    fn example() -> String {
        "\"gauss 5\"".into()
    }
    fn shape(_: &mut Book) -> Looks {
        Looks::Pattern {
            noun: Self::allowed(),
            patterns: vec!["^(gauss|lobatto|midpoint|simpson|trapezoid) +[1-9][0-9]{0,2}$".into()],
            examples: &["gauss 5", "midpoint 20"],
        }
    }
    fn written(&self) -> Option<String> {
        let (rule, n) = match *self {
            ThicknessRule::Gauss(n) => ("gauss", n),
            ThicknessRule::Lobatto(n) => ("lobatto", n),
            ThicknessRule::MidPoint(n) => ("midpoint", n),
            ThicknessRule::Simpson(n) => ("simpson", n),
            ThicknessRule::Trapezoid(n) => ("trapezoid", n),
        };
        Some(format!("{rule} {n}"))
    }
}

/// Options of the nonlinear engine; defaults are echoed if any is given.
///
/// * `ratios`: damping ratios of the case
pub(super) fn nonlinear(
    r: &mut Resolver<'_>,
    given: Option<&Given<NonlinearOptions>>,
    tank: Option<&Tank>,
    ratios: case::Damping,
) -> NonlinearOptions {
    r.known.shape = tank.map(|t| t.shape);
    r.known.ratios = Some(ratios);
    let Some((given, found)) = given.and_then(|given| Some((given, given.resolve(r)?))) else {
        return NonlinearOptions::new(ratios);
    };
    let strip = r.known.shape.map(|s| matches!(s, Shape::Rectangle { strip: true, .. }));
    if strip == Some(true) {
        let allowed = "symmetry for a cylinder or a rectangle";
        r.inapplicable(&given.symmetry, "symmetry does not apply to a strip", allowed);
    }
    if strip == Some(false) {
        let allowed = "no `wall`: walls of this tank are shells";
        r.inapplicable(&given.wall, "wall applies to a strip alone", allowed);
        let allowed = "no `liquid`: that of this tank is condensed onto its walls";
        r.inapplicable(&given.liquid, "liquid applies to a strip alone", allowed);
    }
    if found.liquid == LiquidForm::Condensed {
        let allowed = "\"liquid\": \"displacement\" beside it";
        r.inapplicable(&given.liquid_elements, "liquid_elements applies to a displacement liquid alone", allowed);
        r.inapplicable(&given.contact_tangential, "contact_tangential applies to a displacement liquid alone", allowed);
    }
    let cylinder = (r.known.shape).map(|s| matches!(s, Shape::Cylinder { .. }));
    if found.symmetry && cylinder == Some(true) {
        halves(r, &given.elements);
    }
    // An impact of opening contact has no smooth acceleration to estimate errors by.
    if found.step == StepLength::Adaptive && (cylinder == Some(false) || found.contact == Contact::Opening) {
        let message = "adaptive steps are for cylinders with bonded liquid";
        r.inapplicable(&given.step, message, "\"fixed\"");
    }
    found
}

within! {
    Option<WallElements> => Elements, elements;
    Damping => NonlinearDamping, damping;
    Integration => Given<Integration>, integration;
    Option<WallTemperature> => Given<WallTemperature>, temperature;
}

fn elements(r: &mut Resolver<'_>, option: &Opt<Elements, ()>) -> Option<WallElements> {
    let Some(field) = &option.given else {
        r.not_given(option);
        return None;
    };
    let given = field.value.as_ref()?;
    let height = r.count(&given.height);
    let strip = r.known.shape.map(|s| matches!(s, Shape::Rectangle { strip: true, .. }));
    let circumference = match (&given.circumference.given, strip) {
        (Some(field), Some(true)) => {
            let message = "circumference does not apply to a strip";
            r.refuse(Code::DoesNotApply, field, message, "only height for a strip");
            None
        }
        (Some(field), _) => r.count(field),
        (None, Some(false)) => {
            r.faults.push(
                range_fault(
                    Code::MissingKey,
                    field,
                    "the key `circumference` is missing",
                    &format!("a whole number from 8 to {MOST_SECTORS}"),
                )
                .found("only height")
                .help("add \"circumference\": 64"),
            );
            None
        }
        (None, _) => Some(1),
    };
    Some(WallElements { height: height?, circumference: circumference? })
}

/// Half a cylinder has half of the elements around the circumference, so their number must be even.
fn halves(r: &mut Resolver<'_>, option: &Opt<Elements, ()>) {
    let given = option.value().and_then(|e| e.circumference.given.as_ref());
    if let Some((field, Whole(around))) = given.and_then(|f| Some((f, f.value?)))
        && around % 2 == 1
    {
        let message = "half a tank needs an even number of elements around the whole circumference";
        let allowed = "an even number";
        let fault = range_fault(Code::Contradiction, field, message, allowed);
        r.faults.push(fault.help(format!("write {}, or add \"symmetry\": false", around + 1)));
    }
}

fn integration(r: &mut Resolver<'_>, option: &Opt<Given<Integration>, ()>) -> Integration {
    match option.value() {
        Some(rules) => rules.resolve(r).unwrap_or_default(),
        None => {
            r.echo_default(&option.path, "gauss 2, gauss 5, midpoint 20", "elastic layers, steel, concrete");
            Integration::DEFAULT
        }
    }
}

fn temperature(r: &mut Resolver<'_>, option: &Opt<Given<WallTemperature>, ()>) -> Option<WallTemperature> {
    let found = option.value()?.resolve(r)?;
    r.remarks.push(format!(
        "{}: acts in the state at rest of the nonlinear engine; code procedures and linear engines leave it out",
        option.path
    ));
    Some(found)
}

/// Ratios of wall and sloshing.
pub(super) fn by_group(r: &mut Resolver<'_>, group: &ByGroup, ratios: case::Damping) -> (f64, f64) {
    let mut ratio = |option: &Opt<Number>, otherwise: f64, source: &str| {
        r.or_else(option, otherwise, &otherwise.to_string(), source)
    };
    (
        ratio(&group.wall, ratios.impulsive, "damping.impulsive"),
        ratio(&group.sloshing, ratios.sloshing, "damping.sloshing"),
    )
}

fn damping(r: &mut Resolver<'_>, option: &Opt<NonlinearDamping, ()>) -> Damping {
    let unknown = case::Damping { sloshing: f64::NAN, impulsive: f64::NAN };
    let ratios = r.known.ratios.unwrap_or(unknown);
    let default = Damping::ByGroup { wall: ratios.impulsive, sloshing: ratios.sloshing };
    let Some(field) = &option.given else {
        r.echo_default(&option.path, "by group", "the ratios of `damping`");
        return default;
    };
    let Some(given) = &field.value else { return default };
    match (&given.by_group.given, &given.rayleigh.given, &given.mass_proportional.given) {
        (Some(group), None, None) => {
            let Some(group) = &group.value else { return default };
            let (wall, sloshing) = by_group(r, group, ratios);
            Damping::ByGroup { wall, sloshing }
        }
        (None, Some(field), None) => match &field.value {
            Some(given) => {
                let (first, second, allow_negative) = rayleigh(r, given);
                Damping::Rayleigh { first, second, allow_negative }
            }
            None => default,
        },
        (None, None, Some(mass)) => {
            let Some(mass) = &mass.value else { return default };
            let ratio = r.number(&mass.ratio);
            let at = match &mass.at.given {
                Some(at) => {
                    r.echo_given(at);
                    MassProportionalAt::Frequency(at.value.map_or(f64::NAN, |p| p.0))
                }
                None => {
                    r.echo_default(&mass.at.path, "first sloshing mode", "the slowest mode");
                    MassProportionalAt::FirstSloshing
                }
            };
            r.remarks.push(format!(
                "{}: damping is proportional to the mass alone, which leaves the wall almost undamped",
                field.path
            ));
            Damping::MassProportional { ratio, at }
        }
        _ => {
            let message = "not exactly one damping model";
            let allowed = "one of by_group, rayleigh and mass_proportional";
            r.refuse(Code::Exclusive, field, message, allowed);
            default
        }
    }
}
