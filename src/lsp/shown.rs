//! What is shown in and beside a text: hints, lenses, colours, selections.

use super::asked::Asked;
use super::capabilities::{PREVIEW, SOLVE, TEST};
use super::error::Failure;
use crate::editor::{Action, Declared, Picture};
use assur_text::source::Span;
use gen_lsp_types::{Position, Range};
use serde_json::{Value, json};

impl Asked<'_> {
    pub fn hints(&self, range: Range) -> Result<Vec<Value>, Failure> {
        let found = self.analysis.hints(self.span(range)?, self.results, self.earlier).into_iter();
        let found = found.filter(|one| self.client.wants(one.kind));
        let hint = |at: usize, text: &str| {
            let position = self.range(Span::new(at, at)).start;
            json!({ "position": position, "label": text, "paddingLeft": true })
        };
        Ok(found.map(|one| hint(one.at, &one.text)).collect())
    }

    /// The mechanism at the position of a name, with the names of all, and where what is drawn is declared.
    pub fn picture(&self, pose: Option<&str>) -> Result<Value, Failure> {
        let solved = self.results.ok_or_else(|| Failure::request("the text is not solved".to_owned()))?;
        let Picture { svg, poses, places } = self.analysis.picture(solved, pose).map_err(Failure::request)?;
        let place = |place: &Declared| json!({ "name": place.name, "class": place.class, "range": self.range(place.whole) });
        Ok(json!({ "svg": svg, "poses": poses, "places": places.iter().map(place).collect::<Vec<_>>() }))
    }

    pub fn lenses(&self) -> Vec<Value> {
        let lens = |at: Span, title: &str, action: Action| {
            let command = match action {
                Action::Solve => SOLVE,
                Action::Test => TEST,
                Action::Preview => PREVIEW,
            };
            let command = json!({ "title": title, "command": command, "arguments": [self.uri] });
            json!({ "range": self.range(at), "command": command })
        };
        let found = self.analysis.lenses(self.results, self.tested).into_iter();
        found.map(|one| lens(one.at, &one.title, one.action)).collect()
    }

    /// Five numbers each: lines and columns from the one before, length, kind, whether it is declared there.
    pub fn semantic_tokens(&self) -> Vec<u32> {
        let mut data = Vec::new();
        let mut last = Position::default();
        for one in self.analysis.coloured() {
            let Range { start, end } = self.range(one.at);
            let lines = start.line - last.line;
            let columns = if lines == 0 { start.character - last.character } else { start.character };
            let kind = u32::try_from(one.colour).unwrap_or_default();
            data.extend([
                lines,
                columns,
                end.character - start.character,
                kind,
                u32::from(one.is_declaration),
            ]);
            last = start;
        }
        data
    }

    /// For each position the ever larger parts around it, as a chain from the inside.
    pub fn selections(&self, positions: &[Position]) -> Result<Vec<Value>, Failure> {
        let chain = |position: &Position| {
            let around = self.analysis.selections(self.byte(*position)?);
            let outward = around.into_iter().rev().fold(Value::Null, |parent, span| {
                let mut one = json!({ "range": self.range(span) });
                if !parent.is_null() {
                    one["parent"] = parent;
                }
                one
            });
            Ok(outward)
        };
        positions.iter().map(chain).collect()
    }
}
