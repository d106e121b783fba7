use codes::case::GroundMotion;
use codes::record::Record;
use std::time::Instant;
use tankcheck::fe::solid::{self, MeshSize, SolidOptions};
use tankcheck::fe::{self, Options};
use tankcheck::verify::cases::{broad, slender};

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let refine: f64 = args.get(1).map_or(0.5, |a| a.parse().unwrap());
    let which = args.get(2).map_or("broad", |s| s.as_str());
    let vertical = args.iter().any(|a| a == "v");
    let mut case = match which {
        "broad" => broad(1000.0),
        _ => slender(1000.0, 4.0),
    };
    let n = 800;
    let mut seed = 12345u64;
    let mut rnd = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((seed >> 33) as f64) / (1u64 << 31) as f64 - 0.5
    };
    let mut a = vec![0.0; n];
    let mut s = 0.0;
    for k in 0..n {
        s = 0.8 * s + rnd();
        let t = k as f64 * 0.01;
        a[k] = 3.0 * s * (t / 1.0).min(1.0) * (-(t - 3.0).max(0.0) * 0.7).exp()
            + 1.0 * (3.1 * t).sin() * (-(t - 4.0).max(0.0)).exp();
    }
    a[0] = 0.0;
    let rec = |f: f64| Record {
        name: "x".into(),
        dt: 0.01,
        acceleration: a.iter().map(|x| x * f).collect(),
        processing: vec![],
    };
    case.ground_motion = Some(GroundMotion {
        horizontal: rec(1.0),
        vertical: vertical.then(|| rec(0.5)),
    });
    let options = Options {
        refine: 1.0,
        mesh_error: false,
        ..Options::default()
    };
    let h = fe::simulate(&case, &options).unwrap();
    let mesh = args
        .get(3)
        .filter(|m| m.contains('x'))
        .map(|m| m.parse::<MeshSize>().unwrap());
    let so = Options { refine, ..options };
    let t = Instant::now();
    let solid = SolidOptions {
        mesh,
        liquid: if args.iter().any(|a| a == "disp") {
            solid::Liquid::Displacement
        } else {
            solid::Liquid::Potential
        },
        ..SolidOptions::default()
    };
    if args.iter().any(|a| a == "modes") {
        let t = Instant::now();
        for m in solid::modes(&case, &so, &solid, 8, &fem::progress::Silent).unwrap() {
            println!(
                "{} n={} m={:?} {} omega {} f {} meff {}",
                m.kind,
                m.harmonic,
                m.axial,
                m.number,
                m.omega,
                m.omega / 6.283185307,
                m.effective_mass
            );
        }
        println!("{:?}", t.elapsed());
        return;
    }
    println!("{:?}", solid::estimate(&case, &so, &solid));
    println!("estimate took {:?}", t.elapsed());
    let t = Instant::now();
    let s = solid::simulate(&case, &so, &solid, &fem::progress::Silent).unwrap();
    println!("solid took {:?}", t.elapsed());
    for m in &s.result.mesh {
        println!("{}: {}", m.label, m.text);
    }
    println!("{:?}", s.result.mass_balance);
    for (q, v) in &h.values {
        println!(
            "{:24} {:12.6e} {:12.6e} {:+.3}%",
            q.id(),
            v,
            s.values[q],
            100.0 * (s.values[q] / v - 1.0)
        );
    }
    for kind in ["sloshing", "structural", "rotational"] {
        for hm in [1, 0] {
            for n in 1..6 {
                let f = |r: &tankcheck::results::FeResult| {
                    r.modes
                        .iter()
                        .find(|m| m.kind == kind && m.number == n && m.harmonic == hm)
                        .map(|m| (m.omega, m.effective_mass, m.effective_height))
                };
                if let (Some(a), Some(b)) = (f(&h.result), f(&s.result)) {
                    println!("{kind} m{hm} {n}: {:?} {:?} {:+.3}%", a, b, 100.0 * (b.0 / a.0 - 1.0));
                } else {
                    println!("{kind} {hm} {n} {:?} {:?}", f(&h.result), f(&s.result));
                }
            }
        }
    }
    for i in &s.result.series {
        if let Some(j) = h.result.series.iter().find(|j| j.id == i.id) {
            println!(
                "{:32} static {:10.3e} {:10.3e}  peak {:10.4e} {:10.4e} {:+.3}%",
                i.id,
                j.static_value,
                i.static_value,
                j.peak,
                i.peak,
                100.0 * (i.peak / j.peak - 1.0)
            );
        }
    }
    if let Some(f) = &s.result.fields {
        println!(
            "{} drawn {} wall {} surface",
            f.nodes.len(),
            f.wall.len(),
            f.surface.len()
        );
        for p in &f.modes {
            println!("{} {}", p.title, p.omega);
        }
        for m in &f.maps {
            println!(
                "{} t {} max {:e}",
                m.title,
                m.time,
                m.values.iter().fold(0.0f64, |a, b| a.max(*b))
            );
        }
    }
    for e in &s.result.envelopes {
        if let Some(j) = h.result.envelopes.iter().find(|j| j.id == e.id) {
            let pk = |e: &tankcheck::results::Envelope| e.max.iter().fold(0.0f64, |m, v| m.max(*v));
            println!("{} max {:e} {:e}", e.id, pk(j), pk(e));
        }
    }
}
