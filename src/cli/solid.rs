//! Arguments of the three-dimensional engine, shared by `compare` and `modes`.

use codes::Case;

use crate::cli::Global;
use crate::cli::progress::span;
use crate::error::Error;
use crate::fe;
use crate::fe::solid::{Estimate, Liquid, MeshSize, SolidOptions};
use crate::job::Job;
use crate::results::InputValue;

/// How the three-dimensional engine meshes and what it may take.
#[derive(clap::Args, Clone, Debug)]
pub struct SolidArgs {
    /// Elements over radius, circumference and height of the wall, as 12x16x20 [default: by the size of the tank].
    #[arg(long, value_name = "RxSxV", allow_hyphen_values = true)]
    mesh: Option<MeshSize>,
    /// Formulation of the liquid [default: potential, or as in the tank file].
    #[arg(long, value_enum)]
    liquid: Option<LiquidArg>,
    /// Most memory for matrices and factors; a larger model is refused before the run [default: 4096].
    #[arg(long, value_name = "MIB", value_parser = clap::value_parser!(u64).range(1..=16_777_216))]
    memory_limit: Option<u64>,
}

/// Formulation of the liquid.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum LiquidArg {
    /// Displacement potential on hexahedra.
    Potential,
    /// Displacements in convective coordinates with a rotation penalty.
    Displacement,
}

impl SolidArgs {
    /// The first of these options that was given.
    pub fn given(&self) -> Option<&'static str> {
        let mesh = self.mesh.map(|_| "--mesh");
        mesh.or(self.liquid.map(|_| "--liquid"))
            .or(self.memory_limit.map(|_| "--memory-limit"))
    }

    /// Lays these options over those of the tank file.
    pub fn over(&self, options: &SolidOptions) -> SolidOptions {
        let mut options = options.clone();
        options.mesh = self.mesh.or(options.mesh);
        match self.liquid {
            Some(LiquidArg::Potential) => options.liquid = Liquid::Potential,
            Some(LiquidArg::Displacement) => options.liquid = Liquid::Displacement,
            None => {}
        }
        options.memory_limit_mib = self.memory_limit.unwrap_or(options.memory_limit_mib);
        options
    }

    /// Lays these options over the job's and echoes what the engine will work with.
    pub fn apply(&self, job: &mut Job) {
        job.solid = self.over(&job.solid);
        let liquid = match job.solid.liquid {
            Liquid::Potential => "potential",
            Liquid::Displacement => "displacement",
        };
        let lines = [
            (
                "mesh",
                self.mesh.map(|m| m.to_string()),
                None,
                "by the size of the tank",
            ),
            (
                "liquid",
                self.liquid.map(|_| liquid.to_owned()),
                Some(liquid.to_owned()),
                "nothing to calibrate",
            ),
        ];
        for (key, given, default, source) in lines {
            let path = format!("analysis.solid.{key}");
            job.echo.retain(|e| e.path != path || given.is_none());
            if job.echo.iter().any(|e| e.path == path) {
                continue;
            }
            job.echo.push(InputValue {
                default: given.is_none(),
                text: given.clone().or(default).unwrap_or_else(|| "not given".into()),
                source: if given.is_some() {
                    format!("--{key}")
                } else {
                    source.into()
                },
                path,
            });
        }
    }
}

/// Says what the run will take; refuses what memory does not hold.
pub fn announce(case: &Case, options: &fe::Options, solid: &SolidOptions, global: &Global) -> Result<(), Error> {
    let estimate = fe::solid::estimate(case, options, solid)?;
    if !global.quiet {
        let direct = match options.integrator {
            fe::Integrator::Newmark => ", the direct integration on top of it (minutes on fine meshes)",
            fe::Integrator::Modal => "",
        };
        anstream::eprintln!("{}{direct}", sentence(&estimate));
    }
    Ok(())
}

/// "three-dimensional run: 12x16x20 elements, 11520 unknowns, about 180 MiB, about 20 s".
fn sentence(estimate: &Estimate) -> String {
    let time = span(estimate.seconds);
    format!(
        "three-dimensional run: {} elements, {} unknowns, about {} MiB, about {time}",
        estimate.mesh, estimate.unknowns, estimate.memory_mib
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_run_is_announced_in_units_a_person_waits_in() {
        let mut estimate = Estimate {
            mesh: MeshSize {
                radial: 12,
                sectors: 16,
                vertical: 20,
            },
            unknowns: 11520,
            memory_mib: 180,
            seconds: 0.2,
        };
        assert!(sentence(&estimate).ends_with("12x16x20 elements, 11520 unknowns, about 180 MiB, about 1 s"));
        estimate.seconds = 300.0;
        assert!(sentence(&estimate).ends_with("about 5 min"));
        estimate.seconds = 9000.0;
        assert!(sentence(&estimate).ends_with("about 2.5 h"));
    }
}
