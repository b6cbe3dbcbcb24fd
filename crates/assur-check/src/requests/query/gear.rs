//! What is asked of a pair of gears: `table(z12).da1`, `contact_ratio(z12)`, `tooth_force(z12, M).Ft`.

use crate::expr::read::no_part;
use crate::requests::query::not_a_quantity;
use assur_text::language::Function;
/// A number of the pair, or one of each wheel.
enum Number {
    Pair(fn(&GearPair) -> f64),
    Wheel(fn(&GearPair, &Gear, usize) -> f64),
}
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::ThingKind;
use crate::values::fold::binary;
use crate::values::typed::{Type, Typed};
use Number::{Pair, Wheel};
use assur_math::element::gear::{Gear, GearPair};
use assur_model::model::{BinaryOp, Expr as ModelExpr, FindKind, Table, TableEntry};
use assur_syntax::document::{Expr, ExprKind, FindItem, JointKind, Name};
use assur_text::source::Spanned;
use assur_text::units::Dimension;

const L: Dimension = Dimension::LENGTH;
const N: Dimension = Dimension::NUMBER;

/// The rows of a table: name, dimension, number. Those of a wheel are named with its number: `da1`.
const ROWS: [(&str, Dimension, Number); 23] = [
    ("m", L, Pair(|p| p.teeth.module)),
    ("alpha", Dimension::ANGLE, Pair(|p| p.teeth.pressure_angle)),
    ("alpha_w", Dimension::ANGLE, Pair(|p| p.alpha_w)),
    ("i", N, Pair(|p| p.teeth.z[1] / p.teeth.z[0])),
    ("a", L, Pair(|p| p.a)),
    ("p", L, Pair(|p| p.p)),
    ("pb", L, Pair(|p| p.pb)),
    ("c", L, Pair(|p| p.c)),
    ("z", N, Wheel(|p, _, i| p.teeth.z[i])),
    ("x", N, Wheel(|p, _, i| p.teeth.shift[i])),
    ("d", L, Wheel(|_, g, _| g.d)),
    ("da", L, Wheel(|_, g, _| g.da)),
    ("df", L, Wheel(|_, g, _| g.df)),
    ("db", L, Wheel(|_, g, _| g.db)),
    ("dw", L, Wheel(|_, g, _| g.dw)),
    ("s", L, Wheel(|_, g, _| g.s)),
    ("e", L, Wheel(|_, g, _| g.e)),
    ("sa", L, Wheel(|_, g, _| g.sa)),
    ("x_min", N, Wheel(|_, g, _| g.x_min)),
    ("slip", N, Wheel(|_, g, _| g.slip)),
    ("z_min", N, Pair(|p| p.z_min)),
    ("g", L, Pair(|p| p.g)),
    ("contact_ratio", N, Pair(|p| p.ratio)),
];

/// What a part stands for.
fn part_of(pair: &GearPair, part: &str) -> Option<(f64, Dimension)> {
    ROWS.iter().find_map(|(name, dimension, number)| match number {
        Pair(of) if *name == part => Some((of(pair), *dimension)),
        Wheel(of) => {
            let wheel = part.strip_prefix(name)?;
            let index = ["1", "2"].iter().position(|w| *w == wheel)?;
            Some((of(pair, &pair.gears[index], index), *dimension))
        }
        Pair(_) => None,
    })
}

fn part_list() -> String {
    let name = |(name, _, number): &(&str, Dimension, Number)| match number {
        Pair(_) => format!("`.{name}`"),
        Wheel(_) => format!("`.{name}1`, `.{name}2`"),
    };
    format!("its parts are {}", ROWS.iter().map(name).collect::<Vec<_>>().join(", "))
}

/// A part of it, with its factor.
type RatePart = (&'static str, fn(&GearPair) -> f64);

/// What is proportional to a value given of wheel 1.
#[derive(Clone, Copy)]
pub(crate) enum GearRate {
    /// Forces between the teeth, for a torque.
    ToothForce,
    /// Sliding at the tips, for a speed.
    SlidingVelocity,
}

impl GearRate {
    /// Of what is given, and of what comes out.
    const fn dimensions(self) -> (Dimension, Dimension) {
        match self {
            Self::ToothForce => (Dimension::TORQUE, Dimension::FORCE),
            Self::SlidingVelocity => (Dimension::ANGULAR_VELOCITY, Dimension::VELOCITY),
        }
    }

    /// Its parts, each with the factor.
    fn parts(self) -> &'static [RatePart] {
        match self {
            Self::ToothForce => {
                &[("Ft", |p| p.forces()[0]), ("Fr", |p| p.forces()[1]), ("Fn", |p| p.forces()[2])]
            }
            Self::SlidingVelocity => &[("v1", |p| p.sliding(0)), ("v2", |p| p.sliding(1))],
        }
    }

    fn part_list(self) -> String {
        let parts = match self {
            Self::ToothForce => "`.Ft`, `.Fr`, `.Fn`",
            Self::SlidingVelocity => "`.v1` (at the tip of wheel 1), `.v2`",
        };
        format!("its parts are {parts}")
    }
}

