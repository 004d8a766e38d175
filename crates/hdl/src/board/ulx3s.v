// A core on the board ULX3S, at the end of the serial line of its USB socket.
module @BOARD@(clk_25mhz, btn, ftdi_txd, ftdi_rxd, led, wifi_gpio0);
    input wire clk_25mhz;
    // FIRE1: resets all.
    input wire [1:1] btn;
    // From the host, and to it.
    input wire ftdi_txd;
    output wire ftdi_rxd;
    output wire [7:0] led;
    // 1 keeps the board's other processor from taking it over.
    output wire wifi_gpio0;
    wire clock;
    wire locked;
    @BOARD@_clock of_core(.board_clock(clk_25mhz), .clock(clock), .locked(locked));
    reg [1:0] settled;
    initial settled = 2'd0;
    wire reset = ~settled[1];
    wire deaf;
    wire waits;
    wire interrupt;
    @ON_LINE@ #(.CLOCKS(16'd@CLOCKS@)) on_line(.clock(clock), .reset(reset), .rx(ftdi_txd), .tx(ftdi_rxd),
        .deaf(deaf), .waits(waits), .interrupt(interrupt));
    reg [25:0] beats;
    initial beats = 26'd0;
    always @(posedge clock) begin
        settled <= {settled[0], locked & ~btn[1]};
        beats <= beats + 26'd1;
    end
    assign led = {interrupt, waits, ~ftdi_rxd, ~ftdi_txd, deaf, reset, locked, beats[25]};
    assign wifi_gpio0 = 1'b1;
endmodule
