//! A function given by a table of points: straight lines, monotone cubics or a cubic spline between them.
//!
//! On each interval of length h, with Δ = (y₁ − y₀)/h and the slopes m₀, m₁ at its ends, the cubic is Hermite's:
//! y = y₀ + m₀ t + c t² + d t³, c = (3 Δ − 2 m₀ − m₁)/h, d = (m₀ + m₁ − 2 Δ)/h².
//!
//! Monotone slopes: F. N. Fritsch, J. Butland, A method for constructing local monotone piecewise cubic interpolants,
//! SIAM J. Sci. Stat. Comput. 5 (1984), which keep the condition of F. N. Fritsch, R. E. Carlson, Monotone piecewise
//! cubic interpolation, SIAM J. Numer. Anal. 17 (1980): no extreme between two points, none beyond them.
//!
//! Slopes of the spline: equal second derivatives where intervals meet; the ends are clamped (slope zero) or meet again.

/// How values between the points are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Between {
    /// Monotone cubics: continuous slope.
    #[default]
    Monotone,
    Straight,
    /// A cubic spline: continuous second derivative.
    Spline,
}

/// What holds beyond the first and the last point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beyond {
    /// There is no value.
    #[default]
    Nothing,
    /// The value at the end.
    Held,
    /// The table begins again: its last point is its first.
    Repeated,
}

/// What a table must have to be a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFault {
    /// Fewer than two points.
    Short,
    /// The argument of this point is not above that of the one before.
    Order(usize),
    /// A number is not finite, or its slopes are not.
    TooLarge,
    /// The table is to begin again, and its last value is not its first.
    Ends,
}

/// A function given by a table of points.
#[derive(Clone, Debug, PartialEq)]
pub struct TableFunction {
    x: Vec<f64>,
    y: Vec<f64>,
    slopes: Vec<f64>,
    between: Between,
    beyond: Beyond,
}

/// A part of a function on which it is smooth: an interval, or what holds beyond an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The interval counted from 1; 0 before the first point, as many as there are points behind the last.
    place: usize,
    /// Where the table begins again: by how much its arguments are shifted.
    shift: f64,
}

/// Rounding of an argument at an end, over the length of the table.
const AT_END: f64 = 1e-9;

impl TableFunction {
    /// The function through points with rising arguments.
    ///
    /// # Errors
    /// What is wrong with the points.
    pub fn new(points: &[(f64, f64)], between: Between, beyond: Beyond) -> Result<Self, TableFault> {
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        if x.len() < 2 {
            return Err(TableFault::Short);
        }
        if let Some(i) = (1..x.len()).find(|&i| x[i] <= x[i - 1]) {
            return Err(TableFault::Order(i));
        }
        if beyond == Beyond::Repeated && y.first() != y.last() {
            return Err(TableFault::Ends);
        }
        let repeated = beyond == Beyond::Repeated;
        let slopes = match between {
            Between::Straight => vec![0.0; x.len()],
            Between::Monotone => monotone(&x, &y, repeated),
            Between::Spline => spline(&x, &y, repeated),
        };
        let finite = x.iter().chain(&y).chain(&slopes).all(|v| v.is_finite());
        if finite { Ok(Self { x, y, slopes, between, beyond }) } else { Err(TableFault::TooLarge) }
    }

