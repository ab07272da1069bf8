// fp_cmp: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none

// fp_cmp: fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
//
// Floating-point comparison.
//
// Sign-magnitude words compare like unsigned integers, except that a negative operand reverses the outcome. Let `u`
// be `a < b` on the words as unsigned integers. If both signs are clear, `a < b` is `u`; if both are set, it is the
// reverse, `!u` (for `a != b`); if only `a` is negative, its word is the larger one, so that `u = 0` and again `!u` is
// right; if only `b` is negative, `u = 1`, and `!u` is right. Hence `a < b` is `u` xor `(sign_a | sign_b)` wherever the
// operands differ.
module fp_cmp (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire        lt_o,
    output wire        le_o,
    output wire        eq_o
);

    // Registers
    reg valid;
    reg tag;
    reg lt;
    reg le;
    reg eq;

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
            tag <= tag_i;
            lt <= ordered & less;
            le <= ordered & (less | equal);
            eq <= ordered & equal;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign tag_o = tag;
    assign lt_o = lt;
    assign le_o = le;
    assign eq_o = eq;
endmodule

`default_nettype wire
