//! R1 to R5: stiffening rings and masses at heights.

use std::f64::consts::{PI, TAU};

use nalgebra::DMatrix;

use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::harmonic::build;
use engines::modes::{CoupledMode, Kind, solve};
use engines::solid::SolidOptions;
use engines::solid::model::TankModel;
use engines::solid::spectrum::of_harmonic;
use engines::solid::system::System;
use engines::{FeError, Options};
use fem::progress::Silent;
use fem::shape::gauss;
use results::Channel;
use tank::reference::{case, material};
use tank::{Attachment, Case, Material, Ring, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "rings",
    title: "Stiffening rings and masses at heights",
    model: "Harmonic engine, default mesh. R1: a steel ring of R = 3 m on a wall that neither holds nor weighs anything. R2: a clamped \
            cylinder without liquid, R = 10 m, 10 m high, 8 mm, with a ring on its free top edge. R3: a mass on a slender clamped \
            tube without weight. R4 and R5: a steel tank, R = 10 m, 10 m high, 8 mm, filled to 8 m, with a ring at 9 m and an attachment \
            of 20 t at 6.3 m, in the three-dimensional engine.",
    ids: &[
        ("R1", "a free ring that ovals"),
        ("R2", "a cylinder with a ring on its edge, by waves around"),
        ("R3", "a mass at a height on a tube"),
        ("R4", "base shear of a rigid translation and its moment with rings and attachments"),
        ("R5", "modes with a ring and an attachment, three dimensions against harmonics"),
    ],
    parts: &[
        Part::Fast(free_ring),
        Part::Fast(ring_on_a_cylinder),
        Part::Fast(mass_on_a_tube),
        Part::Fast(three_dimensions),
    ],
};

const STEEL: (f64, f64, f64) = (210e9, 0.3, 7850.0);

fn steel() -> Material {
    material(STEEL.0, STEEL.1, STEEL.2)
}

fn ring(height: f64, area: f64, inertia: f64) -> Ring {
    Ring { height, area, inertia, material: steel() }
}

/// Structural modes of a harmonic by ascending frequency.
fn structural(case: &Case, harmonic: u32, refine: f64) -> Result<Vec<CoupledMode>, FeError> {
    let coupled = build(case, &Options { refine, ..Options::default() }, harmonic)?;
    let modes = solve(&coupled, None)?;
    Ok(modes.into_iter().filter(|m| m.kind == Kind::Structural).collect())
}

/// ω [rad/s] of structural mode `number`, from 1.
fn omega(case: &Case, harmonic: u32, number: usize) -> Result<f64, FeError> {
    let modes = structural(case, harmonic, 1.0)?;
    Ok(modes.get(number - 1).map_or(f64::NAN, |m| m.omega))
}

/// ω² = E I n² (n² − 1)²/(ρ A R⁴ (n² + 1)), Love 1927, §293a; its axis stretches with A R²/I = 3.6·10⁵, the error of the formula.
///
/// The first structural mode of a harmonic is that of the ring on the wall as a spring along the axis.
fn free_ring() -> Answer {
    let (radius, area, inertia) = (3.0, 0.01, 2.5e-7);
    let mut rows = Vec::new();
    for n in [2_u32, 3, 5] {
        let nothing = material(1e2, 0.3, 1e-6);
        let mut case = case(Shape::Cylinder { radius }, &[(3.0, 1e-3)], &nothing, (1e-6, 1.0));
        case.tank.rings.push(ring(3.0, area, inertia));
        let m = f64::from(n);
        let (young, _, density) = STEEL;
        let exact =
            (young * inertia / (density * area)).sqrt() / (radius * radius) * m * (m * m - 1.0) / (m * m + 1.0).sqrt();
        rows.push(Row::new(
            "R1",
            format!("{n} waves around"),
            (exact / TAU, "Love 1927, §293a: inextensional ring", Reference::ClosedForm),
            omega(&case, n, 2)? / TAU,
            (1e-3, "Hz"),
        ));
    }
    Ok(rows)
}

const RADIUS: f64 = 10.0;
const HEIGHT: f64 = 10.0;
const THICKNESS: f64 = 8e-3;

/// Powers of z/H in the Ritz field of each displacement.
const TERMS: usize = 12;

