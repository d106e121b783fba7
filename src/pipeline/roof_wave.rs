//! The wave and the roof: what presses on a fixed roof, and what a floating one does to the waves.

use std::f64::consts::TAU;

use codes::mechanical::{Plan, wave_factor};
use codes::modal_action::ModalAction;
use codes::{roof_wave, site_action};
use oscillator::spectrum::ordinates;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::case::Case;

use crate::job::Job;
use results::roof_wave::{Bent, Carried, Pressed, fixed, floating};
use results::{FE, Method, Part, Status};

/// None of a tank without a roof, and of a fixed roof that no wave reaches.
pub(super) fn part(job: &Job, methods: &[Method]) -> Option<Part> {
    let case = &job.case;
    if case.tank.roof.afloat > 0.0 {
        return carried(case);
    }
    let pressed: Vec<Pressed> = methods.iter().filter_map(|method| pressed(case, method)).collect();
    fixed(case.freeboard(), &pressed)
}

fn pressed(case: &Case, method: &Method) -> Option<Pressed> {
    if method.status != Status::Computed {
        return None;
    }
    let value = |quantity: Quantity| method.quantities.get(quantity.id()).map(|found| found.value);
    let crest = value(Quantity::SloshingCrest)?;
    let contact = roof_wave::contact(case, crest)?;
    let mass = value(Quantity::ConvectiveMass).map(|mass| contact.share * mass);
    let period = value(Quantity::ImpulsivePeriod).unwrap_or(0.0);
    let shear = mass.and_then(|mass| Some(mass * impulsive(case, method, period)?));
    let base = value(Quantity::BaseShear).filter(|shear| *shear > 0.0);
    Some(Pressed {
        label: method.label.clone(),
        site: method.excitation == Excitation::Site,
        crest,
        from: contact.from,
        pressure: contact.pressure,
        share: contact.share,
        mass,
        shear,
        of_shear: shear.zip(base).map(|(shear, base)| shear / base),
        speed: contact.speed,
        angle: contact.angle,
        impact: contact.impact,
    })
}

/// The action of the site as a procedure takes it; that of engines is the first that the site gives the data of.
fn of_site<'a>(case: &'a Case, procedure: Option<&str>) -> Option<ModalAction<'a>> {
    site_action::of(case, procedure, true)?.1.ok()
}

/// Spectral acceleration at the impulsive period of a method, 0 of a rigid tank [m/s²]; none of the site for a procedure that gives no action to modes.
fn impulsive(case: &Case, method: &Method, period: f64) -> Option<f64> {
    let damping = case.damping.impulsive;
    match method.excitation {
        Excitation::Site => {
            let procedure = Some(method.id.as_str()).filter(|id| !id.starts_with(FE));
            Some((of_site(case, procedure)?.structural)(period, damping))
        }
        Excitation::Record => {
            let record = &case.ground_motion.as_ref()?.horizontal;
            Some(if period > 0.0 { ordinates(record, period, damping).psa } else { record.pga() })
        }
    }
}

/// The modes under a floating roof, with their waves by the spectrum of the site, without one by the record.
fn carried(case: &Case) -> Option<Part> {
    let (plan, half) = (Plan::from(case.tank.shape), case.tank.shape.half_length());
    let damping = case.damping.sloshing;
    let site = of_site(case, None);
    let acceleration = |period: f64| match (&site, &case.ground_motion) {
        (Some(action), _) => (period <= action.longest).then(|| (action.wave)(period, damping)),
        (None, Some(motion)) => Some(ordinates(&motion.horizontal, period, damping).psa),
        (None, None) => None,
    };
    let mode = |n: usize| {
        let found = roof_wave::afloat(case, n)?;
        let loaded = TAU / found.loaded;
        let wave = acceleration(loaded).map(|a| wave_factor(plan, n) * half * a / case.gravity);
        Some(Carried { free: TAU / found.free, loaded, wave })
    };
    let modes = [mode(1)?, mode(2)?];
    let bent = modes[1].wave.filter(|wave| *wave > 0.0).and_then(|wave| roof_wave::bent(case, wave));
    let bent = bent.map(|bent| Bent { curvature: bent.curvature, shortening: bent.shortening });
    Some(floating(case.tank.roof.afloat / case.tank.shape.plan_area(), modes, bent))
}
