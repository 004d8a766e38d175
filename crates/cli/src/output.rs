//! Prints the output of a command: one JSON object, or text for people.

use std::io::{self, ErrorKind, Write};

use anyhow::Result;
use serde::Serialize;

use crate::narrow::{WideArgs, narrow};

/// Prints `value` as one JSON object if asked, else the text.
pub fn print<T: Serialize>(json: bool, value: &T, text: impl FnOnce() -> String) -> Result<()> {
    let text = match json {
        true => serde_json::to_string_pretty(value)? + "\n",
        false => text(),
    };
    write(&text)
}

/// [`print()`] of a text with tables, which are made to fit a terminal unless they are asked for in full.
pub fn print_tables<T: Serialize>(
    json: bool,
    wide: WideArgs,
    value: &T,
    text: impl FnOnce() -> String,
) -> Result<()> {
    print(json, value, || match wide.wide {
        true => text(),
        false => narrow(&text()),
    })
}

/// Writes to standard output. A reader that has closed the pipe, such as `head`, is not an error.
pub fn write(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => Ok(result?),
    }
}
