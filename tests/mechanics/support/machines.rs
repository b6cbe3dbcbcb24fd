//! Well-known machines with masses, for the tests of sweeps and for the measurements. Lengths in metres.
#![allow(dead_code)] // every test and bench uses some of them

use assur::internals::math::Vec2;
use assur::internals::model::{
    Balance, BalanceKind, Drive, DriveTarget, Expr, Find, FindKind, Gravity, Guide, Hint, HintKind, Link,
    LinkId, MassProperties, Mechanism, Pair, PairId, PairKind, Pin, Positions,
};
use assur::internals::source::Span;

/// A turning speed for all of them, rad/s.
pub const SPEED: f64 = 30.0;

pub fn at(x: f64, y: f64) -> Vec2 {
    Vec2::new(x, y)
}

/// A mechanism of the ground alone, with gravity, all reactions asked for.
pub fn ground() -> Mechanism {
    let ground = Link { name: "ground".into(), ..Link::default() };
    let find = Find { name: "reactions".into(), span: Span::default(), kind: FindKind::Reactions };
    let gravity = Gravity { acceleration: at(0.0, -9.81), span: Span::default() };
    Mechanism { links: vec![ground], finds: vec![find], gravity: Some(gravity), ..Mechanism::default() }
}

/// A link with its mass and moment of inertia about the mass centre.
pub fn link(m: &mut Mechanism, name: &str, mass: f64, centre: Vec2, inertia: f64) -> LinkId {
    let mass = (mass > 0.0).then_some(MassProperties { mass, centre, inertia });
    m.links.push(Link { name: name.into(), mass, ..Link::default() });
    LinkId::at(m.links.len() - 1)
}

/// A slender bar from its origin along x, 2 kg/m.
pub fn bar(m: &mut Mechanism, name: &str, length: f64) -> LinkId {
    let mass = 2.0 * length;
    link(m, name, mass, at(length / 2.0, 0.0), mass * length * length / 12.0)
}

pub fn pair(m: &mut Mechanism, name: &str, kind: PairKind) -> PairId {
    m.pairs.push(Pair { name: name.into(), span: Span::default(), kind, friction: None, bearing: None });
    PairId::at(m.pairs.len() - 1)
}

pub fn revolute(m: &mut Mechanism, name: &str, a: (LinkId, Vec2), b: (LinkId, Vec2)) -> PairId {
    let pin = |(link, at)| Pin { link, name: name.into(), at };
    pair(m, name, PairKind::Revolute(vec![pin(a), pin(b)]))
}

/// The origin of `slider` on the line of `guide`, turning with it.
pub fn prismatic(m: &mut Mechanism, slider: LinkId, guide: LinkId, through: Vec2, along: Vec2) -> PairId {
    let guide = Guide {
        slider,
        point_name: "C".into(),
        point: at(0.0, 0.0),
        direction: at(1.0, 0.0),
        own_line: None,
        guide,
        line_name: "guide".into(),
        through,
        along,
        contacts: None,
        guide_first: false,
    };
    pair(m, "D", PairKind::Prismatic(guide))
}

/// Drives a link over these angles, rad, at the common speed.
pub fn drive(m: &mut Mechanism, link: LinkId, angles: Positions) {
    m.drives.push(Drive {
        name: m.link(link).name.clone(),
        span: Span::default(),
        target: DriveTarget::Link(link),
        positions: angles,
        written: None,
        speed: Some(Expr::number(SPEED)),
        acceleration: None,
        sense: None,
        free: false,
        sought: None,
        of_time: false,
    });
}

pub fn list(angles: &[f64]) -> Positions {
    Positions::List(angles.iter().map(|&x| Expr::number(x)).collect())
}

/// A whole turn from this angle.
pub fn turn(from: f64, steps: usize) -> Positions {
    let to = from + std::f64::consts::TAU;
    Positions::Range { from: Expr::number(from), to: Expr::number(to), steps }
}

pub fn balance(m: &mut Mechanism, link: LinkId) {
    m.balances.push(Balance {
        name: "Mb".into(),
        span: Span::default(),
        kind: BalanceKind::Torque(link),
        pin: None,
    });
}

pub fn hint(m: &mut Mechanism, kind: HintKind) {
    m.hints.push(Hint { span: Span::default(), kind });
}

/// `point` is left (right) of the line between two others.
pub fn side(m: &mut Mechanism, point: (LinkId, Vec2), from: (LinkId, Vec2), to: (LinkId, Vec2), left: bool) {
    hint(m, HintKind::Side { point, from, to, left });
}

/// Crank r, rod l, guide along x at the height `offset`; the slider ahead of the crank pin.
pub fn crank_slider(r: f64, l: f64, offset: f64, angles: Positions) -> Mechanism {
    let mut m = ground();
    let (crank, rod) = (bar(&mut m, "crank", r), bar(&mut m, "rod", l));
    let piston = link(&mut m, "piston", 0.5, at(0.0, 0.0), 0.0);
    revolute(&mut m, "A", (LinkId::GROUND, at(0.0, 0.0)), (crank, at(0.0, 0.0)));
    revolute(&mut m, "B", (crank, at(r, 0.0)), (rod, at(0.0, 0.0)));
    revolute(&mut m, "C", (rod, at(l, 0.0)), (piston, at(0.0, 0.0)));
    let guide = prismatic(&mut m, piston, LinkId::GROUND, at(0.0, offset), at(1.0, 0.0));
    let ahead =
        HintKind::Along { point: (rod, at(l, 0.0)), other: (crank, at(r, 0.0)), pair: guide, ahead: true };
    hint(&mut m, ahead);
    drive(&mut m, crank, angles);
    balance(&mut m, crank);
    m
}

