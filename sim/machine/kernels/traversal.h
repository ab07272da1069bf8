// Traversal of one ray, from `node`'s start to `traced`. Sets `hit` and `t_max`; `any` ends at the first hit.

// The root's box, tested in software: planes of entry and of exit by the signs of the direction.
{
    float x0 = PARAMETER_FLOAT(PARAM_ROOT), y0 = PARAMETER_FLOAT(PARAM_ROOT + 1), z0 = PARAMETER_FLOAT(PARAM_ROOT + 2),
          x1 = PARAMETER_FLOAT(PARAM_ROOT + 3), y1 = PARAMETER_FLOAT(PARAM_ROOT + 4), z1 = PARAMETER_FLOAT(PARAM_ROOT + 5);
    float t0 = (ENTERED(x) - ox) * ix, t1 = (ENTERED(y) - oy) * iy, t2 = (ENTERED(z) - oz) * iz;
    float u0 = (LEFT(x) - ox) * jx, u1 = (LEFT(y) - oy) * jy, u2 = (LEFT(z) - oz) * jz;
    t_min = maximum(maximum(t0, t1), maximum(t2, t_min));
    float exit = minimum(minimum(u0, u1), minimum(u2, t_max));
    if (t_min > exit) goto traced;
#if defined(DST) || defined(DST_SOFTWARE)
    float best = t_max;
    t_max = exit;
    node = 0;
#else
    node = PARAMETER_INT(PARAM_ROOT + 6);
#define best t_max
#endif

    while (1) {
        int triangle;
#if defined(DST)
        // One operation of the pipeline: code 0 miss, 1 near child, 2 both, 3 leaf.
        int at = nodes + node, code, near, far;
        int word = LOAD_INT(at, 0);
        float plane0 = LOAD_FLOAT(at, 1), plane1 = LOAD_FLOAT(at, 2), far_t_min, far_t_max;
        asm volatile("DSTSTEP %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, %16, %17, %18"
                     : "=r"(code), "=r"(near), "=r"(far), "+f"(t_min), "+f"(t_max), "=f"(far_t_min), "=f"(far_t_max)
                     : "r"(word), "f"(plane0), "f"(plane1), "f"(ox), "f"(oy), "f"(oz), "f"(ix), "f"(iy), "f"(iz),
                       "f"(jx), "f"(jy), "f"(jz));
        node = near;
        if (code == 1) continue;
        if (code == 2) {
            stack[depth].node = far;
            KEEP_T_MIN(far_t_min)
            stack[depth].t_max = far_t_max;
            depth++;
            continue;
        }
        if (code == 0) goto pop;
        triangle = near;
#elif defined(DST_SOFTWARE)
        // The ray's components are read by axis from the local store.
        int at = nodes + node;
        int word = LOAD_INT(at, 0);
        int offset = word & NODE_OFFSET;
        if (word < 0) {
            // Carve: fold both planes into the interval.
            int kind = word >> AXIS_BIT & 3, size = word >> SIZE_BIT & 3;
            float plane0 = LOAD_FLOAT(at, 1), plane1 = LOAD_FLOAT(at, 2);
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
            // This keeps the branches apart. Without it, clang 14 makes conditional moves and a dispatch of them, ten instructions more.
            asm volatile("");
            node = offset;
            if (!(word >> LEAF_BIT & 1)) continue;
            triangle = offset;
        } else if (word >> LEAF_BIT & 1) {
            triangle = offset;
        } else {
            int axis_code = word >> AXIS_BIT & 3, size = word >> SIZE_BIT & 3;
            float plane0 = LOAD_FLOAT(at, 1), plane1 = LOAD_FLOAT(at, 2);
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
                    KEEP_T_MIN(far_entry)
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
            int at = FIRST_CHILD(node);
            float left, right;
            int hits;
#define CHILD(c, offset)                                                                               \
    int c = LOAD_INT(at, offset);                                                                      \
    float c##0 = LOAD_FLOAT(at, offset + 1), c##1 = LOAD_FLOAT(at, offset + 2),                  \
          c##2 = LOAD_FLOAT(at, offset + 3), c##3 = LOAD_FLOAT(at, offset + 4),                  \
          c##4 = LOAD_FLOAT(at, offset + 5), c##5 = LOAD_FLOAT(at, offset + 6);
            CHILD(l, 0)
#ifdef PARALLEL
            CHILD(r, 7)
            asm volatile("BOXTEST2 %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, %16, %17, %18, "
                         "%19, %20, %21, %22, %23, %24"
                         : "=r"(hits), "=f"(left), "=f"(right)
                         : "f"(l0), "f"(l1), "f"(l2), "f"(l3), "f"(l4), "f"(l5), "f"(r0), "f"(r1), "f"(r2), "f"(r3),
                           "f"(r4), "f"(r5), "f"(ox), "f"(oy), "f"(oz), "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy),
                           "f"(jz), "f"(t_max));
            int hit_left = hits & 1, hit_right = hits & 2;
#else
            int hit_left, hit_right;
#define BOXTEST(c, hit, entry)                                                                               \
    asm volatile("BOXTEST %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, %16, %17"    \
                 : "=r"(hit), "=f"(entry)                                                                    \
                 : "f"(c##0), "f"(c##1), "f"(c##2), "f"(c##3), "f"(c##4), "f"(c##5), "f"(ox), "f"(oy),       \
                   "f"(oz), "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz), "f"(t_max));
            BOXTEST(l, hit_left, left)
            CHILD(r, 7)
            BOXTEST(r, hit_right, right)
#endif
            if (hit_left) {
                if (hit_right) {
                    int near = l, far = r;
                    float entry = right;
                    if (right < left) near = r, far = l, entry = left;
                    stack[depth].node = far;
                    KEEP_T_MIN(entry)
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
            int at = FIRST_CHILD(node);
            int word = LOAD_INT(at, 0);
            int count = (word >> 28 & 7) + 1, bottom = depth;
#ifdef PARALLEL
            // Every child's box is loaded to a lane of its own: the first to the highest.
            int hits, lane = count, box = at;
            float entry;
            do {
                BOX_LOAD(lane, box, 1) BOX_LOAD(lane, box, 2) BOX_LOAD(lane, box, 3)
                BOX_LOAD(lane, box, 4) BOX_LOAD(lane, box, 5) BOX_LOAD(lane, box, 6)
                box += 7;
            } while (--lane > 0);
            asm volatile("BOXTESTS %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11"
                         : "=r"(hits)
                         : "r"(count), "f"(ox), "f"(oy), "f"(oz), "f"(ix), "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz),
                           "f"(t_max));
            do {
                if (hits & 1) {
                    asm volatile("ENTRY %0, %1" : "=f"(entry) : "r"(count));
                    word = LOAD_INT(at, 0);
#else
            do {
                int hit_child;
                float entry, c0 = LOAD_FLOAT(at, 1), c1 = LOAD_FLOAT(at, 2),
                             c2 = LOAD_FLOAT(at, 3), c3 = LOAD_FLOAT(at, 4),
                             c4 = LOAD_FLOAT(at, 5), c5 = LOAD_FLOAT(at, 6);
                asm volatile("BOXTEST %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, %16, %17"
                             : "=r"(hit_child), "=f"(entry)
                             : "f"(c0), "f"(c1), "f"(c2), "f"(c3), "f"(c4), "f"(c5), "f"(ox), "f"(oy), "f"(oz), "f"(ix),
                               "f"(iy), "f"(iz), "f"(jx), "f"(jy), "f"(jz), "f"(t_max));
                word = LOAD_INT(at, 0);
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
            float ax = LOAD_FLOAT(row0, 0) - o0, bx = LOAD_FLOAT(row0, 1) - o0, cx = LOAD_FLOAT(row0, 2) - o0;
            float ay = LOAD_FLOAT(row1, 0) - o1, by = LOAD_FLOAT(row1, 1) - o1, cy = LOAD_FLOAT(row1, 2) - o1;
            float az = LOAD_FLOAT(row2, 0) - o2, bz = LOAD_FLOAT(row2, 1) - o2, cz = LOAD_FLOAT(row2, 2) - o2;
            int tag = LOAD_INT(triangle, 9);
            float m = maximum(maximum(maximum(absolute(ax), absolute(bx)), absolute(cx)),
                              maximum(maximum(maximum(absolute(ay), absolute(by)), absolute(cy)),
                                      maximum(maximum(absolute(az), absolute(bz)), absolute(cz))));
            ax -= az * shear0, bx -= bz * shear0, cx -= cz * shear0;
            ay -= az * shear1, by -= bz * shear1, cy -= cz * shear1;
            float e = maximum(maximum(maximum(absolute(ax), absolute(bx)), absolute(cx)),
                              maximum(maximum(absolute(ay), absolute(by)), absolute(cy)));
            float bound = m * 2.38418579e-6f * (e + m * 2.38418579e-7f);
            float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax, t;
            float least = minimum(minimum(u, v), w), most = maximum(maximum(u, v), w);
            // Nothing over- or underflows if m is from 2^-30 on and below 2^35.
            if ((unsigned)bits(m) - 0x30800000u < 0x20800000u) {
                if (most > bound && least < -bound) goto next_triangle;
                if (least > bound || most < -bound) {
                    float depth = u * az + v * bz + w * cz;
                    if (absolute(depth) > 4.f * m * (bound + 2.38418579e-7f * maximum(most, -least))) {
                        float inverse = 1.f / (u + v + w);
                        t = depth * scale * inverse;
                        u = v * inverse, v = w * inverse;
                        goto located;
                    }
                }
            }
            {
                // Not certain: decided exactly, by the library's routine.
                int met;
                asm volatile("EXACT %0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10"
                             : "=r"(met), "=f"(t), "=f"(u), "=f"(v)
                             : "r"(triangle), "f"(ox), "f"(oy), "f"(oz), "f"(local[4]), "f"(local[5]), "f"(local[6]));
                if (!met) goto next_triangle;
            }
        located:
            // Within the interval of its own box, as a tree would have it.
            {
                float px = LOAD_FLOAT(triangle, 0), qx = LOAD_FLOAT(triangle, 1), rx = LOAD_FLOAT(triangle, 2),
                      py = LOAD_FLOAT(triangle, 3), qy = LOAD_FLOAT(triangle, 4), ry = LOAD_FLOAT(triangle, 5),
                      pz = LOAD_FLOAT(triangle, 6), qz = LOAD_FLOAT(triangle, 7), rz = LOAD_FLOAT(triangle, 8);
                float x0 = minimum(minimum(px, qx), rx), x1 = maximum(maximum(px, qx), rx);
                float y0 = minimum(minimum(py, qy), ry), y1 = maximum(maximum(py, qy), ry);
                float z0 = minimum(minimum(pz, qz), rz), z1 = maximum(maximum(pz, qz), rz);
                float from = maximum(maximum((ENTERED(x) - ox) * ix, (ENTERED(y) - oy) * iy), (ENTERED(z) - oz) * iz);
                float to = minimum(minimum((LEFT(x) - ox) * jx, (LEFT(y) - oy) * jy), (LEFT(z) - oz) * jz);
                t = minimum(maximum(t, from), to);
                if (from > to || t < 0.f || t > best) goto next_triangle;
            }
            // Of several at the same distance, the triangle of the lowest index.
            {
                int index = tag & TRIANGLE_INDEX;
                if (t >= best && index >= best_index) goto next_triangle;
                best_index = index;
            }
            best = t;
            hit = triangle;
            local[11] = u, local[12] = v;
            if (any) goto traced;
        next_triangle:
            if (tag >> LAST_BIT & 1) break;
            triangle += 10;
        }
    pop:
        do {
            if (depth == 0) goto traced;
            depth--;
        } while (IS_BEHIND(best));
        node = stack[depth].node;
#if defined(DST) || defined(DST_SOFTWARE)
        t_min = KEPT_T_MIN;
        t_max = minimum(stack[depth].t_max, best);
#endif
    }
}
#undef best