/// Lowest frequency [Hz] of n waves of a clamped cylinder with a ring on its free edge by Rayleigh and Ritz: u, v of z P_k and w of z² P_k
/// (Legendre polynomials over the height), strains of Sanders 1959 as in `shell-cylinder-modes`.
fn ritz(n: u32, edge: &Ring) -> f64 {
    let (young, nu, density) = STEEL;
    let n = f64::from(n);
    let (c, r) = (young * THICKNESS / (1.0 - nu * nu), RADIUS);
    let d = c * THICKNESS * THICKNESS / 12.0;
    let mut stiffness = DMatrix::<f64>::zeros(3 * TERMS, 3 * TERMS);
    let mut mass = stiffness.clone();
    // Value and two derivatives of z^p P_k(2 z/H − 1) at x = z/H, by the recursion of Bonnet.
    let functions = |x: f64, power: i32| -> Vec<[f64; 3]> {
        let t = 2.0 * x - 1.0;
        let mut legendre = vec![[1.0, 0.0, 0.0], [t, 2.0, 0.0]];
        for k in 1..TERMS - 1 {
            let (j, [a, b]) = (k as f64, [legendre[k - 1], legendre[k]]);
            let next = |i: usize| {
                let product = t * b[i] + if i > 0 { 2.0 * i as f64 * b[i - 1] } else { 0.0 };
                ((2.0 * j + 1.0) * product - j * a[i]) / (j + 1.0)
            };
            legendre.push([next(0), next(1), next(2)]);
        }
        let p = f64::from(power);
        let factor = [x.powi(power), p * x.powi(power - 1), p * (p - 1.0) * x.powi((power - 2).max(0))];
        let of = |[f, df, ddf]: [f64; 3]| {
            [
                factor[0] * f,
                (factor[1] * f + factor[0] * df) / HEIGHT,
                (factor[2] * f + 2.0 * factor[1] * df + factor[0] * ddf) / (HEIGHT * HEIGHT),
            ]
        };
        legendre.into_iter().map(of).collect()
    };
    let mut add = |factor: f64, row: &[f64], to_mass: bool| {
        let to = if to_mass { &mut mass } else { &mut stiffness };
        for (i, a) in row.iter().enumerate() {
            for (j, b) in row.iter().enumerate() {
                to[(i, j)] += factor * a * b;
            }
        }
    };
    let row = |u: &dyn Fn(usize) -> f64, v: &dyn Fn(usize) -> f64, w: &dyn Fn(usize) -> f64| -> Vec<f64> {
        (0..3 * TERMS).map(|i| [u, v, w][i / TERMS](i % TERMS)).collect()
    };
    let none = |_: usize| 0.0;
    let panels = 60;
    for panel in 0..panels {
        for &(xi, weight) in gauss::FIVE {
            let x = (f64::from(panel) + 0.5 * (1.0 + xi)) / f64::from(panels);
            let measure = 0.5 * weight * HEIGHT / f64::from(panels);
            let (a, b) = (functions(x, 1), functions(x, 2));
            let axial = row(&|k| a[k][1], &none, &none);
            let hoop = row(&none, &|k| n * a[k][0] / r, &|k| b[k][0] / r);
            let shear = row(&|k| -n * a[k][0] / r, &|k| a[k][1], &none);
            let meridional = row(&none, &none, &|k| -b[k][2]);
            let around = row(&none, &|k| n * a[k][0] / (r * r), &|k| n * n * b[k][0] / (r * r));
            let twist = row(&|k| 0.5 * n * a[k][0] / (r * r), &|k| 1.5 * a[k][1] / r, &|k| 2.0 * n * b[k][1] / r);
            for (rigidity, one, two, angle) in [(c, axial, hoop, shear), (d, meridional, around, twist)] {
                let sum: Vec<f64> = one.iter().zip(&two).map(|(a, b)| a + b).collect();
                add(measure * rigidity * (1.0 - nu), &one, false);
                add(measure * rigidity * (1.0 - nu), &two, false);
                add(measure * rigidity * nu, &sum, false);
                add(measure * rigidity * 0.5 * (1.0 - nu), &angle, false);
            }
            for field in
                [row(&|k| a[k][0], &none, &none), row(&none, &|k| a[k][0], &none), row(&none, &none, &|k| b[k][0])]
            {
                add(measure * density * THICKNESS, &field, true);
            }
        }
    }
    let (a, b) = (functions(1.0, 1), functions(1.0, 2));
    add(young * edge.area, &row(&none, &|k| n * a[k][0] / r, &|k| b[k][0] / r), false);
    add(young * edge.inertia, &row(&none, &none, &|k| (n * n - 1.0) * b[k][0] / (r * r)), false);
    for field in [row(&|k| a[k][0], &none, &none), row(&none, &|k| a[k][0], &none), row(&none, &none, &|k| b[k][0])] {
        add(density * edge.area, &field, true);
    }
    let Some(factor) = mass.cholesky() else { return f64::NAN };
    let inverse = factor.l().try_inverse().unwrap_or_else(|| DMatrix::zeros(0, 0));
    let standard: DMatrix<f64> = &inverse * stiffness * inverse.transpose();
    (&standard + standard.transpose()).scale(0.5).symmetric_eigenvalues().min().sqrt() / TAU
}

