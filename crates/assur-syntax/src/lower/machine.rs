//! Joints, springs, groups and machine elements.

use super::expr::turn;
use super::simulation::Lower;
use super::walk::{P, Parts, span};
use crate::document::{
    AllJoints, Brake, Cam, CamLaw, CamMember, Counterweight, End, Expr, ExprKind, Flywheel, Follower, Group,
    Joint, JointKind, Phase, PhaseKind, Property, Spring, SpringSite,
};
use crate::recover::What;
use crate::words::Rule;
use assur_text::source::Spanned;

impl Lower<'_> {
    pub(super) fn joint(&mut self, pair: P<'_>) -> Option<Joint> {
        let mut parts = Parts::of(pair);
        let kind = kind(&parts.any()?)?;
        let name = parts.name()?;
        let mut ends = Vec::new();
        while let Some(pair) = parts.take(Rule::end) {
            let end = Parts::of(pair).any()?;
            ends.push(match end.as_rule() {
                Rule::path => End::At(self.path(end)?),
                Rule::over => End::Over(Parts::of(end).name_behind(Rule::w_over)?),
                _ => End::Under(Parts::of(end).name_behind(Rule::w_under)?),
            });
        }
        Some(Joint { kind, name, ends, properties: self.properties(&mut parts) })
    }

    pub(super) fn spring(&mut self, pair: P<'_>) -> Option<Spring> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let site = if parts.word(Rule::w_in) {
            SpringSite::Pair(parts.name()?)
        } else {
            SpringSite::Points(self.path(parts.any()?)?, self.path(parts.any()?)?)
        };
        Some(Spring { name, site, properties: self.properties(&mut parts) })
    }

    pub(super) fn all(&mut self, pair: P<'_>) -> Option<AllJoints> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        Some(AllJoints { kind: kind(&parts.any()?)?, properties: self.properties(&mut parts) })
    }

    pub(super) fn group(&mut self, pair: P<'_>) -> Option<Group> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let links = std::iter::from_fn(|| parts.name()).collect();
        Some(Group { name, links })
    }

    /// The properties in braces; none where there are no braces.
    pub(super) fn properties(&mut self, parts: &mut Parts<'_>) -> Vec<Property> {
        let Some(pair) = parts.take(Rule::properties) else { return Vec::new() };
        let mut inner = Parts::of(pair);
        let mut found = Vec::new();
        while let Some(pair) = inner.any() {
            let at = span(&pair);
            let before = self.problems.len();
            if pair.as_rule() == Rule::bad_property {
                self.bad(&pair, What::Property);
                // what has it is not without it
                let (values, properties) = (Vec::new(), Vec::new());
                found.push(Property { name: Spanned::new(String::new(), at), values, properties, span: at });
            } else if let Some(property) = self.property(pair) {
                found.push(property);
            } else {
                self.unreadable(at, before);
            }
        }
        found
    }

    fn property(&mut self, pair: P<'_>) -> Option<Property> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let name = super::walk::name(&parts.any()?);
        let values = match parts.take(Rule::list) {
            Some(list) => self.list(list)?,
            // `cw` names a sense
            None => parts.take(Rule::turn).map(sense).into_iter().collect(),
        };
        Some(Property { name, values, properties: self.properties(&mut parts), span: at })
    }

    pub(super) fn cam(&mut self, pair: P<'_>) -> Option<Cam> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let mut members = Vec::new();
        while let Some(pair) = parts.any() {
            let at = span(&pair);
            let before = self.problems.len();
            let member = if pair.as_rule() == Rule::bad_cam_member {
                CamMember::Bad(self.bad(&pair, What::CamMember))
            } else {
                self.cam_member(pair).unwrap_or_else(|| {
                    self.unreadable(at, before);
                    CamMember::Bad(self.names(at))
                })
            };
            members.push(Spanned::new(member, at));
        }
        Some(Cam { name, members })
    }

    fn cam_member(&mut self, pair: P<'_>) -> Option<CamMember> {
        let rule = pair.as_rule();
        if rule == Rule::property {
            return self.property(pair).map(CamMember::Property);
        }
        let mut parts = Parts::of(pair);
        let word = parts.any()?;
        Some(match rule {
            Rule::cam_turning => CamMember::Turning(turn(&parts.any()?)),
            Rule::follower => CamMember::Follower(Follower {
                motion: parts.name()?,
                shape: parts.name()?,
                properties: self.properties(&mut parts),
            }),
            Rule::lift => CamMember::Lift(parts.name_behind(Rule::w_along)?),
            Rule::phase => CamMember::Phase(Box::new(self.phase(word, parts)?)),
            _ => return None,
        })
    }

    fn phase(&mut self, word: P<'_>, mut parts: Parts<'_>) -> Option<Phase> {
        let kind = match Parts::of(word.clone()).any()?.as_rule() {
            Rule::w_rise => PhaseKind::Rise,
            Rule::w_dwell => PhaseKind::Dwell,
            _ => PhaseKind::Fall,
        };
        let angle = self.expr(parts.any()?)?;
        let through = if parts.word(Rule::w_through) { Some(self.expr(parts.any()?)?) } else { None };
        let law = match parts.any() {
            Some(pair) => Some(law(&pair)?),
            None => None,
        };
        Some(Phase { kind: Spanned::new(kind, span(&word)), angle, through, law })
    }

    pub(super) fn brake(&mut self, pair: P<'_>) -> Option<Brake> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let on = parts.name_behind(Rule::w_on)?;
        Some(Brake { name, on, properties: self.properties(&mut parts) })
    }

    pub(super) fn counterweight(&mut self, pair: P<'_>) -> Option<Counterweight> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let on = parts.name_behind(Rule::w_on)?;
        Some(Counterweight { name, on, properties: self.properties(&mut parts) })
    }

    pub(super) fn flywheel(&mut self, pair: P<'_>) -> Option<Flywheel> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let on = parts.name_behind(Rule::w_on)?;
        let torque = parts.name_behind(Rule::w_for);
        Some(Flywheel { name, on, torque, properties: self.properties(&mut parts) })
    }
}

/// A sense of rotation as the word that it is.
fn sense(pair: P<'_>) -> Expr {
    Expr { kind: ExprKind::Name(pair.as_str().trim().to_owned()), span: span(&pair) }
}

fn kind(pair: &P<'_>) -> Option<Spanned<JointKind>> {
    let at = span(pair);
    let kind = JointKind::named(pair.as_str().trim())?;
    Some(Spanned::new(kind, at))
}

fn law(pair: &P<'_>) -> Option<Spanned<CamLaw>> {
    let law = CamLaw::named(pair.as_str().trim())?;
    Some(Spanned::new(law, span(pair)))
}
