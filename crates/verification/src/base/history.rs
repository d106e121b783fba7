//! Rocking in time.
//!
//! Source:    Malhotra & Veletsos 1994 (rotational spring of a rocking tank); an independent program
//! Model:     `base::history` with the strips of tank C, and the harmonic engine on an unanchored tank like it
//! Reference: springs in series; T = 4 ∫ du/√(2 (E(A) − E(u))/m); an independent program; the run held down
//! Tolerance: periods 1e-4: at 0.1 ms the method is off by (ω h)²/12 = 1e-6 and takes less than that from the amplitude, the quadrature of
//!            2000 panels by less; independent program 1 %, as its moments at a rotation are within 2 %; a tank that does not lift 1e-9, as it
//!            is the same run; energy 1e-3 of the input at 1 ms

use std::f64::consts::{FRAC_PI_2, TAU};

use ::base::Law;
use ::base::history::{Body, BodyMode, History, Run, march};
use oscillator::record::Record;
use results::BaseEnergy;
use tank::case::GroundMotion;
use tank::reference::{case, material};
use tank::{Bottom, Case, Foundation, FoundationKind, Material, Shape, Support};

use super::rocking::rocking;
use super::{TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::soil::IMPULSIVE;
use crate::{Answer, Failure, Reference, Row};
use engines::{Options, simulate};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-history",
    title: "Rocking in time",
    model: "Tank C, elastic bottom plate on k = 10⁸ N/m³, its impulsive mass on one spring without damping; a pulse of 0.04 s, then free \
            vibration at 0.1 ms. The harmonic engine: steel, 40 m across, 15 m of oil, 10 mm of bottom plate that yields, bursts of waves.",
    ids: &[
        ("U9", "period before any uplift"),
        ("U10", "period of free rocking by quadrature"),
        ("U11", "period of free rocking against an independent program"),
        ("U12", "an unanchored tank too heavy to lift against the same held down"),
        ("U13", "balance of energy of runs that lift"),
    ],
    parts: &[Part::Fast(free_rocking), Part::Tested(engine)],
};

const STEP: f64 = 1e-4;
/// Steps of the pulse, and of a run.
const PULSE: usize = 400;
const STEPS: usize = 24_000;
/// Steps after which the vibration is free.
const FREE: usize = 2_000;

/// The impulsive mass of tank C on its wall.
struct Impulsive {
    mass: f64,
    arm: f64,
    omega: f64,
}

impl Impulsive {
    fn of_tank_c() -> Impulsive {
        let (_, _, [mass, arm, period]) = IMPULSIVE[1];
        let omega = TAU / period;
        Impulsive { mass, arm, omega }
    }

    fn stiffness(&self) -> f64 {
        self.mass * self.omega * self.omega
    }

    fn body(&self) -> Body {
        Body {
            modes: vec![BodyMode {
                omega: self.omega,
                damping: 0.0,
                translation: self.mass.sqrt(),
                rotation: self.mass.sqrt() * self.arm,
                pressure: 0.0,
            }],
            mass: self.mass,
            first_moment: self.mass * self.arm,
            second_moment: self.mass * self.arm * self.arm,
        }
    }

    fn swing(&self, law: &Law, pulse: f64) -> Result<Swing, Failure> {
        let ground: Vec<f64> = (0..STEPS).map(|i| if i < PULSE { pulse } else { 0.0 }).collect();
        let history = march(&Run {
            body: &self.body(),
            law: Some(law),
            ring: None,
            heave: None,
            waves: None,
            hysteretic: 0.0,
            dashpot: 0.0,
            friction: None,
            rigid_pressure: [0.0; 2],
            step: STEP,
            ground: &ground,
        })
        .map_err(failure)?;
        Ok(Swing::of(&history))
    }

