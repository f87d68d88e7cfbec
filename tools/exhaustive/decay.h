/* E = exp(-t), A = (1 - E)/t and B = (t - 1 + E)/t^2 for 0 <= t <= 512, LANES numbers at a time, without libm and without a
 * table: B's power series at t/2^k <= 1/16, A = 1 - t B, E = 1 - t A, then k times
 *     B(2t) = (A^2 + 2 B)/4,  A(2t) = A (1 + E)/2,  E(2t) = E^2,
 * where nothing cancels, all terms being positive.
 */
#ifndef DECAY_H
#define DECAY_H

#include "double_double.h"
#include "reference.h"

#if defined(__clang__)
#define UNROLLED _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define UNROLLED _Pragma("GCC unroll 16")
#else
#define UNROLLED
#endif

enum { LANES = REFERENCE_LANES, TERMS = 16, PAIRED = 6, DOUBLINGS = 13 };
#define LARGEST_DECAY 512.0

typedef struct {
    pairs e, a, b;
} decay;

static inline dd pair(const pairs *p, int i) { return (dd){p->hi[i], p->lo[i]}; }

static inline void put(pairs *p, int i, dd value)
{
    p->hi[i] = value.hi;
    p->lo[i] = value.lo;
}

/* the same in doubles, for first guesses */
typedef struct {
    double e[LANES], a[LANES], b[LANES];
} plain_decay;

void decays(const double *t, decay *d);
void plain_decays(const double *t, plain_decay *d);

#endif
