//! Plots are the quantity: curves of 112 numbers with poles, jumps, kinks, steps, peaks and gaps against 10,000 positions, or instants,
//! of the answers. A curve is read back from its lines and the ticks of its axes.

use crate::drawn::{Shown, solved};
use crate::every_example::examples;
use crate::support::random::Random;
use assur::internals::drawing::{Anchor, Drawing, Shape, Style};
use assur::internals::math::Vec2;
use assur::internals::model::{FindKind, Value};
use assur::internals::picture::{Kind, Options, Scene, draw};
use assur::internals::solve::{DriveValue, PoseOrigin};

/// How far a curve may be from the positions, mm, and the positions from the curve.
const APART: f64 = 0.3;
const POSITIONS: usize = 10_000;

/// How many poles a number has.
#[derive(Clone, Copy)]
enum Poles {
    /// So many.
    Exactly(usize),
    /// As often as this item of the file changes its sign.
    SignsOf(usize),
}

/// A number of a file, as it is written.
struct Case {
    kind: &'static str,
    written: String,
    poles: Poles,
}

fn case(kind: &'static str, written: impl Into<String>, poles: Poles) -> Case {
    Case { kind, written: written.into(), poles }
}

/// A four-bar whose crank turns round, with a torque against the motion of its rocker.
fn four_bar(random: &mut Random) -> (String, Vec<Case>) {
    let [a, b, c, d] = loop {
        let [a, b, c, d] = [0.3, 0.6, 0.6, 0.6].map(|least| random.within(least, 4.0));
        let mut all = [a, b, c, d];
        all.sort_by(f64::total_cmp);
        if all[0] == a && a < 1.5 && all[0] + all[3] < all[1] + all[2] - 0.05 {
            break [a, b, c, d];
        }
    };
    let (x, y) = (random.within(-1.0, 3.0), random.within(-2.0, 2.0));
    let text = format!(
        "mech 1\nmechanism \"A four-bar\"\nground {{ A (0, 0); D ({d} m, 0) }}\nlink crank A-B {a} m\n\
         link coupler B-C {b} m {{ E ({x} m, {y} m) }}\nlink rocker D-C {c} m\nrevolute A: ground - crank\n\
         revolute B: crank - coupler\nrevolute C: coupler - rocker\nrevolute D: ground - rocker\n\
         drive crank = 0 deg .. 360 deg in 24 steps at 60 rpm\nassemble C left of B-D\n\
         torque T on rocker = 3 N*m against motion\nbalance torque M on crank\n"
    );
    let at = random.within(0.1, 0.9) * 360.0;
    let wide = 0.06 * random.within(1.1, 3.0);
    let from = format!("(angle(crank) - {at} deg)");
    let cases = vec![
        case("signs", "cross(velocity(coupler.E), acceleration(coupler.E))", Poles::Exactly(0)),
        case("signs", "omega(rocker)", Poles::Exactly(0)),
        case("signs", "velocity(coupler.E).x", Poles::Exactly(0)),
        case("signs", "cos(angle(rocker))", Poles::Exactly(0)),
        case("curvature radius", "curvature_radius(coupler.E)", Poles::SignsOf(0)),
        case("1/omega", "1/omega(rocker)", Poles::SignsOf(1)),
        case("1/v", "omega(crank)*1 m/velocity(coupler.E).x", Poles::SignsOf(2)),
        case("tangent", "tan(angle(rocker))", Poles::SignsOf(3)),
        case("kink", "abs(velocity(coupler.E).x)", Poles::Exactly(0)),
        case("kink", "max(velocity(coupler.E).x, velocity(coupler.E).y)", Poles::Exactly(0)),
        case("load against motion", "M", Poles::Exactly(0)),
        case("narrow peak", format!("1/(1 + ({from}/{wide})^2)"), Poles::Exactly(0)),
        case("pole on a slope", format!("angle(crank) + 0.1/{from}"), Poles::Exactly(1)),
        case("double pole", format!("angle(crank) + 0.04/{from}^2"), Poles::Exactly(1)),
        case("step", format!("{from}/abs{from} + 0.1*angle(crank)"), Poles::Exactly(0)),
        case("pole of a root", format!("0.1/sqrt(abs{from})"), Poles::Exactly(1)),
        case("gap", format!("sqrt{from}"), Poles::Exactly(0)),
        case("logarithm", format!("log(abs{from}/1 rad)"), Poles::Exactly(1)),
    ];
    (text, cases)
}

