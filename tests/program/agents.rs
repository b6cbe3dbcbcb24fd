//! What agents get: the card, `llms.txt`, the server on its streams.

use crate::run::{Folder, assur};
use assur::internals::language::{
    CAM_MEMBERS, COLLECTIONS, FUNCTIONS, LAWS, MEMBERS, PAIRS, PROPERTIES, SHAPES, STATEMENTS, UNITS,
};
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Stdio};

/// Characters of 6,000 tokens, at 3.3 each.
const LONGEST: usize = 19_800;

fn printed(args: &[&str]) -> String {
    let said = assur(&Folder::new("agents"), args);
    assert_eq!(said.status, 0, "{}", said.stderr);
    said.stdout
}

fn card() -> String {
    printed(&["card"])
}

#[test]
fn every_file_of_the_card_solves() {
    let card = card();
    let blocks: Vec<&str> =
        card.split("```mech\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(blocks.len(), 6);
    for text in blocks {
        let solution = assur::solve(text).unwrap_or_else(|errors| panic!("{errors}\n{text}"));
        assert!(
            !solution.poses().is_empty() && solution.poses().iter().all(|pose| pose.failure().is_none()),
            "{text}"
        );
    }
}

#[test]
fn the_card_has_all_tables_and_is_short() {
    let card = card();
    assert!(card.len() <= LONGEST, "{} characters", card.len());
    let words = [STATEMENTS, PAIRS, MEMBERS, CAM_MEMBERS, SHAPES].concat();
    let examples = words.iter().map(|word| word.example);
    let examples = examples.chain(PROPERTIES.iter().flat_map(|(_, all)| all.iter().map(|one| one.example)));
    let names = LAWS.iter().map(|word| word.word);
    let names = names.chain(COLLECTIONS.iter().map(|one| one.word));
    for wanted in examples.chain(names) {
        assert!(card.contains(&format!("`{wanted}`")), "{wanted}");
    }
    for row in FUNCTIONS {
        assert!(card.contains(&format!("`{}(", row.name)), "{}", row.name);
    }
    let units = card.split("## Units").nth(1).expect("units");
    for unit in UNITS {
        assert!(units.split(['`', ' ']).any(|word| word == unit.text), "{}", unit.text);
    }
}

#[test]
fn codes_of_the_card_exist() {
    let card = card();
    let codes: Vec<&str> = card.split('`').filter(|word| word.starts_with("mech::")).collect();
    assert!(codes.len() >= 10);
    codes.iter().for_each(|code| assert!(assur::explain(code).is_ok(), "{code}"));
}

#[test]
fn kept_pages_are_what_is_printed() {
    assert_eq!(card(), include_str!("../../docs/card.md"), "run: assur card > docs/card.md");
    let llms = printed(&["card", "--llms"]);
    assert_eq!(llms, include_str!("../../llms.txt"), "run: assur card --llms > llms.txt");
    for link in llms.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(link);
        assert!(path.exists(), "{link}");
    }
    let data: Value = serde_json::from_str(&printed(&["card", "--format", "json"])).expect("json");
    assert_eq!(data["schema"], "assur.card/1");
    assert_eq!(data["statements"].as_array().map(Vec::len), Some(STATEMENTS.len()));
}

/// What the server answers to lines.
fn served(lines: &[String]) -> Vec<Value> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_assur"))
        .arg("mcp")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut input = child.stdin.take().expect("a stream");
    let text = lines.join("\n") + "\n";
    let writing = std::thread::spawn(move || input.write_all(text.as_bytes()).expect("it reads"));
    let output = child.wait_with_output().expect("it ends");
    writing.join().expect("all is written");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    text.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect()
}

fn request(id: u32, method: &str, params: Value) -> String {
    json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }).to_string()
}

fn call(id: u32, name: &str, arguments: Value) -> String {
    request(id, "tools/call", json!({ "name": name, "arguments": arguments }))
}

