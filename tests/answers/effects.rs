//! An effect that nothing calls for adds no step to the plan and changes no bit of the other answers.
//!
//! One machine, a four-bar with a slider behind it, is written with every combination of effects declared and with
//! different things asked.

use assur::internals::check::Overrides;
use assur::internals::plan::{ForceStep, Level, LoadStep, Plan};
use assur::internals::solve::State;
use assur::internals::source::Source;
use assur::internals::{Compiled, Solved};

/// What the file declares beside the machine and its motion.
#[derive(Clone, Copy, Default)]
struct Declared {
    masses: bool,
    gravity: bool,
    spring: bool,
    friction: bool,
    load: bool,
    part_of_stroke: bool,
}

impl Declared {
    const NOTHING: Self = Self {
        masses: false,
        gravity: false,
        spring: false,
        friction: false,
        load: false,
        part_of_stroke: false,
    };

    /// Every combination.
    fn all() -> impl Iterator<Item = Self> {
        (0_u8..64).map(|bits| Self {
            masses: bits & 1 > 0,
            gravity: bits & 2 > 0,
            spring: bits & 4 > 0,
            friction: bits & 8 > 0,
            load: bits & 16 > 0,
            part_of_stroke: bits & 32 > 0,
        })
    }
}

/// How the crank is driven.
#[derive(Clone, Copy)]
enum Drive {
    Still,
    AtSpeed,
}

fn text(declared: Declared, drive: Drive, find: &str) -> String {
    let on = |is: bool, text: &'static str| if is { text } else { "" };
    let mass = |text: &'static str| on(declared.masses, text);
    let rough = |text: &'static str| on(declared.friction, text);
    let mut lines = vec![
        "mech 1\nmechanism \"Effects\"".to_owned(),
        on(declared.gravity, "gravity 9.81 m/s^2").to_owned(),
        "ground { A (0, 0); D (0.4 m, -0.05 m); Q (0, 0.12 m); line guide through Q along 5 deg }".to_owned(),
        format!(
            "link crank A-B 0.1 m {{ G (0.06 m, 0.01 m){} }}",
            mass("; mass 1 kg at G; inertia 0.002 kg*m^2")
        ),
        format!(
            "link coupler B-C 0.3 m {{ S (0.15 m, 0.02 m){} }}",
            mass("; mass 2 kg at S; inertia 0.01 kg*m^2")
        ),
        "link rocker D-C 0.25 m { E (0.15 m, 0.02 m) }".to_owned(),
        "link rod E-F 0.35 m".to_owned(),
        format!("link ram {{ F (0, 0){} }}", mass("; mass 3 kg at F")),
        format!("revolute A: ground - crank {}", rough("{ radius 10 mm; friction 0.1 }")),
        "revolute B: crank - coupler".to_owned(),
        format!("revolute C: coupler - rocker {}", rough("{ friction_circle 1 mm }")),
        "revolute D: ground - rocker\nrevolute E: rocker - rod\nrevolute F: rod - ram".to_owned(),
        format!("prismatic H: ram.F - ground.guide {}", rough("{ friction 0.12 }")),
        on(
            declared.spring,
            "spring k: ground.Q - rocker.E { stiffness 900 N/m; free_length 80 mm; damping 5 N*s/m }",
        )
        .to_owned(),
        on(declared.load, "force P on ram at F = (-400 N, 20 N)").to_owned(),
        on(declared.part_of_stroke, "torque M on rocker = 30 N*m cw when displacement(H) > 0.3 m").to_owned(),
        match drive {
            Drive::Still => "drive crank = 10 deg .. 370 deg in 9 steps".to_owned(),
            Drive::AtSpeed => "drive crank = 10 deg .. 370 deg in 9 steps at 20 rad/s".to_owned(),
        },
        "assemble C left of B-D, F ahead of E\nbalance torque Mb on crank".to_owned(),
        find.to_owned(),
    ];
    lines.retain(|line| !line.is_empty());
    lines.join("\n") + "\n"
}

fn compiled(text: &str) -> Compiled {
    let source = Source::new("effects.mech", text.to_owned());
    let (compiled, problems) = assur::internals::compile(&source, &Overrides::none());
    assert!(!problems.has_errors(), "{}", assur::internals::diagnose(&source));
    compiled.unwrap_or_else(|| panic!("it compiles:\n{text}"))
}

fn solved(text: &str) -> Solved {
    assur::internals::pipeline::solve(compiled(text)).0.unwrap_or_else(|_| panic!("it is solved:\n{text}"))
}

fn states(solved: &Solved) -> impl Iterator<Item = &State> {
    let outcome = |pose| match pose {
        Ok(solved) => solved,
        Err(error) => panic!("every position is solved: {error:?}"),
    };
    solved.solution.poses.iter().map(move |p| &outcome(p.outcome.as_ref()).state)
}

