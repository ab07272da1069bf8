#!/usr/bin/env bash
# Compiles the kernels with a stock MIPS back end (Debian's clang 14) and prints each listing without directives. The
# listings in this folder are that output, with the conditions of branches and the names of entry points put behind "#:".
# Options: MIPS32 with all 32 single-precision registers and no fused multiply-add.
set -euo pipefail
cd "$(dirname "$0")"
listing() {
    "${CLANG:-clang-14}" --target=mips-linux-gnu -mips32 -mfp32 -fno-pic -mno-abicalls -O3 -ffp-contract=off \
        -fno-integrated-as -S -o - "$@" |
        sed -E 's/#([^:].*)?$//; s/[[:space:]]+$//; s/\t/ /g; s/^ /    /' |
        grep -Ev '^ *(\..*|\$func_end.*|\$CPI.*|)$'
}
listing "$@"
