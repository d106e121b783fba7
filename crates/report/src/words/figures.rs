//! Captions and descriptions of the figures.

use tank::units::Dimension;
use tank::{Liquid, Tank};

use crate::number::{count, fixed, given, percent, plain, significant, with_unit};
use results::nonlinear::{CrackPicture, Loop};
use results::{Envelope, Mode, SeriesInfo};

/// A value and its time [s].
pub type At = (f64, f64);

/// Description of bars: a quantity by method, values in one unit.
pub fn by_method(title: &str, values: &str, unit: &str) -> String {
    format!("{title} by method: {values} {unit}.")
}

/// Caption of bars under the spectrum of the `site`, or under the record.
///
/// * `overtops`: whether a wave is higher than the freeboard
///
/// * `divided`: which methods divide, and by what, in sentences; empty if none does
pub fn by_methods(site: bool, overtops: bool, divided: &str) -> String {
    let methods = if site { "By method, site." } else { "By method, record." };
    match (overtops, divided) {
        (true, _) => format!(
            "{methods} Waves with * are higher than the freeboard: no method follows one that strikes the roof or overtops the wall."
        ),
        (false, "") => methods.into(),
        (false, divided) => format!("{methods} {divided}"),
    }
}

/// What the mark of divided values means for one method.
///
/// * `by`: "R_wi = 4, R_wc = 2"
pub fn divided(method: &str, by: &str) -> String {
    format!("Values with †, {method}: divided by {by}.")
}

/// Mark at the peak of a history.
pub fn peak(value: f64, dimension: Dimension, time: f64) -> String {
    format!("{} at {} s", with_unit(value, dimension), fixed(time, 2))
}

/// Caption of a history without its static value; `between` is whether the peak lies between the samples.
pub fn history(static_value: f64, dimension: Dimension, between: bool) -> String {
    let mut caption = String::from("The largest value is marked.");
    if static_value != 0.0 {
        caption.push_str(&format!(" Seismic part, without the static value {}.", with_unit(static_value, dimension)));
    }
    if between {
        caption.push_str(" The largest value lies between the samples drawn.");
    }
    caption
}

/// Description of a history that ends at `end` [s].
pub fn history_description(title: &str, dimension: Dimension, end: f64, highest: At, lowest: At) -> String {
    format!(
        "{title} over {} s. Largest {} at {} s, smallest {} at {} s.",
        fixed(end, 1),
        with_unit(highest.0, dimension),
        fixed(highest.1, 2),
        with_unit(lowest.0, dimension),
        fixed(lowest.1, 2)
    )
}

/// Caption of two histories: `part` is their largest difference over the largest value, `end` the end of a run that stops
/// early [s].
pub fn overlay(part: f64, run: &str, end: Option<f64>) -> String {
    let mut caption = format!("Samples differ by at most {} of the largest.", percent(part));
    if let Some(end) = end {
        caption.push_str(&format!(" The {run} run ends at {} s.", fixed(end, 2)));
    }
    caption
}

/// Description of two histories with their largest samples.
pub fn overlay_description(info: &SeriesInfo, names: [&str; 2], largest: [f64; 2]) -> String {
    let [a, b] = names;
    format!(
        "{} over time by the {a} and the {b} engine; largest sample {} and {}.",
        info.title,
        with_unit(largest[0], info.dimension),
        with_unit(largest[1], info.dimension)
    )
}

/// Description of a mode shape.
pub fn mode(mode: &Mode) -> String {
    format!(
        "Section through the tank with the surface and the wall displaced in the {} mode number {} of harmonic {}, period {} s.",
        mode.kind,
        mode.number,
        mode.harmonic,
        significant(mode.period, 4)
    )
}

/// Titles, captions and descriptions of the spectra.
pub mod spectra {
    use crate::number::plain;

    /// Title of the linear plot.
    pub const LINEAR: &str = "Pseudo-acceleration spectra";
    /// Its caption.
    pub const LINEAR_CAPTION: &str = "Vertical lines: periods of the tank (c sloshing, i structural).";
    /// Title of the logarithmic plot.
    pub const FOUR_WAY: &str = "Four-way logarithmic spectra";
    /// Its caption.
    pub const FOUR_WAY_CAPTION: &str = "Pseudo-velocity upwards; falling lines of equal displacement, rising lines of equal \
                                        pseudo-acceleration.";