/// Steps by what they do: motion, masses, other loads, forces, forces with friction.
#[derive(Debug, PartialEq, Eq)]
struct Count {
    motion: usize,
    masses: usize,
    loads: usize,
    forces: usize,
    rubbing: usize,
}

impl Count {
    fn of(plan: &Plan) -> Self {
        let masses = plan.loads.iter().filter(|l| matches!(l, LoadStep::Mass { .. })).count();
        let rubbing = plan.forces.iter().filter(|f| matches!(f, ForceStep::Friction { .. })).count();
        Self {
            motion: plan.motion.len(),
            masses,
            loads: plan.loads.len() - masses,
            forces: plan.forces.len() - rubbing,
            rubbing,
        }
    }
}

/// The steps word by word, with how far motion is followed.
fn steps(plan: &Plan) -> String {
    let Plan { motion, loads, forces, friction, lines, massless, effects, .. } = plan;
    format!("{:?} {motion:?} {loads:?} {forces:?} {friction:?} {lines:?} {massless:?}", effects.level)
}

/// All numbers of the bodies as far as a level goes, and of the forces, as bits; zero has no sign.
fn bits(state: &State, level: Level, forces: bool) -> Vec<u64> {
    let mut numbers = Vec::new();
    for b in &state.motion.bodies {
        numbers.extend([b.p.x, b.p.y, b.u.x, b.u.y]);
        if level >= Level::Velocities {
            numbers.extend([b.v.x, b.v.y, b.omega]);
        }
        if level >= Level::Accelerations {
            numbers.extend([b.a.x, b.a.y, b.alpha]);
        }
    }
    if forces {
        numbers.extend(state.forces.reactions.iter().flat_map(|r| [r.force.x, r.force.y, r.couple]));
        numbers.extend(&state.forces.efforts);
    }
    numbers.iter().map(|x| (x + 0.0).to_bits()).collect()
}

fn same(one: &Solved, other: &Solved, level: Level, forces: bool) {
    assert_eq!(one.solution.poses.len(), other.solution.poses.len());
    for (pose, (x, y)) in states(one).zip(states(other)).enumerate() {
        assert_eq!(bits(x, level, forces), bits(y, level, forces), "pose {}", pose + 1);
    }
}

const LEVELS: [(&str, Level); 3] = [
    ("find position(F)", Level::Positions),
    ("find velocity(F)", Level::Velocities),
    ("find acceleration(F)", Level::Accelerations),
];

#[test]
fn motion_alone_has_the_same_plan_and_bits_whatever_acts() {
    for (find, level) in LEVELS {
        let bare = text(Declared::NOTHING, Drive::AtSpeed, find);
        let plan = steps(&compiled(&bare).plan);
        let answers = solved(&bare);
        for declared in Declared::all() {
            let text = text(declared, Drive::AtSpeed, find);
            let compiled = compiled(&text);
            assert_eq!(compiled.plan.effects.level, level);
            assert_eq!(steps(&compiled.plan), plan, "{text}");
            assert_eq!(compiled.plan.effects.names(), Vec::<&str>::new());
            same(&solved(&text), &answers, level, false);
        }
    }
}

#[test]
fn positions_are_the_same_however_far_motion_is_followed() {
    let answers = LEVELS.map(|(find, _)| solved(&text(Declared::NOTHING, Drive::AtSpeed, find)));
    let still = solved(&text(Declared::NOTHING, Drive::Still, LEVELS[0].0));
    let with_forces =
        solved(&text(Declared { masses: true, ..Declared::NOTHING }, Drive::AtSpeed, "find reactions"));
    same(&answers[0], &still, Level::Positions, false);
    same(&answers[0], &answers[1], Level::Positions, false);
    same(&answers[1], &answers[2], Level::Velocities, false);
    same(&answers[2], &with_forces, Level::Accelerations, false);
}

#[test]
fn every_effect_adds_its_own_steps_and_no_others() {
    for drive in [Drive::Still, Drive::AtSpeed] {
        for declared in Declared::all() {
            let text = text(declared, drive, "find Mb");
            let plan = compiled(&text).plan;
            let moving = matches!(drive, Drive::AtSpeed);
            let heavy = declared.masses && (declared.gravity || moving);
            let rubbing = if declared.friction && moving { 3 } else { 0 };
            let wanted = Count {
                motion: 3,
                masses: if heavy { 3 } else { 0 },
                loads: [declared.spring, declared.load, declared.part_of_stroke]
                    .iter()
                    .filter(|is| **is)
                    .count(),
                forces: 3 - rubbing,
                rubbing,
            };
            assert_eq!(Count::of(&plan), wanted, "{text}");
            let level = match (moving, declared.masses, declared.friction || declared.spring) {
                (true, true, _) => Level::Accelerations,
                (true, false, true) => Level::Velocities,
                _ => Level::Positions,
            };
            assert_eq!(plan.effects.level, level, "{text}");
        }
    }
}

