//! `compare --scene`: the motion that a viewer plays is that of the histories, in the resolution of its 16 bits.

use std::f64::consts::TAU;
use std::path::Path;

use serde_json::Value;

use crate::compare::{stderr, tankcheck};

const QUAKE: &str = "examples/records/elcentro.csv";

/// Bytes of base64, by the table of RFC 4648.
fn bytes(text: &Value) -> Vec<u8> {
    let digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut value = [0_u32; 128];
    digits.bytes().enumerate().for_each(|(i, c)| value[usize::from(c)] = i as u32);
    let text = text.as_str().expect("base64").trim_end_matches('=').as_bytes();
    let group = |group: &[u8]| {
        let bits = group.iter().fold(0, |bits, c| bits << 6 | value[usize::from(*c)]) << (6 * (4 - group.len()));
        bits.to_be_bytes()[1..group.len()].to_vec()
    };
    text.chunks(4).flat_map(group).collect()
}

fn numbers(values: &Value) -> Vec<f64> {
    values.as_array().expect("numbers").iter().filter_map(Value::as_f64).collect()
}

/// Frames of 16-bit numbers times their scale.
fn frames(values: &Value, scale: &Value) -> Vec<Vec<f64>> {
    let (bytes, scale) = (bytes(values), numbers(scale));
    let count = bytes.len() / 2 / scale.len();
    let frame = |(bytes, scale): (&[u8], &f64)| {
        bytes.as_chunks::<2>().0.iter().map(|b| f64::from(i16::from_le_bytes(*b)) * scale).collect()
    };
    bytes.chunks(2 * count).zip(&scale).map(frame).collect()
}

