//! Refusals of the nonlinear engine before a run: place in the input, value found, values allowed.
//!
//! The engine builds its sections with the same functions, so that both refuse the same input.

use std::f64::consts::TAU;

use tank::Case;
use tank::options::nonlinear::{MOST_ROWS, MOST_SECTORS};
use tank::refusal::{Place, Refusal};
use tank::units::{Dimension, display};
use tank::{Behaviour, Concrete, ConcreteLaw, Course, Layer, LayerKind, Shape, Softening, Support};

use super::bottom::missing;
use super::cylinder::mesh::Cells;
use super::cylinder::section as shells;
use super::cylinder::two;
use super::lasting;
use super::laws::uniaxial_concrete;
use crate::strip::section as fibres;
use crate::{FeError, out_of_round, strip};
use tank::options::nonlinear::{LiquidForm, NonlinearOptions, StripWall, WallElements};

/// Help on default elements.
const OWN: &str = "the engine chose them: set analysis.nonlinear.elements";
/// Size so small that only parameters of a law can be at fault [m].
const TINY: f64 = 1e-3;

/// The analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// Runs through a record.
    History,
    /// A static pushover.
    Pushover,
}

/// An error of the engine as a refusal.
fn refusal(place: Place, error: FeError) -> Refusal {
    match error {
        FeError::Option { option, found, allowed } => {
            Refusal::new(place, format!("{option} is out of range"), allowed).found(found)
        }
        other => Refusal::new(place, other.to_string(), ""),
    }
}

/// Everything that the engine refuses of a case; empty if it can run.
pub(crate) fn refusals(case: &Case, options: &NonlinearOptions, purpose: Purpose) -> Vec<Refusal> {
    let mut all = Vec::new();
    match (case.tank.shape, purpose) {
        (Shape::Cylinder { .. }, Purpose::History) if options.liquid == LiquidForm::Displacement => all.push(
            Refusal::new(
                Place::Shape,
                "the nonlinear engine has a displacement liquid between the walls of a strip; that of a cylinder is condensed onto its wall",
                "\"rectangle\" with \"strip\": true",
            )
            .help("remove --liquid displacement, or use --fe solid"),
        ),
        (Shape::Cylinder { radius }, Purpose::History) => cylinder(case, options, radius, true, &mut all),
        (Shape::Cylinder { radius }, Purpose::Pushover) => {
            if case.tank.support == Support::Unanchored
                && let Some((reason, allowed)) = missing(case)
            {
                all.push(Refusal::new(Place::Support, reason, allowed));
            }
            cylinder(case, options, radius, false, &mut all);
            one_shell(case, &mut all);
        }
        (Shape::Rectangle { .. }, Purpose::Pushover) => all.push(Refusal::new(
            Place::Shape,
            "a pushover is for cylinders",
            "\"cylinder\"",
        )),
        (Shape::Rectangle { strip: true, .. }, _) => strip_walls(case, options, &mut all),
        (Shape::Rectangle { .. }, _) => all.push(
            Refusal::new(
                Place::Shape,
                "the nonlinear engine runs cylinders and strips of long rectangular tanks, not a rectangle with four walls",
                "\"cylinder\", or \"rectangle\" with \"strip\": true",
            )
            .help("a tank much broader than long is a strip: \"strip\": true in place of its breadth"),
        ),
    }
    if !case.tank.wall_base.is_fixed() {
        let message = "the nonlinear engine clamps the foot of the wall";
        all.push(Refusal::new(Place::WallBase, message, "\"kind\": \"fixed\"").help("use --fe harmonic"));
    }
    all.extend(lasting::refusals(case, options, purpose == Purpose::History));
    all.extend(imperfect(case, options, purpose));
    if purpose == Purpose::History {
        all.extend(two::refusals(case, options));
    }
    // Each refusal is listed once, however many courses share it.
    let mut listed: Vec<Refusal> = Vec::new();
    for refusal in all {
        if !listed.iter().any(|r| r.place == refusal.place && r.message == refusal.message) {
            listed.push(refusal);
        }
    }
    listed
}

