// fp_add: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none
// One file holds the whole hierarchy of its top:
// verilator lint_off DECLFILENAME

// fp_add_fp_unpack: fp_unpack e8m23
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
module fp_add_fp_unpack (
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

// fp_add_sticky_shift: sticky_shift w28_a8
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
module fp_add_sticky_shift (
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

// fp_add_leading_zeros: leading_zeros w26_x5
//   constant top_index = 8'h19
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
//
// Counts the zeros above the leading one.
module fp_add_leading_zeros (
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

// fp_add_rounder: rounder e8m23
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
module fp_add_rounder (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] window_i,
    input  wire        lost_i,
    input  wire        complement_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    input  wire [2:0]  rounding_i,
    output wire [31:0] result_o
);

    // Logic
    // The significand with its round bit at the bottom, and whether anything is below.
    wire top = window_i[25];
    wire sticky_if = top | ~(|exponent_i);
    wire [25:0] kept = sticky_if ? {1'b0, window_i[25:1]} : window_i;
    wire sticky = sticky_if ? (lost_i | window_i[0]) : lost_i;
    // Direction.
    wire inexact = kept[0] | sticky;
    wire away = ((rounding_i == 3'd2) & sign_i) | ((rounding_i == 3'd3) & ~sign_i);
    wire increment_2_if = rounding_i == 3'd0;
    wire increment_if = rounding_i == 3'd4;
    wire to_infinity = (increment_2_if | increment_if) | away;
    wire increment_1 = away & inexact;
    // Packing and increment.
    wire [25:0] fraction_1 = {1'b0, kept[25:1]};
    wire increment_2 = increment_2_if ? (kept[0] & (sticky | kept[1])) : increment_1;
    wire increment = increment_if ? kept[0] : increment_2;
    wire [9:0] exponent_2 = window_i[24] ? exponent_i : 10'd0;
    wire [9:0] exponent = top ? (exponent_i + 10'd1) : exponent_2;
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field = {exponent[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = (increment | complement_i) ? (encoded + 32'd1) : encoded;
    // Results outside the normal range. An increment that overflows gives infinity by itself.
    wire overflow = (exponent_i >= 10'hff) | (top & (exponent_i == 10'hfe));
    wire [31:0] magnitude_3 = overflow ? (to_infinity ? 32'h7f800000 : 32'h7f7fffff) : magnitude_2;
    wire [31:0] magnitude = infinity_i ? 32'h7f800000 : magnitude_3;
    wire [31:0] word_2 = sign_i ? (magnitude | 32'h80000000) : magnitude;
    wire [31:0] word = nan_i ? 32'h7fc00000 : word_2;

    // Outputs
    assign result_o = word;

    // Bits that nothing reads
    wire unused = &{1'b0, exponent[9]};
endmodule

// fp_add: fp_add e8m23_t1
//   constant top_bit = 26'h2000000
//   constant second_bit = 26'h1000000
//   constant top_index = 8'h1b
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
module fp_add (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    input  wire        subtract_i,
    input  wire [2:0]  rounding_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid_1;
    reg tag_1;
    reg [2:0] rounding;
    reg nan;
    reg infinity;
    reg sign;
    reg minus_1;
    reg [7:0] exponent;
    reg [4:0] left;
    reg [27:0] sum;
    reg valid_2;
    reg tag_2;
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
    wire sign_b = b_sign_o ^ subtract_i;
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
    wire result_sign = (minus_1 & ~(|difference)) ? (rounding == 3'd2) : result_sign_1;

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
            tag_1 <= tag_i;
            rounding <= rounding_i;
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            minus_1 <= differ;
            exponent <= high_exponent;
            left <= zeros_count_o;
            sum <= total;
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
    fp_add_fp_unpack a (
        .word_i             (a_i),
        .sign_o             (a_sign_o),
        .encoded_exponent_o (a_encoded_exponent_o),
        .exponent_o         (a_exponent_o),
        .significand_o      (a_significand_o),
        .nan_o              (a_nan_o),
        .infinity_o         (a_infinity_o)
    );
    fp_add_fp_unpack b (
        .word_i             (b_i),
        .sign_o             (b_sign_o),
        .encoded_exponent_o (b_encoded_exponent_o),
        .exponent_o         (b_exponent_o),
        .significand_o      (b_significand_o),
        .nan_o              (b_nan_o),
        .infinity_o         (b_infinity_o)
    );
    // Align and add; a difference is inverted.
    fp_add_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (distance),
        .result_o (align_result_o)
    );
    // The marker, and a one at the bottom, so that the count means something even for zero.
    fp_add_leading_zeros zeros (
        .value_i (ends),
        .count_o (zeros_count_o)
    );
    // Round.
    fp_add_rounder rounder (
        .sign_i       (result_sign),
        .exponent_i   (wide_exponent - {5'd0, left}),
        .window_i     (normal[27:2]),
        .lost_i       (normal[0] | normal[1]),
        .complement_i (negative),
        .nan_i        (nan),
        .infinity_i   (infinity),
        .rounding_i   (rounding),
        .result_o     (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign tag_o = tag_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, first_1[0]};
endmodule

`default_nettype wire
