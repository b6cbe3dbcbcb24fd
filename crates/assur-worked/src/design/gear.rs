//! Involute gears: every measure of the table with its formula, lengths in mm.

use super::page::{Page, given};
use crate::course::plain;
use crate::document::{Block, Figure, text};
use crate::localised::drawing_in;
use crate::pictures::drawn_for_paper;
use crate::words::{DesignMessage as Message, say};
use assur_drawing::Theme;
use assur_formula::{Expr, Function, Name, Unit};
use assur_model::model::{FindKind, Mechanism, Table};
use assur_picture::{Kind, Options, Subject};
use assur_solve::solve::Solution;

/// Measures that are lengths.
const LENGTHS: [&str; 14] = ["m", "a", "p", "pb", "c", "d", "da", "df", "db", "dw", "s", "e", "sa", "g"];

/// The values of a table of gears.
struct Gears<'a> {
    table: &'a Table,
    name: String,
}

impl Gears<'_> {
    /// A measure: a length in mm, an angle in rad.
    fn value(&self, name: &str, i: usize) -> f64 {
        let Some(entry) = self.table.entries.iter().find(|e| e.name == name) else { return f64::NAN };
        let scale = if LENGTHS.contains(&name) { 1e3 } else { 1.0 };
        entry.values.get(i).map_or(f64::NAN, |x| scale * x)
    }

    /// Letters with the wheel and the mesh where there are several.
    fn letters(&self, letter: &str, sub: &str) -> Name {
        let sub = if self.name.is_empty() { sub.to_owned() } else { format!("{sub},{}", self.name) };
        Name::new(letter, sub.trim_start_matches(','))
    }
}

/// What formulas of a pair begin with.
struct Teeth {
    z: [Expr; 2],
    x: [Expr; 2],
    module: Expr,
    alpha: Expr,
    addendum: Expr,
    clearance: Expr,
    internal: bool,
}

fn tan(angle: &Expr) -> Expr {
    angle.clone().of(Function::Tan)
}

/// An angle in degrees as radians.
fn radians(angle: &Expr) -> Expr {
    angle.clone() * Expr::Pi / Expr::Int(180)
}

impl Page {
    pub(super) fn gears(&mut self, mechanism: &Mechanism, solution: &Solution) {
        let tables: Vec<(&str, &Table)> = mechanism
            .finds
            .iter()
            .filter_map(|find| match &find.kind {
                FindKind::Table(table) if table.upright => Some((find.name.as_str(), table)),
                _ => None,
            })
            .collect();
        for (name, table) in &tables {
            let mesh = name.trim_start_matches("table(").trim_end_matches(')');
            let several = if tables.len() > 1 { mesh.to_owned() } else { String::new() };
            self.heading(Message::GearsOf, &[vec![text(mesh)]]);
            self.picture_of_gears(mechanism, solution, mesh);
            self.say(Message::LengthsInMillimetres, &[]);
            self.gear_pair(&Gears { table, name: several });
        }
    }

    /// The two wheels from the front, under the heading of their mesh.
    fn picture_of_gears(&mut self, mechanism: &Mechanism, solution: &Solution, mesh: &str) {
        let subject = Subject::without_position(mechanism, solution, "");
        let drawings = drawn_for_paper(Kind::Gears, subject, &Options::default());
        let own = mechanism.gears.iter().zip(drawings).find(|(gears, _)| gears.mesh == mesh);
        let Some((_, drawing)) = own else { return };
        let mut drawing = drawing_in(self.language, mechanism, drawing);
        drawing.title = plain(&say(self.language, Message::GearsOf, &[vec![text(mesh)]]));
        let caption = drawing.title.clone();
        let svg = drawing.placed().svg(Theme::Auto);
        self.blocks.push(Block::Figures(vec![Figure { svg, name: Kind::Gears.name().to_owned(), caption }]));
    }

