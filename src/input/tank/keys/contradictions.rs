//! Values that describe the same thing and do not agree: each is used where it stands, with a warning.
//!
//! Pairs that cannot both be true in any method are faults, next to their keys; these are the doubtful ones.

use tank::case::{Api650Site, Case, Ec8Site, GroundType, Site, SiteClass};
use tank::check::TankPart;
use tank::units::{Dimension, display};
use tank::{FoundationKind, RoofKind, STANDARD_GRAVITY, Shape, Snow, Support, Tank};

use crate::input::tank::resolver::Resolver;

/// Shear waves at the strains of an earthquake are slower than at rest, by EN 1998-5 table 4.1 down to 0.6 of them.
const SLOWER: f64 = 0.5;
/// Factor between two design accelerations from which they are not those of one site.
const APART: f64 = 2.0;
/// Density of concrete [kg/m³].
const CONCRETE: f64 = 2500.0;

/// Shear wave velocities of a ground type [m/s], EN 1998-1 table 3.1; E is a layer of C or D on rock.
fn of_type(ground: GroundType) -> (f64, f64) {
    match ground {
        GroundType::A => (800.0, f64::INFINITY),
        GroundType::B => (360.0, 800.0),
        GroundType::C => (180.0, 360.0),
        GroundType::D => (0.0, 180.0),
        GroundType::E => (0.0, 360.0),
    }
}

/// Shear wave velocities of a site class [m/s], ASCE 7 table 20.3-1; none of class F.
fn of_class(class: SiteClass) -> Option<(f64, f64)> {
    match class {
        SiteClass::A => Some((1500.0, f64::INFINITY)),
        SiteClass::B => Some((760.0, 1500.0)),
        SiteClass::C => Some((360.0, 760.0)),
        SiteClass::D => Some((180.0, 360.0)),
        SiteClass::E => Some((0.0, 180.0)),
        SiteClass::F => None,
    }
}

/// All pairs.
///
/// * `without`: parts of the tank that the file says there are none of
pub(super) fn warn(r: &mut Resolver<'_>, case: &Case, without: &[TankPart]) {
    let (tank, site) = (&case.tank, &case.site);
    ground(r, tank, site);
    if let (Some(ec8), Some(api)) = (&site.ec8, &site.api650) {
        sites(r, site, ec8, api);
    }
    if let Some(api) = &site.api650 {
        mapped(r, site, api);
    }
    strengths(r, tank);
    top(r, tank);
    base(r, tank, site);
    ring(r, tank);
    if tank.support == Support::Anchored && tank.anchors.is_some() && without.contains(&TankPart::Foundation) {
        let text =
            "tank.anchors and tank.foundation contradict each other: anchors hold to a foundation, and there is none";
        r.inconsistent(text.into());
    }
    pressures(r, tank, site);
}

/// The ground by its type, class and shear waves.
fn ground(r: &mut Resolver<'_>, tank: &Tank, site: &Site) {
    let own = site.spectrum.is_some();
    let ground = site.ec8.filter(|_| !own).map(|ec8| ec8.ground);
    let class = site.api650.filter(|api| api.ss > 0.0).map(|api| api.site_class);
    if let Some(velocity) = tank.foundation.and_then(|f| f.shear_wave_velocity) {
        let found = display(velocity, Dimension::Velocity);
        let outside = |(least, most): (f64, f64)| velocity < SLOWER * least || velocity > most;
        let range = |(least, most): (f64, f64)| match most.is_finite() {
            true => format!("{least} to {most} m/s"),
            false => format!("{least} m/s and more"),
        };
        if let Some(ground) = ground.filter(|ground| outside(of_type(*ground))) {
            r.inconsistent(format!(
                "tank.foundation.shear_wave_velocity and site.ec8.ground contradict each other: {found}, and ground type {ground:?} with {}",
                range(of_type(ground))
            ));
        }
        if let Some((class, limits)) = class.and_then(|c| Some((c, of_class(c)?)))
            && outside(limits)
        {
            r.inconsistent(format!(
                "tank.foundation.shear_wave_velocity and site.api650.site_class contradict each other: {found}, and site class {class:?} \
                 with {}",
                range(limits)
            ));
        }
    }
    if let (Some(ground), Some((class, limits))) = (ground, class.and_then(|c| Some((c, of_class(c)?)))) {
        let types = of_type(ground);
        // They meet in a point alone, or not at all.
        if types.0.max(limits.0) >= types.1.min(limits.1) {
            r.inconsistent(format!(
                "site.ec8.ground and site.api650.site_class contradict each other: ground type {ground:?} and site class {class:?} have no \
                 shear wave velocity in common"
            ));
        }
    }
}

