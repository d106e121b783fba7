//! One model under many records: what a study shares between its rows.
//!
//! Mesh, condensed liquid and modes depend on the tank alone, and the response of a linear model to a scaled record is the scaled
//! response. A [`Prepared`] model answers a record with a [`Response`], and a response every scale of that record.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use fem::progress::Silent;
use tank::case::{GroundMotion, Site, ZoneSite};
use tank::demand::Demands;
use tank::{Case, Quantity, Shape};

use super::analysis::Extent;
use super::model::Model;
use super::{Linear, complete};
use crate::harmonic::Places;
use crate::modes::Kind;
use crate::{FeError, Simulation};
use results::EngineId;
use tank::demand::Footing;
use tank::options::LinearOptions as Options;
use tank::options::linear::LiquidModel;

/// The harmonic model of a tank with its modes.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Without ground motion and site.
    case: Case,
    options: Options,
    model: Model,
}

/// Any site: without a record it asks for a mesh that follows 20 Hz. The mesh is then the same for all records, and no row of a study
/// depends on those that share its model.
const MESH_FOR: Site = Site {
    ec8: None,
    api650: None,
    spectrum: None,
    zone: Some(ZoneSite { zone_factor: 0.4, soil_factor: 1.0, importance: 1.0 }),
    is1893: None,
    national: None,
};

/// Why a study has no nonlinear liquid.
const NO_NONLINEAR: &str = "`analysis.liquid`: a study scales the linear response to a record, and a nonlinear liquid does not scale; remove it, or use compare";

impl Prepared {
    /// Builds the model of a case; its ground motion and its site are not used.
    ///
    /// * `vertical`: whether the records have a vertical component
    ///
    /// Errors: an option out of range, a nonlinear liquid; a model that cannot be built or factored.
    pub fn new(case: &Case, options: &Options, vertical: bool) -> Result<Prepared, FeError> {
        if options.liquid == LiquidModel::Nonlinear {
            return Err(FeError::Unsupported(NO_NONLINEAR.into()));
        }
        let meshed = Case { ground_motion: None, site: MESH_FOR, ..case.clone() };
        let options =
            Options { mesh_error: false, snapshots: Vec::new(), tilt: None, frequency: None, ..options.clone() };
        let model = Model::new(&meshed, &options, vertical, Places::Usual)?;
        let case = Case { site: Site::default(), ..meshed };
        Ok(Prepared { case, options, model })
    }

    /// First impulsive and sloshing period [s], on a fixed base.
    pub fn periods(&self) -> [Option<f64>; 2] {
        let held = self.model.held();
        let impulsive = held.impulsive().map(|found| found.period());
        let sloshing = held.first(Kind::Sloshing).map(|mode| TAU / mode.omega);
        [impulsive, sloshing]
    }

    /// The response to a record.
    ///
    /// Errors: an invalid record; a vertical record of a model without it; a response that is not finite.
    pub fn run(&self, motion: &GroundMotion) -> Result<Response, FeError> {
        if motion.vertical.is_some() && self.model.vertical.is_none() {
            return Err(FeError::Unsupported("a vertical record of a model that was prepared without one".into()));
        }
        let round = matches!(self.case.tank.shape, Shape::Cylinder { .. });
        if motion.transverse.is_some() && !round {
            return Err(FeError::Unsupported("the harmonic engine has no walls along y of a rectangular tank".into()));
        }
        let case = Case { ground_motion: Some(motion.clone()), ..self.case.clone() };
        let linear = Linear {
            engine: EngineId::Harmonic,
            model: &self.model,
            direct: None,
            across: None,
            states: None,
            extent: Extent::Values,
            known: None,
        };
        let simulation = complete(&case, &self.options, &linear, &Silent)?;
        Ok(Response::of(simulation))
    }
}

/// What a study needs of the response of a model to a record.
#[derive(Clone, Debug)]
pub struct Response {
    /// Comparable values, SI.
    pub values: BTreeMap<Quantity, f64>,
    /// What limit states compare with capacities; none of an engine or a tank that does not give it.
    pub demands: Option<Demands>,
    /// Whether the wall's own response is linear: not on isolators.
    linear: bool,
}

impl Response {
    /// That of a finished run.
    pub fn of(simulation: Simulation) -> Response {
        let result = &simulation.result;
        let linear = result.engine != EngineId::Nonlinear
            && result.base.is_none()
            && result.part("isolation").is_none()
            && result.part("large_wave").is_none()
            && !result.incomplete;
        Response { linear, values: simulation.values, demands: simulation.demands }
    }

