//! Holds no code: its manifest has the features that builds of one package and of the workspace share.
