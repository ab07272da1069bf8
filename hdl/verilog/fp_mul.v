// fp_mul: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none
// One file holds the whole hierarchy of its top:
// verilator lint_off DECLFILENAME

// fp_mul_fp_unpack: fp_unpack e8m23
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
module fp_mul_fp_unpack (
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

// fp_mul_significand_product_v1: significand_product w24_lower
//
// The multiplier arrays: the product of a significand with one half of another.
//
// With `b = b_upper * 2^H + b_lower` and `H` half the bits, rounded up, `a * b = a b_upper * 2^H + a b_lower`. Either array has half
// the rows of a whole one, which is what fits in a cycle; whoever uses the two adds their products in the next.
//
// A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier. `rust-hdl`
// multiplies 16 by 16 bits only, so that this module has its kernel written twice: for simulation, and as the syntax tree
// that other kernels get from the macro.
module fp_mul_significand_product_v1 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[11:0]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[23:12]};
endmodule

// fp_mul_significand_product_v2: significand_product w24_upper
module fp_mul_significand_product_v2 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[23:12]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[11:0]};
endmodule

// fp_mul_leading_zeros: leading_zeros w24_x5
//   constant top_index = 8'h17
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
//
// Counts the zeros above the leading one.
module fp_mul_leading_zeros (
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

// fp_mul_rounder: rounder e8m23
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
module fp_mul_rounder (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] window_i,
    input  wire        lost_i,
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
    wire [31:0] magnitude_2 = increment ? (encoded + 32'd1) : encoded;
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

// fp_mul: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant hidden_index = 8'h17
//   constant half = 8'hc
//   constant above_half = 8'h24
//   constant window_reach = 10'h16
//   constant ones = 48'hffffffffffff
//   constant window_offset = 8'h16
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
module fp_mul (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
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
    reg [9:0] exponent;
    reg right_shift;
    reg [4:0] left;
    reg [7:0] right;
    reg [9:0] below;
    reg [47:0] sum;
    reg [23:0] carry;
    reg valid_2;
    reg tag_2;
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
            tag_1 <= tag_i;
            rounding <= rounding_i;
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
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
    fp_mul_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    fp_mul_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    fp_mul_significand_product_v1 array_lower (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_lower_product_o)
    );
    fp_mul_significand_product_v2 array_upper (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_upper_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    fp_mul_leading_zeros leading (
        .value_i (subnormal),
        .count_o (leading_count_o)
    );
    // Round.
    fp_mul_rounder rounder (
        .sign_i     (sign),
        .exponent_i (exponent),
        .window_i   (window[25:0]),
        .lost_i     (|lost),
        .nan_i      (nan),
        .infinity_i (infinity),
        .rounding_i (rounding),
        .result_o   (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign tag_o = tag_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, array_lower_product_o[47:36], array_upper_product_o[47:36], normal[21:0], window[47:26]};
endmodule

`default_nettype wire
