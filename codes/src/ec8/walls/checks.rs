//! Checks of walls of concrete: bending with axial force, shear, crack width.

use super::lines::{self, Governing};
use super::place::{Place, Situation};
use super::section::{self, Missing};
use super::{metal, required};
use crate::ec8::limit_states::{CRACKS, DAMAGE, WALL_BENDING, WALL_SHEAR};
use crate::ec8::work::Work;
use crate::en1992::crack::{self, LASTING, SHORT, Width};
use crate::en1992::section::{Face, Section};
use crate::en1992::shear;
use tank::BarDirection;
use tank::assessment::CheckStatus;

/// Sections of the courses in both directions, hoop first.
struct Sections(Vec<[Result<Section, Missing>; 2]>);

impl Sections {
    fn of(&self, place: &Place) -> Option<&Result<Section, Missing>> {
        let pair = self.0.get(place.index)?;
        Some(&pair[usize::from(place.direction == BarDirection::Vertical)])
    }

    fn given(&self, place: &Place) -> Option<&Section> {
        self.of(place).and_then(|section| section.as_ref().ok())
    }
}

/// Writes the checks of a wall.
pub(super) fn assess(work: &mut Work, places: &[Place]) {
    let case = work.case;
    let damage = places.iter().any(|p| p.factors.situation == Situation::Damage);
    if case.tank.is_metal() {
        return metal::assess(work, places, damage);
    }
    let options = &case.procedures.concrete;
    let directions = [BarDirection::Hoop, BarDirection::Vertical];
    let of = |(index, course)| directions.map(|direction| section::of(course, index, direction, options));
    let sections = Sections(case.tank.courses.iter().enumerate().map(of).collect());
    let missing = places.iter().find_map(|p| sections.of(p).and_then(|s| s.as_ref().err()));
    if let Some(missing) = missing.cloned() {
        left_out(work, places, &sections, &missing, damage);
    }
    for direction in directions {
        bending(work, places, &sections, direction);
    }
    shear(work, places, &sections);
    cracks(work, places, &sections, Situation::Service);
    if damage {
        cracks(work, places, &sections, Situation::Damage);
    }
}

/// Something is missing: all limit states of the wall stay open, whatever the other courses give.
fn left_out(work: &mut Work, places: &[Place], sections: &Sections, missing: &Missing, damage: bool) {
    let bare: Vec<&Place> = places.iter().filter(|p| matches!(sections.of(p), Some(Err(_)))).collect();
    let mut reason = missing.reason.clone();
    // The thickness of several layers is not that of one section.
    let areas = match missing.input {
        Some(_) => required::assess(work, &bare),
        None => String::new(),
    };
    if !areas.is_empty() {
        reason = format!("{reason}; bars needed in the ultimate limit state: {areas}");
    }
    let input = missing.input.as_deref();
    work.without_comparison(WALL_BENDING.id, CheckStatus::NotChecked, &reason, input);
    for state in [WALL_SHEAR.id, CRACKS.id] {
        work.without_comparison(state, CheckStatus::NotChecked, &missing.reason, input);
    }
    if damage {
        work.without_comparison(DAMAGE.id, CheckStatus::NotChecked, &missing.reason, input);
    }
}

fn bending(work: &mut Work, places: &[Place], sections: &Sections, direction: BarDirection) {
    let mut governing: Option<Governing> = None;
    let seismic = |p: &&Place| p.direction == direction && p.factors.situation == Situation::Seismic;
    for place in places.iter().filter(seismic) {
        let Some(section) = sections.given(place) else { continue };
        // A place that its section resists with the largest utilisation so far is not worse.
        let bound = governing.as_ref().map_or(0.0, |g| g.utilisation);
        let harmless =
            bound.is_infinite() || (bound > 0.0 && place.n > 0.0 && section.resists(place.n / bound, place.m / bound));
        if harmless {
            continue;
        }
        let utilisation = section.utilisation(place.n, place.m);
        if governing.is_none() || utilisation > bound {
            governing = Some(Governing { place, section, utilisation });
        }
    }
    if let Some(governing) = governing {
        lines::bending(work, &governing);
    }
}

fn shear(work: &mut Work, places: &[Place], sections: &Sections) {
    let mut governing: Option<(Governing, Option<shear::Shear>)> = None;
    let seismic = |p: &&Place| p.factors.situation == Situation::Seismic;
    for place in places.iter().filter(seismic) {
        let (Some(section), Some(demand)) = (sections.given(place), place.shear) else { continue };
        let tension = if place.m >= 0.0 { Face::Inner } else { Face::Outer };
        let terms = shear::terms(section, place.n, tension);
        let capacity = terms.map_or(0.0, |t| lines::shear_resistance(section, &t));
        let utilisation = if capacity > 0.0 { demand / capacity } else { f64::INFINITY };
        if governing.as_ref().is_none_or(|(g, _)| utilisation > g.utilisation) {
            let worst = Governing { place, section, utilisation };
            governing = Some((worst, terms));
        }
    }
    if let Some((governing, terms)) = governing {
        lines::shear(work, &governing, terms);
    }
}

fn cracks(work: &mut Work, places: &[Place], sections: &Sections, situation: Situation) {
    let (state, duration) = match situation {
        Situation::Damage => (DAMAGE.id, SHORT),
        _ => (CRACKS.id, LASTING),
    };
    let class = work.case.procedures.concrete.tightness_class;
    if class > 1 {
        let reason = format!("not implemented: EN 1992-3 7.3.1, tightness class {class}");
        let input = "procedures.concrete.tightness_class";
        return work.without_comparison(state, CheckStatus::NotChecked, &reason, Some(input));
    }
    let mut governing: Option<(Governing, Width, f64)> = None;
    let mut unknown: Option<&Place> = None;
    for place in places.iter().filter(|p| p.factors.situation == situation) {
        let Some(section) = sections.given(place) else { continue };
        let tensile = crack::tensile_strength(section.strength);
        let Some(width) = crack::width(section, place.n, place.m, tensile, duration) else {
            // Without a diameter the width is unknown; without bars at a face the concrete must not crack there.
            if section.bars.iter().any(|b| b.diameter.is_none()) || !uncracked(section, place, tensile) {
                unknown.get_or_insert(place);
            }
            continue;
        };
        let limit = crack::limit(class, place.head, section.thickness, width.compressed);
        let utilisation = width.width / limit;
        if governing.as_ref().is_none_or(|(g, ..)| utilisation > g.utilisation) {
            let worst = Governing { place, section, utilisation };
            governing = Some((worst, width, limit));
        }
    }
    // A width that holds at other places is no verdict beside one that is not known.
    let shown = governing.filter(|(g, ..)| unknown.is_none() || g.utilisation > 1.0);
    if let Some((governing, width, limit)) = shown {
        lines::crack(work, &governing, &width, limit, duration, situation);
    }
    if let Some(place) = unknown {
        let input = section::reinforcement(place.course, place.index);
        let reason = format!(
            "a face pulls that has no bars, or bars whose diameter is not given in `{input}`: {}",
            place.describe()
        );
        work.without_comparison(state, CheckStatus::NotChecked, &reason, Some(&input));
    }
}

/// Whether the concrete does not crack: the stress of the whole section is below f_ct at both faces.
fn uncracked(section: &Section, place: &Place, tensile: f64) -> bool {
    let h = section.thickness;
    place.n / h + 6.0 * place.m.abs() / (h * h) <= tensile
}
