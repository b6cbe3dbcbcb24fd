//! Matchings and strongly connected components.

use assur_model::structure::matching::{Condition, components, match_all};

#[test]
fn a_later_condition_moves_an_earlier_one_on() {
    let conditions = [Condition { nodes: vec![0, 1] }, Condition { nodes: vec![0] }];
    let m = match_all(&conditions, &[1, 1]);
    assert_eq!(m.node_of, vec![Some(1), Some(0)]);
}

#[test]
fn components_come_after_what_they_point_to() {
    let successors = vec![vec![1], vec![2], vec![1, 3], vec![]];
    assert_eq!(components(&successors), vec![vec![3], vec![1, 2], vec![0]]);
}
