//! Every position of every example against the reference of 30 digits, which is solved from the equations of all bodies at
//! once: what `f64` and its closed forms lose stays below the bound of docs/stability.md.

use assur::check::Overrides;
use assur::math::{Double, Scalar, V2, Vec2};
use assur::plan::Level;
use assur::solve::{BodyState, Reference, Scene, Solution, Solved};
use assur::source::Source;
use assur::structure::JointKind;
use std::path::{Path, PathBuf};

fn files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, out);
        } else if path.extension().is_some_and(|e| e == "mech") {
            out.push(path);
        }
    }
}

fn off(got: Vec2, want: V2<Double>) -> f64 {
    (V2::of(got) - want).norm().high
}

#[derive(Default)]
struct Worst {
    poses: usize,
    missing: Vec<String>,
    lines: Vec<String>,
}

fn judge(name: &str, scene: &Scene<'_>, solution: &Solution, solved: &Solved, worst: &mut Worst) {
    worst.poses += 1;
    let Some(exact) = solution.reference(scene, solved) else {
        worst.missing.push(format!("{name}: condition {:.1e}", solved.condition));
        return;
    };
    let state = &solved.state;
    let size = exact.bodies.iter().map(|b| b.p.norm().high).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let (mut p, mut v, mut a) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut vmax, mut amax) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE);
    for (got, want) in state.bodies.iter().zip(&exact.bodies) {
        p = p.max(off(got.p, want.p) / size).max(off(got.u, want.u));
        v = v.max(off(got.v, want.v) / size).max((want.omega - Double::of(got.omega)).high.abs());
        a = a.max(off(got.a, want.a) / size).max((want.alpha - Double::of(got.alpha)).high.abs());
        vmax = vmax.max(want.v.norm().high / size).max(want.omega.high.abs());
        amax = amax.max(want.a.norm().high / size).max(want.alpha.high.abs()).max(want.omega.high.powi(2));
    }
    let (v, a) = (v / vmax, a / amax);
    let mut f = 0.0_f64;
    let mut fmax = exact.applied.iter().map(|w| w.force.norm().high).fold(f64::MIN_POSITIVE, f64::max);
    for (i, (got, want)) in state.reactions.iter().zip(&exact.reactions).enumerate() {
        fmax = fmax.max(want.force.norm().high);
        f = f.max(off(got.force, want.force));
        let joint = scene.plan.reactions[i].joint;
        let free =
            matches!(scene.structure.replaced.joint(joint).kind, JointKind::Prismatic { in_chain: true, .. });
        if !free {
            f = f.max((want.couple - Double::of(got.couple)).high.abs() / size);
            fmax = fmax.max(want.couple.high.abs() / size);
        }
    }
    let f = f / fmax;
    let s = solved.condition;
    let c = (p * s).max(v * s * s).max(a * s * s * s).max(f * s * s) / f64::EPSILON;
    worst.lines.push(format!(
        "{c:10.1} {name} s={s:.1e} p={p:.1e} v={v:.1e} a={a:.1e} f={f:.1e} closure {:.0e} eq {:.0e}",
        exact.closure, exact.equilibrium
    ));
}

#[test]
fn every_position_of_every_example() {
    let mut paths = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples"), &mut paths);
    paths.sort();
    let mut worst = Worst::default();
    for path in paths {
        let name = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).unwrap().display().to_string();
        let source = Source::new(&name, std::fs::read_to_string(&path).expect("a file"));
        let (solved, _) = assur::solve_source(&source, &Overrides::none());
        let Some(solved) = solved else {
            println!("none: {name}");
            continue;
        };
        for pose in &solved.solution.poses {
            if let Ok(at) = &pose.outcome {
                judge(
                    &format!("{name} {}", pose.name),
                    &solved.compiled.scene(),
                    &solved.solution,
                    at,
                    &mut worst,
                );
            }
        }
    }
    worst.lines.sort();
    for l in worst.lines.iter().rev().take(60) {
        println!("{l}");
    }
    println!("{} poses, {} missing", worst.poses, worst.missing.len());
    for m in &worst.missing {
        println!("missing {m}");
    }
}
