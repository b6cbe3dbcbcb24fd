//! Random mechanisms against an independent path: constraints of all pairs for the motion, the equations of Newton and
//! Euler of all links for the forces.

#[path = "properties/compare.rs"]
mod compare;
#[path = "properties/draft.rs"]
mod draft;
#[path = "properties/equilibrium.rs"]
mod equilibrium;
#[path = "properties/generate.rs"]
mod generate;
#[path = "properties/groups.rs"]
mod groups;
#[path = "properties/jet.rs"]
mod jet;
#[path = "properties/loads.rs"]
mod loads;
#[path = "properties/random.rs"]
mod random;
#[path = "properties/reference.rs"]
mod reference;
#[path = "properties/run.rs"]
mod run;

use compare::{Worst, compare};
use reference::Reference;

const MECHANISMS: u64 = 2500;

#[test]
fn random_mechanisms_agree_with_newton_and_euler() {
    let mut worst = Worst::default();
    let mut failures = Vec::new();
    let one = std::env::var("ASSUR_SEED").ok().and_then(|s| s.parse().ok());
    for seed in one.map_or(0..MECHANISMS, |s| s..s + 1) {
        let draft = generate::mechanism(seed);
        let Some(reference) = Reference::new(&draft.mechanism, &draft.frames) else {
            failures.push((draft.frames.len(), format!("{seed}: singular reference {:?}", draft.made)));
            continue;
        };
        let run = match run::Run::new(&draft.mechanism) {
            Ok(run) => run,
            Err(e) => {
                failures.push((draft.frames.len(), format!("{seed}: {e:.300}")));
                continue;
            }
        };
        if one.is_some() {
            println!("{:#?}", draft.mechanism);
            println!("{:?}", draft.frames);
            println!("{:#?}", run.structure);
        }
        match compare(&draft, &reference, &run) {
            Ok(w) => {
                failures
                    .extend(w.failures().into_iter().map(|f| (draft.frames.len(), format!("{seed}: {f}"))));
                worst.merge(w);
            }
            Err(e) => failures.push((draft.frames.len(), format!("{seed}: {e:.300}"))),
        }
    }
    for e in &worst.errors {
        println!("{:24} {:.2e} {}", e.0, e.1, e.2);
    }
    println!("{} failures", failures.len());
    failures.sort_by_key(|f| f.0);
    for (_, f) in failures.iter().take(60) {
        println!("{f}");
    }
    assert!(failures.is_empty());
}
