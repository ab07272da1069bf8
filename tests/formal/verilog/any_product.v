// Any word that a product of two significands can be, and more. Of the second factor, W bits from LOW upwards count; if their
// leading one is at place t, the product is from a * 2^t to a * (2^(t+1) - 1). Nothing drives `free`, so it becomes an
// input of the proof.
module `NAME #(parameter S = `S, LOW = `LOW, W = `W) (
    input  wire [S-1:0]   a_i,
    input  wire [S-1:0]   b_i,
    output wire [2*S-1:0] product_o
);
    wire [2*S-1:0] free;
    wire [W-1:0] b = b_i[LOW+W-1:LOW];
    integer i, top_b;
    always @* begin
        top_b = 0;
        for (i = 0; i < W; i = i + 1)
            if (b[i]) top_b = i;
    end
    wire [2*S-1:0] least = a_i << top_b;
    wire [2*S-1:0] most = (least << 1) - a_i;
    wire possible = free >= least && free <= most;
    assign product_o = b == 0 ? 0 : possible ? free : least;
endmodule
