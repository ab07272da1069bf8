// Operations of the machine that C has not, and the memory map; sim/machine/src/program/operation.rs defines what each does.
#ifndef TRAX_H
#define TRAX_H
#define INLINE static inline __attribute__((always_inline))

// Defined as `volatile` where minima and maxima keep their place among the loads.
#ifndef IN_ORDER
#define IN_ORDER
#endif

// Words of the parameter block at the start of memory. Addresses count 32-bit words.
enum {
    PARAM_RAYS = 1,          // items: pixels, or rays
    PARAM_BOUNCES = 2,       // diffuse bounces of a path
    PARAM_INVERSE_WIDTH = 3, // 1 / width as a float
    PARAM_WIDTH = 4,         // pixels in a row
    PARAM_OUT = 7,           // address of the picture, three floats a pixel
    PARAM_NODES = 8,         // address of the structure
    PARAM_TRIANGLES = 9,     // address of the triangles, ten words each
    PARAM_PADDING = 10,      // units in the last place between the reciprocals of entry and exit
    PARAM_EXTENT = 11,       // power of two at or below the scene's largest side
    PARAM_RAY_BASE = 14,     // address of the rays
    PARAM_CAMERA = 16,       // eye, corner, right, down
    PARAM_LIGHT = 28,        // position, intensity at a distance of the extent
    PARAM_BACKGROUND = 34,
    PARAM_ROOT = 40, // box, and word 0 of a BVH's root
};

#define LOAD_INT(address, offset)                                                                            \
    ({                                                                                                       \
        int loaded;                                                                                          \
        asm volatile("LOAD %0, %1, %2" : "=r"(loaded) : "r"(address), "i"(offset));                          \
        loaded;                                                                                              \
    })
#define LOAD_FLOAT(address, offset)                                                                          \
    ({                                                                                                       \
        float loaded;                                                                                        \
        asm volatile("LOAD %0, %1, %2" : "=f"(loaded) : "r"(address), "i"(offset));                          \
        loaded;                                                                                              \
    })
#define STORE_INT(value, address, offset) asm volatile("STORE %0, %1, %2" ::"r"(value), "r"(address), "i"(offset))
#define STORE_FLOAT(value, address, offset) asm volatile("STORE %0, %1, %2" ::"f"(value), "r"(address), "i"(offset))
#define PARAMETER_INT(number) LOAD_INT(0, number)
#define PARAMETER_FLOAT(number) LOAD_FLOAT(0, number)

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
INLINE float sine_of(float a) {
    float r;
    asm("SIN %0, %1" : "=f"(r) : "f"(a));
    return r;
}
INLINE float cosine_of(float a) {
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
