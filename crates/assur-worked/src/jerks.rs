//! Jerks that the file asks for: angular jerks as solved, then the jerks of points as accelerations are found.

use crate::course::{Derivation, joined};
use crate::document::Block;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{PointRef, Query, Value};

impl Derivation<'_> {
    /// Jerks of points, angular jerks of links, third rates of coordinates.
    pub(crate) fn asked_of_jerks(&mut self) {
        let before = self.blocks.len();
        for query in self.questions() {
            match query {
                Query::Jerk(PointRef::Fixed(link, at)) => {
                    let [x, y] = self.jerk(link.index(), at);
                    for part in [x, y] {
                        part.visit(&mut |q| {
                            self.asked.insert(q.name.clone());
                        });
                    }
                }
                Query::AngularJerk(link) => {
                    let zeta = self.angular_jerk(link.index());
                    zeta.visit(&mut |q| {
                        self.asked.insert(q.name.clone());
                    });
                }
                Query::RelativeJerk(pair) => {
                    let name = Name::new("j", &self.scene.mechanism().pair(pair).name);
                    if let Value::Scalar(value) = self.scene.view().query(&query) {
                        self.asked.insert(name.clone());
                        self.stated(name, value, Unit::Jerk);
                    }
                }
                _ => {}
            }
        }
        if self.blocks.len() > before {
            let words = say(self.language, Message::AskedForJerks, &[]);
            self.insert(before, vec![Block::Heading(3, self.words(Message::Jerks)), Block::Paragraph(words)]);
        }
    }

    /// The angular jerk of a body, as it is solved.
    fn angular_jerk(&mut self, body: usize) -> Expr {
        let zeta = self.moved(body).zeta;
        if zeta == 0.0 {
            return Expr::ZERO;
        }
        let name = Name::new("ζ", &self.label(body));
        self.stated(name, zeta, Unit::AngularJerk)
    }

    /// The jerk of a point, m/s³: that of the reference of its body, and what the body's turning adds.
    fn jerk(&mut self, body: usize, at: Vec2) -> [Expr; 2] {
        if self.on_ground_at(body, at) {
            return [Expr::ZERO, Expr::ZERO];
        }
        let name = self.point_name(body, at);
        let value = self.moved(body).jerk(at);
        let letter = Name::new("j", &name);
        let Some(arm) = self.arm(body, at, true) else {
            let parts = [(letter.and("x"), value.x), (letter.and("y"), value.y)];
            return parts.map(|(name, value)| self.stated(name, value, Unit::Jerk));
        };
        let [omega, alpha] = arm.rates.clone();
        let zeta = self.angular_jerk(arm.at.0);
        let from = self.jerk(arm.at.0, arm.at.1);
        if omega.is_zero() && alpha.is_zero() && zeta.is_zero() {
            return from;
        }
        let fixed = from.iter().all(Expr::is_zero);
        let index = if fixed { name } else { joined(&arm.point, &arm.reference) };
        let (moved, length) = (self.moved(arm.at.0), arm.length.value());
        let (w, a, z) = (moved.omega, moved.alpha, moved.zeta);
        let normal = self.equate(
            Name::new("j", &index).marked("n"),
            3.0 * w * a * length,
            Unit::Jerk,
            Expr::Int(3) * omega.clone() * alpha * arm.length.clone(),
        );
        let tangential = self.equate(
            Name::new("j", &index).marked(self.language.letters().tangential),
            (z - w * w * w) * length,
            Unit::Jerk,
            (zeta - Expr::Power(Box::new(omega), 3)) * arm.length.clone(),
        );
        let [x, y] = from;
        let right = [
            x - normal.clone() * arm.angle.cos() - tangential.clone() * arm.angle.sin(),
            y - normal * arm.angle.sin() + tangential * arm.angle.cos(),
        ];
        let [r_x, r_y] = right;
        [
            self.component(letter.and("x"), value.x, Unit::Jerk, r_x),
            self.component(letter.and("y"), value.y, Unit::Jerk, r_y),
        ]
    }
}
