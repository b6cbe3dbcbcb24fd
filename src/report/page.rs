//! A report in one of several forms; as an object, `docs/json-schema/report-1.json`, and as comma-separated values.

use super::document::{Block, Report};
use super::text::{self, Look};
use super::{csv, latex, markdown, typst};
use serde::Serialize;

/// The form of a page.
#[derive(Clone, Copy, Debug)]
pub enum Page {
    /// Tables to read on a screen.
    Text(Look),
    /// One object, on a line of its own.
    Json,
    /// Comma-separated values, table below table.
    Csv,
    Markdown,
    /// Sections and tables of a LaTeX document, for `\input`.
    Latex,
    /// Sections and tables of a Typst document, for `#include`.
    Typst,
}

impl Page {
    /// The report in this form.
    #[must_use]
    pub fn render(self, report: &Report) -> String {
        match self {
            Self::Text(look) => text::render(report, look),
            Self::Json => json(report),
            Self::Csv => csv(report),
            Self::Markdown => markdown::render(report),
            Self::Latex => latex::render(report),
            Self::Typst => typst::render(report),
        }
    }
}

/// Name and version of the format.
const SCHEMA: &str = "assur.report/1";

#[derive(Serialize)]
struct ReportView<'a> {
    schema: &'static str,
    title: &'a str,
    notes: &'a [String],
    sections: Vec<SectionView<'a>>,
}

#[derive(Serialize)]
struct SectionView<'a> {
    heading: &'a str,
    blocks: Vec<BlockView<'a>>,
}

#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
enum BlockView<'a> {
    Text(&'a str),
    List(&'a [String]),
    Facts(&'a [(String, String)]),
    Table { columns: Vec<&'a str>, rows: &'a [Vec<String>] },
}

impl<'a> BlockView<'a> {
    fn of(block: &'a Block) -> Self {
        match block {
            Block::Text(text) => Self::Text(text),
            Block::List(items) => Self::List(items),
            Block::Facts(facts) => Self::Facts(facts),
            Block::Table(table) => Self::Table {
                columns: table.columns.iter().map(|c| c.header.as_str()).collect(),
                rows: &table.rows,
            },
        }
    }
}

/// The report as one line of JSON, with the line's end.
#[must_use]
pub fn json(report: &Report) -> String {
    let sections = report.sections.iter().map(|section| SectionView {
        heading: &section.heading,
        blocks: section.blocks.iter().map(BlockView::of).collect(),
    });
    let view = ReportView {
        schema: SCHEMA,
        title: &report.title,
        notes: &report.notes,
        sections: sections.collect(),
    };
    // a view of texts is always written
    super::json::escaped(serde_json::to_string(&view).unwrap_or_default()) + "\n"
}

/// The report as comma-separated values: every line begins with the heading of its section, every table with its headers,
/// and an empty line separates two blocks.
#[must_use]
pub fn csv(report: &Report) -> String {
    let blocks = report.sections.iter().flat_map(|section| {
        section.blocks.iter().map(|block| {
            let line = |cells: &[&str]| {
                let cells = std::iter::once(section.heading.as_str()).chain(cells.iter().copied());
                cells.map(csv::field).collect::<Vec<_>>().join(",") + csv::LINE_END
            };
            match block {
                Block::Text(text) => line(&[text]),
                Block::List(items) => items.iter().map(|item| line(&[item])).collect(),
                Block::Facts(facts) => facts.iter().map(|(name, fact)| line(&[name, fact])).collect(),
                Block::Table(table) => {
                    let headers =
                        std::iter::once("section").chain(table.columns.iter().map(|c| c.header.as_str()));
                    let header = headers.map(csv::field).collect::<Vec<_>>().join(",") + csv::LINE_END;
                    let rows = table
                        .rows
                        .iter()
                        .map(|row| line(&row.iter().map(String::as_str).collect::<Vec<_>>()));
                    header + &rows.collect::<String>()
                }
            }
        })
    });
    blocks.collect::<Vec<_>>().join(csv::LINE_END)
}
