//! `assur batch`: files × rows of variants, in parallel, in the order of the input.

#[cfg(feature = "arrow")]
mod columns;
mod filled;
mod job;
mod layout;
mod line;
mod piece;
mod rows;
mod run;

use std::borrow::Cow;
use std::path::Path;

use super::args::{Batch, Format};
use super::error::CliError;
use super::files;
use super::reply::{Status, complaint, quiet_panics};
use super::screen::Screen;
use super::sink::{Sink, place};
use super::stop;
use assur_text::source::shown_in_line;
use filled::Out;
pub use job::open_table;
use job::{Job, has_columns, lacking};
use layout::Layout;
use run::Run;

use run::Tally;

/// Stack of a thread: that of the main thread.
const STACK: usize = 8 << 20;

/// Solves all rows of all files.
pub fn run(args: &Batch, screen: &Screen) -> Status {
    quiet_panics();
    stop::install();
    let threads = args.threads.unwrap_or(0);
    let pool = || rayon::ThreadPoolBuilder::new().stack_size(STACK);
    // where no thread can be had, this one does the work
    let pool =
        pool().num_threads(threads).build().or_else(|_| pool().num_threads(1).use_current_thread().build());
    let done = match pool {
        Ok(pool) => pool.install(|| all(args, screen)),
        Err(error) => Err(CliError::Threads { why: error.to_string() }),
    };
    done.unwrap_or_else(|error| {
        screen.complain(&complaint(error, screen));
        Status::Unusable
    })
}

fn all(args: &Batch, screen: &Screen) -> Result<Status, CliError> {
    let overrides = args.problem.overrides();
    let mut status = Status::Fine;
    let mut jobs = Vec::new();
    for input in files::expand(&args.problem.files) {
        let job = input
            .and_then(files::Input::read)
            .and_then(|source| Job::new(source, &overrides, args.variants.as_deref(), args.within, screen));
        match job {
            Ok(Ok(job)) => jobs.push(job),
            Ok(Err(found)) => status = status.max(found),
            Err(error) => {
                status = status.max(Status::after(&error));
                screen.complain(&complaint(error, screen));
            }
        }
    }
    keeps_inputs(args)?;
    if let Some((name, feature)) = args.out.as_ref().and_then(|name| Some((name, lacking(name)?))) {
        return Err(CliError::NoColumns { name: name.clone(), feature });
    }
    if let Some(name) = args.key.as_ref().filter(|name| has_columns(name)) {
        return Err(CliError::KeyOfColumns { name: name.clone() });
    }
    if jobs.is_empty() {
        return Ok(status);
    }
    let all = status != Status::Unusable;
    // columns are filled line by line as comma-separated values are
    let format = if args.format().is_columns() { Format::Csv } else { args.format() };
    // pages to read have a table per file below its name
    let own = |job| Layout::of(std::slice::from_ref(job), format);
    let layout = (!format.is_read()).then(|| Layout::of(&jobs, format));
    let key = Layout::of_key(&jobs);
    let mut out = Out::of(args, &jobs)?;
    let columns = out.takes_columns();
    let mut key_out = match &args.key {
        Some(path) => Some(Sink::file(Path::new(path))?),
        None => None,
    };
    if let Some(layout) = layout.as_ref().filter(|_| format == Format::Csv && !columns) {
        out.write(layout.header())?;
    }
    if let Some(sink) = &mut key_out {
        sink.write(key.header())?;
    }
    let mut total = Tally::default();
    for (i, job) in jobs.iter().enumerate() {
        if i > 0 && format.is_read() {
            out.write(format.apart())?;
        }
        if let Some(table) = job.left_out.clone().filter(|_| !matches!(format, Format::Json | Format::Jsonl))
        {
            screen.complain(&complaint(table, screen));
        }
        let layout = layout.as_ref().map_or_else(|| Cow::Owned(own(job)), Cow::Borrowed);
        let key = key_out.is_some().then_some(&key);
        let run = Run { job, format, layout: &layout, key, columns, screen };
        let tally = run.all(&mut out, &mut key_out)?;
        screen.complain(&format!("{}: {}\n", shown_in_line(&job.source.name), tally.summary()));
        total.add(&tally);
        if out.closed() || stop::wanted() {
            break;
        }
    }
    if jobs.len() > 1 {
        screen.complain(&format!("{} files: {}\n", jobs.len(), total.in_short()));
    }
    let out = out.end()?;
    if total.rows() == total.failed() {
        // a key without a row
        key_out = None;
    }
    if stop::wanted() || !all {
        let kept = [Some(out), key_out].into_iter().flatten().filter_map(|s| s.keep_part().transpose());
        let kept = kept.collect::<Result<Vec<_>, _>>()?.join(", ");
        if stop::wanted() {
            screen.complain(&complaint(CliError::Interrupted { rows: total.rows(), kept }, screen));
        } else if !kept.is_empty() {
            screen.complain(&complaint(CliError::NotAll { kept }, screen));
        }
        return Ok(status.max(Status::Wrong));
    }
    let read = out.finish()?;
    match key_out {
        Some(key) if read => drop(key.finish()?),
        Some(key) => {
            let kept = key.keep_part()?.unwrap_or_default();
            screen.complain(&complaint(CliError::Interrupted { rows: total.rows(), kept }, screen));
        }
        None => {}
    }
    let failed = if total.failed() > 0 { Status::Wrong } else { Status::Fine };
    Ok(status.max(if read { failed } else { Status::Unusable }))
}

/// What is written must not replace what is read, nor one the other.
fn keeps_inputs(args: &Batch) -> Result<(), CliError> {
    args.variants.iter().for_each(|name| files::keep(Path::new(name)));
    let overwrites = |name: &String| Err(CliError::Overwrites { name: name.clone() });
    if let Some(name) = args.out.iter().chain(&args.key).find(|name| files::is_input(Path::new(name))) {
        return overwrites(name);
    }
    match (&args.out, &args.key) {
        (Some(out), Some(key)) if place(Path::new(out)) == place(Path::new(key)) => overwrites(key),
        _ => Ok(()),
    }
}
