//! What does not close is told by how much; no data makes the solver panic or give an answer that is none.

use crate::support::draft::Draft;
use crate::support::generate;
use crate::support::machines::{self, at, crank_slider, four_bar, list};
use crate::support::random::Random;
use crate::support::run::Run;
use assur::internals::diagnostic::Diagnosis;
use assur::internals::math::Vec2;
use assur::internals::message;
use assur::internals::model::{
    BalanceKind, Expr, LinkId, LoadKind, Mechanism, PairKind, Place, Positions, ProfileShape, Value,
};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The gap in words of a mechanism that does not close, and its last length, m.
fn gap(m: &Mechanism) -> Option<(String, f64)> {
    let run = Run::new(m).expect("the structure is sound");
    let failures = run.solution.as_ref().err()?;
    let errors: Vec<Diagnosis> = message::failures(&run.model(), failures).collect();
    let [error] = errors.as_slice() else { return None };
    let told = error.is("mech::assembly::does_not_close").then(|| error.to_string())?;
    let (_, gap) = told.split_once(": ")?;
    let words: Vec<&str> = gap.split_whitespace().collect();
    // a mechanism without a text has no units of its own: lengths are in metres
    let unit = words.iter().rposition(|w| w.trim_end_matches([',', ';']) == "m")?;
    Some((gap.to_owned(), words[unit - 1].parse::<f64>().ok()?))
}

/// The figure told is the gap, rounded to four digits; what closes is not told to be open.
fn told(m: &Mechanism, missing: f64, what: &str) {
    match gap(m) {
        None => assert!(missing <= 1e-12, "{what} closes, or is wrong otherwise, but misses {missing}"),
        Some((text, told)) => {
            assert!((told - missing).abs() <= 1e-3 * missing, "{what}: `{text}` but it misses {missing}");
        }
    }
}

#[test]
fn what_does_not_close_tells_by_how_much() {
    let mut random = Random::new(11);
    let (mut open, mut closed) = (0, 0);
    for _ in 0..400 {
        let mut size = || libm::exp(random.within(-7.0, 7.0));
        let scale = size();
        let mut length = || scale * random.within(0.05, 1.0);
        let (lengths, angle) = ([length(), length(), length(), length()], length());
        let b = Vec2::direction(angle) * lengths[0];
        let distance = (b - at(lengths[3], 0.0)).norm();
        let (far, near) = (lengths[1] + lengths[2], (lengths[1] - lengths[2]).abs());
        let missing = (distance - far).max(near - distance).max(0.0);
        told(&four_bar(lengths, true, list(&[angle])), missing, "a four-bar");
        let (r, l, e) = (lengths[0], lengths[1], lengths[2]);
        let missing_slider = ((r * libm::sin(angle) - e).abs() - l).max(0.0);
        told(&crank_slider(r, l, e, list(&[angle])), missing_slider, "a crank-slider");
        let (guide, beside) = swinging_guide(lengths, angle);
        let missing_guide = (beside - distance).max(0.0);
        told(&guide, missing_guide, "a swinging guide");
        for x in [missing, missing_slider, missing_guide] {
            if x > 0.0 { open += 1 } else { closed += 1 }
        }
    }
    assert!(open > 300 && closed > 300, "{open} open, {closed} closed");
}

/// A crank whose pin hangs a block that slides along a link on the ground, at an offset.
fn swinging_guide([r, _, offset, frame]: [f64; 4], angle: f64) -> (Mechanism, f64) {
    let mut m = machines::ground();
    let (crank, bar) = (machines::bar(&mut m, "crank", r), machines::bar(&mut m, "bar", 1.0));
    let block = machines::link(&mut m, "block", 0.0, at(0.0, 0.0), 0.0);
    machines::revolute(&mut m, "A", (LinkId::GROUND, at(0.0, 0.0)), (crank, at(0.0, 0.0)));
    machines::revolute(&mut m, "B", (crank, at(r, 0.0)), (block, at(0.0, 0.0)));
    machines::revolute(&mut m, "D", (LinkId::GROUND, at(frame, 0.0)), (bar, at(0.0, 0.0)));
    let line = machines::prismatic(&mut m, block, bar, at(0.0, offset), at(1.0, 0.0));
    let hint = assur::internals::model::HintKind::Coordinate { pair: line, bound: 0.0, greater: true };
    machines::hint(&mut m, hint);
    machines::drive(&mut m, crank, list(&[angle]));
    (m, offset)
}

