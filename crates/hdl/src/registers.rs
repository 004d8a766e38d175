//! The place of a register in a block. It is stated once, and is read either as the register's value in the simulation
//! or as its path in the emitted text.

use std::fmt::Display;

/// The property of a register that a caller wants.
#[derive(Copy, Clone)]
pub(crate) enum Ask {
    /// The register's value in the simulation.
    Value,
    /// The register's path in the emitted text.
    Path,
}

/// The value or path of a register.
pub(crate) enum Answer {
    /// The register's value in the simulation.
    Value(u64),
    /// The register's path below the block.
    Path(String),
}

impl Answer {
    /// What was asked for with [`Ask::Value`].
    pub fn value(self) -> u64 {
        match self {
            Self::Value(value) => value,
            Self::Path(path) => unreachable!("the value of `{path}` was asked for, not its path"),
        }
    }

    /// What was asked for with [`Ask::Path`].
    pub fn path(self) -> String {
        match self {
            Self::Path(path) => path,
            Self::Value(_) => unreachable!("a path was asked for, not a value"),
        }
    }

    /// The answer of a part, in the block that holds the part at this path, which ends with a dot. It is formatted only where a
    /// path was asked for: values are asked for in every clock.
    pub fn below(self, part: impl Display) -> Self {
        match self {
            Self::Value(value) => Self::Value(value),
            Self::Path(path) => Self::Path(format!("{part}{path}")),
        }
    }
}

/// A field's name in the text. A register inside hand-written text has a field with `_` before its name.
pub(crate) fn visible(field: &str) -> &str {
    field.trim_start_matches('_')
}

macro_rules! path_of {
    ($name:ident; $a:ident [$i:expr] . $($rest:tt)+) => {
        $name += &format!("{}_{}.", $crate::registers::visible(stringify!($a)), $i);
        $crate::registers::path_of!($name; $($rest)+);
    };
    ($name:ident; $a:ident . $($rest:tt)+) => {
        $name += &format!("{}.", $crate::registers::visible(stringify!($a)));
        $crate::registers::path_of!($name; $($rest)+);
    };
    ($name:ident; $a:ident) => { $name += $crate::registers::visible(stringify!($a)); };
}

macro_rules! register {
    ($ask:ident, $block:ident, $($path:tt)+) => {
        match $ask {
            $crate::registers::Ask::Value => $crate::registers::Answer::Value($block.$($path)+.val().number()),
            $crate::registers::Ask::Path => {
                let mut name = String::new();
                $crate::registers::path_of!(name; $($path)+);
                $crate::registers::Answer::Path(name)
            }
        }
    };
}

pub(crate) use {path_of, register};
