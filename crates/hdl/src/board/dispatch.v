// Gives the frames in the buffer to the core, one after the other: words to its streams, accesses to its registers.
module @TOP@_dispatch(clock, reset, read_valid, read_ready, read_data, taken,
    photons_valid, photons_ready, queries_valid, queries_ready, payload,
    write_valid, write_ready, write_answer_valid, write_answer, write_answer_ready,
    fetch_valid, fetch_ready, fetch_answer_valid, fetch_answer, fetch_word, fetch_answer_ready,
    answer_valid, answer_ready, answer_is_read, answer);
    input wire clock;
    input wire reset;
    input wire read_valid;
    output wire read_ready;
    input wire [7:0] read_data;
    // The bytes taken out of the buffer.
    output reg [15:0] taken;
    output wire photons_valid;
    input wire photons_ready;
    output wire queries_valid;
    input wire queries_ready;
    // The payload: its last byte is the highest.
    output reg [@IN_HIGH@:0] payload;
    output wire write_valid;
    input wire write_ready;
    input wire write_answer_valid;
    input wire [1:0] write_answer;
    output wire write_answer_ready;
    output wire fetch_valid;
    input wire fetch_ready;
    input wire fetch_answer_valid;
    input wire [1:0] fetch_answer;
    input wire [31:0] fetch_word;
    output wire fetch_answer_ready;
    // An answer of a register.
    output wire answer_valid;
    input wire answer_ready;
    output wire answer_is_read;
    output wire [39:0] answer;
    localparam [2:0] KIND = 3'd0, PAYLOAD = 3'd1, GIVE = 3'd2, WAIT = 3'd3, ANSWER = 3'd4;
    reg [2:0] state;
    reg [7:0] kind;
    reg [7:0] left;
    reg [39:0] found;
    initial state = KIND;
    initial taken = 16'd0;
    wire [7:0] value = read_data;
    wire [7:0] length = @LENGTHS@;
    assign read_ready = (state == KIND) | (state == PAYLOAD);
    wire takes = read_valid & read_ready;
    wire gives = state == GIVE;
    wire is_read = kind == 8'd@READ@;
    assign photons_valid = gives & (kind == 8'd@PHOTONS@);
    assign queries_valid = gives & (kind == 8'd@QUERY@);
    assign write_valid = gives & (kind == 8'd@WRITE@);
    assign fetch_valid = gives & is_read;
    wire given = (photons_valid & photons_ready) | (queries_valid & queries_ready);
    wire accessed = (write_valid & write_ready) | (fetch_valid & fetch_ready);
    assign write_answer_ready = (state == WAIT) & ~is_read;
    assign fetch_answer_ready = (state == WAIT) & is_read;
    wire answered = (write_answer_ready & write_answer_valid) | (fetch_answer_ready & fetch_answer_valid);
    assign answer_valid = state == ANSWER;
    assign answer_is_read = is_read;
    assign answer = found;
    always @(posedge clock) begin
        if (takes) taken <= taken + 16'd1;
        case (state)
            KIND: if (takes) begin
                kind <= value;
                left <= length;
                state <= PAYLOAD;
            end
            PAYLOAD: if (takes) begin
                payload <= {value, payload[@IN_HIGH@:8]};
                left <= left - 8'd1;
                if (left == 8'd1) state <= GIVE;
            end
            GIVE: begin
                if (given) state <= KIND;
                if (accessed) state <= WAIT;
            end
            WAIT: if (answered) begin
                found <= {fetch_word, 6'd0, is_read ? fetch_answer : write_answer};
                state <= ANSWER;
            end
            default: if (answer_ready) state <= KIND;
        endcase
        if (reset) begin
            state <= KIND;
            taken <= 16'd0;
        end
    end
endmodule
