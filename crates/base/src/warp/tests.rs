//! Waves of the foot: pressure that couples them, springs in place of strips, work and equilibrium.

use super::*;
use crate::curve::Curve;
use crate::march::Point;
use crate::rocking::Rocking;

/// Springs F = c w: c below the ground and above it.
fn springs(slope: [f64; 2]) -> Rocking {
    let point = |uplift: f64| Point {
        uplift,
        hold_down: slope[usize::from(uplift > 0.0)] * uplift,
        axial_force: 0.0,
        rim_moment: 0.0,
        rotation: 0.0,
        plastic_rotation: 0.0,
        lifted_width: 0.0,
    };
    // The slope changes between the points next to the ground.
    let points = [-1.0, -1e-5, 0.0, 1e-5, 1.0].map(point).to_vec();
    Rocking::new(10.0, 1000.0, vec![(1e5, Curve::through(points))]).unwrap()
}

fn walled(slope: [f64; 2], stiffness: f64) -> Rocking {
    // A round rim leaves the membrane alone.
    let (free, sucked) = ([0.0; WAVES], [[0.0; WAVES]; WAVES]);
    let (held, top) = ([1.0 / stiffness; WAVES], Top::Round);
    springs(slope).warping(Some(Warping {
        free,
        mass: [1.0; WAVES],
        sucked,
        held,
        top,
        lever: 1.0,
        fill: [1.0; 3],
        dry: None,
    }))
}

/// In a broad tank p ∝ Σ (−1)^k/α² cos α ζ, whose integrals are sums of odd powers, λ(3) = 1.05180 and λ(5) = 1.00452, over Catalan's constant
/// 0.915966. In a slender tank p is constant: 1 and 1/3.
#[test]
fn moments_of_the_impulsive_pressure() {
    let near = |found: [f64; 3], wanted: [f64; 3], tolerance: f64| {
        assert!(found.iter().zip(wanted).all(|(f, w)| (f / w - 1.0).abs() < tolerance), "{found:?} {wanted:?}");
    };
    let (catalan, three, five) = (0.915_966, 1.051_80, 1.004_52);
    let alpha: f64 = 2.0 / PI;
    let square = three * alpha.powi(3) - 2.0 * five * alpha.powi(5);
    // Σ (−1)^k/(2k + 1)⁴ = 0.988945.
    let first = three * alpha.powi(3) - 0.988_945 * alpha.powi(4);
    let over = catalan * alpha * alpha;
    near(moments(30.0), [three * alpha / catalan, first / over, square / over], 0.005);
    near(moments(0.02), [1.0, 0.5, 1.0 / 3.0], 0.05);
}

