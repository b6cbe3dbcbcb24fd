//! `assur lsp`

use std::io::{self, BufRead, IsTerminal, Read, Write};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;

use super::reply::{Status, quiet_panics};
use super::screen::Screen;
use crate::lsp::Server;
use serde_json::Value;

/// The most bytes of a message; no text of a mechanism is as long.
const LONGEST: usize = 64 << 20;

/// A message, or why it is none.
type Received = Result<Value, String>;

/// Answers an editor on standard input and output until it says `exit` or closes the stream.
pub fn run(screen: &Screen) -> Status {
    if io::stdin().is_terminal() {
        screen.complain(
            "assur lsp is started by an editor: it reads messages of the language server protocol on standard input; \
             docs/editors.md has the lines for editors\n",
        );
        return Status::Unusable;
    }
    quiet_panics();
    let (sender, receiver) = channel();
    // ends with the stream, or with the program
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        while let Ok(Some(message)) = read(&mut input) {
            if sender.send(message).is_err() {
                break;
            }
        }
    });
    let mut server = Server::default();
    match serve(&mut server, &receiver) {
        Ok(()) if server.is_over() && !server.is_closed() => Status::Wrong,
        Ok(()) => Status::Fine,
        // nobody reads any more
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Status::Fine,
        Err(_) => Status::Unusable,
    }
}

/// Handles messages as they come; diagnostics go out when none waits.
fn serve(server: &mut Server, receiver: &Receiver<Received>) -> io::Result<()> {
    while !server.is_over() {
        let received = match receiver.try_recv() {
            Ok(received) => received,
            Err(TryRecvError::Disconnected) => return Ok(()),
            Err(TryRecvError::Empty) => {
                write(&server.publish())?;
                let Ok(received) = receiver.recv() else { return Ok(()) };
                received
            }
        };
        write(&match received {
            Ok(message) => server.handle(&message),
            Err(why) => vec![Server::unreadable(&why)],
        })?;
    }
    Ok(())
}

/// The next message; nothing at the end of the stream.
fn read(input: &mut impl BufRead) -> io::Result<Option<Received>> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line)? == 0 {
            return Ok(None);
        }
        let line = line.trim();
        if line.is_empty() {
            break;
        }
        let (name, value) = line.split_once(':').unwrap_or((line, ""));
        if name.eq_ignore_ascii_case("content-length") {
            length = value.trim().parse::<usize>().ok().filter(|length| *length <= LONGEST);
        }
    }
    let Some(length) = length else { return Ok(Some(Err("no Content-Length before it".to_owned()))) };
    let mut body = Vec::new();
    if input.take(length as u64).read_to_end(&mut body)? < length {
        return Ok(None);
    }
    Ok(Some(serde_json::from_slice(&body).map_err(|error| error.to_string())))
}

fn write(messages: &[Value]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    for message in messages {
        let body = message.to_string();
        write!(out, "Content-Length: {}\r\n\r\n{body}", body.len())?;
    }
    out.flush()
}
