//! The cover points of the testbench: situations that the stimulus must reach, as Verilog in the trace
//! module.

use std::fmt::Write as _;

use photoncube_spec::Machine;

const STREAMS: [&str; 3] = ["query", "group", "result"];

/// The situations, by name, each as a Verilog expression of pins and registers.
pub(super) fn covers(machine: &Machine) -> Vec<(String, String)> {
    let mut covers = Vec::new();
    let mut cover = |name: String, when: String| covers.push((name, when));
    for stream in STREAMS {
        let (valid, ready) = (format!("{stream}_valid"), format!("{stream}_ready"));
        cover(format!("{stream}_moves"), format!("{valid} & {ready}"));
        cover(format!("{stream}_waits"), format!("{valid} & ~{ready}"));
        cover(
            format!("{stream}_is_awaited"),
            format!("~{valid} & {ready}"),
        );
        cover(
            format!("reset_while_{stream}_moves"),
            format!("reset & {valid} & {ready}"),
        );
    }
    let present: Vec<_> = (0..machine.photons_per_iteration())
        .map(|lane| format!("photon_present_{lane}"))
        .collect();
    let moves = "group_valid & group_ready";
    let [all, any] = [" & ", " | "].map(|between| present.join(between));
    cover("group_is_full".into(), format!("{moves} & {all}"));
    cover("group_is_empty".into(), format!("{moves} & ~({any})"));
    cover("group_is_last".into(), format!("{moves} & group_last"));
    for address in 0..addresses(machine) {
        let name = format!("address_{address}");
        cover(name, format!("control_address == {address}"));
    }
    covers
}

/// The number of addresses of the machine's program; 0 where there is no program.
fn addresses(machine: &Machine) -> usize {
    let sequential = machine.microprogram().map(|program| program.steps().len());
    let overlapped = machine
        .overlap_program()
        .map(|program| program.end_address() as usize);
    sequential.or(overlapped).unwrap_or(0)
}

/// The points as statements for the trace module.
pub(super) fn statements(covers: &[(String, String)]) -> String {
    let mut text = String::new();
    for (name, when) in covers {
        let _ = writeln!(text, "  {name}: cover property (@(posedge clock) {when});");
    }
    text
}
