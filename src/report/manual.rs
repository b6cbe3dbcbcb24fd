//! The reference of the language as reports: the same tables that the checker reads.

use super::document::{Report, Section, Table};
use assur_text::language::{Dimension, FUNCTIONS, FunctionGroup, PROPERTIES, Place, UNITS, WORDS};
use assur_text::units::significant;

/// Digits of conversion factors.
const DIGITS: usize = 10;

/// The functions by subject.
pub const SUBJECTS: [(FunctionGroup, &str); 12] = [
    (FunctionGroup::Math, "Mathematics"),
    (FunctionGroup::Motion, "Motion"),
    (FunctionGroup::Force, "Forces"),
    (FunctionGroup::Inertia, "Inertia"),
    (FunctionGroup::Friction, "Friction and losses"),
    (FunctionGroup::Cycle, "The whole cycle"),
    (FunctionGroup::Train, "Wheels, ropes, trains"),
    (FunctionGroup::Gear, "Pairs of gears"),
    (FunctionGroup::Cam, "Cams"),
    (FunctionGroup::Flywheel, "Flywheels"),
    (FunctionGroup::Simulation, "Motion under loads"),
    (FunctionGroup::Bearing, "Bearings"),
];

/// All functions, with their results and meanings.
#[must_use]
pub fn functions() -> Report {
    let mut report = Report { title: "Functions".to_owned(), ..Report::default() };
    for (group, subject) in SUBJECTS {
        let mut table = Table::of_words(&["function", "result", "meaning"]);
        for row in FUNCTIONS.iter().filter(|row| row.group == group) {
            for form in row.forms {
                let takes = form.takes.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
                let call = format!("{}({takes})", row.name);
                table.row(vec![call, form.gives.to_string(), form.means.to_owned()]);
            }
        }
        let mut section = Section::new(subject);
        section.table(table);
        report.section(section);
    }
    report
}

/// All units, with what each is in SI.
#[must_use]
pub fn units() -> Report {
    let mut table = Table::of_words(&["unit", "equals", "dimension"]);
    for unit in UNITS {
        let dimension = unit.dimension;
        let equals = format!("{} {}", significant(unit.factor, DIGITS), dimension.si_text());
        table.row(vec![unit.text.to_owned(), equals.trim_end().to_owned(), without_article(dimension)]);
    }
    let mut section = Section::new("One word");
    section.table(table);
    let mut others = Section::new("Products, quotients, powers");
    others.text("kg*m^2, m/s^2, rad/s, s^-1, N*m/rad");
    Report { title: "Units".to_owned(), notes: Vec::new(), sections: vec![section, others] }
}

/// `length` of `a length`.
fn without_article(dimension: Dimension) -> String {
    let name = dimension.to_string();
    name.split_once(' ').map_or_else(|| name.clone(), |(_, name)| name.to_owned())
}

/// All words that begin a statement or a member, with an example of each, and the properties in braces.
#[must_use]
pub fn statements() -> Report {
    let mut report = Report { title: "Statements and their parts".to_owned(), ..Report::default() };
    for (place, words) in WORDS {
        let heading = match place {
            Place::Statement => "Statements",
            Place::Pair => "Pairs and transmissions",
            Place::Member => "In the braces of a link",
            Place::CamMember => "In the braces of a cam",
            Place::Shape => "Shapes of masses, after the value of `mass` or `weight`",
            Place::Law => "Laws of cams, after the angle of a phase",
            // they have no meaning of their own
            Place::Connecting | Place::Contextual => continue,
        };
        let mut table = Table::of_words(&["word", "means", "example"]);
        for row in *words {
            table.row(vec![row.word.to_owned(), row.means.to_owned(), row.example.to_owned()]);
        }
        let mut section = Section::new(heading);
        section.table(table);
        report.section(section);
    }
    let mut table = Table::of_words(&["of", "property", "means"]);
    for (of, properties) in PROPERTIES {
        for property in *properties {
            let cells = [*of, property.example, property.means];
            table.row(cells.map(str::to_owned).to_vec());
        }
    }
    let mut section = Section::new("Properties, in the braces of a pair or an element");
    section.table(table);
    report.section(section);
    report
}
