//! Materials that other keys name.

use files::code::Code;
use tank::keys::list;
use tank::{Behaviour, Material};

use super::grades::{self, Found};
use super::materials::{MAX_MATERIALS, MAX_NAME, Materials};
use crate::input::tank::read::{Field, nearest};
use crate::input::tank::resolver::{Resolver, range_fault};

/// Largest number of material names in a message.
const SHOWN_NAMES: usize = 20;
/// Faults among which the same one is looked for.
const REPEATED: usize = 50;

/// Use of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Use {
    /// A shell of the wall, the bottom plate.
    Shell,
    /// A layer between two shells.
    Interlayer,
    /// Bars in concrete.
    Bars,
    /// A ring around the wall.
    Ring,
}

/// The material of this name. Reports an unknown name and a material of the wrong kind, but not a material that is faulty itself.
pub(super) fn material(
    r: &mut Resolver<'_>,
    field: &Field<String>,
    materials: &Materials,
    purpose: Use,
) -> Option<Material> {
    r.echo_given(field);
    let name = field.value.as_ref()?;
    if let Some(material) = materials.get(name) {
        let material = material.clone()?;
        let (fits, what, allowed) = match (purpose, material.behaviour) {
            (Use::Shell, b) => (
                matches!(b, Behaviour::Elastic | Behaviour::Steel(_) | Behaviour::Concrete(_)),
                "a shell",
                "an elastic material, steel or concrete",
            ),
            (Use::Interlayer, b) => (
                matches!(b, Behaviour::Elastic | Behaviour::Interlayer(_)),
                "an interlayer",
                "an elastic material or one with the behaviour interlayer",
            ),
            (Use::Ring, b) => {
                (matches!(b, Behaviour::Elastic | Behaviour::Steel(_)), "a ring", "an elastic material or steel")
            }
            (Use::Bars, b) => (
                matches!(b, Behaviour::Elastic | Behaviour::Steel(_) | Behaviour::Reinforcement(_)),
                "bars",
                "an elastic material, steel or reinforcement",
            ),
        };
        if fits {
            return Some(material);
        }
        let message =
            format!("the material `{name}` is {}, which cannot be used for {what}", material.behaviour.kind());
        r.refuse(Code::UnknownChoice, field, &message, allowed);
        return None;
    }
    let short = |name: &&str| name.len() <= 4 * MAX_NAME;
    let known: Vec<&str> = (materials.keys().map(String::as_str).filter(short)).take(SHOWN_NAMES).collect();
    let allowed = match known.as_slice() {
        [] => "a name from `materials`, which is empty".into(),
        names if names.len() < materials.len() => {
            let more = materials.len() - names.len();
            format!("a name from `materials`: {} and {more} more", names.join(", "))
        }
        names => format!("a name from `materials`: {}", list(names, "or")),
    };
    let message = format!("unknown material `{name}`");
    let grade = !matches!(grades::find(name, 0.0), Found::Unknown);
    // A material that is not in the file at all is reported once, not at every course.
    let first = &mut r.faults.list().iter().take(REPEATED);
    if (grade || materials.is_empty()) && first.any(|fault| fault.message == message) {
        return None;
    }
    let mut fault = range_fault(Code::UnknownChoice, field, &message, &allowed);
    if grade {
        fault = fault.help(format!(
            "`{name}` is a grade that tankcheck has: add \"{name}\": {{ \"grade\": \"{name}\" }} to `materials`"
        ));
    } else if let Some(near) = nearest(name, materials.keys().map(String::as_str).take(MAX_MATERIALS)) {
        fault = fault.help(format!("did you mean \"{near}\"?"));
    }
    r.faults.push(fault);
    None
}
