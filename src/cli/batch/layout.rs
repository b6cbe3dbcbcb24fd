//! The columns of a batch: those of all its files, each header once.

use super::super::args::Format;
use super::job::Job;
use crate::exercise::table::{Separator, cells, from_cell};
use crate::report::Page;
use crate::report::csv::LINE_END;
use crate::report::document::{Block, Column, Report, Section, Table};
use crate::report::rows::{FULL, write_text};

const READABLE: usize = 6;

/// The columns of a batch.
#[derive(Clone, Debug)]
pub struct Layout {
    headers: Vec<String>,
    /// Several files: each line begins with its file, and its cells are put below the headers.
    several: bool,
    /// An answer key: no givens, no drives, no errors.
    pub key: bool,
    pub digits: usize,
}

impl Layout {
    pub fn of(jobs: &[Job], format: Format) -> Self {
        Self::new(jobs, false, if format.is_read() { READABLE } else { FULL })
    }

    /// Those of an answer key.
    pub fn of_key(jobs: &[Job]) -> Self {
        Self::new(jobs, true, FULL)
    }

    fn new(jobs: &[Job], key: bool, digits: usize) -> Self {
        let several = jobs.len() > 1;
        let mut headers: Vec<String> = if several { vec!["file".to_owned()] } else { Vec::new() };
        for job in jobs {
            for header in job.headers(key) {
                if !headers.contains(&header) {
                    headers.push(header);
                }
            }
        }
        // what failed stands last
        if let Some(error) = headers.iter().position(|h| h == ERROR) {
            let error = headers.remove(error);
            headers.push(error);
        }
        Self { headers, several, key, digits }
    }

    /// The first line of CSV.
    pub fn header(&self) -> String {
        let mut line = String::new();
        for (i, header) in self.headers.iter().enumerate() {
            if i > 0 {
                line.push(',');
            }
            write_text(header, &mut line);
        }
        line + LINE_END
    }

    /// For each cell of a job's lines the column where it belongs; `None` where the job's lines are the batch's.
    pub fn places(&self, job: &Job) -> Option<Vec<usize>> {
        let place = |header: &String| self.headers.iter().position(|h| h == header).unwrap_or(0);
        self.several.then(|| job.headers(self.key).iter().map(place).collect())
    }

    /// Puts the cells of lines in their places, after the file's name.
    pub fn placed(&self, lines: &str, places: &[usize], file: &str) -> String {
        let mut out = String::new();
        let mut row: Vec<&str> = Vec::new();
        for line in lines.split_terminator(LINE_END) {
            row.clear();
            row.resize(self.headers.len(), "");
            let found = cells(line, Separator::Comma).unwrap_or_default();
            for (cell, place) in found.iter().zip(places) {
                row[*place] = &line[cell.span.start..cell.span.end];
            }
            write_text(file, &mut out);
            for cell in &row[1..] {
                out.push(',');
                out.push_str(cell);
            }
            out.push_str(LINE_END);
        }
        out
    }

    /// Lines as a page to read.
    pub fn table(&self, lines: &str, title: &str, page: Page) -> String {
        let words = |h: &String| matches!(h.as_str(), "row" | "variant" | "pose" | EVENT | ERROR);
        let column =
            |h: &String| if words(h) { Column::words(h.as_str()) } else { Column::numbers(h.as_str()) };
        let mut table = Table::new(self.headers.iter().map(column).collect(), 0);
        table.keys = self.headers.iter().take_while(|h| matches!(h.as_str(), "row" | "variant")).count();
        let place = self.headers.iter().position(|h| h == "pose" || h.starts_with("time ["));
        for line in lines.split_terminator(LINE_END) {
            let found = cells(line, Separator::Comma).unwrap_or_default();
            table.row(found.into_iter().map(|c| from_cell(&c.text).to_owned()).collect());
        }
        if let Some(place) = place {
            move_to_keys(&mut table, place);
        }
        drop_empty(&mut table);
        let section = Section { heading: "Answers".to_owned(), blocks: vec![Block::Table(table)] };
        page.render(&Report { title: title.to_owned(), notes: Vec::new(), sections: vec![section] })
    }
}

/// The header of the events at an instant.
pub const EVENT: &str = "event";
/// The header of what went wrong.
pub const ERROR: &str = "error";

/// What names a line is in every part of a table that is too wide.
fn move_to_keys(table: &mut Table, place: usize) {
    let header = table.columns.remove(place);
    table.columns.insert(table.keys, header);
    for row in &mut table.rows {
        let cell = row.remove(place);
        row.insert(table.keys, cell);
    }
    table.keys += 1;
}

/// Columns without a cell are no help to a reader.
fn drop_empty(table: &mut Table) {
    for i in (0..table.columns.len()).rev() {
        if table.rows.iter().all(|row| row[i].is_empty()) {
            table.columns.remove(i);
            table.keys -= usize::from(i < table.keys);
            table.rows.iter_mut().for_each(|row| drop(row.remove(i)));
        }
    }
}