    /// Whether the response to the record times a positive factor is this one times the factor: that of a base that rests only as long as it may not
    /// lift, that of a base that moves never.
    pub fn scales(&self, factor: f64) -> bool {
        let rests = self.demands.as_ref().is_none_or(|demands| match demands.footing {
            Footing::Fixed => true,
            Footing::Rests => factor <= 1.0,
            Footing::Moves | Footing::Beyond { .. } => false,
        });
        self.linear && rests
    }

    /// The values of a linear response to the record times a positive factor. The static state stays as it is.
    pub fn values_under(&self, factor: f64) -> BTreeMap<Quantity, f64> {
        let value = |(&quantity, &value): (&Quantity, &f64)| {
            let scaled = if quantity.is_response() { value * factor } else { value };
            (quantity, scaled)
        };
        self.values.iter().map(value).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::test_tanks;
    use oscillator::record::Record;

    fn motion(factor: f64) -> GroundMotion {
        let acceleration = |k: i32| factor * (0.9 * (0.11 * f64::from(k)).sin() + 0.4 * (0.43 * f64::from(k)).cos());
        GroundMotion {
            horizontal: Record {
                name: "two tones".into(),
                dt: 0.02,
                acceleration: (0..600).map(acceleration).collect(),
                processing: Vec::new(),
            },
            transverse: None,
            vertical: None,
        }
    }

    /// An unanchored tank that rests may lift under a stronger motion: its response scales downwards alone. One that overturns has none.
    #[test]
    fn a_base_that_rests_does_not_scale_upwards() {
        let mut case = test_tanks::broad();
        case.tank.support = tank::Support::Unanchored;
        case.tank.bottom = Some(tank::Bottom {
            thickness: 0.001,
            corrosion: 0.0,
            width: None,
            sketch: None,
            projection: 0.0,
            subgrade_modulus: Some(1e8),
            material: case.tank.courses[0].material.clone(),
        });
        let options = Options { mesh_error: false, ..Options::default() };
        let prepared = Prepared::new(&case, &options, false).unwrap();
        let run = |factor: f64| prepared.run(&motion(factor)).unwrap();
        let rests = run(0.01);
        assert_eq!(rests.demands.as_ref().unwrap().footing, Footing::Rests);
        assert!(rests.scales(0.5) && !rests.scales(1.5));
        let overturns = run(200.0);
        let Footing::Beyond { time: Some(_), .. } = overturns.demands.as_ref().unwrap().footing else {
            panic!("{:?}", overturns.demands.unwrap().footing)
        };
        assert!(!overturns.scales(0.5));
    }

    /// A nonlinear liquid is refused, not left out.
    #[test]
    fn a_nonlinear_liquid_does_not_scale() {
        let options = Options { liquid: LiquidModel::Nonlinear, mesh_error: false, ..Options::default() };
        let error = Prepared::new(&test_tanks::broad(), &options, false).unwrap_err();
        assert!(error.to_string().contains("analysis.liquid"), "{error}");
    }

    /// Against the same model under the scaled record, to the order of the sums; and against a run of the engine, whose mesh follows the
    /// record and not 20 Hz: 1 % is what an engineer takes for the same number.
    #[test]
    fn a_scaled_response_is_that_to_the_scaled_record() {
        let mut case = test_tanks::broad();
        let options = Options { mesh_error: false, ..Options::default() };
        let prepared = Prepared::new(&case, &options, false).unwrap();
        let unit = prepared.run(&motion(1.0)).unwrap();
        for factor in [0.3, 2.5] {
            let scaled = unit.values_under(factor);
            let same = prepared.run(&motion(factor)).unwrap();
            case.ground_motion = Some(motion(factor));
            let other = Response::of(crate::simulate(&case, &options).unwrap());
            for (quantity, value) in &same.values {
                let found = scaled[quantity];
                assert!((found / value - 1.0).abs() < 1e-9, "{quantity:?}: {found} {value}");
                let value = other.values[quantity];
                assert!((found / value - 1.0).abs() < 1e-2, "{quantity:?}: {found} {value}");
            }
            let (found, wanted) = (unit.demands.clone().unwrap(), same.demands.unwrap());
            let middle = wanted.places.len() / 2;
            let (a, b) = (&found.places[middle].hoop, &wanted.places[middle].hoop);
            assert!((a.rest / b.rest - 1.0).abs() < 1e-12);
            let (a, b) = (found.history(&a.odd), wanted.history(&b.odd));
            let peak = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            assert!(a.iter().zip(&b).all(|(a, b)| (factor * a - b).abs() < 1e-9 * peak));
        }
    }
}
