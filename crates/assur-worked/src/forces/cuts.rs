//! Forces inside links: piece by piece as polynomials of the place of the cut.

use crate::course::Derivation;
use crate::document::{Line, Table, text};
use crate::words::Message;
use assur_model::model::{InternalPart, LinkId};
use assur_text::units::significant;
use std::fmt::Write;

/// A coefficient whose term comes to less than this part of the greatest is rounding.
const ROUNDING: f64 = 1e-11;
const DIGITS: usize = 6;

impl Derivation<'_> {
    /// The links inside which forces are asked for.
    pub(super) fn cuts(&mut self) {
        for link in self.scene.mechanism().asked_inside() {
            let label = self.label(link.index());
            self.say(Message::InsideLink, &[vec![text(&*label)]]);
            let table = self.pieces(link);
            self.table(table);
        }
    }

    fn pieces(&self, link: LinkId) -> Table {
        let view = self.scene.view();
        let [begin, end] = view.reach(link);
        let mut pieces = Vec::new();
        let mut from = begin;
        while from < end {
            let to = view.next_place(link, from);
            pieces.push(([from, to], view.piece(link, [from, to])));
            from = to;
        }
        let figure = |x: f64| significant(x, DIGITS).replace('-', "−");
        let size = |part: InternalPart| {
            let all =
                pieces.iter().flat_map(|(_, sections)| sections.map(|section| section.part(part).abs()));
            all.fold(0.0, f64::max)
        };
        let sizes = InternalPart::ALL.map(size);
        let row = |&([from, to], sections): &([f64; 2], [assur_solve::answer::Section; 4])| {
            let mut row: Vec<Line> = vec![vec![text(format!("{} … {}", figure(from), figure(to)))]];
            for (part, size) in InternalPart::ALL.into_iter().zip(sizes) {
                let values = sections.map(|section| section.part(part));
                row.push(vec![text(polynomial([from, to], values, size))]);
            }
            row
        };
        let headers = ["x", "N", "Q", "M"].map(|name| vec![text(name)]).to_vec();
        Table { headers, rows: pieces.iter().map(row).collect(), numbers: Vec::new() }
    }
}

/// The polynomial through the values at both ends of a piece and at its thirds: `4000 x − 1500 x²`.
fn polynomial([from, to]: [f64; 2], values: [f64; 4], size: f64) -> String {
    let mut powers = through(values);
    // of the share of the piece, then of x
    let length = to - from;
    for (i, power) in powers.iter_mut().enumerate() {
        if power.abs() <= ROUNDING * size {
            *power = 0.0;
        }
        *power /= libm::pow(length, i as f64);
    }
    let [a, b, c, d] = powers;
    let x = -from;
    let powers = [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * 3.0 * d), c + 3.0 * x * d, d];
    let longest = from.abs().max(to.abs());
    let mut out = String::new();
    for (i, power) in powers.into_iter().enumerate() {
        let term = power.abs() * libm::pow(longest, i as f64);
        if term <= ROUNDING * size {
            continue;
        }
        let sign = match (out.is_empty(), power < 0.0) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let letter = ["", " x", " x²", " x³"][i];
        let _ = write!(out, "{sign}{}{letter}", significant(power.abs(), DIGITS));
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

/// The coefficients of a cubic through values at 0, 1/3, 2/3 and 1.
fn through([y_0, y_1, y_2, y_3]: [f64; 4]) -> [f64; 4] {
    let (r, s, t) = (y_1 - y_0, y_2 - y_0, y_3 - y_0);
    [y_0, 9.0 * r - 4.5 * s + t, -22.5 * r + 18.0 * s - 4.5 * t, 13.5 * r - 13.5 * s + 4.5 * t]
}
