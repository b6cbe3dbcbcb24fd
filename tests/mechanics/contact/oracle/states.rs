//! The equations at fixed states, whether states fit, and the choice among all of them.

use super::{Point, Row, Rows, Rub, State, System, solve};

/// Of efforts, over the greatest effort; of accelerations, over their terms.
const FITS: f64 = 1e-8;
/// Of a speed, over the greatest so far.
pub const RESTS: f64 = 1e-9;

/// Accelerations, multipliers, efforts and forces of stops.
pub struct Stage {
    pub accelerations: Vec<f64>,
    pub multipliers: Vec<f64>,
    pub efforts: Vec<f64>,
    pub presses: Vec<f64>,
    /// the greatest force
    pub size: f64,
    pub determined: bool,
    matrix: Vec<Vec<f64>>,
    sign: f64,
}

/// The terms of an acceleration along a row.
fn along(row: &Row, accelerations: &[f64]) -> (f64, f64) {
    row.gradient.iter().zip(accelerations).fold((row.bias, row.bias.abs()), |(sum, terms), (slope, a)| {
        (sum + slope * a, terms + (slope * a).abs())
    })
}

impl System {
    /// What an element may bear against the sense, from the multipliers.
    fn capacity(&self, i: usize, sense: f64, y: &[f64], time: f64) -> f64 {
        let element = &self.elements[i];
        let sum = element.parts.iter().fold((element.capacity)(time), |sum, part| {
            let size = part.of.iter().fold(0.0_f64, |size, &j| size.hypot(y[j]));
            sum + part.even * size + sense * part.odd * y[part.of[0]]
        });
        element.at_rest * sum
    }

    /// The stage equations of Newton's method on the directions of circles; sides are those of the state.
    pub fn stage(&self, point: &Point, rows: &Rows, state: &State) -> Option<Stage> {
        let (n, m, e) = (point.q.len(), self.constraints.len(), self.elements.len());
        let closed: Vec<usize> = (0..self.stops.len()).filter(|&u| state.closed[u]).collect();
        let size = n + m + e + closed.len();
        let (mut k, mut b) = (vec![vec![0.0; size]; size], vec![0.0; size]);
        for i in 0..n {
            k[i][i] = self.mass[i];
            b[i] = rows.forces[i];
        }
        let pushing = (rows.constraints.iter().chain(&rows.elements))
            .chain(closed.iter().map(|&u| &rows.stops[u]))
            .enumerate();
        for (j, row) in pushing {
            let sense = if j < m + e { 1.0 } else { self.stops[closed[j - m - e]].sense };
            for i in 0..n {
                k[i][n + j] = -sense * row.gradient[i];
                k[n + j][i] = sense * row.gradient[i];
            }
            b[n + j] = rows.laws.get(j).map_or(0.0, |law| law[2]) - sense * row.bias;
        }
        for (i, element) in self.elements.iter().enumerate().filter(|(i, _)| state.rubs[*i] != Rub::Held) {
            k[n + m + i].fill(0.0);
            k[n + m + i][n + m + i] = 1.0;
            b[n + m + i] = -state.rubs[i].sense() * (element.capacity)(point.time);
        }
        let circles = self.elements.iter().flat_map(|e| &e.parts).any(|part| part.of.len() > 1);
        let mut y: Vec<f64> = Vec::new();
        for round in 0..30 {
            let mut now = k.clone();
            for (i, element) in self.elements.iter().enumerate() {
                let sense = state.rubs[i].sense();
                for (part, side) in element.parts.iter().zip(&state.sides[i]) {
                    let length = part
                        .of
                        .iter()
                        .fold(0.0_f64, |size, &j| size.hypot(y.get(n + j).copied().unwrap_or(0.0)));
                    for &j in &part.of {
                        let direction = match (part.of.len(), round) {
                            (1, _) => *side,
                            (_, 0) => 0.0,
                            _ => y[n + j] / length.max(1e-300),
                        };
                        now[n + m + i][n + j] += sense * (part.even * direction + sense * part.odd);
                    }
                }
            }
            let solved = solve(now.clone(), b.clone())?;
            let most = solved.x[n..].iter().chain(&b[..n]).fold(1e-6_f64, |most, x| most.max(x.abs()));
            let moved =
                y.iter().zip(&solved.x).any(|(was, is)| (was - is).abs() > 1e-12 * most.max(is.abs()));
            let done = !circles || round > 0 && !moved;
            y = solved.x;
            if done {
                if let [free] = &solved.free[..] {
                    self.share(&mut y, free, state, point.time, &closed);
                }
                if solved.free.len() > 1 {
                    return None;
                }
                let presses = y.split_off(n + m + e);
                let efforts = y.split_off(n + m);
                let multipliers = y.split_off(n);
                let determined = solved.free.is_empty();
                let sign = solved.sign;
                return Some(Stage {
                    accelerations: y,
                    multipliers,
                    efforts,
                    presses,
                    size: most,
                    determined,
                    matrix: now,
                    sign,
                });
            }
        }
        None
    }

