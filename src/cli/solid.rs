//! Arguments of the three-dimensional engine, shared by `compare` and `modes`.

use crate::input::tank::solid_defaults;
use crate::job::Job;
use engines::solid::{Liquid, MeshSize, SolidOptions};
use results::{EngineId, InputValue};
use tank::options::nonlinear::LiquidForm;

/// Options of the three-dimensional engine.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct SolidArgs {
    /// Elements over radius, circumference and height of the wall, as 12x16x20; of a box over half its length, its breadth and the height
    /// [default: by the size of the tank].
    #[arg(long, value_name = "RxSxV", allow_hyphen_values = true)]
    mesh: Option<MeshSize>,
    /// Liquid: of the three-dimensional engine potential or displacement [default: potential, or as in the tank file]; of a strip with
    /// --fe nonlinear displacement [default: condensed, or as in the tank file]; of the default engine
    /// nonlinear [default: linear, or as in the tank file]. A nonlinear run stands beside linear waves that are not small in any case.
    #[arg(long, value_enum)]
    liquid: Option<LiquidArg>,
}

/// Formulation of the liquid.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LiquidArg {
    /// Displacement potential on hexahedra.
    Potential,
    /// Displacements in convective coordinates with a rotation penalty.
    Displacement,
    /// Potential flow of third order in the wave, its base shear and moments, by the default engine.
    Nonlinear,
}

impl SolidArgs {
    /// The first of these options that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let mesh = self.mesh.map(|_| "--mesh");
        mesh.or(self.of_solid().map(|_| "--liquid"))
    }

    /// Whether the liquid of the default engine is nonlinear.
    pub(crate) fn is_nonlinear(&self) -> bool {
        self.liquid == Some(LiquidArg::Nonlinear)
    }

    /// The formulation, where it is one of the three-dimensional engine.
    fn of_solid(&self) -> Option<LiquidArg> {
        self.liquid.filter(|liquid| *liquid != LiquidArg::Nonlinear)
    }

    /// Applies these options over those of the tank file.
    pub(crate) fn over(&self, options: &SolidOptions) -> SolidOptions {
        let mut options = options.clone();
        options.mesh = self.mesh.or(options.mesh);
        match self.liquid {
            Some(LiquidArg::Potential) => options.liquid = Liquid::Potential,
            Some(LiquidArg::Displacement) => options.liquid = Liquid::Displacement,
            Some(LiquidArg::Nonlinear) | None => {}
        }
        options
    }

    /// Applies a displacement liquid to the nonlinear engine, if it runs, with its echo; whether it did.
    pub(crate) fn apply_to_strip(&self, job: &mut Job) -> bool {
        let chain = self.liquid == Some(LiquidArg::Displacement) && job.engines.contains(&EngineId::Nonlinear);
        if chain {
            job.nonlinear.liquid = LiquidForm::Displacement;
            let path = "analysis.nonlinear.liquid";
            job.echo.retain(|e| e.path != path);
            job.echo.push(InputValue {
                path: path.into(),
                text: "displacement".into(),
                default: false,
                source: "--liquid".into(),
            });
        }
        chain
    }

    /// Applies these options to the job and echoes the resulting values.
    pub(crate) fn apply(&self, job: &mut Job) {
        job.solid = self.over(&job.solid);
        let liquid = match job.solid.liquid {
            Liquid::Potential => "potential",
            Liquid::Displacement => "displacement",
        };
        let given = [self.mesh.map(|m| m.to_string()), self.of_solid().map(|_| liquid.to_owned())];
        for (mut line, given) in solid_defaults().into_iter().zip(given) {
            let in_file = job.echo.iter().any(|e| e.path == line.path);
            match given {
                Some(text) => {
                    job.echo.retain(|e| e.path != line.path);
                    let key = line.path.rsplit('.').next().unwrap_or_default();
                    line.source = format!("--{key}");
                    line.text = text;
                    line.default = false;
                }
                None if in_file => continue,
                None => {}
            }
            job.echo.push(line);
        }
    }
}
