// The ray-box test as documented; binary32. Subtractions and multiplications as in dual_split.v.

module reference_ray_box (
    input  wire [31:0] box_min_x_i, box_min_y_i, box_min_z_i,
    input  wire [31:0] box_max_x_i, box_max_y_i, box_max_z_i,
    input  wire [31:0] origin_x_i, origin_y_i, origin_z_i,
    input  wire [31:0] inv_entry_x_i, inv_entry_y_i, inv_entry_z_i,
    input  wire [31:0] inv_exit_x_i, inv_exit_y_i, inv_exit_z_i,
    input  wire [31:0] t_min_i, t_max_i,
    output wire        hit_o,
    output wire [31:0] t_entry_o
);
    `include "order.vh"

    // Distances of the lower planes (0, 1, 2) and of the upper ones. A ray that runs upwards enters through the lower.
    wire [31:0] difference_0, difference_1, difference_2, difference_3, difference_4, difference_5;
    wire [31:0] t_0, t_1, t_2, t_3, t_4, t_5;
    any_result subtract_0 (.a_i(box_min_x_i), .b_i(origin_x_i), .result_o(difference_0));
    any_result subtract_1 (.a_i(box_min_y_i), .b_i(origin_y_i), .result_o(difference_1));
    any_result subtract_2 (.a_i(box_min_z_i), .b_i(origin_z_i), .result_o(difference_2));
    any_result subtract_3 (.a_i(box_max_x_i), .b_i(origin_x_i), .result_o(difference_3));
    any_result subtract_4 (.a_i(box_max_y_i), .b_i(origin_y_i), .result_o(difference_4));
    any_result subtract_5 (.a_i(box_max_z_i), .b_i(origin_z_i), .result_o(difference_5));
    any_result multiply_0 (
        .a_i(difference_0), .b_i(inv_entry_x_i[31] ? inv_exit_x_i : inv_entry_x_i), .result_o(t_0)
    );
    any_result multiply_1 (
        .a_i(difference_1), .b_i(inv_entry_y_i[31] ? inv_exit_y_i : inv_entry_y_i), .result_o(t_1)
    );
    any_result multiply_2 (
        .a_i(difference_2), .b_i(inv_entry_z_i[31] ? inv_exit_z_i : inv_entry_z_i), .result_o(t_2)
    );
    any_result multiply_3 (
        .a_i(difference_3), .b_i(inv_entry_x_i[31] ? inv_entry_x_i : inv_exit_x_i), .result_o(t_3)
    );
    any_result multiply_4 (
        .a_i(difference_4), .b_i(inv_entry_y_i[31] ? inv_entry_y_i : inv_exit_y_i), .result_o(t_4)
    );
    any_result multiply_5 (
        .a_i(difference_5), .b_i(inv_entry_z_i[31] ? inv_entry_z_i : inv_exit_z_i), .result_o(t_5)
    );

    // An axis with a NaN distance constrains nothing.
    wire [31:0] t_exit;
    assign t_entry_o = maximum_number(
        maximum_number(minimum(t_0, t_3), minimum(t_1, t_4)), maximum_number(minimum(t_2, t_5), t_min_i)
    );
    assign t_exit = minimum_number(
        minimum_number(maximum(t_0, t_3), maximum(t_1, t_4)), minimum_number(maximum(t_2, t_5), t_max_i)
    );
    assign hit_o = less_or_equal(t_entry_o, t_exit);
endmodule

// The two sides of the proof. The entry distance of a miss means nothing.
`define PORTS \
    input  wire        clk_i, valid_i, tag_i, \
    input  wire [31:0] box_min_x_i, box_min_y_i, box_min_z_i, \
    input  wire [31:0] box_max_x_i, box_max_y_i, box_max_z_i, \
    input  wire [31:0] origin_x_i, origin_y_i, origin_z_i, \
    input  wire [31:0] inv_entry_x_i, inv_entry_y_i, inv_entry_z_i, \
    input  wire [31:0] inv_exit_x_i, inv_exit_y_i, inv_exit_z_i, \
    input  wire [31:0] t_min_i, t_max_i, \
    output wire        valid_o, tag_o, hit_o, \
    output wire [31:0] entry
`define MEANING \
    wire [31:0] t_entry_o; \
    assign entry = hit_o ? t_entry_o : 32'd0;

module gold (`PORTS);
    `MEANING
    reference_ray_box unit (.*);
    assign valid_o = valid_i;
    assign tag_o = tag_i;
endmodule

module gate (`PORTS);
    `MEANING
    wire en_i = 1'b1;
    `TOP unit (.*);
endmodule