    /// What is held once too often: the share with the most room. Rooms are broken lines in it, with bends where a number under bars is zero.
    fn share(&self, y: &mut [f64], free: &[f64], state: &State, time: f64, closed: &[usize]) {
        let (n, m, e) = (self.mass.len(), self.constraints.len(), self.elements.len());
        let held: Vec<usize> = (0..e).filter(|&i| state.rubs[i] == Rub::Held).collect();
        let at = |by: f64| y.iter().zip(free).map(|(y, free)| y + by * free).collect::<Vec<f64>>();
        let rooms = |by: f64| {
            let y = at(by);
            let efforts = held.iter().flat_map(|&i| {
                let effort = y[n + m + i];
                [1.0, -1.0].map(|sense| self.capacity(i, sense, &y[n..], time) + sense * effort)
            });
            efforts.chain((0..closed.len()).map(|u| y[n + m + e + u])).collect::<Vec<f64>>()
        };
        let bend = |j: usize| (free[n + j].abs() > 1e-12).then(|| -y[n + j] / free[n + j]);
        let mut bends: Vec<f64> = (held.iter().flat_map(|&i| &self.elements[i].parts))
            .flat_map(|part| part.of.iter().filter_map(|&j| bend(j)))
            .chain([0.0])
            .collect();
        bends.sort_by(f64::total_cmp);
        let (first, last) = (bends[0], bends[bends.len() - 1]);
        // a line per piece between bends: where it is zero
        let pieces =
            bends.windows(2).map(|pair| [pair[0], pair[1]]).chain([[first - 1.0, first], [last, last + 1.0]]);
        let mut tried = bends.clone();
        for [from, to] in pieces.filter(|[from, to]| to > from) {
            let zero =
                |(from_room, to_room): (f64, f64)| from - from_room * (to - from) / (to_room - from_room);
            tried.extend(rooms(from).into_iter().zip(rooms(to)).map(zero).filter(|by| by.is_finite()));
        }
        tried.sort_by(f64::total_cmp);
        let between: Vec<f64> = tried.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
        tried.extend(between);
        let least = |by: &f64| rooms(*by).into_iter().fold(f64::INFINITY, f64::min);
        let best = tried.iter().copied().max_by(|a, b| least(a).total_cmp(&least(b)));
        let shared = at(best.unwrap_or(0.0));
        y.copy_from_slice(&shared);
    }