/// Waves 2 and 3 under N_θ, N_zθ and N_z of a pressure that is constant over the height: the second-order work integrated over the wall. Tolerance 1e-3
/// for the midpoint rule.
#[test]
fn a_pressure_with_the_cosine_couples_neighbours() {
    let (radius, height, pressure) = (7.0, 4.0, 3e4);
    let work = |u: [f64; 2]| {
        let (parts, levels) = (720, 200);
        let (dphi, dz) = (2.0 * PI / f64::from(parts), height / f64::from(levels));
        let mut sum = 0.0;
        for i in 0..parts {
            let phi = (f64::from(i) + 0.5) * dphi;
            for j in 0..levels {
                let z = (f64::from(j) + 0.5) * dz;
                // u, v, w and their derivatives of both waves.
                let mut f = [0.0; 8];
                for (n, u) in [2.0, 3.0].into_iter().zip(u) {
                    let (s, c) = f64::sin_cos(n * phi);
                    let own = [
                        u * c,
                        n * u * z / radius * s,
                        -n * n * u * z / radius * c,
                        -n * u * s,
                        n * u / radius * s,
                        -n * n * u / radius * c,
                        n.powi(3) * u * z / radius * s,
                        0.0,
                    ];
                    f.iter_mut().zip(own).for_each(|(f, own)| *f += own);
                }
                let [up, v, _, up_phi, v_z, w_z, w_phi, _] = f;
                let (p, rest) = (pressure * phi.cos(), height - z);
                let (hoop, shear, axial) =
                    (radius * p, -phi.sin() * pressure * rest, -phi.cos() * pressure * rest * rest / (2.0 * radius));
                let beta = (w_phi - v) / radius;
                let strain = 0.5 * hoop * (beta * beta + (up_phi / radius).powi(2))
                    + 0.5 * axial * (v_z * v_z + w_z * w_z)
                    + shear * beta * w_z;
                // The normal turns with the wall.
                let load = 0.5 * p * (-(w_phi - v) * v - radius * w_z * up) / radius;
                sum += (strain - load) * radius * dphi * dz;
            }
        }
        sum
    };
    let both = work([1e-2, 1e-2]) - work([1e-2, 0.0]) - work([0.0, 1e-2]);
    // ½ π R K_nm U_n U_m, twice.
    let found = both / (PI * radius * 1e-4);
    let steel = tank::reference::material(2e11, 0.3, 7850.0);
    let mut case = tank::reference::case(Shape::Cylinder { radius }, &[(height, 0.01)], &steel, (1000.0, height));
    case.tank.roof.holds = tank::RimSupport::Free;
    let mut warping = Warping::of(&case).unwrap();
    let own = warping.sucked[0][1];
    // The pressure of this tank varies over the height.
    let [level, _, square] = moments(radius / height).map(|m| m * height);
    let c = 177.0;
    let even = (c * height / 3.0 * (height / radius).powi(2) - 0.5 * height) / (2.0 * radius);
    assert!((own / ((c * square * (height / radius).powi(2) - 0.5 * level) / (2.0 * radius)) - 1.0).abs() < 1e-12);
    assert!((found / (pressure * even) - 1.0).abs() < 1e-3, "{found} {}", pressure * even);
    warping.held = [0.0; WAVES];
    assert_eq!(warping.under(1e4).stiffness[0][1], -1e4 * own);
}

#[test]
fn even_springs_do_not_warp() {
    let turn = walled([1e6, 1e6], 1e3).at(1e-3, 0.0).unwrap();
    assert!((turn.moment / (PI * 1e3 * 1e6 * 1e-3) - 1.0).abs() < 1e-6, "{turn:?}");
    assert!(turn.waves.iter().all(|u| u.abs() < 1e-9), "{turn:?}");
}

/// A stiff foot stays plane; a soft one lifts farther and holds less. Without any stiffness against waves, membrane theory gives the force along the
/// foot, F = −w_t + M/(πR²) cos φ, and w = F/c of the springs.
#[test]
fn a_stiff_wall_stays_plane_and_a_soft_one_spreads_the_force() {
    let plane = springs([1e7, 1e6]).at(2e-3, 0.0).unwrap();
    let stiff = walled([1e7, 1e6], 1e14).at(2e-3, 0.0).unwrap();
    assert!((stiff.moment / plane.moment - 1.0).abs() < 1e-3 && (stiff.uplift / plane.uplift - 1.0).abs() < 1e-3);
    assert!((stiff.lifted_angle(10.0) - plane.lifted_angle(10.0)).abs() < 2e-3, "{stiff:?} {plane:?}");
    let soft = walled([1e7, 1e6], 1e5).at(2e-3, 0.0).unwrap();
    assert!(soft.moment < plane.moment && soft.uplift > 1.02 * plane.uplift, "{soft:?} {plane:?}");
    let none = walled([1e7, 1e6], 1.0).at(2e-3, 0.0).unwrap();
    let force = none.moment / (PI * 100.0);
    // The series is cut off where the springs change.
    assert!((none.pull / (force - 1000.0) - 1.0).abs() < 0.03, "{none:?} {force}");
    assert!((none.toe_force / (force + 1000.0) - 1.0).abs() < 0.03, "{none:?} {force}");
}