/// A scene as a viewer reads it, and the histories beside it.
struct Run {
    document: Value,
    nodes: Vec<[f64; 3]>,
    times: Vec<f64>,
    /// Half a step of each frame [m], of the nodes and of those that only the surface has.
    steps: [Vec<f64>; 2],
    apart: Vec<bool>,
    displacement: Vec<Vec<f64>>,
    head: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Run {
    fn of(out: &Path) -> Run {
        let text = std::fs::read_to_string(out.join("scene.json")).expect("a scene");
        let document: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(document["format"], "tankcheck-scene/2");
        let nodes = bytes(&document["nodes"]);
        let nodes: Vec<f64> = nodes.as_chunks::<4>().0.iter().map(|b| f64::from(f32::from_le_bytes(*b))).collect();
        let mut series = csv::Reader::from_path(out.join("series.csv")).expect("histories");
        let id = |head: &str| head.split(" [").next().unwrap_or_default().to_owned();
        let head = series.headers().expect("a head").iter().map(id).collect();
        let row = |row: csv::StringRecord| row.iter().map(|v| v.parse().expect("a number")).collect();
        let scale = numbers(&document["scale"]);
        let surface =
            document["surface_scale"].as_array().map_or_else(|| scale.clone(), |_| numbers(&document["surface_scale"]));
        let mut run = Run {
            nodes: nodes.as_chunks::<3>().0.to_vec(),
            times: numbers(&document["times"]),
            steps: [&scale, &surface].map(|scale| scale.iter().map(|s| 0.5 * s).collect()),
            apart: Vec::new(),
            displacement: Vec::new(),
            rows: series.records().map(|r| row(r.expect("a row"))).collect(),
            head,
            document,
        };
        let others: Vec<usize> =
            ["wall", "bottom", "sides"].iter().flat_map(|part| run.found(part)).flatten().collect();
        run.apart = (0..run.nodes.len()).map(|node| !others.contains(&node)).collect();
        let stored = bytes(&run.document["displacement"]);
        for (i, frame) in stored.chunks(6 * run.nodes.len()).enumerate() {
            let value = |(k, b): (usize, &[u8; 2])| {
                f64::from(i16::from_le_bytes(*b)) * if run.apart[k / 3] { surface[i] } else { scale[i] }
            };
            run.displacement.push(frame.as_chunks::<2>().0.iter().enumerate().map(value).collect());
        }
        assert_eq!(run.displacement.len(), run.times.len());
        run
    }

    /// Half a step of a node in a frame [m].
    fn step(&self, frame: usize, node: usize) -> f64 {
        self.steps[usize::from(self.apart[node])][frame]
    }

    /// Cells of a part.
    fn cells(&self, part: &str) -> Vec<[usize; 4]> {
        let found = self.found(part);
        assert!(!found.is_empty(), "no {part}");
        found
    }

    /// The same, none of a part that is not there.
    fn found(&self, part: &str) -> Vec<[usize; 4]> {
        let parts = self.document["parts"].as_array().expect("parts");
        let Some(found) = parts.iter().find(|p| p["id"] == part) else { return Vec::new() };
        let places = bytes(&found["cells"]);
        let places: Vec<usize> = places.as_chunks::<4>().0.iter().map(|b| u32::from_le_bytes(*b) as usize).collect();
        places.as_chunks::<4>().0.to_vec()
    }

    fn field(&self, id: &str) -> Vec<Vec<f64>> {
        let fields = self.document["fields"].as_array().expect("fields");
        let found = fields.iter().find(|f| f["id"] == id).unwrap_or_else(|| panic!("no {id}"));
        frames(&found["values"], &found["scale"])
    }

    /// Node of a part at a place.
    fn node(&self, part: &str, place: [f64; 3]) -> usize {
        let near = |node: usize| (0..3).all(|k| (self.nodes[node][k] - place[k]).abs() < 1e-5);
        let found = self.cells(part).into_iter().flatten().find(|n| near(*n));
        found.unwrap_or_else(|| panic!("no node of {part} at {place:?}"))
    }

    /// Frames at a sample of the histories, with its row.
    fn samples(&self) -> Vec<(usize, &[f64])> {
        let row = |time: f64| self.rows.iter().find(|row| (row[0] - time).abs() < 1e-7);
        let found: Vec<_> = self.times.iter().enumerate().filter_map(|(f, t)| Some((f, row(*t)?.as_slice()))).collect();
        assert!(found.len() > 20, "{} of {} frames", found.len(), self.times.len());
        found
    }

    fn column(&self, id: &str) -> usize {
        self.head.iter().position(|head| head == id).unwrap_or_else(|| panic!("no {id} in {:?}", self.head))
    }

    /// Asserts that a displacement is that of a history, within half a step of the frame and the digits of the file.
    fn follows(&self, node: usize, axis: usize, sign: f64, channel: &str) {
        self.follows_from(0.0, (node, axis), sign, channel);
    }

    /// The same of a displacement from one at rest.
    fn follows_from(&self, rest: f64, (node, axis): (usize, usize), sign: f64, channel: &str) {
        let column = self.column(channel);
        let largest = self.rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for (frame, row) in self.samples() {
            let (found, expected) = (self.displacement[frame][3 * node + axis] - rest, sign * row[column]);
            let bound = 1.01 * (self.step(frame, node) + if rest == 0.0 { 0.0 } else { self.step(0, node) })
                + 1e-6 * sign.abs() * largest;
            assert!((found - expected).abs() <= bound, "{channel}, t = {}: {found} {expected}", row[0]);
        }
        assert!(sign.abs() * largest > 10.0 * self.step(0, node), "{channel}: {largest}");
    }

    fn area(&self, cell: &[usize; 4]) -> f64 {
        let [p, q, r, s] = cell.map(|n| self.nodes[n]);
        let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] - b[k]);
        let (u, v) = (minus(r, p), minus(s, q));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        0.5 * cross.iter().map(|c| c * c).sum::<f64>().sqrt()
    }

    /// cos θ in the middle of a cell of a cylinder.
    fn cosine(&self, cell: &[usize; 4]) -> f64 {
        let [x, y] = [0, 1].map(|k| cell.iter().map(|n| self.nodes[*n][k]).sum::<f64>());
        x / x.hypot(y)
    }
}

