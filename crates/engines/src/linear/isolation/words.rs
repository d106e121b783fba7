//! Notes and assumptions of a run on isolators.

/// Dashpots beside isolators.
pub(super) const DASHPOTS: &str = "`analysis.damping.dashpots` couple the modes: the march of the isolators needs uncoupled ones; remove the dashpots or the isolators";
/// Note of every run.
pub(super) const MOVES: &str = "The tank stands on isolators: values, envelopes, histories, limit states and demands of the time history are those on isolators, \
     and the section on isolation has those on a fixed base beside them. Modes, transfer functions and the response-spectrum method are those \
     on a fixed base.";
/// Vertical tension.
pub(super) fn tension(share: f64, time: f64) -> String {
    format!(
        "The outermost bearing would be in tension at {time:.2} s (its force is {share:.2} of that at rest): the model holds it down. Bearings of \
         the listed kinds do not bear tension unless they are built for it."
    )
}

/// Assumptions, one sentence each.
pub(super) fn assumptions(vertical: bool, two: bool, pendulum: bool) -> Vec<String> {
    let mut list: Vec<String> = [
        "The slab is rigid, does not rotate, and carries the tank clamped to it.",
        "Wall and liquid follow the acceleration of the slab as its march finds it. Displacements of the wall are those relative to the slab.",
        "The tank's mass on the isolators is all liquid, wall and roof; its sloshing modes move freely on the slab.",
        "Force of the outermost bearing: bearings of equal load under the whole plan of the tank, the overturning moment at the underside of the \
         slab spread over them linearly. Tension is reported, not modelled.",
        "Effective period and damping are those of a cycle to the largest displacement, with all mass; the march does not use them.",
        "Mesh errors are the relative ones of the tank on a fixed base.",
        "Lower and upper properties are two runs beside that of the nominal ones; between them nothing is run, where a demand may be larger.",
    ]
    .map(String::from)
    .to_vec();
    if pendulum {
        list.push(if vertical {
            "Friction and restoring force follow the weight under the vertical motion of the ground; overturning does not change their sum. Effective stiffness and damping are with the friction of fast sliding; the bounds scale the friction, not the radius.".into()
        } else {
            "Without a vertical record, friction and restoring force are those of the weight at rest. Effective stiffness and damping are with the friction of fast sliding; the bounds scale the friction, not the radius.".into()
        });
    }
    list.push(if two {
        "Both horizontal components act on one yield surface, a circle. Displacement and force, and all values with lower and upper properties, are those of both components; the largest values of the tank itself are those along x.".into()
    } else {
        "One horizontal component: a second one would lower the friction or yield force along the first.".into()
    });
    list
}