    /// The pulse after which the free vibration has this largest shear [N].
    fn pulse(&self, law: &Law, shear: f64) -> Result<f64, Failure> {
        let (mut low, mut high) = (0.0, 20.0);
        for _ in 0..16 {
            let middle = 0.5 * (low + high);
            if self.swing(law, middle)?.shear < shear { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }

    /// Period with the amplitude ψ of the rotation. The displacement of the mass is that of its spring and of the base,
    /// u = V/k + h ψ with V h = M(ψ); ψ = A sin χ removes the singularity.
    fn period(&self, law: &Law, amplitude: f64) -> f64 {
        const PANELS: usize = 2000;
        let (k, h) = (self.stiffness(), self.arm);
        let at = |chi: f64| law.respond(amplitude * chi.sin(), 0.0, 0.0, &[]);
        let power = |chi: f64| at(chi).moment * amplitude * chi.cos();
        let width = FRAC_PI_2 / PANELS as f64;
        // ∫ M dψ by Gauss's rule of two points.
        let gauss = |from: f64, to: f64| {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let off = half / 3.0_f64.sqrt();
            half * (power(middle - off) + power(middle + off))
        };
        let top = at(FRAC_PI_2).moment / h;
        let (mut above, mut quarter) = (0.0, 0.0);
        for i in (0..PANELS).rev() {
            let (from, to) = (i as f64 * width, (i as f64 + 1.0) * width);
            let chi = 0.5 * (from + to);
            let base = at(chi);
            let shear = base.moment / h;
            let lost = above + gauss(chi, to) + 0.5 * (top * top - shear * shear) / k;
            let du = base.tangent / (h * k) + h;
            quarter += du * amplitude * chi.cos() / (2.0 * lost / self.mass).sqrt() * width;
            above += gauss(from, to);
        }
        4.0 * quarter
    }
}

/// Free vibration after the pulse.
struct Swing {
    /// Mean period [s].
    period: f64,
    /// Largest rotation [rad].
    rotation: f64,
    /// Largest shear [N].
    shear: f64,
    /// Deviation of the balance of energy over the input.
    balance: f64,
}

impl Swing {
    fn of(history: &History) -> Swing {
        let late = &history.rotation[FREE..];
        let crossings: Vec<f64> = (late.windows(2).enumerate())
            .filter(|(_, w)| w[0] < 0.0 && w[1] >= 0.0)
            .map(|(i, w)| i as f64 - w[0] / (w[1] - w[0]))
            .collect();
        let period = match (crossings.first(), crossings.last()) {
            (Some(first), Some(last)) => STEP * (last - first) / (crossings.len() - 1) as f64,
            _ => f64::NAN,
        };
        let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        Swing { period, rotation: largest(late), shear: largest(&history.shear[FREE..]), balance: history.balance }
    }
}

fn free_rocking() -> Answer {
    let tank = &TANKS[2];
    let impulsive = Impulsive::of_tank_c();
    let law = Law::new(&rocking(tank, false, 1e8)?, 7e-3).map_err(failure)?;
    let mut rows = Vec::new();
    // Before the rim leaves the ground the base is a spring.
    let small = impulsive.swing(&law, 1e-3)?;
    let series = 1.0 + impulsive.stiffness() * impulsive.arm.powi(2) / law.initial();
    let springs = TAU / impulsive.omega * series.sqrt();
    let closed = |value| (value, "T_i √(1 + k h²/K₀)", Reference::ClosedForm);
    rows.push(Row::new("U9", "period of a small vibration", closed(springs), small.period, (1e-4, "s")));
    let other = |value| (value, "independent program", Reference::SecondFormulation);
    rows.push(Row::new("U11", "period before uplift", other(0.276), small.period, (0.01, "s")));
    for (share, period) in [(0.37, 0.324), (0.55, 0.413), (0.73, 0.486)] {
        let weight = impulsive.mass * super::GRAVITY;
        let swing = impulsive.swing(&law, impulsive.pulse(&law, share * weight)?)?;
        let place = format!("at a shear of {share} m g");
        let quadrature = impulsive.period(&law, swing.rotation);
        let closed = (quadrature, "T = 4 ∫ du/√(2 (E(A) − E(u))/m)", Reference::ClosedForm);
        rows.push(Row::new("U10", format!("period {place}"), closed, swing.period, (1e-4, "s")));
        rows.push(Row::new("U11", format!("period {place}"), other(period), swing.period, (0.01, "s")));
        let zero = (0.0, "balance of energy", Reference::ClosedForm);
        let what = format!("deviation over the input, free rocking {place}");
        rows.push(Row::new("U13", what, zero, swing.balance, (1e-3, "1")));
    }
    Ok(rows)
}

/// An oil tank with this mass of roof [kg] on this ground [N/m³], under bursts of waves of this size [m/s²].
fn oil(roof: f64, modulus: f64, peak: f64, friction: Option<f64>) -> Case {
    let steel = Material { yield_strength: Some(205e6), ..material(205e9, 0.3, 7850.0) };
    let courses = [(4.8, 0.023), (4.8, 0.016), (7.2, 0.009)];
    let mut case = case(Shape::Cylinder { radius: 20.0 }, &courses, &steel, (870.0, 15.0));
    case.tank.support = Support::Unanchored;
    case.tank.roof.mass = roof;
    case.tank.bottom = Some(Bottom {
        thickness: 0.01,
        corrosion: 0.0,
        width: None,
        sketch: None,
        projection: 0.0,
        subgrade_modulus: None,
        material: steel,
    });
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Soil,
        stiffness: Some(modulus),
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 1.0 / 3.0,
        thickness: None,
        friction,
    });
    let acceleration = (0..600).map(|i| {
        let t = 0.01 * f64::from(i);
        peak * (0.5 * TAU * t / 6.0).sin().powi(2) * ((TAU * 3.1 * t).sin() + 0.6 * (TAU * 1.3 * t).sin())
    });
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "waves".into(),
            dt: 0.01,
            acceleration: acceleration.collect(),
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    case
}