    /// Positive as long as the state lasts, by what it is that ends.
    pub fn rooms(
        &self,
        point: &Point,
        rows: &Rows,
        state: &State,
        stage: &Stage,
        fastest: f64,
    ) -> Vec<(Ends, f64)> {
        let mut rooms = Vec::new();
        for (i, element) in self.elements.iter().enumerate() {
            let (row, effort) = (&rows.elements[i], stage.efforts[i]);
            rooms.push(match state.rubs[i] {
                Rub::Slides(sense) => {
                    (Ends::Slides(i), f64::from(sense) * row.rate + 1e-10 * row.terms.max(1e-3))
                }
                Rub::Stands => (Ends::Stands(i), RESTS * fastest.max(1e-3) - row.rate.abs()),
                Rub::Held => {
                    let capacity = self.capacity(i, -effort.signum(), &stage.multipliers, point.time);
                    (Ends::Held(i), (capacity - effort.abs()) / stage.size + 1e-10)
                }
            });
            for (p, part) in
                element.parts.iter().enumerate().filter(|(_, part)| part.of.len() == 1 && part.even > 0.0)
            {
                if matches!(state.rubs[i], Rub::Slides(_)) {
                    let signed = state.sides[i][p] * stage.multipliers[part.of[0]];
                    rooms.push((Ends::Side(i, p), signed / stage.size + 1e-10));
                }
            }
        }
        for (j, _) in self.constraints.iter().enumerate().filter(|(_, constraint)| constraint.bond) {
            rooms.push((Ends::Bond, stage.multipliers[j] / stage.size + 1e-10));
        }
        for ([x, y], _) in &self.drags {
            let speed = x.at(point).rate.hypot(y.at(point).rate);
            rooms.push((Ends::Bond, speed - 1e-2));
        }
        let mut presses = stage.presses.iter();
        for (u, stop) in self.stops.iter().enumerate() {
            rooms.push(if state.closed[u] {
                (Ends::Presses(u), presses.next().map_or(0.0, |force| force / stage.size) + 1e-10)
            } else {
                (Ends::Open(u), stop.sense * (rows.stops[u].value - stop.at) + 1e-10)
            });
        }
        rooms
    }

    /// Whether sliding is stable: the determinant has the sign that it has without friction, on both sides of parts that are zero.
    fn stable(&self, stage: &Stage, state: &State) -> bool {
        if !stage.determined {
            return true;
        }
        let (n, m) = (self.mass.len(), self.constraints.len());
        let sign = |matrix: Vec<Vec<f64>>| {
            let zeros = vec![0.0; matrix.len()];
            solve(matrix, zeros).map_or(0.0, |solved| solved.sign)
        };
        let (mut without, mut zero) = (stage.matrix.clone(), Vec::new());
        for (i, element) in self.elements.iter().enumerate().filter(|(i, _)| state.rubs[*i] != Rub::Held) {
            without[n + m + i].fill(0.0);
            without[n + m + i][n + m + i] = 1.0;
            for (part, side) in
                element.parts.iter().zip(&state.sides[i]).filter(|(part, _)| part.of.len() == 1)
            {
                if stage.multipliers[part.of[0]].abs() <= 1e-9 * stage.size {
                    zero.push((i, part, side));
                }
            }
        }
        let without = sign(without);
        stage.sign * without > 0.0
            && (1..1 << zero.len()).all(|flips: u32| {
                let mut matrix = stage.matrix.clone();
                for (bit, (i, part, side)) in zero.iter().enumerate() {
                    if flips & 1 << bit != 0 {
                        matrix[n + m + i][n + part.of[0]] -= 2.0 * state.rubs[*i].sense() * part.even * *side;
                    }
                }
                sign(matrix) * without > 0.0
            })
    }

    /// Whether the state fits here, in forces and accelerations of what is at rest.
    fn fits(&self, point: &Point, rows: &Rows, state: &State, rest: &[usize], fastest: f64) -> bool {
        let Some(stage) = self.stage(point, rows, state) else { return false };
        // rounding of the greatest acceleration is in all of them
        let most = stage.accelerations.iter().fold(0.0_f64, |most, a| most.max(a.abs())) * 1e-6;
        let begins = rest.iter().all(|&i| {
            let (acceleration, terms) = along(&rows.elements[i], &stage.accelerations);
            state.rubs[i].sense() * acceleration >= -FITS * terms.max(most)
        });
        let opens = self.stops.iter().enumerate().all(|(u, stop)| {
            let row = &rows.stops[u];
            let touches =
                stop.sense * (row.value - stop.at) < 1e-8 && row.rate.abs() <= RESTS * fastest.max(1e-3);
            let (acceleration, terms) = along(row, &stage.accelerations);
            state.closed[u] || !touches || stop.sense * acceleration >= -FITS * terms.max(most)
        });
        begins
            && opens
            && self
                .rooms(point, rows, state, &stage, fastest)
                .iter()
                .all(|(ends, room)| matches!(ends, Ends::Bond | Ends::Stands(_)) || *room >= -FITS)
            && self.stable(&stage, state)
    }

