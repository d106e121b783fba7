//! Files that a long analysis is resumed from.
//!
//! ```text
//! magic "TANKSTOP" | version u32 | identity u64 | length u64 | payload | checksum u64
//! ```
//!
//! Little-endian throughout; numbers are stored bit by bit, so that a resumed run is the uninterrupted one to the last
//! digit. The **identity** is a hash of the key that the caller gives, which represents all input of the analysis: a
//! file of another analysis is rejected. Checksum and identity are FNV-1a (Fowler, Noll & Vo 1991): they detect accidents, not
//! forgeries. A file is written next to its target and renamed, so that a crash
//! leaves the old one; the remains of an interrupted write are replaced by the next.

use std::fs::{self, File};
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};

use crate::state::State;

/// First bytes of a file.
pub const MAGIC: [u8; 8] = *b"TANKSTOP";
/// Version of the format.
pub const VERSION: u32 = 13;
/// Bytes before the payload.
const HEAD: usize = 8 + 4 + 8 + 8;

/// A file that cannot be written, read or used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CheckpointError {
    /// The file system failed.
    #[error("checkpoint {path}: {reason}")]
    File {
        /// File.
        path: String,
        /// Message of the operating system.
        reason: String,
    },
    /// No checkpoint.
    #[error("no checkpoint: it does not begin as one")]
    Magic {
        /// First bytes.
        found: Vec<u8>,
    },
    /// Another version of the program wrote it.
    #[error("written by another version of the program: format {found}, this one reads format {VERSION}")]
    Version {
        /// Version found.
        found: u32,
    },
    /// It belongs to another model, other settings or another record.
    #[error("of another run: the tank, the record, an option or the program has changed since it was written")]
    Identity {
        /// Identity found.
        found: u64,
        /// That of this analysis.
        allowed: u64,
    },
    /// Truncated or longer than it should be.
    #[error("{}: it has {found} bytes instead of {allowed}", if found < allowed { "truncated" } else { "longer than written" })]
    Length {
        /// Bytes found.
        found: u64,
        /// Bytes that there should be.
        allowed: u64,
    },
    /// Damaged.
    #[error("damaged: its content does not fit its checksum")]
    Checksum {
        /// Checksum found.
        found: u64,
        /// That of the payload.
        allowed: u64,
    },
    /// A payload that does not fit the analysis.
    #[error("damaged: {what} has {found} entries instead of {allowed}")]
    Shape {
        /// Part of the payload.
        what: &'static str,
        /// Entries found.
        found: usize,
        /// Entries allowed.
        allowed: usize,
    },
    /// A value that no run writes.
    #[error("damaged: {what} is {found}, allowed {allowed}")]
    Value {
        /// Part of the payload.
        what: &'static str,
        /// Value found.
        found: f64,
        /// Values allowed.
        allowed: &'static str,
    },
    /// A file from which this analysis cannot continue.
    #[error("checkpoint {path} cannot be used: {cause}")]
    Unusable {
        /// File.
        path: String,
        /// What is wrong with it.
        cause: Box<CheckpointError>,
    },
}

impl CheckpointError {
    /// The same with the file that it is about.
    pub fn of(self, path: &Path) -> CheckpointError {
        match self {
            CheckpointError::File { .. } | CheckpointError::Unusable { .. } => self,
            cause => CheckpointError::Unusable { path: path.display().to_string(), cause: Box::new(cause) },
        }
    }

    /// What is wrong, without the file.
    pub fn cause(&self) -> &CheckpointError {
        match self {
            CheckpointError::Unusable { cause, .. } => cause,
            other => other,
        }
    }
}

/// Where a checkpoint is written until it is complete.
pub fn unfinished(path: &Path) -> PathBuf {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    beside.into()
}

/// Checks that a file is an undamaged checkpoint of this version, of any analysis.
///
/// Errors: the file system's; not a checkpoint, another version, truncated, damaged.
pub fn inspect(path: &Path) -> Result<(), CheckpointError> {
    read(path).map(|_| ()).map_err(|e| e.of(path))
}

