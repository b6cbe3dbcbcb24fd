//! `assur preview`: requests over loopback, with the key and without.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a test without its page has failed

use crate::run::{Folder, Said, assur, end, start};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::ops::Deref;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const CRANK: &str = "mech 1\nground { A (0, 0) }\nlink crank A-B 100 mm\nrevolute A: ground - crank\n\
    drive crank = 0 deg .. 360 deg in 12 steps at 60 rpm\nfind vx = velocity(crank.B).x\n";
/// A page never waits as long.
const PATIENCE: Duration = Duration::from_secs(30);

/// A page by its address.
struct Page {
    port: u16,
    key: String,
}

impl Page {
    fn at(address: &str) -> Self {
        let behind = address.strip_prefix("http://127.0.0.1:").unwrap_or_else(|| panic!("{address}"));
        let (port, key) = behind.split_once('/').unwrap();
        Self { port: port.parse().unwrap(), key: key.strip_suffix('/').unwrap().to_owned() }
    }

    /// What is answered to the lines of a head.
    fn ask(&self, first: &str, fields: &[&str]) -> String {
        let mut stream = self.connect();
        write!(stream, "{first} HTTP/1.1\r\n{}\r\n\r\n", fields.join("\r\n")).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port)).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream
    }

    fn get(&self, part: &str) -> String {
        self.ask(&format!("GET /{}/{part}", self.key), &[&format!("Host: 127.0.0.1:{}", self.port)])
    }

    /// The picture with its bar and its plot.
    fn markup(&self) -> String {
        let answer = self.get("picture");
        let body = answer.split_once("\r\n\r\n").expect("a body").1;
        serde_json::from_str::<Value>(body).expect("JSON")["markup"].as_str().expect("markup").to_owned()
    }

    /// What is shown, one after another.
    fn events(&self) -> impl FnMut() -> Value {
        let mut stream = self.connect();
        write!(stream, "GET /{}/events HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", self.key, self.port).unwrap();
        let mut lines = BufReader::new(stream).lines();
        move || {
            let data = lines.find_map(|line| line.unwrap().strip_prefix("data: ").map(str::to_owned));
            serde_json::from_str(&data.unwrap()).unwrap()
        }
    }
}

/// A program that shows a file.
struct Preview {
    child: Option<Child>,
    page: Page,
}

impl Deref for Preview {
    type Target = Page;

    fn deref(&self) -> &Page {
        &self.page
    }
}

impl Preview {
    fn of(folder: &Folder, words: &[&str]) -> Self {
        let mut child = start(folder, &[&["preview", "--no-open"], words].concat());
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
        Self { child: Some(child), page: Page::at(line.trim()) }
    }

    /// Ends it with a signal.
    fn interrupt(mut self) -> Said {
        let child = self.child.take().unwrap();
        let done = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(done.success());
        end(child)
    }
}

