//! What a chapter asks its reader to do: files to write and commands to run, with the output that it promises.

use std::ops::Range;

/// A command of a chapter, with the output below it.
#[derive(Debug, PartialEq)]
pub struct Command {
    /// The line of the page in which it begins, from 1.
    pub line: usize,
    /// Without the prompt; a command of several lines has line breaks.
    pub text: String,
    /// `[..]` stands for any text within a line, a line `...` for any lines.
    pub output: String,
    /// The lines of the output in the page, from 0.
    pub output_lines: Range<usize>,
}

/// A thing to do, in the order of the page.
#[derive(Debug, PartialEq)]
pub enum Part {
    /// Write this text into the file of this name.
    File {
        /// In the reader's folder.
        name: String,
        /// All of it.
        text: String,
    },
    /// Run it, and see the output.
    Run(Command),
    /// What cannot be run here; the chapter says why.
    NotRun(Command),
}

/// A block between fences: its info string, its first line (from 0), its lines, and the line of text above it.
struct Block<'a> {
    info: &'a str,
    first: usize,
    lines: Vec<&'a str>,
    above: &'a str,
}

fn blocks(page: &str) -> Result<Vec<Block<'_>>, String> {
    let (mut blocks, mut open, mut above) = (Vec::new(), None::<Block>, "");
    for (at, line) in page.lines().enumerate() {
        match (open.take(), line.strip_prefix("```")) {
            (None, None) if line.trim().is_empty() => {}
            (None, None) => above = line,
            (None, Some(info)) => {
                let (first, lines) = (at + 1, Vec::new());
                open = Some(Block {
                    info,
                    first,
                    lines,
                    above,
                });
            }
            (Some(block), Some(_)) => {
                blocks.push(block);
                above = "";
            }
            (Some(mut block), None) => {
                block.lines.push(line);
                open = Some(block);
            }
        }
    }
    match open {
        Some(block) => Err(format!("line {}: the block has no end", block.first)),
        None => Ok(blocks),
    }
}

/// The name in a line "File `NAME`:".
fn file_name(above: &str) -> Option<&str> {
    above.strip_prefix("File `")?.strip_suffix("`:")
}

/// The commands of a block `console`: `$ ` begins one, `> ` goes on with it.
fn commands(block: &Block) -> Result<Vec<Command>, String> {
    let mut commands: Vec<Command> = Vec::new();
    for (at, line) in block.lines.iter().enumerate() {
        let line_number = block.first + at + 1;
        if let Some(text) = line.strip_prefix("$ ") {
            let after = block.first + at + 1;
            commands.push(Command {
                line: line_number,
                text: text.to_owned(),
                output: String::new(),
                output_lines: after..after,
            });
            continue;
        }
        let Some(command) = commands.last_mut() else {
            return Err(format!("line {line_number}: expected `$ COMMAND`"));
        };
        match line.strip_prefix("> ") {
            Some(more) if command.output.is_empty() => {
                command.text += &format!("\n{more}");
                command.output_lines = block.first + at + 1..block.first + at + 1;
            }
            _ => {
                command.output += &format!("{line}\n");
                command.output_lines.end = block.first + at + 1;
            }
        }
    }
    Ok(commands)
}

/// The parts of a page in their order.
///
/// # Errors
/// A block that is neither run, nor a file, nor `text`, so that no command escapes the test.
pub fn parts(page: &str) -> Result<Vec<Part>, String> {
    let mut parts = Vec::new();
    for block in blocks(page)? {
        match (block.info, file_name(block.above)) {
            ("console", _) => parts.extend(commands(&block)?.into_iter().map(Part::Run)),
            ("console not-run", _) => {
                parts.extend(commands(&block)?.into_iter().map(Part::NotRun));
            }
            (_, Some(name)) => parts.push(Part::File {
                name: name.to_owned(),
                text: block.lines.iter().map(|line| format!("{line}\n")).collect(),
            }),
            ("text", None) => {}
            (info, None) => {
                return Err(format!(
                    "line {}: found a block `{info}`, expected `console`, `console not-run`, `text`, or a line \
                     \"File `NAME`:\" above it",
                    block.first
                ));
            }
        }
    }
    Ok(parts)
}

/// The page with other outputs.
pub fn with_outputs(page: &str, outputs: &[(&Command, String)]) -> String {
    let mut lines: Vec<String> = page.lines().map(str::to_owned).collect();
    for (command, output) in outputs.iter().rev() {
        let output = output.lines().map(str::to_owned);
        lines.splice(command.output_lines.clone(), output);
    }
    lines.join("\n") + "\n"
}
