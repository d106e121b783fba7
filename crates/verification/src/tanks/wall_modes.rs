//! Modes of walls that a joint, a roof or the pressure of the liquid changes.
//!
//! ```text
//! joint   rigid meridian w = a + b z of a low ring of mass μ = ρ t a unit of area, on springs k along its foot:
//!         ω² = E/(ρ R²)  and  E/(ρ R²) + 4 k/(μ H);  about a hinge the first alone
//! roof    massless tube: ω² = 1/(M δ), δ = H³/(3 E I) + 2 H/(G A);  upwards E A/(M H);  the rim with the mass of the roof as a ring, radially,
//!         2 π R/M E t/(2 β R²), β⁴ = 3 (1 − ν²)/(R t)²
//! loaded  Δω² = ∫ N_θ/R² (n² − 1) w² π R dz,  N_θ = ρ g (H − z) R, w of a mode of unit mass
//! ```
//!
//! (n² − 1): a wave w cos nθ without stretch turns by (n − 1/n) w/R, which is N_θ (n² − 1)²/n² in energy; pressure that turns with the wall adds N_θ (n² − 1)/n².
//!
//! Source:    rings and beams by hand; the pressure by Rayleigh's quotient with the modes of the harmonic engine, which has no initial stress
//! Tolerance: set before the values were computed: 1 % of a frequency of the ring, whose meridian bends by (H/√(R t))⁴ of its motion, 0.03 % of its
//!            energy, of a bar and of a rim; 3 % of a tube for a beam, H = 10 R; 3 % of Δω², of which 48 sectors leave out n²/48² and the quotient
//!            Δω²/(4 ω²). Four elements over the radius, which were tried first, have 2 to 6 % less of the liquid's mass; twelve and 64 sectors move the
//!            rows by 0.3 %

use std::f64::consts::PI;

use engines::harmonic::build;
use engines::modes::{Kind, solve};
use engines::solid::{self, MeshSize, SolidOptions};
use engines::{FeError, Options};
use fem::progress::Silent;
use tank::reference::{GRAVITY, case, material};
use tank::{Case, Shape, WallBase};

use crate::{Answer, Benchmark, Part, Reference, Row};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "wall-modes",
    title: "Modes of joints, roofs and walls under pressure",
    model: "Joint: ring of R = 10 m, 0.3 × 0.3 m, E = 30 GPa, ν = 0. Roof: tube of R = 1 m, 10 mm, H = 10 m, without mass, 50 t on top; both without \
            liquid, harmonic engine. Pressure: small steel cylinder full of water (code_aster V8.21.312), three-dimensional engine, 8 × 48 × 24 \
            elements, `analysis.initial_stress` true and false. Not in any engine: waves around the tank on soil, breathing (m = 0) of a tank on soil, \
            whose slab moves along x and turns, and the stiffness of a roof, whose mass is a ring on the rim; so there is nothing to compare.",
    ids: &[
        ("wall-joint", "frequencies of a ring whose foot slides on springs or turns about a hinge"),
        ("wall-roof", "frequencies of a tube with a heavy roof"),
        ("wall-pressure", "what hydrostatic hoop tension adds to ω² of waves around the wall"),
    ],
    parts: &[Part::Fast(joint), Part::Fast(roof), Part::Fast(pressure)],
};

/// A liquid that nothing feels.
const VOID: f64 = 1e-3;

fn closed_form(id: &'static str, what: &str, (value, source): (f64, &'static str), own: f64, tolerance: f64) -> Row {
    Row::new(id, what, (value, source, Reference::ClosedForm), own, (tolerance, "rad/s"))
}

/// First frequencies of the wall in a harmonic [rad/s].
fn structural(tank: &Case, harmonic: u32, count: usize) -> Result<Vec<f64>, FeError> {
    // Four times as fine as by default, for the edge of a tube ten radii long.
    let modes = engines::modes(tank, &Options { refine: 4.0, ..Options::default() }, &[harmonic], count)?;
    let found: Vec<f64> = modes.iter().filter(|mode| mode.kind == "structural").map(|mode| mode.omega).collect();
    if found.len() < count { Err(FeError::Analysis("too few modes of the wall".into())) } else { Ok(found) }
}