/// A pendulum that swings, and one that goes round.
fn pendulum(random: &mut Random) -> (String, Vec<Case>) {
    let turn = random.within(-3.0, 7.0);
    let text = format!(
        "mech 1\nmechanism \"A pendulum\"\ngravity 9.81 m/s^2\nground {{ A (0, 0) }}\n\
         link bar A-P 1 m {{ mass 1 kg at P; inertia 0.1 kg*m^2; E (0.4 m, 0.3 m) }}\nrevolute A: ground - bar\n\
         start bar = {} deg at {turn} rad/s\nsimulate 3 s in 20 steps\n",
        random.within(-170.0, 170.0)
    );
    let cases = vec![
        case("signs", "omega(bar)", Poles::Exactly(0)),
        case("signs", "cos(angle(bar))", Poles::Exactly(0)),
        case("motion, kink", "abs(omega(bar))", Poles::Exactly(0)),
        case("motion, 1/omega", "1/omega(bar)", Poles::SignsOf(0)),
        case("motion, tangent", "tan(angle(bar))", Poles::SignsOf(1)),
        case("motion, smooth", "acceleration(bar.E).y", Poles::Exactly(0)),
    ];
    (text, cases)
}

/// A number at positions: places along the axis and values, in the units of the file.
type Course = Vec<(f64, f64)>;

/// The items of a file at its positions.
fn at_positions(text: &str) -> Vec<Course> {
    let (source, solved) = solved("fine.mech", text).unwrap_or_else(|| panic!("{text}"));
    let shown = Shown::of(&source, &solved);
    let mechanism = &solved.compiled.mechanism;
    let mut all = vec![Course::new(); mechanism.finds.len()];
    for pose in shown.solution.poses.iter().filter(|p| matches!(p.origin, PoseOrigin::Sweep(_))) {
        let Ok(state) = &pose.outcome else { continue };
        let x = match pose.drives.first() {
            Some(DriveValue::Scalar(x)) if mechanism.simulation.is_none() => x.to_degrees(),
            _ => state.state.motion.time,
        };
        for (find, course) in mechanism.finds.iter().zip(&mut all) {
            let FindKind::Value { expr, display, .. } = &find.kind else { panic!("{}", find.name) };
            let Value::Scalar(y) = shown.solution.view(&shown.model, state).value(expr) else {
                panic!("{} is a number", find.name)
            };
            course.push((x, display.of_si(y)));
        }
    }
    all
}

/// Numbers to millimetres, by the first and the last tick of an axis.
struct Ticks {
    first: (f64, f64),
    last: (f64, f64),
}

impl Ticks {
    /// Of the labels on one side of an axis.
    fn of(drawing: &Drawing, is_along: impl Fn(Vec2) -> bool, along: fn(Vec2) -> f64, power: f64) -> Self {
        let number = |text: String| text.replace('−', "-").parse::<f64>().ok();
        let all = drawing.labels.iter().filter(|label| label.towards.is_some_and(&is_along));
        let all = all.filter_map(|label| match label.anchor {
            Anchor::Point(at, _) => Some((number(label.text.plain())? * power, along(at))),
            _ => None,
        });
        let mut all: Vec<(f64, f64)> = all.collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { first: all[0], last: all[all.len() - 1] }
    }

    fn at(&self, x: f64) -> f64 {
        self.first.1 + (x - self.first.0) / (self.last.0 - self.first.0) * (self.last.1 - self.first.1)
    }
}

