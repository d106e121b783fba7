//! Models of the verification without rows: laws of the shell, walls of fibres.

mod shell_element;
mod shell_parts;
mod strip;
