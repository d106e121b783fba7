//! The family of a material: given, that of its grade, that of its behaviour, or the only one with its modulus and density.

use files::code::Code;
use tank::units::{Dimension, display_in, unit_for};
use tank::{Behaviour, Family};

use super::Material;
use super::reader::Reader;
use crate::input::tank::choice::choice;
use crate::input::tank::resolver::Resolver;

choice!(Family);

/// The family; `None` where nothing decides, which leaves the checks of a wall of this material open.
///
/// * `elastic`: Young's modulus [Pa], Poisson's ratio and density [kg/m³], NaN if faulty
pub(super) fn family(
    r: &mut Resolver<'_>,
    m: &Material,
    reader: &Reader,
    behaviour: &Behaviour,
    elastic: [f64; 3],
) -> Option<Family> {
    let path = &m.family.path;
    let word = |family: Family| {
        let written = crate::input::tank::read::FromNode::written(&family);
        written.unwrap_or_default()
    };
    let of_grade = reader.preset.as_ref().map(|preset| (preset.family, preset.name));
    let found = match (&m.family.given, of_grade, behaviour) {
        (Some(field), of_grade, _) => {
            r.echo_given(field);
            if let (Some(given), Some((own, grade))) = (field.value, of_grade)
                && given != own
            {
                let message = format!("the grade {grade} is {}", own.name());
                let allowed = format!("\"{}\", or no family beside the grade", word(own));
                r.refuse(Code::Contradiction, field, &message, &allowed);
            }
            field.value
        }
        (None, Some((own, grade)), _) => {
            r.echo_default(path, &word(own), &format!("grade {grade}"));
            Some(own)
        }
        (None, None, Behaviour::Concrete(_)) => {
            r.echo_default(path, &word(Family::Concrete), "its behaviour");
            Some(Family::Concrete)
        }
        (None, None, Behaviour::Interlayer(_)) => None,
        (None, None, _) => {
            let family = Family::inferred(elastic[0], elastic[2]);
            match family {
                Some(family) => {
                    r.echo_default(path, &word(family), "the only one with its Young's modulus and density")
                }
                None => r.echo_default(path, "not known", "several have its Young's modulus and density"),
            }
            family
        }
    };
    if let (Some(family), false) = (found, matches!(behaviour, Behaviour::Interlayer(_))) {
        unlike(r, m, family, elastic);
    }
    found
}

/// Warns of elastic values and a density that the family does not have.
fn unlike(r: &mut Resolver<'_>, m: &Material, family: Family, values: [f64; 3]) {
    let Some(ranges) = family.ranges() else { return };
    let keys = [
        (&m.youngs_modulus.path, Dimension::Stress, "Young's modulus"),
        (&m.poisson_ratio.path, Dimension::Dimensionless, "Poisson's ratio"),
        (&m.density.path, Dimension::Density, "density"),
    ];
    for (((path, dimension, name), value), (least, most)) in keys.into_iter().zip(values).zip(ranges) {
        if value.is_nan() || (least..=most).contains(&value) {
            continue;
        }
        let show = |value: f64| display_in(value, unit_for(value, dimension), 4);
        let usual = format!("usual {name} of {} is {} to {}", family.name(), show(least), show(most));
        r.unusual(path, &show(value), &usual);
    }
}