/// The plot of one item: its lines, its axes, and how many poles it marks.
struct Read {
    lines: Vec<Vec<Vec2>>,
    x: Ticks,
    y: Ticks,
    poles: usize,
    /// Both ends of the upright axis, mm.
    ends: (f64, f64),
}

fn read(drawing: &Drawing) -> Read {
    let lines = drawing.marks.iter().filter(|mark| mark.style == Style::Curve1);
    let lines: Vec<Vec<Vec2>> = lines
        .filter_map(|mark| match &mark.shape {
            Shape::Lines { points, .. } => Some(points.clone()),
            _ => None,
        })
        .collect();
    let grid = drawing.marks.iter().filter(|mark| mark.style == Style::Grid);
    let levels = grid.filter_map(|mark| match mark.shape {
        Shape::Line(from, _) => Some(from.y),
        _ => None,
    });
    let ends = levels.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
    let texts = || drawing.labels.iter().map(|label| label.text.plain());
    let power = texts().find_map(|text| {
        let exponent = text.split_once("10")?.1.split_once(' ')?.0;
        let digits = exponent
            .chars()
            .map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).map_or('-', |d| (b'0' + d as u8) as char));
        digits.collect::<String>().parse::<i32>().ok()
    });
    let power = 10_f64.powi(power.unwrap_or(0));
    Read {
        lines,
        x: Ticks::of(drawing, |side| side == Vec2::new(0.0, 1.0), |at| at.x, 1.0),
        y: Ticks::of(drawing, |side| side == Vec2::new(-1.0, 0.0), |at| at.y, power),
        poles: texts().filter(|text| text.starts_with("→ ")).count(),
        ends,
    }
}

/// How far points are from lines, at most, with where.
fn apart(points: &[Vec2], lines: &[Vec<Vec2>]) -> (f64, Vec2) {
    let mut pieces: Vec<(Vec2, Vec2)> =
        lines.iter().flat_map(|line| line.windows(2).map(|pair| (pair[0], pair[1]))).collect();
    pieces.sort_by(|a, b| a.0.x.min(a.1.x).total_cmp(&b.0.x.min(b.1.x)));
    let widest = pieces.iter().map(|(a, b)| (b.x - a.x).abs()).fold(0.0, f64::max);
    let from = |(a, b): &(Vec2, Vec2), p: Vec2| {
        let along = *b - *a;
        let share =
            if along.norm() > 0.0 { ((p - *a).dot(along) / along.dot(along)).clamp(0.0, 1.0) } else { 0.0 };
        (*a + along * share - p).norm()
    };
    points.iter().fold((0.0, Vec2::zero()), |most, p| {
        let first = pieces.partition_point(|(a, b)| a.x.min(b.x) < p.x - widest - 1.0);
        let near = pieces[first..].iter().take_while(|(a, b)| a.x.min(b.x) <= p.x + 1.0);
        let far = near.map(|piece| from(piece, *p)).fold(f64::INFINITY, f64::min);
        if far > most.0 { (far, *p) } else { most }
    })
}

