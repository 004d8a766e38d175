//! The arguments of `merge`.

use std::path::PathBuf;

use clap::Args as ClapArgs;

/// `merge`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube progressive cornell --passes 64 --shard 1/2 --state 1.state     on one machine
  photoncube progressive cornell --passes 64 --shard 2/2 --state 2.state     on another
  photoncube merge 1.state 2.state -o all.state
  photoncube progressive cornell --passes 64 --state all.state --resume -o box.png

The merged file is byte for byte that of a single shard, 1/1; the order of the files makes no
difference, and a shard that is given twice counts once. A file of other work, a shard that is not
complete and one that is missing are named, and nothing is written. The command of the shards,
without --shard and with the merged file as --state, prints and writes what it would have on one
machine. --partial allows for missing shards: its file is merged with others again, so that many
shards can be merged in steps.

Commands with --shard: progressive, report --sweep, synth, verify campaign.")]
pub struct MergeArgs {
    /// The state files of the shards
    #[arg(required = true, value_name = "FILES")]
    pub files: Vec<PathBuf>,
    /// The merged state
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Merge although shards are missing
    #[arg(long)]
    pub partial: bool,
}
