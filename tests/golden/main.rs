//! Golden reports of the examples, and the rendering of reports.

mod examples;
