//! Constructors of blocks, whose signals and parts mostly start as their types' default.

/// Makes a block from the fields that are given a value and the names of the fields that start as their types' default:
/// `defaulted!(Self { q: Stage::new(true) }; clock d)`. Rust's `..Default::default()` would need a default of the whole
/// block. A block whose constructor is given a size has none.
macro_rules! defaulted {
    (Self { $($given:ident $(: $value:expr)?),* $(,)? }; $($field:ident)*) => {
        Self {
            $($given $(: $value)?,)*
            $($field: Default::default(),)*
        }
    };
}

/// Makes `count` signals, each the default of its type.
pub(crate) fn signals<S: Default>(count: usize) -> Vec<S> {
    (0..count).map(|_| S::default()).collect()
}

pub(crate) use defaulted;
