//! Response-spectrum method of an engine's own modes.
//!
//! The largest response of an observable in mode j is R_j = r_j S_a(T_j, ξ_j), where r_j is its response per unit of pseudo-acceleration;
//! what is not in the modes kept follows the ground, R_r = r S_a(0). Combined **for each observable**:
//!
//! ```text
//! all modes     R  by SRSS, CQC or the absolute sum of R_j and R_r        (`fem::analysis::spectrum`)
//! two parts     R_i of the structural modes and the rest, R_c of the sloshing modes, each by the same rule;
//!               √(R_i² + R_c²) or R_i + R_c
//! ```
//!
//! Stiff modes move with the ground and so with each other: without that, a rigid tank whose impulsive mass is spread over several
//! structural modes has too small a shear. By SRSS and CQC a structural mode shorter than the period T_p of the spectrum's (first)
//! maximum has a rigid share α_j = S_a(0)/S_a(T_j) (Lindley & Yow 1980; US NRC Regulatory Guide 1.92):
//!
//! ```text
//! R² = R_p² + R_g²        R_p of √(1 − α_j²) R_j by the rule        R_g = Σ α_j R_j + R_r        T → 0: R = Σ R_j + R_r
//! ```
//!
//! Results have no sign: a wave rises and falls alike, a wall bends to both sides. `docs/theory/response-spectrum.md`.

use std::collections::BTreeMap;

use fem::analysis::spectrum::{ModalRule, combined};
use tank::Quantity;
use tank::options::linear::{ModalCombination, PartCombination, SpectrumOptions};

use crate::hoop;
use crate::modes::Kind;
use results::Channel;
use results::channel::{OnWall, Side};

/// A mode that is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeptMode {
    /// Kind.
    pub kind: Kind,
    /// Number within its kind, from 1.
    pub number: usize,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Effective mass [kg].
    pub mass: f64,
}

impl KeptMode {
    /// Period [s].
    pub fn period(&self) -> f64 {
        std::f64::consts::TAU / self.omega
    }
}

/// An observable per unit of pseudo-acceleration of each mode, and of what follows the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// r_j, mode by mode.
    pub modes: Vec<f64>,
    /// r.
    pub rest: f64,
    /// Value in the static state.
    pub static_value: f64,
}

/// Observables over the height of the wall.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitLine {
    /// Output.
    pub what: OnWall,
    /// Heights [m].
    pub z: Vec<f64>,
    /// One a height.
    pub units: Vec<Unit>,
}

/// The response of a tank to horizontal motion, mode by mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalUnits {
    /// The modes kept, by ascending frequency.
    pub modes: Vec<KeptMode>,
    /// Scalars.
    pub scalars: Vec<(Channel, Unit)>,
    /// Lines over the height.
    pub lines: Vec<UnitLine>,
    /// Height of the surface at rest [m].
    pub level: f64,
    /// The same of vertical motion, whose axisymmetric modes are the breathing wall; none where the site does not ask for it.
    pub vertical: Option<Box<ModalUnits>>,
}

/// Acceleration [m/s²] at a period [s], 0 for the ground, and a damping ratio.
pub type Ordinates<'a> = &'a dyn Fn(f64, f64) -> f64;

/// A design spectrum by kind of mode.
#[derive(Clone, Copy)]
pub struct Action<'a> {
    /// Structural modes; at T = 0 what follows the ground.
    pub structural: Ordinates<'a>,
    /// Sloshing modes, for forces and stresses.
    pub sloshing: Ordinates<'a>,
    /// Sloshing modes, for waves.
    pub wave: Ordinates<'a>,
}

/// Largest values along a line over the height.
#[derive(Clone, Debug, PartialEq)]
pub struct LinePeaks {
    /// Output.
    pub what: OnWall,
    /// Heights [m].
    pub z: Vec<f64>,
    /// Largest absolute values, seismic part.
    pub values: Vec<f64>,
}

/// The response to a spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectral {
    /// Accelerations of the modes kept [m/s²]: forces and stresses; that of an over-critical mode, which is switched off, is 0.
    pub accelerations: Vec<f64>,
    /// Acceleration of what follows the ground [m/s²].
    pub ground: f64,
    /// Comparable values.
    pub values: BTreeMap<Quantity, f64>,
    /// Values over the height.
    pub lines: Vec<LinePeaks>,
    /// Axial membrane stress of the base, largest seismic part and static value [Pa].
    pub base_axial: Option<(f64, f64)>,
}

