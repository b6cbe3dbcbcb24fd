//! The language server: exchanges of messages, and the program on its streams.

use crate::run::{Folder, with_input};
use assur::internals::lsp::Server;
use assur::internals::source::{Edit, Encoding, LineColumn, Lines, Span, edited};
use proptest::prelude::*;
use serde_json::{Value, json};

pub const URI: &str = "untitled:a";
const WRONG: &str =
    "given φ = 5 mm\nlnk crank A-B φ\nground {\n  A (0, 0)\n}\n// one\n// two\nrevolute A: ground - crnk\n";

/// A session with a text open, in the encoding that the client offers.
pub fn session(text: &str, encoding: &str) -> (Server, Vec<Value>) {
    let mut server = Server::default();
    let capabilities = json!({ "general": { "positionEncodings": [encoding] } });
    let initialized = request(&mut server, "initialize", &json!({ "capabilities": capabilities }));
    assert_eq!(initialized["result"]["capabilities"]["positionEncoding"], encoding);
    notify(&mut server, "initialized", &json!({}));
    let opened = json!({ "textDocument": { "uri": URI, "languageId": "mech", "version": 1, "text": text } });
    notify(&mut server, "textDocument/didOpen", &opened);
    let published = server.publish();
    (server, published)
}

pub fn request(server: &mut Server, method: &str, params: &Value) -> Value {
    let answers = server.handle(&json!({ "jsonrpc": "2.0", "id": 7, "method": method, "params": params }));
    let [answer] = <[Value; 1]>::try_from(answers).expect("one answer");
    assert_eq!(answer["id"], 7);
    answer
}

