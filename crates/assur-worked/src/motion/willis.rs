//! Willis' table: the carrier locked, the turn of the carrier, their sum; exact fractions of the speed of the drive.

use crate::course::Derivation;
use crate::document::{Line, Table, text};
use crate::motion::of;
use crate::words::Message;
use assur_formula::{Name, with_digits};
use assur_model::model::{DriveTarget, counts_from_carrier};
use assur_model::structure::{BodyRate, JointId, JointKind};

/// The largest denominator that teeth give.
const DENOMINATOR: f64 = 1e6;

impl Derivation<'_> {
    /// A table per carrier, behind the last group with a transmission on it.
    pub(super) fn willis(&mut self, index: usize) {
        let mut carriers: Vec<usize> = Vec::new();
        for law in &self.structure().motion[index].laws {
            if let Some(carrier) = self.carrier(*law)
                && !carriers.contains(&carrier)
            {
                carriers.push(carrier);
            }
        }
        for carrier in carriers {
            let later = self.structure().motion[index + 1..].iter().flat_map(|g| &g.laws);
            if later.clone().any(|law| self.carrier(*law) == Some(carrier)) {
                continue;
            }
            let all = self.structure().motion[..=index].iter().flat_map(|g| &g.laws);
            let own: Vec<JointId> = all.filter(|law| self.carrier(**law) == Some(carrier)).copied().collect();
            self.table_of_carrier(carrier, &own);
        }
    }

    /// The carrier of a law between two wheels.
    fn carrier(&self, law: JointId) -> Option<usize> {
        match &self.structure().replaced.joint(law).kind {
            JointKind::Law(terms) => match terms.get(2) {
                Some((BodyRate::Turn(body), _)) => Some(body.0),
                _ => None,
            },
            _ => None,
        }
    }

    fn table_of_carrier(&mut self, carrier: usize, laws: &[JointId]) {
        let (mut bodies, mut bevel): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        for law in laws {
            let JointKind::Law(terms) = &self.structure().replaced.joint(*law).kind else { continue };
            for (side, (rate, _)) in terms.iter().take(2).enumerate() {
                if let BodyRate::Turn(body) = rate
                    && !bodies.contains(&body.0)
                {
                    bodies.push(body.0);
                    // a bevel planet turns relative to its carrier
                    bevel.extend((!counts_from_carrier(terms, side)).then_some(body.0));
                }
            }
        }
        let omega = |body: usize| self.moved(body).omega;
        let drives = self.scene.mechanism().drives.iter().filter_map(|drive| match drive.target {
            DriveTarget::Link(link) => Some(link.index()),
            _ => None,
        });
        let turning: Vec<usize> = drives.filter(|body| omega(*body) != 0.0).collect();
        // of one drive all speeds are parts of its own
        let unit = match turning.as_slice() {
            [one] => Some(*one),
            _ => None,
        };
        let over = unit.map_or(1.0, omega);
        let figure = |x: f64| -> Line {
            let x = x / over;
            let written = unit.and_then(|_| fraction(x)).unwrap_or_else(|| with_digits(x, 5).text());
            vec![text(written)]
        };
        let mut headers: Vec<Line> = vec![vec![text("")]];
        headers.extend(bodies.iter().map(|b| of(&Name::new("ω", &self.label(*b)))));
        headers.push(of(&Name::new("ω", &self.label(carrier))));
        let mut all = bodies;
        all.push(carrier);
        let turn = |body: usize| if bevel.contains(&body) { 0.0 } else { omega(carrier) };
        let row = |message: Message, values: Vec<f64>| {
            let mut cells: Vec<Line> = vec![vec![text(self.words(message))]];
            cells.extend(values.into_iter().map(figure));
            cells
        };
        let rows = vec![
            row(Message::CarrierLocked, all.iter().map(|b| omega(*b) - turn(*b)).collect()),
            row(Message::CarrierTurns, all.iter().map(|b| turn(*b)).collect()),
            row(Message::SumOfBoth, all.iter().map(|b| omega(*b)).collect()),
        ];
        let carrier = vec![text(self.label(carrier))];
        let numbers = (1..headers.len()).collect();
        let table = Table { headers, rows, numbers };
        match unit {
            Some(body) => {
                let speed = of(&Name::new("ω", &self.label(body)));
                self.say(Message::WillisParts, &[carrier, speed]);
            }
            None => self.say(Message::WillisSpeeds, &[carrier]),
        }
        self.table(table);
    }
}

/// A number as a fraction of whole numbers; none where it is no such fraction.
fn fraction(x: f64) -> Option<String> {
    let (mut before, mut now) = ((0.0, 1.0), (1.0, 0.0));
    let mut rest = x.abs();
    loop {
        let whole = (rest + 1e-9).floor();
        (before, now) = (now, (whole * now.0 + before.0, whole * now.1 + before.1));
        if now.1 > DENOMINATOR {
            return None;
        }
        if (now.0 / now.1 - x.abs()).abs() <= 1e-13 * x.abs().max(1.0) {
            break;
        }
        rest = 1.0 / (rest - whole);
        if !rest.is_finite() {
            return None;
        }
    }
    let sign = if x < 0.0 && now.0 != 0.0 { "−" } else { "" };
    Some(if now.1 == 1.0 { format!("{sign}{}", now.0) } else { format!("{sign}{}/{}", now.0, now.1) })
}
