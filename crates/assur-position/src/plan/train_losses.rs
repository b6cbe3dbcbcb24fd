//! Losses of a train group: its columns by the direction of the power, and whether they leave one solution for all loads.

use super::planned::Plan;
use super::train_step::{LawSite, PlannedLaw, TrainForces, TrainSupport};
use crate::math::{AbsLinearSystem, Lu, Part, Vec2};

impl TrainSupport {
    /// Coefficient of a law with losses on the member's coordinate, with what is left of the forces on its two sides.
    #[must_use]
    pub fn coefficient(&self, law: &PlannedLaw, sides: [f64; 2]) -> Option<f64> {
        let term = law.terms.iter().position(|(site, _)| acts_on(site, self))?;
        Some(law.with_losses(term, sides))
    }
}

impl TrainForces {
    /// The column of a law with losses.
    #[must_use]
    pub fn column(&self, law: &PlannedLaw, sides: [f64; 2]) -> Vec<f64> {
        column(&self.members, law, sides)
    }
}

fn column(members: &[TrainSupport], law: &PlannedLaw, sides: [f64; 2]) -> Vec<f64> {
    members.iter().map(|member| member.coefficient(law, sides).unwrap_or(0.0)).collect()
}

/// Whether a law's site is the coordinate of a member.
fn acts_on(site: &LawSite, member: &TrainSupport) -> bool {
    match (site, member) {
        (LawSite::Turn(body), TrainSupport::Turn(hinge, _)) => *body == hinge.body,
        (LawSite::Slide(a), TrainSupport::Shift(b, _)) => {
            a.slider == b.slider && [a.body, a.base].contains(&b.body) && [a.body, a.base].contains(&b.base)
        }
        _ => false,
    }
}

/// The system A y + Σ_k d_k |y_k| = −q in the magnitudes of the unknowns y_k of some columns: each is −A⁻¹ q less the sum of
/// A⁻¹ d_k |y_k|. `None` where A is singular.
#[must_use]
pub fn loss_system(
    n: usize,
    middle: &[f64],
    loads: &[f64],
    departures: &[Vec<f64>],
    columns: &[usize],
) -> Option<AbsLinearSystem> {
    let mut lu = Lu::new(n);
    middle.chunks_exact(n).enumerate().for_each(|(i, row)| lu.set_row(i, row.iter().copied()));
    if !lu.factor() {
        return None;
    }
    let mut solved = |right: &[f64]| {
        let mut x = right.to_vec();
        lu.solve(&mut x);
        x
    };
    let (constant, slopes) = (solved(loads), departures.iter().map(|d| solved(d)).collect::<Vec<_>>());
    let number = |x: f64| Vec2::new(-x, 0.0);
    let parts = columns.iter().enumerate().map(|(row, &column)| Part {
        row,
        plane: false,
        constant: number(constant[column]),
        slopes: slopes.iter().map(|x| number(x[column])).collect(),
    });
    let parts: Vec<Part> = parts.collect();
    let finite = parts.iter().all(|p| p.constant.x.is_finite() && p.slopes.iter().all(|s| s.x.is_finite()));
    finite.then(|| AbsLinearSystem { orientation: lu.sign(), weights: vec![-1.0; columns.len()], parts })
}

/// Whether a group has one solution whatever its loads and the senses of its rates.
pub(super) fn unique(members: &[TrainSupport], laws: &[usize], matrix: &[f64], plan: &Plan) -> bool {
    let n = members.len();
    let lossy = laws
        .iter()
        .enumerate()
        .filter_map(|(i, slot)| Some((i, &plan.laws[*slot], plan.laws[*slot].efficiency?)));
    let (mut middle, mut departures, mut columns) = (matrix.to_vec(), Vec::new(), Vec::new());
    for (index, law, [there, back]) in lossy {
        let [there, back] = [[1.0, there], [back, 1.0]].map(|sides| column(members, law, sides));
        (0..n).for_each(|i| middle[i * n + index] = 0.5 * (there[i] + back[i]));
        departures.push(there.iter().zip(&back).map(|(a, b)| 0.5 * (a - b)).collect());
        columns.push(index);
    }
    loss_system(n, &middle, &vec![0.0; n], &departures, &columns).is_some_and(|laws| laws.unique())
}
