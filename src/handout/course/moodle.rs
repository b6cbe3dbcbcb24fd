//! Questions as Moodle reads them: its XML, with gaps in one text or as numbers with units.

use super::{CourseError, Interval, Quiz, QuizGap, accepted};
use crate::exercise::grade::Credit;
use crate::handout::base64;
use assur_drawing::escaped;
use assur_text::units::significant;
use assur_worked::{Block, Document, PicturePlace, fragment, how_to_answer, inline, printed_unit};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Digits of an answer: a student sees the text.
const DIGITS: usize = 6;
/// Characters of a name and of an idnumber at the most.
const NAME: usize = 255;
const ID: usize = 100;
/// Factors that make points whole.
const MOST_TIMES: u32 = 100;
/// The parts of a mark that Moodle reads, in percent.
const PARTS: [&str; 21] = [
    "100", "90", "83.33333", "80", "75", "70", "66.66667", "60", "50", "40", "33.33333", "30", "25", "20",
    "16.66667", "14.28571", "12.5", "11.11111", "10", "5", "0",
];

/// Pictures of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Picture {
    Svg,
    Png,
    None,
}

/// What questions of a row are called.
#[derive(Clone, Copy, Debug)]
pub struct Moodle<'a> {
    /// The problem in ids.
    pub file: &'a str,
    pub title: &'a str,
    /// The row, by its name or its number.
    pub row: &'a str,
    /// The title says nothing of the row.
    pub several: bool,
    /// The position, where it was chosen.
    pub pose: Option<&'a str>,
    pub one_per_answer: bool,
    /// The part of the mark that a missing or wrong unit costs: Moodle then compares the number alone.
    pub unit_penalty: f64,
    pub picture: Picture,
}

/// A text of a question, with its files.
#[derive(Default)]
struct Part {
    html: String,
    files: String,
}

/// A question as it is written.
#[derive(Clone, Debug)]
pub struct Question {
    pub id: String,
    pub xml: String,
}

/// Questions of a problem, each with its row.
#[derive(Clone, Copy, Debug)]
pub struct Chapter<'a> {
    pub file: &'a str,
    pub title: &'a str,
    pub questions: &'a [(String, Question)],
}

/// A file of questions, each problem in its category, that is written piece by piece. Chapters of one file follow one another.
#[derive(Debug)]
pub struct Page<'a> {
    name: &'a str,
    /// The problem under way, and the ids of its questions.
    file: Option<String>,
    ids: BTreeSet<String>,
}

impl<'a> Page<'a> {
    /// Without questions, below a category.
    #[must_use]
    pub const fn new(name: &'a str) -> Self {
        Self { name, file: None, ids: BTreeSet::new() }
    }

    /// The text of more questions.
    ///
    /// # Errors
    /// Two questions of a problem have one id: Moodle would drop it without a word.
    pub fn add(&mut self, Chapter { file, title, questions }: Chapter<'_>) -> Result<String, CourseError> {
        let begin = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n";
        let mut text = if self.file.is_none() { begin.to_owned() } else { String::new() };
        if self.file.as_deref() != Some(file) {
            text += &category(self.name, title, file);
            self.ids.clear();
            self.file = Some(file.to_owned());
        }
        for (row, question) in questions {
            if !self.ids.insert(question.id.clone()) {
                return Err(CourseError::SameIdNumber { row: row.clone(), category: self.name.to_owned() });
            }
            text += &question.xml;
        }
        Ok(text)
    }

    /// What ends it; none where it has no questions.
    #[must_use]
    pub const fn end(&self) -> Option<&'static str> {
        if self.file.is_some() { Some("</quiz>\n") } else { None }
    }
}

/// A step into a category, which is made where it is not there. A stroke in a title is no step.
fn category(name: &str, title: &str, file: &str) -> String {
    let title: String = title.chars().take(NAME / 2).collect();
    let path = escaped(&format!("$course$/top/{name}/{}", title.replace('/', "//")));
    format!(
        "<question type=\"category\">\n<category><text>{path}</text></category>\n\
         <info format=\"html\"><text></text></info>\n<idnumber>{}</idnumber>\n</question>\n",
        cut_id(&format!("assur-{file}"))
    )
}

