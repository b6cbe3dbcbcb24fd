//! The five tools. A text with errors is a result: the tool worked.

use super::limits::Alarm;
use crate::editor::solve_while;
use crate::handout::{Pictured, json, json_of_row};
use crate::pipeline::{self, Compiled, FileVariants, Solved, compile_document, is_long};
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_picture::{KINDS, Kind};
use assur_syntax as syntax;
use assur_text::diagnostic::{Problems, did_you_mean};
use assur_text::language::{FUNCTIONS, UNITS, WORDS};
use assur_text::source::{Source, edited};
use assur_text::units::significant;
use assur_worked::Language;
use serde_json::{Map, Value, json};
use std::sync::Arc;

/// The most bytes of a text, of rows and of positions in an answer, of SVG.
const LONGEST_TEXT: usize = 256 << 10;
const ROWS: u64 = 100;
const POSES: usize = 50;
const LONGEST_SVG: usize = 200 << 10;
/// Pixels of a picture across.
#[cfg(feature = "png")]
const WIDTH: u32 = 900;
/// What messages call the text.
const NAME: &str = "text.mech";

/// A tool with its sentence and its arguments.
struct Tool {
    name: &'static str,
    about: &'static str,
    properties: fn() -> Value,
    required: &'static [&'static str],
    run: fn(&Map<String, Value>, &Alarm) -> Result<Answer, String>,
}

/// What a tool answers: its text, what else there is, the same as data.
struct Answer {
    content: Vec<Value>,
    data: Option<Value>,
}

const TOOLS: [Tool; 5] = [
    Tool {
        name: "check",
        about: "Names, units and structure of a .mech text, with fixes. Call it after every change.",
        properties: || json!({ "text": text(), "fix": { "type": "boolean", "default": false, "description": "Return the text after its certain fixes" } }),
        required: &["text"],
        run: check,
    },
    Tool {
        name: "solve",
        about: "Answers of a .mech text as JSON (assur.solution/1, SI and radians): positions, velocities, forces, what `find` asks.",
        properties: || {
            json!({
                "text": text(),
                "set": { "type": "object", "additionalProperties": { "type": "string" }, "description": "Values of `given` statements with their units" },
                "pose": { "type": "string", "description": "The name of the one position wanted" },
                "rows": { "type": "integer", "minimum": 1, "maximum": ROWS, "description": "How many rows of the table of variants" },
            })
        },
        required: &["text"],
        run: solve,
    },
    Tool {
        name: "draw",
        about: "Pictures of a .mech text, with their descriptions in words.",
        properties: || {
            let kinds: Vec<&str> = kinds().map(Kind::name).collect();
            json!({
                "text": text(),
                "pictures": { "type": "array", "items": { "type": "string", "enum": kinds }, "description": "Without it the first that the text has: mostly the scheme" },
                "pose": { "type": "string", "description": "The name of a position" },
                "format": { "type": "string", "enum": ["svg", "png"], "default": "svg" },
            })
        },
        required: &["text"],
        run: draw,
    },
    Tool {
        name: "explain",
        about: "The page of a diagnostic's code, or what a word of the language is: a statement, a function, a unit.",
        properties: || json!({ "code": { "type": "string", "description": "mech::name::unknown" }, "word": { "type": "string", "description": "assemble, velocity, rpm" } }),
        required: &[],
        run: about,
    },
    Tool {
        name: "format",
        about: "A .mech text in the one style.",
        properties: || json!({ "text": text() }),
        required: &["text"],
        run: format,
    },
];

fn text() -> Value {
    json!({ "type": "string", "description": "The whole .mech text, at most 256 kB" })
}

/// Pictures that stand still.
fn kinds() -> impl Iterator<Item = Kind> {
    KINDS.into_iter().filter(|kind| *kind != Kind::Animation)
}

/// The tools as the protocol lists them.
pub fn list() -> Vec<Value> {
    let one = |tool: &Tool| {
        json!({
            "name": tool.name,
            "description": tool.about,
            "inputSchema": {
                "type": "object", "properties": (tool.properties)(), "required": tool.required, "additionalProperties": false,
            },
            "annotations": { "readOnlyHint": true, "idempotentHint": true, "openWorldHint": false },
        })
    };
    TOOLS.iter().map(one).collect()
}

