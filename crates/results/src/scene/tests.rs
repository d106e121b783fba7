use super::*;
use serde_json::Value;

/// Bytes of base64, by the table of RFC 4648.
fn bytes(text: &str) -> Vec<u8> {
    let digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digits: Vec<u32> = text.chars().filter_map(|c| digits.find(c)).map(|d| d as u32).collect();
    let groups = digits.chunks(4).flat_map(|group| {
        let bits = group.iter().fold(0, |bits, d| bits << 6 | d) << (6 * (4 - group.len()));
        bits.to_be_bytes()[1..group.len()].to_vec()
    });
    groups.collect()
}

fn shorts(value: &Value) -> Vec<f64> {
    let bytes = bytes(value.as_str().unwrap());
    bytes.as_chunks::<2>().0.iter().map(|b| f64::from(i16::from_le_bytes(*b))).collect()
}

fn singles(value: &Value) -> Vec<f32> {
    bytes(value.as_str().unwrap()).as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b)).collect()
}

/// A wall of one square on the ground, a node of the liquid before its own.
fn square(states: usize) -> Snapshots {
    let nodes = vec![[9.0; 3], [1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 2.0, 3.0], [1.0, 0.0, 3.0]];
    let state = |i: usize| Snapshot {
        time: 0.1 * i as f64,
        displacement: nodes.iter().map(|p| [0.001 * i as f64 * p[2], -0.5, (i as f64).sin()]).collect(),
        on_wall: vec![1000.0 * (i as f64).cos()],
        resultants: vec![Resultants { n_phi: -4.0, n_v: 2.0 * i as f64, m_phi: f64::NAN, ..Resultants::default() }],
        ..Snapshot::default()
    };
    Snapshots {
        wall: vec![[1, 2, 3, 4]],
        thickness: vec![0.02],
        states: (0..states).map(state).collect(),
        nodes,
        ..Snapshots::default()
    }
}

fn tank() -> TankSummary {
    let tank = tank::Tank {
        details: tank::Details::default(),
        shape: Shape::Cylinder { radius: 1.0 },
        support: tank::Support::Anchored,
        courses: Vec::new(),
        roof: tank::Roof::default(),
        bottom: None,
        wall_base: tank::WallBase::Fixed,
        foundation: None,
        isolators: None,
        staging: None,
        rings: Vec::new(),
        attachments: Vec::new(),
        subsoil: tank::Subsoil::default(),
        insulation: None,
        anchors: None,
        pressure: tank::Pressure::default(),
        pipes: None,
    };
    TankSummary {
        tank,
        liquid: tank::Liquid { density: 1000.0, fill_height: 2.5, bulk_modulus: None },
        gravity: 9.81,
        liquid_mass: 0.0,
        wall_mass: 0.0,
        deformability: None,
    }
}

fn document(snapshots: &Snapshots, most: usize) -> Value {
    serde_json::to_value(scene(&tank(), EngineId::Solid, snapshots, most)).unwrap()
}

/// Every number comes back within half a step of its frame, through base64 and 16 bits; the node that no part uses is gone.
#[test]
fn what_is_read_back_is_what_was_written() {
    let snapshots = square(20);
    let found = document(&snapshots, MOST);
    assert_eq!(singles(&found["nodes"]).len(), 12);
    assert_eq!(singles(&found["nodes"])[3..6], [1.0, 2.0, 0.0]);
    let cells = bytes(found["parts"][0]["cells"].as_str().unwrap());
    assert_eq!(cells.as_chunks::<4>().0.iter().map(|b| u32::from_le_bytes(*b)).collect::<Vec<_>>(), [0, 1, 2, 3]);
    assert_eq!(found["frames"], serde_json::json!({ "kept_every": 1.0, "states": 20 }));
    let moved = shorts(&found["displacement"]);
    assert_eq!(moved.len(), 20 * 12);
    for (i, state) in snapshots.states.iter().enumerate() {
        let scale = found["scale"][i].as_f64().unwrap();
        for (k, value) in state.displacement[1..].iter().flatten().enumerate() {
            assert!((moved[12 * i + k] * scale - value).abs() <= 0.5001 * scale, "{i} {k} {value}");
        }
    }
    let field = |id: &str| {
        let fields = found["fields"].as_array().unwrap();
        let own = fields.iter().find(|f| f["id"] == id).unwrap();
        shorts(&own["values"])
            .iter()
            .zip(own["scale"].as_array().unwrap())
            .map(|(v, s)| v * s.as_f64().unwrap())
            .collect()
    };
    let (hoop, axial, pressure): (Vec<f64>, Vec<f64>, Vec<f64>) =
        (field("hoop_stress"), field("axial_stress"), field("pressure"));
    assert!(hoop.iter().all(|v| (v + 200.0).abs() < 1e-9));
    assert!(axial.iter().enumerate().all(|(i, v)| (v - 100.0 * i as f64).abs() < 1e-9));
    assert!(pressure.iter().enumerate().all(|(i, v)| (v - 1000.0 * (i as f64).cos()).abs() < 1e-9));
}

