//! The module that chooses the chain whose result leaves next.

use std::fmt::Write as _;

use photoncube_spec::Core;

/// The module. Of the chains with a result it chooses the first from `turn` on; the chain behind the chosen one has the next turn.
pub(super) fn arbiter(core: &Core) -> String {
    let top = core.top();
    let (last, bits) = (core.chains - 1, core.chain_bits());
    let high = bits - 1;
    let mut text = format!(
        "// Chooses, of the chains with a result, the first from `turn` on.\n\
         module {top}_arbiter(clock, reset, valid, taken, any_valid, chosen);\n    \
         input wire clock;\n    \
         input wire reset;\n    \
         input wire [{last}:0] valid;\n    \
         input wire taken;\n    \
         output reg any_valid;\n    \
         output reg [{high}:0] chosen;\n    \
         reg [{high}:0] turn;\n    \
         initial turn = {bits}'d0;\n    \
         always @(*) begin\n        \
         any_valid = 1'b0;\n        \
         chosen = {bits}'d0;\n"
    );
    for chain in 0..core.chains {
        let _ = writeln!(
            text,
            "        if (~any_valid & valid[{chain}] & (turn <= {bits}'d{chain})) begin\n            \
             any_valid = 1'b1;\n            chosen = {bits}'d{chain};\n        end"
        );
    }
    for chain in 0..core.chains {
        let _ = writeln!(
            text,
            "        if (~any_valid & valid[{chain}]) begin\n            \
             any_valid = 1'b1;\n            chosen = {bits}'d{chain};\n        end"
        );
    }
    text + &format!(
        "    end\n    \
         always @(posedge clock) begin\n        \
         if (taken) turn <= (chosen == {bits}'d{last}) ? {bits}'d0 : chosen + {bits}'d1;\n        \
         if (reset) turn <= {bits}'d0;\n    \
         end\n\
         endmodule\n"
    )
}
