//! A row of variants put into a mechanism that was checked with another one: the numbers that depend on its columns are
//! computed again, and nothing else is looked at.
//!
//! Which numbers of the mechanism these are is found by checking the document with some rows beside the first: numbers that
//! differ are what an expression of the document comes to, or minus that, in all of them. Where one is something else, or
//! where a row may change more than numbers (see [`crate::row_places`]), every row is checked as a whole; so is a row with a
//! number that a check would look at twice.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::requests::tolerance::MOST as MOST_OF_VALUE;
use crate::row_places::{Asked, depends, is_plain, places};
use crate::row_program::{Compiled, Program, Register};
use crate::template::Template;
use crate::values::definition::Settled;
use crate::values::row::{ColumnUse, Row, RowCell, RowColumn};
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{Expr, FindKind, LinkId, Mechanism, Value};
use assur_syntax::document;
use assur_syntax::document::ExprKind;
use assur_text::units::Dimension;
use indexmap::IndexSet;
use std::f64::consts::PI;
use std::sync::Arc;

/// Rows that are checked beside the first one.
const PROBES: usize = 3;
/// Rows that are tried for that.
const TRIED: u32 = 12;

/// A number of the mechanism: its place among those of [`Mechanism::each_number`], and the register that it has the value of.
#[derive(Clone, Copy, Debug)]
struct Slot {
    place: usize,
    from: Signed,
}

/// A register, or minus it.
#[derive(Clone, Copy, Debug)]
struct Signed {
    register: Register,
    minus: bool,
}

/// What is done for a row.
#[derive(Clone, Debug)]
pub struct RowPatches {
    columns: Arc<[RowColumn]>,
    program: Program,
    asked: Vec<(Register, Asked)>,
    slots: Vec<Slot>,
    /// What could not be told apart: both have the same value.
    alike: Vec<(Signed, Signed)>,
    /// What does not change with the columns that were tried: it has this value.
    fixed: Vec<(Register, f64)>,
    /// Pairs of points of links whose points move, and whether they lie on one another.
    moved: Vec<(LinkId, [usize; 2], bool)>,
}

impl Signed {
    fn of(self, values: &[f64]) -> f64 {
        let value = values[self.register];
        if self.minus { -value } else { value }
    }
}

impl RowPatches {
    /// Finds what is to be done for rows with the columns of this one.
    pub(crate) fn of(template: &mut Template<'_>, row: &Row) -> Option<Self> {
        let (first, problems) = template.check(row);
        let mut first = first.filter(|m| problems.is_empty() && is_simple(m))?;
        let (program, asked) = template.within(row, |cx| compiled(cx, row))?;
        let mut patches = Self {
            columns: row.columns().clone(),
            program,
            asked,
            slots: Vec::new(),
            alike: Vec::new(),
            fixed: Vec::new(),
            moved: Vec::new(),
        };
        let mut probes = vec![patches.probe(row, &mut first)?];
        let shape = shape(&first);
        for seed in 1..=TRIED {
            let other = beside(row, seed);
            let (found, problems) = template.check(&other);
            if let Some(mut found) = found.filter(|_| problems.is_empty()) {
                // another shape is found by these rows alone
                if self::shape(&found) != shape {
                    return None;
                }
                probes.extend(patches.probe(&other, &mut found));
            }
            if probes.len() > PROBES {
                break;
            }
        }
        (probes.len() > PROBES).then_some(())?;
        patches.slots(&probes)?;
        patches.moved = moved(&first, &patches.slots);
        Some(patches)
    }

    /// Numbers of the mechanism and of the registers with a row.
    fn probe(&mut self, row: &Row, mechanism: &mut Mechanism) -> Option<Probe> {
        self.program.run(row).then(|| {
            let mut numbers = Vec::new();
            mechanism.each_number(&mut |x| numbers.push(*x));
            Probe { numbers, values: self.program.values().to_vec() }
        })
    }

    fn slots(&mut self, probes: &[Probe]) -> Option<()> {
        let first = &probes[0];
        let varies = |of: &dyn Fn(&Probe) -> f64| probes.iter().any(|p| !is_same(of(p), of(first)));
        for register in 0..first.values.len() {
            if !self.program.is_known(register) && !varies(&|p| p.values[register]) {
                self.fixed.push((register, first.values[register]));
            }
        }
        let signed = |minus| move |register| Signed { register, minus };
        let all =
            || (0..first.values.len()).map(signed(false)).chain((0..first.values.len()).map(signed(true)));
        for place in 0..first.numbers.len() {
            if !varies(&|p| p.numbers[place]) {
                continue;
            }
            let fits = |s: &Signed| probes.iter().all(|p| is_same(s.of(&p.values), p.numbers[place]));
            let mut fitting = all().filter(fits);
            let from = fitting.next()?;
            self.slots.push(Slot { place, from });
            self.alike.extend(fitting.map(|other| (from, other)));
        }
        Some(())
    }

