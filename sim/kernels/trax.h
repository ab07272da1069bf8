// Operations of the machine that C has not. The text behind "#:" says what an address belongs to; it reaches the listing.
#ifndef TRAX_H
#define TRAX_H
#define INLINE static inline __attribute__((always_inline))

// Words of the parameter block at the start of memory.
enum { PARAM_RAYS = 1, PARAM_OUT = 7, PARAM_NODES = 8, PARAM_RAY_BASE = 14 };

#define LOAD_INT(what, address, offset)                                                                      \
    ({                                                                                                       \
        int loaded;                                                                                          \
        asm volatile("LOAD %0, %1, %2 #: " what : "=r"(loaded) : "r"(address), "i"(offset));                 \
        loaded;                                                                                              \
    })
#define LOAD_FLOAT(what, address, offset)                                                                    \
    ({                                                                                                       \
        float loaded;                                                                                        \
        asm volatile("LOAD %0, %1, %2 #: " what : "=f"(loaded) : "r"(address), "i"(offset));                 \
        loaded;                                                                                              \
    })
#define STORE_INT(what, value, address, offset)                                                              \
    asm volatile("STORE %0, %1, %2 #: " what ::"r"(value), "r"(address), "i"(offset))
#define STORE_FLOAT(what, value, address, offset)                                                            \
    asm volatile("STORE %0, %1, %2 #: " what ::"f"(value), "r"(address), "i"(offset))

INLINE float minimum(float a, float b) {
    float r;
    asm("FPMIN %0, %1, %2" : "=f"(r) : "f"(a), "f"(b));
    return r;
}
INLINE float maximum(float a, float b) {
    float r;
    asm("FPMAX %0, %1, %2" : "=f"(r) : "f"(a), "f"(b));
    return r;
}
// The next number of the counter that all threads share.
INLINE int next_item(void) {
    int r;
    asm volatile("ATOMIC_INC %0, 0" : "=r"(r));
    return r;
}
#endif