/// A ring of 100 by 10 mm, in its plane; without it the edge is free.
fn ring_on_a_cylinder() -> Answer {
    let edge = ring(HEIGHT, 1e-3, 8.333e-7);
    let free = ring(HEIGHT, 0.0, 0.0);
    let mut rows = Vec::new();
    for (name, edge) in [("free edge", &free), ("ring", &edge)] {
        for n in [2, 4, 6, 8] {
            let mut case = case(Shape::Cylinder { radius: RADIUS }, &[(HEIGHT, THICKNESS)], &steel(), (1e-6, 1.0));
            if edge.area > 0.0 {
                case.tank.rings.push(edge.clone());
            }
            rows.push(Row::new(
                "R2",
                format!("{name}, {n} waves around"),
                (ritz(n, edge), "Rayleigh-Ritz, strains of Sanders 1959, 36 terms", Reference::SecondFormulation),
                omega(&case, n, 1)? / TAU,
                (5e-3, "Hz"),
            ));
        }
    }
    Ok(rows)
}

/// A mass with the rotational inertia m R²/2 of a ring at the height a of a clamped tube without weight: flexibility of a beam with
/// I = π R³ t and the shear area π R t of the membrane,
///
/// ```text
/// [U, ψ] = F [P, M]      F = [a³/(3 E I) + a/(G π R t),  a²/(2 E I);  ·,  a/(E I)]      det(F diag(m, m R²/2) − 1/ω²) = 0
/// ```
fn mass_on_a_tube() -> Answer {
    let (radius, thickness, arm, mass) = (1.0, 0.02, 16.0, 5000.0);
    let (young, nu, _) = STEEL;
    let weightless = material(young, nu, 1e-6);
    let mut case = case(Shape::Cylinder { radius }, &[(20.0, thickness)], &weightless, (1e-6, 1.0));
    case.tank.attachments.push(Attachment { name: "platform".into(), mass, height: arm });
    let bending = young * PI * radius.powi(3) * thickness;
    let shear = young / (2.0 * (1.0 + nu)) * PI * radius * thickness;
    let (direct, cross, turning) =
        (arm.powi(3) / (3.0 * bending) + arm / shear, arm * arm / (2.0 * bending), arm / bending);
    let inertia = 0.5 * mass * radius * radius;
    let (trace, product) = (mass * direct + inertia * turning, mass * inertia * (direct * turning - cross * cross));
    let slowest = 0.5 * (trace + (trace * trace - 4.0 * product).sqrt());
    Ok(vec![Row::new(
        "R3",
        "5 t at 16 m of a tube of R = 1 m",
        (1.0 / slowest.sqrt() / TAU, "beam with shear, clamped", Reference::ClosedForm),
        omega(&case, 1, 1)? / TAU,
        (5e-3, "Hz"),
    )])
}

fn fitted() -> Case {
    let mut case = case(Shape::Cylinder { radius: RADIUS }, &[(HEIGHT, THICKNESS)], &steel(), (1000.0, 8.0));
    case.tank.rings.push(ring(9.0, 4e-3, 2e-5));
    case.tank.attachments.push(Attachment { name: "platform".into(), mass: 20e3, height: 6.3 });
    case
}

/// Masses of the harmonic model, and the lowest modes of waves around in three dimensions.
fn three_dimensions() -> Answer {
    let case = fitted();
    let mut rows = Vec::new();
    let coupled = build(&case, &Options::default(), 1)?;
    let shell = (TAU * RADIUS * HEIGHT * THICKNESS * STEEL.2, 0.5 * HEIGHT);
    let liquid = (1000.0 * PI * RADIUS * RADIUS * 8.0, 4.0);
    let parts = [liquid, shell, (TAU * RADIUS * 4e-3 * STEEL.2, 9.0), (20e3, 6.3)];
    for (channel, what, exact, unit) in [
        (Channel::BaseShear, "base shear of 1 m/s²", parts.iter().map(|(m, _)| m).sum::<f64>(), "kN"),
        (
            Channel::BaseMoment,
            "base moment of 1 m/s², without the bottom",
            parts.iter().map(|(m, z)| m * z).sum(),
            "kNm",
        ),
    ] {
        let rigid = coupled.probe(channel).map_or(f64::NAN, |probe| {
            probe.ground_acceleration + linalg::dot(&probe.absolute_acceleration, &coupled.influence)
        });
        let reference = (1e-3 * exact, "sums of masses and of their heights", Reference::ClosedForm);
        rows.push(Row::new("R4", what, reference, 1e-3 * rigid, (1e-6, unit)));
    }
    let solid = SolidOptions::default();
    let tank = TankModel::new(&case, &Options::default(), &solid)?;
    let system = System::new(&tank.model, &tank.assembler, &[], solid.memory_limit_mib << 20)?;
    for n in 1..=5_u32 {
        let expected = structural(&case, n, 2.0)?.first().map_or(f64::NAN, |m| m.omega);
        let modes = of_harmonic(&tank, &system, n, (48, 2), &Silent)?;
        let own = modes.iter().filter(|m| m.kind == Kind::Structural);
        let lowest = own.map(|m| m.omega).fold(f64::INFINITY, f64::min);
        rows.push(Row::new(
            "R5",
            format!("lowest mode, {n} waves around"),
            (expected / TAU, "harmonic engine, twice its default mesh", Reference::SecondFormulation),
            lowest / TAU,
            (0.02, "Hz"),
        ));
    }
    Ok(rows)
}