/// Identity and payload of a sound file.
fn read(path: &Path) -> Result<(u64, Vec<u8>), CheckpointError> {
    let failed = |e: std::io::Error| CheckpointError::File { path: path.display().to_string(), reason: e.to_string() };
    let mut all = Vec::new();
    File::open(path).map_err(failed)?.read_to_end(&mut all).map_err(failed)?;
    if !all.starts_with(&MAGIC) {
        let found = all[..all.len().min(MAGIC.len())].to_vec();
        return Err(CheckpointError::Magic { found });
    }
    let size = all.len() as u64;
    // Whatever is missing of a head that ends early.
    let short = |_| CheckpointError::Length { found: size, allowed: HEAD as u64 + 8 };
    let mut head = Reader { bytes: all, at: MAGIC.len() };
    let version = u32::from_le_bytes(head.take("version").map_err(short)?);
    if version != VERSION {
        return Err(CheckpointError::Version { found: version });
    }
    let identity = u64::from_le_bytes(head.take("identity").map_err(short)?);
    let length = u64::from_le_bytes(head.take("length").map_err(short)?);
    let allowed = length.saturating_add(HEAD as u64 + 8);
    if size != allowed {
        return Err(CheckpointError::Length { found: size, allowed });
    }
    let payload = head.bytes[HEAD..HEAD + length as usize].to_vec();
    head.at = HEAD + length as usize;
    let found = u64::from_le_bytes(head.take("checksum")?);
    let mut hash = Hash::default();
    hash.bytes(&payload);
    if found != hash.value() {
        return Err(CheckpointError::Checksum { found, allowed: hash.value() });
    }
    Ok((identity, payload))
}

