//! Merges equal modules, bottom-up, and gives them readable names.

use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};

use super::EmitError;
use super::channels::ChannelNames;
use super::modules::rename_identifiers;

/// A module as rust-hdl prints it.
pub(super) struct Printed {
    /// The module's name in rust-hdl: the path of its instance, joined by `$`.
    pub path: String,
    /// The name of the instance in its parent.
    pub instance: String,
    /// The text from the opening parenthesis after the name up to `endmodule`, without `endmodule`.
    pub body: String,
    /// The name that the body has for the module of each child, and the path of the module that is printed for it.
    pub children: Vec<(String, String)>,
}

/// Merges equal modules and names them `prefix_instance`. The module `top` becomes `prefix` and is first. Of
/// the others, each comes before the modules that it uses.
pub(super) fn merge(
    mut modules: Vec<Printed>,
    top: &str,
    prefix: &str,
    channels: &ChannelNames,
) -> Result<String, EmitError> {
    modules.sort_by(|one, other| order(&one.path).cmp(&order(&other.path)));
    let mut merged = Merged::new(channels);
    for module in &modules {
        let name = if module.path == top {
            prefix.to_owned()
        } else {
            format!("{prefix}_{}", base_name(module))
        };
        merged.add(module, name)?;
    }
    Ok(merged.text())
}

/// The order in which modules are merged and named: children before parents, since a child's path extends its parent's.
/// Every run gives the same result.
pub(super) fn order(path: &str) -> (Reverse<usize>, &str) {
    (Reverse(path.len()), path)
}

struct Merged<'a> {
    channels: &'a ChannelNames,
    /// Maps the path of a module to the merged module's name.
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

    fn add(&mut self, module: &Printed, wanted: String) -> Result<(), EmitError> {
        let body = self.readable(module)?;
        if let Some(name) = self.by_body.get(&body) {
            self.names.insert(module.path.clone(), name.clone());
            return Ok(());
        }
        let count = self.wanted.entry(wanted.clone()).or_default();
        *count += 1;
        let name = match *count {
            1 => wanted,
            more => format!("{wanted}_{more}"),
        };
        self.names.insert(module.path.clone(), name.clone());
        self.by_body.insert(body.clone(), name.clone());
        self.modules.push((name, body));
        Ok(())
    }

    /// The module's body with readable names of modules and channels, and with `_` for the `$` of rust-hdl's
    /// paths.
    fn readable(&self, module: &Printed) -> Result<String, EmitError> {
        let children = module.children.iter();
        let children: HashMap<&str, &String> = children
            .map(|(name, path)| (name.as_str(), &self.names[path]))
            .collect();
        let mut origin: HashMap<String, String> = HashMap::new();
        let mut clash = None;
        let body = rename_identifiers(&module.body, |word| {
            if let Some(&name) = children.get(word) {
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
                module: module.path.clone(),
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

/// The instance's name without array index. A register is named by
/// its width, because equal registers in many places are one module. A register copy, which synthesis keeps,
/// is named likewise.
fn base_name(module: &Printed) -> String {
    if let Some(width) = register_width(&module.body) {
        let kind = match module.body.contains("(* keep *)") {
            true => "copy",
            false => "register",
        };
        return format!("{kind}_{width}");
    }
    let instance = module.instance.as_str();
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
    use super::*;
    use photoncube_spec::MACHINES;

    const REGISTER: &str = "(d,q,clock);\n input wire [7:0] d;\n q <= d;\n";

    /// Modules of these paths and bodies.
    fn printed(modules: &[(&str, &str)]) -> Vec<Printed> {
        let paths = || modules.iter().map(|(path, _)| *path);
        let parent = |path: &str| {
            let above = paths().filter(|above| path.starts_with(&format!("{above}$")));
            above.max_by_key(|above| above.len())
        };
        let module = |&(path, body): &(&str, &str)| Printed {
            path: path.to_owned(),
            instance: path[parent(path).map_or(0, |parent| parent.len() + 1)..].to_owned(),
            body: body.to_owned(),
            children: paths()
                .filter(|child| parent(child) == Some(path))
                .map(|child| (child.to_owned(), child.to_owned()))
                .collect(),
        };
        modules.iter().map(module).collect()
    }

    fn merge_as_p(modules: Vec<Printed>) -> Result<String, EmitError> {
        merge(modules, "top", "p", &ChannelNames::of(&MACHINES[0]))
    }

    #[test]
    fn equal_children_make_equal_parents() {
        let modules = printed(&[
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
        let modules = printed(&[
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
        let modules = printed(&[
            ("top", "();\n top$a$0 a$0();\n top$a$1 a$1();\n"),
            ("top$a$0", "();\n x\n"),
            ("top$a$1", "();\n y\n"),
        ]);
        let merged = merge_as_p(modules).unwrap();
        assert!(merged.contains("module p_a()") && merged.contains("module p_a_2()"));
    }

    #[test]
    fn names_that_would_fall_together_are_refused() {
        let modules = printed(&[("top", "(a$0, a_0);\n")]);
        let error = merge_as_p(modules).unwrap_err().to_string();
        assert!(error.contains("`a$0` and `a_0`"), "{error}");
    }
}
