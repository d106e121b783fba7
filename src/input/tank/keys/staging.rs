//! `tank.staging`.

use files::code::Code;
use tank::{Shape, Staging, StagingKind, Support};

use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::Resolver;

choice!(StagingKind);

/// What a tank that stands on the ground has, and one on a staging has not.
const ALLOWED: &str = "no tank.staging, or a tank without this";

/// The staging of a whole tank that is held down.
pub(super) fn staging(
    r: &mut Resolver<'_>,
    option: &Opt<Given<Staging>>,
    shape: Option<Shape>,
    support: &Field<Support>,
) -> Option<Staging> {
    let field = option.given.as_ref()?;
    let staging = field.value.as_ref().and_then(|given| given.resolve(r));
    if support.value == Some(Support::Unanchored) {
        let message = "the container is fixed to its staging";
        r.refuse(Code::Contradiction, support, message, "\"anchored\" with tank.staging");
    }
    if matches!(shape, Some(Shape::Rectangle { strip: true, .. })) {
        let message = "a staging carries a whole tank, not a strip";
        r.refuse(Code::Unsupported, field, message, "a cylinder, or a rectangle with its breadth");
    }
    if let (Some(Staging { kind, .. }), Some(columns)) = (staging, &field.value.as_ref()?.columns.given)
        && kind == StagingKind::RcShaft
    {
        r.refuse(Code::DoesNotApply, columns, "a shaft has no columns", "no columns, or a frame");
    }
    r.warn(Code::NotUsed, "`tank.staging` is known to the procedure of IS 1893-2 alone: other procedures and the finite-element engines do not run");
    staging
}

/// Refuses a part that a tank on the ground has.
pub(super) fn on_ground<T, K>(r: &mut Resolver<'_>, option: &Opt<T, K>, message: &str) {
    if let Some(given) = &option.given {
        r.refuse(Code::DoesNotApply, given, message, ALLOWED);
    }
}
