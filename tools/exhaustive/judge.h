/* A binary32 function held against its reference at consecutive inputs, all of them. */
#ifndef JUDGE_H
#define JUDGE_H

#include <stddef.h>
#include <stdint.h>

#include "reference.h"

enum { LISTED = 4096, SPARSELY = 16 };

/* How near a midpoint of floats an input's value may be, relatively, for the reference to decide it. */
#define DECISION 0x1p-50

typedef void (*array_function)(size_t n, const float *x, float *value);

typedef struct {
    uint64_t right, refused, wrong, undecided, differing; /* refused: NaN where NaN is due */
    double nearest;                                       /* least relative distance to a midpoint among the decided */
    uint32_t nearest_input;
    uint32_t wrong_inputs[LISTED], undecided_inputs[LISTED], differing_inputs[LISTED]; /* bits; the first ones of each */
} report;

/* Judge tested[0] at the inputs whose bits are first ... first + count - 1, and in one of SPARSELY stretches of
 * REFERENCE_LANES inputs hold the other versions against its bits.
 * first and count are multiples of REFERENCE_LANES; the report is added to.
 */
void judge(const reference *of, const array_function *tested, int versions, uint32_t first, uint64_t count, report *found);

#endif
