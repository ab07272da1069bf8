// Traversal of one ray, from `node`'s start to `traced`. Sets `hit` and `t_max`; `any` ends at the first hit.

// The root's box, tested in software.
{
    float x0 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT) - ox), y0 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT + 1) - oy),
          z0 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT + 2) - oz), x1 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT + 3) - ox),
          y1 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT + 4) - oy), z1 = (LOAD_FLOAT("parameters", 0, PARAM_ROOT + 5) - oz);
    float t0 = minimum(x0 * ix, x1 * ix), t1 = minimum(y0 * iy, y1 * iy), t2 = minimum(z0 * iz, z1 * iz);
    float u0 = maximum(x0 * jx, x1 * jx), u1 = maximum(y0 * jy, y1 * jy), u2 = maximum(z0 * jz, z1 * jz);
    t_min = maximum(maximum(t0, t1), maximum(t2, t_min));
    float exit = minimum(minimum(u0, u1), minimum(u2, t_max));
    if (t_min > exit) goto traced;
#if defined(DST) || defined(DST_SOFTWARE)
    float best = t_max;
    t_max = exit;
    node = 0;
#else
    node = LOAD_INT("parameters", 0, PARAM_ROOT + 6);
#define best t_max
#endif

    while (1) {
        int triangle;
#if defined(DST)
        // One operation of the pipeline: code 0 miss, 1 near child, 2 both, 3 leaf.
        int at = nodes + node, code, near, far;
        int word = LOAD_INT("node", at, 0);
        float plane0 = LOAD_FLOAT("node", at, 1), plane1 = LOAD_FLOAT("node", at, 2), far_t_min, far_t_max;
        asm volatile("DSTSTEP %0, %1, %2, %3, %4, %5, %6, %7, %8, %9"
                     : "=r"(code), "=r"(near), "=r"(far), "+f"(t_min), "+f"(t_max), "=f"(far_t_min), "=f"(far_t_max)
                     : "r"(word), "f"(plane0), "f"(plane1), "f"(ox), "f"(oy), "f"(oz), "f"(ix), "f"(iy), "f"(iz),
                       "f"(jx), "f"(jy), "f"(jz));
        node = near;
        if (code == 1) continue;
        if (code == 2) {
            stack[depth].node = far;
            stack[depth].t_min = far_t_min;
            stack[depth].t_max = far_t_max;
            depth++;
            continue;
        }
        if (code == 0) goto pop;
        triangle = near;
#elif defined(DST_SOFTWARE)
        // The ray's components are read by axis from the local store.
        int at = nodes + node;
        int word = LOAD_INT("node", at, 0);
        int offset = word & NODE_OFFSET;
        if (word < 0) {
            // Carve: fold both planes into the interval.
            int kind = word >> AXIS_BIT & 3, size = word >> SIZE_BIT & 3;
            float plane0 = LOAD_FLOAT("node", at, 1), plane1 = LOAD_FLOAT("node", at, 2);
            if (kind == 2) {
                float o = local[7 + size], i = local[16 + size], j = local[19 + size];
                if (i < 0.f) {
                    t_max = minimum(t_max, (plane1 - o) * j);
                    t_min = maximum(t_min, (plane0 - o) * i);
                } else {
                    t_max = minimum(t_max, (plane0 - o) * j);
                    t_min = maximum(t_min, (plane1 - o) * i);
                }
            } else {
                int first = kind >> 1, second = (kind & 1) + 1;
                float i0 = local[16 + first], i1 = local[16 + second];
                plane0 -= local[7 + first], plane1 -= local[7 + second];
                if ((bits(i0) >> 31 & 1) == size >> 1)
                    t_max = minimum(t_max, plane0 * local[19 + first]);
                else
                    t_min = maximum(t_min, plane0 * i0);
                if ((bits(i1) >> 31 & 1) == (size & 1))
                    t_max = minimum(t_max, plane1 * local[19 + second]);
                else
                    t_min = maximum(t_min, plane1 * i1);
            }
            if (t_min > t_max) goto pop;
            node = offset;
            if (!(word >> LEAF_BIT & 1)) continue;
            triangle = offset;
        } else if (word >> LEAF_BIT & 1) {
            triangle = offset;
        } else {
            int axis_code = word >> AXIS_BIT & 3, size = word >> SIZE_BIT & 3;
            float plane0 = LOAD_FLOAT("node", at, 1), plane1 = LOAD_FLOAT("node", at, 2);
            float o = local[7 + axis_code], i = local[16 + axis_code], j = local[19 + axis_code];
            int near = offset, far = offset + size;
            float near_exit, far_entry;
            if (i < 0.f) {
                near = offset + size, far = offset;
                near_exit = minimum(t_max, (plane1 - o) * j), far_entry = maximum(t_min, (plane0 - o) * i);
            } else {
                near_exit = minimum(t_max, (plane0 - o) * j), far_entry = maximum(t_min, (plane1 - o) * i);
            }
            if (t_min <= near_exit) {
                if (far_entry <= t_max) {
                    stack[depth].node = far;
                    stack[depth].t_min = far_entry;
                    stack[depth].t_max = t_max;
                    depth++;
                }
                node = near;
                t_max = near_exit;
                continue;
            }
            node = far;
            t_min = far_entry;
            if (far_entry <= t_max) continue;
            goto pop;
        }
#elif BVH == 2
        if (node < 0) {
            triangle = node & BVH_INDEX;
        } else {
            int at = nodes + (node & BVH_INDEX) * 7;
            float left, right;
            int hits;
#define CHILD(c, what, offset)                                                                               \
    int c = LOAD_INT(what, at, offset);                                                                      \
    float c##0 = LOAD_FLOAT(what, at, offset + 1), c##1 = LOAD_FLOAT(what, at, offset + 2),                  \
          c##2 = LOAD_FLOAT(what, at, offset + 3), c##3 = LOAD_FLOAT(what, at, offset + 4),                  \
          c##4 = LOAD_FLOAT(what, at, offset + 5), c##5 = LOAD_FLOAT(what, at, offset + 6);
            CHILD(l, "node", 0)
#ifdef PARALLEL
            CHILD(r, "node", 7)
            asm volatile("BOXTEST2 %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14"
                         : "=r"(hits), "=f"(left), "=f"(right)
                         : "f"(l0), "f"(l1), "f"(l2), "f"(l3), "f"(l4), "f"(l5), "f"(r0), "f"(r1), "f"(r2), "f"(r3),
                           "f"(r4), "f"(r5), "f"(ox), "f"(oy), "f"(oz), "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy),
                           "f"(jz), "f"(t_max));
            int hit_left = hits & 1, hit_right = hits & 2;
#else
            int hit_left, hit_right;
#define BOXTEST(c, hit, entry)                                                                               \
    asm volatile("BOXTEST %0, %1, %2, %3, %4, %5, %6, %7"                                                    \
                 : "=r"(hit), "=f"(entry)                                                                    \
                 : "f"(c##0), "f"(c##1), "f"(c##2), "f"(c##3), "f"(c##4), "f"(c##5), "f"(ox), "f"(oy),       \
                   "f"(oz), "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz), "f"(t_max));
            BOXTEST(l, hit_left, left)
            CHILD(r, "node", 7)
            BOXTEST(r, hit_right, right)
#endif
            if (hit_left) {
                if (hit_right) {
                    int near = l, far = r;
                    float entry = right;
                    if (right < left) near = r, far = l, entry = left;
                    stack[depth].node = far;
                    stack[depth].t_min = entry;
                    depth++;
                    node = near;
                } else
                    node = l;
                continue;
            }
            node = r;
            if (hit_right) continue;
            goto pop;
        }
#else
        if (node < 0) {
            triangle = node & BVH_INDEX;
        } else {
            // All children that are hit go on the stack, the farthest first; the nearest is taken from it at once.
            int at = nodes + (node & BVH_INDEX) * 7;
            int word = LOAD_INT("child", at, 0);
            int count = (word >> 28 & 7) + 1, bottom = depth;
#ifdef PARALLEL
            int hits, left = count, lane = at;
            float entry, c0, c1, c2, c3, c4, c5;
            do {
                c0 = LOAD_FLOAT("child", lane, 1), c1 = LOAD_FLOAT("child", lane, 2), c2 = LOAD_FLOAT("child", lane, 3);
                c3 = LOAD_FLOAT("child", lane, 4), c4 = LOAD_FLOAT("child", lane, 5), c5 = LOAD_FLOAT("child", lane, 6);
                // The words are loaded to the registers of the child's own pipeline.
                asm volatile("" ::"f"(c0), "f"(c1), "f"(c2), "f"(c3), "f"(c4), "f"(c5));
                lane += 7;
            } while (--left > 0);
            asm volatile("BOXTESTS %0, %1, %2, %3, %4, %5, %6, %7"
                         : "=r"(hits)
                         : "r"(count), "f"(c0), "f"(c1), "f"(c2), "f"(c3), "f"(c4), "f"(c5), "f"(ox), "f"(oy), "f"(oz),
                           "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz), "f"(t_max));
            do {
                if (hits & 1) {
                    asm volatile("ENTRY %0, %1" : "=f"(entry) : "r"(count));
                    word = LOAD_INT("child", at, 0);
#else
            do {
                int hit_child;
                float entry, c0 = LOAD_FLOAT("child", at, 1), c1 = LOAD_FLOAT("child", at, 2),
                             c2 = LOAD_FLOAT("child", at, 3), c3 = LOAD_FLOAT("child", at, 4),
                             c4 = LOAD_FLOAT("child", at, 5), c5 = LOAD_FLOAT("child", at, 6);
                asm volatile("BOXTEST %0, %1, %2, %3, %4, %5, %6, %7"
                             : "=r"(hit_child), "=f"(entry)
                             : "f"(c0), "f"(c1), "f"(c2), "f"(c3), "f"(c4), "f"(c5), "f"(ox), "f"(oy), "f"(oz), "f"(ix),
                               "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz), "f"(t_max));
                word = LOAD_INT("child", at, 0);
                if (hit_child) {
#endif
                    int slot = depth++;
                    while (slot > bottom && stack[slot - 1].t_min <= entry) {
                        stack[slot] = stack[slot - 1];
                        slot--;
                    }
                    stack[slot].node = word;
                    stack[slot].t_min = entry;
                }
                at += 7;
#ifdef PARALLEL
                hits >>= 1;
#endif
            } while (--count > 0);
            goto pop;
        }
#endif
        triangle = triangles + triangle * 10;
        while (1) {
            // golden's TriangleTest: corners relative to the origin, sheared; edge functions against their error bound.
            int row0 = triangle + axis0 * 3, row1 = triangle + axis1 * 3, row2 = triangle + axis * 3;
            float o0 = local[7 + axis0], o1 = local[7 + axis1], o2 = local[7 + axis];
            float ax = LOAD_FLOAT("row0", row0, 0) - o0, bx = LOAD_FLOAT("row0", row0, 1) - o0, cx = LOAD_FLOAT("row0", row0, 2) - o0;
            float ay = LOAD_FLOAT("row1", row1, 0) - o1, by = LOAD_FLOAT("row1", row1, 1) - o1, cy = LOAD_FLOAT("row1", row1, 2) - o1;
            float az = LOAD_FLOAT("row2", row2, 0) - o2, bz = LOAD_FLOAT("row2", row2, 1) - o2, cz = LOAD_FLOAT("row2", row2, 2) - o2;
            int tag = LOAD_INT("triangle", triangle, 9);
            float m = maximum(maximum(maximum(absolute(ax), absolute(bx)), absolute(cx)),
                              maximum(maximum(maximum(absolute(ay), absolute(by)), absolute(cy)),
                                      maximum(maximum(absolute(az), absolute(bz)), absolute(cz))));
            ax -= az * shear0, bx -= bz * shear0, cx -= cz * shear0;
            ay -= az * shear1, by -= bz * shear1, cy -= cz * shear1;
            float e = maximum(maximum(maximum(absolute(ax), absolute(bx)), absolute(cx)),
                              maximum(maximum(absolute(ay), absolute(by)), absolute(cy)));
            float bound = m * 2.38418579e-6f * (e + m * 2.38418579e-7f);
            float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
            float least = minimum(minimum(u, v), w), most = maximum(maximum(u, v), w);
            if (most > bound && least < -bound) goto next_triangle;
            if (least <= bound && most >= -bound) {
                // Not certain: decided exactly, by the library's routine.
                asm volatile("EXACT %0, %1, %2, %3" : "+f"(u), "+f"(v), "+f"(w), "+f"(az));
            }
            float sum = 1.f / (u + v + w), t = (u * az + v * bz + w * cz) * scale * sum;
            // Within the interval of its own box, as a tree would have it.
            {
                float px = LOAD_FLOAT("triangle", triangle, 0), qx = LOAD_FLOAT("triangle", triangle, 1),
                      rx = LOAD_FLOAT("triangle", triangle, 2), py = LOAD_FLOAT("triangle", triangle, 3),
                      qy = LOAD_FLOAT("triangle", triangle, 4), ry = LOAD_FLOAT("triangle", triangle, 5),
                      pz = LOAD_FLOAT("triangle", triangle, 6), qz = LOAD_FLOAT("triangle", triangle, 7),
                      rz = LOAD_FLOAT("triangle", triangle, 8);
                float lx = minimum(minimum(px, qx), rx) - ox, hx = maximum(maximum(px, qx), rx) - ox;
                float ly = minimum(minimum(py, qy), ry) - oy, hy = maximum(maximum(py, qy), ry) - oy;
                float lz = minimum(minimum(pz, qz), rz) - oz, hz = maximum(maximum(pz, qz), rz) - oz;
                float from = maximum(maximum(minimum(lx * ix, hx * ix), minimum(ly * iy, hy * iy)), minimum(lz * iz, hz * iz));
                float to = minimum(minimum(maximum(lx * jx, hx * jx), maximum(ly * jy, hy * jy)), maximum(lz * jz, hz * jz));
                t = minimum(maximum(t, from), to);
                if (from > to || t < 0.f || t > best) goto next_triangle;
            }
            best = t;
            hit = triangle;
            local[11] = v * sum, local[12] = w * sum;
            if (any) goto traced;
        next_triangle:
            if (tag >> LAST_BIT & 1) break;
            triangle += 10;
        }
    pop:
        do {
            if (depth == 0) goto traced;
            depth--;
        } while (stack[depth].t_min > best);
        node = stack[depth].node;
#if defined(DST) || defined(DST_SOFTWARE)
        t_min = stack[depth].t_min;
        t_max = minimum(stack[depth].t_max, best);
#endif
    }
}
#undef best
