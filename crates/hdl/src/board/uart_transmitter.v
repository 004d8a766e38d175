// Sends bytes: a start bit, 8 bits with the lowest first, a stop bit.
module @TOP@_uart_transmitter(clock, byte_valid, byte_ready, byte_data, line);
    // Clocks of a bit, at least 4.
    parameter [15:0] CLOCKS = 16'd4;
    input wire clock;
    input wire byte_valid;
    output wire byte_ready;
    input wire [7:0] byte_data;
    output wire line;
    reg busy;
    reg level;
    // The bits behind the one on the line.
    reg [8:0] bits;
    reg [3:0] place;
    reg [15:0] left;
    initial busy = 1'b0;
    initial level = 1'b1;
    assign byte_ready = ~busy;
    assign line = level;
    always @(posedge clock) begin
        if (!busy) begin
            place <= 4'd0;
            left <= CLOCKS - 16'd1;
            bits <= {1'b1, byte_data};
            busy <= byte_valid;
            level <= ~byte_valid;
        end else if (left == 16'd0) begin
            left <= CLOCKS - 16'd1;
            place <= place + 4'd1;
            bits <= {1'b1, bits[8:1]};
            level <= bits[0];
            // The stop bit is the tenth.
            if (place == 4'd9) busy <= 1'b0;
        end else begin
            left <= left - 16'd1;
        end
    end
endmodule
