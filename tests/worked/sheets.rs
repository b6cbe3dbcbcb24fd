//! Sheets of all examples and rows have no answer in them; keys have them all, and are marked as right by themselves.

use crate::examples::{Example, examples};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// A folder that is removed again.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("assur-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn at(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    /// The text of a file that may be there, which is taken away.
    fn take(&self, name: &str) -> Option<String> {
        let text = std::fs::read_to_string(self.0.join(name)).ok();
        let _ = std::fs::remove_file(self.0.join(name));
        text
    }
}

impl Folder {
    /// The text of the first file that begins so, which is taken away.
    fn take_first(&self, begins: &[String]) -> Option<String> {
        let all = std::fs::read_dir(&self.0).ok()?.flatten();
        let mut names = all.map(|entry| entry.file_name().to_string_lossy().into_owned());
        let name = names.find(|name| begins.iter().any(|begin| name.starts_with(begin)))?;
        self.take(&name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn assur(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur")).args(words).output().expect("the program runs")
}

fn path(example: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(example).display().to_string()
}

/// What a reader finds in a page: its text with titles and descriptions, comments, and attributes that are words.
fn read(page: &str) -> String {
    let (mut found, mut rest) = (String::new(), page);
    while let Some(at) = rest.find('<') {
        found.push_str(&rest[..at]);
        found.push(' ');
        rest = &rest[at..];
        let end = match rest {
            r if r.starts_with("<style") => r.find("</style>"),
            r if r.starts_with("<!--") => r.find("-->").inspect(|end| found.push_str(&r[4..*end])),
            r => r.find('>').inspect(|end| found.push_str(&words_of(&r[..*end]))),
        };
        rest = &rest[end.map_or(rest.len(), |end| end + 1)..];
    }
    found + rest
}

/// The attributes of a tag that are words and not coordinates.
fn words_of(tag: &str) -> String {
    let mut words = String::new();
    for (name, after) in tag.match_indices("=\"").map(|(at, _)| (&tag[..at], &tag[at + 2..])) {
        let name = name.rsplit(' ').next().unwrap_or_default();
        if name.starts_with("data-") || matches!(name, "aria-label" | "alt" | "title" | "id" | "class") {
            words += after.split('"').next().unwrap_or_default();
            words.push(' ');
        }
    }
    words
}

fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    words.filter_map(|w| w.trim_matches('.').parse().ok()).collect()
}

/// A key: its headers, and its lines.
fn key_of(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let cells = |line: &str| {
        let (mut cells, mut quoted) = (vec![String::new()], false);
        for c in line.chars() {
            match c {
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                c => cells.last_mut().expect("a cell").push(c),
            }
        }
        cells
    };
    let mut lines = csv.lines().map(cells);
    (lines.next().unwrap_or_default(), lines.collect())
}

/// The answers of a file: header and value of each line of a row.
fn answers(csv: &str, row: usize) -> Vec<(String, f64)> {
    let (headers, lines) = key_of(csv);
    let own = lines.iter().filter(|line| line.first().is_some_and(|first| *first == row.to_string()));
    let pairs = own.flat_map(|line| headers.iter().zip(line).filter(|(header, _)| is_quantity(header)));
    pairs.filter_map(|(header, cell)| Some((header.clone(), cell.parse().ok()?))).collect()
}

fn is_quantity(header: &str) -> bool {
    !matches!(header, "row" | "pose" | "variant" | "time" | "file") && !header.starts_with("time [")
}

/// Whether a number says more than that it is round: scales and much else are.
fn is_telling(value: f64) -> bool {
    let figures = format!("{:.6e}", value.abs());
    value != 0.0 && figures.split('e').next().unwrap_or_default().trim_end_matches('0').len() >= 5
}

/// Whether a position is asked for that the text does not give: a motion under loads begins where it says.
fn asks_for_positions(text: &str) -> bool {
    let finds = text.lines().filter(|line| line.trim_start().starts_with("find "));
    let asks = |line: &str| {
        let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '('));
        words.any(|w| ["position(", "angle(", "displacement("].iter().any(|f| w.starts_with(f)))
    };
    finds.into_iter().any(asks) && !text.contains("\nsimulate ")
}

