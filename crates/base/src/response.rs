//! What a base answers a motion with.

/// Moment or force and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// M_b [N m], or the force along the ground [N].
    pub moment: f64,
    /// dM_b/dψ [N m], or that of the force by the displacement [N/m].
    pub tangent: f64,
}

impl Response {
    /// With another one beside it.
    pub(crate) fn and(self, other: Response) -> Response {
        Response { moment: self.moment + other.moment, tangent: self.tangent + other.tangent }
    }
}
