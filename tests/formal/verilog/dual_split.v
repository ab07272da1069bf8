// One step of dual-split traversal, as the node format and the step are documented; binary32.
//
// The subtractions and multiplications are instances of `any_result`, whose result is any word at all. The proof
// therefore holds whatever these units compute from their operands. It shows that the operands are equal too.

module reference_dual_split (
    input  wire [31:0] header_i, plane_0_i, plane_1_i,
    input  wire [31:0] origin_x_i, origin_y_i, origin_z_i,
    input  wire [31:0] inv_entry_x_i, inv_entry_y_i, inv_entry_z_i,
    input  wire [31:0] inv_exit_x_i, inv_exit_y_i, inv_exit_z_i,
    input  wire [31:0] t_min_i, t_max_i,
    output reg  [1:0]  code_o,
    output reg  [31:0] near_offset_o, near_t_min_o, near_t_max_o,
    output reg  [31:0] far_offset_o, far_t_min_o, far_t_max_o
);
    `include "order.vh"

    function [31:0] component(input [1:0] axis, input [31:0] x, input [31:0] y, input [31:0] z);
        case (axis)
            2'd0: component = x;
            2'd1: component = y;
            default: component = z;
        endcase
    endfunction

    // The node.
    wire is_carve = header_i[31];
    wire [1:0] kind = header_i[30:29];
    wire [1:0] size = header_i[28:27];
    wire is_leaf = header_i[26];
    wire [31:0] offset = {6'd0, header_i[25:0]};
    reg [1:0] axis_0, axis_1;
    reg is_min_0, is_min_1;
    always @* begin
        {is_min_0, is_min_1} = 2'b01;
        if (!is_carve) {axis_0, axis_1} = {kind, kind};
        else if (kind == 2'd2) {axis_0, axis_1} = {size, size};
        else begin
            {is_min_0, is_min_1} = size;
            case (kind)
                2'd0: {axis_0, axis_1} = {2'd0, 2'd1};
                2'd1: {axis_0, axis_1} = {2'd0, 2'd2};
                default: {axis_0, axis_1} = {2'd1, 2'd2};
            endcase
        end
    end

    // Distances of the planes.
    wire [31:0] entry_0 = component(axis_0, inv_entry_x_i, inv_entry_y_i, inv_entry_z_i);
    wire [31:0] entry_1 = component(axis_1, inv_entry_x_i, inv_entry_y_i, inv_entry_z_i);
    wire [31:0] exit_0 = component(axis_0, inv_exit_x_i, inv_exit_y_i, inv_exit_z_i);
    wire [31:0] exit_1 = component(axis_1, inv_exit_x_i, inv_exit_y_i, inv_exit_z_i);
    wire leaves_0 = entry_0[31] == is_min_0;
    wire leaves_1 = entry_1[31] == is_min_1;
    wire [31:0] difference_0, difference_1, t_0, t_1;
    any_result subtract_0 (
        .a_i(plane_0_i), .b_i(component(axis_0, origin_x_i, origin_y_i, origin_z_i)), .result_o(difference_0)
    );
    any_result subtract_1 (
        .a_i(plane_1_i), .b_i(component(axis_1, origin_x_i, origin_y_i, origin_z_i)), .result_o(difference_1)
    );
    any_result multiply_0 (.a_i(difference_0), .b_i(leaves_0 ? exit_0 : entry_0), .result_o(t_0));
    any_result multiply_1 (.a_i(difference_1), .b_i(leaves_1 ? exit_1 : entry_1), .result_o(t_1));

    // The step.
    reg [31:0] lower, upper;
    reg near, far;
    wire downward = entry_0[31];
    always @* begin
        lower = t_min_i;
        upper = t_max_i;
        {near_offset_o, near_t_min_o, near_t_max_o} = {offset, t_min_i, t_max_i};
        {far_offset_o, far_t_min_o, far_t_max_o} = {offset, t_min_i, t_max_i};
        near = 1'b0;
        far = 1'b0;
        if (is_carve) begin
            if (leaves_0) upper = minimum_number(upper, t_0);
            else lower = maximum_number(lower, t_0);
            if (leaves_1) upper = minimum_number(upper, t_1);
            else lower = maximum_number(lower, t_1);
            {near_t_min_o, near_t_max_o} = {lower, upper};
            code_o = !less_or_equal(lower, upper) ? 2'd0 : is_leaf ? 2'd3 : 2'd1;
        end else if (is_leaf) code_o = 2'd3;
        else begin
            near_offset_o = downward ? offset + size : offset;
            far_offset_o = downward ? offset : offset + size;
            near_t_max_o = minimum_number(t_max_i, downward ? t_1 : t_0);
            far_t_min_o = maximum_number(t_min_i, downward ? t_0 : t_1);
            near = less_or_equal(near_t_min_o, near_t_max_o);
            far = less_or_equal(far_t_min_o, far_t_max_o);
            code_o = near && far ? 2'd2 : near || far ? 2'd1 : 2'd0;
            if (far && !near)
                {near_offset_o, near_t_min_o, near_t_max_o} = {far_offset_o, far_t_min_o, far_t_max_o};
        end
    end
endmodule

// The two sides of the proof. Outputs that mean nothing are masked: both slots of a miss, and the far slot of every
// code except 2.
`define PORTS \
    input  wire        clk_i, valid_i, tag_i, \
    input  wire [31:0] header_i, plane_0_i, plane_1_i, \
    input  wire [31:0] origin_x_i, origin_y_i, origin_z_i, \
    input  wire [31:0] inv_entry_x_i, inv_entry_y_i, inv_entry_z_i, \
    input  wire [31:0] inv_exit_x_i, inv_exit_y_i, inv_exit_z_i, \
    input  wire [31:0] t_min_i, t_max_i, \
    output wire        valid_o, tag_o, \
    output wire [1:0]  code_o, \
    output wire [95:0] near, far
`define MEANING \
    wire [31:0] near_offset_o, near_t_min_o, near_t_max_o; \
    wire [31:0] far_offset_o, far_t_min_o, far_t_max_o; \
    assign near = code_o == 2'd0 ? 96'd0 : {near_offset_o, near_t_min_o, near_t_max_o}; \
    assign far = code_o == 2'd2 ? {far_offset_o, far_t_min_o, far_t_max_o} : 96'd0;

module gold (`PORTS);
    `MEANING
    reference_dual_split unit (.*);
    assign valid_o = valid_i;
    assign tag_o = tag_i;
endmodule

module gate (`PORTS);
    `MEANING
    wire en_i = 1'b1;
    `TOP unit (.*);
endmodule
