//! The independent path: all bodies and all pairs as they are declared, as one system of constraints for the motion.
//!
//! The derivatives of the constraints come from power series in time: with the velocities of the bodies set to unit
//! vectors one by one, the rates of the constraints are the columns of their Jacobian.

use crate::support::draft::Frame;
use crate::support::equilibrium::{Forces, equilibrium};
use crate::support::jet::{Jet, Moving};
use assur::internals::math::{Scalar, V2, Vec2};
use assur::internals::model::{
    Drive, DriveTarget, Expr, Guide, LinkId, Mechanism, PairKind, Positions, Profile, ProfileShape, Value,
};
use nalgebra::{DMatrix, DVector};

/// Motion of a body: rates and second rates of the origin and the angle.
#[derive(Clone, Copy, Debug)]
pub struct Rates<S = f64> {
    pub v: V2<S>,
    pub omega: S,
    pub a: V2<S>,
    pub alpha: S,
}

impl<S: Scalar> Default for Rates<S> {
    fn default() -> Self {
        Self { v: V2::zero(), omega: S::zero(), a: V2::zero(), alpha: S::zero() }
    }
}

/// A body in motion.
#[derive(Clone, Copy, Debug)]
pub struct Body<S = f64> {
    pub p: Moving<S>,
    pub u: Moving<S>,
}

impl Body {
    fn new(frame: &Frame, rates: &Rates) -> Self {
        Self::moving(frame.p, frame.u, rates)
    }
}

impl<S: Scalar> Body<S> {
    /// With its origin at `p` and its x axis along `u`.
    pub fn moving(p: V2<S>, u: V2<S>, rates: &Rates<S>) -> Self {
        Self { p: Moving::new(p, rates.v, rates.a), u: Moving::direction(u, rates.omega, rates.alpha) }
    }

    /// A point of the body.
    pub fn point(&self, at: Vec2) -> Moving<S> {
        self.p.plus(Moving::constant(at).turned(self.u))
    }

    pub fn axis(&self, d: Vec2) -> Moving<S> {
        Moving::constant(d).turned(self.u)
    }
}

/// The direction of an angle.
pub trait Direction: Scalar {
    fn direction(angle: f64) -> V2<Self>;
}

impl Direction for f64 {
    fn direction(angle: f64) -> Vec2 {
        Vec2::direction(angle)
    }
}

pub struct Reference {
    pub rates: Vec<Rates>,
    pub bodies: Vec<Body>,
    pub forces: Option<Forces>,
}

impl Reference {
    /// Motion and forces at the given poses; `None` where the constraints do not determine the motion.
    pub fn new(mechanism: &Mechanism, frames: &[Frame]) -> Option<Self> {
        let rates = motion(mechanism, frames)?;
        let bodies: Vec<Body> = frames.iter().zip(&rates).map(|(f, r)| Body::new(f, r)).collect();
        let forces = equilibrium(mechanism, &bodies, &rates);
        Some(Self { rates, bodies, forces })
    }

    /// The unknown efforts hold the mechanism, and not just barely.
    pub fn holds_well(&self) -> bool {
        self.forces.as_ref().is_some_and(|f| f.condition > 3e-3)
    }
}

pub fn number(expr: &Expr) -> f64 {
    match expr {
        Expr::Constant(Value::Scalar(x)) => *x,
        _ => f64::NAN,
    }
}

pub fn vector(expr: &Expr) -> Vec2 {
    match expr {
        Expr::Constant(Value::Vector(v)) => *v,
        _ => Vec2::new(f64::NAN, f64::NAN),
    }
}

/// A drive's value with its derivatives.
fn law(drive: &Drive) -> Jet {
    let value = match &drive.positions {
        Positions::List(list) => list.first().map_or(f64::NAN, number),
        Positions::Numbers(list) => list.first().copied().unwrap_or(f64::NAN),
        Positions::None | Positions::Range { .. } => f64::NAN,
    };
    let rate = drive.speed.as_ref().map_or(0.0, number);
    Jet { value, rate, second: drive.acceleration.as_ref().map_or(0.0, number) }
}

/// Links that guides keep from turning against each other, by a number alike.
struct Alike(Vec<usize>);

