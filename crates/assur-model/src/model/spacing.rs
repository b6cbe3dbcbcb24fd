//! How far numbers are apart where coordinates and angles are great: no answer has more digits.

use super::{Drive, DriveTarget, Expr, LinkId, Mechanism, PairKind, Positions, Value};
use crate::source::Span;

/// Where numbers are far apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spacing {
    /// The point, line or drive.
    pub span: Span,
    /// An angle, else a length.
    pub is_angle: bool,
    /// The greatest coordinate, m, or the angle, rad.
    pub at: f64,
    /// From a number to the next there.
    pub step: f64,
    /// The length of the shortest link, m, or 1 rad.
    pub of: f64,
}

impl Spacing {
    /// The step as a part of what is to be resolved.
    #[must_use]
    pub fn relative(&self) -> f64 {
        self.step / self.of
    }
}

impl Mechanism {
    /// Where numbers are farthest apart for what they have to tell apart.
    #[must_use]
    pub fn coarsest(&self) -> Option<Spacing> {
        let lengths = self.shortest_link().into_iter().flat_map(|of| self.coordinates(of));
        let angles = self.drives.iter().filter(|d| self.turns(d)).flat_map(angles);
        lengths.chain(angles).max_by(|a, b| a.relative().total_cmp(&b.relative()))
    }

    fn coordinates(&self, of: f64) -> impl Iterator<Item = Spacing> + '_ {
        let places = self.links.iter().flat_map(|link| {
            let points = link.points.iter().map(|p| (p.span, p.at));
            points.chain(link.lines.iter().map(|l| (l.span, l.through)))
        });
        places.map(move |(span, at)| {
            let at = at.x.abs().max(at.y.abs());
            Spacing { span, is_angle: false, at, step: at * f64::EPSILON, of }
        })
    }

    /// The least distance of two points of a moving link.
    fn shortest_link(&self) -> Option<f64> {
        let spans = self.links.iter().skip(1).flat_map(|link| {
            let first = link.points.first().map(|p| p.at);
            link.points.iter().filter_map(move |p| Some((p.at - first?).norm()))
        });
        spans.filter(|length| *length > 0.0 && length.is_finite()).reduce(f64::min)
    }

    fn turns(&self, drive: &Drive) -> bool {
        match drive.target {
            DriveTarget::Link(id) => id != LinkId::GROUND,
            DriveTarget::Pair(pair) => matches!(self.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) => false,
        }
    }
}

/// The angles that a drive takes, as far as they are numbers.
fn angles(drive: &Drive) -> impl Iterator<Item = Spacing> + '_ {
    let values: Vec<&Expr> = match &drive.positions {
        Positions::List(all) => all.iter().collect(),
        Positions::Range { from, to, .. } => vec![from, to],
        Positions::None | Positions::Numbers(_) => Vec::new(),
    };
    values.into_iter().filter_map(|value| {
        let Expr::Constant(Value::Scalar(at)) = value else { return None };
        let at = at.abs();
        Some(Spacing { span: drive.span, is_angle: true, at, step: at * f64::EPSILON, of: 1.0 })
    })
}
