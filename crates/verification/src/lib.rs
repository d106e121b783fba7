//! Verification: models with known solutions, and the manual made of their rows.
//!
//! A benchmark is a file: its module documentation, a constant `BENCHMARK` (id and title of its page, model, meaning of its
//! ids, parts) and the functions that compute its rows; [`ALL`] lists them. A row compares a computed value with a reference
//! that was not made by this program, and names the kind of the reference; a row that only repeats earlier output is a
//! [`Reference::Regression`] and does not verify.
//!
//! ```text
//! Benchmark ─ Part ─ Row ─ Entry ─ rows.json ─ pages (Markdown + SVG), HTML, table
//! ```
//!
//! [`run`] computes the rows of a [`Choice`] of benchmarks; the pages are a function of `rows.json` and [`ALL`] alone
//! ([`manual`]). The tests of this crate run every fast and tested part once, a test each.

#![warn(unreachable_pub)]

mod base;
mod benchmark;
pub mod dissertation;
mod dynamics;
pub mod elements;
mod entry;
mod error;
mod experiments;
mod fluid;
pub mod html;
pub mod manual;
mod materials;
pub mod moreau;
pub mod potential;
pub mod records;
mod row;
mod run;
mod shell;
mod soil;
mod solid;
pub mod strip;
pub mod tanks;

pub use benchmark::{Benchmark, Part};
pub use entry::{Entry, Pace};
pub use error::{Answer, Error, Failure};
pub use records::Records;
pub use row::{Reference, Row};
pub use run::{Choice, Manual, NotRun, Pattern, find, nearest, run};

