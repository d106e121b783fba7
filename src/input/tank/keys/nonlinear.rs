//! `analysis.nonlinear`: options of the nonlinear engine.

use files::code::Code;
use tank::case;
use tank::imperfection::Imperfections;
use tank::options::nonlinear::{
    Contact, Damping, Integration, MOST_ROWS, MOST_SECTORS, MassProportionalAt, StepLength, StripWall, ThicknessRule,
    WallElements,
};
use tank::options::{AfterRecord, NonlinearOptions};
use tank::{Shape, Tank};

use super::damping::RATIO;
use super::rayleigh::{Rayleigh, rayleigh};
use crate::input::diagnostic::Faults;
use crate::input::tank::key::{Absent, Limits, default, without};
use crate::input::tank::read::{Field, FromNode, Opt, choice, object, wrong_kind, wrong_value};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::shape::{Book, Shape as Looks};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Number, Pitch, Time, Whole};

/// Defaults. The damping ratios are placeholders: those of the case replace them.
const DEFAULT: &NonlinearOptions = &NonlinearOptions::new(case::Damping {
    sloshing: f64::NAN,
    impulsive: f64::NAN,
});

object! {
    /// Options of the nonlinear engine: walls that yield and crack, large rotations, liquid of linear theory.
    Nonlinear {
        /// Numbers of elements of the wall.
        elements: Opt<Elements> = Absent::Without("by the size of the wall and its materials"),
        /// Whether only the half of the tank on one side of the plane of shaking is computed; not for a strip.
        symmetry (false): Opt<bool>
            = default(DEFAULT.symmetry).because("half of the tank is computed, the other is its mirror image"),
        /// Spectral radius of the time integration at high frequencies; 1 is the trapezoidal rule (generalised-alpha method
        /// of Chung and Hulbert).
        spectral_radius (0.8): Opt<Number> [Limits::from(0.0).to(1.0)] = default(Number(DEFAULT.spectral_radius))
            .because("next to no numerical damping of the modes that count (Chung and Hulbert 1993)"),
        /// Time step.
        time_step ("0.0025 s"): Opt<Time> [Limits::from(1e-6).to(1.0)]
            = without("a twentieth of the impulsive period, at most half the step of the record"),
        /// Whether quiet phases of a cylinder with bonded liquid are marched in longer steps: several time steps at once, at most
        /// the step of the record, as long as the local error of the displacements stays below 0.1 % of the largest so far.
        step ("adaptive"): Opt<StepLength> = default(DEFAULT.step).because("every time step is resolved"),
        /// Damping model.
        damping: Opt<NonlinearDamping> = Absent::Follows("by_group with the ratios of damping"),
        /// Contact of liquid and wall.
        contact: Opt<Contact> = default(DEFAULT.contact).because("the liquid stays at the wall"),
        /// Elements of the walls of a strip; not for a cylinder, whose walls are shells.
        wall ("shell"): Opt<StripWall>
            = default(DEFAULT.wall).because("one leaf bends, and fibres take a sixth of the time of shells"),
        /// Whether the weight of the wall acts.
        self_weight (false): Opt<bool> = default(DEFAULT.self_weight).because("the wall has weight"),
        /// Whether the pressure turns with the wall.
        follower_pressure (false): Opt<bool>
            = default(DEFAULT.follower_pressure).because("pressure stands on the deformed wall"),
        /// Points through the thickness, by kind of material.
        integration: Opt<Integrations>,
        /// Refinement of the rings of the bottom plate of an unanchored cylinder: 2 makes them half as wide.
        bottom_mesh (2): Opt<Number> [Limits::from(0.5).to(8.0)] = default(Number(DEFAULT.bottom_mesh))
            .because("rings of two thicknesses at the foot resolve the hinge of the plate"),
        /// Whether the foot of a cylinder on its bottom plate stays a plane, as it does in the strips of the harmonic engine and under a stiff roof; of
        /// no account where the foot is clamped.
        plane_foot (true): Opt<bool>
            = default(DEFAULT.plane_foot).because("the mass of the roof is modelled, not its stiffness: the foot may warp"),
        /// Free vibration after the record: periods of the first sloshing mode, a time, or none. A long wave often peaks there.
        after_record ("2 periods"): Opt<AfterRecord> = default(DEFAULT.after_record)
            .because("as the linear engines: two periods of the first sloshing mode"),
        /// Computing time between two checkpoints from which a run can be resumed.
        checkpoint ("300 s"): Opt<Time> [Limits::from(1.0).to(1e6)]
            = default(Time(DEFAULT.checkpoint)).because("at most a minute of computing is lost"),
    }

    /// Numbers of elements of the wall.
    Elements {
        /// Over the height of the wall.
        height (40): Field<Whole> [Limits::count(1, MOST_ROWS)],
        /// Around a cylinder, even unless symmetry is false, or along the whole perimeter of a rectangle. Both need it; it does not
        /// apply to a strip.
        circumference (64): Opt<Whole> [Limits::count(8, MOST_SECTORS)],
    }

