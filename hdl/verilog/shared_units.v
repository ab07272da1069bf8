// shared_units: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge, no reset: registers start at their initial value.
`default_nettype none
// One file holds the whole hierarchy of its top:
// verilator lint_off DECLFILENAME

// fp_unpack e8m23
//   constant sign_index = 8'h1f
//   constant fraction_bits = 8'h17
//   constant fraction_mask = 24'h7fffff
//   constant hidden_bit = 24'h800000
//   constant special_exponent = 8'hff
module fp_unpack (
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
    wire n9 = |code;
    wire [7:0] exponent = n9 ? code : 8'd1;
    wire [23:0] significand = n9 ? significand_1 : fraction;
    wire n14 = |fraction;

    // Outputs
    assign sign_o = word_i[31];
    assign exponent_o = exponent;
    assign significand_o = significand;
    assign nan_o = special & n14;
    assign infinity_o = special & ~n14;
endmodule

// sticky_shift w28_a8
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
module sticky_shift_v1 (
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

// rounder e8m23
//   constant leading_index = 8'h19
//   constant fraction_mask = 26'h7fffff
//   constant fraction_bits = 8'h17
//   constant special_exponent = 10'hff
//   constant max_finite = 32'h7f7fffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   constant sign_bit = 32'h80000000
//   tied input rounding_i = 3'd0
module rounder (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] significand_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    output wire [31:0] result_o
);

    // Logic
    wire leading = significand_i[25];
    wire [25:0] fraction_1 = {2'd0, significand_i[25:2]};
    wire increment = significand_i[1] & (significand_i[0] | significand_i[2]);
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field_2 = leading ? {22'd0, exponent_i} : 32'd0;
    wire [31:0] field = {field_2[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = increment ? (encoded + 32'd1) : encoded;
    wire overflow = (exponent_i >= 10'hff) | (magnitude_2 == 32'h7f800000);
    wire [31:0] magnitude_3 = overflow ? 32'h7f800000 : magnitude_2;
    wire [31:0] magnitude = infinity_i ? 32'h7f800000 : magnitude_3;
    wire [31:0] word_2 = sign_i ? (magnitude | 32'h80000000) : magnitude;
    wire [31:0] word = nan_i ? 32'h7fc00000 : word_2;

    // Outputs
    assign result_o = word;

    // Bits that nothing reads
    wire unused = &{1'b0, field_2[31:9]};
endmodule

// fp_add e8m23_t1
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
//   tied input rounding_i = 3'd0
module fp_add (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    input  wire        subtract_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid_1 = 1'b0;
    reg tag_1 = 1'b0;
    reg nan = 1'b0;
    reg infinity = 1'b0;
    reg sign = 1'b0;
    reg zero_sign = 1'b0;
    reg [7:0] exponent = 8'd0;
    reg [27:0] sum = 28'd0;
    reg valid_2 = 1'b0;
    reg tag_2 = 1'b0;
    reg [31:0] result = 32'd0;

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
    wire [27:0] high = {1'b0, high_significand, 3'd0};
    wire [27:0] total_1 = high + align_result_o;
    wire [27:0] total = differ ? (high - align_result_o) : total_1;
    wire n60 = (sum < 28'h1000) & (exponent >= 8'h10);
    wire [7:0] budget_2 = n60 ? (exponent - 8'h10) : exponent;
    wire [27:0] normal_2 = n60 ? {sum[11:0], 16'd0} : sum;
    wire n71 = (normal_2 < 28'h100000) & (budget_2 >= 8'd8);
    wire [7:0] budget_3 = n71 ? (budget_2 - 8'd8) : budget_2;
    wire [27:0] normal_3 = n71 ? {normal_2[19:0], 8'd0} : normal_2;
    wire n82 = (normal_3 < 28'h1000000) & (budget_3 >= 8'd4);
    wire [7:0] budget_4 = n82 ? (budget_3 - 8'd4) : budget_3;
    wire [27:0] normal_4 = n82 ? {normal_3[23:0], 4'd0} : normal_3;
    wire n93 = (normal_4 < 28'h4000000) & (budget_4 >= 8'd2);
    wire [7:0] budget_5 = n93 ? (budget_4 - 8'd2) : budget_4;
    wire [27:0] normal_5 = n93 ? {normal_4[25:0], 2'd0} : normal_4;
    wire n104 = (normal_5 < 28'h8000000) & (budget_5 >= 8'd1);
    wire [7:0] budget = n104 ? (budget_5 - 8'd1) : budget_5;
    wire [27:0] normal = n104 ? {normal_5[26:0], 1'b0} : normal_5;
    wire [9:0] raw_exponent = {2'd0, budget};
    wire [27:0] raw_significand_1 = {2'd0, normal[27:2]};
    wire [27:0] raw_significand = (normal[0] | normal[1]) ? (raw_significand_1 | 28'd1) : raw_significand_1;
    wire result_sign = (~(|sum) & ~infinity) ? zero_sign : sign;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid_1 <= valid_i;
            tag_1 <= tag_i;
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            zero_sign <= ~differ & high_sign;
            exponent <= high_exponent;
            sum <= total;
            valid_2 <= valid_1;
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    sticky_shift_v1 align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (high_exponent - low_exponent),
        .result_o (align_result_o)
    );
    rounder rounder (
        .sign_i        (result_sign),
        .exponent_i    (raw_exponent + 10'd1),
        .significand_i (raw_significand[25:0]),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign tag_o = tag_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, raw_significand[27:26]};
endmodule

// significand_product w24
module significand_product (
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
    wire [31:0] middle = cross_0 + cross_1;
    wire [47:0] middle_wide = {middle, 16'd0};
    wire [47:0] high_wide = {high[15:0], 32'd0};
    wire [47:0] sum = middle_wide + high_wide;

    // Outputs
    assign product_o = sum + {16'd0, low};

    // Bits that nothing reads
    wire unused = &{1'b0, high[31:16]};
endmodule

// leading_zeros w24_x10
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
module leading_zeros (
    input  wire [23:0] value_i,
    output wire [9:0]  count_o
);

    // Logic
    wire n3 = value_i < 24'h100;
    wire [23:0] value_2 = n3 ? {value_i[7:0], 16'd0} : value_i;
    wire [9:0] count_2 = n3 ? 10'h10 : 10'd0;
    wire n11 = value_2 < 24'h10000;
    wire [23:0] value_3 = n11 ? {value_2[15:0], 8'd0} : value_2;
    wire [9:0] count_3 = n11 ? (count_2 + 10'd8) : count_2;
    wire n20 = value_3 < 24'h100000;
    wire [23:0] value_4 = n20 ? {value_3[19:0], 4'd0} : value_3;
    wire [9:0] count_4 = n20 ? (count_3 + 10'd4) : count_3;
    wire n29 = value_4 < 24'h400000;
    wire [23:0] value_5 = n29 ? {value_4[21:0], 2'd0} : value_4;
    wire [9:0] count_5 = n29 ? (count_4 + 10'd2) : count_4;
    wire [9:0] count = (value_5 < 24'h800000) ? (count_5 + 10'd1) : count_5;

    // Outputs
    assign count_o = count;
endmodule

// sticky_shift w26_a8
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
module sticky_shift_v2 (
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

// fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant top_index = 8'h2f
//   constant high_offset = 8'h16
//   constant low_mask = 48'h3fffff
//   tied input rounding_i = 3'd0
module fp_mul (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid_1 = 1'b0;
    reg tag_1 = 1'b0;
    reg nan = 1'b0;
    reg infinity = 1'b0;
    reg sign = 1'b0;
    reg [9:0] exponent = 10'd0;
    reg [9:0] left = 10'd0;
    reg [7:0] right = 8'd0;
    reg [47:0] product = 48'd0;
    reg valid_2 = 1'b0;
    reg tag_2 = 1'b0;
    reg [31:0] result = 32'd0;

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
    wire zero_factor = ~(|a_significand_o) | ~(|b_significand_o);
    wire infinite_factor = a_infinity_o | b_infinity_o;
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
    wire [47:0] normal_1 = product << left;
    wire n67 = ~normal_1[47] & (exponent != 10'd1);
    wire [47:0] normal = n67 ? {normal_1[46:0], 1'b0} : normal_1;
    wire [9:0] raw_exponent = n67 ? (exponent - 10'd1) : exponent;
    wire [25:0] raw_significand_1 = normal[47:22];
    wire [47:0] low = normal & 48'h3fffff;
    wire [25:0] raw_significand = (|low) ? (raw_significand_1 | 26'd1) : raw_significand_1;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid_1 <= valid_i;
            tag_1 <= tag_i;
            nan <= (a_nan_o | b_nan_o) | (infinite_factor & zero_factor);
            infinity <= infinite_factor;
            sign <= a_sign_o ^ b_sign_o;
            exponent <= start_exponent;
            left <= left_amount;
            right <= right_amount;
            product <= array_product_o;
            valid_2 <= valid_1;
            tag_2 <= tag_1;
            result <= rounder_result_o;
        end
    end

    // Instances
    fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    significand_product array (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_product_o)
    );
    leading_zeros zeros_a (
        .value_i (a_significand_o),
        .count_o (zeros_a_count_o)
    );
    leading_zeros zeros_b (
        .value_i (b_significand_o),
        .count_o (zeros_b_count_o)
    );
    sticky_shift_v2 denormalise (
        .value_i  (raw_significand),
        .amount_i (right),
        .result_o (denormalise_result_o)
    );
    rounder rounder (
        .sign_i        (sign),
        .exponent_i    (raw_exponent),
        .significand_i (denormalise_result_o),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign tag_o = tag_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, shortfall[9:8]};
endmodule

// delay w32_n2
module delay_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0 = 32'd0;
    reg [31:0] stage_1 = 32'd0;

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

// delay w32_n5
module delay_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0 = 32'd0;
    reg [31:0] stage_1 = 32'd0;
    reg [31:0] stage_2 = 32'd0;
    reg [31:0] stage_3 = 32'd0;
    reg [31:0] stage_4 = 32'd0;

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

// ray_box_select w32
//   constant sign_index = 8'h1f
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
    delay_v1 inv_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_0),
        .q_o   (inv_wait_0_q_o)
    );
    delay_v1 inv_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_1),
        .q_o   (inv_wait_1_q_o)
    );
    delay_v1 inv_wait_2 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_low_2),
        .q_o   (inv_wait_2_q_o)
    );
    delay_v1 inv_wait_3 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_0),
        .q_o   (inv_wait_3_q_o)
    );
    delay_v1 inv_wait_4 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_1),
        .q_o   (inv_wait_4_q_o)
    );
    delay_v1 inv_wait_5 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (inv_high_2),
        .q_o   (inv_wait_5_q_o)
    );
    delay_v2 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    delay_v2 t_max_wait (
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

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b1
module fp_min_max_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid = 1'b0;
    reg [31:0] result = 32'd0;

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
            valid <= valid_i;
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign result_o = result;
endmodule

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b1
module fp_min_max_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result = 32'd0;

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

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b1
module fp_min_max_v3 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result = 32'd0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (nan_a | nan_b);
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire n19 = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | n19;
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

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b0
module fp_min_max_v4 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid = 1'b0;
    reg [31:0] result = 32'd0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire n18 = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | n18;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid <= valid_i;
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign result_o = result;
endmodule

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b0
module fp_min_max_v5 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result = 32'd0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire n17 = (magnitude_a <= 32'h7f800000) & ~(below ^ any_negative);
    wire choose_a = nan_b | n17;
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

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b0
module fp_min_max_v6 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] result_o
);

    // Registers
    reg [31:0] result = 32'd0;

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

// fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module fp_cmp_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire        le_o
);

    // Registers
    reg valid = 1'b0;
    reg le = 1'b0;

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
            valid <= valid_i;
            le <= ordered & (less | equal);
        end
    end

    // Outputs
    assign valid_o = valid;
    assign le_o = le;
endmodule

// fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module fp_cmp_v2 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        lt_o
);

    // Registers
    reg lt = 1'b0;

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

// ray_box_fold e8m23_c2
module ray_box_fold (
    input  wire        clk_i,
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
    reg [31:0] t_entry = 32'd0;

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
    wire hit = accept_0_le_o & ~accept_1_lt_o;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            t_entry <= entry_result_o;
        end
    end

    // Instances
    fp_min_max_v1 axis_near_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (valid_i),
        .a_i      (t_0_i),
        .b_i      (t_3_i),
        .valid_o  (axis_near_0_valid_o),
        .result_o (axis_near_0_result_o)
    );
    fp_min_max_v2 axis_near_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_1_i),
        .b_i      (t_4_i),
        .result_o (axis_near_1_result_o)
    );
    fp_min_max_v2 axis_near_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_2_i),
        .b_i      (t_5_i),
        .result_o (axis_near_2_result_o)
    );
    fp_min_max_v3 axis_far_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_0_i),
        .b_i      (t_3_i),
        .result_o (axis_far_0_result_o)
    );
    fp_min_max_v3 axis_far_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_1_i),
        .b_i      (t_4_i),
        .result_o (axis_far_1_result_o)
    );
    fp_min_max_v3 axis_far_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_2_i),
        .b_i      (t_5_i),
        .result_o (axis_far_2_result_o)
    );
    fp_min_max_v4 entry_half_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (axis_near_0_valid_o),
        .a_i      (axis_near_0_result_o),
        .b_i      (axis_near_1_result_o),
        .valid_o  (entry_half_0_valid_o),
        .result_o (entry_half_0_result_o)
    );
    fp_min_max_v5 entry_half_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_near_2_result_o),
        .b_i      (t_min_i),
        .result_o (entry_half_1_result_o)
    );
    fp_min_max_v6 exit_half_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_far_0_result_o),
        .b_i      (axis_far_1_result_o),
        .result_o (exit_half_0_result_o)
    );
    fp_min_max_v6 exit_half_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (axis_far_2_result_o),
        .b_i      (t_max_i),
        .result_o (exit_half_1_result_o)
    );
    fp_min_max_v4 entry (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (entry_half_0_valid_o),
        .a_i      (entry_half_0_result_o),
        .b_i      (entry_half_1_result_o),
        .valid_o  (entry_valid_o),
        .result_o (entry_result_o)
    );
    fp_min_max_v6 leave (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (exit_half_0_result_o),
        .b_i      (exit_half_1_result_o),
        .result_o (leave_result_o)
    );
    delay_v1 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    fp_cmp_v1 accept_0 (
        .clk_i   (clk_i),
        .en_i    (en_i),
        .valid_i (entry_valid_o),
        .a_i     (entry_result_o),
        .b_i     (leave_result_o),
        .valid_o (accept_0_valid_o),
        .le_o    (accept_0_le_o)
    );
    fp_cmp_v2 accept_1 (
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

// node_header
//   constant carve_index = 8'h1f
//   constant leaf_index = 8'h1a
//   constant kind_index = 8'h1d
//   constant size_index = 8'h1b
//   constant offset_mask = 32'h3ffffff
module node_header_v1 (
    input  wire [31:0] header_i,
    output wire        carve_o,
    output wire [1:0]  kind_o,
    output wire [1:0]  size_o
);

    // Outputs
    assign carve_o = header_i[31];
    assign kind_o = header_i[30:29];
    assign size_o = header_i[28:27];

    // Bits that nothing reads
    wire unused = &{1'b0, header_i[26:0]};
endmodule

// ray_select w32
//   constant sign_index = 8'h1f
module ray_select (
    input  wire [1:0]  axis_i,
    input  wire        min_side_i,
    input  wire [31:0] origin_x_i,
    input  wire [31:0] origin_y_i,
    input  wire [31:0] origin_z_i,
    input  wire [31:0] inv_entry_x_i,
    input  wire [31:0] inv_entry_y_i,
    input  wire [31:0] inv_entry_z_i,
    input  wire [31:0] inv_exit_x_i,
    input  wire [31:0] inv_exit_y_i,
    input  wire [31:0] inv_exit_z_i,
    output wire [31:0] origin_o,
    output wire [31:0] inv_o,
    output wire [31:0] inv_entry_o,
    output wire        negative_o
);

    // Logic
    wire n5 = axis_i == 2'd0;
    wire [31:0] origin_2 = n5 ? origin_x_i : origin_z_i;
    wire [31:0] inv_entry_2 = n5 ? inv_entry_x_i : inv_entry_z_i;
    wire [31:0] inv_exit_2 = n5 ? inv_exit_x_i : inv_exit_z_i;
    wire n13 = axis_i == 2'd1;
    wire [31:0] origin = n13 ? origin_y_i : origin_2;
    wire [31:0] inv_entry = n13 ? inv_entry_y_i : inv_entry_2;
    wire [31:0] inv_exit = n13 ? inv_exit_y_i : inv_exit_2;
    wire negative = inv_entry[31];
    wire leaving = negative == min_side_i;
    wire [31:0] inv = leaving ? inv_exit : inv_entry;

    // Outputs
    assign origin_o = origin;
    assign inv_o = inv;
    assign inv_entry_o = inv_entry;
    assign negative_o = negative;
endmodule

// fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
//   tied input b_i = 32'd0
module fp_cmp_v3 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    output wire        lt_o
);

    // Registers
    reg lt = 1'b0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire any_negative = magnitude_a != a_i;
    wire ordered = magnitude_a <= 32'h7f800000;
    wire equal = (a_i == 32'd0) | ~(|magnitude_a);
    wire less = any_negative & ~equal;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            lt <= ordered & less;
        end
    end

    // Outputs
    assign lt_o = lt;
endmodule

// delay w32_n3
module delay_v3 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0 = 32'd0;
    reg [31:0] stage_1 = 32'd0;
    reg [31:0] stage_2 = 32'd0;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
            stage_2 <= stage_1;
        end
    end

    // Outputs
    assign q_o = stage_2;
endmodule

// delay w1_n4
module delay_v4 (
    input  wire clk_i,
    input  wire en_i,
    input  wire d_i,
    output wire q_o
);

    // Registers
    reg stage_0 = 1'b0;
    reg stage_1 = 1'b0;
    reg stage_2 = 1'b0;
    reg stage_3 = 1'b0;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
            stage_2 <= stage_1;
            stage_3 <= stage_2;
        end
    end

    // Outputs
    assign q_o = stage_3;
endmodule

// dual_split_select e8m23_c2
//   constant single_code = 2'd2
module dual_split_select (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] header_i,
    input  wire [31:0] plane_0_i,
    input  wire [31:0] plane_1_i,
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
    output wire [31:0] plane_0_o,
    output wire [31:0] plane_1_o,
    output wire [31:0] origin_0_o,
    output wire [31:0] origin_1_o,
    output wire [31:0] inv_0_o,
    output wire [31:0] inv_1_o,
    output wire [31:0] t_min_o,
    output wire [31:0] t_max_o,
    output wire [31:0] header_o,
    output wire        exit_0_o,
    output wire        exit_1_o
);

    // Registers
    reg valid = 1'b0;
    reg [31:0] plane_0 = 32'd0;
    reg [31:0] plane_1 = 32'd0;
    reg [31:0] origin_0 = 32'd0;
    reg [31:0] origin_1 = 32'd0;
    reg negative_0 = 1'b0;
    reg negative_1 = 1'b0;
    reg side_0 = 1'b0;
    reg side_1 = 1'b0;

    // Outputs of instances
    wire fields_carve_o;
    wire [1:0] fields_kind_o;
    wire [1:0] fields_size_o;
    wire [31:0] select_0_origin_o;
    wire select_0_negative_o;
    wire [31:0] select_1_origin_o;
    wire select_1_negative_o;
    wire [31:0] select_0_inv_entry_o;
    wire role_0_lt_o;
    wire [31:0] select_1_inv_entry_o;
    wire role_1_lt_o;
    wire [31:0] select_0_inv_o;
    wire [31:0] inv_wait_0_q_o;
    wire exit_wait_0_q_o;
    wire [31:0] select_1_inv_o;
    wire [31:0] inv_wait_1_q_o;
    wire exit_wait_1_q_o;
    wire [31:0] header_wait_q_o;
    wire [31:0] t_min_wait_q_o;
    wire [31:0] t_max_wait_q_o;

    // Logic
    wire dual = fields_carve_o & (fields_kind_o != 2'd2);
    wire [1:0] axis_0_2 = fields_carve_o ? fields_size_o : fields_kind_o;
    wire [1:0] axis_0 = dual ? {1'b0, fields_kind_o[1]} : axis_0_2;
    wire [1:0] axis_1 = dual ? (fields_kind_o[0] ? 2'd2 : 2'd1) : axis_0_2;
    wire min_side_0 = dual & fields_size_o[1];
    wire min_side_1 = ~dual | fields_size_o[0];
    wire runs_down_0 = role_0_lt_o | negative_0;
    wire runs_down_1 = role_1_lt_o | negative_1;
    wire leaving_0 = runs_down_0 == side_0;
    wire leaving_1 = runs_down_1 == side_1;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid <= valid_i;
            plane_0 <= plane_0_i;
            plane_1 <= plane_1_i;
            origin_0 <= select_0_origin_o;
            origin_1 <= select_1_origin_o;
            negative_0 <= select_0_negative_o;
            negative_1 <= select_1_negative_o;
            side_0 <= min_side_0;
            side_1 <= min_side_1;
        end
    end

    // Instances
    node_header_v1 fields (
        .header_i (header_i),
        .carve_o  (fields_carve_o),
        .kind_o   (fields_kind_o),
        .size_o   (fields_size_o)
    );
    ray_select select_0 (
        .axis_i        (axis_0),
        .min_side_i    (min_side_0),
        .origin_x_i    (origin_x_i),
        .origin_y_i    (origin_y_i),
        .origin_z_i    (origin_z_i),
        .inv_entry_x_i (inv_entry_x_i),
        .inv_entry_y_i (inv_entry_y_i),
        .inv_entry_z_i (inv_entry_z_i),
        .inv_exit_x_i  (inv_exit_x_i),
        .inv_exit_y_i  (inv_exit_y_i),
        .inv_exit_z_i  (inv_exit_z_i),
        .origin_o      (select_0_origin_o),
        .inv_o         (select_0_inv_o),
        .inv_entry_o   (select_0_inv_entry_o),
        .negative_o    (select_0_negative_o)
    );
    ray_select select_1 (
        .axis_i        (axis_1),
        .min_side_i    (min_side_1),
        .origin_x_i    (origin_x_i),
        .origin_y_i    (origin_y_i),
        .origin_z_i    (origin_z_i),
        .inv_entry_x_i (inv_entry_x_i),
        .inv_entry_y_i (inv_entry_y_i),
        .inv_entry_z_i (inv_entry_z_i),
        .inv_exit_x_i  (inv_exit_x_i),
        .inv_exit_y_i  (inv_exit_y_i),
        .inv_exit_z_i  (inv_exit_z_i),
        .origin_o      (select_1_origin_o),
        .inv_o         (select_1_inv_o),
        .inv_entry_o   (select_1_inv_entry_o),
        .negative_o    (select_1_negative_o)
    );
    fp_cmp_v3 role_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (select_0_inv_entry_o),
        .lt_o  (role_0_lt_o)
    );
    fp_cmp_v3 role_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (select_1_inv_entry_o),
        .lt_o  (role_1_lt_o)
    );
    delay_v3 inv_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (select_0_inv_o),
        .q_o   (inv_wait_0_q_o)
    );
    delay_v3 inv_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (select_1_inv_o),
        .q_o   (inv_wait_1_q_o)
    );
    delay_v4 exit_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (leaving_0),
        .q_o   (exit_wait_0_q_o)
    );
    delay_v4 exit_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (leaving_1),
        .q_o   (exit_wait_1_q_o)
    );
    delay_v2 header_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (header_i),
        .q_o   (header_wait_q_o)
    );
    delay_v2 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    delay_v2 t_max_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_max_i),
        .q_o   (t_max_wait_q_o)
    );

    // Outputs
    assign valid_o = valid;
    assign plane_0_o = plane_0;
    assign plane_1_o = plane_1;
    assign origin_0_o = origin_0;
    assign origin_1_o = origin_1;
    assign inv_0_o = inv_wait_0_q_o;
    assign inv_1_o = inv_wait_1_q_o;
    assign t_min_o = t_min_wait_q_o;
    assign t_max_o = t_max_wait_q_o;
    assign header_o = header_wait_q_o;
    assign exit_0_o = exit_wait_0_q_o;
    assign exit_1_o = exit_wait_1_q_o;
endmodule

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input propagate_nan_i = 1'b0
module fp_min_max_v7 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    input  wire        maximum_i,
    output wire        valid_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid = 1'b0;
    reg [31:0] result = 32'd0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = nan_a & nan_b;
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire n19 = (magnitude_a <= 32'h7f800000) & ((below ^ any_negative) ^ maximum_i);
    wire choose_a = nan_b | n19;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid <= valid_i;
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign result_o = result;
endmodule

// delay w1_n3
module delay_v5 (
    input  wire clk_i,
    input  wire en_i,
    input  wire d_i,
    output wire q_o
);

    // Registers
    reg stage_0 = 1'b0;
    reg stage_1 = 1'b0;
    reg stage_2 = 1'b0;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            stage_0 <= d_i;
            stage_1 <= stage_0;
            stage_2 <= stage_1;
        end
    end

    // Outputs
    assign q_o = stage_2;
endmodule

// fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module fp_cmp_v4 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        le_o
);

    // Registers
    reg le = 1'b0;

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
            le <= ordered & (less | equal);
        end
    end

    // Outputs
    assign le_o = le;
endmodule

// int_add w32_t1
//   tied input tag_i = 1'b0
module int_add (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] sum_o
);

    // Registers
    reg [31:0] sum = 32'd0;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            sum <= a_i + b_i;
        end
    end

    // Outputs
    assign sum_o = sum;
endmodule

// node_header
//   constant carve_index = 8'h1f
//   constant leaf_index = 8'h1a
//   constant kind_index = 8'h1d
//   constant size_index = 8'h1b
//   constant offset_mask = 32'h3ffffff
module node_header_v2 (
    input  wire [31:0] header_i,
    output wire        carve_o,
    output wire        leaf_o,
    output wire [1:0]  size_o,
    output wire [31:0] offset_o
);

    // Outputs
    assign carve_o = header_i[31];
    assign leaf_o = header_i[26];
    assign size_o = header_i[28:27];
    assign offset_o = header_i & 32'h3ffffff;
endmodule

// dual_split_fold e8m23
module dual_split_fold (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] t_0_i,
    input  wire [31:0] t_1_i,
    input  wire        exit_0_i,
    input  wire        exit_1_i,
    input  wire [31:0] header_i,
    input  wire [31:0] t_min_i,
    input  wire [31:0] t_max_i,
    output wire        valid_o,
    output wire [1:0]  code_o,
    output wire [31:0] near_offset_o,
    output wire [31:0] near_t_min_o,
    output wire [31:0] near_t_max_o,
    output wire [31:0] far_offset_o,
    output wire [31:0] far_t_min_o,
    output wire [31:0] far_t_max_o
);

    // Registers
    reg [31:0] exit_t = 32'd0;
    reg [31:0] entry_t = 32'd0;
    reg two_exits = 1'b0;
    reg two_entries = 1'b0;
    reg [31:0] t_min_6 = 32'd0;
    reg [31:0] t_max_6 = 32'd0;
    reg [31:0] t_min_7 = 32'd0;
    reg [31:0] t_max_7 = 32'd0;
    reg [31:0] first_offset = 32'd0;
    reg carve = 1'b0;
    reg leaf = 1'b0;
    reg [31:0] lower = 32'd0;
    reg [31:0] upper = 32'd0;
    reg [31:0] t_min_8 = 32'd0;
    reg [31:0] t_max_8 = 32'd0;

    // Outputs of instances
    wire combine_valid_o;
    wire [31:0] combine_result_o;
    wire [31:0] header_wait_q_o;
    wire fold_entry_valid_o;
    wire fields_carve_o;
    wire [31:0] fold_entry_result_o;
    wire [31:0] fold_exit_result_o;
    wire [31:0] fields_offset_o;
    wire [1:0] fields_size_o;
    wire fields_leaf_o;
    wire accept_near_le_o;
    wire accept_far_le_o;
    wire downward_q_o;
    wire [31:0] second_offset_sum_o;
    wire accept_near_valid_o;

    // Logic
    wire runs_down = ~exit_0_i;
    wire [31:0] route_exit = exit_0_i ? t_0_i : (exit_1_i ? t_1_i : t_max_i);
    wire [31:0] route_entry = exit_0_i ? (exit_1_i ? t_min_i : t_1_i) : t_0_i;
    wire [31:0] latest_entry = two_entries ? combine_result_o : entry_t;
    wire [31:0] earliest_exit = two_exits ? combine_result_o : exit_t;
    wire [31:0] near_start = fields_carve_o ? fold_entry_result_o : t_min_7;
    wire n46 = ~carve;
    wire is_split = n46 & ~leaf;
    wire [1:0] n58 = (accept_near_le_o & accept_far_le_o) ? 2'd2 : ((accept_near_le_o | accept_far_le_o) ? 2'd1 : 2'd0);
    wire [1:0] n64 = leaf ? ((n46 | accept_near_le_o) ? 2'd3 : 2'd0) : (accept_near_le_o ? 2'd1 : 2'd0);
    wire [1:0] code = is_split ? n58 : n64;
    wire [31:0] near_offset = (is_split & (accept_near_le_o == downward_q_o)) ? second_offset_sum_o : first_offset;
    wire [31:0] near_t_min = (carve | (is_split & ~accept_near_le_o)) ? lower : t_min_8;
    wire [31:0] near_t_max = (carve | (is_split & accept_near_le_o)) ? upper : t_max_8;
    wire [31:0] far_offset = downward_q_o ? first_offset : second_offset_sum_o;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            exit_t <= route_exit;
            entry_t <= route_entry;
            two_exits <= exit_0_i & exit_1_i;
            two_entries <= runs_down & ~exit_1_i;
            t_min_6 <= t_min_i;
            t_max_6 <= t_max_i;
            t_min_7 <= t_min_6;
            t_max_7 <= t_max_6;
            first_offset <= fields_offset_o;
            carve <= fields_carve_o;
            leaf <= fields_leaf_o;
            lower <= fold_entry_result_o;
            upper <= fold_exit_result_o;
            t_min_8 <= t_min_7;
            t_max_8 <= t_max_7;
        end
    end

    // Instances
    fp_min_max_v7 combine (
        .clk_i     (clk_i),
        .en_i      (en_i),
        .valid_i   (valid_i),
        .a_i       (t_0_i),
        .b_i       (t_1_i),
        .maximum_i (runs_down),
        .valid_o   (combine_valid_o),
        .result_o  (combine_result_o)
    );
    fp_min_max_v4 fold_entry (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (combine_valid_o),
        .a_i      (t_min_6),
        .b_i      (latest_entry),
        .valid_o  (fold_entry_valid_o),
        .result_o (fold_entry_result_o)
    );
    fp_min_max_v6 fold_exit (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_max_6),
        .b_i      (earliest_exit),
        .result_o (fold_exit_result_o)
    );
    delay_v1 header_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (header_i),
        .q_o   (header_wait_q_o)
    );
    delay_v5 downward (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (runs_down),
        .q_o   (downward_q_o)
    );
    fp_cmp_v1 accept_near (
        .clk_i   (clk_i),
        .en_i    (en_i),
        .valid_i (fold_entry_valid_o),
        .a_i     (near_start),
        .b_i     (fold_exit_result_o),
        .valid_o (accept_near_valid_o),
        .le_o    (accept_near_le_o)
    );
    fp_cmp_v4 accept_far (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (fold_entry_result_o),
        .b_i   (t_max_7),
        .le_o  (accept_far_le_o)
    );
    int_add second_offset (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (fields_offset_o),
        .b_i   ({30'd0, fields_size_o}),
        .sum_o (second_offset_sum_o)
    );
    node_header_v2 fields (
        .header_i (header_wait_q_o),
        .carve_o  (fields_carve_o),
        .leaf_o   (fields_leaf_o),
        .size_o   (fields_size_o),
        .offset_o (fields_offset_o)
    );

    // Outputs
    assign valid_o = accept_near_valid_o;
    assign code_o = code;
    assign near_offset_o = near_offset;
    assign near_t_min_o = near_t_min;
    assign near_t_max_o = near_t_max;
    assign far_offset_o = far_offset;
    assign far_t_min_o = lower;
    assign far_t_max_o = t_max_8;
endmodule

// delay w1_n8
module delay_v6 (
    input  wire clk_i,
    input  wire en_i,
    input  wire d_i,
    output wire q_o
);

    // Registers
    reg stage_0 = 1'b0;
    reg stage_1 = 1'b0;
    reg stage_2 = 1'b0;
    reg stage_3 = 1'b0;
    reg stage_4 = 1'b0;
    reg stage_5 = 1'b0;
    reg stage_6 = 1'b0;
    reg stage_7 = 1'b0;

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

// shared_units e8m23_t1
module shared_units (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [1:0]  mode_i,
    input  wire        add_valid_0_i,
    input  wire        add_valid_1_i,
    input  wire        add_valid_2_i,
    input  wire        add_valid_3_i,
    input  wire        add_valid_4_i,
    input  wire        add_valid_5_i,
    input  wire        add_valid_6_i,
    input  wire        add_valid_7_i,
    input  wire        add_tag_0_i,
    input  wire        add_tag_1_i,
    input  wire        add_tag_2_i,
    input  wire        add_tag_3_i,
    input  wire        add_tag_4_i,
    input  wire        add_tag_5_i,
    input  wire        add_tag_6_i,
    input  wire        add_tag_7_i,
    input  wire [31:0] add_a_0_i,
    input  wire [31:0] add_a_1_i,
    input  wire [31:0] add_a_2_i,
    input  wire [31:0] add_a_3_i,
    input  wire [31:0] add_a_4_i,
    input  wire [31:0] add_a_5_i,
    input  wire [31:0] add_a_6_i,
    input  wire [31:0] add_a_7_i,
    input  wire [31:0] add_b_0_i,
    input  wire [31:0] add_b_1_i,
    input  wire [31:0] add_b_2_i,
    input  wire [31:0] add_b_3_i,
    input  wire [31:0] add_b_4_i,
    input  wire [31:0] add_b_5_i,
    input  wire [31:0] add_b_6_i,
    input  wire [31:0] add_b_7_i,
    input  wire        add_subtract_0_i,
    input  wire        add_subtract_1_i,
    input  wire        add_subtract_2_i,
    input  wire        add_subtract_3_i,
    input  wire        add_subtract_4_i,
    input  wire        add_subtract_5_i,
    input  wire        add_subtract_6_i,
    input  wire        add_subtract_7_i,
    input  wire        mul_valid_0_i,
    input  wire        mul_valid_1_i,
    input  wire        mul_valid_2_i,
    input  wire        mul_valid_3_i,
    input  wire        mul_valid_4_i,
    input  wire        mul_valid_5_i,
    input  wire        mul_valid_6_i,
    input  wire        mul_valid_7_i,
    input  wire        mul_tag_0_i,
    input  wire        mul_tag_1_i,
    input  wire        mul_tag_2_i,
    input  wire        mul_tag_3_i,
    input  wire        mul_tag_4_i,
    input  wire        mul_tag_5_i,
    input  wire        mul_tag_6_i,
    input  wire        mul_tag_7_i,
    input  wire [31:0] mul_a_0_i,
    input  wire [31:0] mul_a_1_i,
    input  wire [31:0] mul_a_2_i,
    input  wire [31:0] mul_a_3_i,
    input  wire [31:0] mul_a_4_i,
    input  wire [31:0] mul_a_5_i,
    input  wire [31:0] mul_a_6_i,
    input  wire [31:0] mul_a_7_i,
    input  wire [31:0] mul_b_0_i,
    input  wire [31:0] mul_b_1_i,
    input  wire [31:0] mul_b_2_i,
    input  wire [31:0] mul_b_3_i,
    input  wire [31:0] mul_b_4_i,
    input  wire [31:0] mul_b_5_i,
    input  wire [31:0] mul_b_6_i,
    input  wire [31:0] mul_b_7_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] header_i,
    input  wire [31:0] plane_0_i,
    input  wire [31:0] plane_1_i,
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
    output wire        add_valid_0_o,
    output wire        add_valid_1_o,
    output wire        add_valid_2_o,
    output wire        add_valid_3_o,
    output wire        add_valid_4_o,
    output wire        add_valid_5_o,
    output wire        add_valid_6_o,
    output wire        add_valid_7_o,
    output wire        add_tag_0_o,
    output wire        add_tag_1_o,
    output wire        add_tag_2_o,
    output wire        add_tag_3_o,
    output wire        add_tag_4_o,
    output wire        add_tag_5_o,
    output wire        add_tag_6_o,
    output wire        add_tag_7_o,
    output wire [31:0] add_result_0_o,
    output wire [31:0] add_result_1_o,
    output wire [31:0] add_result_2_o,
    output wire [31:0] add_result_3_o,
    output wire [31:0] add_result_4_o,
    output wire [31:0] add_result_5_o,
    output wire [31:0] add_result_6_o,
    output wire [31:0] add_result_7_o,
    output wire        mul_valid_0_o,
    output wire        mul_valid_1_o,
    output wire        mul_valid_2_o,
    output wire        mul_valid_3_o,
    output wire        mul_valid_4_o,
    output wire        mul_valid_5_o,
    output wire        mul_valid_6_o,
    output wire        mul_valid_7_o,
    output wire        mul_tag_0_o,
    output wire        mul_tag_1_o,
    output wire        mul_tag_2_o,
    output wire        mul_tag_3_o,
    output wire        mul_tag_4_o,
    output wire        mul_tag_5_o,
    output wire        mul_tag_6_o,
    output wire        mul_tag_7_o,
    output wire [31:0] mul_result_0_o,
    output wire [31:0] mul_result_1_o,
    output wire [31:0] mul_result_2_o,
    output wire [31:0] mul_result_3_o,
    output wire [31:0] mul_result_4_o,
    output wire [31:0] mul_result_5_o,
    output wire [31:0] mul_result_6_o,
    output wire [31:0] mul_result_7_o,
    output wire        tag_o,
    output wire        node_valid_o,
    output wire [1:0]  code_o,
    output wire [31:0] near_offset_o,
    output wire [31:0] near_t_min_o,
    output wire [31:0] near_t_max_o,
    output wire [31:0] far_offset_o,
    output wire [31:0] far_t_min_o,
    output wire [31:0] far_t_max_o,
    output wire        box_valid_o,
    output wire        hit_o,
    output wire [31:0] t_entry_o
);

    // Outputs of instances
    wire add_0_valid_o;
    wire [31:0] add_0_result_o;
    wire [31:0] box_select_inv_0_o;
    wire [31:0] mul_0_result_o;
    wire add_1_valid_o;
    wire [31:0] add_1_result_o;
    wire [31:0] box_select_inv_1_o;
    wire [31:0] mul_1_result_o;
    wire add_2_valid_o;
    wire [31:0] add_2_result_o;
    wire [31:0] box_select_inv_2_o;
    wire [31:0] mul_2_result_o;
    wire add_3_valid_o;
    wire [31:0] add_3_result_o;
    wire [31:0] box_select_inv_3_o;
    wire [31:0] mul_3_result_o;
    wire add_4_valid_o;
    wire [31:0] add_4_result_o;
    wire [31:0] box_select_inv_4_o;
    wire [31:0] mul_4_result_o;
    wire add_5_valid_o;
    wire [31:0] add_5_result_o;
    wire [31:0] box_select_inv_5_o;
    wire [31:0] mul_5_result_o;
    wire node_select_valid_o;
    wire [31:0] node_select_plane_0_o;
    wire [31:0] node_select_origin_0_o;
    wire [31:0] node_select_inv_0_o;
    wire [31:0] node_select_plane_1_o;
    wire [31:0] node_select_origin_1_o;
    wire [31:0] node_select_inv_1_o;
    wire add_0_tag_o;
    wire mul_0_valid_o;
    wire mul_0_tag_o;
    wire add_1_tag_o;
    wire mul_1_valid_o;
    wire mul_1_tag_o;
    wire add_2_tag_o;
    wire mul_2_valid_o;
    wire mul_2_tag_o;
    wire add_3_tag_o;
    wire mul_3_valid_o;
    wire mul_3_tag_o;
    wire add_4_tag_o;
    wire mul_4_valid_o;
    wire mul_4_tag_o;
    wire add_5_tag_o;
    wire mul_5_valid_o;
    wire mul_5_tag_o;
    wire add_6_valid_o;
    wire add_6_tag_o;
    wire [31:0] add_6_result_o;
    wire mul_6_valid_o;
    wire mul_6_tag_o;
    wire [31:0] mul_6_result_o;
    wire add_7_valid_o;
    wire add_7_tag_o;
    wire [31:0] add_7_result_o;
    wire mul_7_valid_o;
    wire mul_7_tag_o;
    wire [31:0] mul_7_result_o;
    wire [31:0] box_select_t_min_o;
    wire [31:0] box_select_t_max_o;
    wire node_select_exit_0_o;
    wire node_select_exit_1_o;
    wire [31:0] node_select_header_o;
    wire [31:0] node_select_t_min_o;
    wire [31:0] node_select_t_max_o;
    wire tag_q_o;
    wire node_fold_valid_o;
    wire [1:0] node_fold_code_o;
    wire [31:0] node_fold_near_offset_o;
    wire [31:0] node_fold_near_t_min_o;
    wire [31:0] node_fold_near_t_max_o;
    wire [31:0] node_fold_far_offset_o;
    wire [31:0] node_fold_far_t_min_o;
    wire [31:0] node_fold_far_t_max_o;
    wire box_fold_valid_o;
    wire box_fold_hit_o;
    wire [31:0] box_fold_t_entry_o;

    // Logic
    wire ray_box = mode_i == 2'd1;
    wire dual_split = mode_i == 2'd2;
    wire n87 = mode_i != 2'd1;
    wire add_valid_0_2 = ray_box ? valid_i : add_valid_0_i;
    wire [31:0] add_a_0_2 = ray_box ? box_min_x_i : add_a_0_i;
    wire [31:0] add_b_0_2 = ray_box ? origin_x_i : add_b_0_i;
    wire add_subtract_0_2 = ray_box | add_subtract_0_i;
    wire mul_valid_0_2 = ray_box ? add_0_valid_o : mul_valid_0_i;
    wire [31:0] mul_a_0_2 = ray_box ? add_0_result_o : mul_a_0_i;
    wire [31:0] mul_b_0_2 = ray_box ? box_select_inv_0_o : mul_b_0_i;
    wire add_valid_1_2 = ray_box ? valid_i : add_valid_1_i;
    wire [31:0] add_a_1_2 = ray_box ? box_min_y_i : add_a_1_i;
    wire [31:0] add_b_1_2 = ray_box ? origin_y_i : add_b_1_i;
    wire add_subtract_1_2 = ray_box | add_subtract_1_i;
    wire mul_valid_1_2 = ray_box ? add_1_valid_o : mul_valid_1_i;
    wire [31:0] mul_a_1_2 = ray_box ? add_1_result_o : mul_a_1_i;
    wire [31:0] mul_b_1_2 = ray_box ? box_select_inv_1_o : mul_b_1_i;
    wire add_valid_2 = ray_box ? valid_i : add_valid_2_i;
    wire [31:0] add_a_2 = ray_box ? box_min_z_i : add_a_2_i;
    wire [31:0] add_b_2 = ray_box ? origin_z_i : add_b_2_i;
    wire add_subtract_2 = ray_box | add_subtract_2_i;
    wire mul_valid_2 = ray_box ? add_2_valid_o : mul_valid_2_i;
    wire [31:0] mul_a_2 = ray_box ? add_2_result_o : mul_a_2_i;
    wire [31:0] mul_b_2 = ray_box ? box_select_inv_2_o : mul_b_2_i;
    wire add_valid_3 = ray_box ? valid_i : add_valid_3_i;
    wire [31:0] add_a_3 = ray_box ? box_max_x_i : add_a_3_i;
    wire [31:0] add_b_3 = ray_box ? origin_x_i : add_b_3_i;
    wire add_subtract_3 = ray_box | add_subtract_3_i;
    wire mul_valid_3 = ray_box ? add_3_valid_o : mul_valid_3_i;
    wire [31:0] mul_a_3 = ray_box ? add_3_result_o : mul_a_3_i;
    wire [31:0] mul_b_3 = ray_box ? box_select_inv_3_o : mul_b_3_i;
    wire add_valid_4 = ray_box ? valid_i : add_valid_4_i;
    wire [31:0] add_a_4 = ray_box ? box_max_y_i : add_a_4_i;
    wire [31:0] add_b_4 = ray_box ? origin_y_i : add_b_4_i;
    wire add_subtract_4 = ray_box | add_subtract_4_i;
    wire mul_valid_4 = ray_box ? add_4_valid_o : mul_valid_4_i;
    wire [31:0] mul_a_4 = ray_box ? add_4_result_o : mul_a_4_i;
    wire [31:0] mul_b_4 = ray_box ? box_select_inv_4_o : mul_b_4_i;
    wire add_valid_5 = ray_box ? valid_i : add_valid_5_i;
    wire [31:0] add_a_5 = ray_box ? box_max_z_i : add_a_5_i;
    wire [31:0] add_b_5 = ray_box ? origin_z_i : add_b_5_i;
    wire add_subtract_5 = ray_box | add_subtract_5_i;
    wire mul_valid_5 = ray_box ? add_5_valid_o : mul_valid_5_i;
    wire [31:0] mul_a_5 = ray_box ? add_5_result_o : mul_a_5_i;
    wire [31:0] mul_b_5 = ray_box ? box_select_inv_5_o : mul_b_5_i;
    wire taken_0 = dual_split | ray_box;
    wire add_valid_0 = dual_split ? node_select_valid_o : add_valid_0_2;
    wire [31:0] add_a_0 = dual_split ? node_select_plane_0_o : add_a_0_2;
    wire [31:0] add_b_0 = dual_split ? node_select_origin_0_o : add_b_0_2;
    wire add_subtract_0 = dual_split | add_subtract_0_2;
    wire mul_valid_0 = dual_split ? add_0_valid_o : mul_valid_0_2;
    wire [31:0] mul_a_0 = dual_split ? add_0_result_o : mul_a_0_2;
    wire [31:0] mul_b_0 = dual_split ? node_select_inv_0_o : mul_b_0_2;
    wire add_valid_1 = dual_split ? node_select_valid_o : add_valid_1_2;
    wire [31:0] add_a_1 = dual_split ? node_select_plane_1_o : add_a_1_2;
    wire [31:0] add_b_1 = dual_split ? node_select_origin_1_o : add_b_1_2;
    wire add_subtract_1 = dual_split | add_subtract_1_2;
    wire mul_valid_1 = dual_split ? add_1_valid_o : mul_valid_1_2;
    wire [31:0] mul_a_1 = dual_split ? add_1_result_o : mul_a_1_2;
    wire [31:0] mul_b_1 = dual_split ? node_select_inv_1_o : mul_b_1_2;
    wire n174 = ~taken_0;

    // Instances
    fp_add add_0 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_0),
        .tag_i      (add_tag_0_i),
        .a_i        (add_a_0),
        .b_i        (add_b_0),
        .subtract_i (add_subtract_0),
        .valid_o    (add_0_valid_o),
        .tag_o      (add_0_tag_o),
        .result_o   (add_0_result_o)
    );
    fp_add add_1 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_1),
        .tag_i      (add_tag_1_i),
        .a_i        (add_a_1),
        .b_i        (add_b_1),
        .subtract_i (add_subtract_1),
        .valid_o    (add_1_valid_o),
        .tag_o      (add_1_tag_o),
        .result_o   (add_1_result_o)
    );
    fp_add add_2 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_2),
        .tag_i      (add_tag_2_i),
        .a_i        (add_a_2),
        .b_i        (add_b_2),
        .subtract_i (add_subtract_2),
        .valid_o    (add_2_valid_o),
        .tag_o      (add_2_tag_o),
        .result_o   (add_2_result_o)
    );
    fp_add add_3 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_3),
        .tag_i      (add_tag_3_i),
        .a_i        (add_a_3),
        .b_i        (add_b_3),
        .subtract_i (add_subtract_3),
        .valid_o    (add_3_valid_o),
        .tag_o      (add_3_tag_o),
        .result_o   (add_3_result_o)
    );
    fp_add add_4 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_4),
        .tag_i      (add_tag_4_i),
        .a_i        (add_a_4),
        .b_i        (add_b_4),
        .subtract_i (add_subtract_4),
        .valid_o    (add_4_valid_o),
        .tag_o      (add_4_tag_o),
        .result_o   (add_4_result_o)
    );
    fp_add add_5 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_5),
        .tag_i      (add_tag_5_i),
        .a_i        (add_a_5),
        .b_i        (add_b_5),
        .subtract_i (add_subtract_5),
        .valid_o    (add_5_valid_o),
        .tag_o      (add_5_tag_o),
        .result_o   (add_5_result_o)
    );
    fp_add add_6 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_6_i),
        .tag_i      (add_tag_6_i),
        .a_i        (add_a_6_i),
        .b_i        (add_b_6_i),
        .subtract_i (add_subtract_6_i),
        .valid_o    (add_6_valid_o),
        .tag_o      (add_6_tag_o),
        .result_o   (add_6_result_o)
    );
    fp_add add_7 (
        .clk_i      (clk_i),
        .en_i       (en_i),
        .valid_i    (add_valid_7_i),
        .tag_i      (add_tag_7_i),
        .a_i        (add_a_7_i),
        .b_i        (add_b_7_i),
        .subtract_i (add_subtract_7_i),
        .valid_o    (add_7_valid_o),
        .tag_o      (add_7_tag_o),
        .result_o   (add_7_result_o)
    );
    fp_mul mul_0 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_0),
        .tag_i    (mul_tag_0_i),
        .a_i      (mul_a_0),
        .b_i      (mul_b_0),
        .valid_o  (mul_0_valid_o),
        .tag_o    (mul_0_tag_o),
        .result_o (mul_0_result_o)
    );
    fp_mul mul_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_1),
        .tag_i    (mul_tag_1_i),
        .a_i      (mul_a_1),
        .b_i      (mul_b_1),
        .valid_o  (mul_1_valid_o),
        .tag_o    (mul_1_tag_o),
        .result_o (mul_1_result_o)
    );
    fp_mul mul_2 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_2),
        .tag_i    (mul_tag_2_i),
        .a_i      (mul_a_2),
        .b_i      (mul_b_2),
        .valid_o  (mul_2_valid_o),
        .tag_o    (mul_2_tag_o),
        .result_o (mul_2_result_o)
    );
    fp_mul mul_3 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_3),
        .tag_i    (mul_tag_3_i),
        .a_i      (mul_a_3),
        .b_i      (mul_b_3),
        .valid_o  (mul_3_valid_o),
        .tag_o    (mul_3_tag_o),
        .result_o (mul_3_result_o)
    );
    fp_mul mul_4 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_4),
        .tag_i    (mul_tag_4_i),
        .a_i      (mul_a_4),
        .b_i      (mul_b_4),
        .valid_o  (mul_4_valid_o),
        .tag_o    (mul_4_tag_o),
        .result_o (mul_4_result_o)
    );
    fp_mul mul_5 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_5),
        .tag_i    (mul_tag_5_i),
        .a_i      (mul_a_5),
        .b_i      (mul_b_5),
        .valid_o  (mul_5_valid_o),
        .tag_o    (mul_5_tag_o),
        .result_o (mul_5_result_o)
    );
    fp_mul mul_6 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_6_i),
        .tag_i    (mul_tag_6_i),
        .a_i      (mul_a_6_i),
        .b_i      (mul_b_6_i),
        .valid_o  (mul_6_valid_o),
        .tag_o    (mul_6_tag_o),
        .result_o (mul_6_result_o)
    );
    fp_mul mul_7 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .valid_i  (mul_valid_7_i),
        .tag_i    (mul_tag_7_i),
        .a_i      (mul_a_7_i),
        .b_i      (mul_b_7_i),
        .valid_o  (mul_7_valid_o),
        .tag_o    (mul_7_tag_o),
        .result_o (mul_7_result_o)
    );
    ray_box_select box_select (
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
        .inv_0_o       (box_select_inv_0_o),
        .inv_1_o       (box_select_inv_1_o),
        .inv_2_o       (box_select_inv_2_o),
        .inv_3_o       (box_select_inv_3_o),
        .inv_4_o       (box_select_inv_4_o),
        .inv_5_o       (box_select_inv_5_o),
        .t_min_o       (box_select_t_min_o),
        .t_max_o       (box_select_t_max_o)
    );
    ray_box_fold box_fold (
        .clk_i     (clk_i),
        .en_i      (en_i),
        .valid_i   (mul_0_valid_o & ray_box),
        .t_0_i     (mul_0_result_o),
        .t_1_i     (mul_1_result_o),
        .t_2_i     (mul_2_result_o),
        .t_3_i     (mul_3_result_o),
        .t_4_i     (mul_4_result_o),
        .t_5_i     (mul_5_result_o),
        .t_min_i   (box_select_t_min_o),
        .t_max_i   (box_select_t_max_o),
        .valid_o   (box_fold_valid_o),
        .hit_o     (box_fold_hit_o),
        .t_entry_o (box_fold_t_entry_o)
    );
    dual_split_select node_select (
        .clk_i         (clk_i),
        .en_i          (en_i),
        .valid_i       (valid_i & dual_split),
        .header_i      (header_i),
        .plane_0_i     (plane_0_i),
        .plane_1_i     (plane_1_i),
        .origin_x_i    (origin_x_i),
        .origin_y_i    (origin_y_i),
        .origin_z_i    (origin_z_i),
        .inv_entry_x_i (inv_entry_x_i),
        .inv_entry_y_i (inv_entry_y_i),
        .inv_entry_z_i (inv_entry_z_i),
        .inv_exit_x_i  (inv_exit_x_i),
        .inv_exit_y_i  (inv_exit_y_i),
        .inv_exit_z_i  (inv_exit_z_i),
        .t_min_i       (t_min_i),
        .t_max_i       (t_max_i),
        .valid_o       (node_select_valid_o),
        .plane_0_o     (node_select_plane_0_o),
        .plane_1_o     (node_select_plane_1_o),
        .origin_0_o    (node_select_origin_0_o),
        .origin_1_o    (node_select_origin_1_o),
        .inv_0_o       (node_select_inv_0_o),
        .inv_1_o       (node_select_inv_1_o),
        .t_min_o       (node_select_t_min_o),
        .t_max_o       (node_select_t_max_o),
        .header_o      (node_select_header_o),
        .exit_0_o      (node_select_exit_0_o),
        .exit_1_o      (node_select_exit_1_o)
    );
    dual_split_fold node_fold (
        .clk_i         (clk_i),
        .en_i          (en_i),
        .valid_i       (mul_0_valid_o & dual_split),
        .t_0_i         (mul_0_result_o),
        .t_1_i         (mul_1_result_o),
        .exit_0_i      (node_select_exit_0_o),
        .exit_1_i      (node_select_exit_1_o),
        .header_i      (node_select_header_o),
        .t_min_i       (node_select_t_min_o),
        .t_max_i       (node_select_t_max_o),
        .valid_o       (node_fold_valid_o),
        .code_o        (node_fold_code_o),
        .near_offset_o (node_fold_near_offset_o),
        .near_t_min_o  (node_fold_near_t_min_o),
        .near_t_max_o  (node_fold_near_t_max_o),
        .far_offset_o  (node_fold_far_offset_o),
        .far_t_min_o   (node_fold_far_t_min_o),
        .far_t_max_o   (node_fold_far_t_max_o)
    );
    delay_v6 tag (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (tag_i),
        .q_o   (tag_q_o)
    );

    // Outputs
    assign add_valid_0_o = add_0_valid_o & n174;
    assign add_valid_1_o = add_1_valid_o & n174;
    assign add_valid_2_o = add_2_valid_o & n87;
    assign add_valid_3_o = add_3_valid_o & n87;
    assign add_valid_4_o = add_4_valid_o & n87;
    assign add_valid_5_o = add_5_valid_o & n87;
    assign add_valid_6_o = add_6_valid_o;
    assign add_valid_7_o = add_7_valid_o;
    assign add_tag_0_o = add_0_tag_o;
    assign add_tag_1_o = add_1_tag_o;
    assign add_tag_2_o = add_2_tag_o;
    assign add_tag_3_o = add_3_tag_o;
    assign add_tag_4_o = add_4_tag_o;
    assign add_tag_5_o = add_5_tag_o;
    assign add_tag_6_o = add_6_tag_o;
    assign add_tag_7_o = add_7_tag_o;
    assign add_result_0_o = add_0_result_o;
    assign add_result_1_o = add_1_result_o;
    assign add_result_2_o = add_2_result_o;
    assign add_result_3_o = add_3_result_o;
    assign add_result_4_o = add_4_result_o;
    assign add_result_5_o = add_5_result_o;
    assign add_result_6_o = add_6_result_o;
    assign add_result_7_o = add_7_result_o;
    assign mul_valid_0_o = mul_0_valid_o & n174;
    assign mul_valid_1_o = mul_1_valid_o & n174;
    assign mul_valid_2_o = mul_2_valid_o & n87;
    assign mul_valid_3_o = mul_3_valid_o & n87;
    assign mul_valid_4_o = mul_4_valid_o & n87;
    assign mul_valid_5_o = mul_5_valid_o & n87;
    assign mul_valid_6_o = mul_6_valid_o;
    assign mul_valid_7_o = mul_7_valid_o;
    assign mul_tag_0_o = mul_0_tag_o;
    assign mul_tag_1_o = mul_1_tag_o;
    assign mul_tag_2_o = mul_2_tag_o;
    assign mul_tag_3_o = mul_3_tag_o;
    assign mul_tag_4_o = mul_4_tag_o;
    assign mul_tag_5_o = mul_5_tag_o;
    assign mul_tag_6_o = mul_6_tag_o;
    assign mul_tag_7_o = mul_7_tag_o;
    assign mul_result_0_o = mul_0_result_o;
    assign mul_result_1_o = mul_1_result_o;
    assign mul_result_2_o = mul_2_result_o;
    assign mul_result_3_o = mul_3_result_o;
    assign mul_result_4_o = mul_4_result_o;
    assign mul_result_5_o = mul_5_result_o;
    assign mul_result_6_o = mul_6_result_o;
    assign mul_result_7_o = mul_7_result_o;
    assign tag_o = tag_q_o;
    assign node_valid_o = node_fold_valid_o;
    assign code_o = node_fold_code_o;
    assign near_offset_o = node_fold_near_offset_o;
    assign near_t_min_o = node_fold_near_t_min_o;
    assign near_t_max_o = node_fold_near_t_max_o;
    assign far_offset_o = node_fold_far_offset_o;
    assign far_t_min_o = node_fold_far_t_min_o;
    assign far_t_max_o = node_fold_far_t_max_o;
    assign box_valid_o = box_fold_valid_o;
    assign hit_o = box_fold_hit_o;
    assign t_entry_o = box_fold_t_entry_o;
endmodule

`default_nettype wire
