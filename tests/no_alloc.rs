//! The loop over positions takes no memory: motion, loads and forces of machines with closed forms and without, nor do the
//! steps of a motion under loads.

#[path = "mechanics/support/machines.rs"]
mod machines;

use assur::internals::math::Vec2;
use assur::internals::math::ode::{
    Dop853, Extrapolation, Integrator, Radau, Step, System, Tolerance, Undefined,
};
use assur::internals::model::{Friction, Mechanism, PairKind};
use assur::internals::report::json::JsonLines;
use assur::internals::report::lines::{CsvLines, PoseLines};
use assur::internals::report::rows::AnswerColumns;
use assur::internals::report::{Answers, NumberRows, PrintedDigits};
use assur::internals::solve::{Block, DriveInput, Following, Model, PoseOutputs, Solution, solve};

/// Allocations of this thread over a revolution of a machine, after it was assembled.
fn allocations(mechanism: &Mechanism) -> u64 {
    let (structure, _) = assur::internals::structure::structure(mechanism).expect("the machine is sound");
    let plan = assur::internals::plan::plan(mechanism, &structure);
    let model = Model { mechanism, structure: &structure, plan: &plan };
    let solution = solve(&model).expect("the machine closes");
    let first = solution.poses[0].outcome.as_ref().expect("the first position is regular");
    let mut state = first.state.clone().ready(&plan);
    let mut sum = 0.0;
    let mut solve_at = |i: u16| {
        let value = f64::from(i).to_radians();
        let place = Vec2::direction(value);
        state.motion.inputs[0] = DriveInput { value, place, rate: machines::SPEED, ..DriveInput::default() };
        state.run_motion::<2>(&plan);
        state.run_loads(&model, &[]);
        state.set_lines(&plan);
        state.set_senses(&plan);
        state.run_forces(&plan);
        sum += state.forces.efforts[0];
    };
    // iterations take their memory at the first position
    solve_at(0);
    let counted = allocation_counter::measure(|| (0..360).for_each(&mut solve_at));
    assert!(sum.is_finite() && state.motion.open.is_none());
    counted.count_total
}

#[test]
fn the_loop_over_positions_allocates_nothing() {
    let start = || machines::list(&[0.0]);
    assert_eq!(allocations(&machines::crank_slider(0.1, 0.35, 0.02, start())), 0);
    assert_eq!(allocations(&machines::four_bar([0.1, 0.35, 0.3, 0.4], true, start())), 0);
    assert_eq!(allocations(&machines::six_bar(start())), 0);
    assert_eq!(allocations(&machines::triad(start())), 0);
    assert_eq!(allocations(&machines::class_iv(start())), 0);
}

#[test]
fn jerks_allocate_nothing() {
    let start = || machines::list(&[0.0]);
    for mechanism in [
        machines::crank_slider(0.1, 0.35, 0.02, start()),
        machines::triad(start()),
        machines::class_iv(start()),
    ] {
        let (structure, _) =
            assur::internals::structure::structure(&mechanism).expect("the machine is sound");
        let effects = assur::internals::plan::Effects {
            level: assur::internals::plan::Level::Accelerations,
            beyond: true,
            ..assur::internals::plan::Effects::default()
        };
        let plan = assur::internals::plan::plan_with(&mechanism, &structure, effects);
        let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
        let solution = solve(&model).expect("the machine closes");
        let first = solution.poses[0].outcome.as_ref().expect("the first position is regular");
        let mut state = first.state.clone().ready(&plan);
        let mut sum = 0.0;
        let mut solve_at = |i: u16| {
            let value = f64::from(i).to_radians();
            let input = &mut state.motion.inputs[0];
            (input.value, input.place, input.rate) = (value, Vec2::direction(value), machines::SPEED);
            state.run_planned_motion(&plan);
            sum += state.motion.bodies[2].zeta;
        };
        solve_at(0);
        let counted = allocation_counter::measure(|| (0..30).for_each(&mut solve_at));
        assert!(sum.is_finite() && sum != 0.0);
        assert_eq!(counted.count_total, 0);
    }
}

#[test]
fn a_balance_far_from_the_drive_allocates_nothing() {
    let mut m = machines::six_bar(machines::list(&[0.0]));
    m.balances.clear();
    machines::balance(&mut m, assur::internals::model::LinkId::at(5));
    // the six-bar's last link is a rocker: over a whole turn its torque cannot always hold the crank, but it is counted
    assert_eq!(allocations(&m), 0);
}

