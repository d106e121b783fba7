//! Response analyses of a coupled system: modal, direct.
