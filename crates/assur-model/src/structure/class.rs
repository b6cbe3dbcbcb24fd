//! The class of a structural group after Artobolevsky: the number of sides of its most complex closed contour.

use super::group_joint::GroupJoint;
use super::joint::BodyId;

/// Class I with a drive inside and one body, II for a dyad; III where a rigid link carries three or more pairs of the
/// group; k where k inner pairs close a contour that can change its shape.
pub(super) fn class(bodies: &[BodyId], joints: &[GroupJoint], efforts: &[usize]) -> u8 {
    if bodies.len() == 1 && !efforts.is_empty() {
        return 1;
    }
    if bodies.len() <= 2 {
        return 2;
    }
    let contour = joints
        .iter()
        .filter(|j| j.inner)
        .filter_map(|closing| shortest_contour(bodies, joints, *closing))
        .max()
        .unwrap_or(0);
    u8::try_from(contour.max(3)).unwrap_or(u8::MAX)
}

/// The number of pairs in the shortest closed contour of inner joints through one of them.
fn shortest_contour(bodies: &[BodyId], joints: &[GroupJoint], closing: GroupJoint) -> Option<usize> {
    let mut distance: Vec<Option<usize>> = vec![None; bodies.len()];
    let place = |b: BodyId| bodies.iter().position(|&x| x == b);
    let (start, goal) = (place(closing.body)?, place(closing.base)?);
    distance[start] = Some(0);
    let mut queue = std::collections::VecDeque::from([start]);
    while let Some(at) = queue.pop_front() {
        for j in joints.iter().filter(|j| j.inner && **j != closing) {
            let (Some(a), Some(b)) = (place(j.body), place(j.base)) else { continue };
            let next = if a == at {
                b
            } else if b == at {
                a
            } else {
                continue;
            };
            if distance[next].is_none() {
                distance[next] = distance[at].map(|d| d + 1);
                queue.push_back(next);
            }
        }
    }
    distance[goal].map(|d| d + 1)
}
