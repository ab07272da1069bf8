// ray_box: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none
// One file holds the whole hierarchy of its top:
// verilator lint_off DECLFILENAME

// ray_box_delay_v1: delay w32_n2
//
// Delay line: a value that has to wait for a unit's result.
module ray_box_delay_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0;
    reg [31:0] stage_1;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
        end
    end

    // Outputs
    assign q_o = stage_1;
endmodule

// ray_box_delay_v2: delay w32_n5
module ray_box_delay_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0;
    reg [31:0] stage_1;
    reg [31:0] stage_2;
    reg [31:0] stage_3;
    reg [31:0] stage_4;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
            stage_2 <= stage_1;
            stage_3 <= stage_2;
            stage_4 <= stage_3;
        end
    end

    // Outputs
    assign q_o = stage_4;
endmodule

// ray_box_select: ray_box_select w32
//   constant sign_index = 8'h1f
//
// First stage of the ray-box pipeline: picks the reciprocal of each plane's role, and lets operands wait.
//
// A ray that runs upwards on an axis enters through the box's min plane and leaves through its max plane; the sign bit
// of the entry reciprocal tells the direction.
module ray_box_select (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] inv_entry_x_i,
    input  wire [31:0] inv_entry_y_i,
    input  wire [31:0] inv_entry_z_i,
    input  wire [31:0] inv_exit_x_i,
    input  wire [31:0] inv_exit_y_i,
    input  wire [31:0] inv_exit_z_i,
    input  wire [31:0] t_min_i,
    input  wire [31:0] t_max_i,
    output wire [31:0] inv_0_o,
    output wire [31:0] inv_1_o,
    output wire [31:0] inv_2_o,
    output wire [31:0] inv_3_o,
    output wire [31:0] inv_4_o,
    output wire [31:0] inv_5_o,
    output wire [31:0] t_min_o,
    output wire [31:0] t_max_o
);

    // Outputs of instances
    wire [31:0] inv_wait_0_q_o;
    wire [31:0] inv_wait_1_q_o;
    wire [31:0] inv_wait_2_q_o;
    wire [31:0] inv_wait_3_q_o;
    wire [31:0] inv_wait_4_q_o;
    wire [31:0] inv_wait_5_q_o;
    wire [31:0] t_min_wait_q_o;
    wire [31:0] t_max_wait_q_o;

    // Logic
    wire [31:0] inv_low_0 = inv_entry_x_i[31] ? inv_exit_x_i : inv_entry_x_i;
    wire [31:0] inv_high_0 = inv_entry_x_i[31] ? inv_entry_x_i : inv_exit_x_i;
    wire [31:0] inv_low_1 = inv_entry_y_i[31] ? inv_exit_y_i : inv_entry_y_i;
    wire [31:0] inv_high_1 = inv_entry_y_i[31] ? inv_entry_y_i : inv_exit_y_i;
    wire [31:0] inv_low_2 = inv_entry_z_i[31] ? inv_exit_z_i : inv_entry_z_i;
    wire [31:0] inv_high_2 = inv_entry_z_i[31] ? inv_entry_z_i : inv_exit_z_i;

    // Instances
    ray_box_delay_v1 inv_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_0),
        .q_o   (inv_wait_0_q_o)
    );
    ray_box_delay_v1 inv_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_1),
        .q_o   (inv_wait_1_q_o)
    );
    ray_box_delay_v1 inv_wait_2 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_2),
        .q_o   (inv_wait_2_q_o)
    );
    ray_box_delay_v1 inv_wait_3 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_0),
        .q_o   (inv_wait_3_q_o)
    );
    ray_box_delay_v1 inv_wait_4 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_1),
        .q_o   (inv_wait_4_q_o)
    );
    ray_box_delay_v1 inv_wait_5 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_2),
        .q_o   (inv_wait_5_q_o)
    );
    ray_box_delay_v2 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    ray_box_delay_v2 t_max_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_max_i),
        .q_o   (t_max_wait_q_o)
    );

    // Outputs
    assign inv_0_o = inv_wait_0_q_o;
    assign inv_1_o = inv_wait_1_q_o;
    assign inv_2_o = inv_wait_2_q_o;
    assign inv_3_o = inv_wait_3_q_o;
    assign inv_4_o = inv_wait_4_q_o;
    assign inv_5_o = inv_wait_5_q_o;
    assign t_min_o = t_min_wait_q_o;
    assign t_max_o = t_max_wait_q_o;
endmodule

// ray_box_fp_unpack_v1: fp_unpack e8m23
//   constant sign_index = 8'h1f
//   constant fraction_bits = 8'h17
//   constant fraction_mask = 24'h7fffff
//   constant hidden_bit = 24'h800000
//   constant special_exponent = 8'hff
//
// Splits a word into the fields that the arithmetic units compute with.
//
// A finite value is `(-1)^sign * significand * 2^(exponent - bias - (S - 1))`. A subnormal has the exponent code of the
// smallest normal number, 1, and a clear leading bit, so that the formula holds for it and for zero too.
module ray_box_fp_unpack_v1 (
    input  wire [31:0] word_i,
    output wire        sign_o,
    output wire [7:0]  encoded_exponent_o,
    output wire [7:0]  exponent_o,
    output wire [23:0] significand_o,
    output wire        nan_o,
    output wire        infinity_o
);

    // Logic
    wire [7:0] encoded_exponent = word_i[30:23];
    wire [23:0] fraction = word_i[23:0] & 24'h7fffff;
    wire special = encoded_exponent == 8'hff;
    wire [23:0] significand_1 = fraction | 24'h800000;
    wire significand_if = |encoded_exponent;
    wire [7:0] exponent = significand_if ? encoded_exponent : 8'd1;
    wire [23:0] significand = significand_if ? significand_1 : fraction;
    wire infinity_o_part = |fraction;

    // Outputs
    assign sign_o = word_i[31];
    assign encoded_exponent_o = encoded_exponent;
    assign exponent_o = exponent;
    assign significand_o = significand;
    assign nan_o = special & infinity_o_part;
    assign infinity_o = special & ~infinity_o_part;
endmodule

