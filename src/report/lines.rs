//! The answers of a file as comma-separated values, one position after another: none is kept.

use super::answers::{Answers, pose_header};
use super::csv::{LINE_END, field};
use super::rows::{AnswerColumns, FULL, write_text};
use super::simulation;
use assur_model::model::Value;
use assur_solve::solve::{Model, Pose};

#[derive(Clone, Debug)]
pub struct CsvLines {
    columns: AnswerColumns,
    /// The file's name as a cell with its comma, where every line begins with it.
    file: Option<String>,
    /// The answers that need no pose, once known.
    whole: Vec<Option<Value>>,
    begun: bool,
    /// What heads the names of poses.
    pose: String,
    /// A column says which events happen.
    events: bool,
}

impl CsvLines {
    /// For the answers of a file, whose name every line begins with if it is given.
    #[must_use]
    pub fn of(model: &Model<'_>, file: Option<&str>) -> Self {
        let cell = |file: &str| field(file).into_owned() + ",";
        Self {
            columns: AnswerColumns::of_file(model),
            file: file.map(cell),
            whole: Vec::new(),
            begun: false,
            pose: pose_header(model.mechanism),
            events: simulation::names_events(model.mechanism),
        }
    }

    #[must_use]
    pub fn header(&self) -> String {
        let mut line = if self.file.is_some() { "file," } else { "" }.to_owned();
        write_text(&self.pose, &mut line);
        if self.events {
            line.push_str(",event");
        }
        for header in self.columns.headers(false) {
            line.push(',');
            write_text(&header, &mut line);
        }
        line + LINE_END
    }

    /// Finds the answers that need no pose.
    pub fn begin(&mut self, answers: &Answers<'_>) {
        if !std::mem::replace(&mut self.begun, true) {
            self.whole = self.columns.whole(answers);
        }
    }

    /// Whether a column shows the angle of a link or of a hinge.
    #[must_use]
    pub fn reads_angles(&self, model: &Model<'_>) -> bool {
        self.columns.reads_angles(model)
    }

    /// Adds the line of a position, once it has [begun](CsvLines::begin); none where it only says that its accuracy was missed.
    pub fn add(&self, answers: &Answers<'_>, pose: &Pose, out: &mut Vec<u8>) {
        if !pose.is_position() {
            return;
        }
        out.extend_from_slice(self.file.as_deref().unwrap_or_default().as_bytes());
        if pose.name.bytes().all(|b| b.is_ascii_digit()) {
            out.extend_from_slice(pose.name.as_bytes());
        } else {
            out.extend_from_slice(field(&pose.name).as_bytes());
        }
        if self.events {
            out.push(b',');
            let events = simulation::events_at(answers, pose).unwrap_or_default();
            out.extend_from_slice(field(&events).as_bytes());
        }
        self.columns.write_beside(answers, pose, &self.whole, (FULL, None), out);
        out.extend_from_slice(LINE_END.as_bytes());
    }

    /// Adds the one line of a file without positions.
    pub fn add_without_pose(&self, answers: &Answers<'_>, out: &mut Vec<u8>) {
        let mut line = self.file.clone().unwrap_or_default();
        self.columns.write_without_pose(answers, FULL, false, &mut line);
        out.extend_from_slice((line + LINE_END).as_bytes());
    }
}
