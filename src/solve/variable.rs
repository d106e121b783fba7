//! The variables of `check --solve`: where each stands in the case, and the values that are tried.

use files::code::Code;
use tank::hazard::SpectrumForm;
use tank::units::Dimension;
use tank::{Case, STANDARD_GRAVITY, Shape};

use crate::error::Error;

/// Number of intervals between the samples.
const INTERVALS: u32 = 24;
/// Smallest fill height that is tried, as a share of the largest.
const LOWEST_FILL: f64 = 0.01;
/// Mapped and ground accelerations that are tried [g]; the upper ends are those of the input.
const LOWEST_ACCELERATION: f64 = 1e-3;
/// Upper end of a_gR [g].
const HIGHEST_AG: f64 = 3.0;
/// Upper end of S_s [g].
const HIGHEST_SS: f64 = 5.0;
/// Thinnest wall of a tank: R (or half the length) by this.
const THINNEST: f64 = 20_000.0;
/// Thickest wall of a cylinder that is tried: R by this. The input allows more, but a single course of such weight fails by its
/// inertia.
const THICKEST_CYLINDER: f64 = 50.0;
/// Thickest wall of a rectangle that is tried: half the length by this.
const THICKEST_RECTANGLE: f64 = 2.0;
/// The given thickness by which the range is extended.
const TIMES_GIVEN: f64 = 2.0;

/// The unknown of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// Largest `liquid.fill_height` [m].
    FillHeight,
    /// Smallest thickness of a course [m], counted from 1 at the base.
    Thickness(usize),
    /// Largest `site.ec8.ag` [m/s²].
    Ag,
    /// Largest `site.api650.ss` [g].
    Ss,
}

impl Variable {
    /// The variable of this name.
    ///
    /// Errors: an unknown name; a course without a number.
    pub fn parse(name: &str) -> Result<Variable, Error> {
        match (name, name.strip_prefix("thickness:").map(str::parse)) {
            ("fill_height", _) => Ok(Variable::FillHeight),
            ("ag", _) => Ok(Variable::Ag),
            ("ss", _) => Ok(Variable::Ss),
            (_, Some(Ok(course))) => Ok(Variable::Thickness(course)),
            _ => Err(Error::value(format!(
                "--solve: found `{name}`, expected fill_height, thickness:N, ag or ss\n  help: N counts the courses from 1 \
                 at the base, as in thickness:1"
            ))),
        }
    }

    /// Its name on the command line ("thickness:1").
    pub fn name(self) -> String {
        match self {
            Variable::FillHeight => "fill_height".into(),
            Variable::Thickness(course) => format!("thickness:{course}"),
            Variable::Ag => "ag".into(),
            Variable::Ss => "ss".into(),
        }
    }