/// A run into a folder.
fn run(tank: &str, out: &Path, options: &[&str]) -> String {
    let out = out.to_str().expect("text");
    let given = ["compare", tank, "--quake", QUAKE, "--no-mesh-error", "--no-report", "--out", out];
    let output = tankcheck(&[&given, options].concat());
    assert!(output.status.code().is_some_and(|code| code != 2 && code != 3), "{}", stderr(&output));
    stderr(&output)
}

/// The broad tank with stations at heights [m].
fn broad(home: &Path, stations: &[f64]) -> String {
    let text = std::fs::read_to_string("examples/01_broad_tank/tank.json").expect("the example");
    let stations: Vec<String> = stations.iter().map(|z| format!("\"{z} m\"")).collect();
    let own = text.replace(r#"["2.5 cm", "5 cm", "10 cm"]"#, &format!("[{}]", stations.join(", ")));
    assert_ne!(own, text);
    let path = home.join("tank.json");
    std::fs::write(&path, own).expect("writable");
    path.to_str().expect("text").to_owned()
}

/// Waves at both sides, deflections at the joint of the courses and at the top, and hoop stresses in the middle of cells are those of the histories;
/// the pressures on the wall make up the base shear, and the surface keeps its volume.
#[test]
fn a_scene_is_that_of_the_histories() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    run(&broad(home.path(), &[0.915, 1.83]), &out, &["--scene"]);
    let first = Run::of(&out);
    assert_eq!(first.document["engine"], "harmonic");
    let radius = 1.83;
    for (side, degrees) in [(1.0, 0), (-1.0, 180)] {
        let crest = first.node("surface", [side * radius, 0.0, 1.525]);
        first.follows(crest, 2, 1.0, &format!("wave_height_theta_{degrees}"));
        // Outwards at 0 is along x, at 180° against it, and the harmonic changes its sign: the wall moves as a ring.
        for z in [0.915, 1.83] {
            let node = first.node("wall", [side * radius, 0.0, z]);
            first.follows(node, 0, 1.0, &format!("radial_displacement_z_{z}"));
        }
    }
    let surface: Vec<([usize; 4], f64)> = first.cells("surface").iter().map(|c| (*c, first.area(c))).collect();
    assert!((surface.iter().map(|(_, a)| a).sum::<f64>() / (TAU / 2.0 * radius * radius) - 1.0).abs() < 0.004);
    for (u, step) in first.displacement.iter().zip(&first.steps[1]) {
        let volume: f64 = surface.iter().map(|(c, a)| a * 0.25 * c.iter().map(|n| u[3 * n + 2]).sum::<f64>()).sum();
        assert!(volume.abs() <= step * TAU / 2.0 * radius * radius, "{volume}");
    }
    // The wave is a hundred times as high as the wall moves, whose step is its own; about the largest base shear its period is resolved.
    let largest = |steps: &[f64]| steps.iter().copied().fold(0.0, f64::max);
    assert!(
        largest(&first.steps[0]) < 0.1 * largest(&first.steps[1]),
        "{:?}",
        first.steps.each_ref().map(|s| largest(s))
    );
    let modes = first.document["modes"].as_array().expect("modes");
    let wall =
        modes.iter().find(|mode| mode["title"].as_str().is_some_and(|title| title.starts_with("Wall and liquid, cos")));
    let period = 1.0 / wall.and_then(|mode| mode["frequency"].as_f64()).expect("a mode of the wall");
    assert!(first.times.windows(161).any(|times| times[160] - times[0] <= 40.0 * period), "{period}");
    // The liquid pushes against the wall as the ground against the tank; the wall itself has 1 % of the impulsive mass.
    let (wall, pressure) = (first.cells("wall"), first.field("pressure"));
    let shear = first.column("base_shear");
    let largest = first.rows.iter().map(|row| row[shear].abs()).fold(0.0, f64::max);
    for (frame, row) in first.samples() {
        let force = wall.iter().zip(&pressure[frame]).map(|(c, p)| p * first.area(c) * first.cosine(c)).sum::<f64>();
        assert!((force + row[shear]).abs() < 0.03 * largest, "t = {}: {force} {}", row[0], row[shear]);
    }
    // Stations in the middle of cells next to θ = 0, of which a new run has the histories.
    let beside: Vec<(usize, f64)> = (wall.iter().enumerate())
        .filter(|(_, c)| c.iter().any(|n| first.nodes[*n][1].abs() < 1e-9) && first.cosine(c) > 0.99)
        .map(|(i, c)| (i, 0.25 * c.iter().map(|n| first.nodes[*n][2]).sum::<f64>()))
        .filter(|(_, z)| (0.4..1.2).contains(z))
        .collect();
    assert!(beside.len() > 10);
    let again = home.path().join("again");
    run(
        &broad(home.path(), &beside.iter().map(|(_, z)| (z * 1e6).round() / 1e6).collect::<Vec<_>>()),
        &again,
        &["--scene"],
    );
    let second = Run::of(&again);
    for (id, column) in [("hoop_stress", "hoop_stress_z_"), ("axial_stress", "axial_membrane_stress_z_")] {
        let values = second.field(id);
        for (cell, z) in &beside {
            let column = second.column(&format!("{column}{}", (z * 1e6).round() / 1e6));
            let largest = second.rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
            for (frame, row) in second.samples() {
                let expected = row[column] * (TAU / 96.0).cos();
                let found = values[frame][*cell];
                assert!((found - expected).abs() < 0.01 * largest + 1e3, "{id} {z} t = {}: {found} {expected}", row[0]);
            }
        }
    }
}

