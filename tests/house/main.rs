//! The plan of the house, held by tests: who may import whom (`walls`), and no new large circles of files (`circles`).
//! `ARCHITECTURE.md` draws the plan and gives the reasons.

mod circles;
mod procedures;
mod sources;
mod walls;