impl Drop for Preview {
    fn drop(&mut self) {
        if let Some(mut child) = self.child.take() {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

fn status(answer: &str) -> &str {
    answer.split(' ').nth(1).unwrap()
}

#[test]
fn a_page_shows_the_picture_and_the_answers() {
    let folder = Folder::new("preview").with("crank.mech", CRANK);
    let preview = Preview::of(&folder, &["crank.mech"]);
    assert_eq!(preview.key.len(), 32, "{}", preview.key);
    let page = preview.get("");
    assert!(
        page.starts_with("HTTP/1.1 200 OK\r\n") && page.contains("new EventSource(\"events\")"),
        "{page}"
    );
    assert!(page.contains("default-src 'none'") && page.contains("Cache-Control: no-store"), "{page}");
    let shown = preview.events()();
    assert_eq!(
        (&shown["name"], &shown["old"], &shown["diagnostics"]),
        (&"crank.mech".into(), &false.into(), &"".into())
    );
    assert!(shown["answers"].as_str().unwrap().contains("vx"), "{shown}");
    let of = |name: &str, class: &str| {
        let all = shown["declared"].as_array().unwrap();
        all.iter().find(|d| d["name"] == name && d["class"] == class).unwrap().clone()
    };
    assert_eq!((&of("crank", "link")["line"], &of("A", "pair")["line"]), (&3.into(), &4.into()));
    assert_eq!(of("crank", "link")["text"], "link crank A-B 100 mm");
    let picture = preview.markup();
    assert!(picture.contains("data-name=\"crank\"") && picture.contains("type=\"range\""), "{picture}");
    let said = preview.interrupt();
    assert_eq!((said.status, said.stderr.as_str()), (130, ""));
}

#[test]
fn nobody_without_the_key_and_no_other_site_is_answered() {
    let folder = Folder::new("preview-key").with("crank.mech", CRANK);
    let preview = Preview::of(&folder, &["crank.mech"]);
    let (key, port) = (&preview.key, preview.port);
    let host = format!("Host: 127.0.0.1:{port}");
    let other = "0".repeat(32);
    let mine = format!("GET /{key}/");
    let origin = format!("Origin: http://127.0.0.1:{port}");
    for (first, fields, wanted) in [
        (mine.as_str(), vec![host.as_str()], "200"),
        (&mine, vec![&host, &origin], "200"),
        (&format!("GET /{other}/"), vec![&host], "404"),
        ("GET /", vec![&host], "404"),
        (&format!("GET /{key}"), vec![&host], "404"),
        (&format!("GET /{key}/../{key}/"), vec![&host], "404"),
        (&format!("GET /{key}/other"), vec![&host], "404"),
        (&mine, vec![], "403"),
        (&mine, vec!["Host: example.com"], "403"),
        (&mine, vec![&host, "Origin: http://example.com"], "403"),
        (&mine, vec![&host, "Origin: null"], "403"),
        (&format!("POST /{key}/"), vec![&host], "405"),
        (&mine, vec![&host, &host], "400"),
        (&mine, vec![&host, "no colon"], "400"),
        ("GET", vec![&host], "400"),
    ] {
        let answer = preview.ask(first, &fields);
        assert_eq!(status(&answer), wanted, "{first} {fields:?}: {answer}");
        assert!(wanted == "200" || !answer.contains(key.as_str()), "{answer}");
    }
    let long = preview.ask(&mine, &[&host, &format!("X: {}", "x".repeat(20_000))]);
    assert_eq!(status(&long), "400");
}

#[test]
fn a_change_of_the_file_arrives_and_errors_keep_the_picture() {
    let folder = Folder::new("preview-change").with("crank.mech", CRANK);
    let preview = Preview::of(&folder, &["crank.mech"]);
    let mut next = preview.events();
    let first = next();
    folder.write_bytes("crank.mech", CRANK.replace("link crank", "lnk <b>&crank").as_bytes());
    let wrong = next();
    assert_eq!((&wrong["old"], &wrong["picture"]), (&true.into(), &first["picture"]));
    assert!(wrong["diagnostics"].as_str().unwrap().contains("lnk <b>&crank"), "{wrong}");
    assert!(wrong["answers"].as_str().unwrap().contains("vx"), "{wrong}");
    assert!(preview.markup().contains("data-name=\"crank\""));
    folder.write_bytes("crank.mech", CRANK.replace("crank", "arm").as_bytes());
    let right = next();
    assert_eq!((&right["old"], &right["diagnostics"]), (&false.into(), &"".into()));
    assert!(right["picture"].as_u64() > first["picture"].as_u64());
    assert!(preview.markup().contains("data-name=\"arm\""));
    std::fs::remove_file(folder.path("crank.mech")).unwrap();
    let gone = next();
    assert!(
        gone["old"] == true && gone["diagnostics"].as_str().unwrap().contains("cannot be read"),
        "{gone}"
    );
    folder.write_bytes("crank.mech", CRANK.as_bytes());
    assert_eq!(next()["old"], false);
    folder.write_bytes("crank.mech", b"");
    let empty = next();
    assert!(empty["diagnostics"].as_str().unwrap().contains("the file is empty"), "{empty}");
}

/// Connections that say nothing make room for one that asks.
#[test]
fn silent_connections_do_not_keep_a_browser_out() {
    let folder = Folder::new("preview-silent").with("crank.mech", CRANK);
    let preview = Preview::of(&folder, &["crank.mech"]);
    let silent: Vec<TcpStream> = (0..70).map(|_| preview.connect()).collect();
    let begun = Instant::now();
    for _ in 0..10 {
        assert_eq!(status(&preview.get("")), "200");
    }
    assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
    drop(silent);
}

/// What becomes a pipe is said, and a file in its place is shown again.
#[test]
fn a_file_that_becomes_a_pipe_is_said() {
    let folder = Folder::new("preview-pipe").with("crank.mech", CRANK);
    let preview = Preview::of(&folder, &["crank.mech"]);
    let mut events = preview.events();
    events();
    std::fs::remove_file(folder.path("crank.mech")).unwrap();
    assert!(Command::new("mkfifo").arg(folder.path("crank.mech")).status().unwrap().success());
    let begun = Instant::now();
    while !events().to_string().contains("is none") {
        assert!(begun.elapsed() < PATIENCE);
    }
    std::fs::remove_file(folder.path("crank.mech")).unwrap();
    std::fs::write(folder.path("crank.mech"), CRANK.replace("100 mm", "120 mm")).unwrap();
    while events().to_string().contains("is none") {
        assert!(begun.elapsed() < PATIENCE);
    }
    assert_eq!(status(&preview.get("picture")), "200");
}

#[test]
fn names_in_a_picture_are_escaped() {
    let text = CRANK.replace("mech 1\n", "mech 1\nmechanism \"</script><script>alert(1)</script>\"\n");
    let folder = Folder::new("preview-escaped").with("crank.mech", &text);
    let preview = Preview::of(&folder, &["crank.mech"]);
    assert_eq!(preview.events()()["old"], false);
    assert!(!preview.markup().contains("<script>alert"));
}

#[test]
fn what_cannot_be_shown_is_said() {
    let folder = Folder::new("preview-wrong").with("crank.mech", CRANK);
    let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    for (words, wanted) in [
        (
            &["crank.mech", "--no-open", "--port", &port][..],
            &*format!("the page cannot be served on port {port}"),
        ),
        (&["other.mech"], "there is no file or folder `other.mech`"),
        (&["-"], "`assur preview` follows one file, and `-` is none"),
        (&["."], "`assur preview` follows one file, and `.` is none"),
        (&["crank.mech", "--port", "0"], "0 is not in 1..=65535"),
    ] {
        let said = assur(&folder, &[&["preview"], words].concat());
        assert_eq!((said.status, said.stdout.as_str()), (2, ""), "{words:?}");
        assert!(said.stderr.contains(wanted), "{words:?}: {}", said.stderr);
    }
}

/// A program that answers an editor.
#[cfg(feature = "lsp")]
struct Session {
    child: Child,
}

#[cfg(feature = "lsp")]
impl Session {
    fn start() -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
        let piped = command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped());
        Self { child: piped.spawn().unwrap() }
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.child.stdin.as_mut().unwrap(), "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
    }

    fn notify(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.send(&json!({ "jsonrpc": "2.0", "id": method, "method": method, "params": params }));
        self.wait(|message| message["id"] == method)
    }

    /// The next message of a kind.
    fn wait(&mut self, is_wanted: impl Fn(&Value) -> bool) -> Value {
        loop {
            let message = self.next();
            if is_wanted(&message) {
                return message;
            }
        }
    }

    fn next(&mut self) -> Value {
        let out = self.child.stdout.as_mut().unwrap();
        let mut head = Vec::new();
        while !head.ends_with(b"\r\n\r\n") {
            let mut byte = [0];
            out.read_exact(&mut byte).unwrap();
            head.push(byte[0]);
        }
        let length = String::from_utf8(head).unwrap().trim().rsplit(' ').next().unwrap().parse().unwrap();
        let mut body = vec![0; length];
        out.read_exact(&mut body).unwrap();
        serde_json::from_slice(&body).unwrap()
    }
}

#[cfg(feature = "lsp")]
#[test]
fn an_editor_shows_a_text_that_has_no_file() {
    let uri = "untitled:crank";
    let mut session = Session::start();
    let capabilities = json!({ "window": { "showDocument": { "support": true } } });
    session.ask("initialize", &json!({ "capabilities": capabilities }));
    session.notify("initialized", &json!({}));
    let opened = json!({ "uri": uri, "languageId": "mech", "version": 1, "text": CRANK });
    session.notify("textDocument/didOpen", &json!({ "textDocument": opened }));
    let command = json!({ "command": "assur.preview", "arguments": [uri] });
    let answer = session.ask("workspace/executeCommand", &command);
    let address = answer["result"]["address"].as_str().unwrap().to_owned();
    let shown = session.wait(|message| message["method"] == "window/showDocument");
    assert_eq!((&shown["params"]["uri"], &shown["params"]["external"]), (&json!(address), &json!(true)));
    // a second time it is the same page, and what shows it by itself is not asked to
    let quiet = json!({ "command": "assur.preview", "arguments": [uri, false] });
    assert_eq!(session.ask("workspace/executeCommand", &quiet)["result"]["address"], json!(address));

    let page = Page::at(&address);
    let mut next = page.events();
    assert_eq!((&next()["old"], page.markup().contains("data-name=\"crank\"")), (&json!(false), true));
    for (version, text, is_old) in
        [(2, CRANK.replace("link", "lnk"), true), (3, CRANK.replace("crank", "arm"), false)]
    {
        let change = json!({ "textDocument": { "uri": uri, "version": version }, "contentChanges": [{ "text": text }] });
        session.notify("textDocument/didChange", &change);
        assert_eq!(next()["old"], json!(is_old));
    }
    assert!(page.markup().contains("data-name=\"arm\""));
    let said = session.ask("assur/picture", &json!({ "uri": uri, "pose": "4" }));
    let picture = &said["result"];
    assert!(picture["svg"].as_str().unwrap().contains("data-name=\"arm\""), "{said}");
    assert_eq!(picture["poses"].as_array().unwrap().len(), 12);
    let place = picture["places"].as_array().unwrap().iter().find(|p| p["name"] == "arm").unwrap();
    assert_eq!((&place["class"], &place["range"]["start"]["line"]), (&json!("link"), &json!(2)));
    let wrong = session.ask("assur/picture", &json!({ "uri": uri, "pose": "40" }));
    assert!(wrong["error"]["message"].as_str().unwrap().contains("no solved pose is named `40`"), "{wrong}");
    // the page and the editor are at one place: what is highlighted is marked, and values are those of the pose
    let crank = json!({ "textDocument": { "uri": uri }, "position": { "line": 2, "character": 6 } });
    session.ask("textDocument/documentHighlight", &crank);
    assert_eq!(next()["marked"], json!({ "class": "link", "name": "arm" }));
    let answer = json!({ "textDocument": { "uri": uri }, "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 6, "character": 0 } } });
    let hints = |session: &mut Session| session.ask("textDocument/inlayHint", &answer)["result"].to_string();
    let all = hints(&mut session);
    assert!(all.contains(" … ") && !all.contains("(pose "), "{all}");
    page.get("pose?0.5");
    let begun = Instant::now();
    while !hints(&mut session).contains("(pose ") {
        assert!(begun.elapsed() < Duration::from_secs(10), "{}", hints(&mut session));
    }
    drop(session.child.stdin.take());
    assert_eq!(session.child.wait().unwrap().code(), Some(0));
}
