// In simulations, in the place of the PLL: the clock of the core is the board's. The lock comes some clocks after power-up.
module @BOARD@_clock(board_clock, clock, locked);
    input wire board_clock;
    output wire clock;
    output wire locked;
    reg [3:0] passed;
    initial passed = 4'd0;
    assign clock = board_clock;
    assign locked = passed == 4'd15;
    always @(posedge board_clock) if (!locked) passed <= passed + 4'd1;
endmodule
