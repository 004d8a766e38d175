//! What the machines are: formats, ops, microprograms, topology; data only.