    fn gear_pair(&mut self, gears: &Gears<'_>) {
        let (m, alpha) = (gears.value("m", 0), gears.value("alpha", 0));
        let z = [gears.value("z", 0), gears.value("z", 1)];
        let x = [gears.value("x", 0), gears.value("x", 1)];
        let (a, da, d) = (gears.value("a", 0), gears.value("da", 0), gears.value("d", 0));
        if ![m, alpha, z[0], z[1], x[0], x[1], a, da, d].iter().all(|x| x.is_finite()) {
            return;
        }
        let internal = a < 0.5 * m * (z[0] + z[1]) - 0.5 * m * z[0];
        let sign = if internal { -1.0 } else { 1.0 };
        // the file gives them in modules: what is left of the tip circle
        let short = if internal { 0.0 } else { x[0] + x[1] - (a / m - 0.5 * (z[0] + z[1])) };
        let part = |value: f64| (value * 1e9).round() / 1e9;
        let of = |letter: &str, i: usize, value: f64| {
            given(gears.letters(letter, &(i + 1).to_string()), value, Unit::One)
        };
        let teeth = Teeth {
            z: [of("z", 0, z[0]), of("z", 1, z[1])],
            x: [of("x", 0, x[0]), of("x", 1, x[1])],
            module: given(gears.letters("m", ""), m, Unit::Millimetre),
            alpha: given(gears.letters("α", ""), alpha.to_degrees(), Unit::Angle),
            addendum: given(
                gears.letters("h", "a").marked("*"),
                part(0.5 * (da - d) / m - x[0] + short),
                Unit::One,
            ),
            clearance: given(gears.letters("c", "").marked("*"), part(gears.value("c", 0) / m), Unit::One),
            internal,
        };
        let ratio = teeth.z[1].clone() / teeth.z[0].clone();
        self.equate(gears.letters("i", ""), gears.value("i", 0), Unit::One, ratio);
        let (alpha_w, distance) = self.centre_distance(gears, &teeth, sign);
        let shortened = self.shortened(gears, &teeth, &distance);
        let pitch = self.equate(
            gears.letters("p", ""),
            gears.value("p", 0),
            Unit::Millimetre,
            Expr::Pi * teeth.module.clone(),
        );
        let base = pitch.clone() * teeth.alpha.clone().cos();
        let base = self.equate(gears.letters("p", "b"), gears.value("pb", 0), Unit::Millimetre, base);
        let clearance = teeth.clearance.clone() * teeth.module.clone();
        self.equate(gears.letters("c", ""), gears.value("c", 0), Unit::Millimetre, clearance);
        let tips = [0, 1].map(|i| self.wheel(gears, &teeth, (&shortened, &alpha_w), &pitch, i));
        self.say(Message::MeshOf, &[]);
        let least = Expr::Int(2) * teeth.addendum.clone() / teeth.alpha.clone().sin().squared();
        self.equate(gears.letters("z", "min"), gears.value("z_min", 0), Unit::One, least);
        let [one, two] = [0, 1].map(|i| teeth.z[i].clone() * (tan(&tips[i]) - tan(&alpha_w)));
        let sum = if teeth.internal { one - two } else { one + two };
        let ratio = sum / (Expr::Int(2) * Expr::Pi);
        let ratio = self.equate(gears.letters("ε", ""), gears.value("contact_ratio", 0), Unit::One, ratio);
        self.equate(gears.letters("g", ""), gears.value("g", 0), Unit::Millimetre, ratio * base);
        self.say(Message::SlidingOf, &[]);
        for i in [0, 1] {
            self.sliding(gears, &teeth, (&tips[1 - i], &alpha_w), i);
        }
    }

    /// The working pressure angle and the centre distance.
    fn centre_distance(&mut self, gears: &Gears<'_>, teeth: &Teeth, sign: f64) -> (Expr, Expr) {
        let both = |of: &[Expr; 2]| {
            let [one, two] = of.clone();
            if sign < 0.0 { two - one } else { one + two }
        };
        let (z, x) = (both(&teeth.z), both(&teeth.x));
        let plain =
            |more: Expr, below: Expr| teeth.module.clone() * z.clone() * more / (Expr::Int(2) * below);
        if x.is_zero() || gears.value("alpha_w", 0) == gears.value("alpha", 0) {
            let a = self.equate(
                gears.letters("a", ""),
                gears.value("a", 0),
                Unit::Millimetre,
                plain(Expr::Int(1), Expr::Int(1)),
            );
            return (teeth.alpha.clone(), a);
        }
        let involute = tan(&teeth.alpha) - radians(&teeth.alpha);
        let right = involute + Expr::Int(2) * x * tan(&teeth.alpha) / z.clone();
        self.named(gears.letters("inv α", "w"), Unit::One, right);
        self.say(Message::InvoluteSolved, &[]);
        let angle = self.stated(gears.letters("α", "w"), gears.value("alpha_w", 0).to_degrees(), Unit::Angle);
        let a = plain(teeth.alpha.clone().cos(), angle.clone().cos());
        let a = self.equate(gears.letters("a", ""), gears.value("a", 0), Unit::Millimetre, a);
        (angle, a)
    }