pub fn notify(server: &mut Server, method: &str, params: &Value) {
    let answers = server.handle(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    assert!(answers.is_empty(), "{method}: {answers:?}");
}

pub fn document() -> Value {
    json!({ "uri": URI })
}

pub fn range(from: (u32, u32), to: (u32, u32)) -> Value {
    json!({ "start": { "line": from.0, "character": from.1 }, "end": { "line": to.0, "character": to.1 } })
}

/// A text with edits of the protocol made, columns counted in UTF-16.
pub fn applied(text: &str, edits: &Value) -> String {
    let mut text = text.to_owned();
    for edit in edits.as_array().expect("edits").iter().rev() {
        let byte = |at: &Value| {
            let number =
                |key: &str| usize::try_from(at[key].as_u64().expect("a number")).expect("a small one");
            let before = text.split_inclusive('\n').take(number("line")).map(str::len).sum::<usize>();
            let units = text[before..].char_indices().scan(0, |count, (at, c)| {
                let here = *count;
                *count += c.len_utf16();
                Some((here, at))
            });
            let at = units.into_iter().find(|(count, _)| *count == number("character")).map(|(_, at)| at);
            at.map_or(text.len(), |at| before + at)
        };
        let (start, end) = (byte(&edit["range"]["start"]), byte(&edit["range"]["end"]));
        text.replace_range(start..end, edit["newText"].as_str().expect("a text"));
    }
    text
}

#[test]
fn diagnostics_follow_the_text() {
    let (mut server, published) = session(WRONG, "utf-16");
    let params = &published[0]["params"];
    assert_eq!((params["uri"].as_str(), params["version"].as_i64()), (Some(URI), Some(1)));
    let first = &params["diagnostics"][0];
    assert_eq!(first["range"], range((1, 0), (1, 3)));
    assert_eq!((first["severity"].as_i64(), first["source"].as_str()), (Some(1), Some("assur")));
    assert!(
        first["message"].as_str().is_some_and(|m| m.contains("help: write: link crank A-B φ")),
        "{first}"
    );
    assert!(server.publish().is_empty(), "published once");
    let change = |version: i32, change: Value| json!({ "textDocument": { "uri": URI, "version": version }, "contentChanges": [change] });
    notify(
        &mut server,
        "textDocument/didChange",
        &change(2, json!({ "range": range((1, 0), (1, 3)), "text": "link" })),
    );
    notify(
        &mut server,
        "textDocument/didChange",
        &change(3, json!({ "range": range((7, 21), (7, 25)), "text": "crank" })),
    );
    let published = server.publish();
    assert_eq!(
        (published.len(), published[0]["params"]["version"].as_i64()),
        (1, Some(3)),
        "the last of two"
    );
    let left = published[0]["params"]["diagnostics"].to_string();
    assert!(!left.contains("lnk") && !left.contains("crnk"), "{left}");
    // a fresh start says the same
    let fixed = WRONG.replace("lnk", "link").replace("crnk", "crank");
    assert_eq!(
        published[0]["params"]["diagnostics"],
        session(&fixed, "utf-16").1[0]["params"]["diagnostics"]
    );
    let closed = server.handle(&json!({ "jsonrpc": "2.0", "method": "textDocument/didClose", "params": { "textDocument": document() } }));
    assert_eq!(closed[0]["params"]["diagnostics"], json!([]));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(crate::share::part(200)) })]

    /// After any edits, what is published is what a fresh start says of the text.
    #[test]
    fn no_history_is_seen(edits in prop::collection::vec((0..12_u32, 0..40_u32, 0..12_u32, 0..40_u32, 0..8_usize), 1..20)) {
        const PUT: [&str; 8] = ["", "link", " φ", "\n", "{", "}", "\r\n", "mm 曲柄😀"];
        let (mut server, _) = session(WRONG, "utf-16");
        let mut text = WRONG.to_owned();
        let mut published = Vec::new();
        for (version, (line, column, to_line, to_column, put)) in edits.into_iter().enumerate() {
            let range = range((line, column), (to_line, to_column));
            let change = json!({ "range": range, "text": PUT[put] });
            let version = json!({ "uri": URI, "version": version + 2 });
            let params = json!({ "textDocument": version, "contentChanges": [change] });
            // a range that there is not is refused, and the text stays
            let message = json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": params });
            if server.handle(&message).is_empty() {
                let lines = Lines::of(&text);
                let place = |line, column| LineColumn { line, column };
                let byte = |line: u32, column: u32| {
                    lines.byte(place(line as usize, column as usize), Encoding::Utf16).expect("a place")
                };
                let span = Span::new(byte(line, column), byte(to_line, to_column));
                text = edited(&text, &[Edit::new(span, PUT[put])]);
                published = server.publish();
            }
        }
        if let Some(last) = published.last() {
            let fresh = session(&text, "utf-16").1;
            prop_assert_eq!(&last["params"]["diagnostics"], &fresh[0]["params"]["diagnostics"], "{}", text);
        }
    }
}

#[test]
fn columns_are_counted_as_the_client_does() {
    let text = "given φ = 5 wobbles\n";
    let column = |encoding| {
        session(text, encoding).1[0]["params"]["diagnostics"][0]["range"]["start"]["character"].clone()
    };
    assert_eq!((column("utf-8"), column("utf-16")), (json!(13), json!(12)));
}

#[test]
fn fixes_are_code_actions() {
    let (mut server, _) = session(WRONG, "utf-16");
    let asked = json!({ "textDocument": document(), "range": range((1, 1), (1, 1)), "context": { "diagnostics": [] } });
    let actions = request(&mut server, "textDocument/codeAction", &asked)["result"].clone();
    assert_eq!(actions[0]["title"], "write: link crank A-B φ");
    assert_eq!(
        (actions[0]["kind"].as_str(), actions[0]["isPreferred"].as_bool()),
        (Some("quickfix"), Some(true))
    );
    let fixed = applied(WRONG, &actions[0]["edit"]["changes"][URI]);
    assert_eq!(fixed, WRONG.replace("lnk", "link"));
    assert_eq!(
        (actions[1]["kind"].as_str(), actions.as_array().map(Vec::len)),
        (Some("source.fixAll"), Some(3))
    );
    assert_eq!(actions[2]["command"]["command"], "assur.explain");
    let explain = json!({ "command": "assur.explain", "arguments": actions[2]["command"]["arguments"] });
    let said = server.handle(
        &json!({ "jsonrpc": "2.0", "id": 1, "method": "workspace/executeCommand", "params": explain }),
    );
    assert!(
        said[0]["result"].as_str().is_some_and(|page| page.starts_with("# mech::syntax::misspelt_word")),
        "{said:?}"
    );
    assert_eq!(said[0]["result"], said[1]["params"]["message"]);
    let elsewhere = json!({ "textDocument": document(), "range": range((3, 0), (3, 0)), "context": { "diagnostics": [] } });
    let actions = request(&mut server, "textDocument/codeAction", &elsewhere)["result"].clone();
    assert_eq!(actions.as_array().map(Vec::len), Some(1), "all that is certain: {actions}");
}

