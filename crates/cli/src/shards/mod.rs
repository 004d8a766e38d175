//! Work that is shared out: what a shard is, its state file, and how the files of all shards become that of one machine.
//!
//! A long command numbers its jobs, 0, 1, 2, ..., by its options alone. Shard I of N does the jobs whose number leaves the rest I - 1
//! when divided by N, and keeps their results in a file of its own. `photoncube merge` makes of the files of all N shards the one that
//! a single shard (1/1) writes, byte for byte, so results have no times and sums are exact. The command itself, given the merged file,
//! has nothing left to do but to print and to write its results.
//!
//! Each file begins with a line of JSON, its [`Header`]. `progressive` keeps sums behind it; every other command keeps a line for each
//! job, see [`Ledger`].

mod header;
mod ledger;
mod parts;
mod select;
mod shard;

pub use self::header::{Header, Settings};
pub use self::ledger::{Ledger, jobs_in, merge_lines};
pub use self::parts::Parts;
pub use self::select::{Input, Selection};
pub use self::shard::{Shard, ShardArgs};