/// Parts of marks that Moodle would refuse.
///
/// # Errors
/// The first of them, with the nearest that is allowed.
pub fn checked_credit(credit: &Credit) -> Result<(), CourseError> {
    // these slips come with the other sign too, and then get the product
    const SIGNED: [&str; 5] = ["unit", "weight", "decimal-point", "half", "other-quantity"];
    let parts: Vec<(&str, f64)> = credit.parts().collect();
    let sign = parts.iter().find(|(name, _)| *name == "sign").map_or(0.0, |(_, part)| *part);
    for (name, part) in &parts {
        if percent(*part).is_none() {
            let distance = |x: &f64| (x - 100.0 * part).abs();
            let listed = PARTS.iter().filter_map(|text| text.parse::<f64>().ok());
            let near = listed.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0.0) / 100.0;
            let help = format!("--credit {name}={}", significant(near, 7));
            return Err(CourseError::PartNotAllowed { part: *part, help });
        }
        let product = part * sign;
        if SIGNED.contains(name) && percent(product).is_none() {
            let help =
                format!("`sign` and `{name}` together get the product, as in --credit sign=0.5,{name}=0.5");
            return Err(CourseError::PartNotAllowed { part: product, help });
        }
    }
    Ok(())
}

/// A part of a mark in percent, as Moodle lists it.
fn percent(part: f64) -> Option<&'static str> {
    let is = |text: &&&str| text.parse::<f64>().is_ok_and(|x| (x - 100.0 * part).abs() < 1e-4);
    PARTS.iter().find(is).copied()
}

/// Letters, figures, `-` and `@`; a long text ends in a sum of what is left out.
pub(super) fn cut_id(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_alphanumeric() || c == '@' { c } else { '-' }).collect();
    if plain.chars().count() <= ID {
        return plain;
    }
    let (kept, rest) = plain.split_at(plain.char_indices().nth(ID - 9).map_or(0, |(at, _)| at));
    format!("{kept}-{:08x}", sum_of(rest))
}

