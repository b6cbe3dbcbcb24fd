//! Forces of a link on three legs of any mix: two revolutes, a guide below or a guide above.

use crate::support::digits;
use crate::support::draft::Draft;
use crate::support::generate::finish;
use crate::support::random::Random;
use crate::support::run::Run;
use assur::internals::math::Vec2;
use assur::internals::model::LinkId;
use assur::internals::plan::ForceStep;

/// A leg's joints from below.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Leg {
    Rr,
    Pr,
    Rp,
}

const LEGS: [Leg; 3] = [Leg::Rr, Leg::Pr, Leg::Rp];

/// A crank that carries the first leg, the ground the others; `None` where the lines of the three forces nearly meet.
fn machine(seed: u64, kinds: [Leg; 3]) -> Option<Draft> {
    let mut draft = Draft::new(Random::new(seed));
    draft.add_crank()?;
    let feet = [0, 1, 2].map(|_| draft.spot());
    let pins = [0, 1, 2].map(|_| draft.spot());
    let guides = [0, 1, 2].map(|_| draft.random.direction());
    // the line of each leg's unknown force
    let lines = [0, 1, 2].map(|i| match kinds[i] {
        Leg::Rr => (pins[i], (pins[i] - feet[i]) / (pins[i] - feet[i]).norm()),
        Leg::Pr => (pins[i], guides[i].perp()),
        Leg::Rp => (feet[i], guides[i].perp()),
    });
    let crossing = lines[0].1.cross(lines[1].1);
    let pole = lines[0].0 + lines[0].1 * ((lines[1].0 - lines[0].0).cross(lines[1].1) / crossing);
    let arm = (lines[2].0 - pole).cross(lines[2].1).abs();
    let far = (0..3).all(|i| (pins[i] - feet[i]).norm() > 0.4);
    if !far || crossing.abs() < 0.3 || arm < 0.3 || pole.norm() > 3.0 {
        return None;
    }
    let plate = draft.link(pins[0]);
    for i in 0..3 {
        let host = LinkId::at(if i == 0 { 1 } else { 0 });
        let leg = draft.link(feet[i]);
        if kinds[i] == Leg::Pr {
            draft.prismatic(leg, host, pins[i], guides[i]);
        } else {
            draft.revolute(host, leg, feet[i]);
        }
        if kinds[i] == Leg::Rp {
            draft.prismatic(leg, plate, pins[i], guides[i]);
        } else {
            draft.revolute(plate, leg, pins[i]);
        }
    }
    finish(&mut draft);
    Some(draft)
}

/// The loss of the forces over ε/σ²; `None` where the draw is no machine.
fn loss(seed: u64, kinds: [Leg; 3]) -> Option<f64> {
    let draft = machine(seed, kinds)?;
    let run = Run::new(&draft.mechanism).unwrap_or_else(|e| panic!("seed {seed}, {kinds:?}: {e}"));
    let solved = run.solved(0).ok()?;
    let closed = run.plan.forces.iter().any(|step| matches!(step, ForceStep::Triad(_)));
    assert!(closed, "seed {seed}, {kinds:?}: {:?}", run.plan.forces);
    let solution = run.solution.as_ref().ok()?;
    let model = run.model();
    let exact = solution.reference(&model, solved).unwrap_or_else(|| panic!("seed {seed}: no reference"));
    let error = digits::force_error(&model, solved, &exact);
    Some(error * solved.condition.powi(2) / f64::EPSILON)
}

#[test]
fn forces_of_a_link_on_legs_of_any_mix() {
    let mut worst = 0.0_f64;
    let wanted = crate::share::part(8);
    for mix in 0..27 {
        let kinds = [LEGS[mix % 3], LEGS[mix / 3 % 3], LEGS[mix / 9]];
        let losses = (0..200).filter_map(|i| Some((i, loss(9000 + 200 * mix as u64 + i, kinds)?)));
        let losses: Vec<(u64, f64)> = losses.take(wanted).collect();
        assert_eq!(losses.len(), wanted, "{kinds:?}");
        for (seed, c) in losses {
            assert!(c <= 64.0, "{kinds:?}, seed {seed}: {c}");
            worst = worst.max(c);
        }
    }
    println!("c = {worst}");
}

/// At a pole of the three lines nothing holds the link, and the figure says so.
#[test]
fn lines_that_meet_hold_nothing() {
    use assur::internals::group::triad::Triad;
    let pole = Vec2::new(0.2, -0.1);
    let arms = [Vec2::new(1.0, 0.0), Vec2::new(-0.5, 0.8), Vec2::new(-0.5, -0.8)];
    for apart in [0.0, 1e-9, 1e-3] {
        let d = arms.map(|a| {
            let along = a - pole;
            along / along.norm()
        });
        let turned = [d[0].turned(Vec2::direction(apart)), d[1], d[2]];
        let conditioning = Triad::new(turned, arms, 1.0).conditioning.abs();
        assert!(
            conditioning <= 4.0 * apart + 1e-15 && conditioning >= 0.1 * apart,
            "{apart}: {conditioning:e}"
        );
    }
}