/// One site under two codes.
fn sites(r: &mut Resolver<'_>, site: &Site, ec8: &Ec8Site, api: &Api650Site) {
    if site.spectrum.is_none() {
        let (own, mapped) = (ec8.ag / STANDARD_GRAVITY, 0.4 * api.q * api.ss);
        if mapped > 0.0 && !(1.0 / APART..=APART).contains(&(own / mapped)) {
            r.inconsistent(format!(
                "site.ec8.ag and site.api650.ss contradict each other: a_gR = {own:.3} g, and 0.4 Q S_s = {mapped:.3} g, the design peak \
                 acceleration on rock"
            ));
        }
    }
    let important = (ec8.importance >= 1.4 && api.sug == 1) || (ec8.importance < 1.0 && api.sug == 3);
    if important {
        r.inconsistent(format!(
            "site.ec8.importance and site.api650.sug contradict each other: γ_I = {}, and seismic use group {}",
            ec8.importance, api.sug
        ));
    }
    if let (Some(one), Some(other)) = (ec8.bearing_capacity, api.bearing_capacity)
        && !(1.0 / 3.0..=3.0).contains(&(one / other))
    {
        r.inconsistent(format!(
            "site.ec8.bearing_capacity and site.api650.bearing_capacity contradict each other: {} and {} of one ground",
            display(one, Dimension::Stress),
            display(other, Dimension::Stress)
        ));
    }
}

/// Values of the map among themselves, and beside the user's spectrum.
fn mapped(r: &mut Resolver<'_>, site: &Site, api: &Api650Site) {
    if api.s1 > api.ss {
        r.inconsistent(format!(
            "site.api650.s1 and site.api650.ss contradict each other: S_1 = {} g is more than S_s = {} g",
            api.s1, api.ss
        ));
    }
    if let Some(s0) = api.s0.filter(|_| api.ss > 0.0)
        && !(0.5..=1.75).contains(&(s0 / (0.4 * api.ss)))
    {
        r.inconsistent(format!(
            "site.api650.s0 and site.api650.ss contradict each other: S_0 = {s0} g, and 0.4 S_s = {:.3} g",
            0.4 * api.ss
        ));
    }
    if let Some(own) = &site.spectrum
        && api.ss > 0.0
    {
        let longest = codes::hazard::longest(own);
        let plateau = codes::hazard::elastic(own, 1.0, 0.05)(0.2f64.min(longest)) / STANDARD_GRAVITY;
        let design = api.q * api.fa.unwrap_or(1.0) * api.ss;
        if !(0.25..=4.0).contains(&(plateau / design)) {
            r.inconsistent(format!(
                "site.spectrum and site.api650.ss contradict each other: {plateau:.3} g at 0.2 s, and Q F_a S_s near {design:.3} g"
            ));
        }
    }
}

/// Strengths of one material.
fn strengths(r: &mut Resolver<'_>, tank: &Tank) {
    let plate = tank.bottom.as_ref().map(|bottom| &bottom.material);
    let mut seen: Vec<&str> = Vec::new();
    for material in tank.wall_materials().chain(plate) {
        if seen.contains(&material.name.as_str()) {
            continue;
        }
        seen.push(&material.name);
        if let (Some(allowable), Some(yielding)) = (material.allowable_stress, material.yield_strength)
            && allowable > 0.9 * yielding * (1.0 + 1e-9)
        {
            r.inconsistent(format!(
                "materials.{0}.allowable_stress and materials.{0}.yield_strength contradict each other: {1} is more than 0.9 of {2}",
                material.name,
                display(allowable, Dimension::Stress),
                display(yielding, Dimension::Stress)
            ));
        }
    }
}

/// Roof and snow.
fn top(r: &mut Resolver<'_>, tank: &Tank) {
    let roof = &tank.roof;
    let snow = tank.details.snow;
    if snow == Some(Snow::Included) && roof.mass == 0.0 {
        let text =
            "tank.roof.snow and tank.roof.mass contradict each other: snow is included, and the wall carries no mass";
        r.inconsistent(text.into());
    }
    let load = roof.mass / tank.shape.plan_area();
    if roof.kind == RoofKind::Open && load > 100.0 {
        r.inconsistent(format!(
            "tank.roof.type and tank.roof.mass contradict each other: the tank is open, and its girders weigh {load:.0} kg per m² of plan"
        ));
    }
}

