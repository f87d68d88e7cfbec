/* Values of the primitives as hi + lo, from their definitions; no coefficient and no code of the emitted kernels.
 *
 * An implicit definition G(t, x) = 0 is solved by Newton's method in doubles, whose result needs no proof, and then by one
 * step from the double t so found, with G in pairs: its rounding error is below 2^-70 of t, and what the step leaves is
 * below (step/t)^2. Where the step is more than 2^-40 of t, lo is NaN: undecided, like any input too near a midpoint.
 * From t = FAR on exp(-t) < 2^-92 is left out, where that is a share of the value. REFERENCE_ERROR is counted on by what
 * uses the values.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include <stddef.h>

#define REFERENCE_ERROR 0x1p-64
#define REFERENCE_LANES 256

typedef struct {
    double hi[REFERENCE_LANES], lo[REFERENCE_LANES];
} pairs;

typedef struct {
    const char *name;
    void (*values)(const double *x, pairs *value); /* for x in the domain, not 0 and finite; x > 0 if there is a parity */
    int parity;                                    /* -1 odd, 1 even, 0 neither */
    double least, greatest;                        /* the domain */
    double ordinary;                               /* some x in it */
    double at_zero, at_minus_zero, at_infinity;
} reference;

/* By name; NULL if there is none. */
const reference *reference_of(const char *name);

/* REFERENCE_LANES values anywhere: limits at 0 and infinity, NaN for what is no argument. */
void reference_values(const reference *of, const double *x, double *hi, double *lo);

#endif