/// What went anywhere: stored, lost, radiated [J].
fn spent(energy: &BaseEnergy) -> f64 {
    let base = energy.base_elastic + energy.base_hysteretic + energy.base_radiated;
    energy.body + energy.viscous + base + energy.friction
}

fn engine() -> Answer {
    let options = Options { mesh_error: false, ..Options::default() };
    let mut rows = Vec::new();
    // 2000 t of roof.
    let free = oil(2e6, 1e12, 0.1, None);
    let mut held = free.clone();
    held.tank.support = Support::Anchored;
    let (free, held) = (simulate(&free, &options)?, simulate(&held, &options)?);
    for (quantity, value) in &held.values {
        let computed = free.values.get(quantity).copied().unwrap_or(f64::NAN);
        let reference = (*value, "held down", Reference::SecondFormulation);
        let unit = quantity.dimension().si_symbol();
        rows.push(Row::new("U12", quantity.title(), reference, computed, (1e-9, unit)));
    }
    for (what, friction) in [("lifting", None), ("lifting and sliding", Some(0.15))] {
        let run = simulate(&oil(25e3, 1e8, 2.0, friction), &options)?;
        let base = (run.result.base).ok_or_else(|| Failure::from("the tank does not lift".to_owned()))?;
        let energy = &base.energy;
        let zero = (0.0, "balance of energy", Reference::ClosedForm);
        rows.push(Row::new(
            "U13",
            format!("largest deviation over the largest input, {what}"),
            zero,
            energy.error,
            (1e-3, "1"),
        ));
        rows.push(Row::new(
            "U13",
            format!("energies at the end over the input, {what}"),
            (1.0, "balance of energy", Reference::ClosedForm),
            spent(energy) / energy.input,
            (1e-3, "1"),
        ));
    }
    Ok(rows)
}
