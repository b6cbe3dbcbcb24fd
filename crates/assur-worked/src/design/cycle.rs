//! Quantities of the cycle: extreme positions, stroke, the ratio of the times out and back.

use super::page::Page;
use crate::document::text;
use crate::prune::queries;
use crate::words::DesignMessage as Message;
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{FindKind, PairId, PairKind, Query};
use assur_solve::solve::{Model, Solution};

impl Page {
    /// The pairs whose stroke, extreme positions or ratio of times the file asks for.
    pub(super) fn cycle(&mut self, model: &Model<'_>, solution: &Solution) {
        let mechanism = model.mechanism;
        let mut pairs: Vec<PairId> = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, .. } = &find.kind else { continue };
            queries(mechanism, expr, &mut |query| {
                if let Query::Stroke(pair)
                | Query::TimeRatio(pair)
                | Query::Dead(pair, _)
                | Query::Travel(pair) = query
                    && !pairs.contains(pair)
                {
                    pairs.push(*pair);
                }
            });
        }
        let statics = &solution.statics;
        let known =
            |pair: &PairId| statics.stroke(*pair).is_finite() && statics.time_ratio(*pair).is_finite();
        pairs.retain(known);
        for pair in pairs {
            let named = mechanism.pair(pair);
            let turns = matches!(named.kind, PairKind::Revolute(_));
            self.heading(Message::CycleOf, &[vec![text(named.name.clone())]]);
            self.say(Message::ExtremesOf, &[vec![text(named.name.clone())]]);
            let letter = |letter: &str, more: &str| Name::new(letter, &format!("{more},{}", named.name));
            let angle = |which: u8| statics.dead(pair, which).to_degrees();
            let one = self.stated(letter("φ", "1"), angle(1), Unit::Angle);
            let two = self.stated(letter("φ", "2"), angle(2), Unit::Angle);
            let (unit, scale) =
                if turns { (Unit::Angle, 180.0 / std::f64::consts::PI) } else { (Unit::Length, 1.0) };
            let sort = if turns { "φ" } else { "s" };
            let least = self.stated(letter(sort, "min"), scale * statics.least(pair), unit);
            let most = scale * (statics.least(pair) + statics.stroke(pair));
            let most = self.stated(letter(sort, "max"), most, unit);
            let stroke = letter(if turns { "ψ" } else { "H" }, "");
            let stroke = Name::new(&stroke.letter, stroke.sub.trim_start_matches(','));
            self.equate(stroke, scale * statics.stroke(pair), unit, most - least);
            // the way from the least to the greatest, and what is left of the turn
            let right = if angle(2) >= angle(1) { two - one } else { one - two };
            let way = self.named(letter("Δφ", "1"), Unit::Angle, right);
            let right = Expr::Degrees(360) - way.clone();
            let other = self.named(letter("Δφ", "2"), Unit::Angle, right);
            self.say(Message::TimesOf, &[]);
            let (long, short) = if way.value() >= other.value() { (way, other) } else { (other, way) };
            let ratio = Name::new("K", &named.name);
            let k = self.equate(ratio, statics.time_ratio(pair), Unit::One, long / short);
            let right = Expr::Degrees(180) * (k.clone() - Expr::Int(1)) / (k + Expr::Int(1));
            self.named(Name::new("θ", &named.name), Unit::Angle, right);
        }
    }
}