const GEARS: &str = "mech 1\nshaft I { wheel a teeth 20 }\nshaft O { wheel b teeth 50 }\nmesh k: a - b\n\
                     given n = 10 rad/s\ndrive I at n\nfind omega(O)\n";

#[test]
fn the_server_shakes_hands_and_lists_five_tools() {
    let hello = json!({ "protocolVersion": "2025-03-26", "capabilities": {}, "clientInfo": { "name": "t", "version": "1" } });
    let answers = served(&[
        request(1, "initialize", hello),
        json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }).to_string(),
        request(2, "tools/list", json!({})),
        request(3, "server/discover", json!({})),
        request(4, "initialize", json!({ "protocolVersion": "1999-01-01" })),
        request(5, "resources/read", json!({ "uri": "assur://explain/mech::name::unknown" })),
        request(6, "ping", json!({})),
    ]);
    assert_eq!(answers.len(), 6, "a notification has no answer");
    assert_eq!(answers[0]["result"]["protocolVersion"], "2025-03-26");
    let tools = answers[1]["result"]["tools"].as_array().expect("tools");
    let names: Vec<&str> = tools.iter().filter_map(|tool| tool["name"].as_str()).collect();
    assert_eq!(names, ["check", "solve", "draw", "explain", "format"]);
    assert!(tools.iter().all(|tool| tool["inputSchema"]["additionalProperties"] == false));
    assert_eq!(answers[2]["error"]["code"], -32601);
    assert_eq!(answers[3]["result"]["protocolVersion"], "2025-11-25");
    assert!(answers[4]["result"]["contents"][0]["text"].as_str().is_some_and(|page| page.contains("name")));
    assert_eq!(answers[5]["result"], json!({}));
}

#[test]
fn tools_answer_with_data_and_errors_of_a_text_are_results() {
    let answers = served(&[
        call(1, "solve", json!({ "text": GEARS, "set": { "n": "5 rad/s" } })),
        call(2, "check", json!({ "text": "mech 1\nlink a A-B 35\n" })),
        call(3, "check", json!({ "text": GEARS.replace("find", "fnid"), "fix": true })),
        call(4, "draw", json!({ "text": GEARS, "pictures": ["train"] })),
        call(5, "format", json!({ "text": "mech 1\nlink   a A-B   3 mm\n" })),
        call(6, "explain", json!({ "word": "assemble" })),
        call(
            7,
            "solve",
            json!({ "text": "mech 1\nground { O (0, 0) }\nlink a O-A 1 m\nrevolute O: ground - a\ndrive a = 0 deg .. 360 deg in 90 steps\nfind position(A)\n" }),
        ),
    ]);
    let result = |i: usize| &answers[i]["result"];
    assert!(answers.iter().all(|answer| answer["result"]["isError"] == false), "{answers:?}");
    assert_eq!(result(0)["structuredContent"]["poses"][0]["quantities"]["omega(O)"], -2.0);
    assert_eq!(result(1)["structuredContent"]["diagnostics"][0]["code"], "mech::unit::missing");
    assert_eq!(result(2)["structuredContent"]["text"], GEARS);
    let drawn = result(3)["content"].as_array().expect("content");
    assert!(drawn[0]["text"].as_str().is_some_and(|words| words.contains("Wheels: a on I")));
    assert!(drawn[1]["text"].as_str().is_some_and(|svg| svg.starts_with("<svg")));
    assert_eq!(result(4)["structuredContent"]["text"], "mech 1\nlink a A-B 3 mm\n");
    assert!(
        result(5)["content"][0]["text"].as_str().is_some_and(|page| page.contains("assemble C left of B-D"))
    );
    let swept = &result(6)["structuredContent"];
    assert_eq!((swept["poses"].as_array().map(Vec::len), &swept["poses_left_out"]), (Some(50), &json!(40)));
}

