//! Questions as PrairieLearn reads them: a folder per problem, with all rows in its `server.py`.

use super::moodle::{cut_id, sum_of, weights};
use super::page::{Shown, Template, merged, unbraced};
use super::pint::in_pint;
use super::uuid::uuid;
use super::{CourseError, Interval, Quiz, QuizGap};
use crate::handout::base64;
use assur_text::units::significant;
use assur_worked::{PicturePlace, fragment};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Digits of an answer, and of an interval.
const DIGITS: usize = 6;
const FINE: usize = 9;
const SERVER: &str = include_str!("server.py");

/// A file of a question: its name in the folder, and its bytes.
pub type Part = (String, Vec<u8>);

/// How rows become variants.
#[derive(Clone, Copy, Debug)]
pub struct PrairieLearn<'a> {
    /// The ending of pictures.
    pub ending: &'a str,
    /// The tolerance.
    pub within: f64,
}

/// A row as a variant of a question.
#[derive(Clone, Debug)]
pub struct Variant {
    shown: Vec<Shown>,
    params: Map<String, Value>,
    solution: String,
    answers: Vec<Answer>,
    pictures: Vec<Part>,
}

#[derive(Clone, Debug)]
struct Answer {
    name: String,
    /// As pint writes it; empty for a plain number.
    unit: String,
    weight: u32,
    intervals: Vec<Interval>,
}

/// What a question is called.
#[derive(Clone, Copy, Debug)]
pub struct Called<'a> {
    pub file: &'a str,
    pub title: &'a str,
    pub category: &'a str,
}

impl Called<'_> {
    /// The number of the question: a new export is the same question.
    #[must_use]
    pub fn uuid(&self) -> String {
        uuid(&format!("assur:course/{}/{}", self.category, self.file))
    }

    /// The name of its folder.
    #[must_use]
    pub fn folder(&self) -> String {
        cut_id(self.file).replace('@', "-")
    }
}

impl PrairieLearn<'_> {
    /// A row with these values, at a place in the list of rows. `encode` makes the bytes of a picture from its SVG.
    ///
    /// # Errors
    /// A picture that cannot be made, or points without whole ratios.
    pub fn variant<E: From<CourseError>>(
        &self,
        quiz: &Quiz,
        place: &str,
        encode: &dyn Fn(&str) -> Result<Vec<u8>, E>,
    ) -> Result<Variant, E> {
        let answers = answers(quiz)?;
        let asked = answers.iter().map(|answer| (answer.name.clone(), json!(1)));
        let mut params = Map::new();
        params.insert("asked".to_owned(), asked.collect());
        params.insert("title".to_owned(), json!(quiz.sheet.title));
        let mut template = Template::of(&quiz.sheet);
        let mut pictures = Vec::new();
        for (number, svg) in (1..).zip(std::mem::take(&mut template.pictures)) {
            let name = format!("{place}-{number}.{}", self.ending);
            params.insert(format!("picture_{number}"), json!(name));
            pictures.push((format!("clientFilesQuestion/{name}"), encode(&svg)?));
        }
        let named = quiz.gaps.iter().zip(&answers);
        let inputs = named.map(|(gap, it)| (gap, it.name.as_str(), it.unit.is_empty(), it.weight));
        template.ask(quiz, inputs, self.within);
        let solution = self.solution(quiz, encode)?;
        Ok(Variant { shown: template.shown, params, solution, answers, pictures })
    }

    /// The worked solution with its pictures within: what is in `clientFilesQuestion` can be read before answering.
    fn solution<E>(&self, quiz: &Quiz, encode: &dyn Fn(&str) -> Result<Vec<u8>, E>) -> Result<String, E> {
        let Some(solution) = &quiz.solution else { return Ok(String::new()) };
        let place = PicturePlace { before: "@", stem: "solution", ending: self.ending };
        let (html, pictures) = fragment(solution, place);
        let mut html = unbraced(&html);
        let kind = if self.ending == "png" { "image/png" } else { "image/svg+xml" };
        for (name, svg) in pictures {
            let bytes = base64(&encode(&svg)?);
            html = html.replace(&format!("\"@{name}\""), &format!("\"data:{kind};base64,{bytes}\""));
        }
        Ok(html)
    }
}

