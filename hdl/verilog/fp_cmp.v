// fp_cmp: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge, no reset: registers start at their initial value.
`default_nettype none

// fp_cmp e8m23_t1
//   constant magnitude_mask = 32'h7fffffff
//   constant infinity = 32'h7f800000
module fp_cmp (
    input  wire        clk_i,
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
    reg valid = 1'b0;
    reg tag = 1'b0;
    reg lt = 1'b0;
    reg le = 1'b0;
    reg eq = 1'b0;

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
