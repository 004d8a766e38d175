//! Exit codes: 0 for success, 1 for a failed check, 2 for wrong usage or input.

use std::process::ExitCode;

use thiserror::Error;

/// The error of a check that the command was asked for. Every other error of a command is wrong input, or a
/// computer that cannot run the command.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct CheckFailed(pub String);

/// The message of an error with its causes, each once; the messages of many errors contain those of their
/// causes.
pub fn message(error: &anyhow::Error) -> String {
    error.chain().fold(String::new(), |said, cause| {
        match without_temporary_name(&cause.to_string()) {
            cause if said.is_empty() => cause,
            cause if said.contains(&cause) => said,
            cause => format!("{said}: {cause}"),
        }
    })
}

/// Removes the name of a temporary file from a message. Files are written under such a name beside their
/// place and then renamed.
fn without_temporary_name(said: &str) -> String {
    let Some((before, path)) = said.split_once(" at path \"") else {
        return said.to_owned();
    };
    let (path, after) = path.split_once('"').unwrap_or((path, ""));
    let name = path.rsplit('/').next().unwrap_or_default();
    match name.starts_with(".tmp") {
        true => format!("{before}{after}"),
        false => said.to_owned(),
    }
}

/// The exit code of an error.
pub fn exit_code(error: &anyhow::Error) -> ExitCode {
    let check_failed = error.chain().any(|cause| cause.is::<CheckFailed>());
    ExitCode::from(if check_failed { 1 } else { 2 })
}

#[cfg(test)]
mod tests {
    use std::io;

    use anyhow::Context;

    use super::*;

    #[derive(Debug, Error)]
    #[error("{file}: {source}")]
    struct Told {
        file: &'static str,
        source: io::Error,
    }

    #[test]
    fn each_cause_is_told_once() {
        let source = io::Error::from(io::ErrorKind::NotFound);
        let why = source.to_string();
        let told = Told { file: "a", source };
        let error = Err::<(), _>(told).context("cannot begin").unwrap_err();
        assert_eq!(message(&error), format!("cannot begin: a: {why}"));
        let error = anyhow::anyhow!("first").context("second");
        assert_eq!(message(&error), "second: first");
    }

    #[test]
    fn the_name_of_a_temporary_file_is_not_told() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("missing");
        let error = tempfile::NamedTempFile::new_in(&missing).unwrap_err();
        assert!(error.to_string().contains("/.tmp"), "{error}");
        let said = message(&anyhow::Error::from(error).context("cannot write x.png"));
        assert!(said.starts_with("cannot write x.png: "), "{said}");
        assert!(!said.contains("at path") && !said.contains("tmp"), "{said}");
        let other = "no key at path \"a/b\" here";
        assert_eq!(without_temporary_name(other), other);
    }
}