#[test]
fn texts_are_formatted() {
    let text = "given  φ=5mm\ngiven  r=1 m\n";
    let (mut server, _) = session(text, "utf-16");
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let asked = json!({ "textDocument": document(), "options": options });
    let edits = request(&mut server, "textDocument/formatting", &asked)["result"].clone();
    assert_eq!(applied(text, &edits), "given φ = 5 mm\ngiven r = 1 m\n");
    let asked = json!({ "textDocument": document(), "options": options, "range": range((1, 0), (1, 3)) });
    let edits = request(&mut server, "textDocument/rangeFormatting", &asked)["result"].clone();
    assert_eq!(applied(text, &edits), "given  φ=5mm\ngiven r = 1 m\n");
    let (mut server, _) = session("link  link link\n", "utf-16");
    let asked = json!({ "textDocument": document(), "options": options });
    assert_eq!(
        request(&mut server, "textDocument/formatting", &asked)["result"],
        json!([]),
        "it does not read"
    );
}

#[test]
fn symbols_and_folds() {
    let (mut server, _) = session(WRONG, "utf-16");
    let asked = json!({ "textDocument": document() });
    let symbols = request(&mut server, "textDocument/documentSymbol", &asked)["result"].clone();
    let names = symbols.as_array().expect("symbols").iter().map(|s| s["name"].as_str().expect("a name"));
    assert_eq!(names.collect::<Vec<_>>(), ["φ", "ground", "A"]);
    assert_eq!(symbols[1]["children"][0]["name"], "A");
    assert_eq!(symbols[1]["range"], range((2, 0), (4, 1)));
    let folds = request(&mut server, "textDocument/foldingRange", &asked)["result"].clone();
    assert_eq!(folds, json!([{ "startLine": 2, "endLine": 4 }, { "startLine": 5, "endLine": 6 }]));
}

#[test]
fn words_of_the_language_are_explained() {
    let text = "link crank A-B 5 mm { mass 2 kN*m }\nfind velocity(B)\nspring k: rod.B - ground.A { stiffness 4 N/m }\n// allows mech::name::unknown: it is\n";
    let (mut server, _) = session(text, "utf-16");
    let mut hover = |line: u32, character: u32| {
        let at = json!({ "line": line, "character": character });
        let answer = request(
            &mut server,
            "textDocument/hover",
            &json!({ "textDocument": document(), "position": at }),
        );
        (answer["result"]["contents"]["value"].as_str().map(str::to_owned), answer["result"]["range"].clone())
    };
    assert!(hover(0, 2).0.is_some_and(|text| text.ends_with("a rigid link")));
    let (unit, range_of) = hover(0, 30);
    assert_eq!(unit.as_deref(), Some("`kN*m`: a torque or energy, 1000 N*m"));
    assert_eq!(range_of, range((0, 29), (0, 33)));
    assert!(hover(0, 23).0.is_some_and(|text| text.contains("mass")));
    let function = hover(1, 7).0.expect("a function");
    assert!(
        function.starts_with("```mech\nvelocity(") && function.contains("- velocity, a vector: "),
        "{function}"
    );
    let property = hover(2, 33).0.expect("a property");
    assert!(property.starts_with("```mech\nstiffness ") && property.contains("> 0"), "{property}");
    let (page, at) = hover(3, 14);
    assert!(page.is_some_and(|page| page.starts_with("# mech::name::unknown")));
    assert_eq!((at, hover(3, 4).0), (range((3, 10), (3, 29)), None));
    assert_eq!(
        hover(0, 6).0.as_deref(),
        Some("```mech\nlink crank A-B 5 mm { mass 2 kN*m }\n```\npoints `A`, `B`")
    );
}

