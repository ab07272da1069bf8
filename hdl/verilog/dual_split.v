// dual_split: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none
// One file holds the whole hierarchy of its top:
// verilator lint_off DECLFILENAME

// dual_split_node_header_v1: node_header
//   constant carve_index = 8'h1f
//   constant leaf_index = 8'h1a
//   constant kind_index = 8'h1d
//   constant size_index = 8'h1b
//   constant offset_mask = 32'h3ffffff
//
// Cuts a dual-split node's first word into its fields, where `golden::dst::header` puts them.
module dual_split_node_header_v1 (
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

// dual_split_ray_select: ray_select w32
//   constant sign_index = 8'h1f
//
// Picks the components of a ray that one plane of a node is tested with.
//
// The sign bit of the entry reciprocal says on which side of a box the ray enters: if it is set, the ray runs towards
// smaller coordinates and leaves through a box's min side. A plane is thus an exit if that bit equals the plane's
// side, and its role picks one of the axis' two reciprocals.
module dual_split_ray_select (
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
    wire inv_exit_2_if = axis_i == 2'd0;
    wire [31:0] origin_2 = inv_exit_2_if ? origin_x_i : origin_z_i;
    wire [31:0] inv_entry_2 = inv_exit_2_if ? inv_entry_x_i : inv_entry_z_i;
    wire [31:0] inv_exit_2 = inv_exit_2_if ? inv_exit_x_i : inv_exit_z_i;
    wire inv_exit_if = axis_i == 2'd1;
    wire [31:0] origin = inv_exit_if ? origin_y_i : origin_2;
    wire [31:0] inv_entry = inv_exit_if ? inv_entry_y_i : inv_entry_2;
    wire [31:0] inv_exit = inv_exit_if ? inv_exit_y_i : inv_exit_2;
    wire negative = inv_entry[31];
    wire leaving = negative == min_side_i;
    wire [31:0] inv = leaving ? inv_exit : inv_entry;

    // Outputs
    assign origin_o = origin;
    assign inv_o = inv;
    assign inv_entry_o = inv_entry;
    assign negative_o = negative;
endmodule

// dual_split_fp_cmp_v1: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
//   tied input b_i = 32'd0
//
// Floating-point comparison.
//
// Sign-magnitude words compare like unsigned integers, except that a negative operand reverses the outcome. Let `u`
// be `a < b` on the words as unsigned integers. If both signs are clear, `a < b` is `u`; if both are set, it is the
// reverse, `!u` (for `a != b`); if only `a` is negative, its word is the larger one, so that `u = 0` and again `!u` is
// right; if only `b` is negative, `u = 1`, and `!u` is right. Hence `a < b` is `u` xor `(sign_a | sign_b)` wherever the
// operands differ.
module dual_split_fp_cmp_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    output wire        lt_o
);

    // Registers
    reg lt;

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

// dual_split_delay_v1: delay w32_n3
//
// Delay line: a value that has to wait for a unit's result.
module dual_split_delay_v1 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] d_i,
    output wire [31:0] q_o
);

    // Registers
    reg [31:0] stage_0;
    reg [31:0] stage_1;
    reg [31:0] stage_2;

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