/// Three components: the crest at every quarter of the wall is that of its history, and the top at θ = 0.
#[test]
fn three_components_are_those_of_the_histories() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    // Along y the record from its end to its beginning.
    let text = std::fs::read_to_string(QUAKE).expect("the record");
    let rows: Vec<(&str, &str)> = text.lines().skip(1).filter_map(|line| line.split_once(',')).collect();
    let turned = rows.iter().zip(rows.iter().rev()).map(|((t, _), (_, a))| format!("{t},{a}\n"));
    let across = home.path().join("across.csv");
    std::fs::write(&across, "time_s,acceleration_g\n".to_owned() + &turned.collect::<String>()).expect("writable");
    let more = ["--quake-y", across.to_str().expect("text"), "--vertical", QUAKE];
    run(&broad(home.path(), &[1.83]), &out, &[&["--scene"], &more[..]].concat());
    let run = Run::of(&out);
    let radius = 1.83;
    for (place, degrees) in [([1.0, 0.0], 0), ([0.0, 1.0], 90), ([-1.0, 0.0], 180), ([0.0, -1.0], 270)] {
        let crest = run.node("surface", [radius * place[0], radius * place[1], 1.525]);
        run.follows(crest, 2, 1.0, &format!("wave_height_theta_{degrees}"));
    }
    run.follows(run.node("wall", [radius, 0.0, 1.83]), 0, 1.0, "radial_displacement_z_1.83");
}

/// The file belongs to the folder: manifest, report and diff; a run without it removes it.
#[test]
fn the_file_belongs_to_its_folder() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let [out, plain] = ["out", "plain"].map(|name| home.path().join(name));
    let tank = "examples/01_broad_tank/tank.json";
    run(tank, &out, &["--scene", "--vtu-every", "0.5"]);
    run(tank, &plain, &[]);
    let manifest = |folder: &Path| std::fs::read_to_string(folder.join("manifest.json")).expect("a manifest");
    assert!(manifest(&out).contains("scene.json") && !manifest(&plain).contains("scene.json"));
    assert!(!plain.join("scene.json").exists());
    let [out_text, plain_text] = [&out, &plain].map(|p| p.to_str().expect("text"));
    let same = tankcheck(&["diff", out_text, plain_text]);
    assert_eq!(same.status.code(), Some(0), "{}", stderr(&same));
    let read = |name: &str| [&out, &plain].map(|folder| std::fs::read(folder.join(name)).expect(name));
    let [with, without] = read("series.csv");
    assert_eq!(with, without);
    let report = tankcheck(&["report", out_text]);
    assert_eq!(report.status.code(), Some(0), "{}", stderr(&report));
    assert!(out.join("scene.json").exists() && out.join("report.html").exists());
    assert!(Run::of(&out).times.len() < 80);
    let warned = run(tank, &out, &[]);
    assert!(warned.contains("scene.json") && !out.join("scene.json").exists(), "{warned}");
}

