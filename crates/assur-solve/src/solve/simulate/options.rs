//! How a motion is integrated, beside what its file says.

use super::report::Method;
use crate::position::State;

/// Told each instant that is reached, s, and the last one: `false` ends the motion there.
pub type Progress<'w> = dyn Fn(f64, f64) -> bool + Sync + 'w;

/// How a motion is integrated, beside what its file says.
#[derive(Clone, Copy, Default)]
pub struct IntegrationOptions<'c> {
    /// [`Method::Radau`] from the first instant on, or [`Method::Dop853`] also where the method of energy would do; without it, the
    /// solver's own choice.
    pub method: Option<Method>,
    /// Steps of the run at least: of runs that nothing else tells apart.
    pub steps: f64,
    /// One run alone, at this tolerance: of a motion whose accuracy is known.
    pub alone: Option<f64>,
    /// Functions over the run are not taken, and events that change nothing are not looked for.
    pub bare: bool,
    /// Functions over the run are drawn.
    pub drawn: Option<Drawn<'c>>,
    /// Told how far it is, in each of the runs that it takes.
    pub watch: Option<&'c Progress<'c>>,
}

/// How functions are found that are drawn. Events that change nothing are known then, and not looked for.
#[derive(Clone, Copy)]
pub struct Drawn<'c> {
    /// What series may leave off, of the greatest value.
    pub smooth: f64,
    /// What they may leave off of each function, however small it is.
    pub roundings: &'c [f64],
    /// The position at the first instant, where it is known.
    pub start: Option<&'c State>,
}

impl IntegrationOptions<'_> {
    /// Whether the run goes on from an instant, s.
    pub(crate) fn goes_on(&self, reached: f64, last: f64) -> bool {
        self.watch.is_none_or(|watch| watch(reached, last))
    }
}
