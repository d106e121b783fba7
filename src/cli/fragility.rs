//! `tankcheck fragility`: curves of data, and the risk that follows.

use std::path::PathBuf;

use serde_json::{Value, json};

use crate::cli::table::Table;
use crate::cli::{Format, Global, show};
use crate::curves::{Asked, Curve, FORMAT};
use crate::error::{EXIT_NOT_CHECKED, EXIT_OK, Error};
use crate::input::fragility::{self as input, STATE};
use ::fragility::export::{Component, nrml, pelicun};
use files::code::Code;
use files::{text, write_whole};

/// Most resamples.
const MOST: u32 = 100_000;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck fragility --stripes stripes.csv --hazard hazard.csv
  tankcheck fragility --capacities caps.csv --im-max 1.2 --censored 3 --format json
  tankcheck fragility --cloud cloud.csv --limit DS1=1 --limit DS2=1.4 --im \"Sa(0.3 s)\"

Data, CSV with these columns:
  --stripes     im, n, exceed            runs at an intensity, and how many reached the state (Baker 2015)
  --capacities  im                       intensity at which each run reached the state
  --cloud       im, edp [, collapsed]    demand of each run (Cornell et al. 2002)
  --hazard      im, rate                 rate of exceedance a year, on straight lines in double logarithmic axes
Stripes and capacities may have a column damage_state, from mild to severe.

Exit codes: 0 at least one curve was fitted; 2 bad input; 4 the data identify no curve.")]
pub(crate) struct Args {
    #[command(flatten)]
    data: Data,
    /// Intensity at which scaling ended; runs that had not reached the state are counted by --censored.
    #[arg(long, value_name = "IM", requires = "capacities", requires = "censored")]
    im_max: Option<f64>,
    /// Runs that had not reached the state at --im-max.
    #[arg(long, value_name = "N", requires = "im_max")]
    censored: Option<usize>,
    /// Limit of the demand of --cloud, `1.4` or `DS2=1.4`.
    #[arg(long, value_name = "LIMIT", requires = "cloud")]
    limit: Vec<String>,
    /// Hazard curve: CSV with the columns im and rate (a year).
    #[arg(long, value_name = "FILE")]
    hazard: Option<PathBuf>,
    /// Name of the intensity measure.
    #[arg(long, value_name = "NAME", default_value = "im")]
    im: String,
    /// Its unit in the table for pelicun.
    #[arg(long, value_name = "UNIT", default_value = "unitless")]
    im_unit: String,
    /// Resamples for the bands of median and dispersion; 0 for none.
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u32).range(0..=i64::from(MOST)))]
    bootstrap: u32,
    /// Seed of the resamples.
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Write the curves as a component table for pelicun; the file must not exist.
    #[arg(long, value_name = "FILE")]
    pelicun: Option<PathBuf>,
    /// Write the curves for OpenQuake (NRML 0.5); intensities in the unit of the measure there, g for accelerations. The file must not exist.
    #[arg(long, value_name = "FILE")]
    nrml: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

#[derive(clap::Args)]
#[group(required = true, multiple = false)]
struct Data {
    /// Counts at intensities.
    #[arg(long, value_name = "FILE")]
    stripes: Option<PathBuf>,
    /// Intensities at which runs reached the state.
    #[arg(long, value_name = "FILE")]
    capacities: Option<PathBuf>,
    /// Demands against intensities.
    #[arg(long, value_name = "FILE")]
    cloud: Option<PathBuf>,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: &Args, _: &Global) -> Result<u8, Error> {
    for (option, path) in [("--pelicun", &args.pelicun), ("--nrml", &args.nrml)] {
        if let Some(path) = path.as_ref().filter(|path| path.exists()) {
            return Err(Error::input(
                Code::FileTaken,
                format!("{option}: found `{}`, which exists, expected the name of a new file", path.display()),
            ));
        }
    }
    let asked = Asked {
        im: args.im.clone(),
        resamples: args.bootstrap as usize,
        seed: args.seed,
        hazard: args.hazard.as_ref().map(|path| input::hazard(path)).transpose()?,
    };
    let curves = match (&args.data.stripes, &args.data.capacities, &args.data.cloud) {
        (Some(path), _, _) => asked.of_stripes(&input::stripes(path)?),
        (_, Some(path), _) => {
            if let Some(largest) = args.im_max.filter(|im| !(*im > 0.0 && im.is_finite())) {
                let text = format!("--im-max: found {largest}, expected a number greater than 0");
                return Err(Error::value(text));
            }
            let data = input::capacities(path, args.im_max)?;
            if args.im_max.is_some() && data.len() > 1 {
                return Err(Error::conflict(
                    "--censored counts the runs of one state, and the file has several\n  help: give each state a file of its own",
                ));
            }
            asked.of_capacities(&data, args.im_max.zip(args.censored))
        }
        (_, _, Some(path)) => asked.of_cloud(&input::cloud(path)?, &limits(&args.limit)?),
        _ => Vec::new(),
    };
    if let Some(path) = &args.pelicun {
        write_whole(path, pelicun(&components(&curves), &args.im, &args.im_unit).as_bytes())?;
    }
    if let Some(path) = &args.nrml {
        let medians = || curves.iter().filter_map(Curve::curve);
        let range = [
            medians().map(|c| c.quantile(0.01)).fold(f64::INFINITY, f64::min),
            medians().map(|c| c.quantile(0.99)).fold(0.0, f64::max),
        ];
        write_whole(path, nrml(&components(&curves), &args.im, 1.0, range).as_bytes())?;
    }
    show(args.format, || human(&curves), || document(&curves), || Ok(csv(&curves)))?;
    Ok(if curves.iter().any(|c| c.curve().is_some()) { EXIT_OK } else { EXIT_NOT_CHECKED })
}

