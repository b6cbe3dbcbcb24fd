//! The motion under loads as a whole: its plot, what every number that is asked for begins and ends with and between what it stays, and
//! what every event is.

use crate::asked_formula::passing_in_letters;
use crate::course::Derivation;
use crate::document::{Inline, Line, Reference, Table, text};
use crate::questions::question;
use crate::words::{Message, RunMessage, say};
use assur_formula::with_digits;
use assur_model::model::{Display, Event, Expr, Find, FindKind, Situation, Value};
use assur_picture::Kind;
use assur_solve::solve::{CourseSet, courses};
use assur_text::units::Dimension;

/// Digits of its numbers, and instants of an event that are listed.
const DIGITS: usize = 5;
const LISTED: usize = 8;

impl Derivation<'_> {
    /// The section with which the solution of a motion begins.
    pub fn overview(&mut self) {
        if self.scene.mechanism().simulation.is_none() {
            return;
        }
        let heading = self.words(RunMessage::Run);
        self.heading(2, heading);
        let plot = self.pictures(Kind::Plot, Message::PlotOfMotion, "");
        if let Some(first) = plot.first() {
            let reference = Reference { caption: first.caption.clone(), ..Reference::default() };
            self.say(RunMessage::SeePlot, &[vec![Inline::Figure(reference)]]);
        }
        self.figures(plot);
        self.ranges();
        self.events();
        let instant = self.instant(self.state().motion.time);
        self.say(RunMessage::OneInstant, &[instant]);
    }

    /// `t = 0.05 s`
    pub(crate) fn instant(&self, time: f64) -> Line {
        let display = self.scene.mechanism().display_of(Dimension::TIME);
        vec![text(format!("t = {}", display.text(Value::Scalar(time), DIGITS)))]
    }

    /// Where every number begins and ends, and its extremes between.
    fn ranges(&mut self) {
        let asked: Vec<(&Find, &Expr, &Display)> = (self.scene.mechanism().finds.iter())
            .filter_map(|find| match &find.kind {
                FindKind::Value { expr, display, poseless: false } => Some((find, expr, display)),
                _ => None,
            })
            .filter(|(_, expr, _)| matches!(self.scene.view().value(expr), Value::Scalar(_)))
            .collect();
        let set = |(_, expr, display): &(&Find, &Expr, &Display)| CourseSet {
            exprs: vec![(*expr).clone()],
            rounding: self.scene.rounding(display.dimension),
        };
        let sets: Vec<CourseSet> = asked.iter().map(set).collect();
        let Ok(found) = courses(&self.scene.model, self.scene.solution, &sets) else { return };
        let time = self.scene.mechanism().display_of(Dimension::TIME);
        let mut rows = Vec::new();
        for ((find, _, display), course) in asked.into_iter().zip(found.sets.into_iter().flatten()) {
            let lines = course.lines(1.0);
            let mut points = lines.iter().flatten();
            let (Some(first), Some(last)) = (points.next(), points.next_back()) else { continue };
            let value = |x: f64| vec![text(with_digits(display.of_si(x), DIGITS).text())];
            let at = |extreme: Option<(f64, f64)>| {
                let Some((t, x)) = extreme else { return vec![text("–".to_owned())] };
                let mut cell = value(x);
                cell.push(text(format!(" ({})", with_digits(time.of_si(t), DIGITS).text())));
                cell
            };
            let mut name = question(self.scene.mechanism(), self.scene.text, find, self.language);
            let unit = crate::sheet::printed_unit(&display.unit);
            if !unit.is_empty() {
                name.push(text(format!(", {}", self.language.unit(unit.trim_start()))));
            }
            rows.push(vec![name, value(first.1), at(course.least), at(course.greatest), value(last.1)]);
        }
        let unit = vec![text(self.language.unit(crate::sheet::printed_unit(&time.unit).trim_start()))];
        let heads = [RunMessage::AtBegin, RunMessage::Least, RunMessage::Greatest, RunMessage::AtEnd];
        let heads = heads.map(|head| say(self.language, head, std::slice::from_ref(&unit)));
        let quantity = vec![text(self.words(Message::Quantity))];
        self.table(Table {
            headers: std::iter::once(quantity).chain(heads).collect(),
            rows,
            numbers: (1..5).collect(),
        });
    }

    /// Where every event of a motion or of a sweep happens, and what it is.
    pub fn events(&mut self) {
        let (mechanism, statics) = (self.scene.mechanism(), &self.scene.solution.statics);
        let along = statics.along(mechanism);
        let (said, place) = match &statics.swept {
            None => (RunMessage::EventsOfRun, self.words(RunMessage::Instants)),
            Some(swept) => {
                let name = &mechanism.drives[swept.drive].name;
                (RunMessage::EventsOfSweep, format!("{name}, {}", along.unit))
            }
        };
        let mut rows = Vec::new();
        for (event, places) in mechanism.events.iter().zip(&statics.events) {
            let shown = |at: &f64| {
                with_digits(if statics.swept.is_some() { along.of_si(*at) } else { *at }, 6).text()
            };
            let mut shown: Vec<String> = places.iter().take(LISTED).map(shown).collect();
            if places.len() > LISTED {
                shown.push(format!("… ({})", places.len()));
            }
            let written = if shown.is_empty() { "–".to_owned() } else { shown.join(", ") };
            let name = event.name.clone().unwrap_or_else(|| self.words(RunMessage::EndsRun));
            rows.push(vec![vec![text(name)], self.what_happens(event), vec![text(written)]]);
        }
        let headers = [self.words(RunMessage::Event), self.words(RunMessage::WhatHappens), place];
        let headers = headers.map(|head| vec![text(head)]).to_vec();
        if !rows.is_empty() {
            self.say(said, &[]);
            self.table(Table { headers, rows, numbers: Vec::new() });
        }
    }

    /// What an event is: a pair that begins to be held or to slip, a number that passes a value, a condition that becomes true.
    fn what_happens(&self, event: &Event) -> Line {
        let pair = |pair| vec![text(&*self.scene.mechanism().pair(pair).name)];
        if let Some((situation, begins)) = event.situation {
            let (message, of) = match (situation, begins) {
                (Situation::Rests(of), true) => (RunMessage::Meets, of),
                (Situation::Rests(of), false) => (RunMessage::Leaves, of),
                (Situation::Sticks(of), true) => (RunMessage::Held, of),
                (Situation::Sticks(of), false) => (RunMessage::Slides, of),
            };
            return say(self.language, message, &[pair(of)]);
        }
        let statement = self.scene.text.get(event.span.start..event.span.end).unwrap_or_default();
        let known = passing_in_letters(self.scene.mechanism(), statement, self.language);
        known.unwrap_or_else(|| {
            vec![text(statement.split_once(':').map_or(statement, |(_, words)| words).trim())]
        })
    }
}
