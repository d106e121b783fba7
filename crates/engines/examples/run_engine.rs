//! Runs the harmonic engine: the coupled tank and liquid under a ground motion.
//!
//!     cargo run --release -p engines --example run_engine

use std::error::Error;
use std::f64::consts::PI;

use engines::nonlinear::NonlinearOptions;
use engines::solid::SolidOptions;
use engines::{Options, Task, engine};
use fem::progress::Silent;
use oscillator::record::Record;
use results::EngineId;
use tank::case::GroundMotion;
use tank::reference;
use tank::units::display;

fn main() -> Result<(), Box<dyn Error>> {
    // Water, 1.525 m deep, in the aluminium tank of Manos & Clough (1982), and a sine of 0.1 g and 1 s for 3 s.
    let mut case = reference::broad(1000.0);
    let dt = 0.01;
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "sine".into(),
            dt,
            acceleration: (0..=300).map(|i| 0.981 * (2.0 * PI * dt * f64::from(i)).sin()).collect(),
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    let (linear, solid, nonlinear) = (Options::default(), SolidOptions::default(), NonlinearOptions::new(case.damping));
    let task =
        Task { case: &case, linear: &linear, solid: &solid, nonlinear: &nonlinear, checkpoint: None, without: &[] };
    let engine = engine(EngineId::Harmonic);
    if let Some(refusal) = engine.refuses(&task).first() {
        return Err(refusal.message.clone().into());
    }
    let simulation = engine.run(&task, &Silent)?;
    for (quantity, value) in &simulation.values {
        println!("{:<44} {}", quantity.title(), display(*value, quantity.dimension()));
    }
    for note in &simulation.notes {
        println!("note: {note}");
    }
    Ok(())
}
