//! The base of an unanchored tank under the largest moment of the procedures, for figures.

use codes::lifted::{Drawing, drawings, softened};
use tank::assessment::Excitation;
use tank::{Quantity, Support};

use crate::job::Job;
use results::{Method, Standing, StandingGround, StandingPlate, StandingValues, Status};

/// Plate that is kept, in lifted widths from the rim.
const KEPT: f64 = 3.0;

/// None for a tank on anchors or without a metal bottom plate, and where nothing gives a moment. Of the moments those of the site count,
/// without a site those of the record.
pub(super) fn standing(job: &Job, methods: &[Method]) -> Option<Standing> {
    if job.case.tank.support != Support::Unanchored {
        return None;
    }
    let excitation = if job.case.site.is_given() { Excitation::Site } else { Excitation::Record };
    let moments = methods.iter().filter_map(|method| {
        let computed = method.status == Status::Computed && method.excitation == excitation;
        let moment = method.quantities.get(Quantity::BaseMoment.id())?.value;
        computed.then_some((method, moment))
    });
    let (method, moment) = moments.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let tank = &job.case.tank;
    let at_rest = || tank.weight_above(0.0) * job.case.gravity / tank.perimeter();
    let weight = method.hold_down.unwrap_or_else(at_rest);
    let drawn = drawings(&job.case, moment, weight);
    if drawn.is_empty() {
        return None;
    }
    let wall = tank.courses.first()?.net_thickness();
    Some(Standing {
        moment,
        method: method.id.clone(),
        weight: Some(weight),
        softened: softened(&job.case, moment).map(|suction| [suction.share, suction.limit]),
        plate: plate(&drawn),
        grounds: drawn.into_iter().map(|drawing| ground(drawing, wall)).collect(),
    })
}

fn ground(drawing: Drawing, wall: f64) -> StandingGround {
    let values = drawing.stand.map(|(stand, _)| StandingValues {
        rotation: stand.turn.rotation,
        uplift: stand.turn.uplift,
        lifted_width: stand.rim.lifted_width,
        plastic_rotation: stand.rim.plastic_rotation,
        toe_axial_stress: stand.turn.toe_force / wall,
    });
    StandingGround { modulus: drawing.modulus, decides: drawing.decides, curve: drawing.curve, values }
}

/// The deciding ground that holds the moment and on which the rim lifts most.
fn plate(drawn: &[Drawing]) -> Option<StandingPlate> {
    let held = drawn.iter().filter(|d| d.decides).filter_map(|d| Some((d, d.stand.as_ref()?)));
    let (drawing, (stand, points)) = held.max_by(|a, b| a.1.0.turn.uplift.total_cmp(&b.1.0.turn.uplift))?;
    if stand.turn.uplift <= 0.0 {
        return None;
    }
    let kept: Vec<_> = points.iter().filter(|p| p.distance <= KEPT * stand.rim.lifted_width).collect();
    let yielded = kept.windows(2).filter(|pair| pair[0].yielded).map(|pair| [pair[0].distance, pair[1].distance]);
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    for [from, to] in yielded {
        match stretches.last_mut() {
            Some(last) if last[1] == from => last[1] = to,
            _ => stretches.push([from, to]),
        }
    }
    Some(StandingPlate {
        modulus: drawing.modulus,
        points: kept.iter().map(|p| [p.distance, p.deflection, p.pressure]).collect(),
        yielded: stretches,
    })
}
