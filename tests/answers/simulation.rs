//! Motions under loads: the error that is reported is the true one, events, and what comes out of a run in every form.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::report::{self, PrintedDigits, csv};
use assur::internals::solve::{Method, extent};
use assur::internals::source::Source;
use assur::internals::{compile, solve_source, solve_within};
use std::f64::consts::PI;
use std::path::Path;

fn examples() -> Vec<Source> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/simulation");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().flatten().map(|e| e.path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "mech"));
    paths.sort();
    let name = |p: &Path| p.file_stem().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|p| Source::new(name(p), std::fs::read_to_string(p).unwrap())).collect()
}

fn run(source: &Source, within: f64) -> Solved {
    let (compiled, problems) = compile(source, &Overrides::none());
    let mut compiled = compiled.unwrap_or_else(|| panic!("{}: {problems:?}", source.name));
    let simulation = compiled.mechanism.simulation.as_mut().unwrap();
    simulation.within = Some(within);
    // enough instants to see the greatest of every kind
    simulation.steps = simulation.steps.max(Some(40));
    let (solved, _) = solve_within(compiled, None);
    solved.unwrap_or_else(|_| panic!("{} moves", source.name))
}

/// Numbers of a run by kind, each with the greatest that it is compared to.
fn numbers(solved: &Solved) -> Vec<(&'static str, Vec<f64>)> {
    let mut kinds: Vec<(&'static str, Vec<f64>)> = [
        "positions",
        "directions",
        "velocities",
        "angular velocities",
        "accelerations",
        "angular accelerations",
        "forces",
        "moments",
    ]
    .map(|k| (k, Vec::new()))
    .into();
    let forces = solved.compiled.plan.effects.forces;
    for pose in &solved.solution.poses {
        let Ok(found) = &pose.outcome else { continue };
        for b in &found.state.motion.bodies {
            let each = [
                vec![b.p.x, b.p.y],
                vec![b.u.x, b.u.y],
                vec![b.v.x, b.v.y],
                vec![b.omega],
                vec![b.a.x, b.a.y],
                vec![b.alpha],
            ];
            each.into_iter().enumerate().for_each(|(i, x)| kinds[i].1.extend(x));
        }
        for r in found.state.forces.reactions.iter().filter(|_| forces) {
            kinds[6].1.extend([r.force.x, r.force.y]);
            kinds[7].1.push(r.couple);
        }
    }
    let report = solved.solution.simulation.as_ref().unwrap();
    kinds.push(("events", report.events.iter().flatten().copied().collect()));
    kinds.push(("functions", solved.solution.statics.cycles.iter().map(|c| c.value).collect()));
    kinds
}

/// The greatest of each kind over the whole motion, of which the instants that are printed may show little.
fn scales(source: &Source) -> Vec<f64> {
    let (compiled, _) = compile(source, &Overrides::none());
    let mut compiled = compiled.unwrap();
    let simulation = compiled.mechanism.simulation.as_mut().unwrap();
    (simulation.within, simulation.steps) = (Some(1e-6), Some(2000));
    let (solved, _) = solve_within(compiled, None);
    let solved = solved.unwrap_or_else(|_| panic!("{} moves", source.name));
    numbers(&solved).into_iter().map(|(_, x)| x.iter().fold(0.0_f64, |m, x| m.max(x.abs()))).collect()
}

/// The worst error of a run beside a much finer one, relative to the greatest of each kind.
fn error(solved: &Solved, exact: &Solved, scales: &[f64]) -> (f64, &'static str) {
    let mut worst = (0.0, "");
    let length = exact.solution.simulation.as_ref().unwrap().end;
    for (((kind, a), (_, b)), greatest) in numbers(solved).into_iter().zip(numbers(exact)).zip(scales) {
        let greatest = b.iter().fold(*greatest, |m, x| m.max(x.abs()));
        let scale = match kind {
            "positions" => extent(&exact.compiled.model()).max(greatest),
            "directions" | "functions" => 1.0,
            "events" => length,
            _ => greatest,
        };
        let error = if a.len() == b.len() {
            a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        } else {
            f64::INFINITY
        };
        let scales = &exact.solution.statics.cycles;
        let error = if kind == "functions" {
            a.iter().zip(&b).zip(scales).map(|((a, b), c)| (a - b).abs() / c.scale).fold(0.0, f64::max)
        } else {
            error
        };
        let error = if error == 0.0 { 0.0 } else { error / scale };
        if error > worst.0 {
            worst = (error, kind);
        }
    }
    worst
}