#[test]
fn bad_calls_are_answered_and_the_server_goes_on() {
    let answers = served(&[
        "{nope".to_owned(),
        "[1, 2]".to_owned(),
        "x".repeat((1 << 20) + 10),
        call(1, "chek", json!({})),
        call(2, "solve", json!({ "text": GEARS, "lines": 3 })),
        call(3, "solve", json!({ "text": 3 })),
        call(4, "solve", json!({ "text": " ".repeat(300_000) })),
        call(5, "solve", json!({ "text": GEARS, "pose": "9" })),
        call(6, "draw", json!({ "text": GEARS, "pictures": ["trian"] })),
        call(7, "explain", json!({ "code": "name::unknwn" })),
        call(8, "solve", json!({ "text": GEARS })),
    ]);
    let code = |i: usize| answers[i]["error"]["code"].as_i64();
    assert_eq!([code(0), code(1), code(2), code(3)], [-32700, -32600, -32600, -32602].map(Some));
    assert!(answers[3]["error"]["message"].as_str().is_some_and(|words| words.contains("`check`")));
    let said = |i: usize| answers[i]["result"]["content"][0]["text"].as_str().unwrap_or_default();
    for (i, words) in [
        (4, "no argument `lines`"),
        (5, "must be of the type string"),
        (6, "262144"),
        (7, "no position is named `9`"),
        (8, "did you mean `train`?"),
        (9, "mech::name::unknown"),
    ] {
        assert_eq!(answers[i]["result"]["isError"], true, "{:?}", answers[i]);
        assert!(said(i).contains(words), "{}", said(i));
    }
    assert_eq!(answers[10]["result"]["isError"], false);
}

#[test]
fn broken_lines_never_lose_an_answer() {
    let good = call(1, "check", json!({ "text": GEARS }));
    let mut lines = Vec::new();
    let mut seed = 1_u64;
    for i in 0..10_000_u64 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mut bytes = good.clone().into_bytes();
        let at = (seed >> 33) as usize % bytes.len();
        match i % 4 {
            0 => bytes[at] = b'!' + (seed >> 20 & 63) as u8,
            1 => bytes.truncate(at),
            2 => drop(bytes.drain(..at)),
            _ => bytes.insert(at, b'{'),
        }
        if i % 100 == 0 {
            lines.push(request(100_000 + i as u32, "ping", json!({})));
        }
        lines.push(String::from_utf8_lossy(&bytes).replace('\n', " "));
    }
    let answers = served(&lines);
    let pings = answers.iter().filter(|answer| answer["id"].as_u64().is_some_and(|id| id >= 100_000)).count();
    assert_eq!(pings, 100);
}

/// A hundred motions that take seconds each.
fn long() -> Value {
    let rows: String = (1..=100).map(|i| format!("  {i}\n")).collect();
    let text = format!(
        "mech 1\ngravity 9.81 m/s^2\ngiven k = 1\nground {{ O (0, 0) }}\nlink a O-A 1 m {{ mass 1 kg at A }}\n\
         link b A-B 1 m {{ mass k * 1 kg at B }}\nrevolute O: ground - a\nrevolute A: a - b\nstart a = 10 deg at 0 rad/s\n\
         start b = 20 deg at 0 rad/s\nsimulate 0 s .. 10000 s in 10 steps within 1e-12\nfind angle(a)\nvariants {{\n  k\n{rows}}}\n"
    );
    json!({ "text": text, "rows": 100 })
}

#[test]
fn a_call_that_is_cancelled_or_takes_too_long_ends() {
    let cancelled =
        json!({ "jsonrpc": "2.0", "method": "notifications/cancelled", "params": { "requestId": 1 } });
    let answers = served(&[
        call(1, "solve", long()),
        cancelled.to_string(),
        call(2, "solve", long()),
        request(3, "ping", json!({})),
    ]);
    let ids: Vec<Option<u64>> = answers.iter().map(|answer| answer["id"].as_u64()).collect();
    assert_eq!(ids, [Some(2), Some(3)], "{answers:?}");
    assert_eq!(answers[0]["result"]["isError"], true, "{}", answers[0]);
    assert!(answers[0]["result"]["content"][0]["text"].as_str().is_some_and(|why| why.contains("5 s")));
}
