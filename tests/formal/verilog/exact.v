// Addition and multiplication without any floating-point technique, for small formats. Operands become integers, in
// multiples of the smallest subnormal number. The operation on the integers is exact, and its result is rounded once.

// The nearest numbers to magnitude * 2^-F smallest subnormals.
module exact_round #(parameter E = 4, parameter S = 4, parameter N = 32, parameter F = 0) (
    input  wire           sign,
    input  wire [N-1:0]   magnitude,
    input  wire [2:0]     rounding,
    output reg  [E+S-2:0] rounded
);
    localparam [E+S-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    integer i, shift, code;
    reg [N:0] kept, rest, unit;
    always @* begin
        // One unit in the last place is 2^shift: that of the subnormals, unless the number is too large.
        shift = F;
        for (i = F + S; i < N; i = i + 1)
            if (magnitude[i]) shift = i - (S - 1);
        unit = 1;
        unit = unit << shift;
        kept = magnitude >> shift;
        rest = magnitude & (unit - 1);
        case (rounding)
            3'd0: if (2 * rest > unit || (2 * rest == unit && kept[0])) kept = kept + 1;
            3'd2: if (sign && rest != 0) kept = kept + 1;
            3'd3: if (!sign && rest != 0) kept = kept + 1;
            3'd4: if (2 * rest >= unit) kept = kept + 1;
            default: ;
        endcase
        if (kept == 1 << S) begin
            kept = 1 << (S - 1);
            shift = shift + 1;
        end
        code = kept >= 1 << (S - 1) ? shift - F + 1 : 0;
        rounded = {code[E-1:0], kept[S-2:0]};
        if (code >= (1 << E) - 1)
            case (rounding)
                3'd0, 3'd4: rounded = INFINITY;
                3'd2: rounded = sign ? INFINITY : INFINITY - 1'b1;
                3'd3: rounded = sign ? INFINITY - 1'b1 : INFINITY;
                default: rounded = INFINITY - 1'b1;
            endcase
    end
endmodule

// A finite number's magnitude: significand * 2^scale smallest subnormals.
module exact_value #(parameter E = 4, parameter S = 4) (
    input  wire [E+S-2:0] word,
    output wire [S-1:0]   significand,
    output wire [E-1:0]   scale
);
    wire [E-1:0] code = word[E+S-2:S-1];
    assign significand = {code != 0, word[S-2:0]};
    assign scale = code == 0 ? 0 : code - 1;
endmodule

module exact_fp_add #(parameter E = 4, parameter S = 4) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    input  wire           subtract_i,
    input  wire [2:0]     rounding_i,
    output reg  [E+S-1:0] result_o
);
    localparam W = E + S;
    localparam N = (1 << E) + S; // finite numbers have fewer bits by three: a carry and a sign fit
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    localparam [W-1:0] NAN = {1'b0, {E{1'b1}}, 1'b1, {(S-2){1'b0}}};
    wire [S-1:0] significand_a, significand_b;
    wire [E-1:0] scale_a, scale_b;
    exact_value #(E, S) exact_a (.word(a_i[W-2:0]), .significand(significand_a), .scale(scale_a));
    exact_value #(E, S) exact_b (.word(b_i[W-2:0]), .significand(significand_b), .scale(scale_b));
    wire [N-1:0] value_a = significand_a << scale_a;
    wire [N-1:0] value_b = significand_b << scale_b;
    wire sign_a = a_i[W-1];
    wire sign_b = b_i[W-1] ^ subtract_i;
    wire [N-1:0] sum = (sign_a ? -value_a : value_a) + (sign_b ? -value_b : value_b);
    wire [N-1:0] magnitude = sum[N-1] ? -sum : sum;
    wire [W-2:0] rounded;
    exact_round #(E, S, N, 0) round (
        .sign(sum[N-1]), .magnitude(magnitude), .rounding(rounding_i), .rounded(rounded)
    );
    always @* begin
        result_o = {sum[N-1], rounded};
        if (sum == 0) result_o = {sign_a == sign_b ? sign_a : rounding_i == 3'd2, {(W-1){1'b0}}};
        if (b_i[W-2:0] == INFINITY) result_o = {sign_b, INFINITY};
        if (a_i[W-2:0] == INFINITY)
            result_o = b_i[W-2:0] == INFINITY && sign_a != sign_b ? NAN : {sign_a, INFINITY};
        if (a_i[W-2:0] > INFINITY || b_i[W-2:0] > INFINITY) result_o = NAN;
    end
endmodule

module exact_fp_mul #(parameter E = 4, parameter S = 4) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    input  wire [2:0]     rounding_i,
    output reg  [E+S-1:0] result_o
);
    localparam W = E + S;
    localparam N = 2 * ((1 << E) - 2 + S);
    // A product of two smallest subnormals is 2^-F of one.
    localparam F = (1 << (E - 1)) + S - 3;
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    localparam [W-1:0] NAN = {1'b0, {E{1'b1}}, 1'b1, {(S-2){1'b0}}};
    wire [S-1:0] significand_a, significand_b;
    wire [E-1:0] scale_a, scale_b;
    exact_value #(E, S) exact_a (.word(a_i[W-2:0]), .significand(significand_a), .scale(scale_a));
    exact_value #(E, S) exact_b (.word(b_i[W-2:0]), .significand(significand_b), .scale(scale_b));
    wire sign = a_i[W-1] ^ b_i[W-1];
    wire [N-1:0] product = (significand_a * significand_b) << scale_a << scale_b;
    wire [W-2:0] rounded;
    exact_round #(E, S, N, F) round (
        .sign(sign), .magnitude(product), .rounding(rounding_i), .rounded(rounded)
    );
    always @* begin
        result_o = {sign, rounded};
        if (a_i[W-2:0] == INFINITY) result_o = b_i[W-2:0] == 0 ? NAN : {sign, INFINITY};
        if (b_i[W-2:0] == INFINITY) result_o = a_i[W-2:0] == 0 ? NAN : {sign, INFINITY};
        if (a_i[W-2:0] > INFINITY || b_i[W-2:0] > INFINITY) result_o = NAN;
    end
endmodule

module reference_product #(parameter S = 4, LOW = 0, W = 4) (
    input  wire [S-1:0]   a_i,
    input  wire [S-1:0]   b_i,
    output wire [2*S-1:0] product_o
);
    assign product_o = a_i * b_i[LOW+W-1:LOW];
endmodule
