//! Pages on a port of this machine alone, each behind a random key. One thread per request: a browser has few.

use super::board::Board;
use assur_picture::{PLAYER, PLAYER_STYLE};
use std::collections::{BTreeMap, VecDeque};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::process::{Command, Stdio};
use std::sync::{
    Arc, LazyLock, Mutex, MutexGuard, PoisonError,
    atomic::{AtomicUsize, Ordering},
};
use std::thread;
use std::time::Duration;

/// The page around a picture, with the player.
static PAGE: LazyLock<String> = LazyLock::new(|| {
    let page = include_str!("page.html").replace("/* PLAYER STYLE */", PLAYER_STYLE);
    page.replace("/* PLAYER */", PLAYER)
});
const MOST: usize = 64;
/// What a browser may take to send a request, or to read an answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// Where nothing changes, a word to see whether the browser is still there.
const PULSE: Duration = Duration::from_secs(15);
/// Bytes that are read of a request that is refused.
const REST: u64 = 64 << 10;
/// Bytes of a key.
const KEY: usize = 16;

/// Pages of one process.
#[derive(Debug)]
pub struct Site {
    port: u16,
    boards: Mutex<BTreeMap<String, Arc<Board>>>,
    open: AtomicUsize,
    /// Connections that have sent no request yet, the oldest first.
    silent: Mutex<VecDeque<(usize, TcpStream)>>,
}

impl Site {
    /// Serves on a port, 0 for one that is free, until the program ends.
    pub fn start(port: u16) -> io::Result<Arc<Self>> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = listener.local_addr()?.port();
        let site = Arc::new(Self {
            port,
            boards: Mutex::default(),
            open: AtomicUsize::new(0),
            silent: Mutex::default(),
        });
        let serving = Arc::clone(&site);
        thread::Builder::new().spawn(move || serving.accept(&listener))?;
        Ok(site)
    }

    /// The address of a new page.
    pub fn add(&self, board: &Arc<Board>) -> io::Result<String> {
        let mut bytes = [0; KEY];
        getrandom::fill(&mut bytes).map_err(|error| io::Error::other(error.to_string()))?;
        let key: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        let address = format!("http://127.0.0.1:{}/{key}/", self.port);
        self.boards.lock().unwrap_or_else(PoisonError::into_inner).insert(key, Arc::clone(board));
        Ok(address)
    }

    fn silent(&self) -> MutexGuard<'_, VecDeque<(usize, TcpStream)>> {
        self.silent.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Closes the oldest connection that has sent nothing, if there is one.
    fn close_silent(&self) -> bool {
        let oldest = self.silent().pop_front();
        oldest.is_some_and(|(_, stream)| stream.shutdown(Shutdown::Both).is_ok())
    }

    /// A connection has sent its request, or is closed.
    fn is_heard(&self, number: usize) {
        self.silent().retain(|(other, _)| *other != number);
    }

    fn accept(self: &Arc<Self>, listener: &TcpListener) {
        let mut number = 0;
        for stream in listener.incoming() {
            let Ok(stream) = stream else {
                // no files are left: wait for some
                thread::sleep(Duration::from_millis(50));
                continue;
            };
            number += 1;
            if self.open.fetch_add(1, Ordering::Relaxed) >= MOST && !self.close_silent() {
                self.open.fetch_sub(1, Ordering::Relaxed);
                continue;
            }
            if let Ok(other) = stream.try_clone() {
                self.silent().push_back((number, other));
            }
            let site = Arc::clone(self);
            let answering = move || {
                // a browser that went away needs no answer
                let _ = site.answer(&stream, number);
                site.is_heard(number);
                site.open.fetch_sub(1, Ordering::Relaxed);
            };
            if thread::Builder::new().spawn(answering).is_err() {
                self.open.fetch_sub(1, Ordering::Relaxed);
            }
        }
    }

    fn answer(&self, stream: &TcpStream, number: usize) -> io::Result<()> {
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        let request = Request::read(BufReader::new(stream));
        self.is_heard(number);
        let found = request.as_ref().map_err(|refusal| *refusal).and_then(|request| {
            let (key, part) = request.page(self.port)?;
            let board = self.boards.lock().unwrap_or_else(PoisonError::into_inner).get(key).cloned();
            Ok((board.ok_or(Refusal::Missing)?, part))
        });
        match found {
            Ok((_, "")) => whole(stream, "200 OK", "text/html", &PAGE),
            Ok((board, "picture")) => match board.picture() {
                Some(picture) => whole(stream, "200 OK", "application/json", &picture),
                None => refuse(stream, Refusal::Missing),
            },
            Ok((board, "events")) => events(stream, &board),
            Ok((board, "pose")) => match request.ok().and_then(|request| request.query()?.parse().ok()) {
                Some(part) => {
                    board.moved(part);
                    whole(stream, "200 OK", "text/plain", "")
                }
                None => refuse(stream, Refusal::Bad),
            },
            Ok(_) => refuse(stream, Refusal::Missing),
            Err(refusal) => refuse(stream, refusal),
        }
    }
}