fn document(curves: &[Curve]) -> Value {
    json!({ "format": FORMAT, "curves": curves })
}

fn components(curves: &[Curve]) -> Vec<Component> {
    let states: Vec<_> = curves.iter().filter_map(|c| Some((c.damage_state.clone(), c.curve()?))).collect();
    if states.is_empty() { Vec::new() } else { vec![Component { id: "tank".into(), states }] }
}

/// Limits of a demand with the names of their states.
fn limits(given: &[String]) -> Result<Vec<(String, f64)>, Error> {
    if given.is_empty() {
        return Err(Error::missing(
            "--cloud needs the limit of the demand\n  help: add --limit 1.0, or --limit DS1=1.0 --limit DS2=1.4",
        ));
    }
    let one = |text: &String| {
        let (name, number) = text.split_once('=').unwrap_or((STATE, text));
        match number.trim().parse::<f64>() {
            Ok(limit) if limit > 0.0 && limit.is_finite() => Ok((name.trim().to_owned(), limit)),
            _ => {
                Err(Error::value(format!("--limit: found `{text}`, expected a number greater than 0, or NAME=number")))
            }
        }
    };
    given.iter().map(one).collect()
}

fn human(curves: &[Curve]) -> String {
    let mut table = Table::new([
        "damage state",
        "median",
        "5 to 95 %",
        "dispersion",
        "5 to 95 %",
        "runs",
        "rate a year",
        "in 50 years",
    ]);
    let shown = |v: Option<f64>| v.map_or("–".into(), |v| format!("{v:.6}"));
    for curve in curves {
        let band = |pick: fn(&::fragility::bootstrap::Scatter) -> ::fragility::bootstrap::Band| {
            curve.scatter.as_ref().map_or("–".into(), |s| {
                let band = pick(s);
                format!("{:.4} to {:.4}", band.low, band.high)
            })
        };
        let risk = curve.risk.as_ref();
        table.row([
            &text::line(&curve.damage_state).into_owned(),
            &shown(curve.median),
            &band(|s| s.median),
            &shown(curve.dispersion),
            &band(|s| s.dispersion),
            &curve.n.to_string(),
            &risk.map_or("–".into(), |r| format!("{:.3e}", r.annual_rate)),
            &risk.map_or("–".into(), |r| format!("{:.3} %", 100.0 * r.probability_50_years)),
        ]);
    }
    let mut said = table.to_string();
    for curve in curves {
        for remark in remarks(curve) {
            said.push_str(&format!("{}: {remark}\n", text::line(&curve.damage_state)));
        }
    }
    said
}

/// What a curve has beside its numbers.
fn remarks(curve: &Curve) -> Vec<String> {
    let mut all = Vec::new();
    if let Some(reason) = &curve.reason {
        let bound = |b: Option<f64>| b.map_or("unknown".into(), |b| b.to_string());
        let bounds = |b: [Option<f64>; 2]| format!("; the median is between {} and {}", bound(b[0]), bound(b[1]));
        all.push(format!("not identifiable: {}{}", text::line(reason), curve.bounds.map_or(String::new(), bounds)));
    }
    if let Some(common) = &curve.common {
        all.push(format!(
            "the curves cross within the data; with one dispersion: median {:.6}, dispersion {:.6}",
            common.median, common.dispersion
        ));
    }
    if let Some(scatter) = curve.scatter.as_ref().filter(|s| s.not_identified > 0) {
        all.push(format!(
            "{} of {} resamples identify no curve; the bands are of the others",
            scatter.not_identified, scatter.resamples
        ));
    }
    if let Some(risk) = curve.risk.as_ref().filter(|r| r.share_beyond_last > 0.05) {
        all.push(format!(
            "{:.0} % of the rate comes from beyond the last point of the hazard curve, which is extrapolated",
            100.0 * risk.share_beyond_last
        ));
    }
    if let Some(cloud) = &curve.cloud {
        all.push(format!(
            "ln edp = {:.4} + {:.4} ln im, scatter {:.4}, R² {:.3}",
            cloud.intercept, cloud.slope, cloud.deviation, cloud.determination
        ));
        if cloud.collapsed > 0 {
            all.push(format!(
                "{} runs collapsed and are not in this curve: the probability of damage is larger",
                cloud.collapsed
            ));
        }
    }
    all
}

fn csv(curves: &[Curve]) -> String {
    let mut said = String::from("damage_state,method,im,median,dispersion,n,status\n");
    let number = |v: Option<f64>| v.map_or(String::new(), |v| v.to_string());
    for curve in curves {
        let status = match curve.curve() {
            Some(_) => "fitted",
            None => "not_identifiable",
        };
        said.push_str(&format!(
            "{},{},{},{},{},{},{status}\n",
            text::cell(&curve.damage_state),
            curve.method,
            text::cell(&curve.im),
            number(curve.median),
            number(curve.dispersion),
            curve.n
        ));
    }
    said
}
