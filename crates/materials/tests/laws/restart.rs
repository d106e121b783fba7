//! Equal input, equal bits: a run restarted from the stored history at any step equals the whole run.

use crate::path::{Noise, Point, wander};
use crate::registry::{Case, every_law};

fn bits<const N: usize>(point: &mut Point<'_, N>, path: &[[f64; N]]) -> Vec<u64> {
    let mut bits = Vec::new();
    for strain in path {
        let response = point.step(strain);
        bits.extend(response.stress.map(f64::to_bits));
        bits.extend(response.tangent.iter().flatten().map(|x| x.to_bits()));
        bits.push(response.dissipation.to_bits());
        bits.extend(point.history.iter().map(|x| x.to_bits()));
    }
    bits
}

fn check<const N: usize>(case: &Case<N>) {
    let path = wander(&mut Noise::new(41), case.strain, 4, 10);
    let whole = bits(&mut Point::new(&*case.law), &path);
    for split in 0..path.len() {
        let mut point = Point::new(&*case.law);
        let mut parts = bits(&mut point, &path[..split]);
        let mut again = Point { law: &*case.law, history: point.history.clone() };
        // A response that is not committed has no effect.
        again.answer(&path[0]);
        parts.extend(bits(&mut again, &path[split..]));
        assert!(parts == whole, "{}, N = {N}: split at {split}", case.name);
    }
}

#[test]
fn restart() {
    every_law!(check);
}