/// Accelerations of one kind of observable.
struct Seen {
    modes: Vec<f64>,
    /// α_j.
    rigid: Vec<f64>,
    ground: f64,
}

/// Share of the lesser of two components (EN 1998-1 4.3.3.5.2).
const LESSER: f64 = 0.3;

/// Step of the search for the largest ordinate [s] and longest period in it: the shortest control period T_B of EN 1998-1 is 0.05 s,
/// and no design spectrum has its maximum beyond 2 s.
const SEARCH: (f64, f64) = (0.005, 2.0);

/// Period of the first maximum of a spectrum [s].
fn first_maximum(spectrum: Ordinates<'_>, damping: f64) -> f64 {
    let (step, last) = SEARCH;
    let mut best = (0.0, spectrum(0.0, damping));
    for k in 1..=(last / step) as usize {
        let period = k as f64 * step;
        let value = spectrum(period, damping);
        // Rounding on a plateau is no new maximum.
        if value > best.1 * (1.0 + 1e-9) {
            best = (period, value);
        }
    }
    best.0
}

impl ModalUnits {
    /// Whether a mode of a kind stands here, and its longest period [s].
    pub fn longest(&self) -> Option<(Kind, f64)> {
        let first = self.modes.iter().min_by(|a, b| a.omega.total_cmp(&b.omega))?;
        Some((first.kind, first.period()))
    }

    /// Largest responses to a spectrum.
    ///
    /// * `round`: whether the tank is a cylinder, whose walls have hoop and axial stress
    pub fn respond(&self, action: &Action<'_>, options: &SpectrumOptions, round: bool) -> Spectral {
        let forces = self.seen(action.structural, action.sloshing, options);
        let waves = self.seen(action.structural, action.wave, options);
        let keys: Vec<(f64, f64)> = self.modes.iter().map(|m| (m.omega, m.damping.max(0.0))).collect();
        let peak = |unit: &Unit, seen: &Seen| self.peak(unit, seen, &keys, options);
        let mut values = BTreeMap::new();
        for (channel, unit) in &self.scalars {
            let seen = if channel.is_wave() { &waves } else { &forces };
            let counts = round || !matches!(channel, Channel::Base(OnWall::Axial));
            if let Some(quantity) = channel.quantity().filter(|_| counts) {
                values.insert(quantity, peak(unit, seen));
            }
        }
        let lines: Vec<LinePeaks> = self
            .lines
            .iter()
            .map(|line| LinePeaks {
                what: line.what,
                z: line.z.clone(),
                values: line.units.iter().map(|unit| peak(unit, &forces)).collect(),
            })
            .collect();
        if let Some(line) = lines.iter().find(|l| l.what == OnWall::Hoop && round) {
            hoop::put(&mut values, (&line.z, self.level), |i| line.values[i]);
        }
        let axial = self.scalar(Channel::Base(OnWall::Axial)).filter(|_| round);
        Spectral {
            base_axial: axial.map(|unit| (peak(unit, &forces), unit.static_value)),
            accelerations: forces.modes,
            ground: forces.ground,
            values,
            lines,
        }
    }