/// The refusal of imperfections, if there is one.
fn imperfect(case: &Case, options: &NonlinearOptions, purpose: Purpose) -> Option<Refusal> {
    let imperfections = &options.imperfections;
    if imperfections.is_empty() {
        return None;
    }
    let refuse = |message: &str, allowed: &str| Refusal::new(Place::Imperfections, message, allowed);
    if purpose == Purpose::Pushover {
        let refusal = refuse(
            "a pushover has an imperfect shell of its own",
            "no analysis.imperfections; --imperfection with an amplitude or a quality class",
        );
        return Some(refusal);
    }
    if options.symmetry && !imperfections.is_symmetric(case.tank.wall_height()) {
        let refusal = refuse(
            "the imperfections are not symmetric about the plane of shaking, and half of the tank is computed",
            "analysis.nonlinear.symmetry false, or a phase that puts a crest or a trough at θ = 0",
        );
        return Some(refusal.help("add \"symmetry\": false to analysis.nonlinear"));
    }
    let cells = Cells::new(&case.tank, case.liquid.fill_height, options.elements, options.symmetry);
    let help = "set analysis.nonlinear.elements";
    out_of_round::resolved(imperfections, &case.tank, (cells.sectors, cells.rows()), help)
}

fn strip_walls(case: &Case, options: &NonlinearOptions, all: &mut Vec<Refusal>) {
    if case.tank.roof.mass > 0.0 {
        all.push(Refusal::new(
            Place::Roof,
            "the strip engine does not support a roof mass",
            "no roof mass; remove `roof`",
        ));
    }
    let levels = |n: u32| fibres::levels(case, n);
    let rows = Rows { case, given: options.elements, chosen: strip::ELEMENTS, levels: &levels };
    for (index, course) in case.tank.courses.iter().enumerate() {
        let layers = course.build_up();
        let main = match fibres::main_leaf(&layers) {
            Ok(main) => main,
            Err(error) => {
                all.push(refusal(Place::Course(index), error).found(in_words(course)));
                continue;
            }
        };
        let before = all.len();
        all.extend(stiff_in_its_plane(&layers).filter(|_| options.wall == StripWall::Fibre));
        for (layer, concrete) in concretes(main) {
            // Plane strain across the strip.
            let nu = layer.material.poisson_ratio;
            let young = layer.material.youngs_modulus / (1.0 - nu * nu);
            let law = |size: f64| match options.wall {
                StripWall::Fibre => uniaxial_concrete(&concrete, young, layer, size).map(|_| ()),
                StripWall::Shell => {
                    let own = layer.material.youngs_modulus;
                    shells::plane_concrete(&concrete, own, nu, layer, [size, size]).map(|_| ())
                }
            };
            let softens = softens(&concrete, young);
            check(index, layer, &concrete, softens, &law, &rows, None, all);
        }
        let longest = rows.longest(index, rows.count());
        let built = || match options.wall {
            StripWall::Fibre => fibres::section(&layers, longest, options).map(|_| ()),
            StripWall::Shell => strip::shells::shell_row(&layers, longest, options).map(|_| ()),
        };
        if all.len() == before
            && let Err(error) = built()
        {
            all.push(refusal(Place::Course(index), error).found(in_words(course)));
        }
    }
}

