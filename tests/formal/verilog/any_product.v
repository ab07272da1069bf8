// Any word that a product of two significands can be, and more: any word from the product of the operands' leading
// ones to four times that, or zero if an operand is zero. Nothing drives `free`, so it becomes an input of the proof.
module `NAME #(parameter S = `S) (
    input  wire [S-1:0]   a_i,
    input  wire [S-1:0]   b_i,
    output wire [2*S-1:0] product_o
);
    wire [2*S-1:0] free;
    integer i, top_a, top_b;
    always @* begin
        top_a = 0;
        top_b = 0;
        for (i = 0; i < S; i = i + 1) begin
            if (a_i[i]) top_a = i;
            if (b_i[i]) top_b = i;
        end
    end
    wire [2*S+1:0] least = 1 << (top_a + top_b);
    wire possible = free >= least && free < least << 2;
    assign product_o = a_i == 0 || b_i == 0 ? 0 : possible ? free : least;
endmodule