impl Context<'_> {
    /// The pair of gears that an argument names.
    fn mesh_argument(&mut self, call: Call<'_>, expr: &Expr) -> Option<GearPair> {
        let ExprKind::Name(name) = &expr.kind else {
            self.wrong_argument(call, "a mesh", expr.span);
            return None;
        };
        let name = Spanned::new(name.clone(), expr.span);
        let fits = |k: ThingKind| k == ThingKind::Joint(JointKind::Mesh);
        self.names.note_thing(&name);
        if self.names.things.get(&name.node).is_some_and(|d| fits(d.what)) {
            return self.gear_pair(&name.node, call.span);
        }
        self.no_thing(&name, "mesh", "a mesh", fits);
        None
    }

    /// `contact_ratio(z12)`
    pub(crate) fn contact_ratio(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.mesh_argument(call, args[0])?;
        Some(Typed::constant(pair.ratio, N))
    }

    /// `table(z12).da1`
    pub(crate) fn gear_part(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.mesh_argument(call, args[0])?;
        match part_of(&pair, &part.node) {
            Some((value, dimension)) if value.is_finite() => Some(Typed::constant(value, dimension)),
            Some(_) => {
                let help = Some("a ring has none".to_owned());
                self.error(no_part(&part.node, part.span, help));
                None
            }
            None => {
                let help = Some(part_list());
                self.error(no_part(&part.node, part.span, help));
                None
            }
        }
    }

    /// `tooth_force(z12, M1).Ft` for a torque on wheel 1; `sliding_velocity(z12, omega1).v1` for its speed.
    pub(crate) fn gear_rate(&mut self, call: Call<'_>, rate: GearRate, part: &Name) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let pair = self.mesh_argument(call, args[0]);
        let given = self.read(args[1]);
        let (from, to) = rate.dimensions();
        let given = self.fit(given?, from, "the value for wheel 1", args[1])?;
        let pair = pair?;
        let Some((_, of)) = rate.parts().iter().find(|(name, _)| *name == part.node) else {
            let help = Some(rate.part_list());
            self.error(no_part(&part.node, part.span, help));
            return None;
        };
        let factor = of(&pair);
        if given.pending {
            return Some(Typed::pending(Type::number(to)));
        }
        let expr = binary(BinaryOp::Mul, given.expr, ModelExpr::number(factor));
        Some(Typed::new(expr, Type::number(to)))
    }

    /// A table of gears without one of its parts.
    pub(crate) fn gear_table_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        self.gear_alone(call, part_list())
    }

    /// Forces or velocities of teeth without one of their parts.
    pub(crate) fn gear_rate_alone(&mut self, call: Call<'_>, rate: GearRate) -> Option<Typed> {
        self.gear_alone(call, rate.part_list())
    }

    fn gear_alone(&mut self, call: Call<'_>, help: String) -> Option<Typed> {
        let path = format!("{}(…)", call.name.node);
        self.error(not_a_quantity(&path, call.span, Some(help)));
        None
    }

    /// `find table(z12)`; `None` where the item asks no table of gears.
    pub(crate) fn gear_table(&mut self, item: &FindItem) -> Option<Option<FindKind>> {
        let ExprKind::Call { function, args } = &item.value.kind else { return None };
        if Function::named(&function.node) != Some(Function::Table)
            || item.name.is_some()
            || item.steps.is_some()
            || item.unit.is_some()
        {
            return None;
        }
        let sign = crate::expr::results::Sign::Matters;
        let call = Call { name: function, args, span: item.value.span, sign };
        let pair = self.arguments(call, 1, 1).and_then(|args| self.mesh_argument(call, args[0]));
        Some(pair.map(|pair| {
            let entry = |(name, dimension, number): &(&str, Dimension, Number)| TableEntry {
                name: (*name).to_owned(),
                display: self.values.display(*dimension),
                values: match number {
                    Pair(of) => vec![of(&pair)],
                    Wheel(of) => (0..2).map(|i| of(&pair, &pair.gears[i], i)).collect(),
                },
                found: Vec::new(),
            };
            FindKind::Table(Table { entries: ROWS.iter().map(entry).collect(), upright: true })
        }))
    }
}
