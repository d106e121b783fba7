//! Parts of the moment at the base of strip 8.4, and the validity limits of a run: `strip_moments RECORD.csv [name=value …]`.
//!
//! The record is a table of time and acceleration at 0.02 s, times `scale` [m/s² a unit of the table]. Names: `gf` (fracture energy
//! [N/m], 0 brittle), `as` (bars of a face [m²/m]), `elements`, `step` [s], `until` [s], `radius` (ρ_∞), `damping` (0
//! mass-proportional, 1 by group), `ratio`, `opening` (1: the liquid may part). Table of section 9 of `docs/theory/strip.md`.

use std::error::Error;
use std::sync::Arc;

use engines::strip::liquid::StripLiquid;
use engines::strip::{Contact, Scalar, Side, StripDamping, StripModel, StripQuake, StripTank, levels};
use fem::analysis::damping::Rayleigh;
use fem::analysis::newton;
use fem::analysis::scheme::TimeScheme;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::Options;
use fem::progress::Silent;
use materials::bar::Bar;
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};
use oscillator::record::Record;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let get = |name: &str, default: f64| -> f64 {
        let found = arguments.iter().find_map(|o| o.strip_prefix(name)?.strip_prefix('=')?.parse().ok());
        found.unwrap_or(default)
    };
    let text = std::fs::read_to_string(arguments.first().ok_or("no record given")?)?;
    let scale = get("scale", 9.80665);
    let value = |line: &str| line.split(',').nth(1).unwrap_or("").trim().parse::<f64>();
    let acceleration: Result<Vec<f64>, _> = text.lines().skip(1).map(|l| value(l).map(|a| a * scale)).collect();
    let record = Record { name: "record".into(), dt: 0.02, acceleration: acceleration?, processing: Vec::new() };
    let (elements, fracture_energy) = (get("elements", 40.0), get("gf", 0.0));
    let softening = match fracture_energy > 0.0 {
        true => Softening::Energy { fracture_energy, size: 3.0 / elements },
        false => Softening::Brittle,
    };
    let tension = Tension { strength: 3.5e6, softening, stiffening: None, bond: None };
    let concrete = UniaxialConcrete::new(3.4e10 / 0.96, Compression::Plastic { strength: 35e6 }, Some(tension))?;
    let area = get("as", 7e-4);
    let section = FibreSection::new(2540.0 * 0.3)?
        .with_attached_mass(123.0)?
        .rectangle(Arc::new(concrete), [1.0, 0.3], 0.0, 20)?
        .bars(Arc::new(Bar::new(2.1e11, 5e8, 2.1e9)?), &[[-0.115, area], [0.115, area]])?;
    let wet = (2.57 / 3.0 * elements).round() as usize;
    let dry = (elements as usize - wet).max(1);
    let opening = get("opening", 0.0) > 0.0;
    let tank = StripTank {
        levels: levels([2.57, 3.0], [wet, dry], 1.0)?,
        sections: std::iter::repeat_n(Arc::new(section), wet + dry).collect(),
        shells: None,
        carried: Vec::new(),
        options: Options::default(),
        base_spring: None,
        liquid: StripLiquid::new(2.5, 2.57, 1019.4),
        sloshing: 12,
        contact: if opening { Contact::Joined { opens: true, penalty: None } } else { Contact::Bonded },
        mesh: None,
    };
    let damping = match get("damping", 0.0) > 0.0 {
        true => StripDamping::ByGroup { wall: get("ratio", 0.05), sloshing: 0.005 },
        false => StripDamping::Rayleigh(Rayleigh::mass_proportional(2.39, get("ratio", 0.022))),
    };
    let strip = StripModel::new(&tank, damping)?;
    let mut quake = StripQuake::new(record, get("step", 2.5e-3));
    quake.until = Some(get("until", 8.0));
    quake.scheme = TimeScheme::GeneralizedAlpha { radius: get("radius", 0.9) };
    if opening {
        quake.newton = newton::Options::for_contact();
    }
    for side in Side::BOTH {
        let run = strip.single(&quake, side, &Silent)?;
        let history = &run.history;
        let most = |scalar| -> f64 { history.scalar(scalar).iter().fold(0.0, |most, x: &f64| most.max(x.abs())) };
        let bars = history.cells.iter().map(|c| c.bar_stress).fold(0.0, f64::max);
        println!(
            "{side:?}: to {:.3} s, {} halvings, top {:.1} mm, bars {:.0} MPa, acceleration {:.0} m/s², reaction {:.2}, section {:.2} kNm/m",
            run.run.time,
            run.run.cuts,
            1e3 * most(Scalar::Deflection),
            1e-6 * bars,
            most(Scalar::Acceleration),
            1e-3 * most(Scalar::Moment),
            1e-3 * most(Scalar::SectionMoment),
        );
        println!("    {:?}", history.peak);
        for departure in &history.departures {
            println!("    {departure:?}");
        }
        println!("    {:?}", run.lost);
    }
    Ok(())
}
