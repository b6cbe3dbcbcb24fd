//! The outcomes of the rows, in one line.

use assur_solve::measure::accuracy::AchievedAccuracy;
use indexmap::IndexMap;

/// The number of rows that are named; the others are counted.
const NAMED: usize = 12;

/// The stage of what is wrong with a line of a table.
const TABLE: &str = "mech::table::";

/// The kinds of outcomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The row has no answers, or not all.
    Failed,
    /// An expectation of the row is not met.
    Unmet,
    /// Something is to be said of the row.
    Warned,
}

#[derive(Clone, Debug, Default)]
struct Group {
    count: usize,
    first: Vec<usize>,
}

/// The outcomes of the rows.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    solved: usize,
    failed: usize,
    groups: IndexMap<(Kind, String), Group>,
    /// The accuracy that was wanted, and the greatest error of all rows.
    reached: Option<(f64, f64)>,
}

impl Tally {
    /// Counts a row with answers.
    pub const fn solved(&mut self) {
        self.solved += 1;
    }

    /// Counts a row without.
    pub fn failed_row(&mut self, row: usize, code: &str) {
        self.failed += 1;
        self.note(Kind::Failed, row, code);
    }

    /// Keeps the greatest error of all rows.
    pub fn reached(&mut self, row: &AchievedAccuracy) {
        let worst = self.reached.map_or(0.0, |r| r.1);
        self.reached = Some((row.within, row.error.max(worst)));
    }

    /// Notes what is to be said of a row. Returns how often it has been said.
    pub fn note(&mut self, kind: Kind, row: usize, code: &str) {
        // whatever is wrong with a line of a table, it cannot be read
        let code = if code.starts_with(TABLE) { TABLE } else { code };
        let group = self.groups.entry((kind, code.to_owned())).or_default();
        group.count += 1;
        if group.first.len() < NAMED {
            group.first.push(row);
        }
    }

    /// How often something has been said.
    pub fn said(&self, kind: Kind, code: &str) -> usize {
        let code = if code.starts_with(TABLE) { TABLE } else { code };
        self.groups.get(&(kind, code.to_owned())).map_or(0, |g| g.count)
    }

    pub const fn failed(&self) -> usize {
        self.failed
    }

    pub const fn rows(&self) -> usize {
        self.solved + self.failed
    }

    /// Adds the numbers of another file.
    pub const fn add(&mut self, other: &Self) {
        self.solved += other.solved;
        self.failed += other.failed;
    }

    /// `126 solved, 2 failed`
    pub fn in_short(&self) -> String {
        let failed = if self.failed > 0 { format!(", {} failed", self.failed) } else { String::new() };
        format!("{} solved{failed}", self.solved)
    }

    /// `126 solved, 2 do not close: rows 17, 90`
    pub fn summary(&self) -> String {
        let mut parts = vec![format!("{} solved", self.solved)];
        for kind in [Kind::Failed, Kind::Unmet, Kind::Warned] {
            for ((_, code), group) in self.groups.iter().filter(|((k, _), _)| *k == kind) {
                parts.push(group.words(kind, code));
            }
        }
        if let Some((within, worst)) = self.reached {
            parts.push(format!("within {within:.0e}: greatest error of all rows {worst:.0e}"));
        }
        parts.join(", ")
    }
}

impl Group {
    fn words(&self, kind: Kind, code: &str) -> String {
        let one = self.count == 1;
        let what = match (kind, code.strip_prefix("mech::").unwrap_or(code)) {
            (Kind::Failed, "assembly::does_not_close" | "assembly::not_found") => {
                if one {
                    "does not close".to_owned()
                } else {
                    "do not close".to_owned()
                }
            }
            (Kind::Failed, code) if code.starts_with("table::") => "cannot be read".to_owned(),
            (Kind::Failed, code) => format!("failed ({code})"),
            (Kind::Unmet, _) => "with expectations not met".to_owned(),
            (Kind::Warned, code) => format!("with a warning ({code})"),
        };
        let rows: Vec<String> = self.first.iter().map(ToString::to_string).collect();
        let more = self.count - self.first.len();
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!("{} {what}: row{} {}{more}", self.count, if one { "" } else { "s" }, rows.join(", "))
    }
}