#[test]
fn friction_allocates_nothing() {
    let mut m = machines::crank_slider(0.1, 0.35, 0.02, machines::list(&[0.0]));
    for pair in &mut m.pairs {
        pair.friction = Some(match pair.kind {
            PairKind::Revolute(_) => Friction::Circle(0.002),
            _ => Friction::Coefficient(0.1),
        });
    }
    assert_eq!(allocations(&m), 0);
}

#[test]
fn a_cam_allocates_nothing() {
    let text = include_str!("../examples/cams/lever.mech");
    let source = assur::internals::source::Source::new("lever.mech", text);
    let (mechanism, _) = assur::internals::check_source(&source, &assur::internals::check::Overrides::none());
    assert_eq!(allocations(&mechanism.expect("the example is sound")), 0);
}

/// Allocations over blocks of a sweep over a turn, after the first of them. What to do at a block is made of the answers.
fn allocations_of_blocks<W>(text: &str, worker: impl FnOnce(&Answers<'_>) -> W) -> u64
where
    W: FnMut(&Answers<'_>, &Block),
{
    let source = assur::internals::source::Source::new("sweep.mech", text);
    let (compiled, _) = assur::internals::compile(&source, &assur::internals::check::Overrides::none());
    let compiled = compiled.expect("the text is sound");
    let model = compiled.model();
    let mut following = Following::new(&model, Vec::new()).expect("it is solved").expect("it moves");
    following.next();
    let solution = Solution { statics: following.statics().clone(), ..Solution::default() };
    let precision = PrintedDigits::READABLE;
    let answers = Answers { model, solution: &solution, outcomes: &[], reached: None, precision };
    let (mut work, mut count) = (worker(&answers), 0);
    let each = |(): &(), count: usize, work: &(dyn Fn(usize) + Sync)| (0..count).for_each(work);
    let found = following.side_by_side(PoseOutputs::ALL, &mut (), each, |(), sweep| {
        let mut block = Block::default();
        let mut blocks = |numbers: std::ops::Range<usize>| {
            for number in numbers {
                sweep.solve(number, &mut block);
                work(&answers, &block);
            }
        };
        blocks(0..20);
        count = allocation_counter::measure(|| blocks(20..60)).count_total;
        true
    });
    assert!(found.is_some(), "positions do not depend on one another");
    count
}

const SWEEP: &str = include_str!("../benches/peers/four-bar.mech");

#[test]
fn a_sweep_and_its_lines_allocate_nothing() {
    let text = SWEEP.replace("in 360 steps", "in 10000 steps");
    let count = allocations_of_blocks(&text, |answers| {
        let (mut row, mut out) = (Vec::new(), Vec::new());
        let (mut csv, mut json) = (CsvLines::of(&answers.model, None), JsonLines::of("a".to_owned()));
        move |answers: &Answers<'_>, block: &Block| {
            for pose in block.poses() {
                out.clear();
                csv.begin(answers, None);
                csv.add(answers, pose, &mut row, &mut out);
                json.begin(answers, Some(pose));
                json.add(answers, pose, &mut row, &mut out);
            }
        }
    });
    assert_eq!(count, 0);
}

#[test]
fn columns_of_a_sweep_allocate_nothing() {
    let text = SWEEP.replace("in 360 steps", "in 10000 steps")
        + "find omega(coupler), 2*velocity(coupler.C), reaction(B, coupler)\n";
    let mut sum = 0.0;
    let sum_of_all = &mut sum;
    let count = allocations_of_blocks(&text, |answers| {
        let model = answers.model;
        let mut rows = NumberRows::of(AnswerColumns::of_file(&model));
        rows.begin(answers);
        let mut row = Vec::new();
        move |answers: &Answers<'_>, block: &Block| {
            for pose in block.poses() {
                rows.read(answers, pose, &mut row);
                *sum_of_all += row[0];
            }
        }
    });
    assert_eq!(count, 0);
    assert!(sum.is_finite() && sum != 0.0);
}

#[test]
fn the_count_counts() {
    let counted = allocation_counter::measure(|| drop(std::hint::black_box(vec![1_u8])));
    assert_eq!(counted.count_total, 1);
}

/// A gearbox with losses that drives a crank-slider and a hoist.
const TRAIN: &str = "
ground { O (0, 0); line guide through O along 0 deg; wheel ring teeth 60 }
shaft S { wheel sun teeth 24 }
shaft H { wheel w radius 0.2 m; wheel h teeth 20; inertia 0.1 kg*m^2 }
shaft P on H { wheel p teeth 18 }
mesh a: sun - p { efficiency 0.98 }
mesh b: p - ring { internal; efficiency 0.98 }
link crank O-A 100 mm { wheel z teeth 40 at O }
link rod A-B 400 mm
link piston { B (0, 0); mass 2 kg }
revolute O: ground - crank
revolute A: crank - rod
revolute B: rod - piston
prismatic D: piston.B - ground.guide
mesh k: h - z { efficiency 0.95 }
slider load { mass 20 kg }
rope r: load - over(C) - w
gravity 9.81 m/s^2
drive S = 0 deg at 100 rpm
assemble B ahead of O
force R on piston at B = 100 N @ 180 deg
find effort(S)
";

#[test]
fn a_train_allocates_nothing() {
    let source = assur::internals::source::Source::new("train.mech", TRAIN);
    let (mechanism, problems) =
        assur::internals::check_source(&source, &assur::internals::check::Overrides::none());
    let mechanism = mechanism.unwrap_or_else(|| panic!("{problems:?}"));
    assert_eq!(allocations(&mechanism), 0);
}

#[test]
fn a_row_of_variants_allocates_nothing() {
    assert_eq!([allocations_of_rows(false), allocations_of_rows(true)], [0, 0]);
}

/// Allocations of rows of variants, read from a table, solved and written; of whole solutions, or for answers alone.
fn allocations_of_rows(for_answers: bool) -> u64 {
    use assur::internals::check::{Overrides, columns};
    use assur::internals::exercise::table::{Lines, Read, Table};
    use assur::internals::pipeline::VariantSolver;
    use std::fmt::Write;
    use std::sync::Arc;

    let text = include_str!("../examples/variants/crank-slider.mech");
    let source = assur::internals::source::Source::new("crank-slider.mech", text);
    let document = Arc::new(assur::internals::syntax::parse(&source).0);
    let none = Overrides::none();
    let mut table = "r [mm],l [mm],n [rpm],phi [deg],P [N]\n".to_owned();
    for i in 0..200 {
        writeln!(table, "{},{},{},{},{}", 80 + i % 40, 300 + i % 77, 500 + i, 7 * i % 360, i)
            .expect("written");
    }
    let mut table =
        Table::open("rows.csv", table.as_bytes()).expect("read").unwrap_or_else(|_| panic!("a header"));
    let columns: Arc<[_]> = columns(&document, &none, &table.columns).0.expect("columns that fit").into();
    let mut lines = Lines::default();
    table.lines(200, &mut lines).expect("read");
    let solver = VariantSolver::new(&document, &none);
    let mut solver = if for_answers { solver.for_answers() } else { solver };
    let (mut read, mut answers, mut out) = (Read::default(), None, Vec::with_capacity(1 << 20));
    let mut solve = |i: usize| {
        let raw = lines.get(i).expect("a row");
        raw.read_in("rows.csv", &columns, table.separator, &mut read).unwrap_or_else(|_| panic!("numbers"));
        if i == 0 {
            assert!(solver.prepare(&read.row));
        }
        let (solved, problems) = solver.solve_in_place(&read.row);
        let solved = solved.expect("the row closes").answers(PrintedDigits::READABLE);
        assert!(problems.is_empty());
        let written = answers.get_or_insert_with(|| AnswerColumns::of(&solved.model));
        let whole = written.whole(&solved);
        for line in written.lines(&solved, false) {
            let places = (line.pose, line.whole(&whole));
            written.write(&solved, places, (15, false, None), &mut out);
        }
    };
    (0..20).for_each(&mut solve);
    let counted = allocation_counter::measure(|| (20..200).for_each(&mut solve));
    assert!(out.len() > 20_000);
    counted.count_total
}

/// Allocations of a whole run under loads that ends at this instant.
fn allocations_of_a_run(text: &str, end: &str) -> (u64, usize) {
    let source = assur::internals::source::Source::new("run.mech", text.replace("END", end));
    let (compiled, problems) =
        assur::internals::compile(&source, &assur::internals::check::Overrides::none());
    let compiled = compiled.unwrap_or_else(|| panic!("{problems:?}"));
    let model = compiled.model();
    let mut steps = 0;
    let counted = allocation_counter::measure(|| {
        steps = solve(&model).expect("it moves").simulation.expect("a run").steps;
    });
    (counted.count_total, steps)
}

/// A crank-slider with a curve, a spring and loads that depend on the motion; two freedoms with a drive beside them; functions over
/// the run, an event and a work; functions where energy is conserved.
const RUNS: [&str; 4] = [
    "
ground { A (0, 0); line guide through A along 0 deg }
link crank  A-B 100 mm { mass 1 kg at A; inertia 0.5 kg*m^2 }
link rod    B-C 350 mm { S (117 mm, 0); mass 2.5 kg at S; inertia 0.0425 kg*m^2 }
link piston { C (0, 0); mass 2.14 kg at C }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
assemble C ahead of B
curve motor linear held { n [rpm], M [N*m]; 0, 80; 1500, 0 }
torque M on crank = motor(omega(crank))
force Q on piston at C = -2 N*s/m*velocity(C)
spring k in A { stiffness 0.5 N*m/rad; free_angle 0 deg; damping 0.01 N*m*s/rad }
gravity 9.81 m/s^2
start crank = 45 deg
simulate END within 1e-9
find omega(crank)
",
    "
gravity 9.81 m/s^2
ground { O (0, 0); line way through O along 0 deg }
link slide { A (0, 0); mass 3 kg at A }
link bar A-B 0.6 m { mass 1 kg at B; inertia 0.03 kg*m^2 }
link end B-C 0.4 m { mass 1 kg at C; inertia 0.03 kg*m^2 }
prismatic G: slide.A - ground.way
revolute A: slide - bar
revolute B: bar - end
drive G = 20 mm at 60 mm/s accelerating 3 m/s^2
start bar = -80 deg
start end = -60 deg
simulate END within 1e-9
find angle(bar), reactions
",
    "
gravity 9.81 m/s^2
ground { A (0, 0); line guide through A along 0 deg }
link crank  A-B 100 mm { mass 1 kg at A; inertia 0.5 kg*m^2 }
link rod    B-C 350 mm { S (117 mm, 0); mass 2.5 kg at S; inertia 0.0425 kg*m^2 }
link piston { C (0, 0); mass 2.14 kg at C }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
assemble C ahead of B
torque M on crank = 20 N*m - 0.2 N*m*s*omega(crank)
start crank = 45 deg
simulate END within 1e-8
event quarter: angle(crank) = 90 deg
let speed = mag(velocity(C))
find max(speed), argmax(speed), integral(speed), mean(omega(crank)), max(mag(acceleration(C)), after = 0.1 s), time(quarter), work(M)
",
    "
gravity 9.81 m/s^2
ground { A (0, 0) }
link bar A-P 1 m { mass 1 kg at P; inertia 0.1 kg*m^2 }
revolute A: ground - bar
start bar = 0 deg at 30 rad/s
simulate END within 1e-8
find max(omega(bar)), min(mag(acceleration(P))), mean(position(P).y)
",
];

/// Every run of a pair, or of several until they agree, takes its memory at its begin: of two files that differ in the last
/// instant alone, and in many steps, the one allocates as often as the other.
#[test]
fn the_steps_of_a_run_allocate_nothing() {
    for text in RUNS {
        let ends = ["0.3 s", "0.5 s", "0.7 s", "1 s", "1.5 s", "2 s", "2.8 s", "3 s"];
        let found = ends.map(|end| allocations_of_a_run(text, end));
        let alike = |a: &(u64, usize), b: &(u64, usize)| a.0 == b.0 && b.1 > a.1 + 30;
        assert!(found.iter().any(|a| found.iter().any(|b| alike(a, b))), "{found:?} of{text}");
    }
}

/// A turn whose rates have no value beyond a little more than its radius.
struct Turn;

impl System<f64> for Turn {
    fn rates(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        (dy[0], dy[1]) = (-y[1], y[0]);
        if y[0] * y[0] + y[1] * y[1] < 1.0 + 1e-5 { Ok(()) } else { Err(Undefined) }
    }
}

/// Steps with rejected trials, dense output and events allocate nothing.
fn steps(method: &mut impl Integrator<f64>) {
    let mut between = [0.0; 2];
    let counted = allocation_counter::measure(|| {
        method.start(&mut Turn, 0.0, &[1.0, 0.0], 50.0).expect("the start has rates");
        loop {
            let step = method.step(&mut Turn).expect("it goes on");
            method.prepare_dense(&mut Turn).expect("it has rates");
            method.dense(0.5 * (method.previous_t() + method.t()), &mut between);
            if method.counts().steps == 20 {
                let t = 0.25 * method.previous_t() + 0.75 * method.t();
                method.shorten(&mut Turn, t).expect("it has rates");
                let y = [method.y()[0], method.y()[1]];
                method.restart(&mut Turn, &y, 50.0).expect("it has rates");
            }
            if step == Step::Last {
                break;
            }
        }
    });
    assert!(method.counts().rejected > 0 && method.counts().shortened == 1 && between[0].is_finite());
    assert_eq!(counted.count_total, 0);
}

#[test]
fn the_loop_over_steps_allocates_nothing() {
    steps(&mut Dop853::new(Tolerance::uniform(2, 1e-4, 1e-4)));
    steps(&mut Extrapolation::new(Tolerance::uniform(2, 1e-4, 1e-4)));
    steps(&mut Radau::new(&Tolerance::uniform(2, 1e-4, 1e-4)));
}
