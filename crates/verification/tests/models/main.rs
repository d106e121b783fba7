//! Models of the verification without rows: laws of the shell, walls of fibres, the harmonic and the three-dimensional engine against closed
//! forms, convergence and second formulations; the manual, and the program that writes it.

mod bulging;
mod convergence;
mod manual;
mod map;
mod motions;
mod observables;
mod program;
mod response_oscillators;
mod response_simulate;
mod response_tank;
mod rigid_cylinder;
mod rigid_strip;
mod shell_element;
mod shell_parts;
mod solid_box;
mod solid_engine;
mod strip;
mod strip_wall;
mod tanks;
mod three_field;
mod wall_modes;
mod wall_statics;
