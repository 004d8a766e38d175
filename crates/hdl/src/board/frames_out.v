// Sends the bridge's frames. The first in this order goes next: a sync's answer, an error, a register's answer, a credit, a result.
module @TOP@_frames_out(clock, sync, sync_begins, sync_token, error, error_cause, expected, taken,
    answer_valid, answer_ready, answer_is_read, answer, result_valid, result_ready, result,
    byte_valid, byte_ready, byte_data);
    input wire clock;
    input wire sync;
    input wire sync_begins;
    input wire [7:0] sync_token;
    input wire error;
    input wire [7:0] error_cause;
    input wire [7:0] expected;
    input wire [15:0] taken;
    input wire answer_valid;
    output wire answer_ready;
    input wire answer_is_read;
    input wire [39:0] answer;
    input wire result_valid;
    output wire result_ready;
    input wire [@RESULT_HIGH@:0] result;
    output wire byte_valid;
    input wire byte_ready;
    output wire [7:0] byte_data;
    localparam [2:0] IDLE = 3'd0, FLAG = 3'd1, KIND = 3'd2, NUMBER = 3'd3, PAYLOAD = 3'd4, CRC_HIGH = 3'd5, CRC_LOW = 3'd6;
    reg [2:0] stage;
    reg [7:0] kind;
    reg [7:0] number;
    reg [7:0] left;
    reg [@OUT_HIGH@:0] payload;
    reg [15:0] crc;
    // The escape of this byte was sent.
    reg escaped;
    reg synced_waits;
    reg [7:0] token;
    reg error_waits;
    reg [7:0] cause;
    // The bytes taken that the host was told.
    reg [15:0] told;
    initial stage = IDLE;
    initial number = 8'd0;
    initial synced_waits = 1'b0;
    initial error_waits = 1'b0;
    initial told = 16'd0;
    wire idle = stage == IDLE;
    wire [15:0] untold = taken - told;
    wire credit_waits = untold >= 16'd@CREDIT_STEP@;
    wire sends_synced = idle & synced_waits;
    wire sends_error = idle & ~synced_waits & error_waits;
    wire sends_answer = idle & ~synced_waits & ~error_waits & answer_valid;
    wire sends_credit = idle & ~synced_waits & ~error_waits & ~answer_valid & credit_waits;
    wire sends_result = idle & ~synced_waits & ~error_waits & ~answer_valid & ~credit_waits & result_valid;
    assign answer_ready = sends_answer;
    assign result_ready = idle & ~synced_waits & ~error_waits & ~answer_valid & ~credit_waits;
    wire starts = sends_synced | sends_error | sends_answer | sends_credit | sends_result;
    wire [7:0] answer_kind = answer_is_read ? 8'd@READ_ANSWER@ : 8'd@WRITE_ANSWER@;
    wire [7:0] next_kind = sends_synced ? 8'd@SYNCED@ : sends_error ? 8'd@ERROR@ : sends_answer ? answer_kind
        : sends_credit ? 8'd@CREDIT@ : 8'd@RESULT@;
    wire [7:0] value = next_kind;
    wire [7:0] length = @LENGTHS@;
    wire [7:0] plain = (stage == KIND) ? kind : (stage == NUMBER) ? number : (stage == PAYLOAD) ? payload[7:0]
        : (stage == CRC_HIGH) ? crc[15:8] : crc[7:0];
    wire needs_escape = (plain == 8'd@FLAG@) | (plain == 8'd@ESCAPE@);
    wire is_flag = stage == FLAG;
    assign byte_valid = ~idle;
    assign byte_data = is_flag ? 8'd@FLAG@ : ~needs_escape ? plain : escaped ? (plain ^ 8'd@ESCAPED@) : 8'd@ESCAPE@;
    wire moves = byte_valid & byte_ready;
    wire escapes = moves & ~is_flag & needs_escape & ~escaped;
    wire sent = moves & ~escapes;
    wire [15:0] crc_next;
    @TOP@_crc of_crc(.crc(crc), .data(plain), .next(crc_next));
    always @(posedge clock) begin
        if (sync) begin
            synced_waits <= 1'b1;
            token <= sync_token;
        end else if (sends_synced) begin
            synced_waits <= 1'b0;
        end
        if (error) begin
            error_waits <= 1'b1;
            cause <= error_cause;
        end else if (sends_error | sync) begin
            error_waits <= 1'b0;
        end
        if (sync & sync_begins) told <= 16'd0;
        else if (sends_synced | sends_credit) told <= taken;
        escaped <= (escaped | escapes) & ~sent;
        if (starts) begin
            stage <= FLAG;
            kind <= next_kind;
            left <= length;
            crc <= 16'd@CRC_START@;
            payload <= @PAYLOADS@;
        end
        if (sent) begin
            if ((stage == KIND) | (stage == NUMBER) | (stage == PAYLOAD)) crc <= crc_next;
            case (stage)
                FLAG: stage <= KIND;
                KIND: stage <= NUMBER;
                NUMBER: begin
                    number <= number + 8'd1;
                    stage <= PAYLOAD;
                end
                PAYLOAD: begin
                    payload <= {8'd0, payload[@OUT_HIGH@:8]};
                    left <= left - 8'd1;
                    if (left == 8'd1) stage <= CRC_HIGH;
                end
                CRC_HIGH: stage <= CRC_LOW;
                default: stage <= IDLE;
            endcase
        end
    end
endmodule
