//! Drives, poses and loads.

use super::body::side;
use super::expr::{compare, pose_name, turn};
use super::simulation::Lower;
use super::walk::{P, Parts, span};
use crate::document::{
    Assemble, AssembleClause, Balance, Direction, Drive, DrivePosition, DriveRange, Expr, ExprKind, Load,
    LoadKind, Number, Order, Place, Pose, Sensed, Setting, Site, Steps, Way,
};
use crate::words::Rule;
use assur_text::source::Spanned;

impl Lower<'_> {
    pub(super) fn drive(&mut self, pair: P<'_>) -> Option<Drive> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let target = self.path(parts.any()?)?;
        let position = match parts.take(Rule::position) {
            Some(pair) => Some(self.position(pair)?),
            None => None,
        };
        let rate = self.sensed_behind(&mut parts, Rule::rate)?;
        let acceleration = self.sensed_behind(&mut parts, Rule::acceleration)?;
        let direction = match parts.take(Rule::direction) {
            Some(pair) => Some(direction(pair)?),
            None => None,
        };
        Some(Drive { target, position, rate, acceleration, direction })
    }

    /// The value in `rate` or `acceleration`, if that part stands there.
    pub(super) fn sensed_behind(&mut self, parts: &mut Parts<'_>, rule: Rule) -> Option<Option<Sensed>> {
        let Some(pair) = parts.take(rule) else { return Some(None) };
        let mut inner = Parts::of(pair);
        inner.any()?;
        Some(Some(self.sensed(inner.any()?)?))
    }

    fn position(&mut self, pair: P<'_>) -> Option<DrivePosition> {
        let mut parts = Parts::of(pair);
        let first = self.sensed(parts.any()?)?;
        if let Some(course) = parts.take(Rule::course) {
            let mut parts = Parts::of(course);
            let to = self.expr(parts.any()?)?;
            let count = parts.word(Rule::w_in);
            parts.word(Rule::w_step);
            let steps = self.expr(parts.any()?)?;
            let steps = if count { Steps::In(steps) } else { Steps::Of(steps) };
            return Some(DrivePosition::Range(Box::new(DriveRange { from: first.value, to, steps })));
        }
        let mut given = Vec::new();
        while let Some(pair) = parts.any() {
            given.push(self.sensed(pair)?);
        }
        let alone = given.len() == 1;
        let mut values = vec![first];
        for value in given {
            if let Some(last) = values.last_mut()
                && self.decimal_comma(&mut last.value, &value.value, alone)
            {
                last.sense = value.sense;
                continue;
            }
            values.push(value);
        }
        Some(DrivePosition::Values(values))
    }

    pub(super) fn pose(&mut self, pair: P<'_>) -> Option<Pose> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = pose_name(&parts.any()?);
        parts.word(Rule::w_at);
        Some(Pose { name, settings: self.settings(&mut parts)? })
    }

    pub(super) fn settings(&mut self, parts: &mut Parts<'_>) -> Option<Vec<Setting>> {
        let mut settings = Vec::new();
        while let Some(pair) = parts.take(Rule::setting) {
            let mut inner = Parts::of(pair);
            let target = self.path(inner.any()?)?;
            settings.push(Setting { target, value: self.sensed(inner.any()?)? });
        }
        Some(settings)
    }

    pub(super) fn assemble(&mut self, pair: P<'_>) -> Option<Assemble> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let mut clauses = Vec::new();
        while let Some(pair) = parts.any() {
            let at = span(&pair);
            clauses.push(Spanned::new(self.clause(pair)?, at));
        }
        Some(Assemble { clauses })
    }

    fn clause(&mut self, pair: P<'_>) -> Option<AssembleClause> {
        let mut parts = Parts::of(pair);
        let what = self.path(parts.any()?)?;
        let rest = parts.any()?;
        let rule = rest.as_rule();
        let mut inner = Parts::of(rest);
        let word = inner.any()?;
        Some(match rule {
            Rule::near => AssembleClause::Near { what, at: self.expr(inner.any()?)? },
            Rule::phased => AssembleClause::Phase { what, phase: self.expr(inner.any()?)? },
            Rule::beside => {
                inner.word(Rule::w_of);
                let (from, to) = (self.path(inner.any()?)?, self.path(inner.any()?)?);
                AssembleClause::Side { what, side: side(word)?, from, to }
            }
            Rule::order => {
                let ahead = word.as_rule() == Rule::w_ahead;
                let order = if ahead { Order::Ahead } else { Order::Behind };
                inner.word(Rule::w_of);
                let order = Spanned::new(order, span(&word));
                AssembleClause::Order { what, order, than: self.path(inner.any()?)? }
            }
            Rule::compared => {
                AssembleClause::Sign { what, op: compare(&word)?, bound: self.expr(inner.any()?)? }
            }
            _ => return None,
        })
    }

    pub(super) fn balance(&mut self, pair: P<'_>) -> Option<Balance> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let kind = load_kind(parts.any()?)?;
        let name = parts.name()?;
        let site = self.site(parts.any()?)?;
        let mut also = Vec::new();
        while let Some(other) = parts.take(Rule::other_site) {
            also.push(Parts::of(other).name()?);
        }
        let along = if !parts.word(Rule::w_along) {
            None
        } else if let Some(heading) = parts.take(Rule::heading) {
            Some(heading_angle(heading)?)
        } else {
            Some(self.expr(parts.any()?)?)
        };
        let frame = parts.take(Rule::frame).and_then(|p| Parts::of(p).name_behind(Rule::w_in));
        Some(Balance { kind, name, site, also, along, frame })
    }

    pub(super) fn load(&mut self, pair: P<'_>) -> Option<Load> {
        let mut parts = Parts::of(pair);
        let kind = load_kind(parts.any()?)?;
        let name = parts.name();
        let site = self.site(parts.any()?)?;
        let mut value = self.sensed(parts.any()?)?;
        let mut last = match parts.take(Rule::last) {
            Some(last) => Some(self.expr(Parts::of(last).any()?)?),
            None => None,
        };
        if let Some(heading) = parts.take(Rule::heading) {
            let (end, angle) = (span(&heading), heading_angle(heading)?);
            for value in std::iter::once(&mut value.value).chain(&mut last) {
                let at = value.span.to(end);
                let kind = ExprKind::Polar(Box::new(value.clone()), Box::new(angle.clone()));
                *value = Expr { kind, span: at };
            }
        }
        let frame = parts.take(Rule::frame).and_then(|p| Parts::of(p).name_behind(Rule::w_in));
        let against_motion = parts.take(Rule::against).map(|p| span(&p));
        let when = if parts.word(Rule::w_when) { Some(self.expr(parts.any()?)?) } else { None };
        Some(Load { kind, name, site, value, last, frame, against_motion, when })
    }

    fn site(&mut self, pair: P<'_>) -> Option<Site> {
        let mut parts = Parts::of(pair);
        if parts.word(Rule::w_in) {
            return Some(Site::Pair(parts.name()?));
        }
        if parts.word(Rule::w_at) {
            return Some(Site::Pin(parts.name()?));
        }
        let link = parts.name_behind(Rule::w_on)?;
        if let Some(segment) = parts.take(Rule::segment) {
            let mut ends = Parts::of(segment);
            let (from, to) = (ends.name_behind(Rule::w_from)?, ends.name_behind(Rule::w_to)?);
            return Some(Site::Segment { link, from, to });
        }
        if !parts.word(Rule::w_at) {
            return Some(Site::Link { link, at: None });
        }
        let mut place = Parts::of(parts.any()?);
        let at = match place.name() {
            Some(name) => Place::Point(name),
            None => Place::Ground(self.expr(place.any()?)?),
        };
        Some(Site::Link { link, at: Some(at) })
    }
}

