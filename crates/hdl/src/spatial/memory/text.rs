//! The Verilog text of the photon memory.

/// The name of the block RAM's array.
pub(in crate::spatial) const GROUPS: &str = "groups";

/// The block RAM. The word read is in `read_word` one clock later and in `word` after two. Where a word is
/// read and written in one clock, its value is not used, so no logic needs to distinguish old from new. The
/// words have no initial value: no word is played before it is written, and with initial values a Cyclone V's
/// block RAM is not inferred.
pub(super) fn block_ram(width: usize, bank_groups: usize, bits: usize, group: &str) -> String {
    format!(
        "(* no_rw_check *) reg [{high}:0] {GROUPS} [0:{last}];\n\
         reg [{high}:0] write_word = {width}'d0;\n\
         reg [{high}:0] read_word = {width}'d0;\n\
         reg [{high}:0] word = {width}'d0;\n\
         wire [{high}:0] group = {{{group}}};\n\
         wire [{bits}:0] write_address = {{write_bank, write_place}};\n\
         wire [{bits}:0] read_address = {{play_bank, play_place}};\n\
         always @(posedge clock) begin\n\
         \x20 read_word <= {GROUPS}[read_address];\n\
         \x20 word <= read_word;\n\
         \x20 write_word <= group;\n\
         \x20 if (write_valid) {GROUPS}[write_address] <= write_word;\n\
         end\n",
        high = width - 1,
        last = 2 * bank_groups - 1,
    )
}

/// The registers of the memory and their next values.
pub(super) fn state(bits: usize) -> String {
    let top = bits - 1;
    format!(
        "reg fill_bank = 1'd0;\n\
         reg [{top}:0] fill_place = {bits}'d0;\n\
         reg fill_ready = 1'd0;\n\
         reg write_valid = 1'd0;\n\
         reg write_bank = 1'd0;\n\
         reg [{top}:0] write_place = {bits}'d0;\n\
         reg full_0 = 1'd0;\n\
         reg full_1 = 1'd0;\n\
         reg [{top}:0] end_place_0 = {bits}'d0;\n\
         reg [{top}:0] end_place_1 = {bits}'d0;\n\
         reg play_bank = 1'd0;\n\
         reg play_full = 1'd0;\n\
         reg [{top}:0] play_end = {bits}'d0;\n\
         reg [{top}:0] before_end = {bits}'d0;\n\
         reg [{top}:0] play_place = {bits}'d0;\n\
         reg at_end = 1'd0;\n\
         reg may_start = 1'd0;\n\
         reg playing = 1'd0;\n\
         reg releases = 1'd0;\n\
         reg release_taken = 1'd0;\n\
         reg release_next = 1'd0;\n\
         reg read_valid = 1'd0;\n\
         reg read_last = 1'd0;\n\
         reg valid = 1'd0;\n\
         reg last = 1'd0;\n\
         wire takes_group = group_valid & fill_ready;\n\
         wire set_ends = group_last | (&fill_place);\n\
         wire [15:0] wide_end = {{{pad}play_end}};\n\
         wire in_time = clocks_to_last <= wide_end;\n\
         wire busy = playing | may_start | (read_valid & read_last) | (valid & last);\n\
         wire reads = playing | may_start;\n\
         wire [{top}:0] set_end = play_bank ? end_place_1 : end_place_0;\n\
         wire ends_set = reads & at_end & (may_start ? release_next : releases);\n\
         always @(*) group_ready = fill_ready;\n\
         always @(*) word_valid = valid;\n\
         always @(*) word_last = last;\n\
         always @(posedge clock) begin\n\
         \x20 may_start <= ~busy & play_full & is_full & has_room & in_time;\n\
         \x20 play_full <= play_bank ? full_1 : full_0;\n\
         \x20 play_end <= set_end;\n\
         \x20 before_end <= set_end - {bits}'d1;\n\
         \x20 at_end <= reads ? ~at_end & (play_place == before_end) : ~|play_end;\n\
         \x20 valid <= read_valid;\n\
         \x20 last <= read_last;\n\
         \x20 read_valid <= reads;\n\
         \x20 read_last <= reads & at_end;\n\
         \x20 if (reads) begin\n\
         \x20   playing <= ~at_end;\n\
         \x20   play_place <= at_end ? {bits}'d0 : play_place + {bits}'d1;\n\
         \x20 end\n\
         \x20 if (ends_set) begin\n\
         \x20   play_bank <= ~play_bank;\n\
         \x20   if (play_bank) full_1 <= 1'd0;\n\
         \x20   else full_0 <= 1'd0;\n\
         \x20 end\n\
         \x20 if (may_start) begin\n\
         \x20   releases <= release_next;\n\
         \x20   release_next <= 1'd0;\n\
         \x20 end\n\
         \x20 release_taken <= query_taken & release_in;\n\
         \x20 if (release_taken) release_next <= 1'd1;\n\
         \x20 write_valid <= takes_group;\n\
         \x20 write_bank <= fill_bank;\n\
         \x20 write_place <= fill_place;\n\
         \x20 fill_ready <= ~(fill_bank ? full_1 : full_0) & ~(takes_group & set_ends);\n\
         \x20 if (fill_ready & ~fill_bank) end_place_0 <= fill_place;\n\
         \x20 if (fill_ready & fill_bank) end_place_1 <= fill_place;\n\
         \x20 if (takes_group) fill_place <= set_ends ? {bits}'d0 : fill_place + {bits}'d1;\n\
         \x20 if (takes_group & set_ends) begin\n\
         \x20   fill_bank <= ~fill_bank;\n\
         \x20   if (fill_bank) full_1 <= 1'd1;\n\
         \x20   else full_0 <= 1'd1;\n\
         \x20 end\n\
         \x20 if (reset) begin\n\
         \x20   fill_bank <= 1'd0;\n\
         \x20   fill_place <= {bits}'d0;\n\
         \x20   fill_ready <= 1'd0;\n\
         \x20   write_valid <= 1'd0;\n\
         \x20   write_bank <= 1'd0;\n\
         \x20   write_place <= {bits}'d0;\n\
         \x20   full_0 <= 1'd0;\n\
         \x20   full_1 <= 1'd0;\n\
         \x20   end_place_0 <= {bits}'d0;\n\
         \x20   end_place_1 <= {bits}'d0;\n\
         \x20   play_bank <= 1'd0;\n\
         \x20   play_full <= 1'd0;\n\
         \x20   play_end <= {bits}'d0;\n\
         \x20   before_end <= {bits}'d0;\n\
         \x20   play_place <= {bits}'d0;\n\
         \x20   at_end <= 1'd0;\n\
         \x20   may_start <= 1'd0;\n\
         \x20   playing <= 1'd0;\n\
         \x20   releases <= 1'd0;\n\
         \x20   release_taken <= 1'd0;\n\
         \x20   release_next <= 1'd0;\n\
         \x20   read_valid <= 1'd0;\n\
         \x20   read_last <= 1'd0;\n\
         \x20   valid <= 1'd0;\n\
         \x20   last <= 1'd0;\n\
         \x20 end\n\
         end\n",
        pad = match 16 - bits {
            0 => String::new(),
            more => format!("{more}'d0, "),
        },
    )
}
