//! Mechanism → Structure: mobility, structural groups in the order of solution, static determinacy, and lower pairs in
//! place of higher ones.

mod add_effort;
mod add_pair;
mod assertion;
mod count;
mod decompose;
mod defect;
mod diagnose;
#[doc(hidden)]
pub mod echelon;
mod effort;
mod floating;
mod generic;
mod group;
mod incidence;
mod islands;
mod joint;
mod leave_out;
mod letters;
mod lines;
mod lost;
#[doc(hidden)]
pub mod matching;
mod order;
mod parting;
mod place;
mod places;
mod renumber;
mod repeated;
mod replace;
mod ring;
mod roller;
mod swaps;
mod trial;
mod uses;
mod weld;
mod weld_defects;
mod words;

pub use count::Count;
pub use count::Structure;
pub use effort::{Effort, EffortKind, EffortSource};
pub use group::{Dyad, Group, GroupKind};
pub use joint::GroupJoint;
pub use joint::{Body, BodyId, BodyOrigin, BodyRate, Joint, JointId, JointKind, Part, Replaced};
pub use leave_out::{Spare, spare};
pub use lost::{Lost, LostPair, lost};
pub use parting::start_what_parts;

use crate::model::Mechanism;
use assur_text::diagnostic::Diagnosis;
use incidence::Incidence;
use trial::Trial;

/// Finds the structure of a mechanism.
///
/// # Errors
/// All defects found: loose and floating links, over- and underconstrained parts, assertions that do not hold.
pub fn structure(mechanism: &Mechanism) -> Result<(Structure, Vec<Diagnosis>), Vec<Diagnosis>> {
    let replaced = replace::replace(mechanism);
    let drives = effort::of_drives(mechanism, &replaced);
    let trial = Trial { mechanism, replaced: &replaced, efforts: &drives };
    let mut errors = weld_defects::defects(mechanism, &replaced);
    if !errors.is_empty() {
        return Err(errors);
    }
    errors.extend(lines::contradiction(trial).or_else(|| places::contradiction(trial)));
    errors.extend(floating::floating(trial));
    errors.extend(roller::turned(mechanism, &replaced.passive));
    if !errors.is_empty() {
        return Err(errors);
    }
    let count = count::count(mechanism, &replaced, &drives);
    let joints = Incidence::of_joints(&replaced);
    let driven = joints.clone().with_efforts(&replaced, &drives);
    let motion = match decompose::decompose(&replaced, &driven, &drives, decompose::Side::Motion) {
        Ok(groups) => match driven.split() {
            Some(split) => return Err(vec![diagnose::of_split(trial, split)]),
            None => match places::parallel(trial) {
                Some(error) => return Err(vec![error]),
                None => groups,
            },
        },
        Err(defect) => {
            return Err(vec![diagnose::of_motion(trial, &count, &defect)]);
        }
    };
    let efforts = effort::of_balances(mechanism, &replaced);
    let balanced = joints.with_efforts(&replaced, &efforts);
    let split = decompose::decompose(&replaced, &balanced, &efforts, decompose::Side::Forces);
    let (forces, force_defect) = match split {
        Ok(groups) => (groups, None),
        Err(defect) => {
            let trial = Trial { mechanism, replaced: &replaced, efforts: &efforts };
            (Vec::new(), Some(diagnose::of_forces(trial, &count, &defect)))
        }
    };
    let immobile = floating::immobile(trial, &driven);
    let mut structure = Structure {
        passive: replaced.passive.clone(),
        undetermined_couples: replaced.undetermined_couples(),
        count,
        replaced,
        drives,
        motion,
        efforts,
        forces,
        force_defect,
    };
    let (assertion_errors, mut warnings) = assertion::check(mechanism, &mut structure);
    warnings.extend(immobile);
    warnings.extend(letters::wrong_ends(mechanism));
    if assertion_errors.is_empty() { Ok((structure, warnings)) } else { Err(assertion_errors) }
}

impl Structure {
    /// Whether there are slides that may contradict or repeat each other at other numbers.
    #[must_use]
    pub fn has_slides(&self) -> bool {
        let slides = |joint: &&Joint| matches!(joint.kind, JointKind::Prismatic { .. });
        self.replaced.joints.iter().filter(slides).count() > 1
    }

    /// The structure of another mechanism of the same text whose values differ from this one's; `None` where that takes
    /// more than other numbers: a defect, a driven point, or joints of another kind.
    #[must_use]
    pub fn with_numbers_of(&self, mechanism: &Mechanism) -> Option<Self> {
        let points =
            self.drives.iter().any(|d| matches!(d.kind, EffortKind::Point(_) | EffortKind::Place(..)));
        if self.force_defect.is_some()
            || points
            || self.replaced.has_parts()
            || !islands::floating_islands(mechanism).is_empty()
        {
            return None;
        }
        let replaced = replace::replace(mechanism);
        // a roller that turns freely may have got what turns it
        let sound = roller::turned(mechanism, &replaced.passive).is_empty();
        let sound =
            sound && lines::agree(mechanism, &replaced) && places::agree(mechanism, &replaced, &self.drives);
        (sound && replaced.is_alike(&self.replaced)).then(|| Self { replaced, ..self.clone() })
    }
}