/// Calls a tool; `Err` where the call cannot be read.
pub fn call(params: &Value, alarm: &Alarm) -> Result<Value, String> {
    let name = params.get("name").and_then(Value::as_str).unwrap_or_default();
    let Some(tool) = TOOLS.iter().find(|tool| tool.name == name) else {
        let near = did_you_mean(name, TOOLS.iter().map(|tool| tool.name));
        let names = TOOLS.map(|tool| tool.name).join(", ");
        let help = near
            .first()
            .map_or_else(|| format!("the tools are {names}"), |near| format!("did you mean `{near}`?"));
        return Err(format!("there is no tool `{name}`; {help}"));
    };
    let none = Map::new();
    let arguments = params.get("arguments").and_then(Value::as_object).unwrap_or(&none);
    Ok(match readable(tool, arguments).and_then(|()| (tool.run)(arguments, alarm)) {
        Ok(Answer { content, data: Some(data) }) => {
            json!({ "content": content, "structuredContent": data, "isError": false })
        }
        Ok(Answer { content, data: None }) => json!({ "content": content, "isError": false }),
        Err(why) => json!({ "content": [said(&why)], "isError": true }),
    })
}

/// Whether a call has what the tool takes, and nothing else.
fn readable(tool: &Tool, arguments: &Map<String, Value>) -> Result<(), String> {
    let properties = (tool.properties)();
    let known: Vec<&str> =
        properties.as_object().into_iter().flat_map(|all| all.keys()).map(String::as_str).collect();
    if let Some(other) = arguments.keys().find(|name| !known.contains(&name.as_str())) {
        return Err(format!("`{}` has no argument `{other}`: it has {}", tool.name, known.join(", ")));
    }
    if let Some(missing) = tool.required.iter().find(|name| !arguments.contains_key(**name)) {
        return Err(format!("`{}` needs the argument `{missing}`", tool.name));
    }
    for (name, value) in arguments {
        let wanted = properties[name]["type"].as_str().unwrap_or_default();
        let fits = match wanted {
            "string" => value.is_string(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_u64(),
            "array" => value.as_array().is_some_and(|all| all.iter().all(Value::is_string)),
            _ => value.as_object().is_some_and(|all| all.values().all(Value::is_string)),
        };
        if !fits {
            return Err(format!("the argument `{name}` of `{}` must be of the type {wanted}", tool.name));
        }
    }
    match arguments.get("text").and_then(Value::as_str) {
        Some(text) if text.len() > LONGEST_TEXT => {
            Err(format!("the text has {} bytes: at most {LONGEST_TEXT} are taken", text.len()))
        }
        _ => Ok(()),
    }
}

fn said(words: &str) -> Value {
    json!({ "type": "text", "text": words })
}

fn word<'a>(arguments: &'a Map<String, Value>, name: &str) -> Option<&'a str> {
    arguments.get(name).and_then(Value::as_str)
}

fn source(arguments: &Map<String, Value>) -> Source {
    Source::new(NAME, word(arguments, "text").unwrap_or_default())
}

/// What a call answers that has taken too long.
pub(super) fn too_long() -> String {
    "this takes longer than 5 s here: ask for fewer positions, or use `assur solve FILE`, which has no limit"
        .to_owned()
}

/// A line of JSON as an answer.
fn data(line: &str) -> Result<Answer, String> {
    let data: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
    Ok(Answer { content: vec![said(line.trim_end())], data: Some(data) })
}

fn check(arguments: &Map<String, Value>, _: &Alarm) -> Result<Answer, String> {
    let mut source = source(arguments);
    let mut fixed = None;
    if arguments.get("fix") == Some(&Value::Bool(true)) {
        let (new, count) = pipeline::fixed(&source, &Overrides::none());
        if count > 0 {
            fixed = Some((new.text.clone(), count));
            source = new;
        }
    }
    let (compiled, problems) = pipeline::look_at(&source, &Overrides::none());
    let mut answer = data(&json(&source, Err(compiled.as_ref()), &problems))?;
    if let (Some((text, count)), Some(Value::Object(data))) = (fixed, &mut answer.data) {
        data.insert("fixes".to_owned(), count.into());
        data.insert("text".to_owned(), text.into());
        answer.content = vec![said(&Value::Object(data.clone()).to_string())];
    }
    Ok(answer)
}

