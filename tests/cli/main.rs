//! The command line: bad input, exit codes, output folders; and what must hold of the repository itself.

mod bad_tank;
mod compare;
mod ida;
mod licences;
mod nonlinear_cylinder;
mod nonlinear_input;
mod nonlinear_options;
mod nonlinear_run;
mod nonlinear_scope;
mod push;
mod records;
mod solid;
mod tank_file;
mod vtu;
