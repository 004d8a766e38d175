//! The module that says which chain gives its result in a clock.

use std::fmt::Write as _;

use photoncube_spec::Core;

/// The module. The turn goes to the next chain with a result in the clock before, so the way from a chain's memories to its own
/// grant does not pass the other chains.
pub(super) fn arbiter(core: &Core) -> String {
    let top = core.top();
    let (last, bits) = (core.chains - 1, core.chain_bits());
    let high = bits - 1;
    let mut text = format!(
        "// Gives the turn to the next chain, from the one behind `turn` on, that has a result now.\n\
         module {top}_arbiter(clock, reset, valid, turn);\n    \
         input wire clock;\n    \
         input wire reset;\n    \
         input wire [{last}:0] valid;\n    \
         output reg [{high}:0] turn;\n    \
         initial turn = {bits}'d0;\n    \
         wire [{high}:0] next =\n"
    );
    for chain in 1..core.chains {
        let _ = writeln!(
            text,
            "        valid[{chain}] & (turn < {bits}'d{chain}) ? {bits}'d{chain} :"
        );
    }
    for chain in 0..core.chains {
        let _ = writeln!(text, "        valid[{chain}] ? {bits}'d{chain} :");
    }
    text + &format!(
        "        turn;\n    \
         always @(posedge clock) turn <= reset ? {bits}'d0 : next;\n\
         endmodule\n"
    )
}
