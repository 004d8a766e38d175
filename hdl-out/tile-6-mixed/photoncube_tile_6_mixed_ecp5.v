// SPDX-License-Identifier: MIT
// tile-6-mixed: 11 modules of photoncube_tile_6_mixed.v, made of an ECP5's own cells.
// Written by photoncube 0.2.0, `photoncube generate --machine tile-6-mixed`; do not edit.
//
// Each replaces the module of that name in photoncube_tile_6_mixed.v and is the same function,
// which scripts/yosys/ecp5.sh proves. With both files as they are a name is declared twice. Yosys:
// read_verilog photoncube_tile_6_mixed.v; read_verilog -overwrite photoncube_tile_6_mixed_ecp5.v.
// Elsewhere leave the modules below out of photoncube_tile_6_mixed.v; the cells (CCU2C, LUT4, ...)
// are those of Lattice's library.
//
//   photoncube_tile_6_mixed_accumulate_2
//   photoncube_tile_6_mixed_gated_sum_2
//   photoncube_tile_6_mixed_lookup
//   photoncube_tile_6_mixed_product
//   photoncube_tile_6_mixed_subtract
//   photoncube_tile_6_mixed_range_of_format
//   photoncube_tile_6_mixed_accumulate
//   photoncube_tile_6_mixed_gated_sum
//   photoncube_tile_6_mixed_square_sum
//   photoncube_tile_6_mixed_magnitude_of
//   photoncube_tile_6_mixed_digit_products

