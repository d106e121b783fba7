//! Separation of the liquid from the wall, as the results name it.

use results::LiquidParting;

/// A separation as the results name it.
pub(crate) fn parting(found: fem::liquid::separation::Parting) -> LiquidParting {
    LiquidParting { time: found.time, height: found.height, open: found.open }
}
