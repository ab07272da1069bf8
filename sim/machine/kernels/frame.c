// A frame: each item of work is a pixel. Rays are generated, traced through one of the structures, and shaded: direct light,
// and PARAM_BOUNCES diffuse bounces with a shadow ray from every vertex.
//
// One of DST (hardware step), DST_SOFTWARE, BVH=2|4|8 (one ray-box pipeline), with PARALLEL as many pipelines as children.
// The operations are those of golden: `dst::step`, `bvh::box_step`, `TriangleTest`, in single precision throughout.
#include "trax.h"

enum { NODE_OFFSET = 0x3ffffff, LEAF_BIT = 26, SIZE_BIT = 27, AXIS_BIT = 29, BVH_INDEX = 0xfffffff, LAST_BIT = 27 };

struct entry {
    int node;
    float t_min, t_max;
};

int main(void) {
    int pixels = LOAD_INT("parameters", 0, PARAM_RAYS), nodes = LOAD_INT("parameters", 0, PARAM_NODES),
        triangles = LOAD_INT("parameters", 0, PARAM_TRIANGLES);
    struct entry stack[192];
    float local[24];
    for (int item = next_item(); item < pixels; item = next_item()) {
        // The direction through the pixel's centre.
        float row = (float)(int)((float)item * LOAD_FLOAT("parameters", 0, PARAM_INVERSE_WIDTH));
        float column = (float)item - row * LOAD_FLOAT("parameters", 0, PARAM_WIDTH) + 0.5f;
        row += 0.5f;
        float dx = LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 3) + column * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 6) +
                   row * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 9);
        float dy = LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 4) + column * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 7) +
                   row * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 10);
        float dz = LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 5) + column * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 8) +
                   row * LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 11);
        float unit = inverse_square_root(dx * dx + dy * dy + dz * dz);
        dx *= unit, dy *= unit, dz *= unit;
        float ox = LOAD_FLOAT("parameters", 0, PARAM_CAMERA), oy = LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 1),
              oz = LOAD_FLOAT("parameters", 0, PARAM_CAMERA + 2);
        float t_max = __builtin_inff();
        local[0] = local[1] = local[2] = 0.f; // radiance
        local[3] = 1.f;                       // throughput
        int bounce = LOAD_INT("parameters", 0, PARAM_BOUNCES), any = 0;
        while (1) {
            // Reciprocals for planes of entry and of exit, 4 units in the last place apart.
            float ix = 1.f / dx, iy = 1.f / dy, iz = 1.f / dz;
            float jx = from_bits(bits(ix) + 4), jy = from_bits(bits(iy) + 4), jz = from_bits(bits(iz) + 4);
            // The triangle test's axes, the direction's largest component last, and its shear.
            float x = absolute(dx), y = absolute(dy), z = absolute(dz);
            int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
            int axis0 = axis == 2 ? 0 : axis + 1, axis1 = axis == 0 ? 2 : axis - 1;
            local[4] = dx, local[5] = dy, local[6] = dz;
            local[7] = ox, local[8] = oy, local[9] = oz;
#ifdef DST_SOFTWARE
            local[16] = ix, local[17] = iy, local[18] = iz;
            local[19] = jx, local[20] = jy, local[21] = jz;
#endif
            float scale = 1.f / local[4 + axis];
            float shear0 = local[4 + axis0] * scale, shear1 = local[4 + axis1] * scale;
            int hit = -1, depth = 0;
            float t_min = 0.f;
            int node;
#include "traversal.h"
        traced:
            // The ray is done.
            if (any) {
                if (hit < 0) {
                    float light = local[10];
                    local[0] += light * LOAD_FLOAT("parameters", 0, PARAM_LIGHT + 3);
                    local[1] += light * LOAD_FLOAT("parameters", 0, PARAM_LIGHT + 4);
                    local[2] += light * LOAD_FLOAT("parameters", 0, PARAM_LIGHT + 5);
                }
            } else {
                float throughput = local[3];
                if (hit < 0) {
                    local[0] += throughput * LOAD_FLOAT("parameters", 0, PARAM_BACKGROUND);
                    local[1] += throughput * LOAD_FLOAT("parameters", 0, PARAM_BACKGROUND + 1);
                    local[2] += throughput * LOAD_FLOAT("parameters", 0, PARAM_BACKGROUND + 2);
                    break;
                }
                // Normal towards the ray, point, and start of the rays that leave it.
                float ax = LOAD_FLOAT("hit", hit, 0), bx = LOAD_FLOAT("hit", hit, 1), cx = LOAD_FLOAT("hit", hit, 2);
                float ay = LOAD_FLOAT("hit", hit, 3), by = LOAD_FLOAT("hit", hit, 4), cy = LOAD_FLOAT("hit", hit, 5);
                float az = LOAD_FLOAT("hit", hit, 6), bz = LOAD_FLOAT("hit", hit, 7), cz = LOAD_FLOAT("hit", hit, 8);
                float ex = bx - ax, ey = by - ay, ez = bz - az, fx = cx - ax, fy = cy - ay, fz = cz - az;
                float nx = ey * fz - ez * fy, ny = ez * fx - ex * fz, nz = ex * fy - ey * fx;
                float length = inverse_square_root(nx * nx + ny * ny + nz * nz);
                float towards = nx * dx + ny * dy + nz * dz;
                length = from_bits(bits(length) ^ (~bits(towards) & (int)0x80000000));
                nx *= length, ny *= length, nz *= length;
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
                // Towards the light.
                dx = LOAD_FLOAT("parameters", 0, PARAM_LIGHT) - ox;
                dy = LOAD_FLOAT("parameters", 0, PARAM_LIGHT + 1) - oy;
                dz = LOAD_FLOAT("parameters", 0, PARAM_LIGHT + 2) - oz;
                float cosine_times_distance = nx * dx + ny * dy + nz * dz;
                if (cosine_times_distance > 0.f) {
                    float squared = dx * dx + dy * dy + dz * dz;
                    float inverse = inverse_square_root(squared);
                    local[10] = throughput * 0.318309886f * cosine_times_distance * inverse * inverse * inverse;
                    t_max = 1.f;
                    any = 1;
                    continue;
                }
            }
            if (bounce == 0) break;
            bounce--;
            // A cosine-weighted direction around the normal.
            float r0 = random_number(), r1 = random_number() * 6.28318531f;
            float sin = sine(r1), cos = cosine(r1);
            float radius = r0 * inverse_square_root(r0), up = 1.f - r0;
            up *= inverse_square_root(up);
            float nx = local[13], ny = local[14], nz = local[15];
            float sign = from_bits((bits(nz) & (int)0x80000000) | 0x3f800000);
            float a = -1.f / (sign + nz), b = nx * ny * a;
            float p = radius * cos, q = radius * sin;
            dx = (1.f + sign * nx * nx * a) * p + b * q + nx * up;
            dy = sign * b * p + (sign + ny * ny * a) * q + ny * up;
            dz = nz * up - sign * nx * p - ny * q;
            t_max = __builtin_inff();
            any = 0;
        }
        int pixel = LOAD_INT("parameters", 0, PARAM_OUT) + item * 3;
        STORE_FLOAT("pixel", local[0], pixel, 0);
        STORE_FLOAT("pixel", local[1], pixel, 1);
        STORE_FLOAT("pixel", local[2], pixel, 2);
    }
    return 0;
}
