//! The answers of a file as comma-separated values, one position after another: none is kept.

use super::answers::{Answers, pose_header};
use super::csv::{LINE_END, field};
use super::rows::{AnswerColumns, FULL, write_text};
use super::simulation;
use assur_model::model::Value;
use assur_solve::solve::{Model, Pose, PoseOutputs};

/// A form of output with a line per position.
pub trait PoseLines: Sync {
    /// The lines before those of positions.
    fn header(&self) -> String {
        String::new()
    }
    /// Finds what is the same at all positions, at one of them if there is one.
    fn begin(&mut self, answers: &Answers<'_>, pose: Option<&Pose>);
    /// What is read of positions beside their answers.
    fn reads(&self, model: &Model<'_>) -> PoseOutputs;
    /// Adds the line of a position, once it has [begun](PoseLines::begin), with memory for its numbers; none where it only says that its
    /// accuracy was missed.
    fn add(&self, answers: &Answers<'_>, pose: &Pose, row: &mut Vec<f64>, out: &mut Vec<u8>);
    /// Adds the one line of a file without positions.
    fn add_without_pose(&self, answers: &Answers<'_>, out: &mut Vec<u8>);
}

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
}

impl PoseLines for CsvLines {
    fn header(&self) -> String {
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

    fn begin(&mut self, answers: &Answers<'_>, _: Option<&Pose>) {
        if !std::mem::replace(&mut self.begun, true) {
            self.whole = self.columns.whole(answers);
        }
    }

    fn reads(&self, model: &Model<'_>) -> PoseOutputs {
        PoseOutputs { residuals: false, angles: self.columns.reads_angles(model) }
    }

    fn add(&self, answers: &Answers<'_>, pose: &Pose, _: &mut Vec<f64>, out: &mut Vec<u8>) {
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
            let events = simulation::events_at(answers, pose);
            out.extend_from_slice(field(&events).as_bytes());
        }
        self.columns.write(answers, (Some(pose), &self.whole), (FULL, false, None), out);
        out.extend_from_slice(LINE_END.as_bytes());
    }

    fn add_without_pose(&self, answers: &Answers<'_>, out: &mut Vec<u8>) {
        out.extend_from_slice(self.file.as_deref().unwrap_or_default().as_bytes());
        self.columns.write(answers, (None, &self.columns.whole(answers)), (FULL, false, None), out);
        out.extend_from_slice(LINE_END.as_bytes());
    }
}
