//! Checks the files that a command will write before its work, so that a typo does not cost an hour of
//! rendering.

use std::fs;
use std::path::{Component, Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use photoncube_render::IMAGE_ENDINGS;

use crate::files;

/// The legal endings of the name of a plot or a map.
const PLOT_ENDINGS: [&str; 1] = [".svg"];

/// The legal endings of the name of a waveform.
const WAVE_ENDINGS: [&str; 1] = [".vcd"];

/// A file that a command will write.
#[derive(Clone, Debug)]
pub struct Output {
    /// The option that names the file or its folder.
    option: &'static str,
    path: PathBuf,
    /// The legal endings of the name; any ending where this is empty.
    endings: &'static [&'static str],
}

impl Output {
    /// A picture file that the option names.
    pub fn picture(option: &'static str, path: &Path) -> Self {
        let path = path.to_owned();
        let endings = &IMAGE_ENDINGS;
        Self {
            option,
            path,
            endings,
        }
    }

    /// A plot, or a map of an error, that the option names.
    pub fn plot(option: &'static str, path: &Path) -> Self {
        let path = path.to_owned();
        let endings = &PLOT_ENDINGS;
        Self {
            option,
            path,
            endings,
        }
    }

    /// A waveform that the option names.
    pub fn waves(option: &'static str, path: &Path) -> Self {
        let path = path.to_owned();
        let endings = &WAVE_ENDINGS;
        Self {
            option,
            path,
            endings,
        }
    }

    /// A file whose name the command chooses, in a folder that the option names.
    pub fn within(option: &'static str, path: PathBuf) -> Self {
        let endings = &[];
        Self {
            option,
            path,
            endings,
        }
    }

    fn display(&self) -> String {
        format!("{} {}", self.option, self.path.display())
    }

    fn check_ending(&self) -> Result<()> {
        let name = self.path.to_string_lossy().to_ascii_lowercase();
        if self.endings.is_empty() || self.endings.iter().any(|e| name.ends_with(e)) {
            return Ok(());
        }
        let found = match self.path.extension() {
            Some(ending) => format!("a name that ends in .{}", ending.to_string_lossy()),
            None => "a name without an ending".to_owned(),
        };
        let expected = self.endings.join(" or ");
        bail!("{}: found {found}, expected {expected}", self.display())
    }

    /// Refuses a place that a file cannot replace: a folder, a device.
    fn check_place(&self) -> Result<()> {
        let found = match fs::metadata(files::target(&self.path)) {
            Ok(found) if found.is_dir() => "a folder",
            Ok(found) if !found.is_file() => "no plain file",
            _ => return Ok(()),
        };
        bail!(
            "{}: found {found}, expected the name of a file",
            self.display()
        )
    }
}

/// Checks the endings, that all outputs are different files and none is an input, and that each can be
/// written. Leaves all files as they were.
pub fn check(outputs: &[Output], inputs: &[PathBuf]) -> Result<()> {
    outputs.iter().try_for_each(Output::check_ending)?;
    let places: Vec<_> = outputs.iter().map(|output| place(&output.path)).collect();
    for (index, (output, place)) in outputs.iter().zip(&places).enumerate() {
        if let Some(other) = places[..index].iter().position(|other| other == place) {
            let other = outputs[other].display();
            bail!(
                "{}: found the same file as {other}, expected another",
                output.display()
            );
        }
    }
    for input in inputs {
        let input_place = place(input);
        if let Some(output) = places.iter().position(|place| *place == input_place) {
            bail!(
                "{}: found {}, which is read, expected another file",
                outputs[output].display(),
                input.display()
            );
        }
    }
    outputs.iter().try_for_each(Output::check_place)?;
    outputs.iter().try_for_each(|output| {
        let folder = files::folder_of(&files::target(&output.path));
        try_folder(&folder).with_context(|| output.display())
    })
}

/// Checks that files can be written in the folder that an option names. Does not leave a folder that did not
/// exist.
pub fn check_folder(option: &'static str, folder: &Path) -> Result<()> {
    try_folder(folder).with_context(|| format!("{option} {}", folder.display()))
}

