//! Links and what stands in their braces.

use super::simulation::Lower;
use super::walk::{P, Parts, span, text};
use crate::document::{
    About, Across, At, Bar, Body, CircleMember, Expr, ExprKind, Ground, LineDirection, LineMember, Link,
    MassShape, Member, Name, PointFrom, PointMember, ProfileMember, Shaft, ShapeKind, Side, Slider,
    Statement, WheelMember, WheelSize,
};
use crate::recover::{What, needless_word};
use crate::trivia::corrected;
use crate::words::Rule;
use assur_text::diagnostic::did_you_mean;
use assur_text::language::{Place, words_of};
use assur_text::source::{Span, Spanned};

impl Lower<'_> {
    /// `ground`, `link`, `shaft` and `slider`.
    pub(super) fn link(&mut self, pair: P<'_>) -> Option<Statement> {
        let rule = pair.as_rule();
        let mut parts = Parts::of(pair);
        parts.any()?;
        let number = parts.take(Rule::count).map(|p| text(&p));
        if rule == Rule::ground {
            return Some(Statement::Ground(Ground { number, body: self.body(&mut parts) }));
        }
        let name = parts.name()?;
        Some(match rule {
            Rule::link => {
                let bar = match parts.take(Rule::bar) {
                    Some(pair) => Some(self.bar(pair)?),
                    None => None,
                };
                Statement::Link(Link { number, name, bar, body: self.body(&mut parts) })
            }
            Rule::shaft => {
                let on = parts.name_behind(Rule::w_on);
                Statement::Shaft(Shaft { name, on, body: self.body(&mut parts) })
            }
            _ => Statement::Slider(Slider { name, body: self.body(&mut parts) }),
        })
    }

    fn bar(&mut self, pair: P<'_>) -> Option<Bar> {
        let mut parts = Parts::of(pair);
        Some(Bar { from: parts.name()?, to: parts.name()?, length: self.expr(parts.any()?)? })
    }

    fn body(&mut self, parts: &mut Parts<'_>) -> Body {
        let Some(pair) = parts.take(Rule::body) else { return Body::new() };
        let mut members = Body::new();
        let mut inner = Parts::of(pair);
        while let Some(member) = inner.any() {
            let at = span(&member);
            let node = if member.as_rule() == Rule::bad_member {
                Member::Bad(self.bad(&member, What::Member))
            } else {
                let before = self.problems.len();
                self.member(member).unwrap_or_else(|| {
                    self.unreadable(at, before);
                    Member::Bad(self.names(at))
                })
            };
            members.push(Spanned::new(node, at));
        }
        members
    }

    fn member(&mut self, pair: P<'_>) -> Option<Member> {
        let rule = pair.as_rule();
        let mut parts = Parts::of(pair);
        let word = parts.any()?;
        Some(match rule {
            Rule::m_point => self.point(word, parts)?,
            Rule::m_line => {
                let name = parts.name()?;
                parts.word(Rule::w_through);
                Member::Line(LineMember {
                    name,
                    through: parts.name()?,
                    direction: self.direction(parts.any()?)?,
                })
            }
            Rule::m_circle => {
                let name = parts.name()?;
                let centre = parts.name_behind(Rule::w_centre)?;
                parts.word(Rule::w_radius);
                Member::Circle(CircleMember { name, centre, radius: self.expr(parts.any()?)? })
            }
            Rule::m_profile => Member::Profile(ProfileMember {
                name: parts.name()?,
                of: parts.name_behind(Rule::w_of)?,
                centre: parts.name_behind(Rule::w_centre)?,
            }),
            Rule::m_mass | Rule::m_weight => {
                let value = self.expr(parts.any()?)?;
                let at = parts.name_behind(Rule::w_at);
                let shape = match parts.take(Rule::shape) {
                    Some(pair) => Some(Box::new(self.shape(pair)?)),
                    None => None,
                };
                let inertia = if parts.word(Rule::w_inertia) { Some(self.expr(parts.any()?)?) } else { None };
                let plane = if parts.word(Rule::w_plane) { Some(self.expr(parts.any()?)?) } else { None };
                let name = Spanned::new(word.as_str().to_owned(), span(&word));
                match (&value.kind, &at, &shape, &inertia) {
                    (ExprKind::Vector(..), None, None, None) if plane.is_none() => {
                        Member::Point(PointMember { name, at: value })
                    }
                    _ if rule == Rule::m_mass => Member::Mass(At { value, at, shape, inertia, plane }),
                    _ => Member::Weight(At { value, at, shape, inertia, plane }),
                }
            }
            Rule::m_plane => {
                let value = self.expr(parts.any()?)?;
                match value.kind {
                    ExprKind::Vector(..) | ExprKind::Polar(..) => {
                        let name = Spanned::new(word.as_str().to_owned(), span(&word));
                        Member::Point(PointMember { name, at: value })
                    }
                    _ => Member::Plane(value),
                }
            }
            Rule::m_inertia => {
                let value = self.expr(parts.any()?)?;
                Member::Inertia(About { value, about: parts.name_behind(Rule::w_about) })
            }
            Rule::m_wheel => self.wheel(parts)?,
            _ => return None,
        })
    }

    /// `rod A to B`, `disc centre O radius 0.3 m inner 50 mm thickness 20 mm`
    fn shape(&mut self, pair: P<'_>) -> Option<MassShape> {
        let mut parts = Parts::of(pair);
        let word = parts.any()?;
        let kind = match word.as_rule() {
            Rule::w_rod => ShapeKind::Rod,
            Rule::w_disc => ShapeKind::Disc,
            Rule::w_ring => ShapeKind::Ring,
            Rule::w_sphere => ShapeKind::Sphere,
            _ => ShapeKind::Plate,
        };
        parts.word(Rule::w_centre);
        let mut points = Vec::new();
        while let Some(name) = parts.name() {
            points.push(name);
            parts.word(Rule::w_to);
        }
        let radius = if parts.word(Rule::w_radius) { Some(self.expr(parts.any()?)?) } else { None };
        let inner = if parts.word(Rule::w_inner) { Some(self.expr(parts.any()?)?) } else { None };
        let across = match parts.any() {
            None => None,
            Some(word) => {
                let thick = word.as_rule() == Rule::w_thickness;
                let across = if thick { Across::Thickness } else { Across::Section };
                Some((Spanned::new(across, span(&word)), self.expr(parts.any()?)?))
            }
        };
        Some(MassShape { kind: Spanned::new(kind, span(&word)), points, radius, inner, across })
    }

    fn point(&mut self, name: P<'_>, mut parts: Parts<'_>) -> Option<Member> {
        let name: Name = super::walk::name(&name);
        let at = self.expr(parts.any()?)?;
        if parts.word(Rule::w_at) {
            let angle = self.expr(parts.any()?)?;
            let whole = at.span.to(angle.span);
            let at = Expr { kind: ExprKind::Polar(Box::new(at), Box::new(angle)), span: whole };
            return Some(Member::Point(PointMember { name, at }));
        }
        if !parts.word(Rule::w_from) {
            if let Some(point) = self.word_before_point(&name, &at) {
                return Some(Member::Point(point));
            }
            self.check_point(&name, &at);
            return Some(Member::Point(PointMember { name, at }));
        }
        let first = parts.name()?;
        let second_distance = self.expr(parts.any()?)?;
        let second = parts.name_behind(Rule::w_from)?;
        let side = side(parts.any()?)?;
        let from = PointFrom { name, first_distance: at, first, second_distance, second, side };
        Some(Member::PointFrom(Box::new(from)))
    }

    /// `point A (0, 0)` reads as a point with a call: the word is reported, and the point is what follows.
    fn word_before_point(&mut self, word: &Name, at: &Expr) -> Option<PointMember> {
        let ExprKind::Call { function, args } = &at.kind else { return None };
        let [x, y] = args.as_slice() else { return None };
        if !matches!(word.node.as_str(), "point" | "points" | "pt" | "node") {
            return None;
        }
        let gap = Span::new(word.span.start, function.span.start);
        let help = corrected(self.text, gap, "");
        self.problems.push(needless_word(&word.node, word.span, help));
        let span = Span::new(function.span.end, at.span.end);
        let kind = ExprKind::Vector(Box::new(x.value.clone()), Box::new(y.value.clone()));
        Some(PointMember { name: function.clone(), at: Expr { kind, span } })
    }

    /// A point after whose name a number stands is no point: `wieght 21 N`.
    fn check_point(&mut self, name: &Name, at: &Expr) {
        // `inerta 0 kg*m^2`, but `P 0` is at the origin
        let is_word = !did_you_mean(&name.node, words_of(Place::Member)).is_empty();
        if matches!(&at.kind, ExprKind::Number(n) if n.value != 0.0 || n.unit.is_some() && is_word) {
            let problem = crate::recover::point_without_coordinates(self.text, name, at.span);
            self.problems.push(problem);
        }
    }

    fn direction(&mut self, pair: P<'_>) -> Option<LineDirection> {
        let along = pair.as_rule() == Rule::m_along;
        let mut parts = Parts::of(pair);
        parts.any()?;
        if along {
            return Some(LineDirection::Along(self.expr(parts.any()?)?));
        }
        Some(LineDirection::To(parts.name()?))
    }

    fn wheel(&mut self, mut parts: Parts<'_>) -> Option<Member> {
        let name = parts.name()?;
        let size = match parts.peek() {
            Some(rule @ (Rule::w_radius | Rule::w_diameter | Rule::w_teeth)) => {
                parts.any()?;
                let value = self.expr(parts.any()?)?;
                Some(match rule {
                    Rule::w_radius => WheelSize::Radius(value),
                    Rule::w_diameter => WheelSize::Diameter(value),
                    _ => WheelSize::Teeth(value),
                })
            }
            _ => None,
        };
        let module = if parts.word(Rule::w_module) { Some(self.expr(parts.any()?)?) } else { None };
        let at = parts.name_behind(Rule::w_at);
        Some(Member::Wheel(WheelMember { name, size, module, at }))
    }
}

/// `left` or `right`
pub(super) fn side(pair: P<'_>) -> Option<Spanned<Side>> {
    let at = span(&pair);
    let side = match Parts::of(pair).any()?.as_rule() {
        Rule::w_left => Side::Left,
        _ => Side::Right,
    };
    Some(Spanned::new(side, at))
}