impl Alike {
    /// Whether a guide between two links is the first that does so: of others the directions agree to rounding only.
    fn joins(&mut self, a: LinkId, b: LinkId) -> bool {
        let (from, to) = (self.0[a.index()], self.0[b.index()]);
        self.0.iter_mut().filter(|x| **x == from).for_each(|x| *x = to);
        from != to
    }
}

/// All constraints; zero where they hold. With `driven` false the drives stand still.
pub fn constraints<S: Direction>(mechanism: &Mechanism, bodies: &[Body<S>], driven: bool) -> Vec<Jet<S>> {
    let mut out = Vec::new();
    let body = |link: LinkId| &bodies[link.index()];
    let mut turning = Alike((0..bodies.len()).collect());
    for pair in &mechanism.pairs {
        match &pair.kind {
            // trains are tested by themselves
            PairKind::Transmission(_) => {}
            PairKind::Revolute(pins) => {
                let at = |i: usize| body(pins[i].link).point(pins[i].at);
                for i in 1..pins.len() {
                    let apart = at(i).minus(at(0));
                    out.extend([apart.x, apart.y]);
                }
            }
            PairKind::Weld { pins, angle } => {
                let first = body(pins[0].link);
                for pin in &pins[1..] {
                    let own = body(pin.link);
                    let apart = own.point(pin.at).minus(first.point(pins[0].at));
                    let along = first.axis(Vec2::direction(*angle));
                    out.extend([apart.x, apart.y, own.u.cross(along)]);
                }
            }
            PairKind::Prismatic(g) => {
                out.push(height(g, bodies));
                if turning.joins(g.slider, g.guide) {
                    out.push(body(g.slider).axis(g.direction).cross(body(g.guide).axis(g.along)));
                }
            }
            PairKind::Slot(g) => out.push(height(g, bodies)),
            PairKind::Contact { first, second, internal, .. } => {
                out.push(contact(first, second, *internal, bodies));
            }
            PairKind::Cylinder { barrel, rod: end, from, to } => {
                let (tube, rod) = (body(*barrel), body(*end));
                let apart = body(from.link).point(from.at).minus(tube.p);
                let also = body(to.link).point(to.at).minus(rod.p);
                out.extend([apart.x, apart.y, also.x, also.y]);
                out.push(tube.u.cross(rod.p.minus(tube.p)));
                if turning.joins(*barrel, *end) {
                    out.push(tube.u.cross(rod.u));
                }
            }
        }
    }
    for link in rollers(mechanism) {
        let angle = body(link).u.value().perp();
        out.push(body(link).u.dot(Moving::fixed(angle)));
    }
    for drive in &mechanism.drives {
        if let DriveTarget::Point(link, at) = drive.target {
            let [place, v, a] = point_law(drive);
            let law = if driven {
                Moving::new(V2::of(place), V2::of(v), V2::of(a))
            } else {
                Moving::constant(place)
            };
            let apart = body(link).point(at).minus(law);
            out.extend([apart.x, apart.y, body(link).u.cross(Moving::constant(Vec2::new(1.0, 0.0)))]);
            continue;
        }
        let mut law = law(drive);
        if !driven {
            law = Jet::constant(law.value);
        }
        out.push(match drive.target {
            DriveTarget::Link(link) => turned_by(Moving::constant(Vec2::new(1.0, 0.0)), body(link).u, law),
            DriveTarget::Pair(pair) => match &mechanism.pair(pair).kind {
                PairKind::Revolute(pins) => turned_by(body(pins[0].link).u, body(pins[1].link).u, law),
                PairKind::Prismatic(g) | PairKind::Slot(g) => {
                    let from = body(g.slider).point(g.point).minus(body(g.guide).point(g.through));
                    from.dot(body(g.guide).axis(g.along)) - Jet::of(law)
                }
                PairKind::Cylinder { from, to, .. } => {
                    let r = body(to.link).point(to.at).minus(body(from.link).point(from.at));
                    r.dot(r) - Jet::of(law) * Jet::of(law)
                }
                PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => {
                    Jet::constant(S::of(f64::NAN))
                }
            },
            DriveTarget::Place(link, at, axis) => {
                body(link).point(at).dot(Moving::constant(axis.unit())) - Jet::of(law)
            }
            DriveTarget::Point(..) => Jet::constant(S::of(f64::NAN)),
        });
    }
    out
}