/// All benchmarks, in the order of the manual.
pub const ALL: &[&Benchmark] = &[
    &tanks::rigid_sloshing::BENCHMARK,
    &tanks::rigid_strip::BENCHMARK,
    &tanks::rigid_masses::BENCHMARK,
    &tanks::coupled_modes::BENCHMARK,
    &tanks::solid_against_harmonic::BENCHMARK,
    &tanks::solid_box::BENCHMARK,
    &tanks::imperfect_wall::BENCHMARK,
    &tanks::mesh_error::BENCHMARK,
    &tanks::tilt::BENCHMARK,
    &tanks::transfer::BENCHMARK,
    &tanks::turning::BENCHMARK,
    &tanks::wall_modes::BENCHMARK,
    &tanks::mode_damping::BENCHMARK,
    &tanks::internal_forces::BENCHMARK,
    &tanks::rings::BENCHMARK,
    &base::strip::BENCHMARK,
    &base::shells::BENCHMARK,
    &base::rims::BENCHMARK,
    &base::sector::BENCHMARK,
    &base::joint::BENCHMARK,
    &base::round::BENCHMARK,
    &base::rocking::BENCHMARK,
    &base::history::BENCHMARK,
    &base::drag::BENCHMARK,
    &base::sliding::BENCHMARK,
    &base::anchors::BENCHMARK,
    &base::loops::BENCHMARK,
    &tanks::datasheet::BENCHMARK,
    &tanks::two_masses::BENCHMARK,
    &soil::impedances::BENCHMARK,
    &soil::structure::BENCHMARK,
    &soil::engine::BENCHMARK,
    &soil::isolation::BENCHMARK,
    &soil::isolated_tanks::BENCHMARK,
    &shell::element::BENCHMARK,
    &shell::patch::BENCHMARK,
    &shell::scordelis_lo::BENCHMARK,
    &shell::pinched_cylinder::BENCHMARK,
    &shell::hemisphere::BENCHMARK,
    &shell::twisted_beam::BENCHMARK,
    &shell::cook::BENCHMARK,
    &shell::z_cantilever::BENCHMARK,
    &shell::square_frame::BENCHMARK,
    &shell::cantilever_plate::BENCHMARK,
    &shell::tank_static::BENCHMARK,
    &shell::tank_sectors::BENCHMARK,
    &shell::volume_change::BENCHMARK,
    &shell::axial_buckling::BENCHMARK,
    &shell::cylinder_modes::BENCHMARK,
    &materials::steel::BENCHMARK,
    &materials::concrete::BENCHMARK,
    &materials::bond::BENCHMARK,
    &materials::solid_concrete::BENCHMARK,
    &solid::cantilever::BENCHMARK,
    &solid::joint::BENCHMARK,
    &solid::wall::BENCHMARK,
    &solid::macro_wall::BENCHMARK,
    &solid::elastica::BENCHMARK,
    &potential::BENCHMARK,
    &fluid::rank::BENCHMARK,
    &fluid::patch::BENCHMARK,
    &fluid::weight::BENCHMARK,
    &fluid::rectangle::BENCHMARK,
    &fluid::cylinder::BENCHMARK,
    &fluid::disc::BENCHMARK,
    &fluid::sloshing_box::BENCHMARK,
    &fluid::impulsive::BENCHMARK,
    &fluid::large_wave::BENCHMARK,
    &experiments::BENCHMARK,
    &dynamics::time_integration::BENCHMARK,
    &dynamics::rayleigh_damping::BENCHMARK,
    &dynamics::dashpots::BENCHMARK,
    &dynamics::response_spectrum_method::BENCHMARK,
    &dynamics::condensed_liquid::BENCHMARK,
    &dynamics::missing_mass::BENCHMARK,
    &dynamics::energy_balance::BENCHMARK,
    &dynamics::four_methods::BENCHMARK,
    &strip::at_rest::BENCHMARK,
    &strip::section::BENCHMARK,
    &strip::chain::BENCHMARK,
    &strip::shells::BENCHMARK,
    &shell::tank_locking::BENCHMARK,
    &shell::tank_grading::BENCHMARK,
    &shell::cantilever::BENCHMARK,
    &shell::roll_up::BENCHMARK,
    &shell::slit_ring::BENCHMARK,
    &shell::hemisphere_large::BENCHMARK,
    &shell::pull_out::BENCHMARK,
    &shell::hinged_roof::BENCHMARK,
    &shell::follower_pressure::BENCHMARK,
    &shell::plastic_plates::BENCHMARK,
    &shell::pressurized_buckling::BENCHMARK,
    &shell::elephant_foot::BENCHMARK,
    &shell::pinched_large::BENCHMARK,
    &shell::concrete_beams::BENCHMARK,
    &shell::concrete_patch::BENCHMARK,
    &dynamics::nonlinear::BENCHMARK,
    &tanks::responses::BENCHMARK,
    &dynamics::separation::BENCHMARK,
    &strip::linear_response::BENCHMARK,
    &strip::incremental::BENCHMARK,
    &dissertation::BENCHMARK,
];

/// El Centro NS scaled to 0.348 g: the version of the dissertation from the folder `TANKCHECK_RECORDS`, if set, else the textbook
/// version that comes with the examples.
#[cfg(test)]
pub(crate) fn test_record() -> oscillator::record::Record {
    let path = match std::env::var("TANKCHECK_RECORDS") {
        Ok(folder) => format!("{folder}/imperial-valley-1940-el-centro-ns.csv"),
        Err(_) => concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/records/elcentro.csv").to_owned(),
    };
    let text = std::fs::read_to_string(path).unwrap();
    let pairs: Vec<[f64; 2]> = text
        .lines()
        .filter_map(|line| {
            let mut numbers = line.split(',').map(|c| c.trim().parse::<f64>());
            match (numbers.next(), numbers.next()) {
                (Some(Ok(t)), Some(Ok(a))) => Some([t, a]),
                _ => None,
            }
        })
        .collect();
    let peak = pairs.iter().fold(0.0, |m: f64, p| m.max(p[1].abs()));
    oscillator::record::Record {
        name: "El Centro".into(),
        dt: pairs[1][0] - pairs[0][0],
        acceleration: pairs.iter().map(|p| p[1] / peak * 0.348 * 9.81).collect(),
        processing: Vec::new(),
    }
}
