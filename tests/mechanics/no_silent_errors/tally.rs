//! What came of many cases.

use super::claim::{KINDS, UNWARNED, judge};
use super::models;
use crate::support::run::Run;
use assur::internals::solve::{Cause, Failure};
use std::collections::BTreeMap;

/// Counts, the worst of each kind, and what was wrong.
#[derive(Debug, Default)]
pub struct Tally {
    cases: u64,
    pub judged: u64,
    pub warned: u64,
    pub refused: u64,
    unjudged_forces: u64,
    /// Why there was no answer.
    reasons: BTreeMap<&'static str, u64>,
    /// The worst error over its claim: 10^−digits, and ε/σ^k.
    worst: [[(f64, u64); 2]; 4],
    wrong: Vec<String>,
}

impl Tally {
    pub fn case(&mut self, seed: u64) {
        self.cases += 1;
        let hard = models::model(seed);
        let run = match Run::new(&hard.mechanism) {
            Ok(run) => run,
            Err(e) if hard.easy => return self.wrong.push(format!("seed {seed}: {e:.300}")),
            Err(_) => {
                self.refused += 1;
                *self.reasons.entry("not determined").or_insert(0) += 1;
                return;
            }
        };
        let solved = match &run.solution {
            Ok(solution) => match solution.poses.first().map(|p| &p.outcome) {
                Some(Ok(solved)) => solved,
                Some(Err(e)) => return self.refused(seed, hard.easy, e),
                None => return self.wrong.push(format!("seed {seed}: no pose")),
            },
            Err(errors) => return self.refused(seed, hard.easy, &errors[0]),
        };
        match judge(&run, solved) {
            Err(what) => {
                // what claims no digit may be anything
                if super::claim::warned(&run) != Some(0) {
                    self.wrong.push(format!("seed {seed}: {what}"));
                }
            }
            Ok(judged) => {
                self.judged += 1;
                self.warned += u64::from(judged.warned.is_some());
                self.unjudged_forces += u64::from(judged.errors[3].is_none());
                let digits = judged.warned.map_or(UNWARNED, f64::from);
                for (k, error) in judged.errors.into_iter().enumerate() {
                    let Some(error) = error else { continue };
                    let shares = [
                        error * libm::exp10(digits),
                        error * judged.condition.powi(KINDS[k].1) / f64::EPSILON,
                    ];
                    for (worst, share) in self.worst[k].iter_mut().zip(shares) {
                        if share > worst.0 || share.is_nan() {
                            *worst = (share, seed);
                        }
                    }
                    if (error.is_nan() || shares[0] > 1.0) && digits > 0.0 {
                        self.wrong.push(format!(
                            "seed {seed}: {} are off by {error:.1e}, but {digits} digits are claimed, condition {:.1e}",
                            KINDS[k].0, judged.condition
                        ));
                    }
                }
            }
        }
    }

    fn refused(&mut self, seed: u64, easy: bool, why: &Failure) {
        self.refused += 1;
        let reason = match why.cause {
            Cause::DoesNotClose { .. } => "does not close",
            Cause::NotFound { .. } => "not found",
            Cause::Ambiguous { .. } => "ambiguous",
            Cause::Dead { .. } => "dead position",
            Cause::CannotHold { .. } => "the effort cannot hold it",
            Cause::Lost(_) => "lost in rounding",
            _ => "another",
        };
        *self.reasons.entry(reason).or_insert(0) += 1;
        if easy && !matches!(why.cause, Cause::CannotHold { .. }) {
            self.wrong.push(format!("seed {seed}: there is an answer, but: {why:.200?}"));
        }
    }

    pub fn merge(&mut self, o: Self) {
        self.cases += o.cases;
        self.judged += o.judged;
        self.warned += o.warned;
        self.refused += o.refused;
        self.unjudged_forces += o.unjudged_forces;
        for (reason, n) in o.reasons {
            *self.reasons.entry(reason).or_insert(0) += n;
        }
        for (mine, theirs) in self.worst.iter_mut().flatten().zip(o.worst.into_iter().flatten()) {
            if theirs.0 > mine.0 {
                *mine = theirs;
            }
        }
        self.wrong.extend(o.wrong);
    }

    pub fn failures(&self) -> &[String] {
        &self.wrong
    }

    pub fn told(&self) -> String {
        let mut out = format!(
            "{} cases: {} judged ({} warned of, forces of {} not judged), {} without an answer {:?}\n",
            self.cases, self.judged, self.warned, self.unjudged_forces, self.refused, self.reasons
        );
        for ((kind, power), [digits, sigma]) in KINDS.iter().zip(&self.worst) {
            out += &format!(
                "{kind:14} worst {:.1e} of 10^-digits (seed {}), {:.1e} of eps/sigma^{power} (seed {})\n",
                digits.0, digits.1, sigma.0, sigma.1
            );
        }
        out
    }
}