#[test]
fn what_is_declared_without_its_cause_changes_no_bit_of_the_forces() {
    let find = "find Mb, reactions";
    let loaded = Declared { load: true, ..Declared::NOTHING };
    let pairs = [
        // weights need masses
        (loaded, Declared { gravity: true, ..loaded }, Drive::AtSpeed),
        // inertia needs a speed
        (loaded, Declared { masses: true, ..loaded }, Drive::Still),
        // friction needs a motion
        (loaded, Declared { friction: true, ..loaded }, Drive::Still),
    ];
    for (without, with, drive) in pairs {
        let [without, with] = [without, with].map(|declared| text(declared, drive, find));
        assert_eq!(steps(&compiled(&without).plan), steps(&compiled(&with).plan), "{with}");
        same(&solved(&without), &solved(&with), Level::Accelerations, true);
    }
}

#[test]
fn effects_of_no_strength_change_no_bit_of_the_forces() {
    let find = "find Mb, reactions";
    let all = Declared { masses: true, gravity: true, load: true, ..Declared::NOTHING };
    let answers = solved(&text(all, Drive::AtSpeed, find));
    let with = |change: Declared, from: &str, to: &str| {
        let text = text(change, Drive::AtSpeed, find);
        assert!(text.contains(from), "{text}");
        solved(&text.replace(from, to))
    };
    // a force below all rounding: a spring without stiffness is refused
    let spring = Declared { spring: true, ..all };
    let slack = with(spring, "900 N/m; free_length 80 mm; damping 5 N*s/m", "1e-300 N/m; free_length 80 mm");
    same(&answers, &slack, Level::Accelerations, true);
    let smooth = text(Declared { friction: true, ..all }, Drive::AtSpeed, find)
        .replace("friction 0.1 ", "friction 0 ")
        .replace("friction_circle 1 mm", "friction_circle 0 mm")
        .replace("friction 0.12 ", "friction 0 ");
    same(&answers, &solved(&smooth), Level::Accelerations, true);
    let never =
        with(Declared { part_of_stroke: true, ..all }, "displacement(H) > 0.3 m", "displacement(H) > 3 m");
    same(&answers, &never, Level::Accelerations, true);
    let null = with(Declared { part_of_stroke: true, ..all }, "30 N*m cw when", "0 N*m cw when");
    same(&answers, &null, Level::Accelerations, true);
}

#[test]
fn a_definition_that_nobody_asks_for_calls_for_nothing() {
    let bare = compiled(&text(Declared::NOTHING, Drive::AtSpeed, "find position(F)")).plan;
    let defined =
        text(Declared::NOTHING, Drive::AtSpeed, "let v = velocity(F).x\nlet M = Mb\nfind position(F)");
    assert_eq!(steps(&compiled(&defined).plan), steps(&bare));
}

#[test]
fn a_contact_adds_its_own_group_and_changes_no_bit_of_the_others() {
    let find = "find acceleration(F)";
    let without = text(Declared::NOTHING, Drive::AtSpeed, find);
    let with = without
        .replace("G (0.06 m, 0.01 m) }", "G (0.06 m, 0.01 m); circle disc centre G radius 30 mm }")
        .replace("Q (0, 0.12 m);", "Q (0, 0.12 m); L (-0.2 m, 0);")
        + "link lever { L (0, 0); T (0.2 m, 0); line flat through L along 0 deg }\n\
           revolute L: ground - lever\ncontact K: crank.disc - lever.flat\nassemble lever.T near (0, 40 mm)\n";
    let (bare, plan) = (compiled(&without).plan, compiled(&with).plan);
    assert_eq!(plan.motion.len(), bare.motion.len() + 1);
    assert_eq!((plan.loads.len(), plan.forces.len()), (0, 0));
    let (bare, answers) = (solved(&without), solved(&with));
    for (x, y) in states(&bare).zip(states(&answers)) {
        let known = bits(x, Level::Accelerations, false);
        let others: Vec<_> = bits(y, Level::Accelerations, false).into_iter().take(known.len()).collect();
        assert_eq!(others, known);
    }
}

/// A load that depends on the motion asks for it, whatever else the file asks for.
#[test]
fn loads_are_computed_with_the_velocities_they_depend_on() {
    let file = |find: &str| {
        format!(
            "ground {{ A (0, 0) }}
link bar A-B 200 mm
revolute A: ground - bar
drive bar = 30 deg at 10 rad/s
force R on bar at B = 14 N against motion
torque T on bar = 5 N*m against motion
torque D on bar = -0.2 N*m*s*omega(bar)
brake K on bar {{ capacity 3 N*m }}
let twice = 2*T
find {find}
"
        )
    };
    for (find, wanted) in
        [("T", -5.0), ("D", -2.0), ("K", -3.0), ("twice", -10.0), ("abs(K)", 3.0), ("mag(R)", 14.0)]
    {
        let solution = assur::solve(file(find)).expect("it is solved");
        let found = solution.poses()[0][find].number().expect("a number");
        assert!((found - wanted).abs() < 1e-12, "{find} = {found}, not {wanted}");
    }
}
