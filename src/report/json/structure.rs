//! The structure in JSON.

use serde::Serialize;

use super::super::mobility::{GroupCount, link_names};
use super::super::train::kind_name;
use assur_model::structure::{Group, GroupKind};
use assur_solve::solve::Model;

#[derive(Serialize)]
pub(super) struct StructureView<'a> {
    mobility: i64,
    links: usize,
    lower_pairs: usize,
    higher_pairs: usize,
    groups: Vec<GroupView<'a>>,
}

#[derive(Serialize)]
struct GroupView<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    links: Vec<String>,
    class: &'static str,
    kind: &'static str,
    n: usize,
    pl: usize,
    ph: usize,
}

impl<'a> StructureView<'a> {
    /// The numbers of the mechanism and its structural groups; links that are driven alone form none.
    pub fn of(model: &Model<'a>) -> Self {
        let count = &model.structure.count;
        let groups = model.structure.motion.iter().filter(|g| g.kind != GroupKind::Driven);
        Self {
            mobility: count.mobility,
            links: count.n,
            lower_pairs: count.lower,
            higher_pairs: count.higher,
            groups: groups.map(|g| GroupView::of(model, g)).collect(),
        }
    }
}

impl<'a> GroupView<'a> {
    fn of(model: &Model<'a>, group: &'a Group) -> Self {
        let count = GroupCount::of(model.structure, group);
        Self {
            name: group.name.as_deref(),
            links: link_names(model, group),
            class: group.class_name(),
            kind: kind_name(model, group),
            n: count.n,
            pl: count.lower,
            ph: count.higher,
        }
    }
}
