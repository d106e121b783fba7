//! Golden reports of the examples, and the rendering of reports.

mod examples;
mod kept;
mod previous;
mod rendering;
mod sample;
