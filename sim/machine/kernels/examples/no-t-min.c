// Ordered traversal whose stack entries do not keep where the ray enters them: an entry is a word shorter, and none is dropped
// when it is popped. Only the sorting of BVH4 and BVH8 needs the distance, and keeps it.
//
//     dualsplit simulate SCENE --structure S --kernel no-t-min.c
#define NO_ENTRY_T_MIN
#include "frame.c"