/// FNV-1a over bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Hash {
        Hash(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Takes bytes in.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for b in bytes {
            self.0 = (self.0 ^ u64::from(*b)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Takes numbers and their count in.
    pub fn numbers(&mut self, values: &[f64]) {
        self.count(values.len());
        values.iter().for_each(|v| self.bytes(&v.to_le_bytes()));
    }

    /// Takes a count in.
    pub fn count(&mut self, value: usize) {
        self.bytes(&(value as u64).to_le_bytes());
    }

    /// Takes a text in.
    pub fn text(&mut self, text: &str) {
        self.count(text.len());
        self.bytes(text.as_bytes());
    }

    /// The hash.
    pub fn value(self) -> u64 {
        self.0
    }
}

/// Payload being written.
#[derive(Clone, Debug, Default)]
pub struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    /// A count.
    pub fn count(&mut self, value: usize) {
        self.bytes.extend((value as u64).to_le_bytes());
    }

    /// A number.
    pub fn number(&mut self, value: f64) {
        self.bytes.extend(value.to_le_bytes());
    }

    /// Numbers and their count.
    pub fn numbers(&mut self, values: &[f64]) {
        self.count(values.len());
        values.iter().for_each(|&v| self.number(v));
    }

    /// A text.
    pub fn text(&mut self, text: &str) {
        self.count(text.len());
        self.bytes.extend(text.as_bytes());
    }

    /// The committed fields and the history of a model.
    pub fn state(&mut self, state: &State) {
        let fields = &state.committed;
        for vector in [&fields.u, &fields.v, &fields.a, &state.old] {
            self.numbers(vector);
        }
        let turns: Vec<f64> = fields.rotation.iter().flat_map(|q| q.coords.iter().copied()).collect();
        self.numbers(&turns);
    }

    /// A part with its length, so that a reader can skip a part it does not support.
    pub fn part(&mut self, part: Writer) {
        self.count(part.bytes.len());
        self.bytes.extend(part.bytes);
    }

    /// Writes the file next to its target ([`unfinished`]), then renames it.
    ///
    /// Errors: those of the file system.
    pub fn save(self, path: &Path, identity: u64) -> Result<(), CheckpointError> {
        let failed =
            |e: std::io::Error| CheckpointError::File { path: path.display().to_string(), reason: e.to_string() };
        let mut hash = Hash::default();
        hash.bytes(&self.bytes);
        let beside = unfinished(path);
        let write = || -> std::io::Result<()> {
            let mut file = File::create(&beside)?;
            file.write_all(&MAGIC)?;
            file.write_all(&VERSION.to_le_bytes())?;
            file.write_all(&identity.to_le_bytes())?;
            file.write_all(&(self.bytes.len() as u64).to_le_bytes())?;
            file.write_all(&self.bytes)?;
            file.write_all(&hash.value().to_le_bytes())?;
            file.sync_all()?;
            drop(file);
            fs::rename(&beside, path)
        };
        write().map_err(|error| {
            // The old checkpoint stays; half a new one only takes room on a disk that may be full.
            let _ = fs::remove_file(&beside);
            failed(error)
        })
    }
}

/// Payload being read.
#[derive(Clone, Debug, Default)]
pub struct Reader {
    bytes: Vec<u8>,
    at: usize,
}

impl Reader {
    /// Opens a file of this analysis.
    ///
    /// Errors: the file system's; not a checkpoint, another version, truncated, damaged, of another analysis.
    pub fn open(path: &Path, identity: u64) -> Result<Reader, CheckpointError> {
        let (found, bytes) = read(path)?;
        if found != identity {
            return Err(CheckpointError::Identity { found, allowed: identity });
        }
        Ok(Reader { bytes, at: 0 })
    }

    fn take<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], CheckpointError> {
        let slice = self.bytes.get(self.at..self.at + N);
        let out = slice.and_then(|s| s.try_into().ok()).ok_or(CheckpointError::Shape {
            what,
            found: self.bytes.len().saturating_sub(self.at),
            allowed: N,
        })?;
        self.at += N;
        Ok(out)
    }

    /// A count.
    ///
    /// Errors: the end of the payload.
    pub fn count(&mut self) -> Result<usize, CheckpointError> {
        Ok(u64::from_le_bytes(self.take("a count")?) as usize)
    }

    /// A number.
    ///
    /// Errors: the end of the payload.
    pub fn number(&mut self) -> Result<f64, CheckpointError> {
        Ok(f64::from_le_bytes(self.take("a number")?))
    }

    /// Numbers.
    ///
    /// Errors: the end of the payload.
    pub fn numbers(&mut self, what: &'static str) -> Result<Vec<f64>, CheckpointError> {
        let count = self.count()?;
        let left = (self.bytes.len() - self.at) / 8;
        if count > left {
            return Err(CheckpointError::Shape { what, found: left, allowed: count });
        }
        (0..count).map(|_| self.number()).collect()
    }

    /// Numbers into a place of the right length.
    ///
    /// Errors: another length.
    pub fn numbers_into(&mut self, what: &'static str, to: &mut [f64]) -> Result<(), CheckpointError> {
        let found = self.numbers(what)?;
        if found.len() != to.len() {
            return Err(CheckpointError::Shape { what, found: found.len(), allowed: to.len() });
        }
        to.copy_from_slice(&found);
        Ok(())
    }

    /// Committed fields and history into a state of the same model; the trial state is then the committed one.
    ///
    /// Errors: another model's.
    pub fn state_into(&mut self, state: &mut State) -> Result<(), CheckpointError> {
        let fields = &mut state.committed;
        self.numbers_into("displacements", &mut fields.u)?;
        self.numbers_into("velocities", &mut fields.v)?;
        self.numbers_into("accelerations", &mut fields.a)?;
        self.numbers_into("history", &mut state.old)?;
        let mut turns = vec![0.0; 4 * fields.rotation.len()];
        self.numbers_into("rotations", &mut turns)?;
        for (q, c) in fields.rotation.iter_mut().zip(turns.chunks_exact(4)) {
            // Not normalised again: bit for bit as written.
            *q = nalgebra::Unit::new_unchecked(nalgebra::Quaternion::new(c[3], c[0], c[1], c[2]));
        }
        state.revert();
        Ok(())
    }

    /// A count that an analysis can have.
    ///
    /// Errors: the end of the payload, a count out of `range`, which `allowed` states in words.
    pub fn count_within(
        &mut self,
        what: &'static str,
        range: std::ops::RangeInclusive<u64>,
        allowed: &'static str,
    ) -> Result<u64, CheckpointError> {
        let found = u64::from_le_bytes(self.take(what)?);
        match range.contains(&found) {
            true => Ok(found),
            false => Err(CheckpointError::Value { what, found: found as f64, allowed }),
        }
    }

    /// A text.
    ///
    /// Errors: the end of the payload, bytes that are not text.
    pub fn text(&mut self) -> Result<String, CheckpointError> {
        let bytes = self.rest("a text")?;
        let found = bytes.len();
        String::from_utf8(bytes).map_err(|e| CheckpointError::Shape {
            what: "a text",
            found,
            allowed: e.utf8_error().valid_up_to(),
        })
    }

    /// A part that was written as one.
    ///
    /// Errors: the end of the payload.
    pub fn part(&mut self) -> Result<Reader, CheckpointError> {
        let bytes = self.rest("a part")?;
        Ok(Reader { bytes, at: 0 })
    }

    /// Bytes behind their number.
    fn rest(&mut self, what: &'static str) -> Result<Vec<u8>, CheckpointError> {
        let length = self.count()?;
        let bytes = self.bytes.get(self.at..self.at.saturating_add(length));
        let bytes = bytes.ok_or(CheckpointError::Shape { what, found: self.bytes.len() - self.at, allowed: length })?;
        self.at += length;
        Ok(bytes.to_vec())
    }
}