/// Without states there is no file, and the run says why.
#[test]
fn without_a_record_there_is_no_scene() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let out = out.to_str().expect("text");
    let tank = "examples/01_broad_tank/tank.json";
    let site = tankcheck(&["compare", tank, "--no-report", "--scene", "--out", out]);
    assert!(
        stderr(&site).contains("scene: no file written; states are those of a run under a record"),
        "{}",
        stderr(&site)
    );
    assert!(!Path::new(out).join("scene.json").exists());
    let none = tankcheck(&["compare", tank, "--quake", QUAKE, "--fe", "none", "--vtu", out]);
    assert_eq!(none.status.code(), Some(2));
    assert!(stderr(&none).contains("--vtu: there is nothing to draw"), "{}", stderr(&none));
    let alone = tankcheck(&["compare", tank, "--quake", QUAKE, "--vtu-every", "1"]);
    assert_eq!(alone.status.code(), Some(2));
}

/// A bottom that lifts: its rim is the foot of the wall, and rises as the history of the uplift.
#[test]
fn a_lifting_bottom_and_its_wall_move_together() {
    let home = tempfile::tempdir().expect("a temporary folder");
    run("examples/09_slender_unanchored/tank.json", home.path(), &["--scene"]);
    let run = Run::of(home.path());
    let radius = run.document["length"]["radius"].as_f64().expect("a radius");
    for (side, degrees) in [(1.0, 0), (-1.0, 180)] {
        let [foot, rim] = ["wall", "bottom"].map(|part| run.node(part, [side * radius, 0.0, 0.0]));
        assert_ne!(foot, rim);
        for (u, step) in run.displacement.iter().zip(&run.steps[0]) {
            assert!(
                (u[3 * foot + 2] - u[3 * rim + 2]).abs() < 3.0 * step + 1e-6,
                "{} {}",
                u[3 * foot + 2],
                u[3 * rim + 2]
            );
        }
        run.follows(foot, 2, 1.0, &format!("uplift_theta_{degrees}"));
    }
    assert!(run.field("ground_pressure").iter().flatten().all(|p| *p >= 0.0));
}

/// A base that moves: the foot goes with the isolators, or tilts with its slab on soil.
#[test]
fn a_foot_goes_with_its_base() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = |name: &str| home.path().join(name);
    run("examples/11_slab_tank/tank_isolated.json", &folder("isolated"), &["--scene", "--vtu-every", "0.1"]);
    let isolated = Run::of(&folder("isolated"));
    let radius = isolated.document["length"]["radius"].as_f64().expect("a radius");
    for place in [[radius, 0.0, 0.0], [0.0, radius, 0.0]] {
        isolated.follows(isolated.node("wall", place), 0, 1.0, "isolator_displacement");
    }
    run("examples/11_slab_tank/tank_soil.json", &folder("soil"), &["--scene", "--vtu-every", "0.1"]);
    let soil = Run::of(&folder("soil"));
    let radius = soil.document["length"]["radius"].as_f64().expect("a radius");
    // A positive rotation presses θ = 0 down.
    for side in [1.0, -1.0] {
        let foot = soil.node("wall", [side * radius, 0.0, 0.0]);
        soil.follows(foot, 2, -side * radius, "foundation_rotation");
    }
}

