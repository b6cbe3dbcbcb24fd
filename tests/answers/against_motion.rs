//! Loads against the motion at rest and at reversal, rests that end by a load that is switched on, and an impact at the first instant.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

fn number(text: &str, pose: usize, name: &str) -> f64 {
    let solution = assur::solve(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    solution.poses()[pose][name].number().unwrap()
}

fn near(got: f64, right: f64, within: f64) {
    assert!((got - right).abs() <= within, "{got}, not {right}");
}

#[test]
fn a_brake_is_at_its_event_what_it_was_before() {
    let text = include_str!("../cases/use3/numbers/brake-sign-at-stop.mech");
    near(number(text, 1, "M"), -113.111, 1e-9);
    let text = include_str!("../cases/use3/numbers/brake-crank-slider.mech");
    near(number(text, 1, "M"), -5.0, 1e-9);
    let text = include_str!("../cases/use3/numbers/brake-extremes.mech");
    near(number(text, 0, "max(M)"), 0.0, 1e-9);
    near(number(text, 0, "min(M)"), -100.0, 1e-9);
    near(number(text, 0, "mean(M)"), -200.0 / 3.0, 1e-7);
}

#[test]
fn an_impact_at_the_first_instant_comes_after_it() {
    let text = include_str!("../cases/use3/numbers/impact-at-the-first-instant.mech");
    near(number(text, 0, "relative_velocity(P)"), -1.0, 1e-12);
    near(number(text, 1, "relative_velocity(P)"), 0.5, 1e-9);
}

/// Numbers between 0 and 1 without end.
fn random(seed: u64) -> impl FnMut(f64, f64) -> f64 {
    let mut state = seed;
    move |from, to| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let part = f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(u32::MAX);
        from + part * (to - from)
    }
}

#[test]
fn what_rests_gets_going_when_a_load_is_switched_on() {
    let text = include_str!("../cases/use3/numbers/held-then-switched-on.mech");
    near(number(text, 1, "w"), 0.8228, 1e-9);
    let mut random = random(37);
    for case in 0..60 {
        let (holds, mass) = (random(1.0, 50.0), random(0.1, 20.0));
        let (force, on) = (holds * random(1.01, 4.0), random(0.1, 5.0));
        let end = on + random(0.05, 5.0);
        let off = on + random(0.2, 0.9) * (end - on);
        let (window, by_load) = (case % 3 == 0, case % 2 == 0);
        let sign = if case % 4 < 2 { ">" } else { ">=" };
        let until = if window { format!(" and time < {off} s") } else { String::new() };
        let friction =
            if by_load { String::new() } else { format!(" {{ friction {} }}", holds / mass / 10.0) };
        let load =
            if by_load { format!("force R on b at B = {holds} N against motion\n") } else { String::new() };
        let text = format!(
            "gravity 10 m/s^2
ground {{ O (0, 0); line way through O along 0 deg }}
link b {{ B (0, 0); mass {mass} kg at B }}
prismatic P: b.B - ground.way{friction}
force F on b at B = ({force} N, 0) when time {sign} {on} s{until}
{load}start P = 0 mm
simulate {end} s
find w = relative_velocity(P)
"
        );
        let pulled = (force - holds) / mass;
        let free = if window { off } else { end };
        let right = (pulled * (free - on) - holds / mass * (end - free)).max(0.0);
        near(number(&text, 1, "w"), right, 1e-8 * pulled * (end - on));
    }
}

