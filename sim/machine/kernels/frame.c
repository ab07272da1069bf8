// A frame: each item of work is a pixel. Rays are generated, traced through one of the structures, and shaded: direct light,
// and PARAM_BOUNCES diffuse bounces with a shadow ray from every vertex.
//
// One of DST (hardware step), DST_SOFTWARE, BVH=2|4|8 (one ray-box pipeline), with PARALLEL as many pipelines as children.
// The operations are those of golden, in the same order: `dst::step`, `bvh::box_step`, `TriangleTest`, `render::shading`.
#include "trax.h"

enum {
    NODE_OFFSET = 0x3ffffff,
    LEAF_BIT = 26,
    SIZE_BIT = 27,
    AXIS_BIT = 29,
    BVH_INDEX = 0xfffffff,
    TRIANGLE_INDEX = 0x3ffffff,
    LAST_BIT = 27,
    SIGN = (int)0x80000000,
    EXPONENT = 0x7f800000,
};

// Of the planes a0 and a1 of a box, the one at which the ray enters, and the one at which it leaves.
#define ENTERED(a) (i##a < 0.f ? a##1 : a##0)
#define LEFT(a) (i##a < 0.f ? a##0 : a##1)

// The reciprocal of a power of two at or below m.
#define UNSCALE(m) from_bits(0x7f000000 - (bits(m) & EXPONENT))

// Address of the first child of the inner node of a BVH with this word 0: it counts nodes, with WORD_OFFSETS words.
#ifdef WORD_OFFSETS
#define FIRST_CHILD(word) (nodes + ((word) & BVH_INDEX))
#else
#define FIRST_CHILD(word) (nodes + ((word) & BVH_INDEX) * 7)
#endif

#define BOX_LOAD(lane, address, word) asm volatile("BOXLOAD %0, %1, %2" ::"r"(lane), "r"(address), "i"(word));

// Where the reciprocal i of a component d overflows, planes of entry get the largest finite number.
#define RECIPROCALS(d, i, j)                                                                                 \
    if (d == 0.f)                                                                                            \
        j = i;                                                                                               \
    else {                                                                                                   \
        int magnitude = bits(i) & ~SIGN;                                                                     \
        if (magnitude >= EXPONENT) magnitude = EXPONENT - 1;                                                 \
        i = from_bits(magnitude | (bits(d) & SIGN));                                                         \
        magnitude += padding;                                                                                \
        if (magnitude > EXPONENT) magnitude = EXPONENT;                                                      \
        j = from_bits(magnitude | (bits(d) & SIGN));                                                         \
    }

// With NO_ENTRY_T_MIN (examples/no-t-min.c), an entry does not keep where the ray enters it, and none is dropped when it is popped.
#ifdef NO_ENTRY_T_MIN
#define KEEP_T_MIN(t)
#define KEPT_T_MIN 0.f
#define IS_BEHIND(t) 0
#else
#define KEEP_T_MIN(t) stack[depth].t_min = t;
#define KEPT_T_MIN stack[depth].t_min
#define IS_BEHIND(t) (stack[depth].t_min > (t))
#endif

struct entry {
    int node;
#if !defined(NO_ENTRY_T_MIN) || BVH > 2
    float t_min;
#endif
#if defined(DST) || defined(DST_SOFTWARE)
    float t_max;
#endif
};

