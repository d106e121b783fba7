//! Golden reports of the examples, and the rendering of reports.

mod examples;
mod report_content;
mod report_print;
mod sample;