    /// The response to a horizontal spectrum with that to a vertical one, and the structural mode of vertical motion that carries most of the
    /// pressure at the base; none without vertical modes.
    ///
    /// ```text
    /// R = max(R_h + 0.3 R_v, c R_h + R_v)          for each observable
    /// ```
    ///
    /// * `upwards`: the vertical spectrum, and c
    ///
    /// Source: EN 1998-1:2004 4.3.3.5.2(4), as for the pressures of EN 1998-4:2006 A.2.2 and A.3.3. R_v by the same rule for modes: the
    /// breathing modes, and what follows the ground with S_v(0), whose sum on a rigid wall is ρ S_v(0) (H − z).
    pub fn with_vertical(
        &self,
        horizontal: &Spectral,
        (upwards, beside): (Ordinates<'_>, f64),
        options: &SpectrumOptions,
        round: bool,
    ) -> Option<(Spectral, Option<KeptMode>)> {
        let units = self.vertical.as_ref()?;
        let action = Action { structural: upwards, sloshing: upwards, wave: upwards };
        let vertical = units.respond(&action, options, round);
        let larger = |h: f64, v: f64| (h + LESSER * v).max(beside * h + v);
        let mut found = horizontal.clone();
        for (quantity, value) in &mut found.values {
            *value = larger(*value, vertical.values.get(quantity).copied().unwrap_or(0.0));
        }
        for line in &mut found.lines {
            let same = vertical.lines.iter().find(|l| l.what == line.what && l.z == line.z);
            let Some(same) = same else { continue };
            for (h, v) in line.values.iter_mut().zip(&same.values) {
                *h = larger(*h, *v);
            }
        }
        if let Some(line) = found.lines.iter().find(|l| l.what == OnWall::Hoop && round) {
            hoop::put(&mut found.values, (&line.z, self.level), |i| line.values[i]);
        }
        if let (Some((peak, _)), Some((other, _))) = (&mut found.base_axial, vertical.base_axial) {
            *peak = larger(*peak, other);
        }
        Some((found, units.breathing()))
    }

    /// The structural mode with the largest pressure at the base under a unit acceleration.
    pub fn breathing(&self) -> Option<KeptMode> {
        let pressure = self.lines.iter().find(|l| l.what == OnWall::Pressure)?.units.first()?;
        let shares = self.modes.iter().zip(&pressure.modes);
        let structural = shares.filter(|(mode, _)| mode.kind == Kind::Structural);
        let largest = structural.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        Some(*largest.0)
    }

    /// An observable of the tank.
    pub fn scalar(&self, channel: Channel) -> Option<&Unit> {
        self.scalars.iter().find(|(c, _)| *c == channel).map(|(_, unit)| unit)
    }

    /// The wave at the wall.
    pub fn wave(&self) -> Option<&Unit> {
        self.scalar(Channel::Wave(Side::Front))
    }

    fn seen(&self, structural: Ordinates<'_>, sloshing: Ordinates<'_>, options: &SpectrumOptions) -> Seen {
        let of = |mode: &KeptMode| match mode.kind {
            // An over-critical mode is switched off.
            _ if mode.damping >= 1.0 => 0.0,
            Kind::Sloshing => sloshing(mode.period(), mode.damping.max(0.0)),
            Kind::Structural | Kind::Rotational => structural(mode.period(), mode.damping.max(0.0)),
        };
        // A stiff structural mode has the same damping as what follows the ground; at T = 0 it is of no account.
        let stiff = self.modes.iter().rev().find(|m| m.kind != Kind::Sloshing);
        let damping = stiff.map_or(0.05, |m| m.damping.clamp(0.0, 1.0));
        let (turn, zero) = (first_maximum(structural, damping), structural(0.0, damping));
        let modes: Vec<f64> = self.modes.iter().map(of).collect();
        let share = |(mode, acceleration): (&KeptMode, &f64)| match mode.kind {
            Kind::Structural | Kind::Rotational if mode.period() <= turn && *acceleration > 0.0 => {
                (zero / acceleration).min(1.0)
            }
            _ => 0.0,
        };
        Seen {
            rigid: self.modes.iter().zip(&modes).map(share).collect(),
            modes,
            ground: if options.missing_mass { zero } else { 0.0 },
        }
    }

    fn peak(&self, unit: &Unit, seen: &Seen, keys: &[(f64, f64)], options: &SpectrumOptions) -> f64 {
        let rule = match options.combination {
            ModalCombination::Cqc => ModalRule::Cqc,
            ModalCombination::Srss => ModalRule::Srss,
            ModalCombination::Abs => ModalRule::Absolute,
        };
        let own: Vec<f64> = unit.modes.iter().zip(&seen.modes).map(|(r, a)| r * a).collect();
        let rest = unit.rest * seen.ground;
        let of = |chosen: &[usize], rest: f64| {
            let keys: Vec<(f64, f64)> = chosen.iter().map(|&j| keys[j]).collect();
            if rule == ModalRule::Absolute {
                let own: Vec<f64> = chosen.iter().map(|&j| own[j]).collect();
                return combined(rule, &keys, &own, rest);
            }
            let swinging = |&j: &usize| own[j] * (1.0 - seen.rigid[j].powi(2)).max(0.0).sqrt();
            let swinging: Vec<f64> = chosen.iter().map(swinging).collect();
            let ground: f64 = chosen.iter().map(|&j| seen.rigid[j] * own[j]).sum();
            combined(rule, &keys, &swinging, ground + rest)
        };
        let part = |convective: bool| {
            let belongs = |j: &usize| (self.modes[*j].kind == Kind::Sloshing) == convective;
            let chosen: Vec<usize> = (0..own.len()).filter(belongs).collect();
            of(&chosen, if convective { 0.0 } else { rest })
        };
        match options.parts {
            PartCombination::Modal => of(&(0..own.len()).collect::<Vec<_>>(), rest),
            PartCombination::Srss => part(false).hypot(part(true)),
            PartCombination::Abs => part(false) + part(true),
        }
    }
}

#[cfg(test)]
mod tests;
