//! The proof of a mutant on its module alone, for modules that hold no observed register: for equal inputs in all clocks from
//! power-up on, the outputs are equal in all clocks. So a register in between may have another value where no output shows it.

use std::collections::BTreeSet;

use fpga_flow::Netlist;
use photoncube_hdl::Emitted;

use super::Mutation;
use super::design::{read, yosys};
use crate::device::{DeviceError, scratch_folder};

/// The most clocks of the induction. It succeeds for a pipeline of fewer stages; that of the comparison of boxes has 4.
const MOST_CLOCKS: u32 = 8;

/// The modules that hold an observed register, themselves or in a part.
pub(super) struct ObservedModules(BTreeSet<String>);

impl ObservedModules {
    /// Follows the path of each observed register through the modules of the design.
    ///
    /// # Errors
    /// Yosys does not run, or a path is not that of a net.
    pub fn of(design: &Emitted) -> Result<Self, DeviceError> {
        let folder = scratch_folder()?;
        yosys(folder.path(), design, "write_json modules.json")?;
        let netlist = Netlist::parse(&read(&folder.path().join("modules.json"))?)?;
        let mut modules = BTreeSet::from([design.top.clone()]);
        for path in &design.register_paths {
            let on_path = modules_on(&netlist, &design.top, path);
            modules.extend(on_path.ok_or_else(|| DeviceError::BrokeOff {
                device: "yosys".to_owned(),
                message: format!("its netlist has no net {path}; expected each observed register"),
            })?);
        }
        Ok(Self(modules))
    }

    /// Whether a module holds an observed register.
    fn has(&self, module: &str) -> bool {
        self.0.contains(module)
    }
}

/// The modules of the instances on a path of dots from the top module to a net; `None` where there is no such net.
fn modules_on(netlist: &Netlist, top: &str, path: &str) -> Option<Vec<String>> {
    let modules = &netlist.json()["modules"];
    let mut names: Vec<_> = path.split('.').collect();
    let net = names.pop()?;
    let mut module = top;
    let mut on_path = Vec::new();
    for name in names {
        module = modules[module]["cells"][name]["type"].as_str()?;
        on_path.push(module.to_owned());
    }
    modules[module]["netnames"].get(net)?;
    Some(on_path)
}

/// The script that compares a module with its mutant, from the elaborated design; `None` where the module holds an observed
/// register.
///
/// The solver takes each register to have its next value in each clock, so all registers must have the clock of the module.
pub(super) fn script(
    observed: &ObservedModules,
    mutation: &Mutation,
    solve: &str,
) -> Option<String> {
    let (module, options) = (mutation.module_in_text()?, &mutation.options);
    (!observed.has(module)).then(|| {
        let flat = |name: &str| {
            format!("flatten\nopt_clean\nrename {module} {name}\ndesign -stash {name}")
        };
        format!(
            "hierarchy -top {module}\ndesign -save elaborated\n{}\n\
             design -load elaborated\nmutate {options}\n{}\n\
             design -copy-from gold -as gold gold\ndesign -copy-from gate -as gate gate\n\
             select -assert-none t:$*ff* w:clock %co1:+[CLK] %d\n\
             miter -equiv -flatten -make_assert -make_outputs gold gate miter\n\
             hierarchy -top miter\nopt -full\n{solve} -tempinduct -maxsteps {MOST_CLOCKS} miter",
            flat("gold"),
            flat("gate"),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_on_the_path_of_an_observed_register_is_not_proven_alone() {
        let text = r#"{"modules": {
            "m": {"cells": {"part": {"type": "m_part"}, "own": {"type": "m_own"}}, "netnames": {}},
            "m_part": {"cells": {"seen": {"type": "m_register"}}, "netnames": {}},
            "m_register": {"cells": {}, "netnames": {"q": {}}},
            "m_own": {"cells": {}, "netnames": {}}
        }}"#;
        let netlist = Netlist::parse(text).unwrap();
        let on_path = modules_on(&netlist, "m", "part.seen.q").unwrap();
        assert_eq!(on_path, ["m_part", "m_register"]);
        assert_eq!(modules_on(&netlist, "m", "part.seen.d"), None);
        assert_eq!(modules_on(&netlist, "m", "own.seen.q"), None);

        let observed = ObservedModules(on_path.into_iter().collect());
        let script_of = |module: &str| {
            let mutation = Mutation {
                mutant: 1,
                module: String::new(),
                options: format!("-mode inv -module {module} -cell c -port A"),
            };
            script(&observed, &mutation, "sat")
        };
        assert_eq!(script_of("m_part"), None);
        let script = script_of("m_own").unwrap();
        assert!(script.contains("rename m_own gate"), "{script}");
    }
}