fn solve(arguments: &Map<String, Value>, alarm: &Alarm) -> Result<Answer, String> {
    let source = source(arguments);
    let set = arguments.get("set").and_then(Value::as_object).into_iter().flatten();
    let set = set.filter_map(|(name, value)| Some((name.clone(), value.as_str()?.to_owned())));
    let overrides = Overrides::set(set.collect());
    let (document, found) = syntax::parse(&source);
    let document = Arc::new(document);
    let rows = arguments.get("rows").and_then(Value::as_u64);
    if let (Some(rows), false) = (rows, found.has_errors()) {
        if rows == 0 || rows > ROWS {
            return Err(format!("`rows` must be from 1 to {ROWS}"));
        }
        return rows_of(&source, &document, &overrides, rows, alarm);
    }
    let (compiled, mut problems) = compile_document(&source, &document, found, &overrides);
    let solved = match compiled {
        Some(compiled) if !problems.has_errors() => {
            let (solved, found) = patiently(compiled, alarm)?;
            problems.append(found);
            solved.map_err(Some)
        }
        compiled => Err(compiled),
    };
    let mut answer: Value =
        serde_json::from_str(&json(&source, solved.as_ref().map_err(Option::as_ref), &problems))
            .map_err(|error| error.to_string())?;
    kept_poses(&mut answer, word(arguments, "pose"))?;
    Ok(Answer { content: vec![said(&answer.to_string())], data: Some(answer) })
}

/// Solves as long as the alarm lets it.
fn patiently(compiled: Compiled, alarm: &Alarm) -> Result<(Result<Solved, Compiled>, Problems), String> {
    if is_long(&compiled.model()) {
        return Err(too_long());
    }
    let solved = solve_while(compiled, &|| alarm.goes_on());
    if alarm.goes_on() { Ok(solved) } else { Err(too_long()) }
}

fn rows_of(
    source: &Source,
    document: &Arc<syntax::document::Document>,
    overrides: &Overrides,
    rows: u64,
    alarm: &Alarm,
) -> Result<Answer, String> {
    let Some(table) = FileVariants::of(document, overrides) else {
        return Err("the text has no table of variants: leave `rows` out".to_owned());
    };
    let table = match table {
        Ok(table) => table,
        Err(problems) => return data(&json(source, Err(None), &problems)),
    };
    let mut all = Vec::new();
    for row in table.solve(false) {
        if !alarm.goes_on() {
            return Err(too_long());
        }
        let mut line: Value =
            serde_json::from_str(&json_of_row(source, &row)).map_err(|error| error.to_string())?;
        kept_poses(&mut line, None)?;
        all.push(line);
        if all.len() as u64 == rows {
            break;
        }
    }
    let answer = json!({ "rows": all });
    Ok(Answer { content: vec![said(&answer.to_string())], data: Some(answer) })
}

/// The position that is asked for, or the first ones with the count of the rest.
fn kept_poses(answer: &mut Value, pose: Option<&str>) -> Result<(), String> {
    let Some(poses) = answer.get_mut("poses").and_then(Value::as_array_mut) else { return Ok(()) };
    if let Some(wanted) = pose {
        let name = |pose: &Value| pose["name"].as_str().unwrap_or_default().to_owned();
        let names: Vec<String> = poses.iter().map(name).collect();
        poses.retain(|pose| pose["name"] == wanted);
        if poses.is_empty() {
            let near = did_you_mean(wanted, names.iter().map(String::as_str));
            let help = near.first().map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            return Err(format!("no position is named `{wanted}`{help}"));
        }
    }
    let rest = poses.len().saturating_sub(POSES);
    poses.truncate(POSES);
    if let (true, Some(answer)) = (rest > 0, answer.as_object_mut()) {
        answer.insert("poses_left_out".to_owned(), rest.into());
    }
    Ok(())
}

fn draw(arguments: &Map<String, Value>, alarm: &Alarm) -> Result<Answer, String> {
    let source = source(arguments);
    let pixels = word(arguments, "format") == Some("png");
    let wanted = arguments.get("pictures").and_then(Value::as_array);
    let mut chosen: Vec<Kind> = Vec::new();
    for name in wanted.into_iter().flatten().filter_map(Value::as_str) {
        let Some(kind) = kinds().find(|kind| kind.name() == name) else {
            let near = did_you_mean(name, kinds().map(Kind::name));
            let help = near.first().map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            return Err(format!("there is no picture `{name}`{help}"));
        };
        chosen.push(kind);
    }
    let overrides = Overrides::none();
    let (document, found) = syntax::parse(&source);
    let document = Arc::new(document);
    let (compiled, problems) = compile_document(&source, &document, found.clone(), &overrides);
    match &compiled {
        Some(compiled) if is_long(&compiled.model()) => return Err(too_long()),
        Some(_) if !problems.has_errors() => {}
        _ => return data(&json(&source, Err(compiled.as_ref()), &problems)),
    }
    let theme = if pixels { Theme::Light } else { Theme::Auto };
    let pictured = Pictured {
        source: &source,
        document: &document,
        overrides: &overrides,
        language: Language::English,
        theme,
    };
    let (solved, mut problems) = pictured.solved(found, &chosen);
    let Some(solved) = solved else { return data(&json(&source, Err(compiled.as_ref()), &problems)) };
    if chosen.is_empty() {
        chosen.push(pictured.first_kind(&solved));
    }
    let mut content = Vec::new();
    for kind in chosen {
        if !alarm.goes_on() {
            return Err(too_long());
        }
        match pictured.drawn(&solved, kind, word(arguments, "pose")) {
            Ok(drawn) => {
                for svg in drawn {
                    content.extend(described(&svg));
                    content.push(picture(svg, pixels)?);
                }
            }
            Err(missing) => problems.push(missing),
        }
    }
    let found = problems.views(&source);
    if !found.is_empty() {
        content.push(said(&json!({ "diagnostics": found }).to_string()));
    }
    Ok(Answer { content, data: None })
}

