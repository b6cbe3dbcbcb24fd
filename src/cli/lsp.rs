//! `assur lsp`

use std::io::{self, BufRead, IsTerminal, Read, Write};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::preview::{Moves, Pages};
use super::reply::{Status, quiet_panics};
use super::screen::Screen;
use crate::lsp::{Server, Stop};
use serde_json::{Value, json};

/// The most bytes of a message; no text of a mechanism is as long.
const LONGEST: usize = 64 << 20;

/// The most bytes of a line of a header.
const LONGEST_HEADER: u64 = 4 << 10;
/// A pause of the author before a text is solved.
const PAUSE: Duration = Duration::from_millis(50);
/// A text that takes longer has no answers in the editor.
const LONGEST_SOLUTION: Duration = Duration::from_secs(2);

/// A message, or why it is none; nothing at the end of the stream.
type Received = Option<Result<Value, Unread>>;

/// Why a message is none.
enum Unread {
    /// Its body does not read; the next one begins behind it.
    Body(String),
    /// Nobody knows where the next one begins.
    Framing(String),
}

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
    let to_server = sender.clone();
    let reading = thread::Builder::new().spawn(move || {
        let mut input = io::stdin().lock();
        while let Ok(Some(message)) = read(&mut input) {
            let is_lost = matches!(message, Err(Unread::Framing(_)));
            if sender.send(Some(message)).is_err() {
                return;
            }
            if is_lost {
                break;
            }
        }
        // nobody is there to hear that nobody listens
        let _ = sender.send(None);
    });
    if let Err(error) = reading {
        screen.complain(&format!("assur lsp: no thread to read messages: {error}\n"));
        return Status::Unusable;
    }
    // where a page is moved goes the way of messages
    let moves: Moves = Arc::new(move |uri: &str, part: f64| {
        let params = json!({ "uri": uri, "part": part });
        let message = json!({ "jsonrpc": "2.0", "method": "assur/pose", "params": params });
        let _ = to_server.send(Some(Ok(message)));
    });
    let mut server = Server::with_pages(Box::new(Pages::with_moves(moves)));
    match serve(&mut server, &Inbox::new(receiver)) {
        Ok(()) if server.is_over() && !server.is_closed() => Status::Wrong,
        Ok(()) => Status::Fine,
        // nobody reads any more
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Status::Fine,
        Err(error) => {
            if error.kind() == io::ErrorKind::InvalidData {
                screen.complain(&format!("assur lsp: {error}\n"));
            }
            Status::Unusable
        }
    }
}

/// Messages as they come in. Whether one waits can be seen without taking it.
struct Inbox {
    inside: Mutex<(Receiver<Received>, Option<Received>)>,
}

impl Inbox {
    fn new(receiver: Receiver<Received>) -> Self {
        Self { inside: Mutex::new((receiver, None)) }
    }

    /// Whether a message comes within a time; at the end of the stream too, which is then found by [`Inbox::next`].
    fn waits(&self, time: Duration) -> bool {
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        let (receiver, next) = &mut *inside;
        if next.is_none() {
            match receiver.recv_timeout(time) {
                Ok(received) => *next = Some(received),
                Err(RecvTimeoutError::Timeout) => return false,
                Err(RecvTimeoutError::Disconnected) => {}
            }
        }
        true
    }

    /// The next message; nothing at the end of the stream.
    fn next(&self) -> Received {
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        let (receiver, next) = &mut *inside;
        next.take().or_else(|| receiver.recv().ok()).flatten()
    }
}

/// Handles messages as they come. Diagnostics go out when none waits; in a longer pause texts are solved, until the next comes.
fn serve(server: &mut Server, inbox: &Inbox) -> io::Result<()> {
    while !server.is_over() {
        if !inbox.waits(Duration::ZERO) {
            write(&server.publish())?;
            if !inbox.waits(PAUSE) {
                let begun = Instant::now();
                let patience = || match inbox.waits(Duration::ZERO) {
                    true => Some(Stop::Later),
                    false => (begun.elapsed() > LONGEST_SOLUTION).then_some(Stop::Never),
                };
                write(&server.solve(&patience))?;
            }
        }
        let Some(received) = inbox.next() else { return Ok(()) };
        match received {
            Ok(message) => write(&server.handle(&message))?,
            Err(Unread::Body(why)) => write(&[Server::unreadable(&why)])?,
            Err(Unread::Framing(why)) => {
                write(&[Server::unreadable(&why)])?;
                return Err(io::Error::new(io::ErrorKind::InvalidData, why));
            }
        }
    }
    Ok(())
}

/// The next message; nothing at the end of the stream.
fn read(input: &mut impl BufRead) -> io::Result<Received> {
    let lost = |why: &str| Ok(Some(Err(Unread::Framing(format!("{why}: the stream cannot be read on")))));
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.by_ref().take(LONGEST_HEADER).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            break;
        }
        let (name, value) = line.split_once(':').unwrap_or((line, ""));
        if name.eq_ignore_ascii_case("content-length") {
            length = value.trim().parse::<usize>().ok().filter(|length| *length <= LONGEST);
        }
    }
    let Some(length) = length else { return lost("a message without a Content-Length of at most 64 MiB") };
    let mut body = Vec::new();
    if input.take(length as u64).read_to_end(&mut body)? < length {
        return Ok(None);
    }
    Ok(Some(serde_json::from_slice(&body).map_err(|error| Unread::Body(error.to_string()))))
}

fn write(messages: &[Value]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    for message in messages {
        let body = message.to_string();
        write!(out, "Content-Length: {}\r\n\r\n{body}", body.len())?;
    }
    out.flush()
}