int main(void) {
    int pixels = PARAMETER_INT(PARAM_RAYS), nodes = PARAMETER_INT(PARAM_NODES), triangles = PARAMETER_INT(PARAM_TRIANGLES);
    struct entry stack[192];
    float local[24];
    for (int item = next_item(); item < pixels; item = next_item()) {
        // Row and column. The quotient is off by one at most.
        int width = PARAMETER_INT(PARAM_WIDTH), row = (int)((float)item * PARAMETER_FLOAT(PARAM_INVERSE_WIDTH));
        int column = item - row * width;
        if (column < 0) row--, column += width;
        if (column >= width) row++, column -= width;
        // The direction through the pixel's centre.
        float right = (float)column + 0.5f, down = (float)row + 0.5f;
        float dx = PARAMETER_FLOAT(PARAM_CAMERA + 3) + right * PARAMETER_FLOAT(PARAM_CAMERA + 6) +
                   down * PARAMETER_FLOAT(PARAM_CAMERA + 9);
        float dy = PARAMETER_FLOAT(PARAM_CAMERA + 4) + right * PARAMETER_FLOAT(PARAM_CAMERA + 7) +
                   down * PARAMETER_FLOAT(PARAM_CAMERA + 10);
        float dz = PARAMETER_FLOAT(PARAM_CAMERA + 5) + right * PARAMETER_FLOAT(PARAM_CAMERA + 8) +
                   down * PARAMETER_FLOAT(PARAM_CAMERA + 11);
        float unit = inverse_square_root(dx * dx + dy * dy + dz * dz);
        dx *= unit, dy *= unit, dz *= unit;
        float ox = PARAMETER_FLOAT(PARAM_CAMERA), oy = PARAMETER_FLOAT(PARAM_CAMERA + 1), oz = PARAMETER_FLOAT(PARAM_CAMERA + 2);
        float t_max = __builtin_inff();
        local[0] = local[1] = local[2] = 0.f; // radiance
        local[3] = 1.f;                       // throughput
        int bounce = PARAMETER_INT(PARAM_BOUNCES), any = 0;
        while (1) {
            // Reciprocals for planes of entry and of exit.
            int padding = PARAMETER_INT(PARAM_PADDING);
            float ix = 1.f / dx, iy = 1.f / dy, iz = 1.f / dz;
            float jx = from_bits(bits(ix) + padding), jy = from_bits(bits(iy) + padding), jz = from_bits(bits(iz) + padding);
            float x = absolute(dx), y = absolute(dy), z = absolute(dz);
            if (minimum(minimum(x, y), z) < 1.17549435e-38f && padding) {
                RECIPROCALS(dx, ix, jx)
                RECIPROCALS(dy, iy, jy)
                RECIPROCALS(dz, iz, jz)
            }
            // The triangle test's axes, the direction's largest component last, and its shear.
            int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
            int axis0 = axis == 2 ? 0 : axis + 1, axis1 = axis == 0 ? 2 : axis - 1;
            local[4] = dx, local[5] = dy, local[6] = dz;
            local[7] = ox, local[8] = oy, local[9] = oz;
#ifdef DST_SOFTWARE
            local[16] = ix, local[17] = iy, local[18] = iz;
            local[19] = jx, local[20] = jy, local[21] = jz;
#endif
            float along = local[4 + axis];
            float shear0 = local[4 + axis0] / along, shear1 = local[4 + axis1] / along, scale = 1.f / along;
            int hit = -1, best_index = 0x7fffffff, depth = 0;
            float t_min = 0.f;
            int node;
#include "traversal.h"
        traced:
            // The ray is done.
            if (any) {
                if (hit < 0) {
                    float light = local[10];
                    local[0] += light * PARAMETER_FLOAT(PARAM_LIGHT + 3);
                    local[1] += light * PARAMETER_FLOAT(PARAM_LIGHT + 4);
                    local[2] += light * PARAMETER_FLOAT(PARAM_LIGHT + 5);
                }
            } else {
                float throughput = local[3];
                if (hit < 0) {
                    local[0] += throughput * PARAMETER_FLOAT(PARAM_BACKGROUND);
                    local[1] += throughput * PARAMETER_FLOAT(PARAM_BACKGROUND + 1);
                    local[2] += throughput * PARAMETER_FLOAT(PARAM_BACKGROUND + 2);
                    break;
                }
                // Normal towards the ray, point, and start of the rays that leave it.
                float ax = LOAD_FLOAT(hit, 0), bx = LOAD_FLOAT(hit, 1), cx = LOAD_FLOAT(hit, 2);
                float ay = LOAD_FLOAT(hit, 3), by = LOAD_FLOAT(hit, 4), cy = LOAD_FLOAT(hit, 5);
                float az = LOAD_FLOAT(hit, 6), bz = LOAD_FLOAT(hit, 7), cz = LOAD_FLOAT(hit, 8);
                float ex = bx - ax, ey = by - ay, ez = bz - az, fx = cx - ax, fy = cy - ay, fz = cz - az;
                float side = maximum(maximum(maximum(absolute(ex), absolute(ey)), absolute(ez)),
                                     maximum(maximum(absolute(fx), absolute(fy)), absolute(fz)));
                float unscale = UNSCALE(side);
                float px = ex * unscale, py = ey * unscale, pz = ez * unscale;
                float qx = fx * unscale, qy = fy * unscale, qz = fz * unscale;
                float nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
                float squared = nx * nx + ny * ny + nz * nz;
                if (squared >= 2.32830644e-10f) {
                    float length = inverse_square_root(squared);
                    float towards = nx * dx + ny * dy + nz * dz;
                    length = from_bits(bits(length) ^ (~bits(towards) & SIGN));
                    nx *= length, ny *= length, nz *= length;
                } else {
                    nx = -dx, ny = -dy, nz = -dz;
                }
                float largest = maximum(maximum(maximum(absolute(ax), absolute(bx)), absolute(cx)),
                                        maximum(maximum(maximum(absolute(ay), absolute(by)), absolute(cy)),
                                                maximum(maximum(absolute(az), absolute(bz)), absolute(cz))));
                float offset = largest * 7.62939453125e-6f, u = local[11], v = local[12];
                ox = ax + ex * u + fx * v + nx * offset;
                oy = ay + ey * u + fy * v + ny * offset;
                oz = az + ez * u + fz * v + nz * offset;
                throughput *= 0.7f;
                local[3] = throughput;
                local[13] = nx, local[14] = ny, local[15] = nz;
                // Towards the light, with the largest component from 1 on and below 2.
                dx = PARAMETER_FLOAT(PARAM_LIGHT) - ox;
                dy = PARAMETER_FLOAT(PARAM_LIGHT + 1) - oy;
                dz = PARAMETER_FLOAT(PARAM_LIGHT + 2) - oz;
                float distance = maximum(maximum(absolute(dx), absolute(dy)), absolute(dz));
                unscale = UNSCALE(distance);
                dx *= unscale, dy *= unscale, dz *= unscale;
                float cosine = nx * dx + ny * dy + nz * dz;
                if (cosine > 0.f) {
                    float inverse = inverse_square_root(dx * dx + dy * dy + dz * dz);
                    float falloff = PARAMETER_FLOAT(PARAM_EXTENT) * unscale * inverse;
                    local[10] = throughput * 0.318309886f * cosine * inverse * falloff * falloff;
                    t_max = from_bits(bits(distance) & EXPONENT);
                    any = 1;
                    continue;
                }
            }
            if (bounce == 0) break;
            bounce--;
            // A cosine-weighted direction around the normal.
            float r0 = random_number(), angle = random_number() * 6.28318531f;
            float radius = __builtin_sqrtf(r0), up = __builtin_sqrtf(1.f - r0);
            float p = radius * cosine_of(angle), q = radius * sine_of(angle);
            float nx = local[13], ny = local[14], nz = local[15];
            float sign = from_bits((bits(nz) & SIGN) | 0x3f800000);
            float a = -1.f / (sign + nz), b = nx * ny * a;
            dx = (1.f + sign * nx * nx * a) * p + b * q + nx * up;
            dy = sign * b * p + (sign + ny * ny * a) * q + ny * up;
            dz = nz * up - sign * nx * p - ny * q;
            t_max = __builtin_inff();
            any = 0;
        }
        int pixel = PARAMETER_INT(PARAM_OUT) + item * 3;
        STORE_FLOAT(local[0], pixel, 0);
        STORE_FLOAT(local[1], pixel, 1);
        STORE_FLOAT(local[2], pixel, 2);
    }
    return 0;
}
