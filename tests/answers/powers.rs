//! `find powers` in every example with a motion: what all forces put in adds up to nothing.

use assur::internals::check::Overrides;
use assur::internals::model::{DriveTarget, FindKind, PairKind};
use assur::internals::source::Source;
use std::path::{Path, PathBuf};

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "mech") {
            found.push(path);
        }
    }
    found
}

#[test]
fn all_powers_add_up_to_nothing() {
    let (mut looked, mut poses) = (0, 0);
    for path in files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")) {
        let text = std::fs::read_to_string(&path).expect("a text") + "\nfind powers\n";
        let source = Source::new("powers.mech", &text);
        let (Some(solved), _) = assur::internals::solve_source(&source, &Overrides::none()) else { continue };
        let model = solved.compiled.model();
        let mechanism = model.mechanism;
        // losses of trains are no power of their own, and outer links stand for the rest of a machine
        let train = mechanism.pairs.iter().any(|p| matches!(p.kind, PairKind::Transmission(_)));
        let outer = mechanism.drives.iter().any(|d| matches!(d.target, DriveTarget::Point(..)));
        let Some((first, last)) = mechanism.powers.filter(|_| !train && !outer) else { continue };
        looked += 1;
        let mut all = Vec::new();
        for pose in &solved.solution.poses {
            let Some(at) = pose.outcome.as_ref().ok().filter(|at| !at.state.forces.locked) else { continue };
            let view = solved.solution.view(&model, at);
            let powers: Vec<f64> = mechanism.finds[first..last]
                .iter()
                .filter_map(|find| match &find.kind {
                    FindKind::Value { expr, .. } => Some(view.scalar(expr)),
                    FindKind::Reactions | FindKind::Table(_) => None,
                })
                .collect();
            all.push((pose.name.clone(), powers));
        }
        // at dead positions every power is rounding
        let greatest = all.iter().flat_map(|(_, p)| p).fold(0.0, |m, x| f64::max(m, x.abs()));
        for (pose, powers) in &all {
            let sum: f64 = powers.iter().sum();
            let told = || format!("{} at pose {pose}: {sum:e} of {greatest:e}, {powers:?}", path.display());
            assert!(sum.abs() <= 1e-12 * greatest.max(1.0), "{}", told());
        }
        poses += all.len();
    }
    assert!(looked > 40 && poses > 400, "{looked} files, {poses} poses");
}
