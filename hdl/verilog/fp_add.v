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
    output wire [7:0]  exponent_o,
    output wire [23:0] significand_o,
    output wire        nan_o,
    output wire        infinity_o
);

    // Logic
    wire [7:0] code = word_i[30:23];
    wire [23:0] fraction = word_i[23:0] & 24'h7fffff;
    wire special = code == 8'hff;
    wire [23:0] significand_1 = fraction | 24'h800000;
    wire significand_if = |code;
    wire [7:0] exponent = significand_if ? code : 8'd1;
    wire [23:0] significand = significand_if ? significand_1 : fraction;
    wire infinity_o_part = |fraction;

    // Outputs
    assign sign_o = word_i[31];
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

// fp_add_rounder: rounder e8m23
//   constant leading_index = 8'h19
//   constant fraction_mask = 26'h7fffff
//   constant fraction_bits = 8'h17
//   constant special_exponent = 10'hff
//   constant max_finite = 32'h7f7fffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   constant sign_bit = 32'h80000000
//
// The one rounder behind every operation.
//
// The exact result is handed over as `(-1)^sign * significand * 2^(exponent - bias - S)`, where the significand has `S`
// bits, a round bit and a sticky bit (the OR of all that is further below). Field and fraction are packed into one
// word before the increment, so that a carry out of the fraction runs into the exponent: the largest subnormal becomes
// the smallest normal number, and the largest number becomes infinity, without a case of their own.
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
    input  wire [25:0] significand_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    input  wire [2:0]  rounding_i,
    output wire [31:0] result_o
);

    // Logic
    // Direction.
    wire leading = significand_i[25];
    wire inexact = significand_i[1] | significand_i[0];
    wire away = ((rounding_i == 3'd2) & sign_i) | ((rounding_i == 3'd3) & ~sign_i);
    wire increment_2_if = rounding_i == 3'd0;
    wire increment_if = rounding_i == 3'd4;
    wire to_infinity = (increment_2_if | increment_if) | away;
    wire increment_1 = away & inexact;
    // Packing and increment.
    wire [25:0] fraction_1 = {2'd0, significand_i[25:2]};
    wire increment_2_part = significand_i[1] & (significand_i[0] | significand_i[2]);
    wire increment_2 = increment_2_if ? increment_2_part : increment_1;
    wire increment = increment_if ? significand_i[1] : increment_2;
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field_2 = leading ? {22'd0, exponent_i} : 32'd0;
    wire [31:0] field = {field_2[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = increment ? (encoded + 32'd1) : encoded;
    // Results outside the normal range.
    wire overflow = (exponent_i >= 10'hff) | (magnitude_2 == 32'h7f800000);
    wire [31:0] magnitude_3 = overflow ? (to_infinity ? 32'h7f800000 : 32'h7f7fffff) : magnitude_2;
    wire [31:0] magnitude = infinity_i ? 32'h7f800000 : magnitude_3;
    wire [31:0] word_2 = sign_i ? (magnitude | 32'h80000000) : magnitude;
    wire [31:0] word = nan_i ? 32'h7fc00000 : word_2;

    // Outputs
    assign result_o = word;

    // Bits that nothing reads
    wire unused = &{1'b0, field_2[31:9]};
endmodule

// fp_add: fp_add e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant distance_0 = 8'h80
//   constant distance_1 = 8'h40
//   constant distance_2 = 8'h20
//   constant distance_3 = 8'h10
//   constant distance_4 = 8'd8
//   constant distance_5 = 8'd4
//   constant distance_6 = 8'd2
//   constant distance_7 = 8'd1
//   constant limit_0 = 28'd0
//   constant limit_1 = 28'd0
//   constant limit_2 = 28'd0
//   constant limit_3 = 28'h1000
//   constant limit_4 = 28'h100000
//   constant limit_5 = 28'h1000000
//   constant limit_6 = 28'h4000000
//   constant limit_7 = 28'h8000000
//
// Floating-point addition and subtraction.
//
// Let `|a| >= |b|` (else swap), `d` the difference of their exponents. Both significands get three bits below the last
// place; the smaller one is shifted right by `d`, a sticky bit standing for all that falls off, and added or
// subtracted:
//
// ```text
// sum = significand_a * 2^3 +- (significand_b * 2^3 >> d)
// ```
//
// Three bits suffice: if `d >= 2`, a difference loses at most one leading bit, which leaves a round bit
// and the sticky bit; if `d <= 1`, it is exact. The sum is then shifted left by `min(leading zeros, exponent)`: fully
// normalised, or as far as the smallest exponent allows, so that a subnormal result is exact and needs no case of
// its own.
//
// | cycle | work |
// |---|---|
// | 1 | unpack, order by magnitude, align, add or subtract |
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
    reg zero_sign;
    reg [7:0] exponent;
    reg [27:0] sum;
    reg valid_2;
    reg tag_2;
    reg [31:0] result;

    // Outputs of instances
    wire b_sign_o;
    wire a_sign_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire [27:0] align_result_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: order the operands by magnitude.
    wire sign_b = b_sign_o ^ subtract_i;
    wire differ = a_sign_o ^ sign_b;
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire swap = magnitude_a < magnitude_b;
    wire high_sign = swap ? sign_b : a_sign_o;
    wire [7:0] high_exponent = swap ? b_exponent_o : a_exponent_o;
    wire [7:0] low_exponent = swap ? a_exponent_o : b_exponent_o;
    wire [23:0] high_significand = swap ? b_significand_o : a_significand_o;
    wire [23:0] low_significand = swap ? a_significand_o : b_significand_o;
    // Align and add.
    wire [27:0] high = {1'b0, high_significand, 3'd0};
    wire [27:0] total_1 = high + align_result_o;
    wire [27:0] total = differ ? (high - align_result_o) : total_1;
    wire normal_2_if = (sum < 28'h1000) & (exponent >= 8'h10);
    // Cycle 2: normalise as far as the exponent allows.
    wire [7:0] budget_2 = normal_2_if ? (exponent - 8'h10) : exponent;
    wire [27:0] normal_2 = normal_2_if ? {sum[11:0], 16'd0} : sum;
    wire normal_3_if = (normal_2 < 28'h100000) & (budget_2 >= 8'd8);
    wire [7:0] budget_3 = normal_3_if ? (budget_2 - 8'd8) : budget_2;
    wire [27:0] normal_3 = normal_3_if ? {normal_2[19:0], 8'd0} : normal_2;
    wire normal_4_if = (normal_3 < 28'h1000000) & (budget_3 >= 8'd4);
    wire [7:0] budget_4 = normal_4_if ? (budget_3 - 8'd4) : budget_3;
    wire [27:0] normal_4 = normal_4_if ? {normal_3[23:0], 4'd0} : normal_3;
    wire normal_5_if = (normal_4 < 28'h4000000) & (budget_4 >= 8'd2);
    wire [7:0] budget_5 = normal_5_if ? (budget_4 - 8'd2) : budget_4;
    wire [27:0] normal_5 = normal_5_if ? {normal_4[25:0], 2'd0} : normal_4;
    wire normal_if = (normal_5 < 28'h8000000) & (budget_5 >= 8'd1);
    wire [7:0] budget = normal_if ? (budget_5 - 8'd1) : budget_5;
    wire [27:0] normal = normal_if ? {normal_5[26:0], 1'b0} : normal_5;
    wire [9:0] raw_exponent = {2'd0, budget};
    wire [27:0] raw_significand_1 = {2'd0, normal[27:2]};
    wire [27:0] raw_significand = (normal[0] | normal[1]) ? (raw_significand_1 | 28'd1) : raw_significand_1;
    // Round.
    wire result_sign = (~(|sum) & ~infinity) ? zero_sign : sign;

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
            zero_sign <= (differ & (rounding_i == 3'd2)) | (~differ & high_sign);
            exponent <= high_exponent;
            sum <= total;
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by magnitude.
    fp_add_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    fp_add_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    // Align and add.
    fp_add_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (high_exponent - low_exponent),
        .result_o (align_result_o)
    );
    // Round.
    fp_add_rounder rounder (
        .sign_i        (result_sign),
        .exponent_i    (raw_exponent + 10'd1),
        .significand_i (raw_significand[25:0]),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .rounding_i    (rounding),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign tag_o = tag_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, raw_significand[27:26]};
endmodule

`default_nettype wire
