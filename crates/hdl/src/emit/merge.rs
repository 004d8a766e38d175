//! Merges equal modules, bottom-up, and gives them readable names.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::EmitError;
use super::channels::ChannelNames;
use super::modules::{Module, rename_identifiers};

/// Merges equal modules and names them `prefix_instance`. The module `top` becomes `prefix` and is first. Of
/// the others, each comes before the modules that it uses.
pub(super) fn merge(
    mut modules: Vec<Module>,
    top: &str,
    prefix: &str,
    channels: &ChannelNames,
) -> Result<String, EmitError> {
    let names: HashSet<String> = modules.iter().map(|module| module.name.clone()).collect();
    // A child's name extends its parent's, so the order of decreasing length is bottom-up. Names of equal
    // length keep the order of the text, so that every run gives the same result.
    modules.sort_by_key(|module| std::cmp::Reverse(module.name.len()));
    let mut merged = Merged::new(channels);
    for module in &modules {
        let name = if module.name == top {
            prefix.to_owned()
        } else {
            format!("{prefix}_{}", base_name(module, &names))
        };
        merged.add(module, name)?;
    }
    Ok(merged.text())
}

struct Merged<'a> {
    channels: &'a ChannelNames,
    /// Maps rust-hdl's module name to the merged module's name.
    names: HashMap<String, String>,
    /// Maps a module's text to its name.
    by_body: HashMap<String, String>,
    /// The number of different modules that would have the name.
    wanted: BTreeMap<String, usize>,
    /// Name and body of each merged module, children first.
    modules: Vec<(String, String)>,
}

impl<'a> Merged<'a> {
    fn new(channels: &'a ChannelNames) -> Self {
        Self {
            channels,
            names: HashMap::new(),
            by_body: HashMap::new(),
            wanted: BTreeMap::new(),
            modules: Vec::new(),
        }
    }

    fn add(&mut self, module: &Module, wanted: String) -> Result<(), EmitError> {
        let body = self.readable(module)?;
        if let Some(name) = self.by_body.get(&body) {
            self.names.insert(module.name.clone(), name.clone());
            return Ok(());
        }
        let count = self.wanted.entry(wanted.clone()).or_default();
        *count += 1;
        let name = match *count {
            1 => wanted,
            more => format!("{wanted}_{more}"),
        };
        self.names.insert(module.name.clone(), name.clone());
        self.by_body.insert(body.clone(), name.clone());
        self.modules.push((name, body));
        Ok(())
    }

    /// The module's body with readable names of modules and channels, and with `_` for the `$` of rust-hdl's
    /// paths.
    fn readable(&self, module: &Module) -> Result<String, EmitError> {
        let mut origin: HashMap<String, String> = HashMap::new();
        let mut clash = None;
        let body = rename_identifiers(&module.body, |word| {
            if let Some(name) = self.names.get(word) {
                return name.clone();
            }
            let name = self.channels.name(word).replace('$', "_");
            let first = origin
                .entry(name.clone())
                .or_insert_with(|| word.to_owned());
            if first != word {
                clash = Some((first.clone(), word.to_owned(), name.clone()));
            }
            name
        });
        match clash {
            None => Ok(tidy(&body)),
            Some((first, second, name)) => Err(EmitError::Name {
                module: module.name.clone(),
                first,
                second,
                name,
            }),
        }
    }

    fn text(&self) -> String {
        let modules = self.modules.iter().rev();
        modules
            .map(|(name, body)| format!("\nmodule {name}{body}endmodule\n"))
            .collect()
    }
}

/// The instance's name without array index, which is the part after the parent's path. A register is named by
/// its width, because equal registers in many places are one module. A register copy, which synthesis keeps,
/// is named likewise.
fn base_name(module: &Module, names: &HashSet<String>) -> String {
    if let Some(width) = register_width(&module.body) {
        let kind = match module.body.contains("(* keep *)") {
            true => "copy",
            false => "register",
        };
        return format!("{kind}_{width}");
    }
    let parent = module
        .name
        .rmatch_indices('$')
        .map(|(at, _)| at)
        .find(|&at| names.contains(&module.name[..at]));
    let instance = &module.name[parent.map_or(0, |at| at + 1)..];
    let (stem, index) = instance.split_once('$').unwrap_or((instance, ""));
    if index.bytes().all(|byte| byte.is_ascii_digit()) {
        return stem.to_owned();
    }
    instance.replace('$', "_")
}

/// The width of rust-hdl's D flip-flop, or `None` for any other module.
fn register_width(body: &str) -> Option<u32> {
    if !(body.starts_with("(d,q,clock)") && body.contains("q <= d;")) {
        return None;
    }
    let declaration = body.lines().find(|line| line.trim_end().ends_with(" d;"))?;
    match declaration.split_once('[') {
        None => Some(1),
        Some((_, range)) => Some(range.split(':').next()?.parse::<u32>().ok()? + 1),
    }
}

