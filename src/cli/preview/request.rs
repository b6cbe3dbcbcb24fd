//! What a browser asks for, as far as a page of ours is concerned.

use std::io::BufRead;

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
