//! What a command prints: one JSON object, or text for people.

use anyhow::Result;
use serde::Serialize;

/// Prints `value` as one JSON object if asked, else the text.
pub fn print<T: Serialize>(json: bool, value: &T, text: impl FnOnce() -> String) -> Result<()> {
    if json {
        println!("{}", serde_json::to_string_pretty(value)?);
    } else {
        print!("{}", text());
    }
    Ok(())
}