/// Removes trailing blanks, empty lines and the double blanks of unsigned declarations, and wraps the list of
/// ports.
fn tidy(body: &str) -> String {
    let (ports, rest) = body.split_once('\n').unwrap_or((body, ""));
    let lines = rest.lines().map(str::trim_end).filter(|l| !l.is_empty());
    let lines = lines.map(|line| tidy_line(line) + "\n");
    wrap_ports(ports) + &lines.collect::<String>()
}

/// Formats `(a,b,c);` with a blank after each comma, and starts a new line where the next port would pass the
/// width.
fn wrap_ports(ports: &str) -> String {
    let mut text = String::new();
    let mut column = HEADING;
    for port in ports.split_inclusive(',') {
        if column + port.len() > LINE_WIDTH {
            text += "\n    ";
            column = INDENT;
        } else if !text.is_empty() {
            text += " ";
            column += 1;
        }
        text += port;
        column += port.len();
    }
    text + "\n"
}

const LINE_WIDTH: usize = 96;
const INDENT: usize = 4;
/// The approximate length of `module` and its name on the first line.
const HEADING: usize = 36;

fn tidy_line(line: &str) -> String {
    let text = line.trim_start();
    let indent = &line[..line.len() - text.len()];
    format!("{indent}{}", text.replace("  ", " "))
}

#[cfg(test)]
mod tests {
    use super::super::modules::split;
    use super::*;
    use photoncube_spec::MACHINES;

    const REGISTER: &str = "(d,q,clock);\n input wire [7:0] d;\n q <= d;\n";

    fn text(modules: &[(&str, &str)]) -> Vec<Module> {
        let text: String = modules
            .iter()
            .map(|(name, body)| format!("module {name}{body}endmodule\n"))
            .collect();
        split(&text)
    }

    fn merge_as_p(modules: Vec<Module>) -> Result<String, EmitError> {
        merge(modules, "top", "p", &ChannelNames::of(&MACHINES[0]))
    }

    #[test]
    fn equal_children_make_equal_parents() {
        let modules = text(&[
            ("top", "();\n top$a$0 a$0();\n top$a$1 a$1();\n"),
            ("top$a$0", "();\n top$a$0$r r();\n"),
            ("top$a$0$r", REGISTER),
            ("top$a$1", "();\n top$a$1$r r();\n"),
            ("top$a$1$r", REGISTER),
        ]);
        let merged = merge_as_p(modules).unwrap();
        assert_eq!(
            merged,
            "\nmodule p();\n p_a a_0();\n p_a a_1();\nendmodule\n\
             \nmodule p_a();\n p_register_8 r();\nendmodule\n\
             \nmodule p_register_8(d, q, clock);\n input wire [7:0] d;\n q <= d;\nendmodule\n"
        );
    }

    #[test]
    fn a_register_that_synthesis_keeps_is_another_module() {
        let kept = REGISTER.replace(" q <= d;", " (* keep *) q <= d;");
        let modules = text(&[
            ("top", "();\n top$a a();\n top$b b();\n"),
            ("top$a", REGISTER),
            ("top$b", &kept),
        ]);
        let merged = merge_as_p(modules).unwrap();
        assert!(
            merged.contains(" p_register_8 a();\n p_copy_8 b();\n"),
            "{merged}"
        );
    }

    #[test]
    fn long_port_lists_are_wrapped_and_keep_every_port() {
        let ports: Vec<String> = (0..60).map(|i| format!("port_{i}")).collect();
        let text = wrap_ports(&format!("({});", ports.join(",")));
        assert!(text.lines().count() > 1);
        assert!(text.lines().all(|line| line.len() <= LINE_WIDTH), "{text}");
        let words = text.split_whitespace().collect::<String>();
        assert_eq!(words, format!("({});", ports.join(",")));
    }

    #[test]
    fn different_modules_of_one_name_are_numbered() {
        let modules = text(&[
            ("top", "();\n top$a$0 a$0();\n top$a$1 a$1();\n"),
            ("top$a$0", "();\n x\n"),
            ("top$a$1", "();\n y\n"),
        ]);
        let merged = merge_as_p(modules).unwrap();
        assert!(merged.contains("module p_a()") && merged.contains("module p_a_2()"));
    }

    #[test]
    fn names_that_would_fall_together_are_refused() {
        let modules = text(&[("top", "(a$0, a_0);\n")]);
        let error = merge_as_p(modules).unwrap_err().to_string();
        assert!(error.contains("`a$0` and `a_0`"), "{error}");
    }
}