    /// The least and the greatest argument of the table.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        (self.x.first().copied().unwrap_or(f64::NAN), self.x.last().copied().unwrap_or(f64::NAN))
    }

    /// The arguments of the points.
    #[must_use]
    pub fn arguments(&self) -> &[f64] {
        &self.x
    }

    /// Calls `visit` on the points that an argument passes on its way, or reaches at its end, in the order of the way.
    pub fn points_between(&self, from: f64, to: f64, mut visit: impl FnMut(f64)) {
        let (rises, (first, last)) = (to > from, self.range());
        let (low, high) = if rises { (from, to) } else { (to, from) };
        // the last point of a table that begins again is its first
        let (points, period) = match self.period() {
            Some(period) => (&self.x[..self.x.len() - 1], period),
            None => (&self.x[..], 0.0),
        };
        let turn = |x: f64| if period > 0.0 { ((x - first) / (last - first)).floor() } else { 0.0 };
        let (mut turns, end) = if rises { (turn(low), turn(high)) } else { (turn(high), turn(low)) };
        loop {
            let shift = turns * period;
            let inside = |&&x: &&f64| {
                if rises {
                    low < x + shift && x + shift <= high
                } else {
                    low <= x + shift && x + shift < high
                }
            };
            let begin = points.partition_point(|x| x + shift < low);
            let behind = points.partition_point(|x| x + shift <= high);
            let passed = points[begin..behind].iter().filter(inside).map(|x| x + shift);
            if rises {
                passed.for_each(&mut visit)
            } else {
                passed.rev().for_each(&mut visit)
            }
            if turns == end || !turns.is_finite() {
                return;
            }
            turns += if rises { 1.0 } else { -1.0 };
        }
    }

    /// Whether there is a value at this argument.
    #[must_use]
    pub fn covers(&self, x: f64) -> bool {
        let (first, last) = self.range();
        let slack = AT_END * (last - first);
        x.is_finite() && (self.beyond != Beyond::Nothing || (first - slack <= x && x <= last + slack))
    }

    /// The value; not a number where there is none.
    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        self.derivatives(x)[0]
    }

    /// The value and three derivatives; at a point those of the interval behind it.
    #[must_use]
    pub fn derivatives(&self, x: f64) -> [f64; 4] {
        self.piece(x).map_or([f64::NAN; 4], |piece| self.derivatives_on(piece, x))
    }

    /// The piece on which an argument lies; a point belongs to the interval behind it.
    #[must_use]
    pub fn piece(&self, x: f64) -> Option<Piece> {
        if !self.covers(x) {
            return None;
        }
        let (first, last) = self.range();
        let (mut shift, mut inside) = (0.0, x);
        match self.beyond {
            Beyond::Repeated => {
                shift = ((x - first) / (last - first)).floor() * (last - first);
                inside = x - shift;
            }
            Beyond::Held if x < first => return Some(Piece { place: 0, shift }),
            Beyond::Held if x > last => return Some(Piece { place: self.x.len(), shift }),
            Beyond::Held | Beyond::Nothing => {}
        }
        let inside = inside.clamp(first, last);
        let place = self.x.partition_point(|&at| at <= inside).clamp(1, self.x.len() - 1);
        Some(Piece { place, shift })
    }

    /// The value and three derivatives of the function that holds on a piece, also beside it; not a number where the table
    /// has none.
    #[must_use]
    pub fn derivatives_on(&self, piece: Piece, x: f64) -> [f64; 4] {
        if !self.covers(x) {
            return [f64::NAN; 4];
        }
        if piece.place == 0 || piece.place == self.x.len() {
            return [self.end(piece.place == 0), 0.0, 0.0, 0.0];
        }
        let (first, last) = self.range();
        let inside = if self.beyond == Beyond::Nothing { x.clamp(first, last) } else { x - piece.shift };
        self.on(piece.place - 1, inside)
    }

    /// Where a piece begins and ends; without bound where nothing follows.
    #[must_use]
    pub fn bounds(&self, piece: Piece) -> (f64, f64) {
        let at = |place: usize| self.x.get(place).map(|x| x + piece.shift);
        let (mut from, mut to) = (piece.place.checked_sub(1).and_then(at), at(piece.place));
        if self.beyond == Beyond::Nothing {
            from = from.filter(|_| piece.place > 1);
            to = to.filter(|_| piece.place + 1 < self.x.len());
        }
        (from.unwrap_or(f64::NEG_INFINITY), to.unwrap_or(f64::INFINITY))
    }

    /// The piece that follows at the end, or that goes before at the begin.
    #[must_use]
    pub fn beside(&self, piece: Piece, behind: bool) -> Piece {
        let (first, last) = self.range();
        let Piece { place, shift } = piece;
        let intervals = self.x.len() - 1;
        match (behind, self.beyond) {
            (true, Beyond::Repeated) if place == intervals => {
                Piece { place: 1, shift: shift + (last - first) }
            }
            (false, Beyond::Repeated) if place == 1 => {
                Piece { place: intervals, shift: shift - (last - first) }
            }
            (true, _) => Piece { place: (place + 1).min(self.x.len()), shift },
            (false, _) => Piece { place: place.saturating_sub(1), shift },
        }
    }

    /// The intervals in order, each with its length, the change of the value, and the terms a, b, c of the way
    /// a x + b x² + c x³, x from 0 to 1.
    pub fn cubics(&self) -> impl Iterator<Item = (f64, f64, [f64; 3])> + '_ {
        (0..self.x.len() - 1).map(|i| {
            let h = self.x[i + 1] - self.x[i];
            let [_, slope, second, third] = self.on(i, self.x[i]);
            let terms = [slope * h, second * h * h / 2.0, third * h * h * h / 6.0];
            (h, self.y[i + 1] - self.y[i], terms)
        })
    }

    /// The values at the points.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.y
    }

    /// How values between the points are found.
    #[must_use]
    pub const fn between(&self) -> Between {
        self.between
    }

    fn end(&self, first: bool) -> f64 {
        let y = if first { self.y.first() } else { self.y.last() };
        y.copied().unwrap_or(f64::NAN)
    }

    /// On the interval behind point i.
    fn on(&self, i: usize, x: f64) -> [f64; 4] {
        let h = self.x[i + 1] - self.x[i];
        let t = x - self.x[i];
        let rise = (self.y[i + 1] - self.y[i]) / h;
        if self.between == Between::Straight {
            let value = if t == h { self.y[i + 1] } else { self.y[i] + rise * t };
            return [value, rise, 0.0, 0.0];
        }
        let (m_0, m_1) = (self.slopes[i], self.slopes[i + 1]);
        let c = (3.0 * rise - 2.0 * m_0 - m_1) / h;
        let d = (m_0 + m_1 - 2.0 * rise) / (h * h);
        let value = if t == h { self.y[i + 1] } else { self.y[i] + t * (m_0 + t * (c + t * d)) };
        [value, m_0 + t * (2.0 * c + 3.0 * d * t), 2.0 * c + 6.0 * d * t, 6.0 * d]
    }

    /// How long the table is, where it begins again.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        let (first, last) = self.range();
        (self.beyond == Beyond::Repeated).then_some(last - first)
    }
}

