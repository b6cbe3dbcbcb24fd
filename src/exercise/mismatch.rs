//! Messages about expectations that are not met: one per `expect`.

use super::error::ExpectError;
use super::expect::Outcome;
use assur_model::model::Value;

/// Errors of the answers: one per `expect`, for any number of poses.
#[must_use]
pub fn mismatches(outcomes: &[Outcome]) -> Vec<ExpectError> {
    let of_one = outcomes.chunk_by(|a, b| a.span == b.span);
    of_one.filter_map(|all| Some(Failed { all, worst: worst(all)? }.error())).collect()
}

/// The same in one error, for a sweep that does not close everywhere: all of them have that cause.
#[must_use]
pub fn in_one(failed: Vec<ExpectError>) -> Vec<ExpectError> {
    let more = failed.len().saturating_sub(1);
    failed.first().map(|first| first.and_more(more)).into_iter().collect()
}

/// The answer that is not met and differs most.
fn worst(all: &[Outcome]) -> Option<&Outcome> {
    let off = |o: &&Outcome| o.difference().magnitude();
    all.iter().filter(|o| !o.passed).reduce(|a, b| if off(&b) > off(&a) { b } else { a })
}

/// The outcomes of an `expect`, one per pose, of which some are not met.
struct Failed<'a> {
    all: &'a [Outcome],
    worst: &'a Outcome,
}

impl Failed<'_> {
    fn error(&self) -> ExpectError {
        let Outcome { text, display, got, place: at, span, .. } = self.worst;
        let span = *span;
        if *got == Value::Bool(false) {
            let message = format!("expected {text}{at}, but it is false");
            return ExpectError::Mismatch { message, difference: "false".to_owned(), span, help: None };
        }
        let off = self.worst.difference();
        let digits = digits_to_tell(self.worst.expected.magnitude(), off.magnitude());
        let got = display.text(*got, digits);
        // a comparison's own text has its bound
        let what = match self.worst.comparison {
            Some(_) => text.clone(),
            None => format!("{text} {}", self.worst.expectation(digits)),
        };
        let failed = self.all.iter().filter(|o| !o.passed);
        let message = match failed.clone().count() {
            1 => format!("expected {what}{at}, got {got}"),
            count => {
                let all = self.all.len();
                format!(
                    "{count} of {all} poses differ, the greatest difference is{at}: expected {what}, got {got}"
                )
            }
        };
        let difference = match self.worst.within {
            Some(within) => format!(
                "off by {}, allowed {}",
                display.text(Value::Scalar(off.magnitude()), 3),
                display.text(Value::Scalar(within), 3)
            ),
            None => format!("off by {}", display.text(Value::Scalar(off.magnitude()), 3)),
        };
        let help = slip(self.worst).filter(|help| failed.clone().all(|o| slip(o).as_ref() == Some(help)));
        ExpectError::Mismatch { message, difference, span, help }
    }
}

/// Digits that show where two numbers part, with two more: at least 6.
fn digits_to_tell(value: f64, difference: f64) -> usize {
    let parts_after = libm::log10(value / difference).ceil();
    if parts_after.is_finite() && parts_after > 4.0 {
        (parts_after as usize).saturating_add(2).min(17)
    } else {
        6
    }
}

/// The usual slips: a sign, a prefix, degrees for radians.
fn slip(outcome: &Outcome) -> Option<String> {
    let (Value::Scalar(got), Value::Scalar(expected), Some(within)) =
        (outcome.got, outcome.expected, outcome.within)
    else {
        return None;
    };
    if expected == 0.0 {
        return None;
    }
    // half a graphical solution's accuracy
    let alike = |factor: f64| {
        let allowed = (within * factor.abs()).max(0.02 * (expected * factor).abs());
        (got - expected * factor).abs() <= allowed
    };
    let degree = std::f64::consts::PI / 180.0;
    if alike(-1.0) {
        return Some(
            "check the sign: the positive direction, and the link on which the force acts".to_owned(),
        );
    }
    for factor in [1e3, 1e-3, 1e6, 1e-6] {
        if alike(factor) || alike(-factor) {
            return Some("check the units: the two differ by a power of 1000".to_owned());
        }
    }
    if alike(degree) || alike(1.0 / degree) {
        return Some("check the units: the two differ by 180/pi, degrees against radians".to_owned());
    }
    None
}