#[test]
fn bad_messages_get_errors() {
    let mut server = Server::default();
    let code = |answer: &Value| answer["error"]["code"].as_i64();
    assert_eq!(code(&request(&mut server, "textDocument/formatting", &json!({}))), Some(-32002));
    let (mut server, _) = session(WRONG, "utf-16");
    for (method, params, wanted) in [
        ("textDocument/unknown", json!({}), -32601),
        ("initialize", json!({}), -32600),
        ("textDocument/documentSymbol", json!({}), -32602),
        ("textDocument/documentSymbol", json!({ "textDocument": { "uri": "untitled:b" } }), -32602),
        (
            "textDocument/codeAction",
            json!({ "textDocument": document(), "range": range((99, 0), (99, 0)), "context": { "diagnostics": [] } }),
            -32602,
        ),
        (
            "textDocument/codeAction",
            json!({ "textDocument": document(), "range": range((1, 2), (1, 0)), "context": { "diagnostics": [] } }),
            -32602,
        ),
    ] {
        let answer = request(&mut server, method, &params);
        assert_eq!(code(&answer), Some(wanted), "{method}: {answer}");
    }
    for message in [json!(5), json!([]), json!({ "id": 1 }), json!(null)] {
        assert_eq!(code(&server.handle(&message)[0]), Some(-32600), "{message}");
    }
    let change = json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "range": range((99, 0), (99, 0)), "text": "" }] });
    let said =
        server.handle(&json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": change }));
    assert_eq!(said[0]["method"], "window/logMessage");
    assert!(server.publish().is_empty(), "the text is as it was");
    assert_eq!(request(&mut server, "shutdown", &json!(null))["result"], json!(null));
    assert_eq!(code(&request(&mut server, "textDocument/formatting", &json!({}))), Some(-32600));
}

fn framed(messages: &[String]) -> String {
    messages.iter().map(|body| format!("Content-Length: {}\r\n\r\n{body}", body.len())).collect()
}

#[test]
fn the_program_speaks_on_its_streams() {
    let folder = Folder::new("lsp");
    let initialize =
        json!({ "jsonrpc": "2.0", "id": 1, "method": "initialize", "params": { "capabilities": {} } });
    let opened = json!({ "textDocument": { "uri": URI, "languageId": "mech", "version": 1, "text": WRONG } });
    let open = json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": opened });
    let shutdown = json!({ "jsonrpc": "2.0", "id": 2, "method": "shutdown" });
    let exit = json!({ "jsonrpc": "2.0", "method": "exit" });
    let lines = |all: &[&Value]| framed(&all.iter().map(ToString::to_string).collect::<Vec<_>>());
    let out = with_input(&folder, &["lsp"], &lines(&[&initialize, &open, &shutdown, &exit]));
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(
        out.stdout.starts_with("Content-Length: ") && out.stdout.contains("\"utf-16\""),
        "{}",
        out.stdout
    );
    // a closed stream ends it, `exit` alone is an error
    assert_eq!(with_input(&folder, &["lsp"], &lines(&[&initialize])).status, 0);
    assert_eq!(with_input(&folder, &["lsp"], &lines(&[&initialize, &exit])).status, 1);
    // what is no JSON is answered, and the next message too
    let broken = framed(&["{\"id\": ".to_owned(), initialize.to_string()]);
    let out = with_input(&folder, &["lsp"], &broken);
    assert!(out.stdout.contains("-32700") && out.stdout.contains("capabilities"), "{}", out.stdout);
}