/// * `sized`: whether the cells are those of a time history
fn cylinder(case: &Case, options: &NonlinearOptions, radius: f64, sized: bool, all: &mut Vec<Refusal>) {
    let wanted = |height: u32| {
        let elements = options.elements.map(|e| WallElements { height, ..e });
        Cells::new(&case.tank, case.liquid.fill_height, elements, options.symmetry)
    };
    let cells = wanted(options.elements.map_or(0, |e| e.height));
    let levels = |n: u32| match options.elements {
        Some(_) => wanted(n).z,
        None => cells.z.clone(),
    };
    let rows = Rows { case, given: options.elements, chosen: cells.rows() as u32, levels: &levels };
    let arc = radius * cells.angle();
    let mut first_gap = None;
    for (index, course) in case.tank.courses.iter().enumerate() {
        let layers = course.build_up();
        let before = all.len();
        if let Some(between) = layers.iter().find(|l| l.kind == LayerKind::Interlayer)
            && let Err(error) = shells::interlayer(between)
        {
            all.push(
                Refusal::new(
                    Place::Interlayer(between.material.name.clone()),
                    error.to_string(),
                    "e_normal alone (with or without tension), or also shear_modulus and e_parallel with tension; or an elastic material",
                )
                .found(interlayer_in_words(between)),
            );
        }
        for (layer, concrete) in concretes(&layers) {
            let (young, nu) = (layer.material.youngs_modulus, layer.material.poisson_ratio);
            let law = |size: f64| shells::plane_concrete(&concrete, young, nu, layer, [size, size]).map(|_| ());
            let softens = softens(&concrete, young);
            if sized {
                let around = Some(Around { arc, perimeter: TAU * radius, half: cells.half });
                check(index, layer, &concrete, softens, &law, &rows, around, all);
            } else if let Err(error) = law(TINY) {
                all.push(against_law(layer, &concrete, error));
            }
        }
        if all.len() > before {
            continue;
        }
        match shells::row(&layers, [TINY; 2], &options.integration, options.temperature) {
            Err(error) => all.push(refusal(Place::Course(index), error).found(in_words(course))),
            Ok(row) => {
                let gap = *first_gap.get_or_insert(row.gap);
                if (row.gap - gap).abs() > 1e-9 * radius {
                    let shown = |gap: f64| match gap {
                        0.0 => "one shell".to_owned(),
                        gap => format!("two shells, {} apart between their middles", display(gap, Dimension::Length)),
                    };
                    all.push(
                        Refusal::new(
                            Place::Course(index),
                            "the nonlinear engine models walls whose shells are equally far apart in all courses",
                            format!("{}, as in the first course", shown(gap)),
                        )
                        .found(shown(row.gap)),
                    );
                }
            }
        }
    }
}

fn one_shell(case: &Case, all: &mut Vec<Refusal>) {
    for (index, course) in case.tank.courses.iter().enumerate() {
        if course.build_up().iter().any(|l| l.kind == LayerKind::Interlayer) {
            all.push(
                Refusal::new(
                    Place::Course(index),
                    "a pushover supports walls of one shell, not of two with an interlayer",
                    "layers without an interlayer",
                )
                .found(in_words(course)),
            );
        }
    }
}

/// The refusal of an interlayer with stiffness in its plane beside a wall of fibres, which bends as its main leaf alone.
fn stiff_in_its_plane(layers: &[Layer]) -> Option<Refusal> {
    let stiff = layers.iter().find(|l| matches!(l.material.behaviour, Behaviour::Interlayer(i) if i.e_parallel > 0.0));
    stiff.map(|layer| {
        Refusal::new(
            Place::Interlayer(layer.material.name.clone()),
            "a wall of fibres bends as its stiffest shell alone, without the stiffness of an interlayer in its plane",
            "no e_parallel",
        )
        .found(interlayer_in_words(layer))
        .help("set analysis.nonlinear.wall to \"shell\", or remove e_parallel")
    })
}

/// Largest element whose cracks do not snap back [m]; laws that do not crack have no softening in tension.
fn softens(concrete: &Concrete, young: f64) -> f64 {
    if concrete.law.cracks() { concrete.largest_element(young) } else { f64::INFINITY }
}

/// Layers of concrete that cracks.
fn concretes(layers: &[Layer]) -> impl Iterator<Item = (&Layer, Concrete)> {
    layers.iter().filter_map(|layer| match layer.material.behaviour {
        Behaviour::Concrete(concrete) => Some((layer, concrete)),
        _ => None,
    })
}

fn in_words(course: &Course) -> String {
    let layers = course.build_up();
    let words: Vec<String> =
        layers.iter().map(|l| format!("{} {}", display(l.thickness, Dimension::Length), l.material.name)).collect();
    words.join(", ")
}