/// Makes the folder and a file in it, and removes them again.
fn try_folder(folder: &Path) -> Result<()> {
    let mut missing = Vec::new();
    let mut above = Some(folder);
    while let Some(folder) = above.filter(|f| !f.as_os_str().is_empty() && !f.exists()) {
        missing.push(folder);
        above = folder.parent();
    }
    let attempt = || {
        fs::create_dir_all(folder).map_err(|error| anyhow!("cannot make the folder: {error}"))?;
        let file = files::temporary(folder);
        file.map(drop)
            .map_err(|error| files::cannot_write(folder, &error))
    };
    let result = attempt();
    for folder in missing {
        // The removal fails where the folder was not made or someone else has put a file into it; neither matters.
        let _ = fs::remove_dir(folder);
    }
    result
}

/// The file's path in canonical form, without links as far as it exists.
fn place(path: &Path) -> PathBuf {
    let target = std::path::absolute(files::target(path)).unwrap_or_else(|_| path.to_owned());
    let mut place = PathBuf::new();
    for component in target.components() {
        match component {
            Component::ParentDir => {
                place.pop();
            }
            component => {
                place.push(component);
                // The folder may be a link.
                place = fs::canonicalize(&place).unwrap_or(place);
            }
        }
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(outputs: &[Output], inputs: &[PathBuf]) -> String {
        let result = check(outputs, inputs);
        result.map_or_else(|error| format!("{error:#}"), |()| String::new())
    }

    #[test]
    fn names_must_end_as_what_is_written() {
        let picture = |name| said(&[Output::picture("-o", Path::new(name))], &[]);
        let plot = |name| said(&[Output::plot("--plot", Path::new(name))], &[]);
        assert_eq!(
            picture("o"),
            "-o o: found a name without an ending, expected .png or .exr"
        );
        assert!(picture("o.svg").contains("ends in .svg, expected .png or .exr"));
        assert!(
            plot("o.png").contains("--plot o.png: found a name that ends in .png, expected .svg")
        );
        assert!(plot("pyramid.obj").contains("expected .svg"));
        assert_eq!(picture("o.PNG") + &plot("o.svg"), "");
    }

    #[cfg(unix)]
    #[test]
    fn each_output_is_a_file_of_its_own_whatever_its_path() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("real")).unwrap();
        std::os::unix::fs::symlink("real", at("link")).unwrap();
        std::os::unix::fs::symlink("real/a.svg", at("b.svg")).unwrap();
        for other in ["real/a.svg", "link/a.svg", "link/../real/./a.svg", "b.svg"] {
            let outputs = [
                Output::plot("--plot", &at("real/a.svg")),
                Output::plot("--error-map", &at(other)),
            ];
            assert!(
                said(&outputs, &[]).contains("the same file as --plot"),
                "{other}"
            );
            assert!(
                said(&outputs[1..], &[at("real/a.svg")]).contains("which is read"),
                "{other}"
            );
        }
        let other = Output::plot("--error-map", &at("real/c.svg"));
        assert_eq!(said(&[other], &[at("real/a.svg")]), "");
    }

    #[test]
    fn what_cannot_be_written_is_found_and_nothing_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), "").unwrap();
        fs::create_dir(at("d.png")).unwrap();
        let picture = |name| said(&[Output::picture("-o", &at(name))], &[]);
        assert!(picture("d.png").contains("found a folder, expected the name of a file"));
        assert!(picture("file/x.png").contains("cannot make the folder"));
        assert_eq!(picture("new/folders/x.png"), "");
        assert!(check_folder("--out", &at("new/folder")).is_ok());
        let error = check_folder("--out", &at("file")).unwrap_err();
        assert!(format!("{error:#}").starts_with("--out "), "{error:#}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_system_that_takes_no_file_and_a_device_are_found() {
        let proc = said(&[Output::picture("-o", Path::new("/proc/x.png"))], &[]);
        assert!(proc.contains("-o /proc/x.png: cannot write"), "{proc}");
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("null.svg");
        std::os::unix::fs::symlink("/dev/null", &link).unwrap();
        let null = said(&[Output::plot("--plot", &link)], &[]);
        assert!(null.contains("found no plain file"), "{null}");
    }
}