/// Where the next message begins is not known any more: it says so and ends.
#[test]
fn a_stream_without_its_framing_ends_it() {
    let folder = Folder::new("lsp-lost");
    let initialize =
        json!({ "jsonrpc": "2.0", "id": 1, "method": "initialize", "params": { "capabilities": {} } });
    let first = framed(&[initialize.to_string()]);
    for rest in [
        "{\"jsonrpc\": \"2.0\"}\r\n\r\n",
        "Content-Length: x\r\n\r\n{}",
        "\r\n",
        "Content-Length: 99999999999\r\n\r\n{}",
    ] {
        let out = with_input(&folder, &["lsp"], &format!("{first}{rest}{first}"));
        assert_eq!(out.status, 2, "{rest}");
        assert!(out.stderr.contains("a message without a Content-Length"), "{rest}: {}", out.stderr);
        assert_eq!(out.stdout.matches("capabilities").count(), 1, "{rest}: what follows is not read");
        assert!(out.stdout.contains("-32700"), "{rest}: {}", out.stdout);
    }
}

#[test]
fn names_lead_to_their_places() {
    let text = "given φ = 5 mm\nground { B (0, 0) }\nlink crank B-C φ\nrevolute B: ground - crank\ndrive crank = 4 deg\nfind velocity(C)\n";
    let (mut server, _) = session(text, "utf-16");
    let mut ask = |method: &str, line: u32, character: u32, more: &Value| {
        let at = json!({ "line": line, "character": character });
        let mut params = json!({ "textDocument": document(), "position": at });
        if let (Some(params), Some(more)) = (params.as_object_mut(), more.as_object()) {
            params.extend(more.clone());
        }
        let answer = request(&mut server, &format!("textDocument/{method}"), &params);
        if answer["error"].is_null() { answer["result"].clone() } else { answer["error"]["message"].clone() }
    };
    let ranges = |found: &Value| {
        found.as_array().expect("places").iter().map(|at| at["range"].clone()).collect::<Vec<_>>()
    };
    let none = json!({});
    let crank = range((2, 5), (2, 10));
    assert_eq!(ranges(&ask("definition", 4, 8, &none)), std::slice::from_ref(&crank));
    let points = [range((1, 9), (1, 10)), range((2, 11), (2, 12))];
    assert_eq!(ranges(&ask("definition", 3, 9, &none)), points, "a pair leads to its points");
    let (with, without) = (
        json!({ "context": { "includeDeclaration": true } }),
        json!({ "context": { "includeDeclaration": false } }),
    );
    let uses = [range((3, 21), (3, 26)), range((4, 6), (4, 11))];
    assert_eq!(ranges(&ask("references", 4, 8, &without)), uses);
    assert_eq!(ranges(&ask("references", 4, 8, &with)), [&[crank], &uses[..]].concat());
    let marked = ask("documentHighlight", 0, 6, &none);
    assert_eq!((marked[0]["kind"].as_i64(), marked[1]["kind"].as_i64()), (Some(3), Some(2)), "{marked}");
    assert_eq!(
        ask("prepareRename", 2, 16, &none),
        json!({ "range": range((2, 15), (2, 16)), "placeholder": "φ" })
    );
    assert_eq!(ask("prepareRename", 2, 1, &none), "there is no name here");
    let edits = ask("rename", 3, 9, &json!({ "newName": "Ω" }))["changes"][URI].clone();
    let renamed = text.replace("B (", "Ω (").replace("B-C", "Ω-C").replace("B:", "Ω:");
    assert_eq!(applied(text, &edits), renamed);
    assert_eq!(ask("rename", 3, 9, &json!({ "newName": "crank" })), "`crank` is declared twice");
    for word in ["at", "and", "in", "module"] {
        let refused = format!("`{word}` is a keyword and cannot be a name");
        assert_eq!(ask("rename", 3, 9, &json!({ "newName": word })), refused);
        assert_eq!(ask("rename", 2, 5, &json!({ "newName": word })), refused);
    }
}