    /// Description of the linear plot of `count` spectra up to the period `end` [s].
    pub fn linear(end: f64, count: usize) -> String {
        format!("Pseudo-acceleration over period up to {} s for {count} spectra.", plain(end, 2))
    }

    /// Description of the logarithmic plot.
    pub fn four_way(count: usize) -> String {
        format!("Tripartite plot of {count} spectra on logarithmic axes.")
    }
}

/// Description of profiles over the height; `engine` is whether the envelope of the finite elements is drawn.
pub fn profiles(title: &str, engine: bool, procedures: usize) -> String {
    let envelope = if engine { "envelope of the finite elements and " } else { "" };
    format!("{title} over the height: {envelope}{procedures} procedures.")
}

/// Title of the seismic part of profiles.
pub fn seismic_part(title: &str) -> String {
    format!("{title}, seismic part")
}

/// Title and description of an envelope with its static state.
pub fn combined(envelope: &Envelope) -> [String; 2] {
    [
        format!("{}, finite elements with static state", envelope.title),
        format!("{} over the height: static state and the range with the earthquake.", envelope.title),
    ]
}

/// Caption of the sketch; `exaggeration` is the factor on the thickness of the wall, `raised` a tank on a staging.
pub fn sketch(exaggeration: f64, raised: bool) -> String {
    if raised {
        "Section and plan; the height of the staging and the thickness of the wall are not to scale.".into()
    } else if exaggeration > 1.0 {
        format!("Section and plan to one scale; wall thickness exaggerated {}×.", plain(exaggeration, 0))
    } else {
        "Section and plan to one scale.".into()
    }
}

/// Description of the sketch.
pub fn sketch_description(plan: &str, support: &str, tank: &Tank, liquid: &Liquid) -> String {
    format!(
        "Section through the tank ({plan}, {support}), wall {} high in {} courses, liquid {} deep.",
        given(tank.wall_height(), Dimension::Length),
        tank.courses.len(),
        given(liquid.fill_height, Dimension::Length)
    )
}

/// Waves around an imperfect wall.
pub mod around {
    use super::*;
    use results::{Around, BaseAround};

    /// Amplitudes of the displacement.
    pub const DISPLACEMENT: &str = "Radial displacement";
    /// Amplitudes of the stress.
    pub const STRESS: &str = "Axial membrane stress at the base";
    /// Title of the stress around the base.
    pub const BASE: &str = "Axial membrane stress around the base, range over time";
    /// Horizontal axis of amplitudes.
    pub const WAVES: &str = "Waves around the tank n";
    /// The range in a legend.
    pub const RANGE: &str = "all waves";
    /// The wave n = 1 in a legend.
    pub const FIRST: &str = "n = 1 alone";

    /// Heading of a run.
    pub fn engine(name: &str) -> String {
        format!("By the {name} engine")
    }

    /// Deviation and largest waves in a sentence or two.
    pub fn summary(around: &Around) -> String {
        let mut out = format!(
            "Largest deviation {} ({} thicknesses) at θ = {:.0}°, z = {}.",
            with_unit(around.deviation, Dimension::Length),
            significant(around.over_thickness, 3),
            around.theta.to_degrees(),
            with_unit(around.z, Dimension::Length)
        );
        if let Some((displacement, n)) = around.largest_beyond() {
            out += &format!(" Largest wave beyond n = 1: {} in n = {n}.", with_unit(displacement, Dimension::Length));
        }
        if let Some(ring) = &around.base {
            let (stress, theta) = ring.largest();
            out += &format!(
                " Largest axial membrane stress around the base {} at θ = {:.0}°.",
                with_unit(stress, Dimension::Stress),
                theta.to_degrees()
            );
        }
        out
    }

    /// Description of amplitudes by n.
    pub fn bars(title: &str) -> String {
        format!("{title}: largest amplitude of each number of waves around the tank.")
    }

