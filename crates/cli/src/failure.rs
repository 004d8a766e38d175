//! Exit codes: 0 all holds; 1 a check failed; 2 bad usage or bad input.

use std::process::ExitCode;

use thiserror::Error;

/// A check that the command was asked for does not hold; everything else that ends a command is
/// bad input or a machine that cannot do it.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct CheckFailed(pub String);

/// The exit code of an error.
pub fn exit_code(error: &anyhow::Error) -> ExitCode {
    let check_failed = error.chain().any(|cause| cause.is::<CheckFailed>());
    ExitCode::from(if check_failed { 1 } else { 2 })
}
