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

// fp_mul_significand_product: significand_product w24
//
// The multiplier array: product of two significands.
//
// With `a = a_h * 2^16 + a_l` and `b` likewise, `a * b = a_h b_h * 2^32 + (a_h b_l + a_l b_h) * 2^16 + a_l b_l`; each
// partial product is one of `rust-hdl`'s 16 x 16 bits. A significand of 16 bits or fewer has no high part, and
// three of the four products fold away.
//
// A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier.
module fp_mul_significand_product (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Logic
    wire [15:0] a_0 = a_i[15:0];
    wire [15:0] b_0 = b_i[15:0];
    wire [15:0] a_1 = {8'd0, a_i[23:16]};
    wire [15:0] b_1 = {8'd0, b_i[23:16]};
    wire [31:0] low = {16'd0, a_0} * {16'd0, b_0};
    wire [31:0] cross_0 = {16'd0, a_0} * {16'd0, b_1};
    wire [31:0] cross_1 = {16'd0, a_1} * {16'd0, b_0};
    wire [31:0] high = {16'd0, a_1} * {16'd0, b_1};
    // Each cross product has at most 16 + 8 bits, so that their sum fits.
    wire [31:0] middle = cross_0 + cross_1;
    wire [47:0] middle_wide = {middle, 16'd0};
    wire [47:0] high_wide = {high[15:0], 32'd0};
    wire [47:0] sum = middle_wide + high_wide;

    // Outputs
    assign product_o = sum + {16'd0, low};

    // Bits that nothing reads
    wire unused = &{1'b0, high[31:16]};
endmodule

// fp_mul_leading_zeros: leading_zeros w24_x10
//   constant distance_0 = 10'h10
//   constant distance_1 = 10'd8
//   constant distance_2 = 10'd4
//   constant distance_3 = 10'd2
//   constant distance_4 = 10'd1
//   constant limit_0 = 24'h100
//   constant limit_1 = 24'h10000
//   constant limit_2 = 24'h100000
//   constant limit_3 = 24'h400000
//   constant limit_4 = 24'h800000
//
// Counts the zeros above the leading one.
module fp_mul_leading_zeros (
    input  wire [23:0] value_i,
    output wire [9:0]  count_o
);

    // Logic
    wire count_2_if = value_i < 24'h100;
    wire [23:0] value_2 = count_2_if ? {value_i[7:0], 16'd0} : value_i;
    wire [9:0] count_2 = count_2_if ? 10'h10 : 10'd0;
    wire count_3_if = value_2 < 24'h10000;
    wire [23:0] value_3 = count_3_if ? {value_2[15:0], 8'd0} : value_2;
    wire [9:0] count_3 = count_3_if ? (count_2 + 10'd8) : count_2;
    wire count_4_if = value_3 < 24'h100000;
    wire [23:0] value_4 = count_4_if ? {value_3[19:0], 4'd0} : value_3;
    wire [9:0] count_4 = count_4_if ? (count_3 + 10'd4) : count_3;
    wire count_5_if = value_4 < 24'h400000;
    wire [23:0] value_5 = count_5_if ? {value_4[21:0], 2'd0} : value_4;
    wire [9:0] count_5 = count_5_if ? (count_4 + 10'd2) : count_4;
    wire [9:0] count = (value_5 < 24'h800000) ? (count_5 + 10'd1) : count_5;

    // Outputs
    assign count_o = count;
endmodule

// fp_mul_sticky_shift: sticky_shift w26_a8
//   constant distance_0 = 8'd1
//   constant distance_1 = 8'd2
//   constant distance_2 = 8'd4
//   constant distance_3 = 8'd8
//   constant distance_4 = 8'h10
//   constant distance_5 = 8'h1a
//   constant distance_6 = 8'h1a
//   constant distance_7 = 8'h1a
//   constant lost_mask_0 = 26'd1
//   constant lost_mask_1 = 26'd3
//   constant lost_mask_2 = 26'hf
//   constant lost_mask_3 = 26'hff
//   constant lost_mask_4 = 26'hffff
//   constant lost_mask_5 = 26'h3ffffff
//   constant lost_mask_6 = 26'h3ffffff
//   constant lost_mask_7 = 26'h3ffffff
//
// Right shift that remembers whether it lost anything.
module fp_mul_sticky_shift (
    input  wire [25:0] value_i,
    input  wire [7:0]  amount_i,
    output wire [25:0] result_o
);

    // Logic
    wire [25:0] lost_1 = value_i & 26'd1;
    wire [25:0] value_2 = amount_i[0] ? {1'b0, value_i[25:1]} : value_i;
    wire sticky_2 = amount_i[0] & (|lost_1);
    wire [25:0] lost_2 = value_2 & 26'd3;
    wire [25:0] value_3 = amount_i[1] ? {2'd0, value_2[25:2]} : value_2;
    wire sticky_3 = amount_i[1] ? (sticky_2 | (|lost_2)) : sticky_2;
    wire [25:0] lost_3 = value_3 & 26'hf;
    wire [25:0] value_4 = amount_i[2] ? {4'd0, value_3[25:4]} : value_3;
    wire sticky_4 = amount_i[2] ? (sticky_3 | (|lost_3)) : sticky_3;
    wire [25:0] lost_4 = value_4 & 26'hff;
    wire [25:0] value_5 = amount_i[3] ? {8'd0, value_4[25:8]} : value_4;
    wire sticky_5 = amount_i[3] ? (sticky_4 | (|lost_4)) : sticky_4;
    wire [25:0] lost_5 = value_5 & 26'hffff;
    wire [25:0] value_6 = amount_i[4] ? {16'd0, value_5[25:16]} : value_5;
    wire sticky_6 = amount_i[4] ? (sticky_5 | (|lost_5)) : sticky_5;
    wire [25:0] value_7 = amount_i[5] ? 26'd0 : value_6;
    wire sticky_7 = amount_i[5] ? (sticky_6 | (|value_6)) : sticky_6;
    wire [25:0] lost = amount_i[6] ? 26'd0 : value_7;
    wire sticky_8 = amount_i[6] ? (sticky_7 | (|value_7)) : sticky_7;
    wire [25:0] value_9 = amount_i[7] ? 26'd0 : lost;
    wire sticky = amount_i[7] ? (sticky_8 | (|lost)) : sticky_8;
    wire [25:0] value = sticky ? (value_9 | 26'd1) : value_9;

    // Outputs
    assign result_o = value;
endmodule

// fp_mul_rounder: rounder e8m23
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
module fp_mul_rounder (
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

// fp_mul: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant top_index = 8'h2f
//   constant high_offset = 8'h16
//   constant low_mask = 48'h3fffff
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
// moves it down by one more. While the array multiplies, the zeros `z` of both operands are counted and the shift is
// fixed: left by `min(z, e - 1)`, or right by `1 - e` if `e < 1`, where the result is subnormal. The last left shift, by
// at most one, looks at the product itself.
//
// | cycle | work |
// |---|---|
// | 1 | unpack, multiply; count zeros, exponent and shift amounts |
// | 2 | shift, round |
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
    reg [9:0] left;
    reg [7:0] right;
    reg [47:0] product;
    reg valid_2;
    reg tag_2;
    reg [31:0] result;

    // Outputs of instances
    wire [23:0] a_significand_o;
    wire [23:0] b_significand_o;
    wire a_infinity_o;
    wire b_infinity_o;
    wire [9:0] zeros_a_count_o;
    wire [9:0] zeros_b_count_o;
    wire [7:0] a_exponent_o;
    wire [7:0] b_exponent_o;
    wire a_nan_o;
    wire b_nan_o;
    wire a_sign_o;
    wire b_sign_o;
    wire [47:0] array_product_o;
    wire [25:0] denormalise_result_o;
    wire [31:0] rounder_result_o;

    // Logic
    // Cycle 1: multiply.
    wire zero_factor = ~(|a_significand_o) | ~(|b_significand_o);
    wire infinite_factor = a_infinity_o | b_infinity_o;
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    wire [9:0] zeros = zeros_a_count_o + zeros_b_count_o;
    wire [9:0] wide_a = {2'd0, a_exponent_o};
    wire [9:0] wide_b = {2'd0, b_exponent_o};
    wire [9:0] exponent_sum = wide_a + wide_b;
    wire [9:0] top_exponent = exponent_sum - 10'h7e;
    wire tiny = top_exponent[9] | ~(|top_exponent);
    wire [9:0] room = top_exponent - 10'd1;
    wire [9:0] shortfall = 10'd1 - top_exponent;
    wire [9:0] left_amount_2 = (room < zeros) ? room : zeros;
    wire [9:0] start_exponent_1 = top_exponent - left_amount_2;
    wire [9:0] left_amount = tiny ? 10'd0 : left_amount_2;
    wire [7:0] right_amount = tiny ? shortfall[7:0] : 8'd0;
    wire [9:0] start_exponent = tiny ? 10'd1 : start_exponent_1;
    // Cycle 2: shift.
    wire [47:0] normal_1 = product << left;
    wire raw_exponent_if = ~normal_1[47] & (exponent != 10'd1);
    wire [47:0] normal = raw_exponent_if ? {normal_1[46:0], 1'b0} : normal_1;
    wire [9:0] raw_exponent = raw_exponent_if ? (exponent - 10'd1) : exponent;
    wire [25:0] raw_significand_1 = normal[47:22];
    wire [47:0] low = normal & 48'h3fffff;
    wire [25:0] raw_significand = (|low) ? (raw_significand_1 | 26'd1) : raw_significand_1;

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
            left <= left_amount;
            right <= right_amount;
            product <= array_product_o;
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply.
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
    fp_mul_significand_product array (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    fp_mul_leading_zeros zeros_a (
        .value_i (a_significand_o),
        .count_o (zeros_a_count_o)
    );
    fp_mul_leading_zeros zeros_b (
        .value_i (b_significand_o),
        .count_o (zeros_b_count_o)
    );
    // Cycle 2: shift.
    fp_mul_sticky_shift denormalise (
        .value_i  (raw_significand),
        .amount_i (right),
        .result_o (denormalise_result_o)
    );
    // Round.
    fp_mul_rounder rounder (
        .sign_i        (sign),
        .exponent_i    (raw_exponent),
        .significand_i (denormalise_result_o),
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
    wire unused = &{1'b0, shortfall[9:8]};
endmodule

`default_nettype wire