    /// Description of the stress around the base.
    pub fn base(ring: &BaseAround) -> String {
        let (stress, theta) = ring.largest();
        format!(
            "Smallest and largest seismic axial membrane stress at the base by angle; largest {} at {:.0}°.",
            with_unit(stress, Dimension::Stress),
            theta.to_degrees()
        )
    }
}

/// The three-dimensional run.
pub mod spatial {
    use super::*;

    /// Title of the mesh.
    pub const MESH: &str = "Mesh of wall and free surface";

    /// Description of the mesh; `eye` is from where it is seen, `elements` those of wall and surface.
    pub fn mesh(eye: &str, elements: [usize; 2]) -> String {
        format!(
            "The tank {eye}: {} elements of the wall, {} of the free surface.",
            count(elements[0]),
            count(elements[1])
        )
    }

    /// Description of a mode; `waves` is the circumferential wave number of a cylinder, `parts` are the largest displacements of wall and
    /// surface over the largest.
    pub fn mode(frequency: f64, waves: Option<u32>, eye: &str, parts: [f64; 2]) -> String {
        let waves = waves.map_or(String::new(), |n| format!("circumferential wave number {n}, "));
        format!(
            "Mode shape at {} Hz, {waves}{eye}; largest displacement of the wall {}, of the free \
             surface {} of the largest.",
            significant(frequency, 4),
            percent(parts[0]),
            percent(parts[1])
        )
    }

    /// Factors on the displacements of wall and surface.
    pub fn factors(wall: &str, surface: &str) -> String {
        format!("Displacements of the wall × {wall}, of the free surface × {surface}")
    }

    /// Caption of a deformed shape.
    pub fn moment(factors: &str) -> String {
        format!("{factors}; dashed: undeformed.")
    }

    /// Description of a deformed shape; `largest` are the displacements of wall and surface [m].
    pub fn moment_description(eye: &str, factors: &str, largest: [f64; 2]) -> String {
        format!(
            "Deformed tank {eye}. {factors}. Largest displacement of the wall {}, of the free surface {}.",
            with_unit(largest[0], Dimension::Length),
            with_unit(largest[1], Dimension::Length)
        )
    }

    /// From where a picture is seen [°].
    pub fn eye(beside: f64, above: f64) -> String {
        format!("seen from {}° from the x axis and {}° above the horizon", plain(beside, 0), plain(above, 0))
    }
}

/// The developed wall.
pub mod wall {
    use super::*;

    fn at(time: Option<f64>) -> String {
        time.map_or(String::new(), |t| format!(" at t = {} s", fixed(t, 3)))
    }

    /// Caption of a map, at a time [s].
    pub fn map(time: Option<f64>, walls: bool) -> String {
        match walls {
            false => format!("Developed wall{}.", at(time)),
            true => format!(
                "Developed walls{}; s runs from the middle of the wall at +x towards +y, vertical lines are corners.",
                at(time)
            ),
        }
    }

    /// Description of a map, at a time [s], with its extremes and their places.
    pub fn map_description((title, walls): (&str, bool), time: Option<f64>, largest: &str, smallest: &str) -> String {
        let around = if walls { "position" } else { "angle" };
        format!("{title} over {around} and height of the wall{}: largest {largest}; smallest {smallest}.", at(time))
    }

    /// How far the cells of a map pass its mark: `beyond` of `all`.
    pub fn mark(mark: &str, beyond: usize, all: usize) -> String {
        match beyond {
            0 => format!("{mark} is reached nowhere."),
            some if some == all => format!("{mark} is reached everywhere."),
            some => {
                format!("Double line: {mark}; {} of the cells are at or above it.", percent(some as f64 / all as f64))
            }
        }
    }

    /// A map with one value everywhere, or none.
    pub fn uniform(title: &str, value: Option<&str>) -> String {
        match value {
            None => format!("{title}: zero everywhere."),
            Some(value) => format!("{title}: {value} everywhere."),
        }
    }

    /// Description of a map of cells with its extremes and their places.
    pub fn cells(title: &str, largest: [&str; 2], smallest: [&str; 2]) -> String {
        format!(
            "{title} in the cells of the developed wall: largest {} at {}; smallest {} at {}.",
            largest[0], largest[1], smallest[0], smallest[1]
        )
    }

