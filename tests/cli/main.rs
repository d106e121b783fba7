//! The command line: bad input, exit codes, output folders; and what must hold of the repository itself.

mod compare;
mod licences;
