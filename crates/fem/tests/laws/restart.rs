//! An element has no hidden state: its response depends on the motion and the committed history only, bit for bit.

use fem::element::Want;

use crate::motion::Moved;
use crate::registry::{all, least};
use crate::specimen::{Answer, answer, asked, virgin};

const STEPS: usize = 12;

fn same(a: &Answer, b: &Answer) -> bool {
    let bits = |x: &Answer| -> Vec<u64> {
        let all = x.force.iter().chain(&x.tangent.data).chain(&x.history);
        all.map(|v| v.to_bits()).collect()
    };
    bits(a) == bits(b)
}

/// The run is split after every step: a new element continues from a history that was written out and read back, while the old one
/// is asked about other motions in between.
#[test]
fn a_split_run_repeats_the_whole() {
    for specimen in all() {
        let (element, run) = (specimen.element(), Moved::run(&specimen, STEPS));
        let mut committed = vec![virgin(&*element)];
        let mut whole = Vec::new();
        for moved in &run {
            let found = answer(&*element, moved, &committed[committed.len() - 1]);
            committed.push(found.history.clone());
            whole.push(found);
        }
        for split in 0..STEPS {
            let bytes: Vec<[u8; 8]> = committed[split].iter().map(|h| h.to_le_bytes()).collect();
            let mut history: Vec<f64> = bytes.into_iter().map(f64::from_le_bytes).collect();
            let (fresh, used) = (specimen.element(), &element);
            for (k, moved) in run.iter().enumerate().skip(split) {
                let found = answer(&*fresh, moved, &history);
                assert!(same(&found, &whole[k]), "{specimen}: split after {split}, step {k}");
                answer(&**used, &Moved::scattered(&specimen, 7 + k, 0.5), &history);
                let again = answer(&**used, moved, &history);
                assert!(same(&again, &found), "{specimen}: asked about another motion before step {k}");
                history = found.history;
            }
        }
    }
}

/// Force and tangent asked for one by one are those asked for together.
#[test]
fn what_is_wanted_changes_no_number() {
    for specimen in all() {
        let element = specimen.element();
        let mut history = virgin(&*element);
        for moved in &Moved::run(&specimen, STEPS) {
            let both = answer(&*element, moved, &history);
            let force = asked(&*element, moved, &history, Want::FORCE);
            let tangent = asked(&*element, moved, &history, Want::TANGENT);
            assert_eq!(force.force, both.force, "{specimen}");
            assert_eq!(tangent.tangent, both.tangent, "{specimen}");
            assert_eq!((&force.history, &tangent.history), (&both.history, &both.history), "{specimen}");
            history = both.history;
        }
    }
}

/// Some histories change on the way, so that the laws above ask something.
#[test]
fn histories_change() {
    let mut some = 0;
    for specimen in all() {
        let element = specimen.element();
        let first = virgin(&*element);
        let mut history = first.clone();
        for moved in &Moved::run(&specimen, STEPS) {
            history = answer(&*element, moved, &history).history;
        }
        some += usize::from(history != first);
    }
    assert!(some >= least().change, "{some} histories change");
}