/// The moment is the derivative of the work of strips and wall with respect to the rotation.
#[test]
fn the_moment_is_that_of_the_work() {
    let rocking = walled([1e7, 1e6], 1e6);
    let (n, width) = (720, PI / 720.0);
    let work = |rotation: f64| {
        let turn = rocking.at(rotation, 0.0).unwrap();
        let strips: f64 = (0..n)
            .map(|i| {
                let w = turn.rim(10.0, (f64::from(i) + 0.5) * width);
                0.5 * if w > 0.0 { 1e6 } else { 1e7 } * w * w + 1000.0 * w
            })
            .sum();
        let wall: f64 = turn.waves.iter().map(|u| 0.5 * PI * 1e6 * u * u).sum();
        10.0 * (2.0 * width * strips + wall)
    };
    let slope = (work(2.02e-3) - work(1.98e-3)) / 4e-5;
    let moment = rocking.at(2e-3, 0.0).unwrap().moment;
    assert!((slope / moment - 1.0).abs() < 1e-3, "{slope} {moment}");
}

/// Held at the height of its equilibrium, the foot has the same waves and moment.
#[test]
fn a_foot_that_is_held_in_equilibrium() {
    let rocking = walled([1e7, 1e6], 1e6);
    let turn = rocking.at(2e-3, 0.0).unwrap();
    let mut waves = [0.0; WAVES];
    let (force, moment) = rocking.sums(24, (2e-3, turn.centre), 0.0, &mut waves).unwrap();
    assert!((force / (-2.0 * PI * 10.0 * 1000.0) - 1.0).abs() < 1e-6, "{force}");
    assert!((moment / turn.moment - 1.0).abs() < 1e-6, "{moment} {turn:?}");
    assert!(waves.iter().zip(turn.waves).all(|(a, b)| (a - b).abs() < 1e-9), "{waves:?} {turn:?}");
}

/// The squat tank of `docs/theory/base.md`, section 2: 0.536 of the pressure at rest under a free rim and 1.285 under a girder of 4e-4 m⁴, from the
/// eigenvalues of the full matrices by LAPACK (scipy.linalg.eigh).
#[test]
fn the_lifted_side_softens_at_a_pressure() {
    let steel = tank::reference::material(205e9, 0.3, 7850.0);
    let courses = [(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)];
    let mut case = tank::reference::case(Shape::Cylinder { radius: 25.0 }, &courses, &steel, (1000.0, 9.0));
    case.tank.roof.holds = tank::RimSupport::Free;
    let rest = 1000.0 * case.gravity * 9.0;
    let free = Warping::of(&case).unwrap();
    assert!((free.softened() / rest - 0.536).abs() < 1e-3, "{}", free.softened() / rest);
    let girder = tank::Ring { height: 10.0, area: 1.2e-2, inertia: 4e-4, material: steel };
    case.tank.rings.push(girder);
    let held = Warping::of(&case).unwrap();
    assert!((held.softened() / rest - 1.285).abs() < 1e-3, "{}", held.softened() / rest);
    case.tank.roof.holds = tank::RimSupport::Round;
    assert_eq!(Warping::of(&case).unwrap().softening(), None);
}

/// The waves of Δp with m = 1 alone couple neighbours as the pressure of the motion does.
#[test]
fn a_wave_of_the_missing_pressure_couples_as_the_pressure_does() {
    let steel = tank::reference::material(2e11, 0.3, 7850.0);
    let mut case = tank::reference::case(Shape::Cylinder { radius: 7.0 }, &[(4.0, 0.01)], &steel, (1000.0, 4.0));
    case.tank.roof.holds = tank::RimSupport::Free;
    let warping = Warping::of(&case).unwrap();
    let [level, _, square] = moments(7.0 / 4.0);
    for k in 0..WAVES - 1 {
        let found = dry::coupled(k + 2, k + 3, 1, 7.0, [4.0 * level, 64.0 * square]);
        assert!((found / warping.sucked[k][k + 1] - 1.0).abs() < 1e-12, "{k}: {found} {}", warping.sucked[k][k + 1]);
    }
    // The hydrostatic pressure, m = 0: n⁴ (n² − 1) ρ g H⁴/(12 R³).
    let rest = 1000.0 * case.gravity * 4.0;
    for n in [2, 3, 7] {
        let own = n as f64;
        let wanted = own.powi(4) * (own * own - 1.0) * rest * 64.0 / (12.0 * 343.0);
        let found = dry::coupled(n, n, 0, 7.0, [rest * 2.0, rest * 64.0 / 12.0]);
        assert!((found / wanted - 1.0).abs() < 1e-12, "{n}: {found} {wanted}");
    }
}