fn interlayer_in_words(layer: &Layer) -> String {
    let Behaviour::Interlayer(i) = layer.material.behaviour else { return layer.material.behaviour.kind().to_owned() };
    let modulus = |value: f64| display(value, Dimension::Stress);
    format!(
        "e_normal {}, e_parallel {}, shear_modulus {}, {} tension",
        modulus(i.e_normal),
        modulus(i.e_parallel),
        modulus(i.shear_modulus),
        if i.tension { "with" } else { "without" }
    )
}

/// Rows of elements over the wall.
struct Rows<'a> {
    /// The tank.
    case: &'a Case,
    /// Elements given by the user.
    given: Option<WallElements>,
    /// Default number of rows.
    chosen: u32,
    /// Heights of the nodes for a number of elements.
    levels: &'a dyn Fn(u32) -> Vec<f64>,
}

impl Rows<'_> {
    fn count(&self) -> u32 {
        self.given.map_or(self.chosen, |e| e.height)
    }

    /// Longest element of a course for a number of elements [m].
    fn longest(&self, course: usize, n: u32) -> f64 {
        let courses = &self.case.tank.courses;
        let base: f64 = courses[..course].iter().map(|c| c.height).sum();
        let own = base..base + courses[course].height;
        let levels = (self.levels)(n);
        let inside = levels.windows(2).filter(|z| own.contains(&(0.5 * (z[0] + z[1]))));
        inside.map(|z| z[1] - z[0]).fold(0.0, f64::max)
    }

    /// Least number with which no element of a course is longer than this [m], if within the limit.
    fn needed(&self, course: usize, largest: f64) -> Option<u32> {
        // Starts below the number of equal elements: marks may give a course shorter elements than the others.
        let least = (0.5 * self.case.tank.wall_height() / largest).clamp(1.0, f64::from(MOST_ROWS) + 1.0);
        (least as u32..=MOST_ROWS).find(|&n| self.longest(course, n) <= largest)
    }
}

/// The cells of a cylinder along its circumference.
#[derive(Clone, Copy)]
struct Around {
    /// Length of one [m].
    arc: f64,
    /// 2πR [m].
    perimeter: f64,
    /// Whether half of the tank is computed.
    half: bool,
}

/// Refusals of a law of concrete: parameters out of range, or elements that are too large.
///
/// * `course`: which it is in
/// * `softens`: largest element whose cracks do not snap back [m]
/// * `law`: makes the law for an element of this size [m]
fn check(
    course: usize,
    layer: &Layer,
    concrete: &Concrete,
    softens: f64,
    law: &dyn Fn(f64) -> Result<(), FeError>,
    rows: &Rows<'_>,
    around: Option<Around>,
    all: &mut Vec<Refusal>,
) {
    if let Err(error) = law(TINY) {
        all.push(against_law(layer, concrete, error));
        return;
    }
    let sizes = [(Place::Rows, rows.longest(course, rows.count())), (Place::Sectors, around.map_or(0.0, |a| a.arc))];
    for (place, size) in sizes {
        if size <= TINY || law(size).is_ok() {
            continue;
        }
        let largest = rounded_down(largest(law, size));
        let cracks = concrete.band(size) > softens;
        all.push(TooLarge { place, size, largest, cracks, course, rows, around }.refusal(layer, concrete));
    }
}

/// Elements that are too large for a law of concrete.
struct TooLarge<'a> {
    /// Along which direction.
    place: Place,
    /// Their size, and the largest one allowed [m].
    size: f64,
    largest: f64,
    /// Whether cracks snap back, or else crushing.
    cracks: bool,
    course: usize,
    rows: &'a Rows<'a>,
    around: Option<Around>,
}