/// FNV-1a, 32 bits.
pub(super) fn sum_of(text: &str) -> u32 {
    text.bytes().fold(0x811c_9dc5, |sum, byte| (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

impl Moodle<'_> {
    /// The questions of a row: one with gaps, or one per answer. `encode` makes the bytes of a picture from its SVG.
    ///
    /// # Errors
    /// A picture that cannot be made, or points that Moodle cannot have.
    pub fn questions<E: From<CourseError>>(
        &self,
        quiz: &Quiz,
        encode: &dyn Fn(&str) -> Result<Vec<u8>, E>,
    ) -> Result<Vec<Question>, E> {
        let stem = cut_id(&format!("{}-{}", self.file, self.row)).replace('@', "-");
        let solution = match &quiz.solution {
            Some(solution) => self.part(solution, &format!("{stem}-solution"), encode)?,
            None => Part::default(),
        };
        let mut sheet = self.part(&quiz.sheet, &stem, encode)?;
        if !self.one_per_answer {
            sheet.html = without_braces(&sheet.html) + &gaps(quiz)?;
            return Ok(vec![self.question("cloze", "", [&sheet, &solution], None)]);
        }
        let mut all: Vec<Question> = Vec::new();
        for gap in &quiz.gaps {
            let how = how_to_answer(quiz.language, !gap.unit.text.is_empty());
            sheet.html = self.html(&asking(quiz, gap), &stem).0 + &format!("<p>{}</p>", escaped(&how));
            let mut question = self.question(
                "numerical",
                &numerical(quiz, gap, self.unit_penalty),
                [&sheet, &solution],
                Some(gap),
            );
            if all.iter().any(|other| other.id == question.id) {
                // names that differ in signs alone
                let apart = cut_id(&format!("{}-{:08x}", question.id, sum_of(&gap.gap.name)));
                question.xml = question.xml.replace(&id_line(&question.id), &id_line(&apart));
                question.id = apart;
            }
            all.push(question);
        }
        Ok(all)
    }

    /// A document, and its pictures by their names.
    fn html(&self, document: &Document, stem: &str) -> (String, Vec<(String, String)>) {
        let ending = if self.picture == Picture::Png { "png" } else { "svg" };
        fragment(document, PicturePlace { before: "@@PLUGINFILE@@/", stem, ending })
    }

    fn part<E>(
        &self,
        document: &Document,
        stem: &str,
        encode: &dyn Fn(&str) -> Result<Vec<u8>, E>,
    ) -> Result<Part, E> {
        let (html, pictures) = self.html(document, stem);
        let mut files = String::new();
        for (name, svg) in pictures {
            let bytes = base64(&encode(&svg)?);
            let _ = writeln!(files, "<file name=\"{name}\" path=\"/\" encoding=\"base64\">{bytes}</file>");
        }
        Ok(Part { html, files })
    }

    fn question(
        &self,
        kind: &str,
        answer: &str,
        [sheet, solution]: [&Part; 2],
        gap: Option<&QuizGap>,
    ) -> Question {
        let name = gap.map(|gap| gap.gap.name.as_str());
        let position = gap.and_then(|gap| gap.gap.position.as_ref());
        let pose = position.map(|[name, _]| name.as_str()).or(self.pose);
        let row = if self.several { format!(", {}", self.row) } else { String::new() };
        let of = name.map_or_else(String::new, |name| format!(": {name}"));
        let at = pose.map_or_else(String::new, |pose| format!(" ({pose})"));
        let rest = format!("{row}{of}{at}");
        let room = NAME.saturating_sub(rest.chars().count());
        let title: String = self.title.chars().take(room).chain(rest.chars()).take(NAME).collect();
        let mut id = format!("assur-{}-{}", self.file, self.row);
        id += &name.map_or_else(String::new, |name| format!("-{name}"));
        id += &pose.map_or_else(String::new, |pose| format!("@{pose}"));
        let id = cut_id(&id);
        let xml = format!(
            "<question type=\"{kind}\">\n<name><text>{}</text></name>\n\
             <questiontext format=\"html\"><text>{}</text>\n{}</questiontext>\n\
             <generalfeedback format=\"html\"><text>{}</text>\n{}</generalfeedback>\n\
             <penalty>0.3333333</penalty>\n<hidden>0</hidden>\n{}{answer}</question>\n",
            escaped(&title),
            cdata(&sheet.html),
            sheet.files,
            cdata(&solution.html),
            solution.files,
            id_line(&id),
        );
        Question { id, xml }
    }
}

fn id_line(id: &str) -> String {
    format!("<idnumber>{id}</idnumber>\n")
}

/// All gaps with their letters and units, then how a number is written.
fn gaps(quiz: &Quiz) -> Result<String, CourseError> {
    let weights = weights(&quiz.gaps)?;
    let mut out = String::new();
    let mut position = None;
    for (gap, weight) in quiz.gaps.iter().zip(weights) {
        if gap.gap.position != position {
            position.clone_from(&gap.gap.position);
            let words = position.as_ref().map_or("", |[_, words]| words.as_str());
            let _ = writeln!(out, "<h5>{}</h5>", without_braces(&escaped(words)));
        }
        let letters = without_braces(&inline(&gap.gap.letters));
        let unit = without_braces(&escaped(&printed_unit(&quiz.language.unit(&gap.unit.text))));
        let answers: Vec<String> = gap.intervals.iter().map(in_gap).collect();
        let _ = writeln!(out, "<p>{letters} = {{{weight}:NM:{}}}{unit}</p>", answers.join("~"));
    }
    let _ = write!(out, "<p>{}</p>", escaped(&how_to_answer(quiz.language, false)));
    Ok(out)
}

/// `%0%9.81:0.294#Twice the value.`
fn in_gap(interval: &Interval) -> String {
    let part = match percent(interval.part) {
        Some("100") => "=".to_owned(),
        part => format!("%{}%", part.unwrap_or("0")),
    };
    let [middle, half] = [interval.middle, interval.half].map(|x| significant(x, DIGITS));
    // what is said is decoded once more, and ends at some signs
    let mut words = String::new();
    for c in escaped(&escaped(&interval.words)).chars() {
        match c {
            '~' | '{' | '}' | '\\' => words += &format!("&#{};", u32::from(c)),
            c => words.push(c),
        }
    }
    format!("{part}{middle}:{half}#{words}")
}

/// Points as whole numbers, all times the least factor that makes them so.
pub(super) fn weights(gaps: &[QuizGap]) -> Result<Vec<u32>, CourseError> {
    let whole = |x: f64| {
        let near = x.round();
        let is = (x - near).abs() <= 1e-9 * near && (1.0..=1e6).contains(&near);
        is.then_some(near as u32)
    };
    let times = |n: u32| gaps.iter().map(|gap| whole(gap.points * f64::from(n))).collect::<Option<Vec<_>>>();
    (1..=MOST_TIMES).find_map(times).ok_or_else(|| {
        let points: Vec<String> = gaps.iter().map(|gap| significant(gap.points, DIGITS)).collect();
        CourseError::PointsNotWhole { points: points.join(", ") }
    })
}

/// The sheet with one question in place of the list of all.
fn asking(quiz: &Quiz, gap: &QuizGap) -> Document {
    let mut document = quiz.sheet.clone();
    let items = match document.blocks.pop() {
        Some(Block::List(items)) => items,
        block => {
            document.blocks.extend(block);
            Vec::new()
        }
    };
    document.blocks.extend(gap.gap.position.iter().map(|[_, words]| Block::Heading(3, words.clone())));
    let question = gap.gap.question.and_then(|i| items.get(i));
    document.blocks.extend(question.map(|line| Block::Paragraph(line.clone())));
    if question.is_none() || gap.gap.name.ends_with(".x") || gap.gap.name.ends_with(".y") {
        document.blocks.push(Block::Paragraph(gap.gap.letters.clone()));
    }
    document
}

/// The answers of a number with its units.
fn numerical(quiz: &Quiz, gap: &QuizGap, unit_penalty: f64) -> String {
    let mut out = format!("<defaultgrade>{}</defaultgrade>\n", significant(gap.points, DIGITS));
    for interval in &gap.intervals {
        let part = percent(interval.part).unwrap_or("0");
        let [middle, half] = [interval.middle, interval.half].map(|x| significant(x, DIGITS));
        // a feedback is HTML in XML
        let words = escaped(&escaped(&interval.words));
        let _ = writeln!(
            out,
            "<answer fraction=\"{part}\" format=\"moodle_auto_format\"><text>{middle}</text>\
             <feedback format=\"html\"><text>{words}</text></feedback><tolerance>{half}</tolerance></answer>"
        );
    }
    let units = accepted(&gap.unit, &gap.units, quiz.language);
    if units.is_empty() {
        return out + "<unitgradingtype>0</unitgradingtype>\n<showunits>3</showunits>\n";
    }
    out += "<units>\n";
    for (name, multiplier) in units {
        let name = escaped(&name);
        let _ =
            writeln!(out, "<unit><multiplier>{multiplier}</multiplier><unit_name>{name}</unit_name></unit>");
    }
    let _ = write!(
        out,
        "</units>\n<unitgradingtype>1</unitgradingtype>\n<unitpenalty>{}</unitpenalty>\n\
         <showunits>0</showunits>\n<unitsleft>0</unitsleft>\n",
        significant(unit_penalty, DIGITS)
    );
    out
}

/// Braces of a text are none of a gap.
fn without_braces(html: &str) -> String {
    html.replace('{', "&#123;").replace('}', "&#125;")
}

fn cdata(html: &str) -> String {
    format!("<![CDATA[{}]]>", html.replace("]]>", "]]]]><![CDATA[>"))
}
