// Receives bytes: a start bit, 8 bits with the lowest first, a stop bit. Each bit is sampled in its middle.
module @TOP@_uart_receiver(clock, line, byte_valid, byte_data, byte_broken);
    // Clocks of a bit, at least 4.
    parameter [15:0] CLOCKS = 16'd4;
    input wire clock;
    input wire line;
    // For one clock with each byte; `byte_broken` says that it had no stop bit.
    output reg byte_valid;
    output reg [7:0] byte_data;
    output reg byte_broken;
    // The line is not of this clock.
    reg early;
    reg level;
    reg busy;
    // After a byte without a stop bit, the line must be 1 before a byte can begin.
    reg rested;
    reg [3:0] place;
    reg [15:0] left;
    initial early = 1'b1;
    initial level = 1'b1;
    initial busy = 1'b0;
    initial rested = 1'b0;
    initial byte_valid = 1'b0;
    wire sample = busy & (left == 16'd0);
    always @(posedge clock) begin
        early <= line;
        level <= early;
        byte_valid <= 1'b0;
        if (!busy) begin
            rested <= rested | level;
            place <= 4'd0;
            left <= (CLOCKS >> 1) - 16'd1;
            busy <= rested & ~level;
        end else if (sample) begin
            left <= CLOCKS - 16'd1;
            place <= place + 4'd1;
            if (place == 4'd0) begin
                // A start bit is 0 in its middle too.
                busy <= ~level;
            end else if (place == 4'd9) begin
                busy <= 1'b0;
                rested <= level;
                byte_valid <= 1'b1;
                byte_broken <= ~level;
            end else begin
                byte_data <= {level, byte_data[7:1]};
            end
        end else begin
            left <= left - 16'd1;
        end
    end
endmodule