    /// The first state that fits here and shortly after: most held, then most closed, then least changed. Held ones are carried: their
    /// speeds are rounding. So are those that have just come to rest.
    pub fn choose(&self, point: &Point, was: &State, rested: &[usize], fastest: f64) -> Option<State> {
        let rows = self.rows(point);
        let slow = |row: &Row| row.rate.abs() <= RESTS * fastest.max(1e-3);
        let mut base = was.clone();
        let mut rest = Vec::new();
        for (i, row) in rows.elements.iter().enumerate() {
            let sense = if row.rate < 0.0 { -1 } else { 1 };
            if self.elements[i].driven {
                base.rubs[i] = Rub::Stands;
            } else if rested.contains(&i) || slow(row) {
                rest.push(i);
            } else {
                base.rubs[i] = Rub::Slides(sense);
            }
        }
        let touching: Vec<usize> = (0..self.stops.len())
            .filter(|&u| {
                let gap = self.stops[u].sense * (rows.stops[u].value - self.stops[u].at);
                was.closed[u] || gap < 1e-8 && slow(&rows.stops[u])
            })
            .collect();
        base.closed.fill(false);
        if self.elements.iter().any(|element| element.driven) {
            let after = self.rows(&self.carried(point, 1e-4));
            for (i, row) in rows.elements.iter().enumerate().filter(|(i, _)| self.elements[*i].driven) {
                let rate = if slow(row) { after.elements[i].rate } else { row.rate };
                if rate.abs() > RESTS * fastest.max(1e-3) {
                    base.rubs[i] = Rub::Slides(if rate < 0.0 { -1 } else { 1 });
                }
            }
        }
        let mut ways = vec![base];
        for &u in &touching {
            let open = ways.clone();
            ways.iter_mut().for_each(|way| way.closed[u] = true);
            ways.extend(open);
        }
        for &i in &rest {
            ways = [Rub::Held, Rub::Slides(1), Rub::Slides(-1)]
                .iter()
                .flat_map(|&rub| {
                    ways.iter().map(move |way| {
                        let mut way = way.clone();
                        way.rubs[i] = rub;
                        way
                    })
                })
                .collect();
        }
        ways.sort_by_cached_key(|way| {
            let changed = way.rubs.iter().zip(&was.rubs).filter(|(now, was)| now != was).count();
            let moving = way.rubs.iter().filter(|rub| **rub != Rub::Held).count();
            (moving, way.closed.iter().filter(|closed| !**closed).count(), changed)
        });
        [1e-4, 1e-5, 1e-6].iter().find_map(|&shortly| {
            ways.iter().flat_map(|way| self.with_sides(way)).find(|way| {
                self.fits(point, &rows, way, &rest, fastest)
                    && self
                        .step(point, way, shortly)
                        .is_some_and(|after| self.fits(&after, &self.rows(&after), way, &rest, fastest))
            })
        })
    }

    /// The same state with all sides of what slides, the present ones first.
    fn with_sides(&self, state: &State) -> Vec<State> {
        let mut all = vec![state.clone()];
        for (i, element) in self.elements.iter().enumerate().filter(|(i, _)| state.rubs[*i] != Rub::Held) {
            for p in (0..element.parts.len())
                .filter(|&p| element.parts[p].of.len() == 1 && element.parts[p].even > 0.0)
            {
                let mut others = all.clone();
                others.iter_mut().for_each(|other| other.sides[i][p] *= -1.0);
                all.extend(others);
            }
        }
        all
    }
}

/// What ends a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    Slides(usize),
    Stands(usize),
    Held(usize),
    Side(usize, usize),
    Bond,
    Presses(usize),
    Open(usize),
}
