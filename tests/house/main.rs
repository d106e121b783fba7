//! The plan of the house, held by tests: who may import whom (`walls`), and no new large circles of files (`circles`).
//! `ARCHITECTURE.md` draws the plan and gives the reasons.

mod circles;
mod labels;
mod sources;
mod walls;
