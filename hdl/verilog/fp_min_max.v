// fp_min_max: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none

// fp_min_max: fp_min_max e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//   constant canonical_nan = 32'h7fc00000
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
module fp_min_max (
    input  wire        clk_i,
    input  wire        rst_ni,
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
    reg valid;
    reg tag;
    reg [31:0] result;

    // Logic
    wire [31:0] magnitude_a = a_i & 32'h7fffffff;
    wire [31:0] magnitude_b = b_i & 32'h7fffffff;
    wire nan_a = magnitude_a > 32'h7f800000;
    wire nan_b = magnitude_b > 32'h7f800000;
    wire nan = (nan_a & nan_b) | (propagate_nan_i & (nan_a | nan_b));
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