    /// What the tips of an external pair with shifts are shortened by, in modules.
    fn shortened(&mut self, gears: &Gears<'_>, teeth: &Teeth, distance: &Expr) -> Expr {
        let sum = teeth.x[0].clone() + teeth.x[1].clone();
        if teeth.internal || gears.value("alpha_w", 0) == gears.value("alpha", 0) {
            return Expr::ZERO;
        }
        let plain = (teeth.z[0].clone() + teeth.z[1].clone()) / Expr::Int(2);
        let right = sum - distance.clone() / teeth.module.clone() + plain;
        self.named(gears.letters("k", ""), Unit::One, right)
    }

    /// The diameters and the tooth of a wheel; its pressure angle at the tip.
    fn wheel(
        &mut self,
        gears: &Gears<'_>,
        teeth: &Teeth,
        (short, alpha_w): (&Expr, &Expr),
        pitch: &Expr,
        i: usize,
    ) -> Expr {
        let own = (i + 1).to_string();
        let count = text(teeth.z[i].value().round().to_string());
        self.say(Message::WheelOf, &[vec![text(own.clone())], vec![count]]);
        let ring = teeth.internal && i == 1;
        let out = |x: Expr| if ring { -x } else { x };
        let two = || Expr::Int(2) * teeth.module.clone();
        let x = &teeth.x[i];
        let length = |page: &mut Self, letter: &str, sub: &str, key: &str, right: Expr| {
            page.equate(
                gears.letters(letter, &format!("{sub}{own}")),
                gears.value(key, i),
                Unit::Millimetre,
                right,
            )
        };
        let d = length(self, "d", "", "d", teeth.module.clone() * teeth.z[i].clone());
        let head = out(teeth.addendum.clone()) + x.clone() - short.clone();
        let da = length(self, "d", "a", "da", d.clone() + two() * head);
        let foot = out(teeth.addendum.clone() + teeth.clearance.clone()) - x.clone();
        length(self, "d", "f", "df", d.clone() - two() * foot);
        let db = length(self, "d", "b", "db", d.clone() * teeth.alpha.clone().cos());
        length(self, "d", "w", "dw", db.clone() / alpha_w.clone().cos());
        let more = out(Expr::Int(2) * x.clone() * tan(&teeth.alpha));
        let thick = teeth.module.clone() * (Expr::Pi / Expr::Int(2) + more);
        let s = length(self, "s", "", "s", thick);
        length(self, "e", "", "e", pitch.clone() - s.clone());
        let least = teeth.alpha.clone().sin().squared() * teeth.z[i].clone() / Expr::Int(2);
        if !ring {
            let least = teeth.addendum.clone() - least;
            self.equate(gears.letters("x", &format!("min{own}")), gears.value("x_min", i), Unit::One, least);
        }
        let right = (db / da.clone()).of(Function::Arccos);
        let tip = self.named(gears.letters("α", &format!("a{own}")), Unit::Angle, right);
        let involute = |angle: &Expr| tan(angle) - radians(angle);
        let bend = out(involute(&teeth.alpha) - involute(&tip));
        length(self, "s", "a", "sa", da * (s / d + bend));
        tip
    }

    /// How much of the speed of its flank a wheel slides by, at the end of the line of contact at its root; with the pressure angle at the tip of
    /// the other wheel.
    fn sliding(&mut self, gears: &Gears<'_>, teeth: &Teeth, (tip, alpha_w): (&Expr, &Expr), i: usize) {
        let [own, other] = [i, 1 - i].map(|i| teeth.z[i].clone());
        let reach = other * (tan(tip) - tan(alpha_w));
        let root = own.clone() * tan(alpha_w);
        let root = if teeth.internal { root + reach } else { root - reach };
        let right = Expr::Int(1) - own * tan(tip) / root;
        let name = gears.letters("ζ", &(i + 1).to_string());
        self.equate(name, gears.value("slip", i), Unit::One, right);
    }
}