/// A box: the crests at both walls, which bend the same way.
#[test]
fn a_strip_is_that_of_the_histories() {
    let home = tempfile::tempdir().expect("a temporary folder");
    run("examples/04_concrete_strip/tank.json", home.path(), &["--scene"]);
    let run = Run::of(home.path());
    let [half, fill, height] =
        ["length", "fill", "height"].map(|key| run.document["length"][key].as_f64().expect("a length"));
    let (half, last) = (0.5 * half, run.nodes.iter().map(|p| p[1]).fold(0.0, f64::max));
    for (side, degrees) in [(1.0, 0), (-1.0, 180)] {
        let crest = run.node("surface", [side * half, last, fill]);
        run.follows(crest, 2, 1.0, &format!("wave_height_theta_{degrees}"));
    }
    let tops = [1.0, -1.0].map(|side| run.node("wall", [side * half, last, height]));
    for u in &run.displacement {
        assert_eq!(u[3 * tops[0]], u[3 * tops[1]]);
    }
    assert!(run.field("bending_stress").iter().flatten().any(|v| v.abs() > 1e4));
}

/// Both walls of a nonlinear strip: deflections of the tops from the state at rest, and the crests.
#[test]
fn a_nonlinear_strip_is_that_of_its_histories() {
    let home = tempfile::tempdir().expect("a temporary folder");
    // Four seconds of the record.
    let text = std::fs::read_to_string(QUAKE).expect("the record");
    let short: Vec<&str> = text.lines().take(220).collect();
    let quake = home.path().join("short.csv");
    std::fs::write(&quake, short.join("\n") + "\n").expect("writable");
    let out = home.path().join("out");
    let output = tankcheck(&[
        "compare",
        "examples/04_concrete_strip/tank.json",
        "--quake",
        quake.to_str().expect("text"),
        "--fe",
        "nonlinear",
        "--no-mesh-error",
        "--no-report",
        "--scene",
        "--out",
        out.to_str().expect("text"),
    ]);
    let run = Run::of(&out);
    assert_eq!(run.document["engine"], "nonlinear", "{}", stderr(&output));
    let [half, fill, height] =
        ["length", "fill", "height"].map(|key| run.document["length"][key].as_f64().expect("a length"));
    let half = 0.5 * half;
    let last = run.nodes.iter().map(|p| p[1]).fold(0.0, f64::max);
    for (side, degrees) in [(1.0, 0), (-1.0, 180)] {
        let crest = run.node("surface", [side * half, last, fill]);
        run.follows(crest, 2, 1.0, &format!("nonlinear_wave_height_theta_{degrees}"));
        // Outwards is against x at 180°.
        let top = run.node("wall", [side * half, last, height]);
        let rest = run.displacement[0][3 * top];
        run.follows_from(rest, (top, 0), side, &format!("nonlinear_wall_displacement_theta_{degrees}"));
    }
    assert_eq!(run.field("crack_opening")[0].len(), run.cells("wall").len());
}

/// The three-dimensional engine: the pressures of its liquid on the wall make up the base shear but for the wall's own share.
#[test]
fn a_solid_scene_carries_the_base_shear() {
    let home = tempfile::tempdir().expect("a temporary folder");
    run(
        "examples/01_broad_tank/tank.json",
        home.path(),
        &["--fe", "solid", "--mesh", "6x16x10", "--scene", "--vtu-every", "0.1"],
    );
    let run = Run::of(home.path());
    assert_eq!(run.document["engine"], "solid");
    let (wall, pressure, shear) = (run.cells("wall"), run.field("pressure"), run.column("base_shear"));
    let largest = run.rows.iter().map(|row| row[shear].abs()).fold(0.0, f64::max);
    for (frame, row) in run.samples() {
        let force = wall.iter().zip(&pressure[frame]).map(|(c, p)| p * run.area(c) * run.cosine(c)).sum::<f64>();
        assert!((force + row[shear]).abs() < 0.08 * largest, "t = {}: {force} {}", row[0], row[shear]);
    }
    let surface: f64 = run.cells("surface").iter().map(|c| run.area(c)).sum();
    // A regular polygon of 16 sides.
    let polygon = 8.0 * 1.83 * 1.83 * (TAU / 16.0).sin();
    assert!((surface / polygon - 1.0).abs() < 1e-5, "{surface} {polygon}");
}