/// A ring wall and what stands on it.
fn ring(r: &mut Resolver<'_>, tank: &Tank) {
    let Some(foundation) = tank.foundation.filter(|f| f.kind == FoundationKind::RingWall) else { return };
    let Shape::Cylinder { radius } = tank.shape else {
        let text = "tank.foundation.kind and tank.shape contradict each other: a ring wall under a rectangle";
        return r.inconsistent(text.into());
    };
    let Some(width) = foundation.width else { return };
    let wall = tank.courses.first().map_or(0.0, |course| course.thickness);
    let what = match width {
        width if width > 2.0 * radius => "its inner face lies beyond the middle of the tank",
        width if width < wall => "the wall is thicker than the ring under it",
        _ => return,
    };
    r.inconsistent(format!(
        "tank.foundation.width and the tank contradict each other: a ring of {}, {what}",
        display(width, Dimension::Length)
    ));
}

/// Foundation, friction, anchors.
fn base(r: &mut Resolver<'_>, tank: &Tank, site: &Site) {
    if let Some(foundation) = &tank.foundation {
        if let (FoundationKind::Slab, Some(thickness), Some(weight)) =
            (foundation.kind, foundation.thickness, site.api650.and_then(|api| api.foundation_weight))
        {
            let slab = CONCRETE * STANDARD_GRAVITY * tank.shape.plan_area() * thickness;
            // A slab is wider than the tank, and soil lies on it.
            if weight < 0.8 * slab || weight > 5.0 * slab {
                r.inconsistent(format!(
                    "tank.foundation.thickness and site.api650.foundation_weight contradict each other: a slab of {} under the tank alone \
                     weighs {}, and {} are given",
                    display(thickness, Dimension::Length),
                    display(slab, Dimension::Force),
                    display(weight, Dimension::Force)
                ));
            }
        }
        let design = [
            ("site.ec8.friction", site.ec8.and_then(|ec8| ec8.friction)),
            ("site.api650.friction", site.api650.map(|api| api.friction)),
        ];
        for (path, value) in design {
            if let (Some(value), Some(mean)) = (value, foundation.friction)
                && value > mean * (1.0 + 1e-9)
            {
                r.inconsistent(format!(
                    "{path} and tank.foundation.friction contradict each other: the design value {value} is more than the mean {mean}"
                ));
            }
        }
    }
    if let Some(anchors) = &tank.anchors {
        let pairs = [
            ("attachment_capacity", anchors.attachment_capacity, "an anchor holds more than its attachment"),
            ("yield_force", anchors.yield_force, "an anchor yields below its design capacity"),
        ];
        for (key, value, what) in pairs {
            if let (Some(value), Some(capacity)) = (value, anchors.capacity)
                && value < capacity * (1.0 - 1e-9)
            {
                r.inconsistent(format!(
                    "tank.anchors.{key} and tank.anchors.capacity contradict each other: {what}, {} and {}",
                    display(value, Dimension::Force),
                    display(capacity, Dimension::Force)
                ));
            }
        }
    }
    if let (Support::Unanchored, Some(true)) =
        (tank.support, tank.bottom.as_ref().map(|plate| !plate.material.is_metal()))
        && tank.is_metal()
    {
        let text = "tank.bottom.material and tank.courses contradict each other: the wall is metal and its bottom plate is not";
        r.inconsistent(text.into());
    }
}

/// Gas above the liquid.
fn pressures(r: &mut Resolver<'_>, tank: &Tank, site: &Site) {
    if let Some(api) = &site.api650
        && api.design_pressure < tank.pressure.internal
    {
        r.inconsistent(format!(
            "site.api650.design_pressure and tank.pressure.internal contradict each other: the design pressure {} is less than that in \
             operation, {}",
            display(api.design_pressure, Dimension::Stress),
            display(tank.pressure.internal, Dimension::Stress)
        ));
    }
    let closed = tank.roof.kind.is_fixed();
    if !closed && !tank.pressure.is_none() {
        let text = "tank.pressure and tank.roof.type contradict each other: gas needs a fixed roof above the liquid";
        r.inconsistent(text.into());
    }
}
