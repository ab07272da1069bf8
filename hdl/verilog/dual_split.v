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

// dual_split_fp_unpack_v1: fp_unpack e8m23
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
module dual_split_fp_unpack_v1 (
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

// dual_split_sticky_shift: sticky_shift w28_a8
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
module dual_split_sticky_shift (
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

// dual_split_leading_zeros_v1: leading_zeros w26_x5
//   constant top_index = 8'h19
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
//
// Counts the zeros above the leading one.
module dual_split_leading_zeros_v1 (
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

// dual_split_rounder_v1: rounder e8m23
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
module dual_split_rounder_v1 (
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

// dual_split_fp_add_v1: fp_add e8m23_t1
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
    dual_split_fp_unpack_v1 a (
        .word_i             (a_i),
        .sign_o             (a_sign_o),
        .encoded_exponent_o (a_encoded_exponent_o),
        .exponent_o         (a_exponent_o),
        .significand_o      (a_significand_o),
        .nan_o              (a_nan_o),
        .infinity_o         (a_infinity_o)
    );
    dual_split_fp_unpack_v1 b (
        .word_i             (b_i),
        .sign_o             (b_sign_o),
        .encoded_exponent_o (b_encoded_exponent_o),
        .exponent_o         (b_exponent_o),
        .significand_o      (b_significand_o),
        .nan_o              (b_nan_o),
        .infinity_o         (b_infinity_o)
    );
    // Align and add; a difference is inverted.
    dual_split_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (distance),
        .result_o (align_result_o)
    );
    // The marker, and a one at the bottom, so that the count means something even for zero.
    dual_split_leading_zeros_v1 zeros (
        .value_i (ends),
        .count_o (zeros_count_o)
    );
    // Round.
    dual_split_rounder_v1 rounder (
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

// dual_split_fp_add_v2: fp_add e8m23_t1
//   constant top_bit = 26'h2000000
//   constant second_bit = 26'h1000000
//   constant top_index = 8'h1b
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
    dual_split_fp_unpack_v1 a (
        .word_i             (a_i),
        .sign_o             (a_sign_o),
        .encoded_exponent_o (a_encoded_exponent_o),
        .exponent_o         (a_exponent_o),
        .significand_o      (a_significand_o),
        .nan_o              (a_nan_o),
        .infinity_o         (a_infinity_o)
    );
    dual_split_fp_unpack_v1 b (
        .word_i             (b_i),
        .sign_o             (b_sign_o),
        .encoded_exponent_o (b_encoded_exponent_o),
        .exponent_o         (b_exponent_o),
        .significand_o      (b_significand_o),
        .nan_o              (b_nan_o),
        .infinity_o         (b_infinity_o)
    );
    // Align and add; a difference is inverted.
    dual_split_sticky_shift align (
        .value_i  ({1'b0, low_significand, 3'd0}),
        .amount_i (distance),
        .result_o (align_result_o)
    );
    // The marker, and a one at the bottom, so that the count means something even for zero.
    dual_split_leading_zeros_v1 zeros (
        .value_i (ends),
        .count_o (zeros_count_o)
    );
    // Round.
    dual_split_rounder_v1 rounder (
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

// dual_split_fp_unpack_v2: fp_unpack e8m23
//   constant sign_index = 8'h1f
//   constant fraction_bits = 8'h17
//   constant fraction_mask = 24'h7fffff
//   constant hidden_bit = 24'h800000
//   constant special_exponent = 8'hff
module dual_split_fp_unpack_v2 (
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

// dual_split_significand_product_v1: significand_product w24_lower
//
// The multiplier arrays: the product of a significand with one half of another.
//
// With `b = b_upper * 2^H + b_lower` and `H` half the bits, rounded up, `a * b = a b_upper * 2^H + a b_lower`. Either array has half
// the rows of a whole one, which is what fits in a cycle; whoever uses the two adds their products in the next.
//
// A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier. `rust-hdl`
// multiplies 16 by 16 bits only, so that this module has its kernel written twice: for simulation, and as the syntax tree
// that other kernels get from the macro.
module dual_split_significand_product_v1 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[11:0]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[23:12]};
endmodule

// dual_split_significand_product_v2: significand_product w24_upper
module dual_split_significand_product_v2 (
    input  wire [23:0] a_i,
    input  wire [23:0] b_i,
    output wire [47:0] product_o
);

    // Outputs
    assign product_o = {24'd0, a_i} * {24'd0, {12'd0, b_i[23:12]}};

    // Bits that nothing reads
    wire unused = &{1'b0, b_i[11:0]};
endmodule

// dual_split_leading_zeros_v2: leading_zeros w24_x5
//   constant top_index = 8'h17
//   constant distance_0 = 5'h10
//   constant distance_1 = 5'd8
//   constant distance_2 = 5'd4
//   constant distance_3 = 5'd2
//   constant distance_4 = 5'd1
module dual_split_leading_zeros_v2 (
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

// dual_split_rounder_v2: rounder e8m23
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
module dual_split_rounder_v2 (
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

// dual_split_fp_mul_v1: fp_mul e8m23_t1
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
    dual_split_fp_unpack_v2 a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack_v2 b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    dual_split_significand_product_v1 array_lower (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_lower_product_o)
    );
    dual_split_significand_product_v2 array_upper (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_upper_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    dual_split_leading_zeros_v2 leading (
        .value_i (subnormal),
        .count_o (leading_count_o)
    );
    // Round.
    dual_split_rounder_v2 rounder (
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

// dual_split_fp_mul_v2: fp_mul e8m23_t1
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
    dual_split_fp_unpack_v2 a (
        .word_i        (a_i),
        .sign_o        (a_sign_o),
        .exponent_o    (a_exponent_o),
        .significand_o (a_significand_o),
        .nan_o         (a_nan_o),
        .infinity_o    (a_infinity_o)
    );
    dual_split_fp_unpack_v2 b (
        .word_i        (b_i),
        .sign_o        (b_sign_o),
        .exponent_o    (b_exponent_o),
        .significand_o (b_significand_o),
        .nan_o         (b_nan_o),
        .infinity_o    (b_infinity_o)
    );
    dual_split_significand_product_v1 array_lower (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_lower_product_o)
    );
    dual_split_significand_product_v2 array_upper (
        .a_i       (a_significand_o),
        .b_i       (b_significand_o),
        .product_o (array_upper_product_o)
    );
    // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
    dual_split_leading_zeros_v2 leading (
        .value_i (subnormal),
        .count_o (leading_count_o)
    );
    // Round.
    dual_split_rounder_v2 rounder (
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