module photoncube_tile_6_mixed_accumulate_2(group, sum, first, next_sum);
    input wire [2:0] group;
    input wire [12:0] sum;
    input wire first;
    output wire [12:0] next_sum;
    wire [13:0] chain;
    wire [7:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(sum[0]), .B0(first), .C0(group[0]), .D0(1'b1),
        .A1(sum[1]), .B1(first), .C1(group[1]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(sum[2]), .B0(first), .C0(group[2]), .D0(1'b1),
        .A1(sum[3]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(sum[4]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[5]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(sum[6]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[7]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(sum[8]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[9]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(sum[10]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[11]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(sum[12]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    assign next_sum = chain[12:0];
endmodule

module photoncube_tile_6_mixed_gated_sum_2(a, b, a_in_range, b_in_range, sum);
    input wire a;
    input wire b;
    input wire a_in_range;
    input wire b_in_range;
    output wire [1:0] sum;
    wire [1:0] chain;
    wire [1:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(a), .B0(a_in_range), .C0(b), .D0(b_in_range),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    assign sum = chain[1:0];
endmodule

module photoncube_tile_6_mixed_lookup(clock, difference_a, difference_b, square_a, square_b,
    far_a, far_b);
    input wire clock;
    input wire [9:0] difference_a;
    input wire [9:0] difference_b;
    output wire [13:0] square_a;
    output wire [13:0] square_b;
    output wire far_a;
    output wire far_b;
    reg [9:0] before_a;
    initial before_a = 10'd0;
    always @(posedge clock) before_a <= difference_a;
    wire [9:0] delayed_a = before_a;
    wire [9:0] address_a = delayed_a;
    wire [17:0] word_a;
    assign square_a = word_a[13:0];
    assign far_a = word_a[14];
    reg [9:0] before_b;
    initial before_b = 10'd0;
    always @(posedge clock) before_b <= difference_b;
    wire [9:0] delayed_b = before_b;
    wire [9:0] address_b = delayed_b;
    wire [17:0] word_b;
    assign square_b = word_b[13:0];
    assign far_b = word_b[14];
    DP16KD #(.DATA_WIDTH_A(18), .DATA_WIDTH_B(18), .REGMODE_A("OUTREG"), .REGMODE_B("OUTREG"), .GSR("DISABLED"),
        .INITVAL_00(320'h000e1000c4000a900090000790006400051000400003100024000190001000009000040000100000),
        .INITVAL_01(320'h003c1003840034900310002d9002a4002710024000211001e4001b90019000169001440012100100),
        .INITVAL_02(320'h008a100844007e90079000739006e40069100640005f1005a40055900510004c9004840044100400),
        .INITVAL_03(320'h00f8100f0400e8900e1000d9900d2400cb100c4000bd100b6400af900a9000a29009c40096100900),
        .INITVAL_04(320'h01861017c40172901690015f901564014d101440013b101324012990121001189011040108101000),
        .INITVAL_05(320'h0234102284021c9021100205901fa401ef101e4001d9101ce401c3901b9001ae901a44019a101900),
        .INITVAL_06(320'h0302102f4402e6902d9002cb902be402b1102a4002971028a4027d9027100264902584024c102400),
        .INITVAL_07(320'h03f0103e0403d0903c1003b1903a24039310384003751036640357903490033a9032c4031e103100),
        .INITVAL_08(320'h04fe104ec404da904c9004b7904a6404951048400473104624045190441004309042040410104000),
        .INITVAL_09(320'h062c1061840604905f1005dd905ca405b7105a4005911057e4056b90559005469053440522105100),
        .INITVAL_0A(320'h077a107644074e90739007239070e406f9106e4006cf106ba406a5906910067c9066840654106400),
        .INITVAL_0B(320'h04e8104d0404b8904a100489904724045b104440042d10416407ff907e9007d2907bc407a6107900),
        .INITVAL_0C(320'h06761065c40642906290060f905f6405dd105c4005ab105924057990561005489053040518105000),
        .INITVAL_0D(320'h042410408407ec907d1007b59079a4077f10764007491072e40713906f9006de906c4406aa106900),
        .INITVAL_0E(320'h05f2105d4405b6905990057b9055e405411052400507104ea404cd904b100494904784045c104400),
        .INITVAL_0F(320'h07e0107c0407a09078100761907424072310704006e5106c6406a7906890066a9064c4062e106100),
        .INITVAL_10(320'h05ee105cc405aa9058900567905464052510504004e3104c2404a190481004609044040420104000),
        .INITVAL_11(320'h041c107f8407d4907b10078d9076a407471072400701106de406bb90699006769065440632106100),
        .INITVAL_12(320'h066a106444061e905f9005d3905ae40589105640053f1051a404f5904d1004ac9048840464104400),
        .INITVAL_13(320'h04d8104b040488904610043990412407eb107c40079d107764074f9072900702906dc406b6106900),
        .INITVAL_14(320'h07661073c40712906e9006bf906964066d106440061b105f2405c9905a1005789055040528105000),
        .INITVAL_15(320'h0614105e8405bc90591005659053a4050f104e4004b91048e40463904390040e907e4407ba107900),
        .INITVAL_16(320'h04e2104b440486904590042b907fe407d1107a4007771074a4071d906f1006c4906984066c106400),
        .INITVAL_17(320'h07d0107a0407709074100711906e2406b3106840065510626405f7905c90059a9056c4053e105100),
        .INITVAL_18(320'h06de106ac4067a9064900617905e6405b5105840055310522404f1904c1004909046040430104000),
        .INITVAL_19(320'h060c105d8405a4905710053d9050a404d7104a4004711043e4040b907d9007a69077440742107100),
        .INITVAL_1A(320'h055a10524404ee904b9004839044e40419107e4007af1077a4074590711006dc906a840674106400),
        .INITVAL_1B(320'h04c8104904045890421007e9907b24077b107440070d106d64069f9066900632905fc405c6105900),
        .INITVAL_1C(320'h04561041c407e2907a90076f90736406fd106c40068b1065240619905e1005a89057040538105000),
        .INITVAL_1D(320'h0404107c84078c9075100715906da4069f1066400629105ee405b3905790053e90504404ca104900),
        .INITVAL_1E(320'h07d2107944075690719006db9069e4066110624005e7105aa4056d90531004f4904b84047c104400),
        .INITVAL_1F(320'h07c0107804074090701006c1906824064310604005c5105864054790509004ca9048c4044e104100),
        .INITVAL_20(320'h044e1048c404ca905090054790586405c5106040064310682406c1907010074090780407c0104000),
        .INITVAL_21(320'h047c104b8404f4905310056d905aa405e710624006611069e406db907190075690794407d2104100),
        .INITVAL_22(320'h04ca105044053e90579005b3905ee40629106640069f106da40715907510078c907c840404104400),
        .INITVAL_23(320'h053810570405a8905e100619906524068b106c4006fd107364076f907a9007e29041c40456104900),
        .INITVAL_24(320'h05c6105fc40632906690069f906d64070d107440077b107b2407e9904210045890490404c8105000),
        .INITVAL_25(320'h0674106a8406dc90711007459077a407af107e4004191044e40483904b9004ee905244055a105900),
        .INITVAL_26(320'h074210774407a6907d90040b9043e40471104a4004d71050a4053d90571005a4905d84060c106400),
        .INITVAL_27(320'h04301046040490904c1004f1905224055310584005b5105e640617906490067a906ac406de107100),
        .INITVAL_28(320'h053e1056c4059a905c9005f7906264065510684006b3106e2407119074100770907a0407d0104000),
        .INITVAL_29(320'h066c10698406c4906f10071d9074a40777107a4007d1107fe4042b9045900486904b4404e2105100),
        .INITVAL_2A(320'h07ba107e44040e90439004639048e404b9104e40050f1053a4056590591005bc905e840614106400),
        .INITVAL_2B(320'h05281055040578905a1005c9905f24061b106440066d10696406bf906e9007129073c40766107900),
        .INITVAL_2C(320'h06b6106dc40702907290074f907764079d107c4007eb10412404399046100488904b0404d8105000),
        .INITVAL_2D(320'h046410488404ac904d1004f59051a4053f1056400589105ae405d3905f90061e906444066a106900),
        .INITVAL_2E(320'h0632106544067690699006bb906de4070110724007471076a4078d907b1007d4907f84041c104400),
        .INITVAL_2F(320'h0420104404046090481004a1904c2404e31050400525105464056790589005aa905cc405ee106100),
        .INITVAL_30(320'h062e1064c4066a90689006a7906c6406e51070400723107424076190781007a0907c0407e0104000),
        .INITVAL_31(320'h045c1047840494904b1004cd904ea4050710524005411055e4057b90599005b6905d4405f2106100),
        .INITVAL_32(320'h06aa106c4406de906f9007139072e40749107640077f1079a407b5907d1007ec9040840424104400),
        .INITVAL_33(320'h05181053040548905610057990592405ab105c4005dd105f64060f90629006429065c40676106900),
        .INITVAL_34(320'h07a6107bc407d2907e9007ff904164042d104440045b1047240489904a1004b8904d0404e8105000),
        .INITVAL_35(320'h0654106684067c90691006a5906ba406cf106e4006f91070e40723907390074e907644077a107900),
        .INITVAL_36(320'h05221053440546905590056b9057e40591105a4005b7105ca405dd905f100604906184062c106400),
        .INITVAL_37(320'h04101042040430904410045190462404731048400495104a6404b7904c9004da904ec404fe105100),
        .INITVAL_38(320'h031e1032c4033a903490035790366403751038400393103a2403b1903c1003d0903e0403f0104000),
        .INITVAL_39(320'h024c1025840264902710027d9028a40297102a4002b1102be402cb902d9002e6902f440302103100),
        .INITVAL_3A(320'h019a101a4401ae901b9001c3901ce401d9101e4001ef101fa40205902110021c9022840234102400),
        .INITVAL_3B(320'h010810110401189012100129901324013b101440014d101564015f90169001729017c40186101900),
        .INITVAL_3C(320'h00961009c400a2900a9000af900b6400bd100c4000cb100d2400d9900e1000e8900f0400f8101000),
        .INITVAL_3D(320'h0044100484004c90051000559005a4005f10064000691006e40073900790007e900844008a100900),
        .INITVAL_3E(320'h00121001440016900190001b9001e4002110024000271002a4002d9003100034900384003c100400),
        .INITVAL_3F(320'h000010000400009000100001900024000310004000051000640007900090000a9000c4000e100100)) block (
        .CLKA(clock), .CEA(1'b1), .OCEA(1'b1), .WEA(1'b0), .RSTA(1'b0),
        .CSA0(1'b0), .CSA1(1'b0), .CSA2(1'b0),
        .ADA0(1'b0), .ADA1(1'b0), .ADA2(1'b0), .ADA3(1'b0), .ADA4(address_a[0]), .ADA5(address_a[1]), .ADA6(address_a[2]), .ADA7(address_a[3]), .ADA8(address_a[4]), .ADA9(address_a[5]), .ADA10(address_a[6]), .ADA11(address_a[7]), .ADA12(address_a[8]), .ADA13(address_a[9]),
        .DOA0(word_a[0]), .DOA1(word_a[1]), .DOA2(word_a[2]), .DOA3(word_a[3]), .DOA4(word_a[4]), .DOA5(word_a[5]), .DOA6(word_a[6]), .DOA7(word_a[7]), .DOA8(word_a[8]), .DOA9(word_a[9]), .DOA10(word_a[10]), .DOA11(word_a[11]), .DOA12(word_a[12]), .DOA13(word_a[13]), .DOA14(word_a[14]), .DOA15(word_a[15]), .DOA16(word_a[16]), .DOA17(word_a[17]),
        .CLKB(clock), .CEB(1'b1), .OCEB(1'b1), .WEB(1'b0), .RSTB(1'b0),
        .CSB0(1'b0), .CSB1(1'b0), .CSB2(1'b0),
        .ADB0(1'b0), .ADB1(1'b0), .ADB2(1'b0), .ADB3(1'b0), .ADB4(address_b[0]), .ADB5(address_b[1]), .ADB6(address_b[2]), .ADB7(address_b[3]), .ADB8(address_b[4]), .ADB9(address_b[5]), .ADB10(address_b[6]), .ADB11(address_b[7]), .ADB12(address_b[8]), .ADB13(address_b[9]),
        .DOB0(word_b[0]), .DOB1(word_b[1]), .DOB2(word_b[2]), .DOB3(word_b[3]), .DOB4(word_b[4]), .DOB5(word_b[5]), .DOB6(word_b[6]), .DOB7(word_b[7]), .DOB8(word_b[8]), .DOB9(word_b[9]), .DOB10(word_b[10]), .DOB11(word_b[11]), .DOB12(word_b[12]), .DOB13(word_b[13]), .DOB14(word_b[14]), .DOB15(word_b[15]), .DOB16(word_b[16]), .DOB17(word_b[17]));
endmodule

module photoncube_tile_6_mixed_product(clock, difference, square, far);
    input wire clock;
    input wire [9:0] difference;
    output wire [13:0] square;
    output wire far;
    reg [9:0] operand;
    initial operand = 10'd0;
    always @(posedge clock) operand <= difference;
    wire [35:0] product;
    MULT18X18D #(.REG_INPUTA_CLK("CLK0"), .REG_INPUTB_CLK("CLK0"), .REG_OUTPUT_CLK("CLK0"), .GSR("DISABLED")) block (
        .CLK0(clock), .CE0(1'b1), .RST0(1'b0),
        .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0),
        .A0(1'b0), .A1(1'b0), .A2(1'b0), .A3(1'b0), .A4(1'b0), .A5(1'b0), .A6(1'b0), .A7(1'b0), .A8(operand[0]), .A9(operand[1]), .A10(operand[2]), .A11(operand[3]), .A12(operand[4]), .A13(operand[5]), .A14(operand[6]), .A15(operand[7]), .A16(operand[8]), .A17(operand[9]),
        .B0(1'b0), .B1(1'b0), .B2(1'b0), .B3(1'b0), .B4(1'b0), .B5(1'b0), .B6(1'b0), .B7(1'b0), .B8(operand[0]), .B9(operand[1]), .B10(operand[2]), .B11(operand[3]), .B12(operand[4]), .B13(operand[5]), .B14(operand[6]), .B15(operand[7]), .B16(operand[8]), .B17(operand[9]),
        .P0(product[0]), .P1(product[1]), .P2(product[2]), .P3(product[3]), .P4(product[4]), .P5(product[5]), .P6(product[6]), .P7(product[7]), .P8(product[8]), .P9(product[9]), .P10(product[10]), .P11(product[11]), .P12(product[12]), .P13(product[13]), .P14(product[14]), .P15(product[15]), .P16(product[16]), .P17(product[17]), .P18(product[18]), .P19(product[19]), .P20(product[20]), .P21(product[21]), .P22(product[22]), .P23(product[23]), .P24(product[24]), .P25(product[25]), .P26(product[26]), .P27(product[27]), .P28(product[28]), .P29(product[29]), .P30(product[30]), .P31(product[31]), .P32(product[32]), .P33(product[33]), .P34(product[34]), .P35(product[35]));
    assign square = product[29:16];
    assign far = |product[33:30];
endmodule

module photoncube_tile_6_mixed_subtract(a, b, difference);
    input wire [8:0] a;
    input wire [8:0] b;
    output wire [9:0] difference;
    wire [11:0] chain;
    wire [6:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h0008), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(a[0]), .B1(b[0]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(a[1]), .B0(b[1]), .C0(1'b1), .D0(1'b1),
        .A1(a[2]), .B1(b[2]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(a[3]), .B0(b[3]), .C0(1'b1), .D0(1'b1),
        .A1(a[4]), .B1(b[4]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(a[5]), .B0(b[5]), .C0(1'b1), .D0(1'b1),
        .A1(a[6]), .B1(b[6]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(a[7]), .B0(b[7]), .C0(1'b1), .D0(1'b1),
        .A1(a[8]), .B1(b[8]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'hfff0), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    assign difference = chain[10:1];
endmodule

module photoncube_tile_6_mixed_range_of_format(distance, far, in_range);
    input wire [15:0] distance;
    input wire far;
    output wire in_range;
    wire above;
    LUT4 #(.INIT(16'hfefe)) lut_above (.A(far), .B(distance[14]), .C(distance[15]), .D(1'b0), .Z(above));
    wire all_without;
    LUT4 #(.INIT(16'h0000)) lut_all_without (.A(distance[9]), .B(distance[10]), .C(distance[11]), .D(distance[12]), .Z(all_without));
    wire all_with;
    LUT4 #(.INIT(16'h8000)) lut_all_with (.A(distance[9]), .B(distance[10]), .C(distance[11]), .D(distance[12]), .Z(all_with));
    wire all;
    PFUMX mux_all (.ALUT(all_with), .BLUT(all_without), .C0(distance[13]), .Z(all));
    wire middle;
    LUT4 #(.INIT(16'hfffe)) lut_middle (.A(distance[5]), .B(distance[6]), .C(distance[7]), .D(distance[8]), .Z(middle));
    wire low_without;
    LUT4 #(.INIT(16'hffe0)) lut_low_without (.A(distance[0]), .B(distance[1]), .C(distance[2]), .D(distance[3]), .Z(low_without));
    wire low_with;
    LUT4 #(.INIT(16'hffff)) lut_low_with (.A(distance[0]), .B(distance[1]), .C(distance[2]), .D(distance[3]), .Z(low_with));
    wire low;
    PFUMX mux_low (.ALUT(low_with), .BLUT(low_without), .C0(distance[4]), .Z(low));
    wire near;
    LUT4 #(.INIT(16'h1115)) lut_near (.A(above), .B(all), .C(middle), .D(low), .Z(near));
    assign in_range = near;
endmodule

module photoncube_tile_6_mixed_accumulate(group, sum, first, next_sum);
    input wire [7:0] group;
    input wire [17:0] sum;
    input wire first;
    output wire [17:0] next_sum;
    wire [17:0] chain;
    wire [9:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(sum[0]), .B0(first), .C0(group[0]), .D0(1'b1),
        .A1(sum[1]), .B1(first), .C1(group[1]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(sum[2]), .B0(first), .C0(group[2]), .D0(1'b1),
        .A1(sum[3]), .B1(first), .C1(group[3]), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(sum[4]), .B0(first), .C0(group[4]), .D0(1'b1),
        .A1(sum[5]), .B1(first), .C1(group[5]), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(sum[6]), .B0(first), .C0(group[6]), .D0(1'b1),
        .A1(sum[7]), .B1(first), .C1(group[7]), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(sum[8]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[9]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(sum[10]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[11]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(sum[12]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[13]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_7 (
        .CIN(carry[7]), .A0(sum[14]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[15]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[14]), .S1(chain[15]), .COUT(carry[8]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_8 (
        .CIN(carry[8]), .A0(sum[16]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[17]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[16]), .S1(chain[17]), .COUT(carry[9]));
    assign next_sum = chain[17:0];
endmodule

module photoncube_tile_6_mixed_gated_sum(a, b, a_in_range, b_in_range, sum);
    input wire [5:0] a;
    input wire [5:0] b;
    input wire a_in_range;
    input wire b_in_range;
    output wire [6:0] sum;
    wire [7:0] chain;
    wire [4:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(a[0]), .B0(a_in_range), .C0(b[0]), .D0(b_in_range),
        .A1(a[1]), .B1(a_in_range), .C1(b[1]), .D1(b_in_range),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(a[2]), .B0(a_in_range), .C0(b[2]), .D0(b_in_range),
        .A1(a[3]), .B1(a_in_range), .C1(b[3]), .D1(b_in_range),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(a[4]), .B0(a_in_range), .C0(b[4]), .D0(b_in_range),
        .A1(a[5]), .B1(a_in_range), .C1(b[5]), .D1(b_in_range),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h0000), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    assign sum = chain[6:0];
endmodule

module photoncube_tile_6_mixed_square_sum(magnitude, cross_product, square);
    input wire [6:0] magnitude;
    input wire [6:0] cross_product;
    output wire [13:0] square;
    wire table_0 = (magnitude[0]);
    wire table_1 = 1'b0;
    wire table_2 = (~magnitude[0] & magnitude[1]);
    wire table_3 = (magnitude[0] & magnitude[1] & ~magnitude[2]) | (magnitude[0] & ~magnitude[1] & magnitude[2]);
    wire table_4 = (~magnitude[0] & ~magnitude[1] & magnitude[2]) | (magnitude[0] & ~magnitude[1] & magnitude[2]) | (magnitude[0] & magnitude[1] & magnitude[2]);
    wire table_5 = (magnitude[1] & magnitude[2]);
    wire table_6 = (magnitude[3]);
    wire table_7 = 1'b0;
    wire table_8 = (~magnitude[3] & magnitude[4]);
    wire table_9 = (magnitude[3] & magnitude[4] & ~magnitude[5]) | (magnitude[3] & ~magnitude[4] & magnitude[5]);
    wire table_10 = (~magnitude[3] & ~magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & ~magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & ~magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (~magnitude[3] & ~magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_11 = (~magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (~magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & ~magnitude[4] & magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_12 = (~magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_13 = (magnitude[5] & magnitude[6]);
    wire [9:0] chain;
    wire [5:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h5a9a), .INIT1(16'h6a6a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(cross_product[0]), .B0(magnitude[1]), .C0(magnitude[2]), .D0(magnitude[0]),
        .A1(cross_product[1]), .B1(magnitude[1]), .C1(magnitude[2]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'haaaa), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(cross_product[2]), .B0(magnitude[3]), .C0(1'b1), .D0(1'b1),
        .A1(cross_product[3]), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h9a9a), .INIT1(16'h96aa), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(cross_product[4]), .B0(magnitude[3]), .C0(magnitude[4]), .D0(1'b1),
        .A1(cross_product[5]), .B1(magnitude[5]), .C1(magnitude[4]), .D1(magnitude[3]),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'he860), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(cross_product[6]), .B0(table_10), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[6]), .C1(magnitude[4]), .D1(magnitude[3]),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'hc4c0), .INIT1(16'h8880), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(magnitude[5]), .B0(magnitude[6]), .C0(magnitude[4]), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[6]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign square = {chain[9:0], table_3, table_2, table_1, table_0};
endmodule

module photoncube_tile_6_mixed_magnitude_of(difference, magnitude);
    input wire [9:0] difference;
    output wire [8:0] magnitude;
    wire [9:0] chain;
    wire [5:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h0002), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(difference[9]), .B0(difference[0]), .C0(1'b1), .D0(1'b1),
        .A1(difference[1]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(difference[2]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[3]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(difference[4]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[5]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(difference[6]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[7]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(difference[8]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign magnitude = {chain[8:1], difference[0]};
endmodule

module photoncube_tile_6_mixed_digit_products(magnitude, low_product, high_product);
    input wire [6:0] magnitude;
    output wire [5:0] low_product;
    output wire [3:0] high_product;
    wire [5:0] low_product_chain;
    wire [3:0] low_product_carry;
    assign low_product_carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_0 (
        .CIN(low_product_carry[0]), .A0(magnitude[3]), .B0(magnitude[0]), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[4]), .B1(magnitude[0]), .C1(magnitude[3]), .D1(magnitude[1]),
        .S0(low_product_chain[0]), .S1(low_product_chain[1]), .COUT(low_product_carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_1 (
        .CIN(low_product_carry[1]), .A0(magnitude[5]), .B0(magnitude[0]), .C0(magnitude[4]), .D0(magnitude[1]),
        .A1(magnitude[6]), .B1(magnitude[0]), .C1(magnitude[5]), .D1(magnitude[1]),
        .S0(low_product_chain[2]), .S1(low_product_chain[3]), .COUT(low_product_carry[2]));
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_2 (
        .CIN(low_product_carry[2]), .A0(magnitude[6]), .B0(magnitude[1]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(low_product_chain[4]), .S1(low_product_chain[5]), .COUT(low_product_carry[3]));
    assign low_product = low_product_chain[5:0];
    assign high_product = magnitude[6:3] & {4{magnitude[2]}};
endmodule
