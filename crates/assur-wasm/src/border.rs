//! The border to the host: three functions, and one that it brings.
#![expect(unsafe_code, reason = "memory is handed across the border by address and length")]

use crate::session::{Session, Stop};
use std::cell::RefCell;

#[link(wasm_import_module = "assur")]
unsafe extern "C" {
    /// Whether to stop solving: 0 to go on, 1 as a message waits, 2 as it takes too long.
    safe fn stop() -> i32;
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
}

/// Memory for a message of the host.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; length].into_boxed_slice()).cast()
}

/// Gives back what [`reserve`] or [`handle`] returned.
///
/// # Safety
/// `at` came from there, with this length, and is given back once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn free(at: *mut u8, length: usize) {
    // SAFETY: the allocation was made as a box of that many bytes
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) });
}

/// The answers to a message, whose memory is given back by this: four bytes of their length, lowest first, then that many.
///
/// # Safety
/// `at` came from [`reserve`], with this length.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn handle(at: *mut u8, length: usize) -> *mut u8 {
    // SAFETY: as for `free`
    let message = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) };
    let answers = SESSION.with_borrow_mut(|session| session.handle(&message, &stops));
    let head = u32::try_from(answers.len()).unwrap_or_default().to_le_bytes();
    Box::into_raw([&head[..], &answers].concat().into_boxed_slice()).cast()
}

fn stops() -> Option<Stop> {
    match stop() {
        0 => None,
        1 => Some(Stop::Later),
        _ => Some(Stop::Never),
    }
}
