//! Notes of a run on isolators.

/// Dashpots beside isolators.
pub(super) const DASHPOTS: &str = "`analysis.damping.dashpots` couple the modes: the march of the isolators needs uncoupled ones; remove the dashpots or the isolators";
/// Note of every run.
pub(super) const MOVES: &str = "The tank stands on isolators: values, envelopes, histories, limit states and demands of the time history are those on isolators, \
     and the section on isolation has those on a fixed base beside them. Modes, transfer functions and the response-spectrum method are those \
     on a fixed base.";
/// Note of another model.
pub(super) const ANOTHER: &str = "The tank stands on isolators: values, envelopes, histories, limit states and demands of this run are those on isolators. \
     The slab moves as the linear engine moves it under the forces of this run, which are found by a second run where those of the first differ.";
/// Change of the force on the slab over that of the isolators above which values are indicative.
pub(super) const CLOSE: f64 = 0.03;
/// The forces of another model still differ.
pub(super) fn differs(change: f64) -> String {
    format!(
        "The forces of the last run differ by {:.0} % of the largest force of the isolators from those under which its slab has moved: values on \
         isolators are indicative.",
        100.0 * change
    )
}
/// Vertical tension.
pub(super) fn tension(share: f64, time: f64) -> String {
    format!(
        "The outermost bearing would be in tension at {time:.2} s (its force is {share:.2} of that at rest): the model holds it down. Bearings of \
         the listed kinds do not bear tension unless they are built for it."
    )
}
