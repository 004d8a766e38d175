//! Constructors of blocks, whose signals and parts mostly start as their types' default.

/// A block from the fields that need a value, and the names of those that are default: `defaulted!(Self { q: Stage::new(true) };
/// clock d)`. Rust's `..Default::default()` needs a type that has one, which a block with arrays of a const generic's
/// length, or with a size that its constructor is given, has not.
macro_rules! defaulted {
    (Self { $($given:ident $(: $value:expr)?),* $(,)? }; $($field:ident)*) => {
        Self {
            $($given $(: $value)?,)*
            $($field: Default::default(),)*
        }
    };
}

/// So many signals.
pub(crate) fn signals<S: Default>(count: usize) -> Vec<S> {
    (0..count).map(|_| S::default()).collect()
}

pub(crate) use defaulted;