impl TooLarge<'_> {
    fn refusal(self, layer: &Layer, concrete: &Concrete) -> Refusal {
        let name = &layer.material.name;
        let size = display(self.size, Dimension::Length);
        let message = match self.cracks {
            true => format!("the softening of `{name}` is too steep for elements of {size}: cracks snap back"),
            false => format!("the crushing of `{name}` is too brittle for elements of {size}: it snaps back"),
        };
        let formula = if self.cracks { " (0.98 E·G_f/f_t²)" } else { "" };
        let bound = format!("elements of at most {}{formula}", display(self.largest, Dimension::Length));
        let needed = self.needed();
        let given = self.rows.given.is_some();
        let allowed = match needed {
            Some(n) => format!("{bound}: {n} or more"),
            None if given => format!("{bound}, which needs more than the limit of {}", self.most()),
            None => bound,
        };
        let help = self.help(needed.is_some(), concrete);
        // Default elements are not at fault: the material that does not suit them is.
        let place = if given { self.place } else { Place::Concrete(name.clone()) };
        Refusal::new(place, message, allowed).help(help)
    }

    /// The limit of the number of elements.
    fn most(&self) -> u32 {
        if self.place == Place::Rows { MOST_ROWS } else { MOST_SECTORS }
    }

    /// Least number of elements that are small enough, if within the limit.
    fn needed(&self) -> Option<u32> {
        match (&self.place, self.around) {
            (Place::Sectors, Some(around)) => {
                let n = (around.perimeter / self.largest).ceil();
                // Half a tank needs an even number.
                let even = |n: u32| if around.half { n.next_multiple_of(2) } else { n };
                (n <= f64::from(self.most())).then_some(even(n as u32))
            }
            _ if self.rows.given.is_some() || self.around.is_none() => self.rows.needed(self.course, self.largest),
            _ => None,
        }
    }

    /// What to change; `possible`: whether a number of elements within the limit suffices.
    fn help(&self, possible: bool, concrete: &Concrete) -> String {
        let spacing = format!("a crack_spacing of at most {}", display(self.largest, Dimension::Length));
        match (self.rows.given.is_some(), self.cracks, possible) {
            (true, true, true) => format!("more elements, a larger fracture_energy, or {spacing}"),
            (true, false, true) => "more elements".to_owned(),
            (true, true, false) => match concrete.softening {
                Softening::FractureEnergy(energy) => {
                    let finest = match (&self.place, self.around) {
                        (Place::Sectors, Some(around)) => around.perimeter / f64::from(self.most()),
                        _ => self.rows.longest(self.course, self.most()),
                    };
                    format!(
                        "{spacing}; or a fracture_energy of at least {}, with {} elements",
                        display(energy * finest / self.largest, Dimension::LineForce),
                        self.most()
                    )
                }
                _ => spacing,
            },
            (true, false, false) => "the law `cracked`, which does not soften in compression".to_owned(),
            (false, true, _) => format!("{OWN}, or {spacing}"),
            (false, false, _) => OWN.to_owned(),
        }
    }
}

fn against_law(layer: &Layer, concrete: &Concrete, error: FeError) -> Refusal {
    let name = layer.material.name.clone();
    match (error, concrete.law) {
        (FeError::Unsupported(message), ConcreteLaw::Uniaxial) => Refusal::new(
            Place::Law(name),
            message,
            "\"cracked\", \"plastic-fracturing\", \"two-surface\" or \"fracturing\" in shells",
        ),
        (FeError::Unsupported(message), _) => {
            Refusal::new(Place::Law(name), message, "\"cracked\" or \"uniaxial\" in a strip")
        }
        (error, _) => refusal(Place::Concrete(name), error),
    }
}

/// Largest size up to `refused` that the law takes [m]; it takes [`TINY`].
fn largest(law: &dyn Fn(f64) -> Result<(), FeError>, refused: f64) -> f64 {
    let (mut low, mut high) = (TINY, refused);
    // More digits than are shown.
    while high - low > 1e-6 * low {
        let middle = 0.5 * (low + high);
        match law(middle) {
            Ok(()) => low = middle,
            Err(_) => high = middle,
        }
    }
    low
}

/// Rounded down to three digits, so that the number shown is allowed.
fn rounded_down(size: f64) -> f64 {
    let digit = 10f64.powf(size.log10().floor() - 2.0);
    // A size that is such a number up to rounding is kept.
    (size / digit + 1e-4).floor() * digit
}