/// The finest run that keeps what it says. Over change points of several coordinates accelerations are read off series that leave off
/// 1e-11 of the positions: there they have ten digits at most.
fn finest(source: &Source) -> Solved {
    let mut found = [1e-13, 1e-12, 1e-11, 1e-10, 1e-9].into_iter().map(|within| run(source, within));
    let whole = |solved: &Solved| solved.solution.poses.iter().all(|p| p.outcome.is_ok());
    found.find(whole).unwrap_or_else(|| panic!("{} keeps what it says", source.name))
}

/// Reported over true errors for tolerances from 1e-3 to 1e-11: never below a half. Coordinates that nothing shows count
/// in what is reported, so that above there is no bound.
#[test]
fn the_reported_error_is_that_of_the_run() {
    let mut ratios = Vec::new();
    for source in examples() {
        let (exact, scales) = (finest(&source), scales(&source));
        let best = exact.solution.simulation.as_ref().unwrap().error;
        for digits in [3, 5, 6, 8, 9, 11] {
            let within = 0.1_f64.powi(digits);
            let solved = run(&source, within);
            let report = solved.solution.simulation.as_ref().unwrap();
            let (true_error, kind) = error(&solved, &exact, &scales);
            // of what is as small as the error of the finest run nothing is known
            if true_error <= 10.0 * best || solved.solution.poses.iter().any(|p| p.outcome.is_err()) {
                continue;
            }
            let ratio = report.error / true_error;
            println!(
                "{:18} 1e-{digits:<3} reported {:8.1e} {:22} true {true_error:8.1e} {kind:22} ratio {ratio:7.2}",
                source.name, report.error, report.worst
            );
            assert!(true_error <= 2.0 * within, "{} within {within:e}: {true_error:e}", source.name);
            // the implicit method keeps far more than is wanted, both runs alike: what they differ by says less
            if solved.compiled.mechanism.has_curves {
                // a step does not end where the rows of a curve meet
                assert!(ratio > 0.2, "{} within {within:e}: {ratio}", source.name);
            } else if report.method != Method::Radau {
                ratios.push(ratio);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let least = ratios[0];
    let at = |share: usize| ratios[ratios.len() * share / 100];
    println!("{} runs: least {least:.2}, {:?}", ratios.len(), [5, 25, 50, 75, 95].map(at));
    assert!(ratios.len() > 100 && least > 0.5 && at(5) > 1.0 && at(75) < 30.0);
}

fn solved(text: &str, overrides: &Overrides) -> Solved {
    let source = Source::new("run.mech", text);
    let (solved, problems) = solve_source(&source, overrides);
    let solved = solved.unwrap_or_else(|| panic!("{problems:?}"));
    assert!(!problems.has_errors(), "{problems:?}");
    solved
}

fn csv_of(solved: &Solved) -> String {
    csv::render(&report::table_of_poses(&solved.answers(PrintedDigits::READABLE)))
}

/// All that a run leaves, to the last bit.
fn bits(solved: &Solved) -> String {
    let states = solved.solution.poses.iter().map(|p| format!("{:?}\n", p.outcome));
    csv_of(solved) + &states.collect::<String>() + &format!("{:?}", solved.solution.simulation)
}

#[test]
fn a_run_has_the_same_bits_again() {
    for source in examples() {
        let one = || bits(&solve_source(&source, &Overrides::none()).0.unwrap());
        assert_eq!(one(), one(), "{}", source.name);
    }
}

const PENDULUM: &str = "mech 1
mechanism \"Pendulum\"
given l = 1 m
given a = 0 deg
given g = 9.81 m/s^2
gravity g
ground { A (0, 0) }
link bar A-P l { mass 1 kg at P; inertia 0 kg*m^2 }
revolute A: ground - bar
start bar = a
simulate 10 s within 1e-12
event rest: omega(bar) = 0 rad/s
event same: omega(bar) = 0 rad/s
event back: omega(bar) = 0 rad/s falling
event lowest: angle(bar) = -90 deg
event left: angle(bar) < -90 deg
find position(P), omega(bar), count(rest)
";

/// The period from the horizontal is T = 4 K(sin 45 deg) sqrt(l/g); K(sin 45 deg) is half of π over the arithmetic-geometric
/// mean of 1 and cos 45 deg.
#[test]
fn events_are_where_the_closed_form_says_and_in_order() {
    let (mut a, mut b) = (1.0_f64, 0.5_f64.sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let period = 2.0 * PI / a / 9.81_f64.sqrt();
    let run = solved(PENDULUM, &Overrides::none());
    let report = run.solution.simulation.as_ref().unwrap();
    let [rest, same, back, lowest, left] = &report.events[..] else { panic!("five events") };
    let are = |times: &[f64], first: f64, step: f64, what: &str| {
        let count = ((10.0 / period - first) / step).floor() as usize + 1;
        assert_eq!(times.len(), count, "{what}: {times:?}");
        for (i, t) in times.iter().enumerate() {
            let want = (first + step * i as f64) * period;
            assert!((t - want).abs() < 1e-11, "{what} {i}: {t} not {want}, {:e}", t - want);
        }
    };
    are(rest, 0.5, 0.5, "rest");
    assert_eq!(rest, same);
    are(back, 1.0, 1.0, "back");
    are(lowest, 0.25, 0.5, "lowest");
    are(left, 0.25, 1.0, "left");
    // without steps the instants of all events are printed, each once and in order
    let names: Vec<f64> = run.solution.poses.iter().map(|p| p.name.parse().unwrap()).collect();
    assert!(names.windows(2).all(|t| t[0] < t[1]), "{names:?}");
    assert_eq!(names.len(), 2 + rest.len() + lowest.len());
    // where it is at rest it is level again
    for time in rest {
        let found = run.solution.poses.iter().find(|p| (p.name.parse::<f64>().unwrap() - time).abs() < 1e-12);
        let state = found.unwrap().outcome.as_ref().unwrap();
        assert!(
            state.state.motion.bodies[1].u.y.abs() < 1e-11
                && state.state.motion.bodies[1].omega.abs() < 1e-11
        );
    }
}

/// Between instants nothing of what is asked for changes a run, and it ends where `until` says.
#[test]
fn a_run_ends_at_the_first_until() {
    let text = format!("{PENDULUM}until angle(bar) = -170 deg\nuntil omega(bar) < -4 rad/s\n");
    let run = solved(&text, &Overrides::none());
    let report = run.solution.simulation.as_ref().unwrap();
    assert!(report.ended_by == Some(6) && report.end < 0.6, "{report:?}");
    let last = run.solution.poses.last().unwrap().outcome.as_ref().unwrap();
    assert!((last.state.motion.bodies[1].omega + 4.0).abs() < 1e-11);
    let kept = solved(PENDULUM, &Overrides::none()).solution.simulation.unwrap();
    assert!(kept.end == 10.0 && kept.ended_by.is_none());
}

/// A motion so smooth that a step would go on for many turns: angle = t^2 5 rad/s^2, in 10 s 500 rad.
#[test]
fn nothing_is_lost_while_a_body_turns_many_times() {
    let text = "
shaft rotor { inertia 2 kg*m^2 }
torque M on rotor = 20 N*m
start rotor = 0 deg
simulate 10 s
event turn: cos(angle(rotor)) = 0
event up: cos(angle(rotor)) = 0 rising
event down: cos(angle(rotor)) < 0
find max(cos(angle(rotor))), min(cos(angle(rotor))), mean(sin(angle(rotor))^2)
";
    let run = solved(text, &Overrides::none());
    let report = run.solution.simulation.as_ref().unwrap();
    let [turn, up, down] = &report.events[..] else { panic!("three events") };
    assert_eq!([turn.len(), up.len(), down.len()], [159, 79, 80]);
    for (i, t) in turn.iter().enumerate() {
        let want = ((i as f64 + 0.5) * PI / 5.0).sqrt();
        assert!((t - want).abs() < 1e-9, "{i}: {t} not {want}");
    }
    let values: Vec<f64> = run.solution.statics.cycles.iter().map(|c| c.value).collect();
    // the mean of sin^2(5 t^2), by Fresnel's integral
    for (value, want) in values.iter().zip([1.0, -1.0, 0.489_885_032_323_011]) {
        assert!((value - want).abs() < 1e-8, "{values:?}");
    }
    let without = text.lines().filter(|line| !line.starts_with("event")).collect::<Vec<_>>().join("\n");
    let run = solved(&without, &Overrides::none());
    for (value, want) in run.solution.statics.cycles.iter().zip(values) {
        assert!((value.value - want).abs() < 1e-8, "{value:?} not {want}");
    }
}

/// Instants within a step that ends at a reversal have the friction of before: x'' = -k x/m - f g sign(x').
#[test]
fn friction_has_one_sense_up_to_a_reversal() {
    let text = "
gravity 9.81 m/s^2
ground { O (0, 0); W (-1 m, 0); line floor through O along 0 deg }
link block { B (0, 0); mass 1 kg at B }
prismatic P: block.B - ground.floor { friction 0.25 }
spring s: ground.W - block.B { stiffness 100 N/m; free_length 1 m }
start P = 0.5 m
simulate 5 s in 500 steps
find displacement(P), relative_velocity(P), relative_acceleration(P)
";
    let run = solved(text, &Overrides::none());
    for pose in &run.solution.poses {
        let b = pose.outcome.as_ref().unwrap().state.motion.bodies[1];
        let want = if b.v.x == 0.0 { 0.0 } else { -100.0 * b.p.x - 0.25 * 9.81 * b.v.x.signum() };
        let starts = pose.name == "0";
        assert!(starts || (b.a.x - want).abs() < 1e-9, "{}: {} not {want}", pose.name, b.a.x);
    }
}

/// Digits of a coordinate are all that is known of it: far from the scheme's other points the steps are no shorter.
#[test]
fn a_block_that_begins_far_away_takes_no_more_steps() {
    let far = |start: f64| {
        let text = format!(
            "
ground {{ O (0, 0); line floor through O along 0 deg }}
link block {{ B (0, 0); mass 2 kg at B }}
prismatic P: block.B - ground.floor
force F on block at B = 1 N*sin(1 rad/s*time) @ 0 deg
spring s: block.B - ground.O {{ stiffness 400 N/m; free_length 0 m }}
start P = {start} m
simulate 0.7 s in 14 steps
find displacement(P)
"
        );
        let run = solved(&text, &Overrides::none());
        let end = run.solution.poses.last().unwrap().outcome.as_ref().unwrap().state.motion.bodies[1].p.x;
        let want = start * libm::cos(200f64.sqrt() * 0.7);
        // the force moves it by less than 1 N/k
        assert!((end - want).abs() < 1e-8 * start + 5e-3, "{end} not {want}");
        run.solution.simulation.unwrap().evaluations
    };
    let (near, away) = (far(1.0), far(1e12));
    assert!(away <= near + near / 10, "{near}, {away}");
}

/// Loads against the motion of each of several free coordinates.
/// A bar that turns uniformly: speeds and energies stay, accelerations are zero but for rounding.
#[test]
fn of_a_value_that_does_not_change_the_first_instant_is_the_greatest() {
    let text = "mech 1\nmechanism \"bar\"\nground { A (0, 0) }\nlink bar A-B 0.7 m { S (0.3 m, 0.2 m); \
        mass 1.3 kg at S; inertia 0.07 kg*m^2 }\nrevolute A: ground - bar\nstart bar = 30 deg at 9.7 rad/s\n\
        simulate 0.5 s .. 1.5 s within 1e-9\n\
        find argmax(omega(bar)), argmax(alpha(bar)), argmax(kinetic_energy()), argmax(mag(reaction(A))), \
        argmax(0*angle(bar)), argmax(omega(bar), after = 0.8 s), argmax(angle(bar)), max(alpha(bar)), min(omega(bar))";
    let solved = solved(text, &Overrides::none());
    let cycles = &solved.solution.statics.cycles;
    let values: Vec<f64> = cycles.iter().map(|cycle| cycle.value).collect();
    assert_eq!(values[..7], [0.5, 0.5, 0.5, 0.5, 0.5, 0.8, 1.5]);
    assert!(values[7].abs() < 1e-12 && (values[8] - 9.7).abs() < 1e-13, "{values:?}");
    let report = solved.solution.simulation.as_ref().unwrap();
    assert!(report.error < 1e-12, "{report:?}");
}

/// A worm that locks stands by its losses: its screw bears what its motor gives, and the wheel the load.
#[test]
fn a_worm_at_rest_holds_by_itself() {
    let text = "mech 1\nmechanism \"worm\"\nshaft screw { wheel a radius 20 mm; inertia 0.002 kg*m^2 }\n\
        shaft drum { wheel w teeth 40 module 4 mm; inertia 0.5 kg*m^2 }\n\
        worm k: a - w { starts 1; efficiency 0.4 }\ntorque M on screw = 0.1 N*m*sin(3 rad/s*time)\n\
        torque L on drum = -14 N*m\nstart screw = 0 deg\nsimulate 2 s in 4 steps within 1e-9\n\
        expect moment(k, screw) = -0.1 N*m*sin(3 rad) within 1e-12 N*m at time = 1 s\n\
        expect moment(k, drum) = 14 N*m within 1e-12 at time = 1 s\n\
        expect omega(drum) = 0 rad/s within 1e-12 rad/s at event end";
    let solved = solved(text, &Overrides::none());
    assert_eq!(solved.outcomes.len(), 3);
    assert!(solved.outcomes.iter().all(|outcome| outcome.passed), "{:?}", solved.outcomes);
}

#[test]
fn several_coordinates_are_braked_each_by_its_own() {
    let shaft = |name: &str| {
        format!(
            "shaft {name} {{ inertia 1 kg*m^2 }}\nstart {name} = 0 deg at 10 rad/s\ntorque on {name} = 2 N*m against motion\n"
        )
    };
    for names in [&["a", "b"][..], &["a", "b", "c"][..]] {
        let shafts: String = names.iter().map(|name| shaft(name)).collect();
        let run = solved(&format!("{shafts}simulate 3 s\nfind omega(a), omega(b)\n"), &Overrides::none());
        let last = run.solution.poses.last().unwrap().outcome.as_ref().unwrap();
        assert!(
            last.state.motion.bodies[1..].iter().all(|b| (b.omega - 4.0).abs() < 1e-8),
            "{:?}",
            last.state.motion.bodies
        );
    }
}

/// A line of a table is an instant; values set from outside are those of the file.
#[test]
fn tables_have_a_column_of_instants() {
    let text = PENDULUM.replace("simulate 10 s", "simulate 1 s .. 2 s in 4 steps");
    let lines = csv_of(&solved(&text, &Overrides::none()));
    let mut lines = lines.lines();
    assert!(
        lines
            .next()
            .unwrap()
            .starts_with("time [s],event,position(P).x [m],position(P).y [m],omega(bar) [rad/s]")
    );
    let times: Vec<&str> = lines.map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(times, ["1", "1.25", "1.5", "1.75", "2"]);
    let set = Overrides::set(vec![("l".into(), "0.7m".into()), ("a".into(), "15deg".into())]);
    let written =
        text.replace("given l = 1 m", "given l = 0.7 m").replace("given a = 0 deg", "given a = 15 deg");
    assert_eq!(csv_of(&solved(&text, &set)), csv_of(&solved(&written, &Overrides::none())));
}

/// A row of variants comes out as the file with its values.
#[test]
fn rows_are_the_files_with_their_values() {
    let table =
        "variants {\n  l [m], a [deg], g [m/s^2]\n  1, 0, 9.81\n  0.5, 10, 9.81\n  2.5, -20, 1.62\n}\n";
    let problem = assur::Problem::new("run.mech", format!("{PENDULUM}{table}"));
    let rows = problem.solve_variants().unwrap();
    assert_eq!(rows.len(), 3);
    for (row, (l, a, g)) in
        rows.into_iter().zip([("1", "0", "9.81"), ("0.5", "10", "9.81"), ("2.5", "-20", "1.62")])
    {
        let row = row.unwrap();
        let alone = assur::Problem::new("run.mech", PENDULUM)
            .set("l", &format!("{l}m"))
            .set("a", &format!("{a}deg"))
            .set("g", &format!("{g}m/s^2"))
            .solve()
            .unwrap();
        assert_eq!(row.poses().len(), alone.poses().len());
        for (one, two) in row.poses().iter().zip(alone.poses()) {
            assert_eq!(one.name(), two.name());
            for ((name, x), (_, y)) in one.iter().zip(two.iter()) {
                assert_eq!(format!("{x:?}"), format!("{y:?}"), "{name}");
            }
        }
    }
}

/// Rates of a drive that follows an expression of time are its derivatives.
#[test]
fn a_drive_of_time_moves_at_its_derivatives() {
    let expressions = [
        "sin(3 rad/s*time)*cos(2 rad/s*time)",
        "tan(0.9 rad/s*time)/(2 + time^2/1 s^2)",
        "sqrt(1 + time/1 s) - exp(-time/0.5 s)*log(2 + time/1 s)",
        "atan(2*time/1 s)/1 rad + asin(0.8*sin(time*1 rad/s))/1 rad - acos(0.5*time/1 s)/1 rad",
        "atan2(1 + time/1 s, 2 - time^2/1 s^2)/1 rad",
        "(1.5 + time/1 s)^(2 - time/1 s) + (1 + time/1 s)^3 - (2 + time/1 s)^(-0.5)",
        "max(time/1 s, 0.3 + 0.2*time/1 s)*abs(time/1 s - 3) + min(2, 3 - time/1 s)",
        "c(time) + slope(c(time))*0.1 s",
    ];
    for expression in expressions {
        let text = format!(
            "ground {{ O (0, 0); line rail through O along 0 deg }}
             curve c {{
               t [s], x
               0, 0.1
               0.4, 0.5
               0.7, 0.2
               1, 0.9
             }}
             link cart {{ A (0, 0) }}
             link bob A-B 1 m {{ mass 1 kg at B; inertia 0.01 kg*m^2 }}
             prismatic G: cart.A - ground.rail
             revolute A: cart - bob
             drive G = 100 mm*({expression})
             start bob = -80 deg
             simulate 1 s in 1000 steps within 1e-3
             find x = displacement(G), v = relative_velocity(G), a = relative_acceleration(G)"
        );
        let solution = assur::solve(&text).unwrap_or_else(|e| panic!("{expression}: {e}"));
        let poses = solution.poses();
        let at = |i: usize, name: &str| poses[i][name].number().unwrap_or(f64::NAN);
        let h = 1e-3;
        let mut compared = 0;
        for i in (20..980).step_by(37) {
            let v = (at(i + 1, "x") - at(i - 1, "x")) / (2.0 * h);
            let a = (at(i + 1, "v") - at(i - 1, "v")) / (2.0 * h);
            // where pieces meet the difference of both sides is not the derivative of either
            let jumps = (at(i + 1, "a") - at(i - 1, "a")).abs() > 0.1;
            if !jumps {
                assert!((v - at(i, "v")).abs() < 1e-4, "{expression} at {i}: {v} and {}", at(i, "v"));
                assert!((a - at(i, "a")).abs() < 1e-3, "{expression} at {i}: {a} and {}", at(i, "a"));
                compared += 1;
            }
        }
        assert!(compared > 15, "{expression}: {compared}");
    }
}

/// A cylinder that rolls in a trough, to and fro: its slope is that of a pendulum with the inertia of the rolling beside its mass.
#[test]
fn what_friction_holds_rolls_on_a_round_floor() {
    let text = "gravity 9.81 m/s^2
ground { O (0, 0); circle trough centre O radius 1 m }
link frame O-F 500 mm { line out through F along 0 deg }
link ball { W (0, 0); circle rim centre W radius 100 mm; mass 6 kg at W; inertia 0.03 kg*m^2 }
revolute O: ground - frame
slot     H: ball.W - frame.out
contact  K: ball.rim - ground.trough { internal; friction 0.4 }
assemble ball.W near (0 mm, -900 mm)
start frame = -60 deg
start ball = 0 deg
simulate 2 s in 20 steps within 1e-11
find omega(frame), omega(ball), angle(frame), normal(K, ball), friction(K, ball), sticks(K)
";
    let run = solved(text, &Overrides::none());
    let mut swings = false;
    for pose in &run.solution.poses {
        let state = &pose.outcome.as_ref().unwrap().state;
        let [frame, ball] = [1, 2].map(|i| &state.motion.bodies[i]);
        // (m + J/r^2) (R - r) phi'' = -m g sin phi, and the energy of it
        let sine = frame.u.x;
        let alpha = -6.0 * 9.81 * sine / (9.0 * 0.9);
        assert!((frame.alpha - alpha).abs() < 1e-9, "{} {alpha}", frame.alpha);
        let square = 2.0 * 6.0 * 9.81 * (-frame.u.y - 0.75_f64.sqrt()) / (9.0 * 0.9);
        assert!((frame.omega * frame.omega - square).abs() < 1e-9, "{} {square}", frame.omega);
        assert!((ball.omega + 9.0 * frame.omega).abs() < 1e-9, "{} {}", ball.omega, frame.omega);
        swings |= frame.omega > 1.0;
    }
    assert!(swings);
}
