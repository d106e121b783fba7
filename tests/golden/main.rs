//! Golden reports of the examples, and the rendering of reports.

mod accepted;
mod examples;
mod kept;
mod languages;
mod previous;
mod rendering;
mod sample;
