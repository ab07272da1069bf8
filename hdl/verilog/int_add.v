// int_add: written by dualsplit 0.1.0 from the rust-hdl source; do not edit.
// Verilog-2005. One clock, rising edge; rst_ni, asserted asynchronously, clears the valid bits and nothing else.
`default_nettype none

// int_add: int_add w32_t1
//
// Integer adder: forms the second child's offset.
module int_add (
    input  wire        clk_i,
    input  wire        rst_ni,
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
    reg valid;
    reg tag;
    reg [31:0] sum;

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
            sum <= a_i + b_i;
        end
    end

    // Outputs
    assign valid_o = valid;
    assign tag_o = tag;
    assign sum_o = sum;
endmodule

`default_nettype wire
