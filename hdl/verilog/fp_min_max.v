// fp_min_max: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge, no reset: registers start at their initial value.
`default_nettype none

// fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
module fp_min_max (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    input  wire        maximum_i,
    input  wire        propagate_nan_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire [31:0] result_o
);

    // Registers
    reg valid = 1'b0;
    reg tag = 1'b0;
    reg [31:0] result = 32'd0;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (propagate_nan_i & (nan_a | nan_b));
    wire any_negative = (magnitude_a != a_i) | (magnitude_b != b_i);
    wire below = a_i < b_i;
    wire n24 = (magnitude_a <= 32'h7f800000) & ((below ^ any_negative) ^ maximum_i);
    wire choose_a = nan_b | n24;
    wire [31:0] chosen_2 = choose_a ? a_i : b_i;
    wire [31:0] chosen = nan ? 32'h7fc00000 : chosen_2;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid <= valid_i;
            tag <= tag_i;
            result <= chosen;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign tag_o = tag;
    assign result_o = result;
endmodule

`default_nettype wire
