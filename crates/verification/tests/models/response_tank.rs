//! Source:    potential flow in a rigid cylinder and strip; statics of a tilted liquid; direct against modal integration
//! Goal:      time histories of coupled tanks: wave, resultants, stresses, missing mass, two integrators
//! Model:     tanks 8.1, 8.2, 8.3 and strip 8.4 of the dissertation on the default mesh unless stated otherwise
//! Expected:  exact series and limits; equality of two methods
//! Tolerance: at each test

use codes::mechanical::{Plan, sloshing_omega, wave_factor};
use engines::damping::Damper;
use engines::harmonic::build;
use engines::modes::{CoupledMode, Kind, solve};
use engines::response::motion::{Grid, Motion};
use engines::response::observe::Observed;
use engines::response::superpose::{self, ModalSystem, Observable};
use engines::{Integrator, Options, simulate};
use oscillator::record::Record;
use oscillator::sdof;
use tank::Case;
use tank::Shape;
use tank::case::GroundMotion;

use crate::motions::{broad_band, slow_pulse, swelling_harmonic};
use crate::tanks::{GRAVITY, assert_close, broad, case, column, material, slender};

fn shaken(mut case: Case, horizontal: Record) -> Case {
    case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
    case
}

/// Strip 8.4 as a monolithic wall.
fn strip() -> Case {
    let shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    case(shape, &[(3.0, 0.3)], &material(34e9, 0.2, 2950.0), (1019.4, 2.57))
}

fn quick() -> Options {
    Options { mesh_error: false, ..Options::default() }
}

/// A constant acceleration tilts the surface by a/g and adds the pressure ρ a x: wave R a/g, base shear m a, and by
/// integration of that pressure the moments m a H/2 and, at the bottom, π ρ a R⁴/4 more. Wall: its mass at its centroid.
/// Waves in all modes within 0.1 %, resultants within 0.01 % (the flexible wall widens the tank by 1e-5, and the slow
/// rise leaves oscillations of 1e-5).
#[test]
fn slow_acceleration_tilts_the_liquid() {
    let tank = broad(1000.0);
    let a = 0.5;
    let options = Options { wave_modes: 1000, ..quick() };
    let found = simulate(&shaken(tank.clone(), slow_pulse(0.1, a, 150.0, 3.0)), &options).unwrap();
    let at_rest = 1515;
    let (r, h, rho) = (1.83, 1.525, 1000.0);
    let (liquid, wall) = (tank.liquid_mass(), tank.tank.wall_mass());
    let check = |id: &str, expected: f64, tolerance: f64| {
        assert_close(id, column(&found, id)[at_rest], expected, tolerance);
    };
    check("wave_height_theta_0", -r * a / GRAVITY, 1e-3);
    check("wave_height_theta_180", r * a / GRAVITY, 1e-3);
    check("base_shear", (liquid + wall) * a, 1e-4);
    let moment = liquid * a * h / 2.0 + wall * a * tank.tank.wall_centroid();
    check("base_moment", moment, 1e-4);
    let bottom = std::f64::consts::PI * rho * a * r.powi(4) / 4.0;
    check("overturning_moment", moment + bottom, 1e-4);
    // Pressure ρ a R at every height, over which the envelope's larger side is this constant.
    let pressure = found.result.envelopes.iter().find(|e| e.id == "pressure").unwrap();
    for (z, (low, high)) in pressure.z.iter().zip(pressure.min.iter().zip(&pressure.max)) {
        assert_close(&format!("pressure at {z}"), high.max(-low), rho * a * r, 2e-3);
    }
}