/// Every number of a mechanism but unit directions, which are made by `check`.
fn numbers(m: &mut Mechanism) -> Vec<&mut f64> {
    let mut out: Vec<&mut f64> = Vec::new();
    fn vector<'a>(v: &'a mut Vec2, out: &mut Vec<&'a mut f64>) {
        out.extend([&mut v.x, &mut v.y]);
    }
    fn expr<'a>(e: &'a mut Expr, out: &mut Vec<&'a mut f64>) {
        match e {
            Expr::Constant(Value::Scalar(x)) => out.push(x),
            Expr::Constant(Value::Vector(v)) => vector(v, out),
            _ => {}
        }
    }
    fn place<'a>(p: &'a mut Place, out: &mut Vec<&'a mut f64>) {
        match p {
            Place::Local(v) => vector(v, out),
            Place::Ground(e) => expr(e, out),
        }
    }
    for link in &mut m.links {
        if let Some(mass) = &mut link.mass {
            out.extend([&mut mass.mass, &mut mass.inertia]);
            vector(&mut mass.centre, &mut out);
        }
    }
    for pair in &mut m.pairs {
        match &mut pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                pins.iter_mut().for_each(|p| vector(&mut p.at, &mut out))
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => {
                vector(&mut g.point, &mut out);
                vector(&mut g.through, &mut out);
                out.extend(g.contacts.iter_mut().flatten());
            }
            PairKind::Contact { first, second, .. } => {
                for profile in [first, second] {
                    match &mut profile.shape {
                        ProfileShape::Point(p) => vector(p, &mut out),
                        ProfileShape::Circle(p, r) => {
                            vector(p, &mut out);
                            out.push(r);
                        }
                        ProfileShape::Line(p, _) => vector(p, &mut out),
                        // cams are tested by themselves
                        ProfileShape::Rim(_) => {}
                    }
                }
            }
            PairKind::Cylinder { from, to, .. } => {
                vector(&mut from.at, &mut out);
                vector(&mut to.at, &mut out);
            }
            PairKind::Transmission(_) => {}
        }
    }
    for drive in &mut m.drives {
        match &mut drive.positions {
            Positions::List(list) => list.iter_mut().for_each(|e| expr(e, &mut out)),
            Positions::Range { from, to, .. } => {
                expr(from, &mut out);
                expr(to, &mut out);
            }
            Positions::None | Positions::Numbers(_) => {}
        }
        drive.speed.iter_mut().chain(&mut drive.acceleration).for_each(|e| expr(e, &mut out));
    }
    if let Some(gravity) = &mut m.gravity {
        vector(&mut gravity.acceleration, &mut out);
    }
    for load in &mut m.loads {
        match &mut load.kind {
            LoadKind::Force { at, value, .. } | LoadKind::ForceAgainstMotion { at, value, .. } => {
                place(at, &mut out);
                expr(value, &mut out);
            }
            LoadKind::Torque { value, .. } | LoadKind::InPair { value, .. } => expr(value, &mut out),
        }
    }
    for spring in &mut m.springs {
        vector(&mut spring.from.1, &mut out);
        vector(&mut spring.to.1, &mut out);
        out.extend([&mut spring.stiffness, &mut spring.free_length, &mut spring.damping]);
    }
    for balance in &mut m.balances {
        if let BalanceKind::Force { at, .. } = &mut balance.kind {
            place(at, &mut out);
        }
    }
    out
}

const ODD: [f64; 16] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    -1.0,
    1e300,
    -1e300,
    1e-300,
    1e308,
    5e-324,
    1e160,
    -1e160,
    1e-160,
    1e17,
    1e-17,
];

/// Replaces some of the numbers by odd ones.
fn spoilt(draft: &Draft, random: &mut Random) -> Mechanism {
    let mut m = draft.mechanism.clone();
    let mut all = numbers(&mut m);
    for _ in 0..1 + random.below(3) {
        let n = random.below(all.len());
        *all[n] = ODD[random.below(ODD.len())];
    }
    if random.chance(0.1) {
        let odd = ODD[random.below(ODD.len())];
        all.into_iter().for_each(|x| *x = odd);
    }
    m
}

/// What is wrong with an answer: numbers that are none, or links that do not meet.
fn no_answer(run: &Run) -> Option<String> {
    let solution = run.solution.as_ref().ok()?;
    for pose in &solution.poses {
        let Ok(solved) = &pose.outcome else { continue };
        let state = &solved.state;
        let finite = state
            .motion
            .bodies
            .iter()
            .all(|b| (b.p.x + b.p.y + b.u.x + b.omega + b.a.x + b.alpha).is_finite())
            && state.forces.reactions.iter().all(|r| (r.force.x + r.force.y + r.couple).is_finite())
            && state.forces.efforts.iter().all(|e| e.is_finite());
        if !finite {
            return Some("numbers that are not finite".into());
        }
        let closure = solved.residuals.closure;
        if solved.condition > 1e-3 && (closure >= 1e-9 || closure.is_nan()) {
            return Some(format!("closure {closure:e} at condition {:e}", solved.condition));
        }
    }
    None
}

#[test]
fn odd_numbers_neither_panic_nor_make_answers() {
    let mut random = Random::new(12);
    let mut wrong = Vec::new();
    for seed in crate::share::first(0..1200) {
        let draft = generate::mechanism(seed);
        let m = spoilt(&draft, &mut random);
        let outcome = catch_unwind(AssertUnwindSafe(|| Run::new(&m).ok().and_then(|run| no_answer(&run))));
        match outcome {
            Err(_) => wrong.push(format!("seed {seed}: panic")),
            Ok(Some(why)) => wrong.push(format!("seed {seed}: {why}")),
            Ok(None) => {}
        }
    }
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn odd_sweeps_neither_panic_nor_make_answers() {
    let mut random = Random::new(13);
    for _ in 0..40 {
        let mut angles = || list(&[0.3, ODD[random.below(ODD.len())], random.within(-9.0, 9.0)]);
        for m in [
            crank_slider(0.1, 0.35, 0.02, angles()),
            four_bar([0.1, 0.35, 0.3, 0.4], true, angles()),
            machines::six_bar(angles()),
        ] {
            let run = Run::new(&m).expect("the structure is sound");
            assert_eq!(no_answer(&run), None);
        }
    }
}
