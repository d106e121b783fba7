//! What is observed for a picture: amplitudes of the harmonics at the levels, cells and rings of its mesh.

use results::Channel;
use results::channel::OnWall;

use super::mesh::{Mesh, elevation};
use crate::coupled::{Coupled, SparseRow};
use crate::linear::demands::between;
use crate::linear::model::Model;
use crate::linear::system::Harmonic;
use crate::probe::{ModeSelection, Probe, ProbeLine};
use crate::response::superpose::Observable;

/// Places of an amplitude among the observables: of m = 1, and of m = 0 where it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Amplitude {
    pub odd: usize,
    pub even: Option<usize>,
}

/// Amplitudes in the middle of the cells between two levels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CellRows {
    pub hoop: Option<Amplitude>,
    pub axial: Option<Amplitude>,
    pub bending: Option<Amplitude>,
    pub shear: Option<Amplitude>,
    /// None above the surface at rest.
    pub pressure: Option<Amplitude>,
}

/// Where the terms of an observable come from.
enum Source {
    /// A probe that only pictures need, in one system.
    Own(usize, Box<Probe>),
    /// Shares of the places of a line of m = 1.
    Line(OnWall, Vec<(usize, f64)>),
    /// The same of m = 0.
    EvenLine(OnWall, Vec<(usize, f64)>),
    /// A scalar of m = 1.
    Scalar(Channel),
}

/// All rows.
pub(super) struct Rows {
    sources: Vec<Source>,
    /// Radial, circumferential and axial displacement, level by level.
    pub levels: Vec<[Amplitude; 3]>,
    /// Level by level, but for the last.
    pub cells: Vec<CellRows>,
    /// Elevations, ring by ring.
    pub rings: Vec<Amplitude>,
    /// Translation and rotation of a slab on soil.
    pub slab: Option<[Amplitude; 2]>,
}

impl Rows {
    /// * `waves`: sloshing modes that count for the surface
    pub(super) fn of(model: &Model, mesh: &Mesh, waves: usize) -> Rows {
        let mut rows =
            Rows { sources: Vec::new(), levels: Vec::new(), cells: Vec::new(), rings: Vec::new(), slab: None };
        let (odd, even) = (&model.horizontal.coupled, model.vertical.as_ref().map(|h| &h.coupled));
        rows.levels = mesh
            .levels
            .iter()
            .map(|&i| {
                let of = |which: usize| {
                    move |coupled: &'_ Coupled| -> SparseRow {
                        let rows = &coupled.shape_rows;
                        match which {
                            0 => rows.wall[i].clone(),
                            1 => rows.tangential[i][1].clone(),
                            _ => rows.tangential[i][0].clone(),
                        }
                    }
                };
                [0, 1, 2].map(|which| rows.own((odd, even), &of(which), ModeSelection::All))
            })
            .collect();
        rows.rings = mesh
            .radii
            .iter()
            .map(|&r| {
                let of = |coupled: &Coupled| elevation(coupled, r).cloned().unwrap_or_default();
                rows.own((odd, even), &of, ModeSelection::FirstSloshing(waves))
            })
            .collect();
        rows.cells = mesh
            .heights
            .windows(2)
            .map(|pair| {
                let middle = 0.5 * (pair[0] + pair[1]);
                let mut line = |what| rows.on_line(model, what, middle);
                CellRows {
                    hoop: line(OnWall::Hoop),
                    axial: line(OnWall::Axial),
                    bending: line(OnWall::Bending),
                    shear: line(OnWall::Shear),
                    pressure: line(OnWall::Pressure),
                }
            })
            .collect();
        let base = [Channel::FoundationTranslation, Channel::FoundationRotation];
        if base.iter().all(|channel| odd.probe(*channel).is_some()) {
            rows.slab = Some(base.map(|channel| rows.push(Source::Scalar(channel), None)));
        }
        rows
    }

    fn push(&mut self, odd: Source, even: Option<Source>) -> Amplitude {
        let first = self.sources.len();
        self.sources.push(odd);
        let even = even.map(|source| {
            self.sources.push(source);
            first + 1
        });
        Amplitude { odd: first, even }
    }

    /// A displacement by its rows in m = 1 and m = 0.
    fn own(
        &mut self,
        (odd, even): (&Coupled, Option<&Coupled>),
        of: &dyn Fn(&Coupled) -> SparseRow,
        modes: ModeSelection,
    ) -> Amplitude {
        let probe = |coupled: &Coupled| {
            let mut displacement = vec![0.0; coupled.influence.len()];
            of(coupled).into_iter().for_each(|(i, c)| displacement[i] += c);
            Box::new(Probe { displacement, modes, ..Probe::new(Channel::BaseShear) })
        };
        self.push(Source::Own(0, probe(odd)), even.map(|coupled| Source::Own(1, probe(coupled))))
    }

    /// A line at a height; none where it does not reach or an engine does not have it.
    fn on_line(&mut self, model: &Model, what: OnWall, z: f64) -> Option<Amplitude> {
        let shares = between(&line(&model.horizontal, what)?.z, z)?;
        let even = model.vertical.as_ref().and_then(|h| line(h, what)).map(|_| Source::EvenLine(what, shares.clone()));
        Some(self.push(Source::Line(what, shares), even))
    }

    /// The observables, in the order of the places of the amplitudes.
    pub(super) fn observables<'a>(&'a self, model: &'a Model) -> Vec<Observable<'a>> {
        let turned = model.turned.as_ref().map(|_| 1 + usize::from(model.vertical.is_some()));
        let of = |source: &'a Source| -> Observable<'a> {
            match source {
                // The same row under the rotation of the base, whose system has the unknowns of m = 1.
                Source::Own(0, probe) => {
                    std::iter::once(0).chain(turned).map(|system| (system, 1.0, &**probe)).collect()
                }
                Source::Own(system, probe) => vec![(*system, 1.0, &**probe)],
                Source::Line(what, shares) => {
                    let line = line(&model.horizontal, *what);
                    let terms = line.map(|line| shares.iter().flat_map(|(i, c)| model.odd_on_line(line, *i, *c)));
                    terms.map_or_else(Vec::new, Iterator::collect)
                }
                Source::EvenLine(what, shares) => {
                    let line = model.vertical.as_ref().and_then(|h| line(h, *what));
                    let terms = line.map(|line| shares.iter().map(|(i, c)| (1, *c, &line.probes[*i])));
                    terms.map_or_else(Vec::new, Iterator::collect)
                }
                Source::Scalar(channel) => {
                    model.horizontal.coupled.probe(*channel).map_or_else(Vec::new, |probe| model.odd(probe))
                }
            }
        };
        self.sources.iter().map(of).collect()
    }
}

/// A line over the height, the membrane shear among them.
fn line(harmonic: &Harmonic, what: OnWall) -> Option<&ProbeLine> {
    let coupled = &harmonic.coupled;
    coupled.lines.iter().chain(&coupled.shear).find(|line| line.what == what)
}
