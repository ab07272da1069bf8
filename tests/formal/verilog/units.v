// The arithmetic units as IEEE 754 defines them, for any format of E exponent and S significand bits.
//
// Plain behavioural Verilog, written from the standard and not from the RTL: the other side of the proofs in
// tests/formal. Ports are those of the RTL's modules without clock and handshake. Rounding directions are coded as in
// RISC-V's frm: 0 nearest even, 1 toward zero, 2 down, 3 up, 4 nearest away. Other codes mean the same as 1.

// Rounds significand * 2^exponent. `kept` are the upper S bits of the significand, `guard` is the next one, and `sticky`
// says whether anything follows. A clear upper bit means a subnormal number, whatever the exponent.
module reference_round #(parameter E = 8, parameter S = 24) (
    input  wire           sign,
    input  wire [E+1:0]   exponent,
    input  wire [S-1:0]   kept,
    input  wire           guard,
    input  wire           sticky,
    input  wire [2:0]     rounding,
    output reg  [E+S-2:0] magnitude
);
    localparam [E+S-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    reg up;
    reg [E+S:0] rounded;
    always @* begin
        case (rounding)
            3'd0: up = guard && (sticky || kept[0]);
            3'd2: up = sign && (guard || sticky);
            3'd3: up = !sign && (guard || sticky);
            3'd4: up = guard;
            default: up = 1'b0;
        endcase
        rounded = {kept[S-1] ? exponent : {(E+2){1'b0}}, kept[S-2:0]} + up;
        magnitude = rounded;
        if (rounded >= INFINITY)
            case (rounding)
                3'd0, 3'd4: magnitude = INFINITY;
                3'd2: magnitude = sign ? INFINITY : INFINITY - 1'b1;
                3'd3: magnitude = sign ? INFINITY - 1'b1 : INFINITY;
                default: magnitude = INFINITY - 1'b1;
            endcase
    end
endmodule

module reference_fp_add #(parameter E = 8, parameter S = 24) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    input  wire           subtract_i,
    input  wire [2:0]     rounding_i,
    output reg  [E+S-1:0] result_o
);
    localparam W = E + S;
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    localparam [W-1:0] NAN = {1'b0, {E{1'b1}}, 1'b1, {(S-2){1'b0}}};

    // The addends by magnitude, with the hidden bit.
    wire sign_b = b_i[W-1] ^ subtract_i;
    wire minus = a_i[W-1] != sign_b;
    wire a_first = a_i[W-2:0] >= b_i[W-2:0];
    wire sign = a_first ? a_i[W-1] : sign_b;
    wire [W-2:0] big = a_first ? a_i[W-2:0] : b_i[W-2:0];
    wire [W-2:0] small = a_first ? b_i[W-2:0] : a_i[W-2:0];
    wire [S-1:0] big_significand = {|big[W-2:S-1], big[S-2:0]};
    wire [S-1:0] small_significand = {|small[W-2:S-1], small[S-2:0]};
    wire [E-1:0] big_exponent = big[W-2:S-1] == 0 ? 1 : big[W-2:S-1];
    wire [E-1:0] small_exponent = small[W-2:S-1] == 0 ? 1 : small[W-2:S-1];

    // The smaller addend loses nothing within 2 S + 2 places. Further away, it is a sticky bit.
    wire [E-1:0] distance = big_exponent - small_exponent;
    wire [3*S+1:0] shifted = {small_significand, {(2*S+2){1'b0}}} >> distance;
    wire lost = |shifted[2*S-2:0] || (distance > 2*S+2 && |small_significand);
    wire [S+3:0] high = {1'b0, big_significand, 3'b000};
    wire [S+3:0] low = {1'b0, shifted[3*S+1:2*S-1]} | lost;
    wire [S+3:0] total = minus ? high - low : high + low;

    // Shifted until a one leads or the exponent is the smallest.
    integer i;
    integer zeros;
    reg [E:0] shift;
    always @* begin
        zeros = S + 4;
        for (i = 0; i < S + 4; i = i + 1)
            if (total[i]) zeros = S + 3 - i;
        shift = zeros > big_exponent ? big_exponent : zeros;
    end
    wire [S+3:0] normal = total << shift;
    wire [E+1:0] exponent = big_exponent + 1 - shift;
    wire [W-2:0] magnitude;
    reference_round #(E, S) round (
        .sign(sign), .exponent(exponent), .kept(normal[S+3:4]), .guard(normal[3]), .sticky(|normal[2:0]),
        .rounding(rounding_i), .magnitude(magnitude)
    );
    always @* begin
        result_o = {sign, magnitude};
        if (total == 0) result_o = {minus ? rounding_i == 3'd2 : a_i[W-1], {(W-1){1'b0}}};
        if (big == INFINITY) result_o = small == INFINITY && minus ? NAN : {sign, INFINITY};
        if (big > INFINITY) result_o = NAN;
    end
endmodule

// The products of the first significand with both halves of the second one come from `reference_product`, a module of its own
// that a proof may replace. It takes W bits of the second factor from LOW upwards.
module reference_fp_mul #(parameter E = 8, parameter S = 24) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    input  wire [2:0]     rounding_i,
    output reg  [E+S-1:0] result_o
);
    localparam W = E + S;
    localparam P = 2 * S;
    localparam BIAS = (1 << (E - 1)) - 1;
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    localparam [W-1:0] NAN = {1'b0, {E{1'b1}}, 1'b1, {(S-2){1'b0}}};

    wire sign = a_i[W-1] ^ b_i[W-1];
    wire [E-1:0] code_a = a_i[W-2:S-1];
    wire [E-1:0] code_b = b_i[W-2:S-1];
    localparam H = S - S / 2;
    wire [S-1:0] significand_a = {code_a != 0, a_i[S-2:0]};
    wire [S-1:0] significand_b = {code_b != 0, b_i[S-2:0]};
    wire [P-1:0] lower, upper;
    reference_product #(S, 0, H) array_lower (.a_i(significand_a), .b_i(significand_b), .product_o(lower));
    reference_product #(S, H, S - H) array_upper (.a_i(significand_a), .b_i(significand_b), .product_o(upper));
    wire [P-1:0] product = lower + (upper << H);

    // `top` is the biased exponent of the product's upper bit.
    integer i, top, zeros, exponent;
    reg [P-1:0] normal;
    reg lost;
    always @* begin
        top = code_a + (code_a == 0) + code_b + (code_b == 0) - BIAS + 1;
        zeros = P;
        for (i = 0; i < P; i = i + 1)
            if (product[i]) zeros = P - 1 - i;
        lost = 1'b0;
        if (top > zeros) begin
            exponent = top - zeros;
            normal = product << zeros;
        end else begin
            exponent = 1;
            if (top >= 1) normal = product << (top - 1);
            else begin
                normal = product >> (1 - top);
                lost = (normal << (1 - top)) != product;
            end
        end
    end
    wire [W-2:0] magnitude;
    reference_round #(E, S) round (
        .sign(sign), .exponent(exponent[E+1:0]), .kept(normal[P-1:S]), .guard(normal[S-1]),
        .sticky(|normal[S-2:0] || lost), .rounding(rounding_i), .magnitude(magnitude)
    );
    always @* begin
        result_o = {sign, magnitude};
        if (a_i[W-2:0] == INFINITY || b_i[W-2:0] == INFINITY) result_o = {sign, INFINITY};
        if (a_i[W-2:0] == INFINITY && b_i[W-2:0] == 0) result_o = NAN;
        if (b_i[W-2:0] == INFINITY && a_i[W-2:0] == 0) result_o = NAN;
        if (a_i[W-2:0] > INFINITY || b_i[W-2:0] > INFINITY) result_o = NAN;
    end
