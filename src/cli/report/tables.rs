//! What a solution has beside the position that is worked out: all positions, quantities of the cycle, cams, gears, flywheels,
//! expectations, as tables and plots.

use crate::pipeline::Solved;
use crate::report::document::{Align, Block as Printed, Section, Table as Rows};
use crate::report::{self, AccuracyShown, Precision};
use assur_drawing::Theme;
use assur_picture::{Kind, Options, Scene, draw};
use assur_text::source::Source;
use assur_worked::{Block, Figure, Inline, Language, Table, drawing_in, localised};

/// The most rows of a table that are printed; of longer ones some over all of it.
const ROWS: usize = 37;
/// Pictures of a sweep.
const PICTURES: [Kind; 4] = [Kind::Plot, Kind::Work, Kind::Cam, Kind::Train];

/// The sections, for behind the last of a solution; all of them where no position is worked out.
pub fn blocks(source: &Source, solved: &Solved, scene: Option<&Scene<'_>>, language: Language) -> Vec<Block> {
    let report = report::of_answers(&source.name, &solved.answers(Precision::READABLE), AccuracyShown::Worst);
    let one = solved.solution.poses.len() == 1;
    let kept = |section: &&Section| {
        let heading = section.heading.as_str();
        let of_position = ["Answers", "Reactions", "Friction"].iter().any(|h| heading.starts_with(h));
        let repeated = heading.starts_with("Structure") || heading.starts_with("Accuracy");
        scene.is_none() || !(repeated || one && of_position)
    };
    let mut blocks: Vec<Block> = report.sections.iter().filter(kept).flat_map(|s| section(s, ROWS)).collect();
    let published = super::published::section(&solved.outcomes);
    blocks.extend(published.iter().flat_map(|s| section(s, usize::MAX)));
    let mut blocks = localised(language, blocks);
    for picture in scene.into_iter().flat_map(|scene| PICTURES.map(|kind| pictures(scene, kind, language))) {
        if !picture.is_empty() {
            blocks.push(Block::Figures(picture));
        }
    }
    blocks
}

fn section(section: &Section, most: usize) -> Vec<Block> {
    let text = |words: &str| vec![Inline::Text(words.to_owned())];
    let mut blocks = vec![Block::Heading(3, section.heading.clone())];
    for block in &section.blocks {
        match block {
            Printed::Text(words) => blocks.push(Block::Paragraph(text(words))),
            Printed::List(items) => blocks.extend(items.iter().map(|item| Block::Paragraph(text(item)))),
            Printed::Facts(facts) => {
                blocks.extend(
                    facts.iter().map(|(name, fact)| Block::Paragraph(text(&format!("{name}: {fact}")))),
                );
            }
            Printed::Table(rows) => blocks.push(Block::Table(table(rows, most))),
        }
    }
    blocks
}

fn table(rows: &Rows, most: usize) -> Table {
    let text = |words: &String| vec![Inline::Text(words.replace('-', "−"))];
    let plain = |words: &String| vec![Inline::Text(words.clone())];
    let numbers = rows.columns.iter().enumerate().filter(|(_, c)| c.align != Align::Left).map(|(i, _)| i);
    let numbers: Vec<usize> = numbers.collect();
    let step = rows.rows.len().div_ceil(most).max(1);
    let cells = |row: &Vec<String>| {
        row.iter().enumerate().map(|(i, c)| if numbers.contains(&i) { text(c) } else { plain(c) }).collect()
    };
    Table {
        headers: rows.columns.iter().map(|c| plain(&c.header)).collect(),
        rows: rows.rows.iter().step_by(step).map(cells).collect(),
        numbers,
    }
}

fn pictures(scene: &Scene<'_>, kind: Kind, language: Language) -> Vec<Figure> {
    let drawings = draw(kind, scene, &Options::default()).unwrap_or_default().into_iter();
    let figure = |drawing: assur_drawing::Drawing| {
        let drawing = drawing_in(language, scene.mechanism(), drawing);
        let (name, caption) = (kind.name().to_owned(), drawing.title.clone());
        Figure { svg: drawing.placed().svg(Theme::Auto), name, caption }
    };
    drawings.map(figure).collect()
}
