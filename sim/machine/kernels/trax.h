// Operations of the machine that C has not. The text behind "#:" says what an address belongs to; it reaches the listing.
#ifndef TRAX_H
#define TRAX_H
#define INLINE static inline __attribute__((always_inline))

// Defined as `volatile` where minima and maxima keep their place among the loads.
#ifndef IN_ORDER
#define IN_ORDER
#endif

// Words of the parameter block at the start of memory.
enum {
    PARAM_RAYS = 1,
    PARAM_BOUNCES = 2,
    PARAM_INVERSE_WIDTH = 3,
    PARAM_WIDTH = 4,
    PARAM_OUT = 7,
    PARAM_NODES = 8,
    PARAM_TRIANGLES = 9,
    PARAM_RAY_BASE = 14,
    PARAM_CAMERA = 16, // eye, corner, right, down
    PARAM_LIGHT = 28,  // position, intensity
    PARAM_BACKGROUND = 34,
    PARAM_ROOT = 40, // box, and word 0 of a BVH's root
};

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
    asm IN_ORDER("FPMIN %0, %1, %2" : "=f"(r) : "f"(a), "f"(b));
    return r;
}
INLINE float maximum(float a, float b) {
    float r;
    asm IN_ORDER("FPMAX %0, %1, %2" : "=f"(r) : "f"(a), "f"(b));
    return r;
}
INLINE float inverse_square_root(float a) {
    float r;
    asm("FPINVSQRT %0, %1" : "=f"(r) : "f"(a));
    return r;
}
// A sample of the unit interval; SimTRaX has it, and sine and cosine, as operations of the adders.
INLINE float random_number(void) {
    float r;
    asm volatile("RAND %0" : "=f"(r));
    return r;
}
INLINE float sine(float a) {
    float r;
    asm("SIN %0, %1" : "=f"(r) : "f"(a));
    return r;
}
INLINE float cosine(float a) {
    float r;
    asm("COS %0, %1" : "=f"(r) : "f"(a));
    return r;
}
INLINE int bits(float a) {
    int r;
    asm("mfc1 %0, %1" : "=r"(r) : "f"(a));
    return r;
}
INLINE float from_bits(int a) {
    float r;
    asm("mtc1 %1, %0" : "=f"(r) : "r"(a));
    return r;
}
INLINE float absolute(float a) { return __builtin_fabsf(a); }
// The next number of the counter that all threads share.
INLINE int next_item(void) {
    int r;
    asm volatile("ATOMIC_INC %0, 0" : "=r"(r));
    return r;
}
#endif