/// Load and stiffness of Δp of a squat tank at 0.49 of the pressure at rest, against sums on a grid of 1000 × 720 by an independent program [N/m].
#[test]
fn liquid_that_does_not_pull_presses_the_middle_down() {
    let dry = Dry::new([25.0, 9.0, 1000.0 * 9.80665 * 9.0]);
    let (load, _) = dry.at(0.49 * 1000.0 * 9.80665 * 9.0);
    for (found, wanted) in load.iter().zip([-2154.2, -3462.4, -3707.0, -2760.3]) {
        assert!((found / wanted - 1.0).abs() < 0.02, "{load:?}");
    }
    assert_eq!(dry.at(0.1 * 1000.0 * 9.80665 * 9.0).0, [0.0; WAVES]);
}

/// Shells of `push`, whose liquid does not pull, at two states of the squat tank under a free rim (`docs/theory/base.md`, section 2): moment within 5 %,
/// lifted angle within 2 %, and the middle of the lifted side higher by at most 4 mm; where liquid pulls, by up to 14 mm.
#[test]
fn strips_beside_shells_whose_liquid_does_not_pull() {
    let steel = tank::reference::material(205e9, 0.3, 7850.0);
    let courses = [(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)];
    let mut case = tank::reference::case(Shape::Cylinder { radius: 25.0 }, &courses, &steel, (1000.0, 9.0));
    case.tank.roof.holds = tank::RimSupport::Free;
    case.tank.support = tank::Support::Unanchored;
    case.tank.bottom = Some(tank::Bottom {
        thickness: 0.01,
        corrosion: 0.0,
        width: None,
        sketch: None,
        projection: 0.0,
        subgrade_modulus: Some(1e8),
        material: steel,
    });
    let base = crate::Base::of(&case).unwrap();
    let [pulls, parts] = [base.clone(), base.clone().without_pull()].map(|b| b.rocking(-0.06, 0.2, true).unwrap());
    for (psi, share, moment, uplift, angle) in
        [(0.21e-3, 0.43, 73.8e6, 3.8e-3, 1.74), (0.37e-3, 0.49, 84.5e6, 6.8e-3, 2.18)]
    {
        let [pulls, parts] = [&pulls, &parts].map(|rocking| rocking.at(psi, share * base.pressure).unwrap());
        assert!((parts.moment / moment - 1.0).abs() < 0.05, "{parts:?}");
        assert!((2.0 * parts.lifted_angle(base.radius) / angle - 1.0).abs() < 0.02, "{parts:?}");
        assert!(parts.uplift - uplift < 4e-3 && parts.uplift < 0.7 * pulls.uplift, "{parts:?} {pulls:?}");
    }
}

/// In a slender tank the liquid of a wave is that around a cylinder that ovals in a plane, ρ R/n per area: ∫ (n² z/R)² ρ R/n dz = n³ ρ H³/(3 R). What comes
/// after sixty terms of the series is 6/(60 π²) = 1 % there, and the surface takes about as much of a depth of 200 radii.
#[test]
fn liquid_that_ovals_in_a_slender_tank() {
    for n in [2, 3, 7] {
        let found = ovalling(0.005, 1.0)[n - 2];
        assert!((found / (0.005 / n as f64 / 3.0) - 1.0).abs() < 0.02, "{n}: {found}");
    }
}

/// I_n(x)/I_n′(x) by order and argument (scipy.special.ive).
const RATIOS: [(usize, f64, f64); 8] = [
    (1, 0.3, 0.29342261),
    (1, 20.0, 1.02460303),
    (2, 5.0, 1.00993566),
    (12, 30.0, 0.941059493),
    (12, 49.9, 0.981351348),
    (12, 50.1, 0.981534542),
    (1, 60.0, 1.00829564),
    (7, 200.0, 1.00189131),
];

/// Within 1e-4, the next term of Debye's series.
#[test]
fn ratios_of_bessel_functions() {
    for (n, x, wanted) in RATIOS {
        let found = bessel::<13>(x)[n];
        assert!((found / wanted - 1.0).abs() < 1e-4, "{n} {x}: {found}");
    }
}