fn joint() -> Answer {
    let (radius, t, height, young, density) = (10.0_f64, 0.3, 0.3, 30e9, 2500.0);
    let ring = young / (density * radius * radius);
    let mut tank = case(Shape::Cylinder { radius }, &[(height, t)], &material(young, 0.0, density), (VOID, 0.1));
    // So stiff that it doubles ω².
    let stiffness = 0.25 * ring * density * t * height;
    tank.tank.wall_base = WallBase::Sliding { stiffness: Some(stiffness), friction: None };
    let slides = structural(&tank, 0, 2)?;
    tank.tank.wall_base = WallBase::Hinged;
    let turns = structural(&tank, 0, 1)?;
    let row = |what: &str, square: f64, own: f64| {
        closed_form("wall-joint", what, (square.sqrt(), "rigid meridian"), own, 0.01)
    };
    Ok(vec![
        row("foot on springs, m = 0: first mode, about the foot", ring, slides[0]),
        row("foot on springs, m = 0: second mode", 2.0 * ring, slides[1]),
        row("foot on a hinge, m = 0: first mode", ring, turns[0]),
    ])
}

fn roof() -> Answer {
    let (radius, t, height, young, poisson, mass) = (1.0, 0.01, 10.0_f64, 210e9, 0.3, 50_000.0);
    let wall = material(young, poisson, 1e-3);
    let mut tank = case(Shape::Cylinder { radius }, &[(height, t)], &wall, (VOID, 0.5));
    tank.tank.roof.mass = mass;
    let area = 2.0 * PI * radius * t;
    let (second, shear) = (0.5 * area * radius * radius, 0.5 * young / (1.0 + poisson));
    let soft = height.powi(3) / (3.0 * young * second) + 2.0 * height / (shear * area);
    let sideways = structural(&tank, 1, 1)?[0];
    let even = structural(&tank, 0, 2)?;
    let beam = ((mass * soft).recip().sqrt(), "Timoshenko's beam with half of its area in shear");
    let bar = ((young * area / (mass * height)).sqrt(), "bar");
    let beta = (3.0 * (1.0 - poisson * poisson)).powf(0.25) / (radius * t).sqrt();
    let edge = young * t / (2.0 * beta * radius * radius);
    let rim = ((2.0 * PI * radius * edge / mass).sqrt(), "free edge of a long tube");
    Ok(vec![
        closed_form("wall-roof", "m = 1: first mode, sideways", beam, sideways, 0.03),
        closed_form("wall-roof", "m = 0: first mode, the mass of the roof as a ring that breathes", rim, even[0], 0.01),
        closed_form("wall-roof", "m = 0: second mode, upwards", bar, even[1], 0.01),
    ])
}

fn pressure() -> Answer {
    const SOURCE: &str = "Rayleigh's quotient with modes of the harmonic engine";
    let steel = material(206e9, 0.3, 7850.0);
    let (radius, depth) = (0.076073, 0.3048);
    let tank = case(Shape::Cylinder { radius }, &[(depth, 0.254e-3)], &steel, (1000.0, depth));
    let mesh = MeshSize { radial: 8, sectors: 48, vertical: 24 };
    let squares = |initial_stress: bool| -> Result<[f64; 3], FeError> {
        let form = SolidOptions { mesh: Some(mesh), initial_stress: Some(initial_stress), ..SolidOptions::default() };
        let found = solid::modes(&tank, &Options::default(), &form, 5, &Silent)?;
        let first = |n: u32| found.iter().find(|m| m.harmonic == n && m.kind == "structural" && m.number == 1);
        Ok([3, 4, 5].map(|n| first(n).map_or(f64::NAN, |mode| mode.omega * mode.omega)))
    };
    let (bare, loaded) = (squares(false)?, squares(true)?);
    let mut rows = Vec::new();
    for (i, n) in [3, 4, 5].into_iter().enumerate() {
        let coupled = build(&tank, &Options::default(), n)?;
        let modes = solve(&coupled, Some(coupled.surface.unknowns.len() + 1))?;
        let mode = modes.iter().find(|m| m.kind == Kind::Structural).ok_or(FeError::Eigen("no mode".into()))?;
        let shape = &coupled.shape_rows;
        // Of the points of the wall, those that are held move by zero.
        let squared = |k: usize| {
            let w: f64 = shape.wall[k].iter().map(|&(i, c)| c * mode.vector[i]).sum();
            (depth - shape.z[k]) * w * w
        };
        let between = |k: usize| 0.5 * (squared(k) + squared(k + 1)) * (shape.z[k + 1] - shape.z[k]);
        let integral: f64 = (0..shape.z.len() - 1).map(between).sum();
        let expected = PI * 1000.0 * GRAVITY * f64::from(n * n - 1) * integral;
        let source = (expected, SOURCE, Reference::SecondFormulation);
        let what = format!("n = {n}, first mode: Δω² by the pressure");
        rows.push(Row::new("wall-pressure", what, source, loaded[i] - bare[i], (0.03, "rad²/s²")));
    }
    Ok(rows)
}
