// Reads the host's frames. The bytes of a frame go to the buffer at once; at its end they are kept there or taken back.
module @TOP@_frames_in(clock, reset, byte_valid, byte_data, byte_broken, room, write, write_data, keep, revert,
    sync, sync_begins, sync_token, error, error_cause, expected, deaf);
    input wire clock;
    input wire reset;
    input wire byte_valid;
    input wire [7:0] byte_data;
    input wire byte_broken;
    // The buffer has room for a byte.
    input wire room;
    output wire write;
    output wire [7:0] write_data;
    // The bytes written since the last of the two are kept, or taken back.
    output wire keep;
    output wire revert;
    output wire sync;
    output wire sync_begins;
    output wire [7:0] sync_token;
    output wire error;
    output wire [7:0] error_cause;
    // The number of the next frame.
    output reg [7:0] expected;
    // Frames are dropped up to a sync.
    output reg deaf;
    localparam [2:0] KIND = 3'd0, NUMBER = 3'd1, PAYLOAD = 3'd2, CRC_HIGH = 3'd3, CRC_LOW = 3'd4;
    reg in_frame;
    reg escaped;
    reg [2:0] stage;
    reg [7:0] kind;
    reg [7:0] left;
    reg number_is_right;
    reg lacked_room;
    // The last two bytes of the payload.
    reg [15:0] tail;
    reg [15:0] crc;
    initial in_frame = 1'b0;
    initial deaf = 1'b1;
    initial expected = 8'd0;
    wire whole = byte_valid & ~byte_broken;
    wire flag = whole & (byte_data == 8'd@FLAG@);
    wire escape = whole & (byte_data == 8'd@ESCAPE@);
    wire octet = whole & ~flag & ~escape;
    wire [7:0] value = byte_data ^ (escaped ? 8'd@ESCAPED@ : 8'd0);
    wire [15:0] crc_next;
    @TOP@_crc of_crc(.crc(crc), .data(value), .next(crc_next));
    // The bytes of the payload of each kind of the host; 0 where there is no such kind.
    wire [7:0] length = @LENGTHS@;
    wire is_kind = octet & in_frame & (stage == KIND);
    wire is_payload = octet & in_frame & (stage == PAYLOAD);
    wire ends = octet & in_frame & (stage == CRC_LOW);
    wire unknown = is_kind & (length == 8'd0);
    wire crc_is_right = crc_next == 16'd0;
    wire right = ends & crc_is_right;
    assign sync = right & (kind == 8'd@SYNC@);
    assign sync_token = tail[7:0];
    assign sync_begins = tail[15:8] == 8'd@BEGINS@;
    wire is_word = right & (kind != 8'd@SYNC@) & ~deaf;
    assign keep = is_word & number_is_right & ~lacked_room;
    assign revert = (byte_valid & byte_broken) | flag | (ends & ~keep);
    assign write = (is_kind | is_payload) & room;
    assign write_data = value;
    wire no_stop = byte_valid & byte_broken;
    wire cut = flag & in_frame;
    wire outside = whole & ~flag & ~in_frame;
    wire crc_is_wrong = ends & ~crc_is_right;
    wire number_is_wrong = is_word & ~number_is_right;
    wire full = is_word & number_is_right & lacked_room;
    assign error = ~deaf & (no_stop | cut | outside | unknown | crc_is_wrong | number_is_wrong | full);
    assign error_cause = no_stop ? 8'd@STOP_BIT@ : cut ? 8'd@CUT@ : outside ? 8'd@OUTSIDE@ : unknown ? 8'd@KIND@
        : crc_is_wrong ? 8'd@CRC@ : number_is_wrong ? 8'd@NUMBER@ : 8'd@FULL@;
    always @(posedge clock) begin
        if (no_stop | unknown | ends) in_frame <= 1'b0;
        if (flag) in_frame <= 1'b1;
        if (error) deaf <= 1'b1;
        if (sync) deaf <= 1'b0;
        if (sync & sync_begins) expected <= 8'd0;
        else if (keep) expected <= expected + 8'd1;
        if (escape) escaped <= 1'b1;
        if (flag) begin
            stage <= KIND;
            escaped <= 1'b0;
            lacked_room <= 1'b0;
            crc <= 16'd@CRC_START@;
        end else if (octet) begin
            escaped <= 1'b0;
            crc <= crc_next;
            if ((is_kind | is_payload) & ~room) lacked_room <= 1'b1;
            case (stage)
                KIND: begin
                    kind <= value;
                    left <= length;
                    stage <= NUMBER;
                end
                NUMBER: begin
                    number_is_right <= value == expected;
                    stage <= PAYLOAD;
                end
                PAYLOAD: begin
                    tail <= {value, tail[15:8]};
                    left <= left - 8'd1;
                    if (left == 8'd1) stage <= CRC_HIGH;
                end
                default: stage <= CRC_LOW;
            endcase
        end
        if (reset) begin
            in_frame <= 1'b0;
            deaf <= 1'b1;
            expected <= 8'd0;
        end
    end
endmodule
