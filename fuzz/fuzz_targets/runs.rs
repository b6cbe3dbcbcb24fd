//! Text → Solution of motions under loads: a motion ends where it is told to, and what it did until then is a solution.
//!
//! `fuzz/run.sh 10000000 86400 runs`

#![no_main]

use assur::internals::check::Overrides;
use assur::internals::compile;
use assur::internals::diagnostic::{Style, render};
use assur::internals::pipeline::solve_conducted;
use assur::internals::solve::IntegrationOptions;
use assur::internals::source::Source;
use libfuzzer_sys::fuzz_target;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Steps of all runs: more take their time, and show nothing new.
const MOST: usize = 4_000;
/// Runs that begin after that: each is told at its first step.
const RUNS: usize = 4;

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.mech", text);
    let (compiled, problems) = compile(&source, &Overrides::none());
    let Some(compiled) = compiled.filter(|c| !problems.has_errors() && c.mechanism.simulation.is_some()) else {
        return;
    };
    // instants take their time in `solve`
    let simulation = compiled.mechanism.simulation.as_ref();
    if simulation.and_then(|s| s.steps).is_some_and(|steps| steps > 2_000) || compiled.mechanism.links.len() > 30 {
        return;
    }
    let steps = AtomicUsize::new(0);
    let watch = |_: f64, _: f64| steps.fetch_add(1, Ordering::Relaxed) < MOST;
    let (solved, problems) = solve_conducted(compiled, None, &IntegrationOptions { watch: Some(&watch), ..IntegrationOptions::default() });
    assert!(steps.load(Ordering::Relaxed) <= MOST + RUNS, "it goes on");
    if let Ok(solved) = solved {
        for pose in &solved.solution.poses {
            if let Ok(found) = &pose.outcome {
                assert!(found.state.motion.time.is_finite() && found.condition >= 0.0, "{}", pose.name);
            }
        }
    }
    let _ = render(&problems, &source, Style::PLAIN);
});
