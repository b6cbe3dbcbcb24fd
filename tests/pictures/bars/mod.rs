//! What must hold for a picture against the solution that it shows.

mod balance;
mod forces;
mod places;
mod plans;

use crate::drawn::{Shown, faults};
use assur::internals::drawing::{Mark, Sheet};
use assur::internals::picture::Kind;
use assur::internals::solve::{Pose, State};

/// What was compared, and what is wrong.
#[derive(Debug, Default)]
pub struct Tally {
    pub sheets: usize,
    pub labels: usize,
    pub joints: usize,
    pub ends: usize,
    pub parts: usize,
    pub polygons: usize,
    pub bodies: usize,
    pub levers: usize,
    pub lines: usize,
    pub wrong: Vec<String>,
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { sheets, labels, joints, ends, parts, .. } = self;
        write!(f, "{sheets} pictures, {labels} labels, {joints} joints, {ends} ends, {parts} parts, ")?;
        let Self { polygons, bodies, levers, lines, wrong, .. } = self;
        write!(
            f,
            "{polygons} polygons, {bodies} free bodies, {levers} levers, {lines} action lines, {} faults",
            wrong.len()
        )
    }
}

/// The most faults of a sheet that are listed.
const LISTED: usize = 3;

/// A sheet with what it shows.
pub struct Judged<'a> {
    pub shown: &'a Shown<'a>,
    pub state: &'a State,
    pub sheet: &'a Sheet,
    pub kind: Kind,
}

impl Tally {
    /// Looks at a picture of a position.
    pub fn judge(&mut self, shown: &Shown<'_>, kind: Kind, pose: &Pose, sheet: &Sheet) {
        let Ok(solved) = &pose.outcome else { return };
        let judged = Judged { shown, state: &solved.state, sheet, kind };
        self.sheets += 1;
        self.labels += sheet.placed.len();
        let mut wrong = faults(sheet);
        match kind {
            Kind::Scheme => self.joints += places::hinges(&judged, &mut wrong),
            Kind::Velocities | Kind::Accelerations => {
                self.ends += plans::ends(&judged, &mut wrong);
                self.parts += plans::parts(&judged, &mut wrong);
            }
            Kind::Forces => {
                self.polygons += forces::polygon(sheet, &mut wrong);
                self.bodies += usize::from(sheet.drawing.id.contains("free-body"));
                wrong.extend(balance::free_body(sheet));
            }
            Kind::Lever => {
                self.levers += forces::lever(sheet, solved.condition, &mut wrong);
                wrong.extend(balance::lever(sheet));
                wrong.extend(balance::list(&judged, solved));
            }
            Kind::Friction => self.lines += forces::action_lines(&judged, &mut wrong),
            _ => {}
        }
        let file = shown.file.0;
        let place = format!("{file}, {} at {}", kind.name(), pose.name);
        self.wrong.extend(wrong.into_iter().take(LISTED).map(|fault| format!("{place}: {fault}")));
    }

    /// Complains about everything at once.
    pub fn finish(&self) {
        let wrong = &self.wrong;
        assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
    }
}

impl Judged<'_> {
    /// The class and the name of the group of a mark.
    fn group(&self, mark: &Mark) -> (&str, &str) {
        let group = &self.sheet.drawing.groups[mark.group];
        (group.class, &group.name)
    }

    /// `Length scale 0.005 m per mm`, `Scale 0.02 m/s per mm` of a description.
    fn factor(&self, words: &str) -> Option<f64> {
        let (_, said) = self.sheet.drawing.description.rsplit_once(words)?;
        number(said.split(' ').next()?)
    }
}

/// A scale factor as printed: `0.005`, `2.5·10⁻⁷`.
fn number(said: &str) -> Option<f64> {
    let raised =
        |c: char| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).and_then(|i| "-0123456789".chars().nth(i));
    let exponent: String = said.chars().filter_map(raised).collect();
    if exponent.is_empty() {
        return said.parse().ok();
    }
    let (mantissa, _) = said.split_once("10")?;
    let mantissa = mantissa.strip_suffix('·').unwrap_or("1");
    format!("{mantissa}e{exponent}").parse().ok()
}

#[test]
fn factors_are_read() {
    for (said, factor) in [("0.005", 0.005), ("10", 10.0), ("4·10⁻⁹", 4e-9), ("10⁶", 1e6), ("100", 100.0)]
    {
        assert_eq!(number(said), Some(factor), "{said}");
    }
}
