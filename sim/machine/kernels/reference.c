// The kernel of the reference runs: software traversal of a BVH2 with 8-word nodes and 11-word triangles.
// With ANY, a ray ends after the first leaf that is hit. Each box is tested before the next one is loaded: the reference's
// count of loads that join a line under way tells (docs/machine.md).
#define IN_ORDER volatile
#include "trax.h"

// Slab test of a box: 6 subtractions, 6 multiplications, 12 minima and maxima.
#define SLAB(b, entry, exit)                                                                                 \
    {                                                                                                        \
        float x0 = (b##0 - ox) * ix, y0 = (b##1 - oy) * iy, z0 = (b##2 - oz) * iz, x1 = (b##3 - ox) * ix,      \
              y1 = (b##4 - oy) * iy, z1 = (b##5 - oz) * iz;                                                  \
        entry = maximum(maximum(maximum(minimum(x0, x1), minimum(y0, y1)), minimum(z0, z1)), 0.f);           \
        exit = minimum(minimum(minimum(maximum(x0, x1), maximum(y0, y1)), maximum(z0, z1)), t);              \
    }
#define LOAD_BOX(b, at)                                                                                \
    float b##0 = LOAD_FLOAT(at, 0), b##1 = LOAD_FLOAT(at, 1), b##2 = LOAD_FLOAT(at, 2),    \
          b##3 = LOAD_FLOAT(at, 3), b##4 = LOAD_FLOAT(at, 4), b##5 = LOAD_FLOAT(at, 5);

int main(void) {
    int nodes = PARAMETER_INT(PARAM_NODES), rays = PARAMETER_INT(PARAM_RAY_BASE),
        out = PARAMETER_INT(PARAM_OUT), n = PARAMETER_INT(PARAM_RAYS);
    int stack[64];
    float stack_entry[64];
    for (int i = next_item(); i < n; i = next_item()) {
        int at = rays + i * 8;
        float ox = LOAD_FLOAT(at, 0), oy = LOAD_FLOAT(at, 1), oz = LOAD_FLOAT(at, 2),
              t_min = LOAD_FLOAT(at, 3), dx = LOAD_FLOAT(at, 4), dy = LOAD_FLOAT(at, 5),
              dz = LOAD_FLOAT(at, 6), t = LOAD_FLOAT(at, 7);
        float ix = 1.f / dx, iy = 1.f / dy, iz = 1.f / dz;
        int hit = -1, depth = 0, node = 0;
        while (1) {
            int address = nodes + node * 8;
            int count = LOAD_INT(address, 6), child = LOAD_INT(address, 7);
            if (count < 0) {
                int pair = nodes + child * 8;
                float left, left_exit, right, right_exit;
                LOAD_BOX(l, pair)
                SLAB(l, left, left_exit)
                LOAD_BOX(r, pair + 8)
                SLAB(r, right, right_exit)
                int hit_left = left <= left_exit, hit_right = right <= right_exit;
                if (hit_left && hit_right) {
                    if (right < left) {
                        stack[depth] = child;
                        stack_entry[depth] = left;
                        node = child + 1;
                    } else {
                        stack[depth] = child + 1;
                        stack_entry[depth] = right;
                        node = child;
                    }
                    depth++;
                    continue;
                }
                if (hit_left) {
                    node = child;
                    continue;
                }
                if (hit_right) {
                    node = child + 1;
                    continue;
                }
            } else {
                for (int k = 0; k < count; k++) {
                    int q = child + k * 11;
                    float ax = LOAD_FLOAT(q, 0), ay = LOAD_FLOAT(q, 1),
                          az = LOAD_FLOAT(q, 2), bx = LOAD_FLOAT(q, 3),
                          by = LOAD_FLOAT(q, 4), bz = LOAD_FLOAT(q, 5),
                          cx = LOAD_FLOAT(q, 6), cy = LOAD_FLOAT(q, 7),
                          cz = LOAD_FLOAT(q, 8);
                    float e0x = ax - cx, e0y = ay - cy, e0z = az - cz;
                    float e1x = bx - cx, e1y = by - cy, e1z = bz - cz;
                    float px = dy * e1z - dz * e1y, py = dz * e1x - dx * e1z, pz = dx * e1y - dy * e1x;
                    float inverse = 1.f / (e0x * px + e0y * py + e0z * pz);
                    float sx = ox - cx, sy = oy - cy, sz = oz - cz;
                    float u = (sx * px + sy * py + sz * pz) * inverse;
                    if (u < 0.f || u > 1.f) continue;
                    float qx = sy * e0z - sz * e0y, qy = sz * e0x - sx * e0z, qz = sx * e0y - sy * e0x;
                    float v = (dx * qx + dy * qy + dz * qz) * inverse;
                    if (v < 0.f || u + v > 1.f) continue;
                    float distance = (e1x * qx + e1y * qy + e1z * qz) * inverse;
                    if (distance > t_min && distance < t) {
                        t = distance;
                        hit = q;
                    }
                }
#ifdef ANY
                if (hit >= 0) break;
#endif
            }
            int found = 0;
            while (depth > 0) {
                depth--;
                if (stack_entry[depth] < t) {
                    node = stack[depth];
                    found = 1;
                    break;
                }
            }
            if (!found) break;
        }
        STORE_FLOAT(t, out + i * 2, 0);
        STORE_INT(hit, out + i * 2, 1);
    }
    return 0;
}
