//! Free bodies and levers as they are drawn: forces at the points where their arrows begin, in the directions of the arrows, with the
//! numbers that the picture says, and couples, add up to nothing.

use super::{Judged, number};
use assur::internals::drawing::{Shape, Sheet};
use assur::internals::math::Vec2;
use assur::internals::solve::Solved;
use std::collections::HashMap;

/// What a picture says in words of its forces and couples.
struct Said<'s> {
    text: &'s str,
    /// How many times a name was asked for: names may be several forces'.
    asked: HashMap<&'s str, usize>,
}

impl<'s> Said<'s> {
    fn of(text: &'s str) -> Self {
        Self { text, asked: HashMap::new() }
    }

    /// The next number of a name.
    fn next(&mut self, name: &'s str) -> Option<f64> {
        let times = self.asked.entry(name).or_default();
        *times += 1;
        let begins = |at: usize| self.text[..at].ends_with(' ');
        let all = self.text.match_indices(name).filter(|(at, _)| begins(*at)).filter_map(|(at, _)| {
            let rest = self.text[at + name.len()..].strip_prefix(' ')?;
            let end = rest.find([' ', ',']).unwrap_or(rest.len());
            rest[..end].trim_end_matches('.').replace('−', "-").parse().ok()
        });
        all.into_iter().nth(*times - 1)
    }
}

/// What numbers of five digits leave open.
const DIGITS: f64 = 5e-5;

/// What is seen on paper, mm.
const SEEN: f64 = 1e-3;

/// What equations of equilibrium leave.
const LEFT: f64 = 1e-6;

/// The length scale of a sheet, m/mm: what its caption says.
fn scale(sheet: &Sheet) -> Option<f64> {
    let captions = sheet.drawing.captions.iter().map(|c| c.text.plain());
    let said = captions.filter_map(|text| {
        let (_, rest) = text.split_once(" = ")?;
        number(rest.split(' ').next()?)
    });
    said.into_iter().next()
}

/// What an arrow is named, where it ends and which way it points.
type Arrow<'s> = (&'s str, Vec2, Vec2);

/// The arrows of a sheet in ground axes: name, point in mm, direction; and its couples: name, sense.
fn drawn(sheet: &Sheet) -> (Vec<Arrow<'_>>, Vec<(&str, f64)>) {
    let (mut forces, mut couples) = (Vec::new(), Vec::new());
    for mark in &sheet.drawing.marks {
        let group = &sheet.drawing.groups[mark.group];
        match (&mark.shape, group.class) {
            (Shape::Arrow(from, to), "vector") => {
                let along = *to - *from;
                let up = |v: Vec2| Vec2::new(v.x, -v.y);
                forces.push((group.name.as_str(), up(*from), up(along / along.norm())));
            }
            (Shape::ArcArrow { sweep, .. }, "couple") => couples.push((group.name.as_str(), -sweep.signum())),
            _ => {}
        }
    }
    (forces, couples)
}

/// What is wrong with a free body.
pub fn free_body(sheet: &Sheet) -> Option<String> {
    if !sheet.drawing.id.contains("free-body") {
        return None;
    }
    let text = &sheet.drawing.description;
    let (forces, couples) = drawn(sheet);
    let mut said = Said::of(text);
    let m = scale(sheet)?;
    let (mut sum, mut moment, mut most, mut turns) = (Vec2::zero(), 0.0, 0.0_f64, 0.0_f64);
    for (name, at, along) in &forces {
        let Some(size) = said.next(name) else { return Some(format!("{name} has no number: {text}")) };
        // what is rounding beside other positions has no number
        if size == 0.0 {
            return None;
        }
        sum += *along * size;
        moment += at.cross(*along) * m * size;
        (most, turns) = (most.max(size), turns.max(at.norm().max(SEEN) * m * size));
    }
    for (name, sense) in &couples {
        let Some(size) = said.next(name) else { return Some(format!("{name} has no number: {text}")) };
        if size * sense < 0.0 {
            return Some(format!("{name} is drawn against its sense"));
        }
        moment += size;
        turns = turns.max(size.abs());
    }
    let count = (forces.len() + couples.len()) as f64;
    if sum.norm() > count * DIGITS * most {
        return Some(format!("{} is left of {most} N: {text}", sum.norm()));
    }
    (moment.abs() > 2.0 * count * DIGITS * turns).then(|| format!("{moment} is left of {turns} N m: {text}"))
}

/// What is wrong with a lever: its arrows have the moments that it says.
pub fn lever(sheet: &Sheet) -> Option<String> {
    let text = &sheet.drawing.description;
    let (acting, rest) = text.split_once("Moments about the pole, W: ")?;
    let (terms, _) = rest.split_once(" Their sum is ")?;
    let m = scale(sheet)?;
    let mut said = Said::of(acting);
    let (mut sum, mut most, mut by_arrows) = (0.0, 0.0_f64, 0.0);
    let (forces, _) = drawn(sheet);
    for (name, at, along) in &forces {
        let Some(size) = said.next(name) else { return Some(format!("{name} has no number: {text}")) };
        let power = at.cross(*along) * m * size;
        by_arrows += power.abs();
        // arrows are no nearer to the pole than is seen
        (sum, most) = (sum + power, most.max(at.norm().max(SEEN) * m * size));
    }
    let open = sheet.drawing.captions.iter().any(|c| c.text.plain().starts_with("Without arrows"));
    let powers = terms.split(' ').filter_map(|word| {
        let word = word.trim_end_matches(['.', ',']);
        word.replace('−', "-").parse::<f64>().ok()
    });
    let total: f64 = powers.map(f64::abs).sum();
    let count = forces.len() as f64;
    if !open && sum.abs() > 2.0 * count * DIGITS * most {
        return Some(format!("{sum} is left of {most} N m/s by the arrows: {text}"));
    }
    (!open && total > 0.0 && by_arrows < 0.5 * total).then(|| format!("arrows are missing: {text}"))
}

/// What is wrong with the list from which all of them are drawn: what acts on a body adds up to nothing.
pub fn list(judged: &Judged<'_>, solved: &Solved) -> Option<String> {
    let model = judged.shown.model;
    let bodies = &judged.state.motion.bodies;
    let mut sums = vec![(Vec2::zero(), 0.0); bodies.len()];
    let extent = bodies.iter().map(|body| body.p.norm()).fold(0.0, f64::max);
    let (mut most, mut turns) = (0.0_f64, 0.0_f64);
    for act in solved.view(&model, &judged.shown.solution.statics).all_actions() {
        for act in [Some(act), act.opposite()].into_iter().flatten() {
            if !model.plan.checks.free.contains(&act.on) {
                continue;
            }
            let moment = (act.at - bodies[act.on].p).cross(act.force) + act.couple;
            sums[act.on].0 += act.force;
            sums[act.on].1 += moment;
            (most, turns) = (most.max(act.force.norm()), turns.max(moment.abs()));
        }
    }
    turns = turns.max(most * extent);
    let left = sums.iter().position(|(f, m)| f.norm() > LEFT * most || m.abs() > LEFT * turns);
    left.map(|body| format!("{:?} is left of {most} N, {turns} N m on body {body}", sums[body]))
}