    /// Puts a row into a mechanism of this document; `false` where the row is to be checked as a whole. The mechanism is then
    /// that of no row.
    pub fn put(&mut self, row: &Row, mechanism: &mut Mechanism) -> bool {
        if !Arc::ptr_eq(row.columns(), &self.columns) || !self.program.run(row) || !self.is_sound() {
            return false;
        }
        let values = self.program.values();
        let (mut slots, mut place) = (self.slots.iter().peekable(), 0);
        mechanism.each_number(&mut |x| {
            if let Some(slot) = slots.next_if(|slot| slot.place == place) {
                *x = slot.from.of(values);
            }
            place += 1;
        });
        self.moved.iter().all(|(link, [i, j], together)| {
            let points = &mechanism.link(*link).points;
            (points[*i].at == points[*j].at) == *together
        })
    }

    fn is_sound(&self) -> bool {
        let values = self.program.values();
        let fits = |(register, asked): &(Register, Asked)| match asked {
            Asked::Nothing | Asked::Direction => true,
            Asked::Positive | Asked::Weight => values[*register] > 0.0,
            Asked::NotNegative => values[*register] >= 0.0,
            Asked::NotZero => values[*register] != 0.0,
            Asked::LessThanHalf => values[*register] < PI,
        };
        self.asked.iter().all(fits)
            && self.fixed.iter().all(|(register, value)| is_same(values[*register], *value))
            && self.alike.iter().all(|(a, b)| is_same(a.of(values), b.of(values)))
    }
}

struct Probe {
    numbers: Vec<f64>,
    values: Vec<f64>,
}

/// To the last bit.
const fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

/// Whether nothing in a mechanism is found by solving it again or from tables.
fn is_simple(mechanism: &Mechanism) -> bool {
    !mechanism.asks_again()
        && mechanism.unsupported.is_empty()
        && !mechanism.has_curves
        && !mechanism.finds.iter().any(|f| matches!(f.kind, FindKind::Table(_)))
}

/// All of a mechanism but its numbers.
fn shape(mechanism: &Mechanism) -> String {
    let mut blank = mechanism.clone();
    blank.each_number(&mut |x| *x = 0.0);
    format!("{blank:?}")
}

/// A row near this one, of numbers with many digits.
fn beside(row: &Row, seed: u32) -> Row {
    let mut state = u64::from(seed);
    let mut part = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 32) as u32) / f64::from(u32::MAX)
    };
    let mut moved =
        |x: f64, by: f64| if x == 0.0 { 0.01 * by * part() } else { x * (1.0 + by * (part() - 0.5)) };
    // a smaller change may be one that the document admits
    let by = 0.4 / f64::from(1 + seed / 4);
    let cells = row.entries().map(|(_, c)| RowCell { value: moved(c.value, by), digit: moved(c.digit, by) });
    Row::new(row.columns().clone(), cells.collect())
}

/// Pairs of points of links with points that the row moves, and whether they lie on one another.
fn moved(mechanism: &Mechanism, slots: &[Slot]) -> Vec<(LinkId, [usize; 2], bool)> {
    let mut first = mechanism.clone();
    let (mut slots, mut place) = (slots.iter().map(|s| s.place).peekable(), 0);
    first.each_number(&mut |x| {
        *x = if slots.next_if_eq(&place).is_some() { f64::NAN } else { 0.0 };
        place += 1;
    });
    let moves = |at: Vec2| at.x.is_nan() || at.y.is_nan();
    let mut pairs = Vec::new();
    for (index, link) in first.links.iter().enumerate() {
        let points = &mechanism.links[index].points;
        for j in 0..points.len() {
            for i in (0..j).filter(|&i| moves(link.points[i].at) || moves(link.points[j].at)) {
                pairs.push((LinkId::at(index), [i, j], points[i].at == points[j].at));
            }
        }
    }
    pairs
}