// ray_box_sticky_shift: sticky_shift w28_a8
//   constant distance_0 = 8'd1
//   constant distance_1 = 8'd2
//   constant distance_2 = 8'd4
//   constant distance_3 = 8'd8
//   constant distance_4 = 8'h10
//   constant distance_5 = 8'h1c
//   constant distance_6 = 8'h1c
//   constant distance_7 = 8'h1c
//   constant lost_mask_0 = 28'd1
//   constant lost_mask_1 = 28'd3
//   constant lost_mask_2 = 28'hf
//   constant lost_mask_3 = 28'hff
//   constant lost_mask_4 = 28'hffff
//   constant lost_mask_5 = 28'hfffffff
//   constant lost_mask_6 = 28'hfffffff
//   constant lost_mask_7 = 28'hfffffff
//
// Right shift that remembers whether it lost anything.
module ray_box_sticky_shift (
    input  wire [27:0] value_i,
    input  wire [7:0]  amount_i,
    output wire [27:0] result_o
);

    // Logic
    wire [27:0] lost_1 = value_i & 28'd1;
    wire [27:0] value_2 = amount_i[0] ? {1'b0, value_i[27:1]} : value_i;
    wire sticky_2 = amount_i[0] & (|lost_1);
    wire [27:0] lost_2 = value_2 & 28'd3;
    wire [27:0] value_3 = amount_i[1] ? {2'd0, value_2[27:2]} : value_2;
    wire sticky_3 = amount_i[1] ? (sticky_2 | (|lost_2)) : sticky_2;
    wire [27:0] lost_3 = value_3 & 28'hf;
    wire [27:0] value_4 = amount_i[2] ? {4'd0, value_3[27:4]} : value_3;
    wire sticky_4 = amount_i[2] ? (sticky_3 | (|lost_3)) : sticky_3;
    wire [27:0] lost_4 = value_4 & 28'hff;
    wire [27:0] value_5 = amount_i[3] ? {8'd0, value_4[27:8]} : value_4;
    wire sticky_5 = amount_i[3] ? (sticky_4 | (|lost_4)) : sticky_4;
    wire [27:0] lost_5 = value_5 & 28'hffff;
    wire [27:0] value_6 = amount_i[4] ? {16'd0, value_5[27:16]} : value_5;
    wire sticky_6 = amount_i[4] ? (sticky_5 | (|lost_5)) : sticky_5;
    wire [27:0] value_7 = amount_i[5] ? 28'd0 : value_6;
    wire sticky_7 = amount_i[5] ? (sticky_6 | (|value_6)) : sticky_6;
    wire [27:0] lost = amount_i[6] ? 28'd0 : value_7;
    wire sticky_8 = amount_i[6] ? (sticky_7 | (|value_7)) : sticky_7;
    wire [27:0] value_9 = amount_i[7] ? 28'd0 : lost;
    wire sticky = amount_i[7] ? (sticky_8 | (|lost)) : sticky_8;
    wire [27:0] value = sticky ? (value_9 | 28'd1) : value_9;

    // Outputs
    assign result_o = value;
endmodule

// ray_box_leading_zeros_v1: leading_zeros w26_x5
//   constant top_index = 8'h19
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
//
// Counts the zeros above the leading one.
module ray_box_leading_zeros_v1 (
    input  wire [25:0] value_i,
    output wire [4:0]  count_o
);

    // Logic
    wire [25:0] any_3_1 = value_i | {value_i[24:0], 1'b0};
    wire [25:0] any_2_1 = any_3_1 | {any_3_1[23:0], 2'd0};
    wire [25:0] any_1_1 = any_2_1 | {any_2_1[21:0], 4'd0};
    wire [25:0] any_0_1 = any_1_1 | {any_1_1[17:0], 8'd0};
    wire [25:0] any_1_2 = any_0_1[25] ? any_1_1 : {any_1_1[9:0], 16'd0};
    wire [25:0] any_2_2 = any_0_1[25] ? any_2_1 : {any_2_1[9:0], 16'd0};
    wire [25:0] any_3_2 = any_0_1[25] ? any_3_1 : {any_3_1[9:0], 16'd0};
    wire [25:0] any_4_2 = any_0_1[25] ? value_i : {value_i[9:0], 16'd0};
    wire [4:0] count_2 = any_0_1[25] ? 5'd0 : 5'h10;
    wire [25:0] any_2_3 = any_1_2[25] ? any_2_2 : {any_2_2[17:0], 8'd0};
    wire [25:0] any_3_3 = any_1_2[25] ? any_3_2 : {any_3_2[17:0], 8'd0};
    wire [25:0] any_4_3 = any_1_2[25] ? any_4_2 : {any_4_2[17:0], 8'd0};
    wire [4:0] count_3 = any_1_2[25] ? count_2 : (count_2 | 5'd8);
    wire [25:0] any_3_4 = any_2_3[25] ? any_3_3 : {any_3_3[21:0], 4'd0};
    wire [25:0] any_4_4 = any_2_3[25] ? any_4_3 : {any_4_3[21:0], 4'd0};
    wire [4:0] count_4 = any_2_3[25] ? count_3 : (count_3 | 5'd4);
    wire [25:0] any_4_5 = any_3_4[25] ? any_4_4 : {any_4_4[23:0], 2'd0};
    wire [4:0] count_5 = any_3_4[25] ? count_4 : (count_4 | 5'd2);
    wire [4:0] count = any_4_5[25] ? count_5 : (count_5 | 5'd1);

    // Outputs
    assign count_o = count;

    // Bits that nothing reads
    wire unused = &{1'b0, any_0_1[24:0], any_1_2[24:0], any_2_3[24:0], any_3_4[24:0], any_4_5[24:0]};
endmodule

// ray_box_rounder_v1: rounder e8m23
//   constant top_index = 8'h19
//   constant second_index = 8'h18
//   constant fraction_mask = 26'h7fffff
//   constant fraction_bits = 8'h17
//   constant special_exponent = 10'hff
//   constant last_exponent = 10'hfe
//   constant max_finite = 32'h7f7fffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   constant sign_bit = 32'h80000000
//   tied input rounding_i = 3'd0
//
// The one rounder behind every operation.
//
// The exact result is handed over as a window of `S + 2` bits and the OR of all that is below it, `lost_i`. `exponent_i` is the
// exponent of the window's second bit. If the top bit is clear, the result starts at the second bit, unless the exponent is 0,
// which makes it subnormal. Whoever fills the window need know where its leading one is to within one place only.
//
// Field and fraction are packed into one word before the increment, so that a carry out of the fraction runs into the
// exponent: the largest subnormal becomes the smallest normal number, and the largest number becomes infinity, without a
// case of their own. For the same reason, a window may hold the complement of a negative number: what is shifted in below
// is all ones, and the increment that `complement_i` asks for completes the negation.
//
// | code | direction | increments if | beyond the largest number |
// |---|---|---|---|
// | 0 | nearest, ties to even | round & (sticky or last) | infinity |
// | 1 | toward zero | never | largest number |
// | 2 | down | inexact & negative | infinity if negative, else largest number |
// | 3 | up | inexact & positive | infinity if positive, else largest number |
// | 4 | nearest, ties away | round | infinity |
//
// Codes 5 to 7 are reserved and round toward zero.
module ray_box_rounder_v1 (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] window_i,
    input  wire        lost_i,
    input  wire        complement_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    output wire [31:0] result_o
);

    // Logic
    // The significand with its round bit at the bottom, and whether anything is below.
    wire top = window_i[25];
    wire sticky_if = top | ~(|exponent_i);
    wire [25:0] kept = sticky_if ? {1'b0, window_i[25:1]} : window_i;
    wire sticky = sticky_if ? (lost_i | window_i[0]) : lost_i;
    // Packing and increment.
    wire [25:0] fraction_1 = {1'b0, kept[25:1]};
    // Direction.
    wire increment = kept[0] & (sticky | kept[1]);
    wire [9:0] exponent_2 = window_i[24] ? exponent_i : 10'd0;
    wire [9:0] exponent = top ? (exponent_i + 10'd1) : exponent_2;
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field = {exponent[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = (increment | complement_i) ? (encoded + 32'd1) : encoded;
    // Results outside the normal range. An increment that overflows gives infinity by itself.
    wire overflow = (exponent_i >= 10'hff) | (top & (exponent_i == 10'hfe));
    wire [31:0] magnitude_3 = overflow ? 32'h7f800000 : magnitude_2;
    wire [31:0] magnitude = infinity_i ? 32'h7f800000 : magnitude_3;
    wire [31:0] word_2 = sign_i ? (magnitude | 32'h80000000) : magnitude;
    wire [31:0] word = nan_i ? 32'h7fc00000 : word_2;

    // Outputs
    assign result_o = word;

    // Bits that nothing reads
    wire unused = &{1'b0, exponent[9]};
endmodule

// ray_box_fp_add_v1: fp_add e8m23_t1
//   constant top_bit = 26'h2000000
//   constant second_bit = 26'h1000000
//   constant top_index = 8'h1b
//   tied input tag_i = 1'b0
//   tied input subtract_i = 1'b1
//   tied input rounding_i = 3'd0
//
// Floating-point addition and subtraction.
//
// Let `a` have the larger exponent (else swap), `d` the difference of the exponents. Both significands get three bits below
// the last place; the one of `b` is shifted right by `d`, a sticky bit standing for all that falls off, and added or
// subtracted:
//
// ```text
// sum = significand_a * 2^3 +- (significand_b * 2^3 >> d)
// ```
//
// Three bits suffice: if `d >= 2`, a difference loses at most one leading bit, which leaves a round bit
// and the sticky bit; if `d <= 1`, it is exact. The sum is then shifted left until it fills the rounder's window, but never by more
// than the exponent, so that a subnormal result is exact and needs no case of its own.
//
// *The difference is formed inverted*, as `!x + y = -(x - y) - 1`, which spares the adder its incoming carry. If `d = 0`, the
// significand of `b` may be the larger one, which nobody compares. The difference is negative then; its complement goes
// into the rounder's window, and the rounder's increment completes the negation. As such a difference is exact, the
// increment is free.
//
// *The shift is known before the sum.* A sum has its leading one in the upper two places, a difference with `d >= 2` in the two
// places below the top. Where `d <= 1`, the digits `p - q` of the nearly aligned significands tell the place (Schmookler and
// Nowka, "Leading zero anticipation and detection", ARITH 2001). Each digit is -1, 0 or 1. The first that is not 0, `s`, starts a
// run, which digits `-s` continue; each of them cancels the place before it. The leading one is where the run ends or one
// place below. A marker where the exponent would run out bounds the shift.
//
// | cycle | work |
// |---|---|
// | 1 | unpack, order by exponent, align, add or subtract; meanwhile, anticipate the leading one |
// | 2 | normalise, round |
//
// | corner case | result |
// |---|---|
// | NaN operand, or infinities whose difference is taken | canonical NaN |
// | infinity and anything else | that infinity |
// | x + (-x) for finite x | +0, or -0 if rounding down |
// | zeros of equal sign | that zero |
module ray_box_fp_add_v1 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid_1;
    reg nan;
    reg infinity;
    reg sign;
    reg minus_1;
    reg [7:0] exponent;
    reg [4:0] left;
    reg [27:0] sum;
    reg valid_2;
    reg [31:0] result;

    // Outputs of instances
    wire b_sign_o;
    wire a_sign_o;
    wire [7:0] a_encoded_exponent_o;
    wire [7:0] b_encoded_exponent_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire [27:0] align_result_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [4:0] zeros_count_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
    wire sign_b = ~b_sign_o;
    wire differ = a_sign_o ^ sign_b;
    wire swap = a_encoded_exponent_o < b_encoded_exponent_o;
    wire [7:0] a_above_b = a_exponent_o - b_exponent_o;
    wire [7:0] b_above_a = b_exponent_o - a_exponent_o;
    wire [7:0] distance = swap ? b_above_a : a_above_b;
    wire high_sign = swap ? sign_b : a_sign_o;
    wire [7:0] high_exponent = swap ? b_exponent_o : a_exponent_o;
    wire [23:0] high_significand = swap ? b_significand_o : a_significand_o;
    wire [23:0] low_significand = swap ? a_significand_o : b_significand_o;
    // Align and add; a difference is inverted.
    wire [27:0] high_2 = {1'b0, high_significand, 3'd0};
    wire [27:0] high = differ ? ~high_2 : high_2;
    wire [27:0] total = high + align_result_o;
    // Anticipate the leading one: align by one place, as if the exponents differed by at most one.
    wire [1:0] near = a_above_b[1:0];
    wire [25:0] p_1 = {2'd0, a_significand_o};
    wire [25:0] q_1 = {2'd0, b_significand_o};
    wire [25:0] p = (near != 2'd3) ? {1'b0, a_significand_o, 1'b0} : p_1;
    wire [25:0] q = (near != 2'd1) ? {1'b0, b_significand_o, 1'b0} : q_1;
    wire [25:0] plus = p & ~q;
    wire [25:0] minus = q & ~p;
    wire [25:0] first_1 = plus | minus;
    wire [25:0] ends_1_part = {1'b0, first_1[25:1]};
    wire [25:0] first = ~ends_1_part;
    wire [25:0] after_plus = {plus[24:0], 1'b0};
    wire [25:0] after_minus = {minus[24:0], 1'b0};
    wire [25:0] ends_1_part_2 = ~after_minus;
    wire [25:0] ends_1_part_3 = ~after_plus;
    wire [25:0] ends_1_part_4 = (plus & ends_1_part_2) | (minus & ends_1_part_3);
    wire [25:0] ends_1_part_5 = (plus & ends_1_part_3) | (minus & ends_1_part_2);
    wire [25:0] ends_1 = (first & ends_1_part_4) | (ends_1_part & ends_1_part_5);
    wire [25:0] ends_2 = (ends_1 | (26'h2000000 >> high_exponent)) | 26'd1;
    wire [25:0] ends_3 = (|distance[7:1]) ? (ends_2 | 26'h1000000) : ends_2;
    wire [25:0] ends = differ ? ends_3 : (ends_3 | 26'h2000000);
    // Cycle 2: normalise as far as the exponent allows.
    wire [27:0] difference = minus_1 ? ~sum : sum;
    wire negative = minus_1 & difference[27];
    wire [27:0] normal_1 = difference << left;
    wire [27:0] normal = negative ? ~normal_1 : normal_1;
    wire [9:0] wide_exponent = {2'd0, exponent};
    // Round.
    wire result_sign_1 = sign ^ negative;
    wire result_sign = ~(minus_1 & ~(|difference)) & result_sign_1;

    // Next state
    always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
            valid_1 <= 1'b0;
            valid_2 <= 1'b0;
        end else if (en_i) begin
            valid_1 <= valid_i;
            valid_2 <= valid_1;
        end
    end
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            minus_1 <= differ;
            exponent <= high_exponent;
            left <= zeros_count_o;
            sum <= total;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
    ray_box_fp_unpack_v1 a (
        .word_i             (a_i),
        .sign_o             (a_sign_o),
        .encoded_exponent_o (a_encoded_exponent_o),
        .exponent_o         (a_exponent_o),
        .significand_o      (a_significand_o),
        .nan_o              (a_nan_o),
        .infinity_o         (a_infinity_o)
    );
    ray_box_fp_unpack_v1 b (
        .word_i             (b_i),
        .sign_o             (b_sign_o),
        .encoded_exponent_o (b_encoded_exponent_o),
        .exponent_o         (b_exponent_o),
        .significand_o      (b_significand_o),
        .nan_o              (b_nan_o),
        .infinity_o         (b_infinity_o)
    );
    // Align and add; a difference is inverted.
    ray_box_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (distance),
        .result_o (align_result_o)
    );
    // The marker, and a one at the bottom, so that the count means something even for zero.
    ray_box_leading_zeros_v1 zeros (
        .value_i (ends),
        .count_o (zeros_count_o)
    );
    // Round.
    ray_box_rounder_v1 rounder (
        .sign_i       (result_sign),
        .exponent_i   (wide_exponent - {5'd0, left}),
        .window_i     (normal[27:2]),
        .lost_i       (normal[0] | normal[1]),
        .complement_i (negative),
        .nan_i        (nan),
        .infinity_i   (infinity),
        .result_o     (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, first_1[0]};
endmodule

// ray_box_fp_add_v2: fp_add e8m23_t1
//   constant top_bit = 26'h2000000
//   constant second_bit = 26'h1000000
//   constant top_index = 8'h1b
//   tied input tag_i = 1'b0
//   tied input subtract_i = 1'b1
//   tied input rounding_i = 3'd0
module ray_box_fp_add_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg nan;
    reg infinity;
    reg sign;
    reg minus_1;
    reg [7:0] exponent;
    reg [4:0] left;
    reg [27:0] sum;
    reg [31:0] result;

    // Outputs of instances
    wire b_sign_o;
    wire a_sign_o;
    wire [7:0] a_encoded_exponent_o;
    wire [7:0] b_encoded_exponent_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire [27:0] align_result_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [4:0] zeros_count_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
    wire sign_b = ~b_sign_o;
    wire differ = a_sign_o ^ sign_b;
    wire swap = a_encoded_exponent_o < b_encoded_exponent_o;
    wire [7:0] a_above_b = a_exponent_o - b_exponent_o;
    wire [7:0] b_above_a = b_exponent_o - a_exponent_o;
    wire [7:0] distance = swap ? b_above_a : a_above_b;
    wire high_sign = swap ? sign_b : a_sign_o;
    wire [7:0] high_exponent = swap ? b_exponent_o : a_exponent_o;
    wire [23:0] high_significand = swap ? b_significand_o : a_significand_o;
    wire [23:0] low_significand = swap ? a_significand_o : b_significand_o;
    // Align and add; a difference is inverted.
    wire [27:0] high_2 = {1'b0, high_significand, 3'd0};
    wire [27:0] high = differ ? ~high_2 : high_2;
    wire [27:0] total = high + align_result_o;
    // Anticipate the leading one: align by one place, as if the exponents differed by at most one.
    wire [1:0] near = a_above_b[1:0];
    wire [25:0] p_1 = {2'd0, a_significand_o};
    wire [25:0] q_1 = {2'd0, b_significand_o};
    wire [25:0] p = (near != 2'd3) ? {1'b0, a_significand_o, 1'b0} : p_1;
    wire [25:0] q = (near != 2'd1) ? {1'b0, b_significand_o, 1'b0} : q_1;
    wire [25:0] plus = p & ~q;
    wire [25:0] minus = q & ~p;
    wire [25:0] first_1 = plus | minus;
    wire [25:0] ends_1_part = {1'b0, first_1[25:1]};
    wire [25:0] first = ~ends_1_part;
    wire [25:0] after_plus = {plus[24:0], 1'b0};
    wire [25:0] after_minus = {minus[24:0], 1'b0};
    wire [25:0] ends_1_part_2 = ~after_minus;
    wire [25:0] ends_1_part_3 = ~after_plus;
    wire [25:0] ends_1_part_4 = (plus & ends_1_part_2) | (minus & ends_1_part_3);
    wire [25:0] ends_1_part_5 = (plus & ends_1_part_3) | (minus & ends_1_part_2);
    wire [25:0] ends_1 = (first & ends_1_part_4) | (ends_1_part & ends_1_part_5);
    wire [25:0] ends_2 = (ends_1 | (26'h2000000 >> high_exponent)) | 26'd1;
    wire [25:0] ends_3 = (|distance[7:1]) ? (ends_2 | 26'h1000000) : ends_2;
    wire [25:0] ends = differ ? ends_3 : (ends_3 | 26'h2000000);
    // Cycle 2: normalise as far as the exponent allows.
    wire [27:0] difference = minus_1 ? ~sum : sum;
    wire negative = minus_1 & difference[27];
    wire [27:0] normal_1 = difference << left;
    wire [27:0] normal = negative ? ~normal_1 : normal_1;
    wire [9:0] wide_exponent = {2'd0, exponent};
    // Round.
    wire result_sign_1 = sign ^ negative;
    wire result_sign = ~(minus_1 & ~(|difference)) & result_sign_1;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            minus_1 <= differ;
            exponent <= high_exponent;
            left <= zeros_count_o;
            sum <= total;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
    ray_box_fp_unpack_v1 a (
        .word_i             (a_i),
        .sign_o             (a_sign_o),
        .encoded_exponent_o (a_encoded_exponent_o),
        .exponent_o         (a_exponent_o),
        .significand_o      (a_significand_o),
        .nan_o              (a_nan_o),
        .infinity_o         (a_infinity_o)
    );
    ray_box_fp_unpack_v1 b (
        .word_i             (b_i),
        .sign_o             (b_sign_o),
        .encoded_exponent_o (b_encoded_exponent_o),
        .exponent_o         (b_exponent_o),
        .significand_o      (b_significand_o),
        .nan_o              (b_nan_o),
        .infinity_o         (b_infinity_o)
    );
    // Align and add; a difference is inverted.
    ray_box_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (distance),
        .result_o (align_result_o)
    );
    // The marker, and a one at the bottom, so that the count means something even for zero.
    ray_box_leading_zeros_v1 zeros (
        .value_i (ends),
        .count_o (zeros_count_o)
    );
    // Round.
    ray_box_rounder_v1 rounder (
        .sign_i       (result_sign),
        .exponent_i   (wide_exponent - {5'd0, left}),
        .window_i     (normal[27:2]),
        .lost_i       (normal[0] | normal[1]),
        .complement_i (negative),
        .nan_i        (nan),
        .infinity_i   (infinity),
        .result_o     (rounder_result_o)
    );

    // Outputs
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, first_1[0]};
endmodule

// ray_box_fp_unpack_v2: fp_unpack e8m23
//   constant sign_index = 8'h1f
//   constant fraction_bits = 8'h17
//   constant fraction_mask = 24'h7fffff
//   constant hidden_bit = 24'h800000
//   constant special_exponent = 8'hff
module ray_box_fp_unpack_v2 (
    input  wire [31:0] word_i,
    output wire        sign_o,
    output wire [7:0]  exponent_o,
    output wire [23:0] significand_o,
    output wire        nan_o,
    output wire        infinity_o
);

    // Logic
    wire [7:0] encoded_exponent = word_i[30:23];
    wire [23:0] fraction = word_i[23:0] & 24'h7fffff;
    wire special = encoded_exponent == 8'hff;
    wire [23:0] significand_1 = fraction | 24'h800000;
    wire significand_if = |encoded_exponent;
    wire [7:0] exponent = significand_if ? encoded_exponent : 8'd1;
    wire [23:0] significand = significand_if ? significand_1 : fraction;
    wire infinity_o_part = |fraction;

    // Outputs
    assign sign_o = word_i[31];
    assign exponent_o = exponent;
    assign significand_o = significand;
    assign nan_o = special & infinity_o_part;
    assign infinity_o = special & ~infinity_o_part;
endmodule

// ray_box_significand_product_v1: significand_product w24_lower
//
// The multiplier arrays: the product of a significand with one half of another.
//
// With `b = b_upper * 2^H + b_lower` and `H` half the bits, rounded up, `a * b = a b_upper * 2^H + a b_lower`. Either array has half
// the rows of a whole one, which is what fits in a cycle; whoever uses the two adds their products in the next.
//
// A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier. `rust-hdl`
// multiplies 16 by 16 bits only, so that this module has its kernel written twice: for simulation, and as the syntax tree
// that other kernels get from the macro.
module ray_box_significand_product_v1 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[11:0]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[23:12]};
endmodule

// ray_box_significand_product_v2: significand_product w24_upper
module ray_box_significand_product_v2 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[23:12]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[11:0]};
endmodule

// ray_box_leading_zeros_v2: leading_zeros w24_x5
//   constant top_index = 8'h17
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
module ray_box_leading_zeros_v2 (
    input  wire [23:0] value_i,
    output wire [4:0]  count_o
);

    // Logic
    wire [23:0] any_3_1 = value_i | {value_i[22:0], 1'b0};
    wire [23:0] any_2_1 = any_3_1 | {any_3_1[21:0], 2'd0};
    wire [23:0] any_1_1 = any_2_1 | {any_2_1[19:0], 4'd0};
    wire [23:0] any_0_1 = any_1_1 | {any_1_1[15:0], 8'd0};
    wire [23:0] any_1_2 = any_0_1[23] ? any_1_1 : {any_1_1[7:0], 16'd0};
    wire [23:0] any_2_2 = any_0_1[23] ? any_2_1 : {any_2_1[7:0], 16'd0};
    wire [23:0] any_3_2 = any_0_1[23] ? any_3_1 : {any_3_1[7:0], 16'd0};
    wire [23:0] any_4_2 = any_0_1[23] ? value_i : {value_i[7:0], 16'd0};
    wire [4:0] count_2 = any_0_1[23] ? 5'd0 : 5'h10;
    wire [23:0] any_2_3 = any_1_2[23] ? any_2_2 : {any_2_2[15:0], 8'd0};
    wire [23:0] any_3_3 = any_1_2[23] ? any_3_2 : {any_3_2[15:0], 8'd0};
    wire [23:0] any_4_3 = any_1_2[23] ? any_4_2 : {any_4_2[15:0], 8'd0};
    wire [4:0] count_3 = any_1_2[23] ? count_2 : (count_2 | 5'd8);
    wire [23:0] any_3_4 = any_2_3[23] ? any_3_3 : {any_3_3[19:0], 4'd0};
    wire [23:0] any_4_4 = any_2_3[23] ? any_4_3 : {any_4_3[19:0], 4'd0};
    wire [4:0] count_4 = any_2_3[23] ? count_3 : (count_3 | 5'd4);
    wire [23:0] any_4_5 = any_3_4[23] ? any_4_4 : {any_4_4[21:0], 2'd0};
    wire [4:0] count_5 = any_3_4[23] ? count_4 : (count_4 | 5'd2);
    wire [4:0] count = any_4_5[23] ? count_5 : (count_5 | 5'd1);

    // Outputs
    assign count_o = count;

    // Bits that nothing reads
    wire unused = &{1'b0, any_0_1[22:0], any_1_2[22:0], any_2_3[22:0], any_3_4[22:0], any_4_5[22:0]};
endmodule

// ray_box_rounder_v2: rounder e8m23
//   constant top_index = 8'h19
//   constant second_index = 8'h18
//   constant fraction_mask = 26'h7fffff
//   constant fraction_bits = 8'h17
//   constant special_exponent = 10'hff
//   constant last_exponent = 10'hfe
//   constant max_finite = 32'h7f7fffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   constant sign_bit = 32'h80000000
//   tied input complement_i = 1'b0
//   tied input rounding_i = 3'd0
module ray_box_rounder_v2 (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] window_i,
    input  wire        lost_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    output wire [31:0] result_o
);

    // Logic
    // The significand with its round bit at the bottom, and whether anything is below.
    wire top = window_i[25];
    wire sticky_if = top | ~(|exponent_i);
    wire [25:0] kept = sticky_if ? {1'b0, window_i[25:1]} : window_i;
    wire sticky = sticky_if ? (lost_i | window_i[0]) : lost_i;
    // Packing and increment.
    wire [25:0] fraction_1 = {1'b0, kept[25:1]};
    // Direction.
    wire increment = kept[0] & (sticky | kept[1]);
    wire [9:0] exponent_2 = window_i[24] ? exponent_i : 10'd0;
    wire [9:0] exponent = top ? (exponent_i + 10'd1) : exponent_2;
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field = {exponent[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = increment ? (encoded + 32'd1) : encoded;
    // Results outside the normal range. An increment that overflows gives infinity by itself.
    wire overflow = (exponent_i >= 10'hff) | (top & (exponent_i == 10'hfe));
    wire [31:0] magnitude_3 = overflow ? 32'h7f800000 : magnitude_2;
    wire [31:0] magnitude = infinity_i ? 32'h7f800000 : magnitude_3;
    wire [31:0] word_2 = sign_i ? (magnitude | 32'h80000000) : magnitude;
    wire [31:0] word = nan_i ? 32'h7fc00000 : word_2;

    // Outputs
    assign result_o = word;

    // Bits that nothing reads
    wire unused = &{1'b0, exponent[9]};
endmodule

// ray_box_fp_mul_v1: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant hidden_index = 8'h17
//   constant half = 8'hc
//   constant above_half = 8'h24
//   constant window_reach = 10'h16
//   constant ones = 48'hffffffffffff
//   constant window_offset = 8'h16
//   tied input tag_i = 1'b0
//   tied input rounding_i = 3'd0
//
// Floating-point multiplication.
//
// The product of two `S`-bit significands has `P = 2 S` bits and is exact. If its top bit is to be the result's
// leading bit, the biased exponent is
//
// ```text
// e = exponent_a + exponent_b - bias + 1
// ```
//
// A product of normal numbers has its leading one in one of the top two bits; each leading zero of a subnormal operand
// moves it down by one more. While the arrays multiply, the zeros `z` of the subnormal operand are counted and the shift is
// fixed: left by `min(z, e - 1)`, or right by `1 - e` if `e < 1`, where the result is subnormal. Two subnormal operands always have
// such a result. That puts the leading one in the top two bits of the rounder's window.
//
// The two shifters work beside each other, as only one of them ever shifts. What is below the window is seen by a mask
// on the product, which does not wait for them.
//
// | cycle | work |
// |---|---|
// | 1 | unpack, multiply with either half of `b`; count zeros, exponent and shift amounts |
// | 2 | add the two products, shift, round |
//
// | corner case | result |
// |---|---|
// | NaN operand, or 0 * infinity | canonical NaN |
// | infinity and a number that is not zero | infinity of the product's sign |
// | zero and a number | zero of the product's sign |
module ray_box_fp_mul_v1 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid_1;
    reg nan;
    reg infinity;
    reg sign;
    reg [9:0] exponent;
    reg right_shift;
    reg [4:0] left;
    reg [7:0] right;
    reg [9:0] below;
    reg [47:0] sum;
    reg [23:0] carry;
    reg valid_2;
    reg [31:0] result;

    // Outputs of instances
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire [47:0] array_upper_product_o;
    wire [47:0] array_lower_product_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [4:0] leading_count_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_sign_o;
    wire b_sign_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
    wire zero_factor = ~(|a_significand_o) | ~(|b_significand_o);
    wire infinite_factor = a_infinity_o | b_infinity_o;
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    wire [23:0] subnormal = a_significand_o[23] ? b_significand_o : a_significand_o;
    wire [9:0] zeros = {5'd0, leading_count_o};
    wire [9:0] wide_a = {2'd0, a_exponent_o};
    wire [9:0] wide_b = {2'd0, b_exponent_o};
    wire [9:0] exponent_sum = wide_a + wide_b;
    wire [9:0] top_exponent = exponent_sum - 10'h7e;
    wire tiny = top_exponent[9] | ~(|top_exponent);
    wire [9:0] room = top_exponent - 10'd1;
    wire [9:0] shortfall = 10'd1 - top_exponent;
    wire [9:0] start_exponent_1 = room - zeros;
    wire start_exponent_2_if = room < zeros;
    wire [9:0] left_amount = start_exponent_2_if ? room : zeros;
    wire [9:0] start_exponent_2 = start_exponent_2_if ? 10'd0 : start_exponent_1;
    // Nothing is below a window that a shift to the left takes to the product's end.
    wire [9:0] below_window_1 = 10'h16 - left_amount;
    wire [9:0] below_window_2 = below_window_1[9] ? 10'd0 : below_window_1;
    wire [9:0] start_exponent = tiny ? 10'd0 : start_exponent_2;
    wire [9:0] below_window = tiny ? (10'h16 + shortfall) : below_window_2;
    // Cycle 2: add, and shift either way.
    wire [47:0] product_2 = {12'd0, carry, 12'd0};
    wire [47:0] product = sum + product_2;
    wire [47:0] normal = product << left;
    wire [47:0] window_1 = {22'd0, normal[47:22]};
    wire [47:0] window = right_shift ? ({22'd0, product[47:22]} >> right) : window_1;
    wire [47:0] lost = product & ~(48'hffffffffffff << below);

    // Next state
    always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
            valid_1 <= 1'b0;
            valid_2 <= 1'b0;
        end else if (en_i) begin
            valid_1 <= valid_i;
            valid_2 <= valid_1;
        end
    end
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | (infinite_factor & zero_factor);
            infinity <= infinite_factor;
            sign <= a_sign_o ^ b_sign_o;
            exponent <= start_exponent;
            right_shift <= tiny;
            left <= left_amount[4:0];
            right <= shortfall[7:0];
            below <= below_window;
            sum <= {array_upper_product_o[35:0], array_lower_product_o[11:0]};
            carry <= array_lower_product_o[35:12];
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
    ray_box_fp_unpack_v2 a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    ray_box_fp_unpack_v2 b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    ray_box_significand_product_v1 array_lower (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_lower_product_o)
    );
    ray_box_significand_product_v2 array_upper (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_upper_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    ray_box_leading_zeros_v2 leading (
        .value_i (subnormal),
        .count_o (leading_count_o)
    );
    // Round.
    ray_box_rounder_v2 rounder (
        .sign_i     (sign),
        .exponent_i (exponent),
        .window_i   (window[25:0]),
        .lost_i     (|lost),
        .nan_i      (nan),
        .infinity_i (infinity),
        .result_o   (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, array_lower_product_o[47:36], array_upper_product_o[47:36], normal[21:0], window[47:26]};
endmodule

// ray_box_fp_mul_v2: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant hidden_index = 8'h17
//   constant half = 8'hc
//   constant above_half = 8'h24
//   constant window_reach = 10'h16
//   constant ones = 48'hffffffffffff
//   constant window_offset = 8'h16
//   tied input tag_i = 1'b0
//   tied input rounding_i = 3'd0
module ray_box_fp_mul_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg nan;
    reg infinity;
    reg sign;
    reg [9:0] exponent;
    reg right_shift;
    reg [4:0] left;
    reg [7:0] right;
    reg [9:0] below;
    reg [47:0] sum;
    reg [23:0] carry;
    reg [31:0] result;

    // Outputs of instances
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire [47:0] array_upper_product_o;
    wire [47:0] array_lower_product_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [4:0] leading_count_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_sign_o;
    wire b_sign_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
    wire zero_factor = ~(|a_significand_o) | ~(|b_significand_o);
    wire infinite_factor = a_infinity_o | b_infinity_o;
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    wire [23:0] subnormal = a_significand_o[23] ? b_significand_o : a_significand_o;
    wire [9:0] zeros = {5'd0, leading_count_o};
    wire [9:0] wide_a = {2'd0, a_exponent_o};
    wire [9:0] wide_b = {2'd0, b_exponent_o};
    wire [9:0] exponent_sum = wide_a + wide_b;
    wire [9:0] top_exponent = exponent_sum - 10'h7e;
    wire tiny = top_exponent[9] | ~(|top_exponent);
    wire [9:0] room = top_exponent - 10'd1;
    wire [9:0] shortfall = 10'd1 - top_exponent;
    wire [9:0] start_exponent_1 = room - zeros;
    wire start_exponent_2_if = room < zeros;
    wire [9:0] left_amount = start_exponent_2_if ? room : zeros;
    wire [9:0] start_exponent_2 = start_exponent_2_if ? 10'd0 : start_exponent_1;
    // Nothing is below a window that a shift to the left takes to the product's end.
    wire [9:0] below_window_1 = 10'h16 - left_amount;
    wire [9:0] below_window_2 = below_window_1[9] ? 10'd0 : below_window_1;
    wire [9:0] start_exponent = tiny ? 10'd0 : start_exponent_2;
    wire [9:0] below_window = tiny ? (10'h16 + shortfall) : below_window_2;
    // Cycle 2: add, and shift either way.
    wire [47:0] product_2 = {12'd0, carry, 12'd0};
    wire [47:0] product = sum + product_2;
    wire [47:0] normal = product << left;
    wire [47:0] window_1 = {22'd0, normal[47:22]};
    wire [47:0] window = right_shift ? ({22'd0, product[47:22]} >> right) : window_1;
    wire [47:0] lost = product & ~(48'hffffffffffff << below);

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | (infinite_factor & zero_factor);
            infinity <= infinite_factor;
            sign <= a_sign_o ^ b_sign_o;
            exponent <= start_exponent;
            right_shift <= tiny;
            left <= left_amount[4:0];
            right <= shortfall[7:0];
            below <= below_window;
            sum <= {array_upper_product_o[35:0], array_lower_product_o[11:0]};
            carry <= array_lower_product_o[35:12];
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
    ray_box_fp_unpack_v2 a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    ray_box_fp_unpack_v2 b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    ray_box_significand_product_v1 array_lower (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_lower_product_o)
    );
    ray_box_significand_product_v2 array_upper (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_upper_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    ray_box_leading_zeros_v2 leading (
        .value_i (subnormal),
        .count_o (leading_count_o)
    );
    // Round.
    ray_box_rounder_v2 rounder (
        .sign_i     (sign),
        .exponent_i (exponent),
        .window_i   (window[25:0]),
        .lost_i     (|lost),
        .nan_i      (nan),
        .infinity_i (infinity),
        .result_o   (rounder_result_o)
    );

    // Outputs
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, array_lower_product_o[47:36], array_upper_product_o[47:36], normal[21:0], window[47:26]};
endmodule

// ray_box_fp_min_max_v1: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b1
//
// Floating-point minimum and maximum, with both treatments of NaN that IEEE 754-2019 (section 9.6) defines.
//
// Numbers are ordered by their words: with `u` the unsigned comparison `a < b` of the words, `a` orders before `b` if
// `u` xor `(sign_a | sign_b)` (see `FpCmp`), and -0 thereby orders before +0. Where the words are equal, it
// does not matter which operand is chosen.
//
// | a | b | `propagate_nan_i` = 0 | `propagate_nan_i` = 1 |
// |---|---|---|---|
// | number | number | the lesser (greater) | the lesser (greater) |
// | number | NaN | a | NaN |
// | NaN | number | b | NaN |
// | NaN | NaN | NaN | NaN |
//
// Every NaN result is canonical.
module ray_box_fp_min_max_v1 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid;
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (nan_a | nan_b);
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a = nan_b | ((magnitude_a <= 32'h7f800000) & (below ^ any_negative));
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
            valid <= 1'b0;
        end else if (en_i) begin
            valid <= valid_i;
        end
    end
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign result_o = result;
endmodule

// ray_box_fp_min_max_v2: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b1
module ray_box_fp_min_max_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (nan_a | nan_b);
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a = nan_b | ((magnitude_a <= 32'h7f800000) & (below ^ any_negative));
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign result_o = result;
endmodule

// ray_box_fp_min_max_v3: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b1
module ray_box_fp_min_max_v3 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (nan_a | nan_b);
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a_part = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | choose_a_part;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign result_o = result;
endmodule

// ray_box_fp_min_max_v4: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b0
module ray_box_fp_min_max_v4 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid;
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a_part = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | choose_a_part;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
            valid <= 1'b0;
        end else if (en_i) begin
            valid <= valid_i;
        end
    end
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign result_o = result;
endmodule

// ray_box_fp_min_max_v5: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b0
module ray_box_fp_min_max_v5 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a_part = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | choose_a_part;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign result_o = result;
endmodule

// ray_box_fp_min_max_v6: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b0
module ray_box_fp_min_max_v6 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire choose_a = nan_b | ((magnitude_a <= 32'h7f800000) & (below ^ any_negative));
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            result <= chosen;
        end
    end

    // Outputs
    assign result_o = result;
endmodule

// ray_box_fp_cmp_v1: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
//
// Floating-point comparison.
//
// Sign-magnitude words compare like unsigned integers, except that a negative operand reverses the outcome. Let `u`
// be `a < b` on the words as unsigned integers. If both signs are clear, `a < b` is `u`; if both are set, it is the
// reverse, `!u` (for `a != b`); if only `a` is negative, its word is the larger one, so that `u = 0` and again `!u` is
// right; if only `b` is negative, `u = 1`, and `!u` is right. Hence `a < b` is `u` xor `(sign_a | sign_b)` wherever the
// operands differ.
module ray_box_fp_cmp_v1 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire        le_o
);

    // Registers
    reg valid;
    reg le;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire [31:0] any_magnitude = magnitude_a | magnitude_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire ordered = (magnitude_a <= 32'h7f800000) & (magnitude_b <= 32'h7f800000);
    wire below = a_i < b_i;
    wire equal = (a_i == b_i) | ~(|any_magnitude);
    wire less = (below ^ any_negative) & ~equal;

    // Next state
    always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
            valid <= 1'b0;
        end else if (en_i) begin
            valid <= valid_i;
        end
    end
    always @(posedge clk_i) begin
        if (en_i) begin
            le <= ordered & (less | equal);
        end
    end

    // Outputs
    assign valid_o = valid;
    assign le_o = le;
endmodule

// ray_box_fp_cmp_v2: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module ray_box_fp_cmp_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        lt_o
);

    // Registers
    reg lt;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire [31:0] any_magnitude = magnitude_a | magnitude_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire ordered = (magnitude_a <= 32'h7f800000) & (magnitude_b <= 32'h7f800000);
    wire below = a_i < b_i;
    wire equal = (a_i == b_i) | ~(|any_magnitude);
    wire less = (below ^ any_negative) & ~equal;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            lt <= ordered & less;
        end
    end

    // Outputs
    assign lt_o = lt;
endmodule

// ray_box_fold: ray_box_fold e8m23_c2
//
// Last four stages of the ray-box pipeline: intersects the three slabs with the ray's interval.
//
// | cycle | work | units |
// |---|---|---|
// | 5 | per axis `near = minimum(t_lo, t_hi)`, `far = maximum(t_lo, t_hi)`; a NaN propagates | 6 FPMIN/MAX |
// | 6 | `max(near_x, near_y)`, `max(near_z, t_min)`, `min(far_x, far_y)`, `min(far_z, t_max)`; a NaN is dropped | 4 FPMIN/MAX |
// | 7 | `entry`, `exit`: maximum and minimum of those | 2 FPMIN/MAX |
// | 8 | `hit = entry <= exit`, and not `exit < t_min` | 2 FPCMP |
//
// A ray parallel to an axis that lies in one of its slab's planes has a NaN distance there; the whole axis then
// constrains nothing. The second comparison is in the published inventory, where it is read as the test for a box
// behind the ray's start. As `entry` is at least `t_min` unless that is NaN, it never changes the outcome, and `C = 1`
// leaves it out with equal results.
module ray_box_fold (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] t_0_i,
    input  wire [31:0] t_1_i,
    input  wire [31:0] t_2_i,
    input  wire [31:0] t_3_i,
    input  wire [31:0] t_4_i,
    input  wire [31:0] t_5_i,
    input  wire [31:0] t_min_i,
    input  wire [31:0] t_max_i,
    output wire        valid_o,
    output wire        hit_o,
    output wire [31:0] t_entry_o
);

    // Registers
    reg [31:0] t_entry;

    // Outputs of instances
    wire axis_near_0_valid_o;
    wire [31:0] axis_near_0_result_o;
    wire [31:0] axis_near_1_result_o;
    wire [31:0] axis_near_2_result_o;
    wire [31:0] axis_far_0_result_o;
    wire [31:0] axis_far_1_result_o;
    wire [31:0] axis_far_2_result_o;
    wire entry_half_0_valid_o;
    wire [31:0] entry_half_0_result_o;
    wire [31:0] entry_half_1_result_o;
    wire [31:0] exit_half_0_result_o;
    wire [31:0] exit_half_1_result_o;
    wire entry_valid_o;
    wire [31:0] entry_result_o;
    wire [31:0] leave_result_o;
    wire accept_0_le_o;
    wire [31:0] t_min_wait_q_o;
    wire accept_1_lt_o;
    wire accept_0_valid_o;

    // Logic
    // Cycle 8: compare.
    wire hit = accept_0_le_o & ~accept_1_lt_o;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            t_entry <= entry_result_o;
        end
    end

    // Instances
    // Cycle 5: slabs.
    ray_box_fp_min_max_v1 axis_near_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (valid_i),
        .a_i      (t_0_i),
        .b_i      (t_3_i),
        .valid_o  (axis_near_0_valid_o),
        .result_o (axis_near_0_result_o)
    );
    ray_box_fp_min_max_v2 axis_near_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_1_i),
        .b_i      (t_4_i),
        .result_o (axis_near_1_result_o)
    );
    ray_box_fp_min_max_v2 axis_near_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_2_i),
        .b_i      (t_5_i),
        .result_o (axis_near_2_result_o)
    );
    ray_box_fp_min_max_v3 axis_far_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_0_i),
        .b_i      (t_3_i),
        .result_o (axis_far_0_result_o)
    );
    ray_box_fp_min_max_v3 axis_far_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_1_i),
        .b_i      (t_4_i),
        .result_o (axis_far_1_result_o)
    );
    ray_box_fp_min_max_v3 axis_far_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_2_i),
        .b_i      (t_5_i),
        .result_o (axis_far_2_result_o)
    );
    // Cycles 6 and 7: fold.
    ray_box_fp_min_max_v4 entry_half_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (axis_near_0_valid_o),
        .a_i      (axis_near_0_result_o),
        .b_i      (axis_near_1_result_o),
        .valid_o  (entry_half_0_valid_o),
        .result_o (entry_half_0_result_o)
    );
    ray_box_fp_min_max_v5 entry_half_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_near_2_result_o),
        .b_i      (t_min_i),
        .result_o (entry_half_1_result_o)
    );
    ray_box_fp_min_max_v6 exit_half_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_far_0_result_o),
        .b_i      (axis_far_1_result_o),
        .result_o (exit_half_0_result_o)
    );
    ray_box_fp_min_max_v6 exit_half_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_far_2_result_o),
        .b_i      (t_max_i),
        .result_o (exit_half_1_result_o)
    );
    ray_box_fp_min_max_v4 entry (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (entry_half_0_valid_o),
        .a_i      (entry_half_0_result_o),
        .b_i      (entry_half_1_result_o),
        .valid_o  (entry_valid_o),
        .result_o (entry_result_o)
    );
    ray_box_fp_min_max_v6 leave (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (exit_half_0_result_o),
        .b_i      (exit_half_1_result_o),
        .result_o (leave_result_o)
    );
    ray_box_delay_v1 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    // Cycle 8: compare.
    ray_box_fp_cmp_v1 accept_0 (
        .clk_i   (clk_i),
        .rst_ni  (rst_ni),
        .en_i    (en_i),
        .valid_i (entry_valid_o),
        .a_i     (entry_result_o),
        .b_i     (leave_result_o),
        .valid_o (accept_0_valid_o),
        .le_o    (accept_0_le_o)
    );
    ray_box_fp_cmp_v2 accept_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (leave_result_o),
        .b_i   (t_min_wait_q_o),
        .lt_o  (accept_1_lt_o)
    );

    // Outputs
    assign valid_o = accept_0_valid_o;
    assign hit_o = hit;
    assign t_entry_o = t_entry;
endmodule

// ray_box_delay_v3: delay w1_n8
module ray_box_delay_v3 (
    input  wire clk_i,
    input  wire en_i,
    input  wire d_i,
    output wire q_o
);

    // Registers
    reg stage_0;
    reg stage_1;
    reg stage_2;
    reg stage_3;
    reg stage_4;
    reg stage_5;
    reg stage_6;
    reg stage_7;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
            stage_2 <= stage_1;
            stage_3 <= stage_2;
            stage_4 <= stage_3;
            stage_5 <= stage_4;
            stage_6 <= stage_5;
            stage_7 <= stage_6;
        end
    end

    // Outputs
    assign q_o = stage_7;
endmodule

// ray_box: ray_box e8m23_c2_t1
//
// The ray-box pipeline: one slab test per cycle.
//
// Each of a box's six planes is met at `t = (plane - origin[axis]) * inv[axis]`, with the reciprocal of its role (exit or
// entry), every operation rounded to nearest even and none fused. The slabs are then intersected with the ray's
// interval; the box is hit if the rest is not empty, bounds included.
//
// | cycle | work | units |
// |---|---|---|
// | 1, 2 | `plane - origin` | 6 FPADD |
// | 3, 4 | `* inv` | 6 FPMUL |
// | 5, 6, 7 | fold (see `RayBoxFold`) | 12 FPMIN/MAX |
// | 8 | compare | 2 FPCMP |
//
// `C = 2` is the inventory of the ray-box unit that Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split
// Trees", HPG 2020, compare with; `C = 1` leaves out the redundant comparison.
module ray_box (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] box_min_x_i,
    input  wire [31:0] box_min_y_i,
    input  wire [31:0] box_min_z_i,
    input  wire [31:0] box_max_x_i,
    input  wire [31:0] box_max_y_i,
    input  wire [31:0] box_max_z_i,
    input  wire [31:0] origin_x_i,
    input  wire [31:0] origin_y_i,
    input  wire [31:0] origin_z_i,
    input  wire [31:0] inv_entry_x_i,
    input  wire [31:0] inv_entry_y_i,
    input  wire [31:0] inv_entry_z_i,
    input  wire [31:0] inv_exit_x_i,
    input  wire [31:0] inv_exit_y_i,
    input  wire [31:0] inv_exit_z_i,
    input  wire [31:0] t_min_i,
    input  wire [31:0] t_max_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire        hit_o,
    output wire [31:0] t_entry_o
);

    // Outputs of instances
    wire subtract_0_valid_o;
    wire [31:0] subtract_0_result_o;
    wire [31:0] select_inv_0_o;
    wire [31:0] multiply_0_result_o;
    wire [31:0] subtract_1_result_o;
    wire [31:0] select_inv_1_o;
    wire [31:0] multiply_1_result_o;
    wire [31:0] subtract_2_result_o;
    wire [31:0] select_inv_2_o;
    wire [31:0] multiply_2_result_o;
    wire [31:0] subtract_3_result_o;
    wire [31:0] select_inv_3_o;
    wire [31:0] multiply_3_result_o;
    wire [31:0] subtract_4_result_o;
    wire [31:0] select_inv_4_o;
    wire [31:0] multiply_4_result_o;
    wire [31:0] subtract_5_result_o;
    wire [31:0] select_inv_5_o;
    wire [31:0] multiply_5_result_o;
    wire multiply_0_valid_o;
    wire [31:0] select_t_min_o;
    wire [31:0] select_t_max_o;
    wire fold_valid_o;
    wire tag_q_o;
    wire fold_hit_o;
    wire [31:0] fold_t_entry_o;

    // Instances
    ray_box_select select (
        .clk_i         (clk_i),
        .en_i          (en_i),
        .inv_entry_x_i (inv_entry_x_i),
        .inv_entry_y_i (inv_entry_y_i),
        .inv_entry_z_i (inv_entry_z_i),
        .inv_exit_x_i  (inv_exit_x_i),
        .inv_exit_y_i  (inv_exit_y_i),
        .inv_exit_z_i  (inv_exit_z_i),
        .t_min_i       (t_min_i),
        .t_max_i       (t_max_i),
        .inv_0_o       (select_inv_0_o),
        .inv_1_o       (select_inv_1_o),
        .inv_2_o       (select_inv_2_o),
        .inv_3_o       (select_inv_3_o),
        .inv_4_o       (select_inv_4_o),
        .inv_5_o       (select_inv_5_o),
        .t_min_o       (select_t_min_o),
        .t_max_o       (select_t_max_o)
    );
    // Cycles 1 to 4: distances.
    ray_box_fp_add_v1 subtract_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (valid_i),
        .a_i      (box_min_x_i),
        .b_i      (origin_x_i),
        .valid_o  (subtract_0_valid_o),
        .result_o (subtract_0_result_o)
    );
    ray_box_fp_add_v2 subtract_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (box_min_y_i),
        .b_i      (origin_y_i),
        .result_o (subtract_1_result_o)
    );
    ray_box_fp_add_v2 subtract_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (box_min_z_i),
        .b_i      (origin_z_i),
        .result_o (subtract_2_result_o)
    );
    ray_box_fp_add_v2 subtract_3 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (box_max_x_i),
        .b_i      (origin_x_i),
        .result_o (subtract_3_result_o)
    );
    ray_box_fp_add_v2 subtract_4 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (box_max_y_i),
        .b_i      (origin_y_i),
        .result_o (subtract_4_result_o)
    );
    ray_box_fp_add_v2 subtract_5 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (box_max_z_i),
        .b_i      (origin_z_i),
        .result_o (subtract_5_result_o)
    );
    ray_box_fp_mul_v1 multiply_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (subtract_0_valid_o),
        .a_i      (subtract_0_result_o),
        .b_i      (select_inv_0_o),
        .valid_o  (multiply_0_valid_o),
        .result_o (multiply_0_result_o)
    );
    ray_box_fp_mul_v2 multiply_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_1_result_o),
        .b_i      (select_inv_1_o),
        .result_o (multiply_1_result_o)
    );
    ray_box_fp_mul_v2 multiply_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_2_result_o),
        .b_i      (select_inv_2_o),
        .result_o (multiply_2_result_o)
    );
    ray_box_fp_mul_v2 multiply_3 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_3_result_o),
        .b_i      (select_inv_3_o),
        .result_o (multiply_3_result_o)
    );
    ray_box_fp_mul_v2 multiply_4 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_4_result_o),
        .b_i      (select_inv_4_o),
        .result_o (multiply_4_result_o)
    );
    ray_box_fp_mul_v2 multiply_5 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_5_result_o),
        .b_i      (select_inv_5_o),
        .result_o (multiply_5_result_o)
    );
    ray_box_fold fold (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .en_i      (en_i),
        .valid_i   (multiply_0_valid_o),
        .t_0_i     (multiply_0_result_o),
        .t_1_i     (multiply_1_result_o),
        .t_2_i     (multiply_2_result_o),
        .t_3_i     (multiply_3_result_o),
        .t_4_i     (multiply_4_result_o),
        .t_5_i     (multiply_5_result_o),
        .t_min_i   (select_t_min_o),
        .t_max_i   (select_t_max_o),
        .valid_o   (fold_valid_o),
        .hit_o     (fold_hit_o),
        .t_entry_o (fold_t_entry_o)
    );
    // Cycles 5 to 8: fold and compare.
    ray_box_delay_v3 tag (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (tag_i),
        .q_o   (tag_q_o)
    );

    // Outputs
    assign valid_o = fold_valid_o;
    assign tag_o = tag_q_o;
    assign hit_o = fold_hit_o;
    assign t_entry_o = fold_t_entry_o;
endmodule

`default_nettype wire
