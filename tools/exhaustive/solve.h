/* What the references share: constants, loops over lanes, the last step of a solution. */
#ifndef SOLVE_H
#define SOLVE_H

#include "decay.h"
#include "plain.h"

#define FAR 64.0
#define STEPS 12
#define ONE ((dd){1.0, 0.0})
#define EACH for (int i = 0; i < LANES; i++)

static inline double least(double a, double b) { return a < b ? a : b; }

static inline dd chosen(int yes, dd a, dd b) { return (dd){yes ? a.hi : b.hi, yes ? a.lo : b.lo}; }

/* x, or 1 from `end` on, where a formula without the solution serves */
static inline double nearer(double x, double end) { return x < end ? x : 1.0; }

/* for the next step, or the one in pairs, to be the last: the error left is about its square */
static inline int too_long(double step, double t) { return fabs(step) > 0x1p-24 * t; }

/* the step, or NaN where it is too long for its square to be left out */
static inline double checked(double step, double t) { return fabs(step) <= 0x1p-40 * t ? step : NAN; }

/* t + step as a pair, lo NaN where the step is too long */
static inline dd improved(double t, double step)
{
    const dd sum = dd_sum(t, step);
    return (dd){sum.hi, fabs(step) <= 0x1p-40 * t ? sum.lo : NAN};
}

/* s > 0 with 1 + (s - 1) exp(s) = square, that is s^2 B = square E: the double s, its decays, and what s lacks */
void launch(const pairs *square, double *s, decay *d, double *lacking);

/* LANES values each, for x in the domain and 2^-200 <= |x| <= 2^200 */
void phi1m(const double *x, pairs *value);
void phi2m(const double *x, pairs *value);
void descent_factor(const double *x, pairs *value);
void flight_factor(const double *x, pairs *value);
void range_factor(const double *x, pairs *value);
void best_sine(const double *x, pairs *value);
void best_angle(const double *x, pairs *value);
void max_range_factor(const double *x, pairs *value);
void w0_offset(const double *x, pairs *value);
void wm1_offset(const double *x, pairs *value);
void w0(const double *x, pairs *value);
void wm1(const double *x, pairs *value);
void exp_minus(const double *x, pairs *value);
void sine(const double *x, pairs *value);
void cosine(const double *x, pairs *value);
void arctangent(const double *x, pairs *value);

#endif
