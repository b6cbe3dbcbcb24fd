//! Where the drives are.

use super::Telling;
use crate::document::{Inline, Line, text};
use crate::sheet::drive_words;
use crate::words::words_of;
use assur_formula::{Name, name_node};
use assur_model::model::{Drive, DriveTarget, Mechanism};
use assur_syntax::document::{DrivePosition, Expr, ExprKind, Statement, Steps};
use assur_syntax::given::{Datum, GivenLine, GivenValue, Shown};

impl<'a> Telling<'a> {
    /// The last line: where the drives are, unless headings have it.
    pub(super) fn positions(&mut self, lines: &[GivenLine<'a>]) -> Line {
        let mut words: Vec<Line> = Vec::new();
        let mut several = false;
        if let Some(drives) = self.data.position {
            words.extend((!drives.is_empty()).then(|| drive_words(drives)));
        } else if self.data.headings || self.is_constant() {
            return Vec::new();
        } else {
            let shown = lines.iter().flat_map(|line| line.data.iter().map(move |datum| (line, datum)));
            for (line, datum) in shown.filter(|(_, datum)| datum.shown == Shown::Heading) {
                if let GivenValue::Positions(position) = &datum.value
                    && !self.is_asked(line)
                {
                    several |= !matches!(position, DrivePosition::Values(values) if values.len() == 1);
                    words.push(self.position(datum, position));
                }
            }
        }
        if words.is_empty() {
            return Vec::new();
        }
        let [colon, semicolon] = self.signs();
        let key = if several { "positions" } else { "position" };
        let head = words_of(self.language, "given subjects", key, &[]);
        [head, vec![text(colon)], words.join(&text(semicolon))].concat()
    }

    fn position(&mut self, datum: &Datum<'a>, position: &'a DrivePosition) -> Line {
        let letter = self.drive_letter(&datum.index);
        match position {
            DrivePosition::Values(values) => match (values.as_slice(), letter) {
                ([one], letter) if one.sense.is_none() => self.values.with_letter(letter, true, &one.value),
                (values, letter) => {
                    let lines: Vec<Line> = values.iter().map(|v| self.values.line(&v.value)).collect();
                    equal(letter, lines.join(&text("; ")))
                }
            },
            DrivePosition::Range(range) => {
                let (key, steps) = match &range.steps {
                    Steps::In(count) => ("steps", count),
                    Steps::Of(step) => ("step", step),
                };
                let parts = [&range.from, &range.to, steps].map(|part| self.values.line(part));
                equal(letter, words_of(self.language, "given words", key, &parts))
            }
        }
    }

    /// The letter of a drive's coordinate; of a point its name.
    fn drive_letter(&self, index: &str) -> Option<Name> {
        let mechanism = self.data.mechanism;
        let drive = mechanism.drives.iter().find(|drive| drive.name == index)?;
        Some(match drive.target {
            DriveTarget::Point(..) => Name::new(index.rsplit('.').next().unwrap_or(index), ""),
            DriveTarget::Link(_) | DriveTarget::Pair(_) | DriveTarget::Place(..) => {
                drive_letter(mechanism, drive)
            }
        })
    }

    /// Whether the position itself is asked for.
    fn is_asked(&self, line: &GivenLine<'_>) -> bool {
        let target = line.names.first().map(String::as_str);
        let finds = self.data.document.statements.iter().filter_map(|s| match &s.node {
            Statement::Find(find) => Some(&find.items),
            _ => None,
        });
        finds.flatten().any(|item| match &item.value.kind {
            ExprKind::Call { function, args } if matches!(&*function.node, "angle" | "displacement") => {
                let of =
                    |expr: &Expr| matches!(&expr.kind, ExprKind::Name(name) if Some(name.as_str()) == target);
                matches!(args.as_slice(), [arg] if of(&arg.value))
            }
            _ => false,
        })
    }

    /// Whether nothing depends on the position: shafts and sliders alone, or one link in a guide.
    fn is_constant(&self) -> bool {
        let statements = || self.data.document.statements.iter().map(|s| &s.node);
        let depends = |statement: &Statement| match statement {
            Statement::Spring(_)
            | Statement::Cam(_)
            | Statement::Curve(_)
            | Statement::Event(_)
            | Statement::Simulate(_)
            | Statement::Equilibrium(_)
            | Statement::Stop(_) => true,
            Statement::Load(load) => load.when.is_some(),
            Statement::Joint(joint) => {
                use assur_syntax::document::JointKind::{Contact, Cylinder, Revolute, Slot, Weld};
                matches!(joint.kind.node, Contact | Cylinder | Slot | Weld | Revolute)
            }
            _ => false,
        };
        let links = statements().filter(|s| matches!(s, Statement::Link(_))).count();
        let asks = crate::sheet::asks_for_positions(self.data.mechanism);
        links <= 1 && !asks && !statements().any(depends)
    }
}

fn equal(letter: Option<Name>, value: Line) -> Line {
    match letter {
        Some(letter) => [vec![Inline::Math(name_node(&letter)), text("\u{a0}=\u{a0}")], value].concat(),
        None => value,
    }
}

/// φ of a link, s of a slide, indexed by its number or its name.
#[must_use]
pub fn drive_letter(mechanism: &Mechanism, drive: &Drive) -> Name {
    let (letter, index) = assur_picture::drive_letter(mechanism, drive);
    Name::new(letter, index)
}