    /// Points through the thickness of a layer, by kind of material.
    Integrations {
        /// Elastic layers.
        elastic ("gauss 2"): Opt<ThicknessRule> = default(Integration::DEFAULT.elastic),
        /// Steel.
        steel ("gauss 5"): Opt<ThicknessRule> = default(Integration::DEFAULT.steel),
        /// Concrete.
        concrete ("midpoint 20"): Opt<ThicknessRule> = default(Integration::DEFAULT.concrete),
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

choice!(Contact, StripWall, StepLength);

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
        let Kind::Text(text) = &node.kind else {
            faults.push(wrong_kind(node, &Self::allowed()));
            return None;
        };
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
    given: Option<&Nonlinear>,
    tank: Option<&Tank>,
    ratios: case::Damping,
) -> NonlinearOptions {
    let Some(given) = given else {
        return NonlinearOptions::new(ratios);
    };
    let elements = elements(r, &given.elements, tank);
    if let (Some(symmetry), Some(Shape::Rectangle { strip: true, .. })) = (&given.symmetry.given, tank.map(|t| t.shape))
    {
        let message = "symmetry does not apply to a strip";
        let allowed = "symmetry for a cylinder or a rectangle";
        r.refuse(Code::DoesNotApply, symmetry, message, allowed);
    }
    if let (Some(wall), Some(false)) = (
        &given.wall.given,
        tank.map(|t| matches!(t.shape, Shape::Rectangle { strip: true, .. })),
    ) {
        let message = "wall applies to a strip alone";
        let allowed = "no `wall`: walls of this tank are shells";
        r.refuse(Code::DoesNotApply, wall, message, allowed);
    }
    let symmetry = r.choice(&given.symmetry);
    if symmetry {
        halves(r, &given.elements, tank);
    }
    NonlinearOptions {
        elements,
        symmetry,
        spectral_radius: r.or_default(&given.spectral_radius),
        time_step: r.optional(&given.time_step),
        step: step(r, &given.step, tank, &given.contact),
        damping: damping(r, &given.damping, ratios),
        contact: r.choice(&given.contact),
        wall: r.choice(&given.wall),
        self_weight: r.choice(&given.self_weight),
        follower_pressure: r.choice(&given.follower_pressure),
        integration: integration(r, &given.integration),
        bottom_mesh: r.or_default(&given.bottom_mesh),
        plane_foot: r.choice(&given.plane_foot),
        after_record: r.choice(&given.after_record),
        checkpoint: r.or_default(&given.checkpoint),
        // Those of `analysis`.
        imperfections: Imperfections::NONE,
    }
}

/// Longer steps are for cylinders with bonded liquid: an impact of opening contact has no smooth acceleration to estimate errors by.
fn step(r: &mut Resolver<'_>, option: &Opt<StepLength>, tank: Option<&Tank>, contact: &Opt<Contact>) -> StepLength {
    let found = r.choice(option);
    let opening = contact.given.as_ref().and_then(|field| field.value) == Some(Contact::Opening);
    let cylinder = tank.is_none_or(|t| matches!(t.shape, Shape::Cylinder { .. }));
    if let (StepLength::Adaptive, Some(field)) = (found, &option.given)
        && (!cylinder || opening)
    {
        let message = "adaptive steps are for cylinders with bonded liquid";
        r.refuse(Code::DoesNotApply, field, message, "\"fixed\"");
    }
    found
}

fn elements(r: &mut Resolver<'_>, option: &Opt<Elements>, tank: Option<&Tank>) -> Option<WallElements> {
    let Some(field) = &option.given else {
        r.not_given(option);
        return None;
    };
    let given = field.value.as_ref()?;
    let height = r.count(&given.height);
    let strip = tank.map(|t| matches!(t.shape, Shape::Rectangle { strip: true, .. }));
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
    Some(WallElements {
        height: height?,
        circumference: circumference?,
    })
}

/// Half a cylinder has half of the elements around the circumference, so their number must be even.
fn halves(r: &mut Resolver<'_>, option: &Opt<Elements>, tank: Option<&Tank>) {
    let cylinder = matches!(tank.map(|t| t.shape), Some(Shape::Cylinder { .. }));
    let given = option.value().and_then(|e| e.circumference.given.as_ref());
    if let (true, Some((field, Whole(around)))) = (cylinder, given.and_then(|f| Some((f, f.value?))))
        && around % 2 == 1
    {
        let message = "half a tank needs an even number of elements around the whole circumference";
        let allowed = "an even number";
        let fault = range_fault(Code::Contradiction, field, message, allowed);
        r.faults
            .push(fault.help(format!("write {}, or add \"symmetry\": false", around + 1)));
    }
}

fn integration(r: &mut Resolver<'_>, option: &Opt<Integrations>) -> Integration {
    match option.value() {
        Some(rules) => Integration {
            elastic: r.choice(&rules.elastic),
            steel: r.choice(&rules.steel),
            concrete: r.choice(&rules.concrete),
        },
        None => {
            r.echo_default(
                &option.path,
                "gauss 2, gauss 5, midpoint 20",
                "elastic layers, steel, concrete",
            );
            Integration::DEFAULT
        }
    }
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

fn damping(r: &mut Resolver<'_>, option: &Opt<NonlinearDamping>, ratios: case::Damping) -> Damping {
    let default = Damping::ByGroup {
        wall: ratios.impulsive,
        sloshing: ratios.sloshing,
    };
    let Some(field) = &option.given else {
        r.echo_default(&option.path, "by group", "the ratios of `damping`");
        return default;
    };
    let Some(given) = &field.value else { return default };
    match (
        &given.by_group.given,
        &given.rayleigh.given,
        &given.mass_proportional.given,
    ) {
        (Some(group), None, None) => {
            let Some(group) = &group.value else { return default };
            let (wall, sloshing) = by_group(r, group, ratios);
            Damping::ByGroup { wall, sloshing }
        }
        (None, Some(field), None) => match &field.value {
            Some(given) => {
                let (first, second, allow_negative) = rayleigh(r, given);
                Damping::Rayleigh {
                    first,
                    second,
                    allow_negative,
                }
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
