//! The section on the nonlinear run: figures, collapse, a run that leaves its model, missing parts.

use report::build;
use report::template::Templates;
use results::EngineId;
use results::compare::Incomplete;
use results::nonlinear::{BaseMoment, Columns, Departure, DepartureKind, End, Energies, Nonlinear, Passed};

use super::{TITLE, figures, rendered, report, sections};
use crate::sample::{Kind, sample};

#[test]
fn the_nonlinear_run_shows_what_became_of_the_wall() {
    let html = report(Kind::Nonlinear).html;
    assert!(sections(&html).contains(&"nonlinear"));
    for figure in [
        "nonlinear_base_shear",
        "nonlinear_wave_height_theta_0",
        "cracks_1",
        "cracks_3",
        "cells_1_plastic_strain",
        "cells_2_utilisation",
        "loop_1_moment_curvature_theta_0",
        "loop_2_shear_displacement",
        "envelope_nonlinear_hoop_stress",
        "history_nonlinear_largest_crack",
        "energies",
    ] {
        assert!(html.contains(&format!("id=\"fig-{figure}\"")), "{figure}");
    }
    // A sentence replaces an empty picture.
    for absent in ["cracks_4", "cells_4_separation", "loop_3_still"] {
        assert!(!html.contains(&format!("id=\"fig-{absent}\"")), "{absent}");
    }
    assert!(html.contains("Outer face: no crack, at rest, t = 0.00\u{a0}s."));
    assert!(html.contains("Separation: zero everywhere."));
    for text in
        ["First yield of a bar", "0.81", "14\u{202f}873", "Nonlinear elements", "to the end of the ground motion"]
    {
        assert!(html.contains(text), "{text}");
    }
    assert!(html.contains(".fig .cr.c0") && !report(Kind::Compare).html.contains(".fig .cr.c0"));
}

#[test]
fn a_collapse_is_told_first_and_its_numbers_are_bounds() {
    let (mut results, mut series) = sample(Kind::Nonlinear, TITLE);
    results.runs[1].end = End::Collapsed {
        time: 7.312,
        load_factor: None,
        reason: "the step was halved 12 times".into(),
        place: "θ = 0°, base <b>".into(),
    };
    results.verdict.unfinished = true;
    results.verdict.cause = Some(Incomplete::NoEquilibrium { time: 7.312 });
    let end = series.time.iter().position(|t| *t > 7.315).expect("a longer record");
    for (id, column) in series.ids.iter().zip(&mut series.columns) {
        if id.starts_with(EngineId::Nonlinear.prefix()) {
            column[end..].fill(f64::NAN);
        }
    }
    let html = rendered(&results, &series).html;
    let summary = &html[..html.find("id=\"comparison\"").expect("a second section")];
    assert!(summary.contains("Collapse: the nonlinear run") && summary.contains("verdict fail"));
    for text in [
        "no equilibrium after t = 7.312 s",
        "θ = 0°, base &lt;b&gt;.",
        "Reason: the step was halved 12 times.",
        "lower bounds",
        "<td class=\"n\">≥ ",
        "The nonlinear run ends at 7.31 s.",
    ] {
        assert!(html.contains(text), "{text}");
    }
    for svg in figures(&html) {
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

/// A run that exceeded a limit of its model is marked at the top, whether it continued or stopped there, and shows the components
/// of the moment at the base.
#[test]
fn a_run_that_left_its_model_is_marked() {
    let departure = Departure {
        kind: DepartureKind::BarStrain,
        time: 4.321,
        theta: Some(0.0),
        height: 0.012,
        passed: Some(Passed { value: 0.03, limit: 0.025 }),
    };
    let moments = BaseMoment {
        place: "wall at θ = 0°".into(),
        time: 4.5,
        reaction: -1.245e6,
        section: -0.8e6,
        damping: -0.1e6,
        inertia: -0.35e6,
        load: 5e3,
        largest_section: 0.44e6,
    };
    let stopped = End::Left {
        time: 4.4,
        departure: Departure { kind: DepartureKind::StoredEnergy, height: 3.0, ..departure.clone() },
    };
    for (end, words) in [
        (End::Completed, "The run left its model at t = 4.321 s"),
        (stopped, "Stopped: the run left its model at t = 4.400 s"),
    ] {
        let (mut results, series) = sample(Kind::Nonlinear, TITLE);
        results.runs[1].end = end;
        let run = results.runs[1].nonlinear.as_mut().expect("a nonlinear run");
        run.departures = vec![departure.clone()];
        run.moments = vec![moments.clone()];
        let html = rendered(&results, &series).html;
        for text in [
            words,
            "wall at θ = 0°, z = 12.0 mm: a bar is strained by 3.00 %, its strain at rupture is 2.50 %",
            "Largest of the section",
        ] {
            assert!(html.contains(text), "{text}");
        }
        assert!(!html.contains("to the end of the ground motion</strong>"));
        let at = html.find("Largest of the section").expect("the table");
        let table = &html[at..at + html[at..].find("</table>").expect("its end")];
        for cell in ["1245", "440", "350"] {
            assert!(table.replace('\u{202f}', "").contains(cell), "{cell}: {table}");
        }
    }
}

#[test]
fn a_strip_shows_its_walls_side_by_side() {
    let (mut results, series) = sample(Kind::Nonlinear, TITLE);
    let run = results.runs[1].nonlinear.as_mut();
    let run = run.expect("a nonlinear run");
    run.grid.columns = Columns::Walls { names: vec!["left wall".into(), "right wall".into()] };
    let cells = run.grid.cells();
    for map in &mut run.maps {
        map.values.truncate(cells);
    }
    for picture in &mut run.cracks {
        picture.cracks.retain(|c| c.cell < cells);
    }
    let html = rendered(&results, &series).html;
    for text in ["right wall", "id=\"fig-cracks_1\"", "id=\"fig-cells_3_bar_stress\""] {
        assert!(html.contains(text), "{text}");
    }
    assert!(!html.contains("mirror image"));
}

#[test]
fn a_nonlinear_run_without_anything_is_no_broken_section() {
    let (mut results, series) = sample(Kind::Nonlinear, TITLE);
    results.runs[1].events.clear();
    let run = results.runs[1].nonlinear.as_mut().expect("a nonlinear run");
    run.maps.clear();
    run.cracks.clear();
    run.loops.clear();
    run.cost.clear();
    run.energies = Energies::default();
    let short = rendered(&results, &series).html;
    assert!(short.contains("id=\"nonlinear\"") && !short.contains("id=\"fig-energies\""));
    results.runs[1].nonlinear = None;
    assert!(rendered(&results, &series).html.contains("id=\"nonlinear\""));
}

#[test]
fn a_map_without_a_value_for_each_cell_is_an_error_and_no_panic() {
    let templates = Templates::new(None).expect("the embedded templates parse");
    let spoil = |spoil: &dyn Fn(&mut Nonlinear)| {
        let (mut results, series) = sample(Kind::Nonlinear, TITLE);
        let run = results.runs[1].nonlinear.as_mut();
        spoil(run.expect("a nonlinear run"));
        build(&results, &series, &templates, report::Level::Full).expect_err("a fault").to_string()
    };
    assert!(spoil(&|run| run.maps[0].values.truncate(3)).contains("plastic_strain"));
    assert!(spoil(&|run| run.cracks[0].cracks[0].cell = 100_000).contains("100000"));
    assert!(spoil(&|run| run.energies.kinetic.truncate(3)).contains("energies"));
}