/// A mass on a spring with dry friction: half-cycles, each less wide by 2 F/k.
#[test]
fn half_cycles_with_a_load_against_motion() {
    let mut random = random(11);
    for _ in 0..20 {
        let (k, mass, wide) = (random(10.0, 500.0), random(0.2, 5.0), random(0.05, 0.4));
        let force = k * wide * random(0.06, 0.3);
        let half = std::f64::consts::PI * (mass / k).sqrt();
        let mut places = vec![wide];
        while places.last().unwrap().abs() * k > force * 1.001 {
            let x = *places.last().unwrap();
            places.push(-x.signum() * (x.abs() - 2.0 * force / k));
        }
        if places.last().unwrap().abs() * k > 0.999 * force {
            continue;
        }
        let turns = places.len() - 1;
        let end = half * (1.3 + f64::from(u32::try_from(turns).unwrap()));
        let text = format!(
            "ground {{ O (0, 0); W (-1 m, 0); line way through O along 0 deg }}
link b {{ B (0, 0); mass {mass} kg at B }}
prismatic P: b.B - ground.way
spring s: ground.W - b.B {{ stiffness {k} N/m; free_length 1 m }}
force R on b at B = {force} N against motion
start P = {wide} m
simulate {end} s
event e: relative_velocity(P) = 0 m/s
find x = displacement(P), f = R.x, most = max(R.x)
"
        );
        let solution = assur::solve(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let at = |pose: usize, name: &str| solution.poses()[pose][name].number().unwrap();
        for turn in 1..=turns {
            near(at(turn, "x"), places[turn], 1e-8 * wide);
            near(at(turn, "f"), force * (places[turn - 1] - places[turn]).signum(), 1e-9 * force);
        }
        // at rest it holds the spring
        near(at(turns + 1, "f"), k * places[turns], 1e-7 * force);
        near(at(0, "most"), force, 1e-8 * force);
    }
}

/// With a load against the motion and no friction forces follow from accelerations, between the instants that are printed too.
#[test]
fn forces_beside_a_brake_are_known_between_the_instants() {
    let drum = "\
mech 1
gravity 9.81 m/s^2
shaft drum { wheel w radius 0.25 m; inertia 3.2 kg*m^2 }
slider load { mass 60 kg }
rope a: load - w
brake Mf on drum { capacity 12 N*m }
start drum = 0 deg at 0 rad/s
simulate 0 s .. 2 s in 4 steps
event taut: tension(a, load) = 100 N
find most = max(tension(a, load)) as N, least = min(tension(a, load)) as N, mean = mean(tension(a, load)) as N
";
    // m g R = (I + m R²) α + M
    let alpha = (60.0 * 9.81 * 0.25 - 12.0) / (3.2 + 60.0 * 0.0625);
    for name in ["most", "least", "mean"] {
        near(number(drum, 0, name), 60.0 * (9.81 - 0.25 * alpha), 1e-9);
    }
    let slider = "\
mech 1
gravity 9.81 m/s^2
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 0.1 m { S (0.05 m, 0); mass 1 kg at S; inertia 0.002 kg*m^2 }
link rod B-C 0.35 m { S (0.15 m, 0); mass 2 kg at S; inertia 0.02 kg*m^2 }
link piston { C (0, 0); mass 3 kg at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
torque M on crank = 12 N*m against motion
assemble C ahead of B
start crank = 80 deg at 60 rad/s
simulate 0 s .. 0.3 s in 3000 steps
event flips: normal(D, piston) = 0 N
find N = normal(D, piston) as N, R = mag(reaction(A)) as N
find most = max(normal(D, piston)) as N, least = min(normal(D, piston)) as N, strongest = max(mag(reaction(A))) as N, flip = time(flips) as s
";
    let solution = assur::solve(slider).unwrap_or_else(|error| panic!("{error}"));
    let row = |name: &str| -> Vec<f64> {
        solution.poses().iter().map(|pose| pose[name].number().unwrap()).collect()
    };
    let (normal, pull) = (row("N"), row("R"));
    let greatest = |all: &[f64]| all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = -greatest(&normal.iter().map(|x| -x).collect::<Vec<_>>());
    let found = |name: &str| solution.poses()[0][name].number().unwrap();
    for (name, rows) in [("most", greatest(&normal)), ("least", least), ("strongest", greatest(&pull))] {
        near(found(name), rows, 2e-4 * rows.abs());
    }
    let before = normal.windows(2).position(|pair| pair[0] * pair[1] < 0.0).unwrap();
    let step = 0.3 / 3000.0;
    near(found("flip"), (before as f64 + 0.5) * step, 1.5 * step);
}

/// A crank drives a slider against a force; at each dead centre, where the slider turns, the force holds nothing.
#[test]
fn a_force_on_a_slider_ends_steps_where_it_turns() {
    let text = |within: &str| {
        format!(
            "ground {{ O (0, 0); line way through O along 0 deg }}
link a O-A 99 mm {{ mass 1 kg at O; inertia 0.1386 kg*m^2 }}
link b A-C 489.7 mm {{ S (244.8 mm, 0); mass 2.564 kg at S; inertia 0.0112 kg*m^2 }}
link s {{ C (0, 0); mass 3.492 kg at C }}
revolute O: ground - a
revolute A: a - b
revolute C: b - s
prismatic G: s.C - ground.way
assemble C ahead of A
force F on s at C = 30.02 N against motion
torque M on a = 5.018 N*m
start a = 146.3 deg at 14.92 rad/s
simulate 1 s in 10 steps within {within}
find p = angle(a)
"
        )
    };
    let right = number(&text("1e-11"), 10, "p");
    for within in [1e-4, 1e-6, 1e-8] {
        near(number(&text(&format!("{within:e}")), 10, "p"), right, within * right);
    }
}

/// One free coordinate moves a point of a coupler on a curve; the force holds it until the torque overcomes it.
#[test]
fn a_force_holds_a_point_that_moves_on_a_curve() {
    let text = |force: f64| {
        format!(
            "ground {{ A (0, 0); D (300 mm, 0) }}
link crank A-B 100 mm {{ mass 1 kg at A; inertia 0.1 kg*m^2 }}
link coupler B-C 300 mm {{ P (150 mm, 80 mm) }}
link rocker D-C 200 mm
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
assemble C left of B-D
force F on coupler at P = {force} N against motion
torque M on crank = 10 N*m/s*time
start crank = 60 deg
simulate 1 s in 10 steps
find w = omega(crank), size = mag(F)
"
        )
    };
    let still = |force: f64| (0..=10).filter(|pose| number(&text(force), *pose, "w") == 0.0).count();
    // the torque reaches 10 N m: of a force that is not overcome as much acts as is needed, more with every instant
    assert_eq!(still(400.0), 11);
    let held: Vec<f64> = (0..=10).map(|pose| number(&text(400.0), pose, "size")).collect();
    for (pose, force) in held.iter().enumerate() {
        near(*force, held[10] * pose as f64 / 10.0, 1e-9 * held[10]);
    }
    // it lets go when as much would be needed
    let part = 0.55;
    assert_eq!(still(part * held[10]), 6);
}