/// What is wrong with the plots of a file.
fn faults(text: &str, cases: &[Case], steps: &str, rows: &mut Vec<String>) -> Vec<String> {
    let finds: String =
        cases.iter().enumerate().map(|(i, c)| format!("find q{i} = {}\n", c.written)).collect();
    let text = text.to_owned() + &finds;
    let fine = at_positions(&text.replace(steps, &format!("in {POSITIONS} steps")));
    let (source, solved) = solved("coarse.mech", &text).unwrap_or_else(|| panic!("{text}"));
    let file = (source.name.as_str(), source.text.as_str());
    let scene =
        Scene::of(solved.compiled.model(), &solved.solution, file, None).unwrap_or_else(|_| panic!("{text}"));
    let mut wrong = Vec::new();
    for (i, case) in cases.iter().enumerate() {
        let name = format!("{} {}", case.kind, case.written);
        let options = Options { plotted: vec![i], ..Options::default() };
        let Ok(drawn) = draw(Kind::Plot, &scene, &options) else {
            wrong.push(format!("{name}: no plot\n{text}"));
            continue;
        };
        let read = read(&drawn[0]);
        let paper = |p: &(f64, f64)| Vec2::new(read.x.at(p.0), read.y.at(p.1));
        let shown = |p: &Vec2| p.y >= read.ends.0 - 1e-9 && p.y <= read.ends.1 + 1e-9;
        let all: Vec<Vec2> = fine[i].iter().map(paper).collect();
        let points: Vec<Vec2> = all.iter().copied().filter(|p| p.y.is_finite() && shown(p)).collect();
        let there = apart(&points, &read.lines);
        // the positions as lines, without those that go through a pole
        let beyond = |p: Vec2| p.y < read.ends.0 || p.y > read.ends.1;
        let joined =
            |pair: &&[Vec2]| pair.iter().all(|p| p.y.is_finite()) && !(beyond(pair[0]) && beyond(pair[1]));
        let lines: Vec<Vec<Vec2>> = all.windows(2).filter(joined).map(<[Vec2]>::to_vec).collect();
        let middles = read.lines.iter().flat_map(|line| line.windows(2).map(|p| (p[0] + p[1]) * 0.5));
        // the last of 10,000 positions of a turn is left out
        let middles: Vec<Vec2> = middles.filter(|p| p.x < 149.9).collect();
        let back = apart(&middles, &lines);
        let poles = match case.poles {
            Poles::Exactly(count) => count,
            Poles::SignsOf(other) => {
                fine[other].windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0).count()
            }
        };
        if there.0 > APART || back.0 > APART || poles != read.poles {
            wrong.push(format!(
                "{name}: {there:?} there, {back:?} back, {} poles of {poles}\n{text}",
                read.poles
            ));
        }
        rows.push(format!("{:20} {:.3} {:.3} {}", case.kind, there.0, back.0, read.poles));
    }
    wrong
}

#[test]
fn curves_are_the_quantity_between_the_positions() {
    let mut random = Random::new(8);
    let (mut wrong, mut rows) = (Vec::new(), Vec::new());
    for _ in 0..5 {
        let (text, cases) = four_bar(&mut random);
        wrong.extend(faults(&text, &cases, "in 24 steps", &mut rows));
    }
    for _ in 0..4 {
        let (text, cases) = pendulum(&mut random);
        wrong.extend(faults(&text, &cases, "in 20 steps", &mut rows));
    }
    rows.sort();
    println!("{}", rows.join("\n"));
    assert!(rows.len() >= 100, "{} numbers", rows.len());
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}

/// What the positions of a sweep have are dots: they lie on the curves, in every example.
#[test]
fn positions_lie_on_the_curves_of_every_example() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    // a guide at rest has no friction at one position: its curve has what it is beside that
    let at_rest = "hard/zero-velocity.mech";
    for (name, text) in examples().into_iter().filter(|example| example.0 != at_rest) {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Ok(scene) = Scene::of(solved.compiled.model(), &solved.solution, (&name, &text), None) else {
            continue;
        };
        for i in 0..solved.compiled.mechanism.finds.len() {
            let options = Options { plotted: vec![i], ..Options::default() };
            let Ok(drawn) = draw(Kind::Plot, &scene, &options) else { continue };
            let dots: Vec<Vec2> = (drawn[0].marks.iter())
                .filter_map(|mark| match mark.shape {
                    Shape::Circle { centre, .. } if mark.style == Style::Hinge => Some(centre),
                    _ => None,
                })
                .collect();
            let lines: Vec<Vec<Vec2>> = (drawn[0].marks.iter())
                .filter_map(|mark| match &mark.shape {
                    Shape::Lines { points, .. } => Some(points.clone()),
                    _ => None,
                })
                .collect();
            count += dots.len();
            let far = apart(&dots, &lines);
            if far.0 > APART && !lines.is_empty() {
                wrong.push(format!("{}: item {i}: a position is {far:?} from the curve", source.name));
            }
        }
    }
    assert!(count > 1000, "{count} positions");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
