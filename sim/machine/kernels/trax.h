// The machine's programs: operations that C has not, the memory, and the rules. sim/machine/src/program/operation.rs defines each
// operation, docs/machine.md shows how to run a program of your own.
//
// THE PROGRAM is one function `int main(void)`, which every thread of the machine executes:
//
//     int pixels = PARAMETER_INT(PARAM_RAYS);
//     for (int item = next_item(); item < pixels; item = next_item()) { ... }
//     return 0;
//
// An item is a pixel, row by row from the top. It is executed by itself, so items are independent: one that reads what another
// has left in a register, in the local store or in memory is an error. next_item() is called in one place for the first item and
// in one for all others, until it returns the number of pixels. At most 8,192 instructions.
//
// WHAT C HAS: int and float in registers; arrays, structures and pointers to them in the thread's own 32 KiB of local store, which
// the stack grows down in. There are no calls (functions are INLINE; nothing that the compiler would call memcpy or memset for), no
// switch by a table, no integer division, no double, no half-word, and no global or static data but float constants.
//
// GLOBAL MEMORY is read by LOAD_INT, LOAD_FLOAT and BOXLOAD, and written by STORE_INT and STORE_FLOAT. An address counts 32-bit words;
// the offset is a constant in 0..65536. Only the picture can be written: three floats a pixel (red, green, blue), each by its item.
//
// Word 0 on: the parameters PARAM_..., below. Then, each from the address that its parameter says:
//
// Triangles (PARAM_TRIANGLES), ten words each: x of the three corners, their y, their z, and a tag. Bits 25:0 of the tag are the
// triangle's index, which decides between hits at the same distance; bit 27 marks the last triangle of a leaf.
//
// Structure (PARAM_NODES) of dst and dst-sw: node `n` is at word n, the root at 0. Word 0 of a node:
//
//     bits    split                     carve                                             leaf
//     31      0                         1                                                 0
//     30:29   axis                      0 dual x,y; 1 dual x,z; 3 dual y,z; 2 single      0
//     28:27   words of the left child   dual: bit 28 for plane 0, bit 27 for plane 1:     0
//                                       it is a box's minimum; single: axis
//     26      0                         1: a leaf is inside                               1
//     25:0    left child's word         child's word, or index of the first triangle      index of the first triangle
//
// Words 1 and 2 of a split: left child's maximum, right child's minimum; of a single carve: maximum, minimum of the box; of a dual
// carve: the planes on both axes. A leaf has one word. The right child follows the left one.
//
// Structure of bvh2, bvh4, bvh8 and their + forms: node `n` is at word 7 n. Word 0: bit 31 leaf; bits 30:28 siblings - 1; bits 27:0
// index of the first child, or of the first triangle. Words 1 to 3 the box's minimum, 4 to 6 its maximum. Siblings follow each other.
// The root is not among them: its box and its word 0 are at PARAM_ROOT. The dual-split tree's box is there, too.
//
// With another layout.alignment than 0, gaps of zeros lie between the children of one node and those of the next, and bits 27:0 of an
// inner node of a bvh count words, not nodes: where C is compiled, WORD_OFFSETS is defined. Offsets of dst count words anyway.
//
// OPERATIONS beyond those below, as inline assembler (traversal.h shows each; =r is an int, =f a float):
//
//     DSTSTEP code=r, near=r, far=r, t_min+f, t_max+f, far_t_min=f, far_t_max=f, word, plane0, plane1, o x3, i x3, j x3
//         a step through a node of a dual-split tree in t_min..t_max: code 0 miss, 1 go on at near, 2 at near and far, 3 leaf near
//     BOXTEST hit=r, entry=f, box x6, o x3, i x3, j x3, t_max          a box, from 0 to t_max
//     BOXTEST2 hits=r, entry0=f, entry1=f, box x6, box x6, o, i, j, t_max      two; a bit of hits each
//     BOXLOAD lane, address, 1..6 (constant)                           a word of memory to a box in lane 1..8
//     BOXTESTS hits=r, lanes, o x3, i x3, j x3, t_max                  boxes in lanes 1..lanes; bit 0 of hits is lane `lanes`
//     ENTRY entry=f, lane                                              where the box in the lane was entered
//     EXACT hit=r, t=f, u=f, v=f, triangle, o x3, d x3                 the exact triangle test, a routine that counts as one
//
// o is the origin, d the direction, i the reciprocals for planes of entry, j those for planes of exit: i plus PARAM_PADDING units in
// the last place (frame.c). The pipeline of --structure decides which there are: DSTSTEP for dst, BOXTEST for all BVHs, BOXTEST2 and
// lanes for the + forms, as many lanes as the pipeline tests boxes (2, 4, 8). dst-sw has EXACT only, which needs no pipeline.
//
// WHAT IS AN ERROR, with the line of the listing: an instruction that the machine has not; an address outside memory or the local
// store, or a store beside the picture; 2^27 instructions without asking for an item; more than 254 random numbers for an item; an end
// while there are items; a dependence between items; a pixel that is not golden's bit for bit (frame.c has golden's operations in
// golden's order), unless --allow-difference is given.
//
// What is defined for each structure: dst DST, dst-sw DST_SOFTWARE, bvh2 BVH=2, bvh4 and bvh8 BVH=4, the + forms PARALLEL as well;
// WORD_OFFSETS for all of bvh, where nodes are not packed.
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