endmodule

// Numbers as signed integers in the same order; -0 and +0 are both 0.
module reference_fp_cmp #(parameter E = 8, parameter S = 24) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    output wire           lt_o,
    output wire           le_o,
    output wire           eq_o
);
    localparam W = E + S;
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    wire signed [W-1:0] a = a_i[W-1] ? -$signed({1'b0, a_i[W-2:0]}) : $signed({1'b0, a_i[W-2:0]});
    wire signed [W-1:0] b = b_i[W-1] ? -$signed({1'b0, b_i[W-2:0]}) : $signed({1'b0, b_i[W-2:0]});
    wire ordered = a_i[W-2:0] <= INFINITY && b_i[W-2:0] <= INFINITY;
    assign lt_o = ordered && a < b;
    assign le_o = ordered && a <= b;
    assign eq_o = ordered && a == b;
endmodule

// minimumNumber, maximumNumber, minimum and maximum; -0 orders before +0.
module reference_fp_min_max #(parameter E = 8, parameter S = 24) (
    input  wire [E+S-1:0] a_i,
    input  wire [E+S-1:0] b_i,
    input  wire           maximum_i,
    input  wire           propagate_nan_i,
    output reg  [E+S-1:0] result_o
);
    localparam W = E + S;
    localparam [W-2:0] INFINITY = {{E{1'b1}}, {(S-1){1'b0}}};
    localparam [W-1:0] NAN = {1'b0, {E{1'b1}}, 1'b1, {(S-2){1'b0}}};
    wire nan_a = a_i[W-2:0] > INFINITY;
    wire nan_b = b_i[W-2:0] > INFINITY;
    // Ascending from the most negative number to the largest.
    wire [W-1:0] rank_a = a_i[W-1] ? ~a_i : {1'b1, a_i[W-2:0]};
    wire [W-1:0] rank_b = b_i[W-1] ? ~b_i : {1'b1, b_i[W-2:0]};
    always @* begin
        if (maximum_i) result_o = rank_a > rank_b ? a_i : b_i;
        else result_o = rank_a < rank_b ? a_i : b_i;
        if (nan_a) result_o = b_i;
        if (nan_b) result_o = a_i;
        if ((nan_a && nan_b) || (propagate_nan_i && (nan_a || nan_b))) result_o = NAN;
    end
endmodule

module reference_int_add (
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [31:0] sum_o
);
    assign sum_o = a_i + b_i;
endmodule