fn direction(pair: P<'_>) -> Option<Spanned<Direction>> {
    let at = span(&pair);
    let mut parts = Parts::of(pair);
    let word = parts.any()?;
    let sense = parts.any()?;
    let direction = match (word.as_rule(), sense.as_rule()) {
        (Rule::w_turning, _) => Direction::Turning(turn(&sense).node),
        (_, Rule::w_forward) => Direction::Moving(Way::Forward),
        _ => Direction::Moving(Way::Back),
    };
    Some(Spanned::new(direction, at))
}

fn load_kind(pair: P<'_>) -> Option<Spanned<LoadKind>> {
    let at = span(&pair);
    let kind = match Parts::of(pair).any()?.as_rule() {
        Rule::w_force => LoadKind::Force,
        _ => LoadKind::Torque,
    };
    Some(Spanned::new(kind, at))
}

/// The angle of a direction of the page.
fn heading_angle(pair: P<'_>) -> Option<Expr> {
    let at = span(&pair);
    let degrees = match Parts::of(pair).any()?.as_rule() {
        Rule::w_right => 0.0,
        Rule::w_up => 90.0,
        Rule::w_left => 180.0,
        _ => 270.0,
    };
    let unit = Some(Spanned::new("deg".to_owned(), at));
    Some(Expr {
        kind: ExprKind::Number(Number { value: degrees, text: degrees.to_string(), unit }),
        span: at,
    })
}
