//! `assur mcp`

mod limits;
mod protocol;
mod tools;

use super::reply::{Status, quiet_panics};
use super::screen::Screen;
use limits::{Alarm, TIME};
use protocol::{LONGEST, answer, too_long, unreadable};
use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{self, BufRead, IsTerminal, Read, Write};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How long past its time a call is waited for: what looks at the alarm between positions ends by itself.
const GRACE: Duration = Duration::from_millis(500);

/// Calls that run at once at the most: a picture is drawn to its end, even if nobody waits for it.
const MOST_OPEN: usize = 4;

/// What comes in.
enum Event {
    Line(Result<Value, String>),
    TooLong,
    /// The answer to the call of this number.
    Answer(u64, Option<Value>),
    End,
}

/// Answers an agent on standard input and output, one message a line, until the stream ends.
pub fn run(screen: &Screen) -> Status {
    if io::stdin().is_terminal() {
        screen.complain(
            "assur mcp is started by an agent: it reads messages of the model context protocol on standard input, one a line; \
             docs/agents.md has the lines for agents\n",
        );
        return Status::Unusable;
    }
    quiet_panics();
    let (sender, receiver) = channel();
    let lines = sender.clone();
    if let Err(error) = thread::Builder::new().spawn(move || read(&lines)) {
        screen.complain(&format!("assur mcp: no thread to read messages: {error}\n"));
        return Status::Unusable;
    }
    match serve(&sender, &receiver) {
        Ok(()) => Status::Fine,
        // nobody reads any more
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Status::Fine,
        Err(_) => Status::Unusable,
    }
}

/// Sends the lines of standard input.
fn read(to: &Sender<Event>) {
    let mut input = io::stdin().lock();
    loop {
        let mut line = Vec::new();
        match input.by_ref().take(LONGEST as u64 + 1).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => break,
            Ok(_) => {}
        }
        let event = if line.len() > LONGEST && line.last() != Some(&b'\n') {
            skip_line(&mut input);
            Event::TooLong
        } else if line.trim_ascii().is_empty() {
            continue;
        } else {
            Event::Line(serde_json::from_slice(&line).map_err(|error| error.to_string()))
        };
        if to.send(event).is_err() {
            return;
        }
    }
    // nobody is there to hear that nobody speaks
    let _ = to.send(Event::End);
}

fn skip_line(input: &mut impl BufRead) {
    loop {
        let Ok(buffer) = input.fill_buf() else { return };
        let (used, done) = match buffer.iter().position(|byte| *byte == b'\n') {
            Some(at) => (at + 1, true),
            None => (buffer.len(), buffer.is_empty()),
        };
        input.consume(used);
        if done {
            return;
        }
    }
}

/// Answers one message after another. A call has a thread of its own, which is not waited for past its time.
fn serve(sender: &Sender<Event>, receiver: &Receiver<Event>) -> io::Result<()> {
    let mut waiting: VecDeque<Event> = VecDeque::new();
    // `open` are the calls that run, with those that nobody waits for
    let (mut number, mut open) = (0, 0);
    loop {
        let Some(event) = waiting.pop_front().or_else(|| receiver.recv().ok()) else { return Ok(()) };
        let message = match event {
            Event::End => return Ok(()),
            // of a call that nobody waits for
            Event::Answer(..) => {
                open -= 1;
                continue;
            }
            Event::TooLong => {
                write(&too_long())?;
                continue;
            }
            Event::Line(Err(why)) => {
                write(&unreadable(&why))?;
                continue;
            }
            Event::Line(Ok(message)) => message,
        };
        let is_cancelled =
            |event: &Event| matches!(event, Event::Line(Ok(other)) if cancels(other, &message));
        if waiting.iter().any(is_cancelled) {
            continue;
        }
        if open >= MOST_OPEN {
            let why = "calls that took too long still run: ask again in some seconds";
            if let Some(answer) = refused(&message, why) {
                write(&answer)?;
            }
            continue;
        }
        number += 1;
        let alarm = Arc::new(Alarm::of_call());
        let (own, to, call) = (Arc::clone(&alarm), sender.clone(), message.clone());
        let spawned = thread::Builder::new().spawn(move || {
            // the program may have ended
            let _ = to.send(Event::Answer(number, answer(&call, &own)));
        });
        if spawned.is_err() {
            return Err(io::Error::other("no thread for a call"));
        }
        open += 1;
        if let Some(answer) = waited(receiver, &mut waiting, (number, &message), (&alarm, &mut open)) {
            write(&answer)?;
        }
    }
}

/// The answer to a call, while other messages wait; none to a notification, nor where the call is cancelled.
fn waited(
    receiver: &Receiver<Event>,
    waiting: &mut VecDeque<Event>,
    (number, message): (u64, &Value),
    (alarm, open): (&Alarm, &mut usize),
) -> Option<Value> {
    // messages that come in meanwhile give it no more time
    let end = Instant::now() + TIME + GRACE;
    loop {
        match receiver.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(Event::Answer(of, answer)) if of == number => {
                *open -= 1;
                return answer;
            }
            Ok(Event::Answer(..)) => *open -= 1,
            Ok(Event::Line(Ok(other))) if cancels(&other, message) => {
                alarm.cancel();
                return None;
            }
            Ok(event) => waiting.push_back(event),
            Err(RecvTimeoutError::Timeout) => {
                alarm.cancel();
                return refused(message, &tools::too_long());
            }
            Err(RecvTimeoutError::Disconnected) => return None,
        }
    }
}

/// The answer to a call that is not made, or not waited for.
fn refused(message: &Value, why: &str) -> Option<Value> {
    let result = json!({ "content": [{ "type": "text", "text": why }], "isError": true });
    Some(json!({ "jsonrpc": "2.0", "id": message.get("id")?, "result": result }))
}

fn cancels(other: &Value, message: &Value) -> bool {
    let id = other.pointer("/params/requestId");
    other["method"] == "notifications/cancelled" && id.is_some() && id == message.get("id")
}

fn write(message: &Value) -> io::Result<()> {
    let mut out = io::stdout().lock();
    writeln!(out, "{message}")?;
    out.flush()
}
