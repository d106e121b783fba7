//! Attachment (E.6.2.1.2, E.7.4), number (5.12.2) and spacing (5.12.3) of the anchors.
//!
//! At least four anchors, six where the earthquake governs: taken as where it pulls at them. E.7.4 has 4 P_AB in place of 3 P_AB.
//! 5.12.2 and 5.12.3 as in the public agenda text on tank anchorage (2011); E.7.4 recalled.
//! The attachment to the shell and the embedment are designed for the lesser of 3 P_AB and the anchor's yield force as built.
//! Where `yield_force` is not given, 3 P_AB is on the safe side. The spacing is measured along the inside of the shell.
//! Clause numbers and the 3 m (10 ft) are recalled; the larger of both printed values counts, as who follows either follows the clause.

use tank::Anchors;
use tank::assessment::CheckStatus;
use tank::units::Dimension::{Dimensionless, Force, Length};

use super::{Run, limit_states};
use tank::assessment::Check;

const E6_2_1_2: &str = "API 650:2020 E.6.2.1.2";
const SPACING: &str = "API 650:2020 5.12.3";
const COUNT: &str = "API 650:2020 5.12.2";
const E7_4: &str = "API 650:2020 E.7.4";
/// Least number of anchors, and where the earthquake governs.
pub(crate) const LEAST: [f64; 2] = [4.0, 6.0];
/// Largest spacing of anchors [m]: printed as 3 m (10 ft), and 10 ft is the larger.
pub(crate) const LARGEST_SPACING: f64 = 10.0 * 0.3048;

impl Run<'_> {
    /// Three times the tension of an anchor against the capacity of its attachment, and the connections.
    ///
    /// * `w_ab`: uplift per length of shell [N/m]
    pub(super) fn anchor_attachment(&mut self, w_ab: f64) {
        let id = limit_states::ATTACHMENT.id;
        if w_ab <= 0.0 {
            let reason = "the weight outweighs the uplift; the anchors carry no tension";
            for id in [id, limit_states::CONNECTIONS.id] {
                self.without_comparison(id, CheckStatus::NotApplicable, reason, None);
            }
            return;
        }
        let missing = match self.counted_anchors() {
            None => Err("tank.anchors"),
            Some(anchors) => match anchors.attachment_capacity {
                None => Err("tank.anchors.attachment_capacity"),
                Some(capacity) => Ok((anchors, capacity)),
            },
        };
        let (anchors, capacity) = match missing {
            Ok(found) => found,
            Err(input) => {
                self.missing(id, input);
                return self.missing(limit_states::CONNECTIONS.id, input);
            }
        };
        self.sheet.given(&[("n_A", f64::from(anchors.count), Dimensionless)]);
        let (name, formula) = ("design force of an attachment, 3 P_AB", "3·w_AB·π·D/n_A");
        let mut force = self.sheet.calc("P_3", name, formula, Force, E6_2_1_2);
        let mut name = "Attachment of an anchor, 3 P_AB";
        let mut note = "or the anchor's yield force as built, where that is less";
        if let Some(yields) = anchors.yield_force {
            self.sheet.input("P_y", "yield force of an anchor", yields, Force, "tank.anchors.yield_force");
            let title = "design force of an attachment, the lesser of both";
            force = self.sheet.calc("P_t", title, "min(P_3, P_y)", Force, E6_2_1_2);
            (name, note) = ("Attachment of an anchor", "the lesser of 3 P_AB and the yield force of an anchor");
        }
        self.check(id, name, force, capacity, Force, E6_2_1_2, note);
        self.anchor_connection(&anchors, capacity);
    }

    /// Connections of the anchors: four times the tension, or the yield force where that is less.
    fn anchor_connection(&mut self, anchors: &Anchors, capacity: f64) {
        self.sheet.given(&[("n_A", f64::from(anchors.count), Dimensionless)]);
        let (mut name, mut formula) = ("design force of a connection, 4 P_AB", "4·w_AB·π·D/n_A");
        if anchors.yield_force.is_some() {
            (name, formula) =
                ("design force of a connection, 4 P_AB or the yield force of an anchor", "min(4·w_AB·π·D/n_A, P_y)");
        }
        let force = self.sheet.calc("P_4", name, formula, Force, E7_4);
        let name = "Connection of an anchor, 4 P_AB";
        let note = "or the yield force of an anchor, where that is given and less";
        self.check(limit_states::CONNECTIONS.id, name, force, capacity, Force, E7_4, note);
    }

    /// Number of the anchors against the least.
    ///
    /// * `w_ab`: uplift per length of shell [N/m]
    pub(super) fn anchor_count(&mut self, w_ab: f64) {
        let id = limit_states::COUNT.id;
        let Some(anchors) = self.counted_anchors() else { return self.missing(id, "tank.anchors") };
        let (least, note) = match w_ab > 0.0 {
            true => (LEAST[1], "six where the earthquake pulls at them"),
            false => (LEAST[0], "the earthquake does not pull at them"),
        };
        let (name, source) = ("least number of anchors", "4, and 6 where the earthquake governs");
        let least = self.sheet.look_up("n_min", name, source, least, Dimensionless, COUNT);
        let count = f64::from(anchors.count);
        let name = "Least number of anchors over that given";
        let check = Check::new(id, name, least, count, Dimensionless, COUNT, note);
        self.out.checks.push(check);
    }

    /// Spacing of the anchors against the largest allowed.
    pub(super) fn anchor_spacing(&mut self) {
        let id = limit_states::SPACING.id;
        let Some(anchors) = self.counted_anchors() else { return self.missing(id, "tank.anchors") };
        self.sheet.given(&[("n_A", f64::from(anchors.count), Dimensionless)]);
        let name = "spacing of the anchors";
        let spacing = self.sheet.calc("a_A", name, "π·D/n_A", Length, SPACING);
        let (name, source) = ("largest spacing", "the larger of its values in metres and in feet");
        let largest = self.sheet.look_up("a_max", name, source, LARGEST_SPACING, Length, SPACING);
        let name = "Spacing of the anchors";
        self.check(id, name, spacing, largest, Length, SPACING, "");
    }

    fn counted_anchors(&self) -> Option<Anchors> {
        self.basis.case.tank.anchors.filter(|anchors| anchors.count > 0)
    }
}
