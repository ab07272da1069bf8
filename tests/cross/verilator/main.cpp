// Runs a Verilated model over vectors from standard input and says how many differ.
//
// A vector is a clock cycle. It has one 32-bit little-endian word for each input, one word for each output with the
// value that the output must have before the rising edge, and then a bit for each output that says whether to compare
// it. `ports.h` lists the ports.

#include <cstdint>
#include <cstdio>
#include "ports.h"

static constexpr uint32_t WORDS = INPUTS + OUTPUTS + (OUTPUTS + 31) / 32;

double sc_time_stamp() { return 0; }

int main() {
    MODEL model;
    model.clk_i = 0;
    static uint32_t chunk[1024][WORDS];
    uint64_t vectors = 0, mismatches = 0;
    while (size_t count = fread(chunk, sizeof chunk[0], 1024, stdin)) {
        for (size_t i = 0; i < count; ++i, ++vectors) {
            const uint32_t *in = chunk[i], *expected = in + INPUTS, *compared = expected + OUTPUTS;
            write_inputs(model, in);
            model.eval();
            uint32_t found[OUTPUTS];
            read_outputs(model, found);
            bool differs = false;
            for (uint32_t output = 0; output < OUTPUTS; ++output)
                differs |= (compared[output / 32] >> output % 32 & 1) && found[output] != expected[output];
            if (differs && mismatches++ < 10) printf("vector %llu differs\n", (unsigned long long)vectors);
            model.clk_i = 1;
            model.eval();
            model.clk_i = 0;
        }
    }
    printf("%llu of %llu vectors differ\n", (unsigned long long)mismatches, (unsigned long long)vectors);
    return 0;
}
