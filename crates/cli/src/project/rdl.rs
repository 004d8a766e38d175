//! The registers of a core in SystemRDL, from which PeakRDL makes a C header, pages and a Python model.

use std::fmt::Write as _;

use photoncube_spec::{Access, Core, CoreField, CoreRegister, CoreRegisterRow};

/// The map of a core whose configuration has this digest.
pub fn text(core: &Core, digest: u64) -> String {
    let mut text = format!(
        "// The registers of {}. Written by photoncube {}, `photoncube generate --machine {} --chains {}`; do not edit.\n\
         addrmap {} {{\n    \
         name = \"Registers of {}\";\n    \
         default regwidth = {};\n    \
         default accesswidth = {};\n",
        core.name(),
        env!("CARGO_PKG_VERSION"),
        core.machine.name,
        core.chains,
        core.top(),
        core.name(),
        Core::REGISTER_BITS,
        Core::REGISTER_BITS,
    );
    for row in CoreRegister::all(core, digest) {
        text += &register(&row);
    }
    text + "};\n"
}

fn register(row: &CoreRegisterRow) -> String {
    let mut text = format!("\n    reg {{\n        desc = \"{}\";\n", row.about);
    let whole = [CoreField {
        name: "value",
        low: 0,
        width: Core::REGISTER_BITS,
        about: "The whole word.",
    }];
    let fields = match row.fields.is_empty() {
        true => &whole[..],
        false => &row.fields,
    };
    for field in fields {
        let reset = u64::from(row.reset) >> field.low & ((1 << field.width) - 1);
        let _ = writeln!(
            text,
            "        field {{ desc = \"{}\"; {} }} {}[{}:{}]{};",
            field.about,
            access(row.access),
            field.name,
            field.low + field.width - 1,
            field.low,
            match row.is_live() {
                true => String::new(),
                false => format!(" = 0x{reset:x}"),
            }
        );
    }
    let _ = writeln!(text, "    }} {} @ 0x{:03x};", row.name, row.address);
    text
}

/// The properties of a field with that access, in SystemRDL 2.0.
fn access(access: Access) -> &'static str {
    match access {
        Access::Read => "sw = r; hw = w;",
        Access::ReadWrite => "sw = rw; hw = r;",
        Access::WriteOneToClear => "sw = rw; hw = rw; onwrite = woclr;",
        Access::WriteOneToDo => "sw = w; hw = r; singlepulse;",
    }
}
