//! The report knows no procedure; what it calls and draws by id is what the procedure says of itself.

use report::methods::look;
use results::{Method, Status};
use tank::assessment::Excitation;

#[test]
fn procedures_look_as_they_say() {
    for procedure in codes::ALL {
        let label = procedure.label();
        let found = look(&Method {
            id: procedure.id().into(),
            title: label.title.into(),
            excitation: Excitation::Record,
            status: Status::Computed,
            quantities: Default::default(),
            steps: Vec::new(),
            checks: Vec::new(),
            profiles: Vec::new(),
            assumptions: Vec::new(),
            notes: Vec::new(),
        });
        assert_eq!(
            (found.label.as_str(), found.class.as_str()),
            (label.short, label.figure_key)
        );
    }
}
