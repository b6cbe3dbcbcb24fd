//! The model context protocol: tools for agents that write `.mech` files. Messages come in and go out as JSON; no streams here. A call
//! reads and writes no file.

use super::limits::Alarm;
use super::tools;
use crate::report::card;
use assur_text::diagnostic::{CODES, explain};
use serde_json::{Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The versions that shake hands by `initialize`, the newest first.
const VERSIONS: [&str; 4] = ["2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05"];
/// The most bytes of a message.
pub(super) const LONGEST: usize = 1 << 20;

/// Codes of JSON-RPC.
const PARSE: i32 = -32700;
const INVALID_REQUEST: i32 = -32600;
const UNKNOWN_METHOD: i32 = -32601;
const INVALID_PARAMS: i32 = -32602;
const INTERNAL: i32 = -32603;
/// The code of the protocol for a resource that is not there.
const NO_RESOURCE: i32 = -32002;

/// Why a request has no result.
#[derive(Debug)]
struct Failure(i32, String);

/// The response to a message; nothing to a notification. A call ends where the alarm says so.
pub(super) fn answer(message: &Value, alarm: &Alarm) -> Option<Value> {
    let id = message.get("id").filter(|id| id.is_string() || id.is_number());
    let Some(method) = message.get("method").and_then(Value::as_str) else {
        // the response to a request of ours, of which there are none
        let is_response = message.get("result").is_some() || message.get("error").is_some();
        return (!is_response)
            .then(|| refusal(id, INVALID_REQUEST, "this is not a request: it has no `method`"));
    };
    let id = id?;
    let params = message.get("params").unwrap_or(&Value::Null);
    let answered = catch_unwind(AssertUnwindSafe(|| result(method, params, alarm)));
    let answered = answered.unwrap_or_else(|_| {
        Err(Failure(INTERNAL, format!("internal error of assur {}", env!("CARGO_PKG_VERSION"))))
    });
    Some(match answered {
        Ok(result) => json!({ "jsonrpc": "2.0", "id": id, "result": result }),
        Err(Failure(code, why)) => refusal(Some(id), code, &why),
    })
}

/// The response to what is not JSON.
pub(super) fn unreadable(why: &str) -> Value {
    refusal(None, PARSE, &format!("this line is no JSON: {why}"))
}

/// The response to a line that is too long.
pub(super) fn too_long() -> Value {
    refusal(None, INVALID_REQUEST, "a message is one line of at most 1 MiB")
}

fn refusal(id: Option<&Value>, code: i32, why: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": why } })
}

fn result(method: &str, params: &Value, alarm: &Alarm) -> Result<Value, Failure> {
    match method {
        "initialize" => Ok(initialize(params)),
        "ping" => Ok(json!({})),
        "tools/list" => Ok(json!({ "tools": tools::list() })),
        "tools/call" => tools::call(params, alarm).map_err(|why| Failure(INVALID_PARAMS, why)),
        "resources/list" => Ok(json!({ "resources": [{
            "uri": CARD, "name": "card", "title": "The language on one page", "mimeType": MARKDOWN,
        }] })),
        "resources/templates/list" => Ok(json!({ "resourceTemplates": [{
            "uriTemplate": "assur://explain/{code}", "name": "explain", "title": "What a diagnostic means", "mimeType": MARKDOWN,
        }] })),
        "resources/read" => resource(params),
        _ => Err(Failure(UNKNOWN_METHOD, format!("there is no method `{method}`"))),
    }
}

fn initialize(params: &Value) -> Value {
    let wanted = params.get("protocolVersion").and_then(Value::as_str).unwrap_or_default();
    let version = VERSIONS.into_iter().find(|own| *own == wanted).unwrap_or(VERSIONS[0]);
    json!({
        "protocolVersion": version,
        "capabilities": { "tools": {}, "resources": {} },
        "serverInfo": { "name": "assur", "title": "assur", "version": env!("CARGO_PKG_VERSION") },
        "instructions": "The language of `.mech` texts is in the resource assur://card.",
    })
}

const CARD: &str = "assur://card";
const MARKDOWN: &str = "text/markdown";

fn resource(params: &Value) -> Result<Value, Failure> {
    let uri = params.get("uri").and_then(Value::as_str).unwrap_or_default();
    let text = match uri.strip_prefix("assur://explain/") {
        _ if uri == CARD => Some(card::page()),
        Some(code) => explain(code).map(str::to_owned),
        None => None,
    };
    match text {
        Some(text) => Ok(json!({ "contents": [{ "uri": uri, "mimeType": MARKDOWN, "text": text }] })),
        None => {
            let example = CODES.first().map_or("", |code| code.code);
            let why = format!(
                "there is no resource `{uri}`: read assur://card or, for a code, assur://explain/{example}"
            );
            Err(Failure(NO_RESOURCE, why))
        }
    }
}
