// What the DSP block and the block RAM of an ECP5 do, as far as the machines use them: Yosys has no models of
// them. Other parameters are refused, by an instance of a module that there is not; what a pin does that no
// machine uses makes the outputs unknown.

// A product of two numbers, signed or not, with registers before and behind it or without any: Lattice,
// FPGA-TN-02205, "sysDSP usage guide for ECP5 and ECP5-5G", figure of MULT18X18D.
module MULT18X18D(
    input A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0,
    input B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0,
    input C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0,
    input SIGNEDA, SIGNEDB, SOURCEA, SOURCEB, CLK0, CE0, RST0,
    output P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18,
    output P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
);
    parameter REG_INPUTA_CLK = "NONE";
    parameter REG_INPUTB_CLK = "NONE";
    parameter REG_OUTPUT_CLK = "NONE";
    parameter GSR = "ENABLED";
    localparam REGISTERED = REG_INPUTA_CLK == "CLK0";
    // One bit more than an operand, so that unsigned ones are numbers too.
    wire signed [18:0] a_in = {SIGNEDA & A17,
        A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
    wire signed [18:0] b_in = {SIGNEDB & B17,
        B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};
    wire [35:0] product;
    generate
        if (REGISTERED) begin : with_registers
            reg signed [18:0] a = 0, b = 0;
            reg signed [37:0] p = 0;
            always @(posedge CLK0) if (CE0) begin
                a <= a_in;
                b <= b_in;
                p <= a * b;
                if (RST0) begin
                    a <= 0;
                    b <= 0;
                    p <= 0;
                end
            end
            assign product = p[35:0];
        end else begin : without_registers
            wire signed [37:0] p = a_in * b_in;
            assign product = p[35:0];
        end
        if ((REGISTERED ? REG_INPUTB_CLK != "CLK0" || REG_OUTPUT_CLK != "CLK0" || GSR != "DISABLED"
            : REG_INPUTA_CLK != "NONE" || REG_INPUTB_CLK != "NONE" || REG_OUTPUT_CLK != "NONE"))
            not_modelled other_use();
    endgenerate
    // An operand can come from the block beside it, which is not modelled.
    assign {
        P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18, P17, P16, P15,
        P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
    } = SOURCEA | SOURCEB ? 36'bx : product;
endmodule

// The words of a block RAM: 1024 of 18 bits, of which each port shows the one at its place, and writes the upper
// and the lower half of it where it says so.
module ecp5_block_words(
    input CLKA, CLKB,
    input [9:0] PLACEA, PLACEB,
    input [1:0] WRITESA, WRITESB,
    input [17:0] DIA, DIB,
    output [17:0] WORDA, WORDB
);
    parameter [20479:0] VALUES = 20480'd0;
    reg [17:0] words [0:1023];
    integer place;
    // A value holds 16 words in 20 bits each.
    initial for (place = 0; place < 1024; place = place + 1) words[place] = VALUES[20 * place +: 18];
    always @(posedge CLKA) begin
        if (WRITESA[0]) words[PLACEA][8:0] <= DIA[8:0];
        if (WRITESA[1]) words[PLACEA][17:9] <= DIA[17:9];
    end
    always @(posedge CLKB) begin
        if (WRITESB[0]) words[PLACEB][8:0] <= DIB[8:0];
        if (WRITESB[1]) words[PLACEB][17:9] <= DIB[17:9];
    end
    assign WORDA = words[PLACEA];
    assign WORDB = words[PLACEB];
endmodule

// A memory with two ports, each with a register for the word that was read and, if it is used, one behind it:
// Lattice, FPGA-TN-02204, "memory usage guide for ECP5 and ECP5-5G", true dual port, 1024 words of 18 bits or
// 2048 of 9. What is read while the other port writes it is unknown, and so is what both write.
module DP16KD(
    input CLKA, CEA, OCEA, WEA, RSTA, CSA0, CSA1, CSA2,
    input ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0,
    input DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4, DIA3,
    input DIA2, DIA1, DIA0,
    output DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9,
    output DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
    input CLKB, CEB, OCEB, WEB, RSTB, CSB0, CSB1, CSB2,
    input ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0,
    input DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4, DIB3,
    input DIB2, DIB1, DIB0,
    output DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9,
    output DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);
    parameter DATA_WIDTH_A = 18;
    parameter DATA_WIDTH_B = 18;
    parameter REGMODE_A = "NOREG";
    parameter REGMODE_B = "NOREG";
    parameter WRITEMODE_A = "NORMAL";
    parameter WRITEMODE_B = "NORMAL";
    parameter CSDECODE_A = "0b000";
    parameter CSDECODE_B = "0b000";
    parameter CLKAMUX = "CLKA";
    parameter CLKBMUX = "CLKB";
    // A machine never resets a block: see `shown`.
    parameter RESETMODE = "SYNC";
    parameter ASYNC_RESET_RELEASE = "SYNC";
    parameter GSR = "ENABLED";
    parameter INITVAL_00 = 320'd0;
    parameter INITVAL_01 = 320'd0;
    parameter INITVAL_02 = 320'd0;
    parameter INITVAL_03 = 320'd0;
    parameter INITVAL_04 = 320'd0;
    parameter INITVAL_05 = 320'd0;
    parameter INITVAL_06 = 320'd0;
    parameter INITVAL_07 = 320'd0;
    parameter INITVAL_08 = 320'd0;
    parameter INITVAL_09 = 320'd0;
    parameter INITVAL_0A = 320'd0;
    parameter INITVAL_0B = 320'd0;
    parameter INITVAL_0C = 320'd0;
    parameter INITVAL_0D = 320'd0;
    parameter INITVAL_0E = 320'd0;
    parameter INITVAL_0F = 320'd0;
    parameter INITVAL_10 = 320'd0;
    parameter INITVAL_11 = 320'd0;
    parameter INITVAL_12 = 320'd0;
    parameter INITVAL_13 = 320'd0;
    parameter INITVAL_14 = 320'd0;
    parameter INITVAL_15 = 320'd0;
    parameter INITVAL_16 = 320'd0;
    parameter INITVAL_17 = 320'd0;
    parameter INITVAL_18 = 320'd0;
    parameter INITVAL_19 = 320'd0;
    parameter INITVAL_1A = 320'd0;
    parameter INITVAL_1B = 320'd0;
    parameter INITVAL_1C = 320'd0;
    parameter INITVAL_1D = 320'd0;
    parameter INITVAL_1E = 320'd0;
    parameter INITVAL_1F = 320'd0;
    parameter INITVAL_20 = 320'd0;
    parameter INITVAL_21 = 320'd0;
    parameter INITVAL_22 = 320'd0;
    parameter INITVAL_23 = 320'd0;
    parameter INITVAL_24 = 320'd0;
    parameter INITVAL_25 = 320'd0;
    parameter INITVAL_26 = 320'd0;
    parameter INITVAL_27 = 320'd0;
    parameter INITVAL_28 = 320'd0;
    parameter INITVAL_29 = 320'd0;
    parameter INITVAL_2A = 320'd0;
    parameter INITVAL_2B = 320'd0;
    parameter INITVAL_2C = 320'd0;
    parameter INITVAL_2D = 320'd0;
    parameter INITVAL_2E = 320'd0;
    parameter INITVAL_2F = 320'd0;
    parameter INITVAL_30 = 320'd0;
    parameter INITVAL_31 = 320'd0;
    parameter INITVAL_32 = 320'd0;
    parameter INITVAL_33 = 320'd0;
    parameter INITVAL_34 = 320'd0;
    parameter INITVAL_35 = 320'd0;
    parameter INITVAL_36 = 320'd0;
    parameter INITVAL_37 = 320'd0;
    parameter INITVAL_38 = 320'd0;
    parameter INITVAL_39 = 320'd0;
    parameter INITVAL_3A = 320'd0;
    parameter INITVAL_3B = 320'd0;
    parameter INITVAL_3C = 320'd0;
    parameter INITVAL_3D = 320'd0;
    parameter INITVAL_3E = 320'd0;
    parameter INITVAL_3F = 320'd0;
    localparam [20479:0] VALUES = {
        INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39, INITVAL_38,
        INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32, INITVAL_31, INITVAL_30,
        INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B, INITVAL_2A, INITVAL_29, INITVAL_28,
        INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24, INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20,
        INITVAL_1F, INITVAL_1E, INITVAL_1D, INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18,
        INITVAL_17, INITVAL_16, INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10,
        INITVAL_0F, INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
        INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01, INITVAL_00
    };

    wire [9:0] place_a = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4};
    wire uses_a = CEA & ~CSA0 & ~CSA1 & ~CSA2;
    // The halves of the word that the port is about.
    wire [1:0] halves_a = DATA_WIDTH_A == 18 ? 2'b11 : {ADA3, ~ADA3};
    wire [1:0] writes_a = DATA_WIDTH_A == 18 ? {2{uses_a & WEA}} & {ADA1, ADA0}
        : {2{uses_a & WEA}} & halves_a;
    wire [17:0] in_a = {
        DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2,
        DIA1, DIA0
    };
    wire reads_a = uses_a & (~WEA | WRITEMODE_A == "READBEFOREWRITE");
    wire [17:0] word_a;

    wire [9:0] place_b = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4};
    wire uses_b = CEB & ~CSB0 & ~CSB1 & ~CSB2;
    // The halves of the word that the port is about.
    wire [1:0] halves_b = DATA_WIDTH_B == 18 ? 2'b11 : {ADB3, ~ADB3};
    wire [1:0] writes_b = DATA_WIDTH_B == 18 ? {2{uses_b & WEB}} & {ADB1, ADB0}
        : {2{uses_b & WEB}} & halves_b;
    wire [17:0] in_b = {
        DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4, DIB3, DIB2,
        DIB1, DIB0
    };
    wire reads_b = uses_b & (~WEB | WRITEMODE_B == "READBEFOREWRITE");
    wire [17:0] word_b;

    // What the other port writes in the same clock is not known.
    wire [1:0] meet = {2{uses_a & uses_b & place_a == place_b}};
    function [17:0] unless(input [1:0] unknown, input [17:0] word);
        unless = {unknown[1] ? 9'bx : word[17:9], unknown[0] ? 9'bx : word[8:0]};
    endfunction
    wire [17:0] data_a = unless(meet & writes_a & writes_b, DATA_WIDTH_A == 18 ? in_a : {2{in_a[8:0]}});
    wire [17:0] known_a = unless(meet & writes_b, word_a);
    wire [17:0] taken_a = DATA_WIDTH_A == 18 ? known_a : {9'bx, ADA3 ? known_a[17:9] : known_a[8:0]};
    wire [17:0] data_b = unless(meet & writes_a & writes_b, DATA_WIDTH_B == 18 ? in_b : {2{in_b[8:0]}});
    wire [17:0] known_b = unless(meet & writes_a, word_b);
    wire [17:0] taken_b = DATA_WIDTH_B == 18 ? known_b : {9'bx, ADB3 ? known_b[17:9] : known_b[8:0]};

    ecp5_block_words #(.VALUES(VALUES)) words(
        .CLKA(CLKA), .PLACEA(place_a), .WRITESA(writes_a), .DIA(data_a), .WORDA(word_a),
        .CLKB(CLKB), .PLACEB(place_b), .WRITESB(writes_b), .DIB(data_b), .WORDB(word_b)
    );
    reg [17:0] read_a = 0, read_b = 0, out_a = 0, out_b = 0;
    always @(posedge CLKA) begin
        if (reads_a) read_a <= taken_a;
        if (OCEA) out_a <= read_a;
    end
    always @(posedge CLKB) begin
        if (reads_b) read_b <= taken_b;
        if (OCEB) out_b <= read_b;
    end
    // A reset, of which each mode has its own, is not modelled.
    wire [17:0] shown_a = RSTA ? 18'bx : REGMODE_A == "OUTREG" ? out_a : read_a;
    assign {
        DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2,
        DOA1, DOA0
    } = shown_a;
    wire [17:0] shown_b = RSTB ? 18'bx : REGMODE_B == "OUTREG" ? out_b : read_b;
    assign {
        DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2,
        DOB1, DOB0
    } = shown_b;
    generate
        if (DATA_WIDTH_A != 9 && DATA_WIDTH_A != 18 || CSDECODE_A != "0b000" || CLKAMUX != "CLKA")
            not_modelled other_use_a();
        if (REGMODE_A != "NOREG" && REGMODE_A != "OUTREG" || WRITEMODE_A != "NORMAL" && WRITEMODE_A != "READBEFOREWRITE")
            not_modelled other_mode_a();
        if (DATA_WIDTH_B != 9 && DATA_WIDTH_B != 18 || CSDECODE_B != "0b000" || CLKBMUX != "CLKB")
            not_modelled other_use_b();
        if (REGMODE_B != "NOREG" && REGMODE_B != "OUTREG" || WRITEMODE_B != "NORMAL" && WRITEMODE_B != "READBEFOREWRITE")
            not_modelled other_mode_b();
        if (GSR != "DISABLED")
            not_modelled other_reset();
    endgenerate
endmodule