// dual_split_delay_v2: delay w1_n4
module dual_split_delay_v2 (
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

// dual_split_delay_v3: delay w32_n5
module dual_split_delay_v3 (
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

// dual_split_select: dual_split_select e8m23_c2
//   constant single_code = 2'd2
//
// First stage of the dual-split pipeline: decodes a node and selects what its two planes are tested with.
//
// All node types become two plane tests. Plane 0 and plane 1 have an axis and a side each; the side says whether the
// plane bounds a box from below (its min side):
//
// | node | axis of plane 0, 1 | min side of plane 0, 1 |
// |---|---|---|
// | split | bits 30:29, both | 0, 1 |
// | single carve | bits 28:27, both | 0, 1 |
// | dual carve | bit 30; bit 29 + 1 | bit 28; bit 27 |
//
// In a split, the left child's max plane is the exit of the near child if the ray runs upwards, and the entry of the
// far child if it runs downwards; that is the rule of a single carve, so that both decode alike. For a bare leaf the
// result of the tests is ignored.
//
// With `C = 2`, two comparators tell whether each ray component runs downwards, as in the published unit. IEEE
// comparison cannot see the sign of a zero or of a NaN, which the sign bit supplies, and as that bit alone
// suffices, `C = 0` drops both comparators with equal results.
module dual_split_select (
    input  wire        clk_i,
    input  wire        rst_ni,
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
    reg valid;
    reg [31:0] plane_0;
    reg [31:0] plane_1;
    reg [31:0] origin_0;
    reg [31:0] origin_1;
    reg negative_0;
    reg negative_1;
    reg side_0;
    reg side_1;

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
    // Cycle 1: decode.
    wire dual = fields_carve_o & (fields_kind_o != 2'd2);
    wire [1:0] axis_0_2 = fields_carve_o ? fields_size_o : fields_kind_o;
    wire [1:0] axis_0 = dual ? {1'b0, fields_kind_o[1]} : axis_0_2;
    wire [1:0] axis_1 = dual ? (fields_kind_o[0] ? 2'd2 : 2'd1) : axis_0_2;
    wire min_side_0 = dual & fields_size_o[1];
    wire min_side_1 = ~dual | fields_size_o[0];
    // Select and register.
    wire runs_down_0 = role_0_lt_o | negative_0;
    wire runs_down_1 = role_1_lt_o | negative_1;
    // Operands wait for the stage that needs them.
    wire leaving_0 = runs_down_0 == side_0;
    wire leaving_1 = runs_down_1 == side_1;

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
    // Cycle 1: decode.
    dual_split_node_header_v1 fields (
        .header_i (header_i),
        .carve_o  (fields_carve_o),
        .kind_o   (fields_kind_o),
        .size_o   (fields_size_o)
    );
    // Select and register.
    dual_split_ray_select select_0 (
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
    dual_split_ray_select select_1 (
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
    dual_split_fp_cmp_v1 role_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (select_0_inv_entry_o),
        .lt_o  (role_0_lt_o)
    );
    dual_split_fp_cmp_v1 role_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (select_1_inv_entry_o),
        .lt_o  (role_1_lt_o)
    );
    // Operands wait for the stage that needs them.
    dual_split_delay_v1 inv_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (select_0_inv_o),
        .q_o   (inv_wait_0_q_o)
    );
    dual_split_delay_v1 inv_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (select_1_inv_o),
        .q_o   (inv_wait_1_q_o)
    );
    dual_split_delay_v2 exit_wait_0 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (leaving_0),
        .q_o   (exit_wait_0_q_o)
    );
    dual_split_delay_v2 exit_wait_1 (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (leaving_1),
        .q_o   (exit_wait_1_q_o)
    );
    dual_split_delay_v3 header_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (header_i),
        .q_o   (header_wait_q_o)
    );
    dual_split_delay_v3 t_min_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (t_min_i),
        .q_o   (t_min_wait_q_o)
    );
    dual_split_delay_v3 t_max_wait (
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

// dual_split_fp_unpack: fp_unpack e8m23
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
module dual_split_fp_unpack (
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

// dual_split_sticky_shift_v1: sticky_shift w28_a8
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
module dual_split_sticky_shift_v1 (
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

// dual_split_rounder: rounder e8m23
//   constant leading_index = 8'h19
//   constant fraction_mask = 26'h7fffff
//   constant fraction_bits = 8'h17
//   constant special_exponent = 10'hff
//   constant max_finite = 32'h7f7fffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   constant sign_bit = 32'h80000000
//   tied input rounding_i = 3'd0
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
module dual_split_rounder (
    input  wire        sign_i,
    input  wire [9:0]  exponent_i,
    input  wire [25:0] significand_i,
    input  wire        nan_i,
    input  wire        infinity_i,
    output wire [31:0] result_o
);

    // Logic
    // Direction.
    wire leading = significand_i[25];
    // Packing and increment.
    wire [25:0] fraction_1 = {2'd0, significand_i[25:2]};
    wire increment = significand_i[1] & (significand_i[0] | significand_i[2]);
    wire [25:0] fraction = fraction_1 & 26'h7fffff;
    wire [31:0] field_2 = leading ? {22'd0, exponent_i} : 32'd0;
    wire [31:0] field = {field_2[8:0], 23'd0};
    wire [31:0] encoded = field | {6'd0, fraction};
    wire [31:0] magnitude_2 = increment ? (encoded + 32'd1) : encoded;
    // Results outside the normal range.
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

// dual_split_fp_add_v1: fp_add e8m23_t1
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
//   tied input tag_i = 1'b0
//   tied input subtract_i = 1'b1
//   tied input rounding_i = 3'd0
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
module dual_split_fp_add_v1 (
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
    reg zero_sign;
    reg [7:0] exponent;
    reg [27:0] sum;
    reg valid_2;
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
    wire sign_b = ~b_sign_o;
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
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            zero_sign <= ~differ & high_sign;
            exponent <= high_exponent;
            sum <= total;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by magnitude.
    dual_split_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    // Align and add.
    dual_split_sticky_shift_v1 align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (high_exponent - low_exponent),
        .result_o (align_result_o)
    );
    // Round.
    dual_split_rounder rounder (
        .sign_i        (result_sign),
        .exponent_i    (raw_exponent + 10'd1),
        .significand_i (raw_significand[25:0]),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, raw_significand[27:26]};
endmodule

// dual_split_fp_add_v2: fp_add e8m23_t1
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
//   tied input tag_i = 1'b0
//   tied input subtract_i = 1'b1
//   tied input rounding_i = 3'd0
module dual_split_fp_add_v2 (
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
    reg zero_sign;
    reg [7:0] exponent;
    reg [27:0] sum;
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
    wire sign_b = ~b_sign_o;
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
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | ((a_infinity_o & b_infinity_o) & differ);
            infinity <= a_infinity_o | b_infinity_o;
            sign <= high_sign;
            zero_sign <= ~differ & high_sign;
            exponent <= high_exponent;
            sum <= total;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: order the operands by magnitude.
    dual_split_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    // Align and add.
    dual_split_sticky_shift_v1 align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (high_exponent - low_exponent),
        .result_o (align_result_o)
    );
    // Round.
    dual_split_rounder rounder (
        .sign_i        (result_sign),
        .exponent_i    (raw_exponent + 10'd1),
        .significand_i (raw_significand[25:0]),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, raw_significand[27:26]};
endmodule

// dual_split_significand_product: significand_product w24
//
// The multiplier array: product of two significands.
//
// With `a = a_h * 2^16 + a_l` and `b` likewise, `a * b = a_h b_h * 2^32 + (a_h b_l + a_l b_h) * 2^16 + a_l b_l`; each
// partial product is one of `rust-hdl`'s 16 x 16 bits. A significand of 16 bits or fewer has no high part, and
// three of the four products fold away.
//
// A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier.
module dual_split_significand_product (
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

// dual_split_leading_zeros: leading_zeros w24_x10
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
module dual_split_leading_zeros (
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

// dual_split_sticky_shift_v2: sticky_shift w26_a8
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
module dual_split_sticky_shift_v2 (
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

// dual_split_fp_mul_v1: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant top_index = 8'h2f
//   constant high_offset = 8'h16
//   constant low_mask = 48'h3fffff
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
module dual_split_fp_mul_v1 (
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
    reg [9:0] left;
    reg [7:0] right;
    reg [47:0] product;
    reg valid_2;
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
            nan <= (a_nan_o | b_nan_o) | (infinite_factor & zero_factor);
            infinity <= infinite_factor;
            sign <= a_sign_o ^ b_sign_o;
            exponent <= start_exponent;
            left <= left_amount;
            right <= right_amount;
            product <= array_product_o;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply.
    dual_split_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    dual_split_significand_product array (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    dual_split_leading_zeros zeros_a (
        .value_i (a_significand_o),
        .count_o (zeros_a_count_o)
    );
    dual_split_leading_zeros zeros_b (
        .value_i (b_significand_o),
        .count_o (zeros_b_count_o)
    );
    // Cycle 2: shift.
    dual_split_sticky_shift_v2 denormalise (
        .value_i  (raw_significand),
        .amount_i (right),
        .result_o (denormalise_result_o)
    );
    // Round.
    dual_split_rounder rounder (
        .sign_i        (sign),
        .exponent_i    (raw_exponent),
        .significand_i (denormalise_result_o),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign valid_o = valid_2;
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, shortfall[9:8]};
endmodule

// dual_split_fp_mul_v2: fp_mul e8m23_t1
//   constant bias = 10'h7e
//   constant sign_index = 8'd9
//   constant top_index = 8'h2f
//   constant high_offset = 8'h16
//   constant low_mask = 48'h3fffff
//   tied input tag_i = 1'b0
//   tied input rounding_i = 3'd0
module dual_split_fp_mul_v2 (
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
    reg [9:0] left;
    reg [7:0] right;
    reg [47:0] product;
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
    always @(posedge clk_i) begin
        if (en_i) begin
            nan <= (a_nan_o | b_nan_o) | (infinite_factor & zero_factor);
            infinity <= infinite_factor;
            sign <= a_sign_o ^ b_sign_o;
            exponent <= start_exponent;
            left <= left_amount;
            right <= right_amount;
            product <= array_product_o;
            result <= rounder_result_o;
        end
    end

    // Instances
    // Cycle 1: multiply.
    dual_split_fp_unpack a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    dual_split_significand_product array (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    dual_split_leading_zeros zeros_a (
        .value_i (a_significand_o),
        .count_o (zeros_a_count_o)
    );
    dual_split_leading_zeros zeros_b (
        .value_i (b_significand_o),
        .count_o (zeros_b_count_o)
    );
    // Cycle 2: shift.
    dual_split_sticky_shift_v2 denormalise (
        .value_i  (raw_significand),
        .amount_i (right),
        .result_o (denormalise_result_o)
    );
    // Round.
    dual_split_rounder rounder (
        .sign_i        (sign),
        .exponent_i    (raw_exponent),
        .significand_i (denormalise_result_o),
        .nan_i         (nan),
        .infinity_i    (infinity),
        .result_o      (rounder_result_o)
    );

    // Outputs
    assign result_o = result;

    // Bits that nothing reads
    wire unused = &{1'b0, shortfall[9:8]};
endmodule

// dual_split_fp_min_max_v1: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input propagate_nan_i = 1'b0
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
module dual_split_fp_min_max_v1 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    input  wire        maximum_i,
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
    wire choose_a_part = (magnitude_a <= 32'h7f800000) & ((below ^ any_negative) ^ maximum_i);
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

// dual_split_fp_min_max_v2: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b1
//   tied input propagate_nan_i = 1'b0
module dual_split_fp_min_max_v2 (
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

// dual_split_fp_min_max_v3: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
//   tied input tag_i = 1'b0
//   tied input maximum_i = 1'b0
//   tied input propagate_nan_i = 1'b0
module dual_split_fp_min_max_v3 (
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

// dual_split_delay_v4: delay w32_n2
module dual_split_delay_v4 (
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

// dual_split_delay_v5: delay w1_n3
module dual_split_delay_v5 (
    input  wire clk_i,
    input  wire en_i,
    input  wire d_i,
    output wire q_o
);

    // Registers
    reg stage_0;
    reg stage_1;
    reg stage_2;

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

// dual_split_fp_cmp_v2: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module dual_split_fp_cmp_v2 (
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

// dual_split_fp_cmp_v3: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   tied input tag_i = 1'b0
module dual_split_fp_cmp_v3 (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        le_o
);

    // Registers
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
    always @(posedge clk_i) begin
        if (en_i) begin
            le <= ordered & (less | equal);
        end
    end

    // Outputs
    assign le_o = le;
endmodule

// dual_split_int_add: int_add w32_t1
//   tied input tag_i = 1'b0
//
// Integer adder: forms the second child's offset.
module dual_split_int_add (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] sum_o
);

    // Registers
    reg [31:0] sum;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            sum <= a_i + b_i;
        end
    end

    // Outputs
    assign sum_o = sum;
endmodule

// dual_split_node_header_v2: node_header
//   constant carve_index = 8'h1f
//   constant leaf_index = 8'h1a
//   constant kind_index = 8'h1d
//   constant size_index = 8'h1b
//   constant offset_mask = 32'h3ffffff
module dual_split_node_header_v2 (
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

// dual_split_fold: dual_split_fold e8m23
//
// Last three stages of the dual-split pipeline: folds the plane distances into the interval, compares, forms the
// offsets and selects the return value.
//
// | cycle | work |
// |---|---|
// | 6 | route the distances by role; combine two exits (minimum) or two entries (maximum) of a dual carve |
// | 7 | `lower = max(t_min, entry)`, `upper = min(t_max, exit)` |
// | 8 | near child: `t_min <= upper`; carve: `lower <= upper`; far child: `lower <= t_max`; second offset |
//
// The comparators' registers end cycle 8; behind them, one 2:1 multiplexer selects each output.
//
// | node | code | near slot | far slot |
// |---|---|---|---|
// | split, both accepted | 2 | near child, `t_min..upper` | far child, `lower..t_max` |
// | split, near accepted | 1 | near child, `t_min..upper` | |
// | split, far accepted | 1 | far child, `lower..t_max` | |
// | carve, `lower <= upper` | 1, or 3 with the leaf bit | child or triangle, `lower..upper` | |
// | bare leaf | 3 | triangle, `t_min..t_max` | |
// | otherwise | 0 | | |
//
// A slot without entry, and the far slot of every code but 2, holds some value that means nothing.
module dual_split_fold (
    input  wire        clk_i,
    input  wire        rst_ni,
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
    reg [31:0] exit_t;
    reg [31:0] entry_t;
    reg two_exits;
    reg two_entries;
    reg [31:0] t_min_6;
    reg [31:0] t_max_6;
    reg [31:0] t_min_7;
    reg [31:0] t_max_7;
    reg [31:0] first_offset;
    reg carve;
    reg leaf;
    reg [31:0] lower;
    reg [31:0] upper;
    reg [31:0] t_min_8;
    reg [31:0] t_max_8;

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
    // Cycle 7: fold.
    wire runs_down = ~exit_0_i;
    // Cycle 6: a bound that no plane moves is folded with itself.
    wire [31:0] route_exit = exit_0_i ? t_0_i : (exit_1_i ? t_1_i : t_max_i);
    wire [31:0] route_entry = exit_0_i ? (exit_1_i ? t_min_i : t_1_i) : t_0_i;
    wire [31:0] latest_entry = two_entries ? combine_result_o : entry_t;
    wire [31:0] earliest_exit = two_exits ? combine_result_o : exit_t;
    // Cycle 8: compare, and add the size of the left child to its offset.
    wire [31:0] near_start = fields_carve_o ? fold_entry_result_o : t_min_7;
    wire code_part = ~carve;
    // Output selection.
    wire is_split = code_part & ~leaf;
    wire [1:0] code_part_2 = (accept_near_le_o & accept_far_le_o) ? 2'd2 : ((accept_near_le_o | accept_far_le_o) ? 2'd1 : 2'd0);
    wire [1:0] code_part_3 = leaf ? ((code_part | accept_near_le_o) ? 2'd3 : 2'd0) : (accept_near_le_o ? 2'd1 : 2'd0);
    wire [1:0] code = is_split ? code_part_2 : code_part_3;
    // A ray that runs downwards meets the right child, which has the second offset, first.
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
    // Cycle 6: a bound that no plane moves is folded with itself.
    dual_split_fp_min_max_v1 combine (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .en_i      (en_i),
        .valid_i   (valid_i),
        .a_i       (t_0_i),
        .b_i       (t_1_i),
        .maximum_i (runs_down),
        .valid_o   (combine_valid_o),
        .result_o  (combine_result_o)
    );
    // Cycle 7: fold.
    dual_split_fp_min_max_v2 fold_entry (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (combine_valid_o),
        .a_i      (t_min_6),
        .b_i      (latest_entry),
        .valid_o  (fold_entry_valid_o),
        .result_o (fold_entry_result_o)
    );
    dual_split_fp_min_max_v3 fold_exit (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (t_max_6),
        .b_i      (earliest_exit),
        .result_o (fold_exit_result_o)
    );
    dual_split_delay_v4 header_wait (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (header_i),
        .q_o   (header_wait_q_o)
    );
    dual_split_delay_v5 downward (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (runs_down),
        .q_o   (downward_q_o)
    );
    // Cycle 8: compare, and add the size of the left child to its offset.
    dual_split_fp_cmp_v2 accept_near (
        .clk_i   (clk_i),
        .rst_ni  (rst_ni),
        .en_i    (en_i),
        .valid_i (fold_entry_valid_o),
        .a_i     (near_start),
        .b_i     (fold_exit_result_o),
        .valid_o (accept_near_valid_o),
        .le_o    (accept_near_le_o)
    );
    dual_split_fp_cmp_v3 accept_far (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (fold_entry_result_o),
        .b_i   (t_max_7),
        .le_o  (accept_far_le_o)
    );
    dual_split_int_add second_offset (
        .clk_i (clk_i),
        .en_i  (en_i),
        .a_i   (fields_offset_o),
        .b_i   ({30'd0, fields_size_o}),
        .sum_o (second_offset_sum_o)
    );
    dual_split_node_header_v2 fields (
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

// dual_split_delay_v6: delay w1_n8
module dual_split_delay_v6 (
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

// dual_split: dual_split e8m23_c2_t1
//
// The dual-split pipeline: one step of dual-split-tree traversal per cycle.
//
// The distance to each of a node's two planes is `t = (plane - origin[axis]) * inv[axis]`, with the reciprocal of the
// plane's role (exit or entry), every operation rounded to nearest even and none fused. All node types flow through
// the same units; multiplexers select operands and results, and nothing branches. What a step computes bit for
// bit is stated by `golden::dst::step()`.
//
// | cycle | work | units |
// |---|---|---|
// | 1 | decode, ray-component and plane selection | (2 FPCMP with `C = 2`) |
// | 2, 3 | `plane - origin` | 2 FPADD |
// | 4, 5 | `* inv` | 2 FPMUL |
// | 6 | combine two exits or two entries | 1 FPMIN/MAX |
// | 7 | fold into the interval | 2 FPMIN/MAX |
// | 8 | compare, second offset, return value | 2 FPCMP, 1 INTADD |
//
// `C = 2` is the inventory of Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split Trees", HPG 2020:
// 1 INTADD, 2 FPADD, 2 FPMUL, 3 FPMIN/MAX, 4 FPCMP in 8 cycles. `C = 0` leaves out the two comparators that the sign bits
// make redundant (see `DualSplitSelect`); its outputs are the same for every input.
//
// | `code_o` | meaning | near slot | far slot |
// |---|---|---|---|
// | 0 | miss | | |
// | 1 | one child | the child | |
// | 2 | two children | the nearer | the farther |
// | 3 | leaf | first triangle | |
module dual_split (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
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
    output wire        tag_o,
    output wire [1:0]  code_o,
    output wire [31:0] near_offset_o,
    output wire [31:0] near_t_min_o,
    output wire [31:0] near_t_max_o,
    output wire [31:0] far_offset_o,
    output wire [31:0] far_t_min_o,
    output wire [31:0] far_t_max_o
);

    // Outputs of instances
    wire select_valid_o;
    wire [31:0] select_plane_0_o;
    wire [31:0] select_origin_0_o;
    wire subtract_0_valid_o;
    wire [31:0] subtract_0_result_o;
    wire [31:0] select_inv_0_o;
    wire [31:0] select_plane_1_o;
    wire [31:0] select_origin_1_o;
    wire [31:0] subtract_1_result_o;
    wire [31:0] select_inv_1_o;
    wire multiply_0_valid_o;
    wire [31:0] multiply_0_result_o;
    wire [31:0] multiply_1_result_o;
    wire select_exit_0_o;
    wire select_exit_1_o;
    wire [31:0] select_header_o;
    wire [31:0] select_t_min_o;
    wire [31:0] select_t_max_o;
    wire fold_valid_o;
    wire tag_q_o;
    wire [1:0] fold_code_o;
    wire [31:0] fold_near_offset_o;
    wire [31:0] fold_near_t_min_o;
    wire [31:0] fold_near_t_max_o;
    wire [31:0] fold_far_offset_o;
    wire [31:0] fold_far_t_min_o;
    wire [31:0] fold_far_t_max_o;

    // Instances
    // Cycle 1: decode and select.
    dual_split_select select (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .en_i          (en_i),
        .valid_i       (valid_i),
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
        .valid_o       (select_valid_o),
        .plane_0_o     (select_plane_0_o),
        .plane_1_o     (select_plane_1_o),
        .origin_0_o    (select_origin_0_o),
        .origin_1_o    (select_origin_1_o),
        .inv_0_o       (select_inv_0_o),
        .inv_1_o       (select_inv_1_o),
        .t_min_o       (select_t_min_o),
        .t_max_o       (select_t_max_o),
        .header_o      (select_header_o),
        .exit_0_o      (select_exit_0_o),
        .exit_1_o      (select_exit_1_o)
    );
    // Cycles 2 to 5: distances.
    dual_split_fp_add_v1 subtract_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (select_valid_o),
        .a_i      (select_plane_0_o),
        .b_i      (select_origin_0_o),
        .valid_o  (subtract_0_valid_o),
        .result_o (subtract_0_result_o)
    );
    dual_split_fp_add_v2 subtract_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (select_plane_1_o),
        .b_i      (select_origin_1_o),
        .result_o (subtract_1_result_o)
    );
    dual_split_fp_mul_v1 multiply_0 (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .en_i     (en_i),
        .valid_i  (subtract_0_valid_o),
        .a_i      (subtract_0_result_o),
        .b_i      (select_inv_0_o),
        .valid_o  (multiply_0_valid_o),
        .result_o (multiply_0_result_o)
    );
    dual_split_fp_mul_v2 multiply_1 (
        .clk_i    (clk_i),
        .en_i     (en_i),
        .a_i      (subtract_1_result_o),
        .b_i      (select_inv_1_o),
        .result_o (multiply_1_result_o)
    );
    // Cycles 6 to 8: fold, compare, return.
    dual_split_fold fold (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .en_i          (en_i),
        .valid_i       (multiply_0_valid_o),
        .t_0_i         (multiply_0_result_o),
        .t_1_i         (multiply_1_result_o),
        .exit_0_i      (select_exit_0_o),
        .exit_1_i      (select_exit_1_o),
        .header_i      (select_header_o),
        .t_min_i       (select_t_min_o),
        .t_max_i       (select_t_max_o),
        .valid_o       (fold_valid_o),
        .code_o        (fold_code_o),
        .near_offset_o (fold_near_offset_o),
        .near_t_min_o  (fold_near_t_min_o),
        .near_t_max_o  (fold_near_t_max_o),
        .far_offset_o  (fold_far_offset_o),
        .far_t_min_o   (fold_far_t_min_o),
        .far_t_max_o   (fold_far_t_max_o)
    );
    dual_split_delay_v6 tag (
        .clk_i (clk_i),
        .en_i  (en_i),
        .d_i   (tag_i),
        .q_o   (tag_q_o)
    );

    // Outputs
    assign valid_o = fold_valid_o;
    assign tag_o = tag_q_o;
    assign code_o = fold_code_o;
    assign near_offset_o = fold_near_offset_o;
    assign near_t_min_o = fold_near_t_min_o;
    assign near_t_max_o = fold_near_t_max_o;
    assign far_offset_o = fold_far_offset_o;
    assign far_t_min_o = fold_far_t_min_o;
    assign far_t_max_o = fold_far_t_max_o;
endmodule

`default_nettype wire