/// Lengths and rises of the intervals.
fn steps(x: &[f64], y: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let rises = y.windows(2).zip(&h).map(|(w, h)| (w[1] - w[0]) / h).collect();
    (h, rises)
}

/// Slopes of the monotone cubics.
fn monotone(x: &[f64], y: &[f64], repeated: bool) -> Vec<f64> {
    let (h, rises) = steps(x, y);
    let last = h.len();
    if last == 1 {
        return vec![if repeated { 0.0 } else { rises[0] }; 2];
    }
    let inner = |i: usize, k: usize| mean_slope((h[i], rises[i]), (h[k], rises[k]));
    let mut slopes = vec![0.0; x.len()];
    for (i, slope) in slopes.iter_mut().enumerate().take(last).skip(1) {
        *slope = inner(i - 1, i);
    }
    (slopes[0], slopes[last]) = if repeated {
        (inner(last - 1, 0), inner(last - 1, 0))
    } else {
        let end = |i: usize, k: usize| end_slope((h[i], rises[i]), (h[k], rises[k]));
        (end(0, 1), end(last - 1, last - 2))
    };
    slopes
}

/// The weighted harmonic mean of the rises on both sides; nothing at an extreme.
fn mean_slope((h_0, rise_0): (f64, f64), (h_1, rise_1): (f64, f64)) -> f64 {
    if rise_0 == 0.0 || rise_1 == 0.0 || rise_0.is_sign_positive() != rise_1.is_sign_positive() {
        return 0.0;
    }
    let (w_0, w_1) = (2.0 * h_1 + h_0, h_1 + 2.0 * h_0);
    (w_0 + w_1) / (w_0 / rise_0 + w_1 / rise_1)
}