/// Crank, coupler, rocker and frame; the coupler's far pin left or right of the diagonal.
pub fn four_bar([r, l, q, frame]: [f64; 4], left: bool, angles: Positions) -> Mechanism {
    let mut m = ground();
    let crank = bar(&mut m, "crank", r);
    let (coupler, rocker) = (bar(&mut m, "coupler", l), bar(&mut m, "rocker", q));
    revolute(&mut m, "A", (LinkId::GROUND, at(0.0, 0.0)), (crank, at(0.0, 0.0)));
    revolute(&mut m, "B", (crank, at(r, 0.0)), (coupler, at(0.0, 0.0)));
    revolute(&mut m, "C", (coupler, at(l, 0.0)), (rocker, at(q, 0.0)));
    revolute(&mut m, "D", (LinkId::GROUND, at(frame, 0.0)), (rocker, at(0.0, 0.0)));
    let (c, b, d) = ((coupler, at(l, 0.0)), (crank, at(r, 0.0)), (LinkId::GROUND, at(frame, 0.0)));
    side(&mut m, c, b, d, left);
    drive(&mut m, crank, angles);
    balance(&mut m, crank);
    m
}

/// A four-bar with a dyad between a point of the coupler and the frame: Stephenson III.
pub fn six_bar(angles: Positions) -> Mechanism {
    let mut m = four_bar([0.1, 0.35, 0.3, 0.4], true, angles);
    let (coupler, e, g) = (LinkId::at(2), at(0.2, 0.15), at(0.35, 0.35));
    let (one, two) = (bar(&mut m, "link5", 0.3), bar(&mut m, "link6", 0.25));
    revolute(&mut m, "E", (coupler, e), (one, at(0.0, 0.0)));
    revolute(&mut m, "F", (one, at(0.3, 0.0)), (two, at(0.25, 0.0)));
    revolute(&mut m, "G", (LinkId::GROUND, g), (two, at(0.0, 0.0)));
    side(&mut m, (two, at(0.25, 0.0)), (coupler, e), (LinkId::GROUND, g), true);
    m
}

/// A crank that moves one corner of a closed contour of four links: class IV.
pub fn class_iv(angles: Positions) -> Mechanism {
    let mut m = ground();
    let crank = bar(&mut m, "crank", 0.01);
    revolute(&mut m, "O", (LinkId::GROUND, at(0.0, 0.0)), (crank, at(0.0, 0.0)));
    let left = link(&mut m, "left", 1.4, at(0.12, 0.06), 0.006);
    let right = link(&mut m, "right", 1.8, at(-0.06, 0.1), 0.009);
    let (lower, upper) = (bar(&mut m, "lower", 0.14), bar(&mut m, "upper", 0.26));
    revolute(&mut m, "P", (crank, at(0.01, 0.0)), (left, at(0.0, 0.0)));
    revolute(&mut m, "Q", (LinkId::GROUND, at(0.5, 0.02)), (right, at(0.0, 0.0)));
    revolute(&mut m, "A", (left, at(0.2, 0.04)), (lower, at(0.0, 0.0)));
    revolute(&mut m, "B", (lower, at(0.14, 0.0)), (right, at(-0.15, 0.12)));
    revolute(&mut m, "C", (left, at(0.16, 0.14)), (upper, at(0.0, 0.0)));
    revolute(&mut m, "D", (upper, at(0.26, 0.0)), (right, at(-0.05, 0.22)));
    hint(&mut m, HintKind::Near { point: (left, at(0.2, 0.04)), place: at(0.23, 0.07) });
    hint(&mut m, HintKind::Near { point: (right, at(-0.05, 0.22)), place: at(0.45, 0.24) });
    drive(&mut m, crank, angles);
    balance(&mut m, crank);
    m
}

/// A crank that moves one leg of a class III triad; the others stand on the ground. At 0° the plate is at (0.3, 0.3).
pub fn triad(angles: Positions) -> Mechanism {
    let mut m = ground();
    let crank = bar(&mut m, "crank", 0.05);
    revolute(&mut m, "A", (LinkId::GROUND, at(0.05, 0.0)), (crank, at(0.0, 0.0)));
    let plate = link(&mut m, "plate", 1.0, at(0.2, 0.1), 0.02);
    let hung = [(crank, at(0.05, 0.0)), (LinkId::GROUND, at(0.9, 0.0)), (LinkId::GROUND, at(0.15, 0.25))];
    let feet = [at(0.1, 0.0), at(0.9, 0.0), at(0.15, 0.25)];
    let pins = [at(0.0, 0.0), at(0.4, 0.0), at(0.2, -0.1)];
    for i in 0..3 {
        let place = pins[i] + at(0.3, 0.3);
        let length = (place - feet[i]).norm();
        let leg = bar(&mut m, &format!("leg{i}"), length);
        revolute(&mut m, &format!("B{i}"), hung[i], (leg, at(0.0, 0.0)));
        revolute(&mut m, &format!("C{i}"), (leg, at(length, 0.0)), (plate, pins[i]));
        hint(&mut m, HintKind::Near { point: (plate, pins[i]), place });
    }
    drive(&mut m, crank, angles);
    balance(&mut m, crank);
    m
}
