//! Several masses of a link: their sum, their common centre, and the moment of inertia by Steiner's theorem.

use crate::course::Derivation;
use crate::document::{Inline, Line, Table, text};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit, name_node, with_digits};
use assur_model::model::{MassPart, MassProperties, MassShape};

type Coordinate = fn(&MassProperties) -> f64;

impl Derivation<'_> {
    /// The table m, x, y, m x, m y with its sums, and what follows from them.
    pub(super) fn sum_of_masses(&mut self, body: usize, whole: MassProperties, parts: &[MassPart]) {
        let label = self.label(body);
        if let [only] = parts {
            let mass = self.given(Name::new("m", &label), whole.mass, Unit::Mass);
            let centre = self.point_name(body, whole.centre);
            self.own_inertia(&centre, &centre, only, &mass);
        }
        if parts.len() < 2 {
            return;
        }
        let names = self.names_of_parts(body, parts);
        self.say(Message::SeveralMasses, &[vec![text(label.clone())]]);
        self.table(table_of(&names, parts));
        let masses: Vec<Expr> = (names.iter().zip(parts))
            .map(|(name, p)| self.given(Name::new("m", &format!("{label},{name}")), p.own.mass, Unit::Mass))
            .collect();
        let sum = masses.iter().fold(Expr::ZERO, |sum, m| sum + m.clone());
        let mass = self.equate(Name::new("m", &label), whole.mass, Unit::Mass, sum);
        let centre = self.point_name(body, whole.centre);
        let along = [("ξ", (|p| p.centre.x) as Coordinate), ("η", |p| p.centre.y)];
        // of each mass its coordinates against the common centre
        let mut apart = vec![Vec::new(); parts.len()];
        for (letter, of) in along {
            let places: Vec<Expr> = (names.iter().zip(parts))
                .map(|(name, p)| self.given(Name::new(letter, name), of(&p.own), Unit::Length))
                .collect();
            let moments =
                masses.iter().zip(&places).fold(Expr::ZERO, |sum, (m, at)| sum + m.clone() * at.clone());
            let middle =
                self.equate(Name::new(letter, &centre), of(&whole), Unit::Length, moments / mass.clone());
            for (apart, at) in apart.iter_mut().zip(places) {
                apart.push(at - middle.clone());
            }
        }
        self.steiner(&label, (&names, &masses, &apart), &centre, whole, parts);
    }

    /// J_S = Σ (J_i + m_i d_i²); not where the file gives the moment of inertia of the whole link.
    fn steiner(
        &mut self,
        label: &str,
        (names, masses, apart): (&[String], &[Expr], &[Vec<Expr>]),
        centre: &str,
        whole: MassProperties,
        parts: &[MassPart],
    ) {
        let distance = |p: &MassPart| (p.own.centre - whole.centre).norm();
        let of_part = |p: &MassPart| p.own.inertia + p.own.mass * distance(p) * distance(p);
        let sum: f64 = parts.iter().map(of_part).sum();
        if (sum - whole.inertia).abs() > 1e-9 * whole.inertia {
            return;
        }
        let mut right = Expr::ZERO;
        for (((name, p), m), apart) in names.iter().zip(parts).zip(masses).zip(apart) {
            right = right + self.own_inertia(&format!("{label},{name}"), name, p, m);
            if distance(p) <= self.tiny {
                continue;
            }
            let apart: Vec<Expr> = apart.iter().filter(|part| !part.is_zero()).cloned().collect();
            let length = match apart.as_slice() {
                [only] => only.clone().abs(),
                all => Expr::Root(Box::new(
                    all.iter().fold(Expr::ZERO, |sum, part| sum + part.clone().squared()),
                )),
            };
            let d = self.equate(Name::new("d", name), distance(p), Unit::Length, length);
            right = right + m.clone() * d.squared();
        }
        self.equate(Name::new("J", centre), whole.inertia, Unit::Inertia, right);
    }

    /// The moment of inertia of a part about its own centre: of a shape by its formula, else as given.
    fn own_inertia(&mut self, index: &str, at: &str, part: &MassPart, mass: &Expr) -> Expr {
        let name = Name::new("J", index);
        let length = |letter: &str, value| self.given(Name::new(letter, at), value, Unit::Length);
        let right = match part.shape {
            None | Some(MassShape::Plate { .. }) => return self.given(name, part.own.inertia, Unit::Inertia),
            Some(MassShape::Rod { from, to }) => {
                mass.clone() * length("l", (to - from).norm()).squared() / Expr::Int(12)
            }
            Some(MassShape::Disc { radius, inner }) => {
                let radii = length("r", radius).squared() + length("q", inner).squared();
                mass.clone() * radii / Expr::Int(2)
            }
            Some(MassShape::Ring { radius }) => mass.clone() * length("r", radius).squared(),
            Some(MassShape::Sphere { radius }) => {
                Expr::Int(2) * mass.clone() * length("r", radius).squared() / Expr::Int(5)
            }
        };
        self.equate(name, part.own.inertia, Unit::Inertia, right)
    }

    /// The names of the centres of the parts: where two share one, each has its number.
    fn names_of_parts(&self, body: usize, parts: &[MassPart]) -> Vec<String> {
        let names: Vec<String> = parts.iter().map(|p| self.point_name(body, p.own.centre)).collect();
        let shared = |name: &String| names.iter().filter(|other| *other == name).count() > 1;
        let shaped = parts.iter().any(|p| p.shape.is_some());
        let numbered = names.iter().enumerate().map(|(i, name)| match shared(name) && shaped {
            true => format!("{name}{}", i + 1),
            false => name.clone(),
        });
        numbered.collect()
    }
}

fn table_of(names: &[String], parts: &[MassPart]) -> Table {
    let letter = |letter: &str, unit: &str| -> Line {
        vec![Inline::Math(name_node(&Name::new(letter, ""))), text(format!(", {unit}"))]
    };
    let headers = vec![
        vec![text("")],
        letter("m", "kg"),
        letter("ξ", "m"),
        letter("η", "m"),
        letter("mξ", "kg·m"),
        letter("mη", "kg·m"),
    ];
    let figure = |x: f64| vec![text(with_digits(x, 6).text())];
    let row = |name: String, [m, x, y, mx, my]: [f64; 5]| {
        vec![vec![text(name)], figure(m), figure(x), figure(y), figure(mx), figure(my)]
    };
    let mut sums = [0.0; 3];
    let mut rows = Vec::new();
    for (name, p) in names.iter().zip(parts) {
        let (m, at) = (p.own.mass, p.own.centre);
        sums = [sums[0] + m, sums[1] + m * at.x, sums[2] + m * at.y];
        rows.push(row(name.clone(), [m, at.x, at.y, m * at.x, m * at.y]));
    }
    let [m, x, y] = sums;
    rows.push(vec![vec![text("Σ")], figure(m), Line::new(), Line::new(), figure(x), figure(y)]);
    Table { headers, rows, numbers: (1..6).collect() }
}