    /// Caption of a crack picture; `widest` is a width with its unit.
    pub fn cracks(open: usize, closed: usize, widest: &str, mirrored: bool) -> String {
        let mirrored = if mirrored { " Computed from 0° to 180°; the other half is its mirror image." } else { "" };
        format!("{} open, {} closed; widest {widest}.{mirrored}", count(open), count(closed))
    }

    /// Description of a crack picture: `open` cracks, `cells` of the wall, lowest and highest edge [m].
    pub fn cracks_description(picture: &CrackPicture, when: &str, open: usize, cells: usize, z: [f64; 2]) -> String {
        let face = match picture.face.as_str() {
            "" => "wall",
            face => face,
        };
        format!(
            "Cracks of the {face} on the developed wall, {when}: {} cracks in {} cells, {} of them open, from z = {} to {}.",
            count(picture.cracks.len()),
            count(cells),
            count(open),
            with_unit(z[0], Dimension::Length),
            with_unit(z[1], Dimension::Length)
        )
    }

    /// A picture without cracks.
    pub fn no_crack(face: &str, when: &str) -> String {
        format!("{face}: no crack, {when}.")
    }

    /// Caption of the table of the widest cracks.
    pub fn widest(listed: usize, all: usize) -> String {
        format!("The {listed} widest of {}", count(all))
    }

    /// A class of crack widths [mm].
    pub fn width(class: usize, classes: &[f64]) -> String {
        let mm = |i: usize| plain(1e3 * classes[i], 2);
        match class {
            0 => format!("up to {} mm", mm(0)),
            over if over == classes.len() => format!("over {} mm", mm(over - 1)),
            i => format!("to {} mm", mm(i)),
        }
    }
}

/// Curves of a nonlinear run.
pub mod nonlinear {
    use super::*;

    /// Title of the energies.
    pub const ENERGIES: &str = "Energy over time";

    /// Caption of the energies; `error` is the largest residual over the largest energy.
    pub fn energies(error: f64) -> String {
        format!(
            "Internal: stored and dissipated in the wall. Work of the loads less all others leaves at most {} of the largest.",
            percent(error)
        )
    }

    /// Description of the energies at the end [s]: work of the loads, damping, materials, time integration [J].
    pub fn energies_description(end: f64, work: f64, [damping, materials, integration]: [f64; 3]) -> String {
        let energy = |value| with_unit(value, Dimension::Energy);
        format!(
            "Energies over {} s: work of the loads {} at the end, dissipated by damping {}, by the materials {}, by the time \
             integration {}.",
            fixed(end, 1),
            energy(work),
            energy(damping),
            energy(materials),
            energy(integration)
        )
    }

    /// Caption of a loop with its extents.
    pub fn extents(curve: &Loop, x: (f64, f64), y: (f64, f64)) -> String {
        format!(
            "From {} to {}, from {} to {}.",
            with_unit(x.0, curve.x.dimension),
            with_unit(x.1, curve.x.dimension),
            with_unit(y.0, curve.y.dimension),
            with_unit(y.1, curve.y.dimension)
        )
    }

    /// Description of a loop.
    pub fn extents_description(curve: &Loop, x: (f64, f64), y: (f64, f64)) -> String {
        format!(
            "{} over {}: from {} to {} over {} to {}.",
            crate::words::capital(&curve.y.title),
            curve.x.title,
            with_unit(y.0, curve.y.dimension),
            with_unit(y.1, curve.y.dimension),
            with_unit(x.0, curve.x.dimension),
            with_unit(x.1, curve.x.dimension)
        )
    }

    /// Caption and description of an envelope; `largest` absolute values of the nonlinear and of the linear run.
    pub fn envelope(envelope: &Envelope, largest: f64, linear: Option<f64>) -> [String; 2] {
        let unit = |value| with_unit(value, envelope.dimension);
        let beside = linear.map_or(String::new(), |l| format!(", linear {}", unit(l)));
        let largest = unit(largest);
        [
            format!("Smallest and largest seismic value over time; largest absolute value {largest}{beside}."),
            format!(
                "{} over the height: smallest and largest value over time of the nonlinear run, largest absolute value \
                 {largest}{beside}.",
                envelope.title
            ),
        ]
    }
}
