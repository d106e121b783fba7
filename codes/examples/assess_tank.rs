//! Assesses one tank with every code procedure that covers it.
//!
//!     cargo run -p codes --example assess_tank

use tank::Quantity;
use tank::assessment::Excitation;
use tank::case::{Ec8Site, GroundType};
use tank::reference;
use tank::units::display;

fn main() {
    // Water, 1.525 m deep, in the aluminium tank of Manos & Clough (1982); SI throughout.
    let mut case = reference::broad(1000.0);
    case.site.ec8 = Some(Ec8Site {
        ground: GroundType::B,
        spectrum: 1,
        ag: 2.5,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    });
    for procedure in codes::ALL {
        let title = procedure.label().title;
        match procedure.assess(&case, Excitation::Site) {
            Ok(assessment) => {
                println!("{title}");
                for quantity in [Quantity::SloshingHeight, Quantity::BaseShear, Quantity::OverturningMoment] {
                    if let Some(value) = assessment.values.get(&quantity) {
                        println!("  {:<44} {}", quantity.title(), display(*value, quantity.dimension()));
                    }
                }
                for check in tank::check::complete(&procedure.limit_states(&case), assessment.checks) {
                    let ratio = check.ratio().map(|ratio| format!("{ratio:.2} ")).unwrap_or_default();
                    println!("  {:<44} {:?} {ratio}{}", check.name, check.status, check.reason);
                }
            }
            Err(reason) => println!("{title}\n  {reason}"),
        }
    }
}