/// The operations behind all expressions of the document that go with the row.
fn compiled(cx: &mut Context<'_>, row: &Row) -> Option<(Program, Vec<(Register, Asked)>)> {
    let mut program = Program::new(cx.builder.mech.quantities.len());
    let names = symbols(cx, row, &mut program)?;
    let mut all = Vec::new();
    let places = places(cx.doc, &names)?;
    for (value, within) in places.expected {
        expected(cx, row, &mut program, &mut all, (value, within))?;
    }
    for (expr, asked) in places.found {
        let read = cx.quietly(|cx| cx.read(expr))?;
        match (program.compile(&read.expr)?, asked) {
            (_, Asked::Nothing) => {}
            (Compiled::Number(register), Asked::Direction) => program.direction(register),
            (Compiled::Number(register), asked) => {
                if let (Asked::Weight, Some(gravity)) = (asked, cx.builder.mech.gravity) {
                    let g = gravity.acceleration;
                    program.mass(register, libm::hypot(g.x, g.y));
                }
                all.push((register, asked));
            }
            _ => return None,
        }
    }
    Some((program, all))
}

/// A value of the answer key that goes with the row, and its tolerance: a share of it as written, or one that follows from
/// the digits of a column.
fn expected(
    cx: &mut Context<'_>,
    row: &Row,
    program: &mut Program,
    all: &mut Vec<(Register, Asked)>,
    (value, within): (&document::Expr, Option<&document::Expr>),
) -> Option<()> {
    let read = cx.quietly(|cx| cx.read(value))?;
    let register = match program.compile(&read.expr)? {
        Compiled::Number(register) => register,
        Compiled::Vector(x, y) => program.magnitude(x, y),
        Compiled::Constant(_) | Compiled::Result => return None,
    };
    let (share, digit) = match within {
        Some(within) => {
            let share = cx.quietly(|cx| cx.read(within))?;
            (share.ty.dimension() == Dimension::NUMBER).then_some(())?;
            let Some(Value::Scalar(share)) = share.value() else { return None };
            (share, None)
        }
        None => {
            let ExprKind::Name(name) = &value.kind else { return None };
            let is = |c: &RowColumn| c.what != ColumnUse::Label && c.set.is_none() && c.name == *name;
            (MOST_OF_VALUE, Some(row.columns().iter().position(is)?))
        }
    };
    let size = program.share(share, register, digit);
    all.push((register, Asked::NotZero));
    // angles do not differ by more
    if read.ty.dimension().is_dimensionless() {
        all.push((size, Asked::LessThanHalf));
    }
    Some(())
}

/// Lets a register stand for each definition that goes with the row; gives their names.
fn symbols(cx: &mut Context<'_>, row: &Row, program: &mut Program) -> Option<IndexSet<String>> {
    let columns = row.columns().clone();
    let mut names = IndexSet::new();
    for (index, column) in columns.iter().enumerate().filter(|(_, c)| c.what == ColumnUse::Key) {
        let register = program.cell(index);
        let key = Typed::new(program.symbol(register), Type::number(column.dimension));
        cx.values.outside.keys.insert(column.name.clone(), key);
        names.insert(column.name.clone());
    }
    for name in cx.values.definitions.order.clone() {
        let Some(QuantityKind::Given(expr) | QuantityKind::Let(expr)) =
            cx.names.quantities.get(&name).map(|d| d.what)
        else {
            continue;
        };
        let Some(Settled::Constant(typed)) = cx.values.definitions.settled.get(&name) else { continue };
        let ty = typed.ty;
        let mut symbol = None;
        if depends(&names, expr) {
            is_plain(&names, expr).then_some(())?;
            let read = cx.quietly(|cx| cx.read(expr))?;
            symbol = match program.compile(&read.expr)? {
                Compiled::Number(register) => Some(program.symbol(register)),
                Compiled::Vector(x, y) => {
                    let [x, y] = [x, y].map(|register| Box::new(program.symbol(register)));
                    Some(Expr::Vector(x, y))
                }
                Compiled::Constant(_) | Compiled::Result => return None,
            };
        }
        if cx.values.outside.is_set(&name) {
            continue;
        }
        let own = |c: &RowColumn| c.what == ColumnUse::Given && c.set.is_none() && c.name == name;
        if let Some(column) = columns.iter().position(own) {
            let register = program.cell(column);
            symbol = Some(program.symbol(register));
        }
        if let Some(expr) = symbol {
            cx.values.definitions.settled.insert(name.clone(), Settled::Constant(Typed::new(expr, ty)));
            names.insert(name);
        }
    }
    Some(names)
}