/// A wave of a metre does not coarsen the tenth of a millimetre that the wall moves: each has its own scale. A node of both is the wall's.
#[test]
fn the_surface_has_a_scale_of_its_own() {
    let mut snapshots = square(2);
    let first = snapshots.nodes.len();
    snapshots.nodes.extend([[0.0, 0.0, 3.0], [0.0, 2.0, 3.0]]);
    snapshots.surface = vec![[4, 3, first, first + 1]];
    for state in &mut snapshots.states {
        state.displacement = vec![[1e-4, 0.0, 0.0]; 5];
        state.displacement.extend([[0.0, 0.0, 1.0], [0.0, 0.0, -0.75]]);
    }
    let found = document(&snapshots, MOST);
    let (moved, of) = (shorts(&found["displacement"]), |key: &str| found[key][1].as_f64().unwrap());
    assert!((of("scale") - 1e-4 / 32767.0).abs() < 1e-12 && (of("surface_scale") - 1.0 / 32767.0).abs() < 1e-9);
    let frame = &moved[moved.len() / 2..];
    assert_eq!((frame[0], frame[9], frame[14], frame[17]), (32767.0, 32767.0, 32767.0, -24575.0));
    assert!(document(&square(2), MOST).get("surface_scale").is_none());
}

/// A bound leaves frames out evenly, but for the largest of displacement and of every field, and a third of the frames about that of displacement.
#[test]
fn frames_are_left_out_evenly_and_peaks_stay() {
    let mut snapshots = square(500);
    snapshots.states[123].on_wall = vec![1e6];
    snapshots.states[77].displacement[3] = [4.0, 0.0, 0.0];
    let whole = document(&snapshots, MOST).to_string().len();
    let found = document(&snapshots, whole / 4);
    let every = found["frames"]["kept_every"].as_f64().unwrap();
    assert!(every > 3.0 && found.to_string().len() <= whole / 4, "{every} {whole} {}", found.to_string().len());
    let times: Vec<f64> = found["times"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
    let gaps = times.windows(2).map(|pair| pair[1] - pair[0]);
    assert!(
        gaps.fold(0.0, f64::max) < 0.1 * (every + 1.0) && times.len() as f64 <= 1.5 * 500.0 / every + 5.0,
        "{times:?}"
    );
    let close = times.iter().filter(|t| (**t - 7.7).abs() < 0.05 * 500.0 / every / 2.0 - 0.1).collect::<Vec<_>>();
    assert!(close.len() > 20 && close.windows(2).all(|pair| (pair[1] - pair[0] - 0.1).abs() < 1e-9), "{close:?}");
    assert!([12.3, 7.7].iter().all(|t| times.iter().any(|own| (own - t).abs() < 1e-9)), "{times:?}");
    assert!(times.is_sorted());
}

/// A field that an engine does not compute is not there.
#[test]
fn what_is_not_computed_is_no_field() {
    let mut snapshots = square(3);
    snapshots.states.iter_mut().for_each(|state| state.resultants[0].n_phi = f64::NAN);
    snapshots.states[1].on_wall.clear();
    let found = document(&snapshots, MOST);
    let ids: Vec<&str> = found["fields"].as_array().unwrap().iter().filter_map(|f| f["id"].as_str()).collect();
    assert_eq!(ids, ["axial_stress"]);
}

/// The image of a half: nodes on the plane once, the other face of each cell inwards as before, y the other way.
#[test]
fn a_half_is_mirrored() {
    let half = Snapshots { half: true, ..square(2) };
    let whole = mirror::whole(&half).unwrap();
    assert_eq!(whole.nodes.len(), 5 + 3);
    let normal = |all: &Snapshots, cell: usize| {
        let [a, b, _, d] = all.wall[cell].map(|n| all.nodes[n]);
        let [u, v] = [b, d].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
        u[1] * v[2] - u[2] * v[1]
    };
    assert_eq!((normal(&whole, 0), normal(&whole, 1)), (6.0, 6.0));
    let lowest = whole.wall[1].map(|n| whole.nodes[n][1]).into_iter().fold(f64::INFINITY, f64::min);
    assert_eq!(lowest, -2.0);
    let state = &whole.states[1];
    assert_eq!((state.displacement[2][1], state.displacement[6][1]), (-0.5, 0.5));
    assert_eq!((whole.thickness.len(), state.on_wall.len(), state.resultants.len()), (2, 2, 2));
}
