//! The command line: bad input, exit codes, output folders; and checks of the repository itself.

mod bad_tank;
mod compare;
mod corners;
mod estimates;
mod hostile;
mod ida;
mod interrupt;
mod kill;
mod licences;
mod limits;
mod linear;
mod nonlinear_cylinder;
mod nonlinear_input;
mod nonlinear_options;
mod nonlinear_run;
mod nonlinear_scope;
mod plausible;
mod push;
mod push_resume;
mod records;
mod solid;
mod streams;
mod tank_file;
mod verify;
mod vtu;
mod vtu_sample;