/// The answers with their names on the page: letters, figures and `_`.
fn answers(quiz: &Quiz) -> Result<Vec<Answer>, CourseError> {
    let mut all: Vec<Answer> = Vec::new();
    for (gap, weight) in quiz.gaps.iter().zip(weights(&quiz.gaps)?) {
        let full = full_name(gap);
        let plain = full.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
        let plain = plain.trim_matches('_');
        let is_free = !plain.is_empty() && all.iter().all(|other| other.name != plain);
        let name = if is_free { plain.to_owned() } else { format!("answer_{:08x}", sum_of(&full)) };
        let unit = in_pint(&gap.unit).unwrap_or_default();
        all.push(Answer { name, unit, weight, intervals: gap.intervals.clone() });
    }
    Ok(all)
}

fn full_name(gap: &QuizGap) -> String {
    let position = gap.gap.position.as_ref().map(|[name, _]| format!(" at {name}"));
    format!("{}{}", gap.gap.name, position.unwrap_or_default())
}

/// All files of a question; none without rows.
#[must_use]
pub fn question(called: Called<'_>, rows: &[&Variant]) -> Vec<Part> {
    if rows.is_empty() {
        return Vec::new();
    }
    let shown: Vec<&[Shown]> = rows.iter().map(|row| row.shown.as_slice()).collect();
    let (page, texts) = merged(&shown);
    let mut files = vec![
        ("info.json".to_owned(), info(called, rows.len()).into_bytes()),
        ("question.html".to_owned(), page.into_bytes()),
        ("server.py".to_owned(), server(rows, texts).into_bytes()),
    ];
    for (number, row) in (1..).zip(rows) {
        files.extend(row.pictures.iter().cloned());
        if !row.solution.is_empty() {
            files.push((solution_file(number), row.solution.clone().into_bytes()));
        }
    }
    files
}

fn solution_file(number: usize) -> String {
    format!("solutions/{number}.html")
}

fn info(called: Called<'_>, rows: usize) -> String {
    let text = |words: &str| json!(words).to_string();
    format!(
        "{{\n  \"uuid\": \"{}\",\n  \"title\": {},\n  \"topic\": {},\n  \"tags\": [\"assur\"],\n  \
         \"type\": \"v3\",\n  \"singleVariant\": {}\n}}\n",
        called.uuid(),
        text(called.title),
        text(called.category),
        rows == 1
    )
}

/// The program of a question, with the table of its rows.
fn server(rows: &[&Variant], texts: Vec<Map<String, Value>>) -> String {
    let mut words: Vec<&str> = Vec::new();
    let mut units: BTreeMap<&str, Value> = BTreeMap::new();
    let mut lines = String::new();
    for ((number, row), texts) in (1..).zip(rows).zip(texts) {
        let mut answers = Map::new();
        for answer in &row.answers {
            units.insert(&answer.name, json!([answer.unit, answer.weight]));
            answers.insert(answer.name.clone(), answer.baked(&mut words));
        }
        let solution = if row.solution.is_empty() { String::new() } else { solution_file(number) };
        let params: Map<String, Value> = row.params.clone().into_iter().chain(texts).collect();
        let line = json!({ "params": params, "solution": solution, "answers": answers });
        lines += &format!("    {line},\n");
    }
    let listed = |items: Vec<String>, [open, close]: [char; 2]| {
        let lines: String = items.iter().map(|item| format!("    {item},\n")).collect();
        format!("{open}\n{lines}{close}")
    };
    let words = listed(words.iter().map(|words| json!(words).to_string()).collect(), ['[', ']']);
    let units = listed(units.iter().map(|(name, it)| format!("{}: {it}", json!(name))).collect(), ['{', '}']);
    // the texts of a teacher come last: they may have these words
    SERVER.replacen("@WORDS@", &words, 1).replacen("@ANSWERS@", &units, 1).replacen("@ROWS@", &lines, 1)
}

impl Answer {
    /// The right answer, and the intervals.
    fn baked<'a>(&'a self, words: &mut Vec<&'a str>) -> Value {
        let fine = |x: f64| significant(x, FINE).parse::<f64>().unwrap_or(x);
        let mut intervals = Vec::new();
        for it in self.intervals.iter().filter(|it| it.middle.is_finite() && it.half.is_finite()) {
            let place = words.iter().position(|known| *known == it.words).unwrap_or(words.len());
            if place == words.len() {
                words.push(&it.words);
            }
            intervals.push(json!([fine(it.middle), fine(it.half), it.part, place]));
        }
        let right = significant(self.intervals.first().map_or(0.0, |it| it.middle), DIGITS);
        let right = match self.unit.as_str() {
            "" => json!(right.parse::<f64>().unwrap_or(0.0)),
            unit => json!(format!("{right} {unit}")),
        };
        json!([right, intervals])
    }
}