    /// Symbol of its unit ("m", "m/s2", "g").
    pub fn unit(self) -> &'static str {
        match self {
            Variable::FillHeight | Variable::Thickness(_) => Dimension::Length.si_symbol(),
            Variable::Ag => Dimension::Acceleration.si_symbol(),
            Variable::Ss => "g",
        }
    }

    /// Whether the largest value is sought; of a thickness it is the smallest.
    pub fn largest(self) -> bool {
        !matches!(self, Variable::Thickness(_))
    }

    /// Its value in a case.
    ///
    /// Errors: a course that does not exist or has layers; a site without the code.
    pub fn given(self, case: &Case) -> Result<f64, Error> {
        let without = |key: &str| {
            let name = self.name();
            Error::missing(format!(
                "--solve {name}: the tank file does not have {key}\n  help: add {key}, or solve for another variable"
            ))
        };
        let own = case.site.spectrum.as_ref().map(|own| &own.form);
        match (self, own) {
            (Variable::Ag, Some(SpectrumForm::Parameters(own))) => return Ok(own.ag),
            (Variable::Ag | Variable::Ss, Some(_)) => {
                let name = self.name();
                return Err(Error::conflict(format!(
                    "--solve {name}: `site.spectrum` gives the hazard, so {name} does not scale it\n  help: remove \
                     `site.spectrum`, or solve for another variable"
                )));
            }
            _ => {}
        }
        match self {
            Variable::FillHeight => Ok(case.liquid.fill_height),
            Variable::Ag => case.site.ec8.map(|s| s.ag).ok_or_else(|| without("site.ec8")),
            Variable::Ss => case.site.api650.map(|s| s.ss).ok_or_else(|| without("site.api650")),
            Variable::Thickness(number) => {
                let courses = &case.tank.courses;
                let Some(course) = number.checked_sub(1).and_then(|i| courses.get(i)) else {
                    return Err(Error::value(format!(
                        "--solve thickness:{number}: found course {number}, expected 1 to {} (from the base up)\n  help: \
                         name a course of tank.courses",
                        courses.len()
                    )));
                };
                if !course.layers.is_empty() {
                    return Err(Error::input(
                        Code::Unsupported,
                        format!(
                            "--solve thickness:{number}: course {number} has layers or bars, expected one thickness\n  help: solve for \
                         a course of one material"
                        ),
                    ));
                }
                Ok(course.thickness)
            }
        }
    }

    /// The same case with another value; unchanged where the variable does not exist.
    pub fn set(self, case: &mut Case, value: f64) {
        match self {
            Variable::FillHeight => case.liquid.fill_height = value,
            Variable::Ag => {
                case.site.ec8.iter_mut().for_each(|s| s.ag = value);
                let own = case.site.spectrum.as_mut().map(|own| &mut own.form);
                if let Some(SpectrumForm::Parameters(own)) = own {
                    own.ag = value;
                }
            }
            Variable::Ss => case.site.api650.iter_mut().for_each(|s| s.ss = value),
            Variable::Thickness(number) => {
                if let Some(index) = number.checked_sub(1) {
                    case.tank.thicken(index, value);
                }
            }
        }
    }

    /// The range that is searched, within the limits of the input; the favourable end first.
    pub fn range(self, case: &Case) -> (f64, f64) {
        match self {
            Variable::FillHeight => {
                let top = case.tank.wall_height().min(case.tank.roof_height());
                (LOWEST_FILL * top, top)
            }
            Variable::Ag => (LOWEST_ACCELERATION * STANDARD_GRAVITY, HIGHEST_AG * STANDARD_GRAVITY),
            Variable::Ss => (LOWEST_ACCELERATION, HIGHEST_SS),
            Variable::Thickness(_) => {
                let half = case.tank.shape.half_length();
                let thickest = match case.tank.shape {
                    Shape::Cylinder { .. } => half / THICKEST_CYLINDER,
                    Shape::Rectangle { .. } => half / THICKEST_RECTANGLE,
                };
                let given = self.given(case).unwrap_or(0.0);
                // The corrosion allowance stays as it is.
                (thickest.max(TIMES_GIVEN * given), half / THINNEST + self.corrosion(case))
            }
        }
    }

    /// What corrosion takes from the thickness that is sought [m].
    fn corrosion(self, case: &Case) -> f64 {
        match self {
            Variable::Thickness(number) => {
                let course = number.checked_sub(1).and_then(|i| case.tank.courses.get(i));
                course.map_or(0.0, |course| course.corrosion)
            }
            _ => 0.0,
        }
    }

    /// The values that are tried first, from the favourable end: the range in 24 equal steps (of a fill height) or ratios (of all
    /// others), and the given value between them.
    pub fn samples(self, case: &Case, given: f64) -> Vec<f64> {
        let (from, to) = self.range(case);
        let mut samples: Vec<f64> = (0..=INTERVALS)
            .map(|i| {
                let share = f64::from(i) / f64::from(INTERVALS);
                match (i, self) {
                    (0, _) => from,
                    (INTERVALS, _) => to,
                    (_, Variable::FillHeight) => from + (to - from) * share,
                    _ => from * (to / from).powf(share),
                }
            })
            .collect();
        let inside = given > from.min(to) && given < from.max(to);
        if inside && samples.iter().all(|s| (s - given).abs() > 1e-9 * given) {
            samples.push(given);
        }
        samples.sort_by(f64::total_cmp);
        if from > to {
            samples.reverse();
        }
        samples
    }
}
