//! Tanks that must not hold because something is not implemented, not in charge or not good input.

use serde_json::json;

use super::failing::incomplete;
use super::*;

const EC8: &str = "ec8-2006";
const API: &str = "api650-2020";

/// All of them.
pub(super) fn tanks() -> Vec<Tank> {
    [not_implemented(), deciding(), input()].into_iter().flatten().collect()
}

/// Each limit state that is not implemented, alone not accepted.
fn not_implemented() -> Vec<Tank> {
    let why = "not implemented and not accepted";
    let ec8 = |name, state| incomplete(name, why, (EC8, state), vec![only_ec8()]);
    let api = |name, state| incomplete(name, why, (API, state), vec![only_api()]);
    vec![
        ec8("sliding-not-accepted", "sliding").open(&["sliding"]),
        ec8("bearing-not-accepted", "bearing").open(&["bearing"]),
        ec8("pipes-not-accepted", "pipes").open(&["pipes"]),
        ec8("damage-limitation-not-accepted", "damage_limitation").open(&["damage_limitation"]),
        incomplete(
            "uplift-not-accepted",
            "the bottom plate is not given",
            (EC8, "uplift"),
            vec![
                only_ec8(),
                unanchored(),
                filled(3.0),
                json!({ "tank": { "bottom": null } }),
                accept(&["overturning", "buckling_elastic", "buckling_elastic_plastic"]),
            ],
        )
        .open(&["uplift"]),
        incomplete(
            "steel-box-uplift",
            "the bottom plate of a steel box may lift: not implemented",
            (EC8, "uplift"),
            vec![only_ec8(), concrete_box(), wall(&[150.0; 2]), unanchored()],
        )
        .open(&["uplift"]),
        api("anchor-attachment-not-accepted", "anchor_attachment").open(&["anchor_attachment"]),
        api("foundation-not-accepted", "foundation").open(&["foundation"]),
        api("piping-not-accepted", "piping").open(&["piping"]),
        incomplete("annulus-not-accepted", why, (API, "annulus_width"), vec![only_api(), unanchored()])
            .open(&["annulus_width"]),
    ]
}

/// Who decides.
fn deciding() -> Vec<Tank> {
    let decide = |id: &str| json!({ "procedures": { "decide": [id] } });
    vec![
        Tank::new(
            "superseded-codes-only",
            "superseded editions do not decide",
            Expected::NotAssessed,
            vec![json!({ "procedures": { "run": ["ec8-env", "api650-1993"] } })],
        ),
        Tank::new(
            "housner-decides",
            "Housner's procedure compares nothing with a capacity under a site",
            Expected::NotAssessed,
            vec![decide("housner")],
        ),
        incomplete(
            "superseded-api-decides",
            "its two comparisons are not all that the standard requires",
            ("api650-1993", "undeclared"),
            vec![decide("api650-1993"), json!({ "site": { "api650": { "zone_factor": 0.075 } } })],
        ),
        Tank::new(
            "engine-without-a-record",
            "the engine that is to decide does not run",
            Expected::NotAssessed,
            vec![decide("fe")],
        ),
        Tank::new("no-site", "nothing shakes the tank", Expected::NotAssessed, vec![json!({ "site": null })]),
        Tank::new(
            "record-only",
            "a record is an assessment of its own",
            Expected::NotAssessed,
            vec![json!({ "site": null })],
        )
        .shaken(),
        incomplete(
            "concrete-decided-under-a-record",
            "freeboard alone is no verdict on a concrete wall",
            (EC8, "wall_tension_and_bending"),
            vec![concrete(), decide("ec8-2006"), json!({ "site": null })],
        )
        .shaken()
        .open(&["wall_tension_and_bending"]),
        Tank::new("box-under-api", "API 650 is for cylinders", Expected::NotAssessed, vec![only_api(), concrete_box()]),
    ]
}

/// Bad input.
fn input() -> Vec<Tank> {
    let refused = |name, why, path, change| Tank::new(name, why, Expected::Input(path), vec![change]);
    let accepting = |name, key: &'static str, value: Value| {
        let mut gap = gap("sliding");
        merge(&mut gap, &json!({ key: value }));
        refused(
            name,
            "a gap is accepted with a reason of several words, a name and a date",
            key,
            json!({ "accepted": [gap] }),
        )
    };
    vec![
        refused(
            "behaviour-factor-out-of-range",
            "EN 1998-4 4.4 allows at most 1.5 for a tank on the ground",
            "site.ec8.behaviour_factor",
            json!({ "site": { "ec8": { "behaviour_factor": 3 } } }),
        ),
        refused(
            "unknown-use-group",
            "there are three",
            "site.api650.sug",
            json!({ "site": { "api650": { "sug": 4 } } }),
        ),
        refused(
            "site-class-without-study",
            "class F needs fa and fv",
            "site.api650.site_class",
            json!({ "site": { "api650": { "site_class": "F" } } }),
        ),
        accepting("accepted-without-reason", "reason", json!(" ")),
        accepting("accepted-with-a-letter", "reason", json!("x")),
        accepting("accepted-with-a-word", "reason", json!("accepted")),
        accepting("accepted-with-a-word-twice", "reason", json!("ok, ok")),
        accepting("accepted-by-nobody", "by", json!("-")),
        accepting("accepted-without-a-name", "by", Value::Null),
        accepting("accepted-without-a-date", "date", Value::Null),
        accepting("accepted-on-no-day", "date", json!("2026-02-30")),
        accepting("accepted-on-a-german-date", "date", json!("14.03.2026")),
        accepting("accepted-on-a-stamp", "date", json!("2026-03-14T00:00:00Z")),
        refused(
            "accepted-twice",
            "each limit state once",
            "accepted[1].check",
            json!({ "accepted": [gap("sliding"), gap("sliding")] }),
        ),
        refused(
            "overfull",
            "more liquid than wall",
            "liquid.fill_height",
            json!({ "liquid": { "fill_height": "11 m" } }),
        ),
        refused(
            "unknown-deciding-method",
            "no such method",
            "procedures.decide",
            json!({ "procedures": { "decide": ["ec9"] } }),
        ),
    ]
}
