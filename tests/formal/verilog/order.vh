    // Order of binary32 numbers, for the references of the pipelines.

    function is_nan(input [31:0] x);
        is_nan = x[30:0] > 31'h7f800000;
    endfunction

    // Ascending from the most negative number; -0 before +0.
    function [31:0] rank(input [31:0] x);
        rank = x[31] ? ~x : {1'b1, x[30:0]};
    endfunction

    function [31:0] minimum_number(input [31:0] a, input [31:0] b);
        if (is_nan(a) && is_nan(b)) minimum_number = 32'h7fc00000;
        else if (is_nan(a)) minimum_number = b;
        else if (is_nan(b)) minimum_number = a;
        else minimum_number = rank(a) < rank(b) ? a : b;
    endfunction

    function [31:0] maximum_number(input [31:0] a, input [31:0] b);
        if (is_nan(a) && is_nan(b)) maximum_number = 32'h7fc00000;
        else if (is_nan(a)) maximum_number = b;
        else if (is_nan(b)) maximum_number = a;
        else maximum_number = rank(a) > rank(b) ? a : b;
    endfunction

    function [31:0] minimum(input [31:0] a, input [31:0] b);
        minimum = is_nan(a) || is_nan(b) ? 32'h7fc00000 : minimum_number(a, b);
    endfunction

    function [31:0] maximum(input [31:0] a, input [31:0] b);
        maximum = is_nan(a) || is_nan(b) ? 32'h7fc00000 : maximum_number(a, b);
    endfunction

    function less_or_equal(input [31:0] a, input [31:0] b);
        less_or_equal = !is_nan(a) && !is_nan(b)
            && (rank(a) <= rank(b) || (a[30:0] == 0 && b[30:0] == 0));
    endfunction
