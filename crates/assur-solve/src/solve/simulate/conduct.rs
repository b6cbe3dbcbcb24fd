//! How a motion is integrated, beside what its file says.

use super::report::Method;

/// Told each instant that is reached, s, and the last one: `false` ends the motion there.
pub type Watch<'w> = dyn Fn(f64, f64) -> bool + Sync + 'w;

/// How a motion is integrated, beside what its file says.
#[derive(Clone, Copy, Default)]
pub struct Conduct<'c> {
    /// [`Method::Radau`] from the first instant on, or [`Method::Dop853`] also where the method of energy would do; without it, the
    /// solver's own choice.
    pub method: Option<Method>,
    /// Steps of the run at least: of runs that nothing else tells apart.
    pub steps: f64,
    /// One run alone, at this tolerance: of a motion whose accuracy is known.
    pub alone: Option<f64>,
    /// Of extremes that differ by no more than this part of the greatest value the first counts.
    pub same: f64,
    /// Told how far it is, in each of the runs that it takes.
    pub watch: Option<&'c Watch<'c>>,
}

impl Conduct<'_> {
    /// Whether the run goes on from an instant, s.
    pub(crate) fn goes_on(&self, reached: f64, last: f64) -> bool {
        self.watch.is_none_or(|watch| watch(reached, last))
    }
}