/// The slope of the parabola through the three points at an end, where it keeps the shape.
fn end_slope((h_0, rise_0): (f64, f64), (h_1, rise_1): (f64, f64)) -> f64 {
    let slope = ((2.0 * h_0 + h_1) * rise_0 - h_0 * rise_1) / (h_0 + h_1);
    if slope * rise_0 <= 0.0 {
        0.0
    } else if rise_0 * rise_1 <= 0.0 && slope.abs() > 3.0 * rise_0.abs() {
        3.0 * rise_0
    } else {
        slope
    }
}

/// Slopes of the cubic spline: m₋/h₋ + 2 m (1/h₋ + 1/h₊) + m₊/h₊ = 3 (Δ₋/h₋ + Δ₊/h₊) at every point.
fn spline(x: &[f64], y: &[f64], repeated: bool) -> Vec<f64> {
    let (h, rises) = steps(x, y);
    let last = h.len();
    if last == 1 {
        return vec![0.0; 2];
    }
    // the rows of the points between the ends; where the table begins again, that of the seam first
    let row = |before: usize, after: usize| {
        let (a, b) = (1.0 / h[before], 1.0 / h[after]);
        (a, 2.0 * (a + b), b, 3.0 * (rises[before] * a + rises[after] * b))
    };
    let mut rows: Vec<_> = (1..last).map(|i| row(i - 1, i)).collect();
    if !repeated {
        let inner = tridiagonal(&rows, &rows.iter().map(|r| r.3).collect::<Vec<_>>());
        return std::iter::once(0.0).chain(inner).chain([0.0]).collect();
    }
    // Sherman–Morrison: the corners are a product of two vectors
    rows.insert(0, row(last - 1, 0));
    let (corner, first) = (rows[0].0, rows[0].1);
    let n = rows.len();
    if n == 2 {
        // both neighbours of each point are the other one
        let (off_0, off_1) = (rows[0].0 + rows[0].2, rows[1].0 + rows[1].2);
        let det = first * rows[1].1 - off_0 * off_1;
        let m_0 = (rows[0].3 * rows[1].1 - off_0 * rows[1].3) / det;
        return vec![m_0, (first * rows[1].3 - off_1 * rows[0].3) / det, m_0];
    }
    let gamma = -first;
    rows[0].1 -= gamma;
    rows[n - 1].1 -= corner * corner / gamma;
    let mut ends = vec![0.0; n];
    (ends[0], ends[n - 1]) = (gamma, corner);
    let p = tridiagonal(&rows, &rows.iter().map(|r| r.3).collect::<Vec<_>>());
    let q = tridiagonal(&rows, &ends);
    let of = |v: &[f64]| v[0] + corner / gamma * v[n - 1];
    let share = of(&p) / (1.0 + of(&q));
    let mut slopes: Vec<f64> = p.iter().zip(&q).map(|(p, q)| p - share * q).collect();
    slopes.push(slopes[0]);
    slopes
}

/// Elimination without exchange: the rows are diagonally dominant.
fn tridiagonal(rows: &[(f64, f64, f64, f64)], right: &[f64]) -> Vec<f64> {
    let mut above = Vec::with_capacity(rows.len());
    let mut m = Vec::with_capacity(rows.len());
    for (i, (row, right)) in rows.iter().zip(right).enumerate() {
        let (c, r) = if i == 0 { (0.0, 0.0) } else { (above[i - 1], m[i - 1]) };
        let pivot = row.1 - if i == 0 { 0.0 } else { row.0 * c };
        above.push(row.2 / pivot);
        m.push((right - if i == 0 { 0.0 } else { row.0 * r }) / pivot);
    }
    for i in (0..rows.len().saturating_sub(1)).rev() {
        m[i] -= above[i] * m[i + 1];
    }
    m
}
