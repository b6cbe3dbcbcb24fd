//! Pages on a port of this machine alone, each behind a random key. One thread per request: a browser has few.

use super::board::Board;
use super::request::{Refusal, Request};
use std::collections::{BTreeMap, VecDeque};
use std::io::{self, BufReader, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// The page around a picture.
const PAGE: &str = include_str!("page.html");
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
            Ok((_, "")) => whole(stream, "200 OK", "text/html", PAGE),
            Ok((board, "picture")) => match board.picture() {
                Some(picture) => whole(stream, "200 OK", "text/html", &picture),
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
    frame-src 'self'; base-uri 'none'; form-action 'none'\r\nConnection: close\r\n";

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
