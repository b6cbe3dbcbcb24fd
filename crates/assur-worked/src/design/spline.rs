//! Splines through tables of lifts: the slopes at the rows as a table, and the terms of a piece from them.

use super::cam::{Letters, degrees};
use super::page::{Page, given};
use crate::document::text;
use crate::spline::{Spline, Term};
use crate::words::DesignMessage as Message;
use assur_formula::{Expr, Name, with_digits};
use assur_math::element::cam::{Law, Phase};

impl Page {
    /// The rows of the tables: angle, lift, slope.
    pub(super) fn slopes(&mut self, phases: &[Phase], letters: &Letters) {
        let name = |letter: &str, stage: usize| letters.of(letter, &stage.to_string());
        let spline = Spline { phases, turns: letters.turns, name: &name, given: &given };
        let scale = if letters.turns { 1_f64.to_degrees() } else { 1.0 };
        let mut rows = Vec::new();
        for (i, phase) in phases.iter().enumerate().filter(|(_, p)| matches!(p.law, Law::Spline(_))) {
            let figures = [scale * phase.from, spline.slope(i)].map(|x| with_digits(x, 5).text());
            let cells = [(i + 1).to_string(), degrees(phase.start)].into_iter().chain(figures);
            rows.push(cells.map(|cell| vec![text(cell)]).collect());
        }
        if !rows.is_empty() {
            self.say(Message::CamSlopes, &[]);
            let units = if letters.turns { ["ψ, °", "σ"] } else { ["s, m", "σ, m"] };
            let headers = ["i", "θ, °"].into_iter().chain(units).map(|header| vec![text(header)]);
            self.table(headers.collect(), rows);
        }
    }

    /// The terms of a piece, with the slopes at its ends; what is written already is not written again.
    pub(super) fn terms_of_spline(&mut self, phases: &[Phase], letters: &Letters, at: usize) -> Vec<Expr> {
        let name = |letter: &str, stage: usize| letters.of(letter, &stage.to_string());
        let spline = Spline { phases, turns: letters.turns, name: &name, given: &given };
        for term in spline.slopes_of(at) {
            self.once(term);
        }
        spline.terms_of(at).into_iter().map(|term| self.once(term)).collect()
    }

    fn once(&mut self, Term { name, value, unit, right }: Term) -> Expr {
        match self.written(&name) {
            Some(found) => found,
            None => self.equate(name, value, unit, right.unwrap_or(Expr::ZERO)),
        }
    }

    /// What an equation has found.
    pub(super) fn written(&self, name: &Name) -> Option<Expr> {
        self.equations.iter().find(|(_, e)| e.left.name == *name).map(|(_, e)| e.found())
    }
}
