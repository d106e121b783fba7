//! Grounds and bases that have no run.

use super::*;
use results::Limit;
use tank::units::Dimension;

/// A run of the band that finds no equilibrium is in the results with its ground and reason, and in the notes, and the others stay.
#[test]
fn a_missed_ground_is_named() {
    let ready = ready(oil(25e3, 1e8, 2.0));
    let base = Base::of(&ready.case).unwrap();
    let setup = ready.setup(10);
    let found = search::settle(&setup, &base, (search::FIRST, None), false).unwrap();
    let soft = outcome::band(&base.on(3.3e7), &found);
    let missed = words::missed_band(3e8, &setup::Missed::TooFar(0.0612, 3.25));
    let moved = outcome::moved(&setup, &base, found, vec![Ok(soft), Err(missed)], ready.analysis().grid);
    assert_eq!(moved.result.band, [soft]);
    let [missed] = &moved.result.missed[..] else { panic!("{:?}", moved.result.missed) };
    assert_eq!(missed.modulus, 3e8);
    let mut notes = vec![HELD_DOWN.to_owned()];
    say(&Free::Moves(Box::new(moved)), true, &mut notes, &mut Vec::new());
    let [moves, note] = &notes[..] else { panic!("{notes:?}") };
    assert_eq!(*moves, words::moves(false));
    for part in ["300 MN/m³", "0.0612 rad", "passes at 3.25 s"] {
        assert!(note.contains(part), "`{part}` is missing in {note}");
    }
}

/// A base that turns too far is a limit of validity with its angle; one without an equilibrium stands at the tension of the wall held down.
#[test]
fn a_base_beyond_the_model_is_a_limit() {
    let pulls = || Limit {
        id: crate::linear::limits::UPLIFT.into(),
        name: String::new(),
        value: -1.0,
        limit: 0.0,
        dimension: Dimension::LineForce,
        holds: true,
        note: String::new(),
    };
    let missed = setup::Missed::TooFar(0.0612, 3.25);
    let found = limits::limits(&Free::beyond(words::missed(&missed), &missed), vec![pulls()]);
    let [turns] = &found[..] else { panic!("{found:?}") };
    assert_eq!((turns.id.as_str(), turns.value, turns.limit, turns.holds), ("base_rotation", 0.0612, 0.05, false));
    assert!(turns.note.contains("overturns"), "{}", turns.note);
    let error = ::base::BaseError::BeyondCurve { rotation: 0.01, wanted: 0.2, from: -0.1, to: 0.1 };
    let missed = setup::Missed::Base(error);
    let found = limits::limits(&Free::beyond(words::missed(&missed), &missed), vec![pulls()]);
    assert!(found.len() == 1 && !found[0].holds && found[0].note.contains("no run with uplift"), "{found:?}");
}
