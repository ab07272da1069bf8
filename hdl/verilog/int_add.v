// int_add: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge, no reset: registers start at their initial value.
`default_nettype none

// int_add w32_t1
module int_add (
    input  wire        clk_i,
    input  wire        en_i,
    input  wire        valid_i,
    input  wire        tag_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire        valid_o,
    output wire        tag_o,
    output wire [31:0] sum_o
);

    // Registers
    reg valid = 1'b0;
    reg tag = 1'b0;
    reg [31:0] sum = 32'd0;

    // Next state
    always @(posedge clk_i) begin
        if (en_i) begin
            valid <= valid_i;
            tag <= tag_i;
            sum <= a_i + b_i;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign tag_o = tag;
    assign sum_o = sum;
endmodule

`default_nettype wire
