//! A logarithmic axis.

/// A logarithmic axis and where it lies.
pub(super) struct Axis {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

impl Axis {
    /// Over positive numbers, with something to spare, more of it at the small ones.
    pub(super) fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Option<Self> {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in values.filter(|x| *x > 0.0).map(libm::log10) {
            (least, greatest) = (least.min(x), greatest.max(x));
        }
        let spare = 0.15_f64.max(0.08 * (greatest - least));
        (least <= greatest).then_some(Self { from: least - 2.5 * spare, to: greatest + spare, start, end })
    }

    pub(super) fn place(&self, x: f64) -> f64 {
        self.start + (libm::log10(x) - self.from) / (self.to - self.from) * (self.end - self.start)
    }

    /// Powers of ten on the axis, and about how many at most.
    pub(super) fn powers(&self, most: f64) -> Vec<f64> {
        let step = ((self.to - self.from) / most).ceil().max(1.0);
        let mut at = (self.from / step).ceil() * step;
        let mut all = Vec::new();
        while at <= self.to {
            all.push(at);
            at += step;
        }
        all
    }

    /// 1, 2, 5, 10, … on the axis; powers of ten alone where it is long.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let times: &[f64] = if self.to - self.from > 3.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let mut all = Vec::new();
        let mut power = self.from.floor();
        while power <= self.to {
            let ten = libm::pow(10.0, power);
            all.extend(times.iter().map(|t| t * ten).filter(|x| {
                let at = libm::log10(*x);
                at >= self.from && at <= self.to
            }));
            power += 1.0;
        }
        all
    }
}