/// Whether a number is a value, rounded to the digits that it has.
fn is_rounded(number: f64, value: f64) -> bool {
    let figures = format!("{number:.12e}");
    let digits = figures.split('e').next().unwrap_or_default().trim_end_matches('0').len() - 1;
    let rounded: f64 = format!("{:.*e}", digits.max(4) - 1, value.abs()).parse().unwrap_or(f64::NAN);
    (rounded - number).abs() <= 1e-9 * number
}

/// The keys of all examples that have one, made once for all tests, by the place of the example.
fn keys() -> &'static [(usize, String)] {
    static ALL: OnceLock<Vec<(usize, String)>> = OnceLock::new();
    ALL.get_or_init(|| {
        let folder = Folder::new("all-keys");
        let key = |(i, example): (usize, &Example)| {
            assur(&["batch", &path(&example.name), "--key", &folder.at("key.csv")]);
            // motions have thousands of instants, which a sheet does not show
            Some((i, folder.take("key.csv").filter(|csv| csv.lines().count() <= 400)?))
        };
        examples().iter().enumerate().filter_map(key).collect()
    })
}

#[test]
fn sheets_have_no_answers() {
    let folder = Folder::new("sheets");
    let (mut wrong, mut sheets, mut count) = (Vec::new(), 0, 0);
    for (i, csv) in keys() {
        let Example { name, text: words, .. } = &examples()[*i];
        let file = path(name);
        assur(&["report", &file, "--sheet", "--per-row", "-o", &folder.at("s.html")]);
        // what the text states before its expectations is given
        let stated = words.lines().filter(|l| !l.trim_start().starts_with("expect") && !l.starts_with("//"));
        let stated: Vec<f64> = stated.flat_map(numbers).collect();
        for row in 1.. {
            let Some(page) = folder.take_first(&[format!("s-{row}.html"), format!("s-{row}-")]) else {
                break;
            };
            sheets += 1;
            // the place of a counterweight is in no scheme
            let hides = words.contains("\ncounterweight") && !page.contains("<svg");
            if asks_for_positions(words) && !hides && !page.contains("drawn at another position") {
                wrong.push(format!("{name}: the scheme shows the position that is asked for"));
            }
            let (text, mut found) = (read(&page), [Vec::new(), Vec::new()]);
            // an angle is no length
            found[1] = numbers(&text);
            found[0] = numbers(
                &text
                    .split('°')
                    .map(|t| t.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.'))
                    .collect::<String>(),
            );
            for (header, value) in answers(csv, row) {
                // the same length in mm and in m, the same angle in degrees and in radians
                let units: &[f64] = match header.rsplit('[').next().unwrap_or_default() {
                    "deg]" | "rad]" => &[1.0, 180.0 / std::f64::consts::PI, std::f64::consts::PI / 180.0],
                    "m]" | "mm]" => &[1.0, 1e3, 1e-3],
                    _ => &[1.0],
                };
                let is = |x: f64, wanted: f64| (x - wanted.abs()).abs() <= 5e-5 * wanted.abs();
                // a motion begins at 1500 rpm
                let rpm = if header.ends_with("[rad/s]") { std::f64::consts::PI / 30.0 } else { 1.0 };
                let given = |x: f64| stated.iter().any(|s| is(*s, x) || is(*s, 2.0 * x) || is(*s * rpm, x));
                if !is_telling(value) || units.iter().any(|unit| given(value * unit)) {
                    continue;
                }
                count += 1;
                let shows = |x: &f64| is_telling(*x) && units.iter().any(|unit| is_rounded(*x, value * unit));
                let found = &found[usize::from(header.ends_with("[deg]") || header.ends_with("[rad]"))];
                if let Some(shown) = found.iter().find(|x| shows(x)) {
                    wrong.push(format!("{name}, row {row}: {header} = {value}: {shown}"));
                }
            }
        }
    }
    println!("{count} answers in {sheets} sheets, {} found", wrong.len());
    assert!(sheets > 260 && count > 4000, "{sheets} {count}");
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(40)]);
}