/// Place, velocity and acceleration of a driven point.
fn point_law(drive: &Drive) -> [Vec2; 3] {
    let place = match &drive.positions {
        Positions::List(list) => list.first().map_or(Vec2::zero(), vector),
        Positions::None | Positions::Numbers(_) | Positions::Range { .. } => Vec2::zero(),
    };
    let of = |e: &Option<Expr>| e.as_ref().map_or(Vec2::zero(), vector);
    [place, of(&drive.speed), of(&drive.acceleration)]
}

fn turned_by<S: Direction>(from: Moving<S>, to: Moving<S>, law: Jet) -> Jet<S> {
    let u = Moving::direction(S::direction(law.value), S::of(law.rate), S::of(law.second));
    u.turned(from).cross(to)
}

/// Height of the point over the line.
fn height<S: Scalar>(g: &Guide, bodies: &[Body<S>]) -> Jet<S> {
    let (slider, guide) = (&bodies[g.slider.index()], &bodies[g.guide.index()]);
    guide.axis(g.along).cross(slider.point(g.point).minus(guide.point(g.through)))
}

fn contact<S: Scalar>(first: &Profile, second: &Profile, internal: bool, bodies: &[Body<S>]) -> Jet<S> {
    let body = |p: &Profile| &bodies[p.link.index()];
    let round = |p: &Profile| match p.shape {
        ProfileShape::Point(c) => Some((body(p).point(c), 0.0)),
        ProfileShape::Circle(c, r) => Some((body(p).point(c), r)),
        // cams are tested by themselves
        ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
    };
    let straight = |p: &Profile, c: Moving<S>, r: f64| match p.shape {
        ProfileShape::Line(q, d) => {
            let height = body(p).axis(d).cross(c.minus(body(p).point(q)));
            let r = S::of(r);
            height - Jet::constant(S::select(height.value.lt(S::zero()), -r, r))
        }
        _ => Jet::constant(S::of(f64::NAN)),
    };
    match (round(first), round(second)) {
        (Some((p, r)), Some((q, s))) => {
            let apart = p.minus(q);
            let distance = if internal { S::of(r) - S::of(s) } else { S::of(r) + S::of(s) };
            apart.dot(apart) - Jet::constant(distance * distance)
        }
        (Some((c, r)), None) => straight(second, c, r),
        (None, Some((c, r))) => straight(first, c, r),
        (None, None) => Jet::constant(S::of(f64::NAN)),
    }
}

/// Links whose rotation changes nothing: one hinge, and circles about it that touch others.
pub fn rollers(mechanism: &Mechanism) -> Vec<LinkId> {
    let free = |link: LinkId| {
        let (mut hinges, mut centres) = (Vec::new(), Vec::new());
        for pair in &mechanism.pairs {
            match &pair.kind {
                PairKind::Revolute(pins) => {
                    hinges.extend(pins.iter().filter(|p| p.link == link).map(|p| p.at));
                }
                PairKind::Contact { first, second, .. } => {
                    for profile in [first, second].into_iter().filter(|p| p.link == link) {
                        match profile.shape {
                            ProfileShape::Circle(c, _) => centres.push(c),
                            _ => return false,
                        }
                    }
                }
                other if other.links().contains(&link) => return false,
                PairKind::Cylinder { barrel, rod, .. } if *barrel == link || *rod == link => return false,
                _ => {}
            }
        }
        let driven = mechanism.drives.iter().any(|d| d.target == DriveTarget::Link(link));
        hinges.len() == 1 && !centres.is_empty() && centres.iter().all(|&c| c == hinges[0]) && !driven
    };
    (1..mechanism.links.len()).map(LinkId::at).filter(|&l| free(l)).collect()
}

