// A product as a sum of shifted rows: the techmap rule by which both sides of an equivalence proof multiply.
(* techmap_celltype = "$mul" *)
module shift_and_add (A, B, Y);
    parameter A_SIGNED = 0;
    parameter B_SIGNED = 0;
    parameter A_WIDTH = 1;
    parameter B_WIDTH = 1;
    parameter Y_WIDTH = 1;
    input [A_WIDTH-1:0] A;
    input [B_WIDTH-1:0] B;
    output [Y_WIDTH-1:0] Y;
    wire _TECHMAP_FAIL_ = A_SIGNED || B_SIGNED;
    genvar i;
    generate
        for (i = 0; i < B_WIDTH; i = i + 1) begin : row
            wire [Y_WIDTH-1:0] sum;
            if (i == 0) assign sum = B[0] ? A : 0;
            else assign sum = row[i-1].sum + (B[i] ? A << i : 0);
        end
    endgenerate
    assign Y = row[B_WIDTH-1].sum;
endmodule