/// Wave height of a rigid tank in the first five modes against the exact series Σ 2R/(λ²−1) ω_n² D_n(t)/g, sample by
/// sample over 20 s. The phase of the third to fifth mode drifts with their error in frequency (up to 0.4 % on the default
/// mesh), which falls with the fourth power of the mesh: 5 % of the peak allowed on the default mesh, a tenth of that on
/// a mesh twice as fine; the peak itself within 1 % and 0.1 %.
#[test]
fn wave_follows_the_exact_series() {
    let thick = case(Shape::Cylinder { radius: 1.83 }, &[(1.83, 0.2)], &material(210e9, 0.3, 7850.0), (1000.0, 1.525));
    let motion = broad_band(0.02, 20.0);
    let mut exact = vec![0.0; motion.acceleration.len()];
    for n in 1..=5 {
        let omega = sloshing_omega(Plan::Circle, n, 1.83, 1.525, GRAVITY);
        let factor = wave_factor(Plan::Circle, n) * 1.83 * omega * omega / GRAVITY;
        let history = sdof::exact(&motion.acceleration, motion.dt, omega, thick.damping.sloshing);
        for (e, u) in exact.iter_mut().zip(&history.u) {
            *e += factor * u;
        }
    }
    let peak = exact.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    for (refine, tolerance, on_peak) in [(1.0, 0.05, 0.01), (2.0, 0.005, 0.001)] {
        let options = Options { refine, ..quick() };
        let found = simulate(&shaken(thick.clone(), motion.clone()), &options).unwrap();
        let wave = column(&found, "wave_height_theta_0");
        let worst = exact.iter().zip(wave).map(|(e, w)| (e - w).abs()).fold(0.0, f64::max);
        let found = wave[..exact.len()].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        assert!(worst < tolerance * peak, "{worst} of {peak}");
        assert_close("peak", found, peak, on_peak);
    }
}

/// Tank 8.2 under 5 mm at 1.2 Hz: steady amplitude Σ 2R/(λ²−1) u₀Ω²/(1 − (Ω/ω_n)²)/g; 3.81 mm with five modes, 3.90 mm
/// with all (theory sheets: 3.8 and 3.90 mm; half the last digit). The finite elements against the series itself within
/// 0.5 % for five modes and 1 % for all, which the mesh has only so many of.
#[test]
fn steady_wave_of_the_model_tank() {
    let (r, h, omega, amplitude) = (0.096, 0.09, std::f64::consts::TAU * 1.2, 0.005);
    let series = |modes: usize| -> f64 {
        let ground = amplitude * omega * omega;
        (1..=modes)
            .map(|n| {
                let q = omega / sloshing_omega(Plan::Circle, n, r, h, GRAVITY);
                wave_factor(Plan::Circle, n) * r * ground / (1.0 - q * q) / GRAVITY
            })
            .sum()
    };
    assert!((series(5) - 3.8e-3).abs() < 0.05e-3, "{}", series(5));
    let mut tank = case(Shape::Cylinder { radius: r }, &[(0.225, 0.02)], &material(210e9, 0.3, 7850.0), (1000.0, h));
    tank.damping.sloshing = 0.001;
    // Swelling over 40 s leaves no start-up wave; the last sample is at 50 s.
    let motion = swelling_harmonic(1.0 / 60.0, 50.0, amplitude, omega, 40.0);
    for (wave_modes, tolerance) in [(5, 5e-3), (1000, 1e-2)] {
        let options = Options { wave_modes, ..quick() };
        let found = simulate(&shaken(tank.clone(), motion.clone()), &options).unwrap();
        let steady = &column(&found, "wave_height_theta_0")[2700..3000];
        let peak = steady.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let modes = if wave_modes == 5 { 5 } else { 4000 };
        // 50 samples a period, and 300 of them not in step with it: a peak is missed by less than 1 − cos(π/50)/… = 0.1 %.
        assert_close("steady wave", peak, series(modes), tolerance);
    }
}

/// Peaks of all scalars and line outputs of m = 1 with the given modes.
fn peaks(
    case: &Case,
    modes: &[CoupledMode],
    keep: impl Fn(&CoupledMode) -> bool,
    motion: &Record,
) -> Vec<(String, f64)> {
    let coupled = build(case, &Options::default(), 1).unwrap();
    let damper = Damper::ByKind { sloshing: case.damping.sloshing, structural: case.damping.impulsive };
    let system = ModalSystem::new(&coupled, modes.iter().filter(|m| keep(m)).collect(), &damper).unwrap();
    let first = modes.iter().find(|m| m.kind == Kind::Structural).unwrap();
    let grid = Grid::new(motion.dt, motion.duration(), 2.0, std::f64::consts::TAU / first.omega / 60.0);
    let ground = Motion::new(motion, &grid);
    let probes: Vec<_> = coupled.probes.iter().chain(coupled.lines.iter().flat_map(|l| &l.probes)).collect();
    let observables: Vec<Observable> = probes.iter().map(|p| vec![(0, 1.0, *p)]).collect();
    let found: Observed =
        superpose::respond(&[system], &[&ground], grid, &[], &observables, &fem::progress::Silent).unwrap();
    let name = |p: &&engines::probe::Probe| {
        let id = p.channel.id();
        format!("{} {}", id.split("_z_").next().unwrap_or(&id), p.key())
    };
    probes.iter().map(name).zip(found.extremes.iter().map(|e| e.peak().0)).collect()
}