/// Velocities, then accelerations, of all bodies.
fn motion(mechanism: &Mechanism, frames: &[Frame]) -> Option<Vec<Rates>> {
    let unknowns = 3 * (frames.len() - 1);
    let mut rates = vec![Rates::default(); frames.len()];
    let evaluate = |rates: &[Rates], driven: bool| {
        let bodies: Vec<Body> = frames.iter().zip(rates).map(|(f, r)| Body::new(f, r)).collect();
        constraints(mechanism, &bodies, driven)
    };
    let rows = evaluate(&rates, false).len();
    let mut jacobian = DMatrix::<f64>::zeros(rows, unknowns);
    for column in 0..unknowns {
        let unit = &mut rates[1 + column / 3];
        match column % 3 {
            0 => unit.v.x = 1.0,
            1 => unit.v.y = 1.0,
            _ => unit.omega = 1.0,
        }
        for (row, c) in evaluate(&rates, false).iter().enumerate() {
            jacobian[(row, column)] = c.rate;
        }
        rates[1 + column / 3] = Rates::default();
    }
    let solver = Solver::new(jacobian)?;
    let right = evaluate(&rates, true);
    let velocity = solver.solve(&DVector::from_iterator(rows, right.iter().map(|c| -c.rate)))?;
    for (body, x) in rates[1..].iter_mut().zip(velocity.as_slice().chunks_exact(3)) {
        body.v = Vec2::new(x[0], x[1]);
        body.omega = x[2];
    }
    let right = evaluate(&rates, true);
    let second = solver.solve(&DVector::from_iterator(rows, right.iter().map(|c| -c.second)))?;
    for (body, x) in rates[1..].iter_mut().zip(second.as_slice().chunks_exact(3)) {
        body.a = Vec2::new(x[0], x[1]);
        body.alpha = x[2];
    }
    Some(rates)
}

/// A linear system: square by LU with full pivoting; with more rows than columns, or fewer, by QR of the matrix or of its
/// transpose.
pub enum Solver {
    Square(nalgebra::FullPivLU<f64, nalgebra::Dyn, nalgebra::Dyn>),
    Tall(DMatrix<f64>, DMatrix<f64>),
    F64x8(DMatrix<f64>, DMatrix<f64>),
}

/// Diagonal elements below this share of the greatest are zero.
const NULL: f64 = 1e-10;

impl Solver {
    /// `None` where columns depend on each other.
    pub fn new(matrix: DMatrix<f64>) -> Option<Self> {
        let columns = matrix.ncols();
        let this = Self::of_any_rank(matrix);
        (this.rank() == columns).then_some(this)
    }

    pub fn of_any_rank(matrix: DMatrix<f64>) -> Self {
        if matrix.is_square() {
            Self::Square(matrix.full_piv_lu())
        } else if matrix.nrows() > matrix.ncols() {
            let qr = matrix.qr();
            Self::Tall(qr.q(), qr.r())
        } else {
            let qr = matrix.transpose().qr();
            Self::F64x8(qr.q(), qr.r())
        }
    }

    fn measures(&self) -> Vec<f64> {
        let diagonal = match self {
            Self::Square(lu) => lu.u().diagonal(),
            Self::Tall(_, r) | Self::F64x8(_, r) => r.diagonal(),
        };
        diagonal.iter().map(|x| x.abs()).collect()
    }

    fn greatest(&self) -> f64 {
        self.measures().into_iter().fold(f64::MIN_POSITIVE, f64::max)
    }

    pub fn rank(&self) -> usize {
        let least = NULL * self.greatest();
        self.measures().into_iter().filter(|x| *x > least).count()
    }

    /// The least measure that is not zero over the greatest.
    pub fn condition(&self) -> f64 {
        let greatest = self.greatest();
        let others = self.measures().into_iter().filter(|x| *x > NULL * greatest);
        others.fold(greatest, f64::min) / greatest
    }

    /// Whether each unknown is determined.
    pub fn determined(&self, columns: usize) -> Vec<bool> {
        match self {
            Self::Square(_) | Self::Tall(..) => vec![self.rank() == columns; columns],
            // what is left of a unit vector outside the range of the rows
            Self::F64x8(q, _) => (0..columns).map(|j| (1.0 - q.row(j).norm_squared()).abs() < 1e-8).collect(),
        }
    }

    /// The solution, of least squares or of least length where there are too many or too few equations.
    pub fn solve(&self, right: &DVector<f64>) -> Option<DVector<f64>> {
        match self {
            Self::Square(lu) => lu.solve(right),
            Self::Tall(q, r) => r.solve_upper_triangular(&(q.transpose() * right)),
            Self::F64x8(q, r) => Some(q * r.transpose().solve_lower_triangular(right)?),
        }
    }
}
