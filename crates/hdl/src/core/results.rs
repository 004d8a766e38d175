//! The results of the chains, up to their port.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreStreams, Leaf};

use super::top::{Sizes, part, range, slice};

/// The results of the chains up to the port.
pub(super) fn results(core: &Core, streams: &CoreStreams, sizes: &Sizes) -> String {
    let Sizes {
        chain: bits,
        sums,
        result_slice,
        ..
    } = *sizes;
    let end = streams.results.end();
    let count = streams.results.field("count");
    let radius = core.has_radii().then(|| streams.results.field("radius_sq"));
    let [is_last, radius_in] = match radius {
        Some(_) => ["result_last, ", "result_radius, "],
        None => [""; 2],
    };
    let valid = (0..core.chains)
        .rev()
        .map(|chain| format!("result_valid_{chain}"));
    let valid = valid.collect::<Vec<_>>().join(", ");
    let mut text = format!(
        "\n    // Results: one chain after the other, then a slice.\n    \
         wire {}results_valid = {{{valid}}};\n    \
         wire {}turn;\n    \
         {}_arbiter arbiter(.clock(aclk), .reset(reset), .valid(results_valid), .turn(turn));\n    \
         wire result_valid = results_valid[turn];\n    \
         wire result_ready;\n    \
         reg {}result_sums;\n    \
         reg {}result_tag;\n{}    \
         always @(*) begin\n        \
         case (turn)\n",
        format_args!("[{}:0] ", core.chains - 1),
        range(bits),
        core.top(),
        range(sums),
        range(Leaf::TAG_BITS),
        radius.map_or(String::new(), |radius| format!(
            "    reg {}result_radius;\n    reg result_last;\n",
            range(radius.width)
        )),
    );
    for chain in 1..core.chains {
        text += &format!("            {bits}'d{chain}: {}", of_chain(core, chain));
    }
    text += &format!(
        "            default: {}        endcase\n    end\n",
        of_chain(core, 0)
    );
    for chain in 0..core.chains {
        let _ = writeln!(
            text,
            "    assign result_ready_{chain} = result_ready & (turn == {bits}'d{chain});"
        );
    }
    let (last, outside) = (Core::LAST_BIT, Core::OUTSIDE_BIT);
    let _ = write!(
        text,
        "    wire result_outside = result_tag[{outside}];\n    \
         wire {}result_seen = result_outside ? {{{sums}{{1'b0}}}} : result_sums;\n    \
         wire result_waits;\n    \
         wire {}result_word;\n",
        range(sums),
        range(result_slice),
    );
    text += &slice(
        core,
        "result",
        result_slice,
        [
            "result_valid",
            "result_ready",
            &format!(
                "{{{is_last}turn, result_outside, result_tag[{last}], {radius_in}result_tag[{}:0], result_seen}}",
                Core::TAG_BITS - 1
            ),
        ],
        ["result_waits", "m_axis_results_tready", "result_word"],
    );
    let padding = match streams.results.bits - end {
        0 => String::new(),
        bits => format!("{bits}'d0, "),
    };
    let _ = write!(
        text,
        "    // A result of before a reset is not given in the clock of the reset.\n    \
         assign m_axis_results_tvalid = result_waits & ~reset;\n    \
         assign m_axis_results_tdata = {{{padding}result_word[{}:0]}};\n    \
         assign m_axis_results_tlast = result_word[{end}];\n    \
         assign m_axis_results_tuser = result_word[{}];\n    \
         assign m_axis_results_tid = result_word[{}:{}];\n    \
         wire result_moves = m_axis_results_tvalid & m_axis_results_tready;\n    \
         wire {}result_photons = result_moves ? {} : {}'d0;\n",
        end - 1,
        end + 1,
        end + 1 + bits,
        end + 2,
        range(count.width),
        part(count.low, count.width, "result_word"),
        count.width,
    );
    if core.has_radii() {
        let _ = writeln!(
            text,
            "    wire result_ends = result_moves & result_word[{}];",
            end + 2 + bits
        );
    }
    text
}

/// The choice of a chain's result.
fn of_chain(core: &Core, chain: u32) -> String {
    let parts = ["sums", "tag"].into_iter();
    let of_rounds = ["radius", "last"].into_iter().filter(|_| core.has_radii());
    let lines = parts.chain(of_rounds);
    let lines =
        lines.map(|part| format!("                result_{part} = result_{part}_{chain};\n"));
    format!("begin\n{}            end\n", lines.collect::<String>())
}
