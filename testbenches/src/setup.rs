//! `scripts/setup.sh`, which installs the tools of pinned versions. This program has it in it, so it needs no clone of
//! the project.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use photoncube_hdl::cache::{CacheError, Files, cache, unpacked};

/// The script, and the files beside it that it reads.
const SCRIPTS: &Files = &[
    ("setup.sh", include_bytes!("../../scripts/setup.sh")),
    ("yosys.py", include_bytes!("../../scripts/yosys.py")),
    (
        "requirements-core.txt",
        include_bytes!("../../scripts/requirements-core.txt"),
    ),
    (
        "requirements-book.txt",
        include_bytes!("../../scripts/requirements-book.txt"),
    ),
];

/// The command that runs the script. It is the script that this program was built with.
///
/// # Errors
/// The script cannot be written to the user's cache.
pub fn setup_script() -> Result<Command, CacheError> {
    let folder = unpacked(&cache("scripts"), SCRIPTS)?;
    let mut command = Command::new("bash");
    command.arg(folder.join("setup.sh"));
    Ok(command)
}

/// The folder of the tools of pinned versions that the script has installed; `None` where there are none. It is looked
/// up once.
pub fn pinned_tools() -> Option<&'static Path> {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder = || {
        let mut script = setup_script().ok()?;
        let output = script.arg("--where").stdin(Stdio::null()).output().ok()?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let folder = said.lines().last().map(PathBuf::from);
        folder.filter(|_| output.status.success())
    };
    FOLDER.get_or_init(folder).as_deref()
}