/// The modes kept by default and the missing mass give every peak that all modes give: 0.1 % of the largest value of the
/// same output over the height.
#[test]
fn kept_modes_and_missing_mass_suffice() {
    let damper = Damper::ByKind { sloshing: 0.005, structural: 0.02 };
    let motion = broad_band(0.0115, 12.0);
    for tank in [broad(1000.0), slender(1000.0, 5.0), strip()] {
        let coupled = build(&tank, &Options::default(), 1).unwrap();
        let modes = solve(&coupled, None).unwrap();
        let kept: Vec<f64> = superpose::keep(&coupled, &modes, &damper, 5).iter().map(|m| m.omega).collect();
        assert!(kept.len() < modes.len() / 2);
        let all = peaks(&tank, &modes, |_| true, &motion);
        let some = peaks(&tank, &modes, |m| kept.contains(&m.omega), &motion);
        for ((name, a), (_, s)) in all.iter().zip(&some) {
            let title = name.rsplit_once(' ').unwrap().0;
            let largest = all.iter().filter(|(n, _)| n.starts_with(title)).map(|(_, v)| *v).fold(0.0, f64::max);
            assert!((a - s).abs() <= 1e-3 * largest, "{name}: all {a}, kept {s}, largest {largest}");
        }
    }
}

/// Strip 8.4, moment at the base of a wall (theory sheet on dynamics, D7): sloshing modes with missing mass do not
/// replace the first wall mode; with it the error of the missing mass is below 1 %, with the second below 0.1 %.
#[test]
fn missing_mass_does_not_replace_the_wall_mode() {
    let tank = strip();
    let coupled = build(&tank, &Options::default(), 1).unwrap();
    let modes = solve(&coupled, None).unwrap();
    let motion = broad_band(0.02, 12.0);
    let moment = |structural: usize| {
        let keep = |m: &CoupledMode| match m.kind {
            Kind::Sloshing => m.number <= 12,
            Kind::Structural | Kind::Rotational => m.number <= structural,
        };
        let found = peaks(&tank, &modes, keep, &motion);
        found.into_iter().find(|(name, _)| name.contains("wall_moment_base")).unwrap().1
    };
    let all = moment(usize::MAX);
    let error = |n: usize| (moment(n) / all - 1.0).abs();
    assert!(error(0) > 0.2, "{}", error(0));
    assert!(error(1) < 0.01, "{}", error(1));
    assert!(error(2) < 0.001, "{}", error(2));
}

/// Direct integration of all unknowns against modal superposition: every comparable value within 0.5 %, and the energy
/// balance within 0.1 % (issue's acceptance; by theory it closes to rounding).
fn integrators_agree(tank: Case, motion: Record, refine: f64) {
    let tank = shaken(tank, motion);
    let run = |integrator| {
        let options = Options { integrator, refine, ..quick() };
        simulate(&tank, &options).unwrap()
    };
    let (modal, direct) = (run(Integrator::Modal), run(Integrator::Newmark));
    for (quantity, value) in &modal.values {
        assert_close(quantity.title(), direct.values[quantity], *value, 5e-3);
    }
    for (m, d) in modal.result.envelopes.iter().zip(&direct.result.envelopes) {
        let largest = m.min.iter().chain(&m.max).fold(0.0_f64, |a, v| a.max(v.abs()));
        for (a, b) in m.min.iter().chain(&m.max).zip(d.min.iter().chain(&d.max)) {
            assert!((a - b).abs() <= 5e-3 * largest, "{}: {a} {b} of {largest}", m.id);
        }
    }
    let energy = direct.result.energy.unwrap();
    assert!(energy.error < 1e-3, "{}", energy.error);
    assert!(modal.result.energy.is_none());
}

#[test]
fn integrators_agree_on_the_broad_tank() {
    integrators_agree(broad(1000.0), broad_band(0.0115, 5.0), 0.5);
}

#[test]
fn integrators_agree_on_the_slender_tank() {
    integrators_agree(slender(1000.0, 5.0), broad_band(0.0115, 5.0), 1.0);
}

#[test]
fn integrators_agree_on_the_strip() {
    integrators_agree(strip(), broad_band(0.02, 5.0), 1.0);
}