/// What is shown, and then whatever is shown next, until the browser goes away.
fn events(mut stream: &TcpStream, board: &Board) -> io::Result<()> {
    write!(stream, "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\n{HEADERS}\r\n")?;
    let mut version = 0;
    loop {
        match board.after(version, PULSE) {
            Some((next, state)) => {
                version = next;
                write!(stream, "data: {state}\n\n")?;
            }
            None => write!(stream, ":\n\n")?,
        }
        stream.flush()?;
    }
}

/// Nothing is kept, nothing is loaded from elsewhere, the address goes to no other site.
const HEADERS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
    Content-Security-Policy: default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; connect-src 'self'; \
    base-uri 'none'; form-action 'none'\r\nConnection: close\r\n";

/// What is still on its way is read, a little of it: a connection that is closed before loses the answer.
fn refuse(stream: &TcpStream, refusal: Refusal) -> io::Result<()> {
    whole(stream, refusal.status(), "text/plain", refusal.status())?;
    stream.shutdown(Shutdown::Write)?;
    io::copy(&mut stream.take(REST), &mut io::sink()).map(drop)
}

fn whole(mut stream: &TcpStream, status: &str, kind: &str, body: &str) -> io::Result<()> {
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\n{HEADERS}\r\n{body}",
        body.len()
    )?;
    stream.flush()
}

// What a browser asks for, as far as a page of ours is concerned.

/// The most bytes of a head; browsers send a thousand.
const LONGEST: u64 = 16 << 10;

/// The head of a request.
#[derive(Debug, Default)]
pub struct Request {
    method: String,
    target: String,
    host: Option<String>,
    origin: Option<String>,
}

/// Why a request has no answer: the status of HTTP.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It does not read.
    Bad,
    /// Another host or another origin.
    Foreign,
    /// Another method than GET.
    Method,
    /// No such page, or not the key.
    Missing,
}

impl Refusal {
    /// Number and words of HTTP.
    pub const fn status(self) -> &'static str {
        match self {
            Self::Bad => "400 Bad Request",
            Self::Foreign => "403 Forbidden",
            Self::Method => "405 Method Not Allowed",
            Self::Missing => "404 Not Found",
        }
    }
}

impl Request {
    pub fn read(stream: impl BufRead) -> Result<Self, Refusal> {
        let mut lines = stream.take(LONGEST);
        let mut line = || {
            let mut line = String::new();
            match lines.read_line(&mut line) {
                Ok(_) if line.ends_with('\n') => Ok(line.trim_end().to_owned()),
                _ => Err(Refusal::Bad),
            }
        };
        let first = line()?;
        let mut words = first.split(' ');
        let (Some(method), Some(target), Some(version), None) =
            (words.next(), words.next(), words.next(), words.next())
        else {
            return Err(Refusal::Bad);
        };
        if !version.starts_with("HTTP/1.") {
            return Err(Refusal::Bad);
        }
        let mut request = Self { method: method.to_owned(), target: target.to_owned(), ..Self::default() };
        loop {
            let line = line()?;
            if line.is_empty() {
                return Ok(request);
            }
            let (name, value) = line.split_once(':').ok_or(Refusal::Bad)?;
            let field = match name.to_ascii_lowercase().as_str() {
                "host" => &mut request.host,
                "origin" => &mut request.origin,
                _ => continue,
            };
            if field.replace(value.trim().to_owned()).is_some() {
                return Err(Refusal::Bad);
            }
        }
    }

    /// What is behind the question mark.
    pub fn query(&self) -> Option<&str> {
        Some(self.target.split_once('?')?.1)
    }

    /// The key and what is asked for behind it, of a request for a page of ours on this port: other sites of the browser know
    /// neither, and a name that somebody lets lead to this machine is another host.
    pub fn page(&self, port: u16) -> Result<(&str, &str), Refusal> {
        let ours = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        let host = self.host.as_ref().filter(|host| ours.contains(host)).ok_or(Refusal::Foreign)?;
        if self.origin.as_ref().is_some_and(|origin| *origin != format!("http://{host}")) {
            return Err(Refusal::Foreign);
        }
        if self.method != "GET" {
            return Err(Refusal::Method);
        }
        let path = self.target.split('?').next().unwrap_or_default();
        path.strip_prefix('/').and_then(|path| path.split_once('/')).ok_or(Refusal::Missing)
    }
}

// The program of the system that opens an address.

/// Opens an address in the browser. Where nothing can open it, the address was printed.
pub fn open(address: &str) {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        Command::new("explorer")
    } else {
        Command::new("xdg-open")
    };
    let quiet = command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Ok(mut child) = quiet.spawn() {
        // it is over at once, or stays for as long as the browser
        thread::spawn(move || child.wait());
    }
}