/// Title and description of a picture, for who does not see it.
fn described(svg: &str) -> Option<Value> {
    let inside = |name: &str| {
        let (_, rest) = svg.split_once(&format!("<{name} "))?;
        let (_, rest) = rest.split_once('>')?;
        Some(rest.split_once("</")?.0)
    };
    let words = [inside("title")?, inside("desc").unwrap_or_default()].join("\n");
    let plain = words.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
    Some(said(plain.trim()))
}

fn picture(svg: String, pixels: bool) -> Result<Value, String> {
    if pixels {
        return pixels_of(&svg);
    }
    if svg.len() > LONGEST_SVG {
        return Ok(said("the picture is larger than 200 kB: ask for `png`, or use `assur draw`"));
    }
    Ok(said(&svg))
}

#[cfg(feature = "png")]
fn pixels_of(svg: &str) -> Result<Value, String> {
    let bytes = crate::cli::draw::png_of_width(svg, WIDTH).map_err(|error| error.to_string())?;
    Ok(json!({ "type": "image", "mimeType": "image/png", "data": crate::handout::base64(&bytes) }))
}

#[cfg(not(feature = "png"))]
fn pixels_of(_: &str) -> Result<Value, String> {
    Err("this build draws no PNG: ask for `svg`, or use a build with the feature `png`".to_owned())
}

fn about(arguments: &Map<String, Value>, _: &Alarm) -> Result<Answer, String> {
    let page = match (word(arguments, "code"), word(arguments, "word")) {
        (Some(code), _) => match crate::explain(code) {
            Ok(page) => page.trim_end().to_owned(),
            Err(near) => {
                let help = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
                return Err(format!("there is no code `{code}`{help}"));
            }
        },
        (None, Some(word)) => of_word(word)?,
        (None, None) => return Err("`explain` needs `code` or `word`".to_owned()),
    };
    Ok(Answer { content: vec![said(&page)], data: None })
}

/// What a word of the language is.
fn of_word(word: &str) -> Result<String, String> {
    let mut out = String::new();
    for row in WORDS.iter().flat_map(|(_, words)| words.iter()).filter(|row| row.word == word) {
        out += &format!("`{word}`: {}", row.means);
        if !row.example.is_empty() {
            out += &format!("\n\n```mech\n{}\n```", row.example);
        }
        out += "\n\n";
    }
    for row in FUNCTIONS.iter().filter(|row| row.name == word) {
        for form in row.forms {
            let takes: Vec<String> = form.takes.iter().map(ToString::to_string).collect();
            out += &format!("`{word}({})` gives {}: {}\n\n", takes.join(", "), form.gives, form.means);
        }
    }
    for unit in UNITS.iter().filter(|unit| unit.text == word) {
        let si = unit.dimension.si_text();
        out += &format!("`{word}`: a unit of {}, {} {si}\n\n", unit.dimension, significant(unit.factor, 10));
    }
    if out.is_empty() {
        let known = WORDS.iter().flat_map(|(_, words)| words.iter().map(|row| row.word));
        let known =
            known.chain(FUNCTIONS.iter().map(|row| row.name)).chain(UNITS.iter().map(|unit| unit.text));
        let near = did_you_mean(word, known);
        let help = near.first().map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
        return Err(format!("the language has no word `{word}`{help}"));
    }
    Ok(out.trim_end().to_owned())
}

fn format(arguments: &Map<String, Value>, _: &Alarm) -> Result<Answer, String> {
    let source = source(arguments);
    match assur_format::edits(&source) {
        Ok(edits) => {
            let text = edited(&source.text, &edits);
            Ok(Answer { content: vec![said(&text)], data: Some(json!({ "text": text })) })
        }
        Err(problems) => data(&json(&source, Err(None), &problems)),
    }
}