/// The rows of all tables of a page side by side: headers, and lines.
fn tables(page: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let (mut headers, mut lines): (Vec<String>, Vec<Vec<String>>) = (Vec::new(), Vec::new());
    for table in page.split("<table").skip(1) {
        let table = table.split("</table>").next().unwrap_or_default();
        let mut rows = table.split("<tr").skip(1).map(|row| {
            let cell = |part: &str| part.split_once('>').map_or("", |(_, words)| words).trim().to_owned();
            let text = |words: &str| words.replace("&amp;", "&").replace("&lt;", "<").replace("&#39;", "'");
            let row = row.replace("</th>", "\u{1}").replace("</td>", "\u{1}");
            let cells: Vec<String> =
                row.split('\u{1}').map(|c| text(&cell(&c[c.rfind("<t").unwrap_or(0)..]))).collect();
            cells[..cells.len() - 1].to_vec()
        });
        let head = rows.next().unwrap_or_default();
        let lead = if headers.is_empty() {
            0
        } else {
            head.iter().take_while(|h| !h.contains('(') && headers.contains(h)).count()
        };
        headers.extend(head[lead..].iter().cloned());
        for (i, row) in rows.enumerate() {
            if lines.len() <= i {
                lines.push(Vec::new());
            }
            lines[i].extend(row[lead..].iter().cloned());
        }
    }
    (headers, lines)
}

/// A number as `1.2e-3`.
fn plain(cell: &str) -> String {
    let digit = |c: char| match c {
        '−' | '⁻' => '-',
        c => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).map_or(c, |d| char::from(b'0' + d as u8)),
    };
    cell.replace("·10", "e").chars().map(digit).collect()
}

#[test]
fn a_key_marks_itself_as_right() {
    let folder = Folder::new("keys");
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (i, csv) in keys() {
        let name = &examples()[*i].name;
        let file = path(name);
        let (of_batch, _) = key_of(csv);
        if !of_batch.iter().any(|header| is_quantity(header)) {
            continue;
        }
        assur(&["report", &file, "--key", "-o", &folder.at("key.html")]);
        let Some(page) = folder.take("key.html") else {
            wrong.push(format!("{name}: there is no key"));
            continue;
        };
        let (headers, lines) = tables(&page);
        let label = if of_batch.iter().any(|h| h == "variant") { "variant" } else { "row" };
        // the page has letters where a file has names, in the same order
        let mut names = of_batch.iter().filter(|header| is_quantity(header));
        let lead = headers.len() - names.clone().count();
        let columns = (0..headers.len()).map(|i| match i {
            0 => label.to_owned(),
            1 if lead == 2 => "pose".to_owned(),
            _ => format!("\"{}\"", names.next().expect("a column of the key")),
        });
        let mut answers = columns.collect::<Vec<_>>().join(";") + "\n";
        assert_eq!(names.next(), None, "{name}");
        for line in lines {
            let number = |cell: String| if cell == "–" { String::new() } else { plain(&cell) };
            answers += &(line.into_iter().map(number).collect::<Vec<_>>().join(";") + "\n");
        }
        count += 1;
        std::fs::write(folder.at("key.csv"), csv).expect("a key");
        std::fs::write(folder.at("answers.csv"), &answers).expect("answers");
        let marked = assur(&["grade", &folder.at("key.csv"), &folder.at("answers.csv")]);
        if !marked.status.success() {
            let said = String::from_utf8_lossy(&marked.stdout) + String::from_utf8_lossy(&marked.stderr);
            wrong.push(format!("{name}: {}", said.chars().take(1200).collect::<String>()));
        }
    }
    println!("{count} keys");
    assert!(count > 190, "{count}");
    assert!(wrong.is_empty(), "{} of {count}: {}", wrong.len(), wrong[..wrong.len().min(6)].join("\n"));
}
