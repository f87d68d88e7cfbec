/* Random inputs, and among them those where a binary64 function errs most. */
#ifndef SEARCH_H
#define SEARCH_H

#include <stddef.h>
#include <stdint.h>

#include "reference.h"

enum { WORST = 8 };

typedef void (*double_function)(size_t n, const double *x, double *value);

typedef struct {
    double ulp[WORST], input[WORST]; /* the largest errors, in ulp of the value, and where */
    uint64_t tried, undecided;
} worst_found;

/* n doubles from low to high, by a generator (splitmix64) whose state is advanced: all bit patterns alike, for
 * bounds of one sign, or dense.
 */
void random_inputs(uint64_t *state, size_t n, double low, double high, int dense, double *x);

/* Error in ulp of each of the tested function's values at n inputs, a multiple of REFERENCE_LANES; NaN where undecided. */
void errors(const reference *of, double_function tested, size_t n, const double *x, double *ulp);

/* Try `count` inputs, a multiple of REFERENCE_LANES, from low to high; `found` is added to. */
void search(const reference *of, double_function tested, uint64_t *state, uint64_t count, double low, double high, int dense,
            worst_found *found);

#endif
