/* Sums of two doubles, hi + lo, |lo| <= ulp(hi)/2. Each operation errs by at most 2^-102 of its result, where no part
 * underflows (Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
 * ACM Trans. Math. Softw. 44, 2017, give 3 to 10 times 2^-106), or, in a sum whose terms cancel, of the larger term.
 * Compile without contraction of a*b + c.
 */
#ifndef DOUBLE_DOUBLE_H
#define DOUBLE_DOUBLE_H

#include <math.h>

typedef struct {
    double hi, lo;
} dd;

static inline dd dd_fast_sum(double a, double b) /* exact where |a| >= |b| */
{
    const double s = a + b;
    return (dd){s, b - (s - a)};
}

static inline dd dd_sum(double a, double b) /* exact */
{
    const double s = a + b, v = s - a;
    return (dd){s, (a - (s - v)) + (b - v)};
}

static inline dd dd_product(double a, double b) /* exact */
{
    const double p = a * b;
    return (dd){p, fma(a, b, -p)};
}

static inline dd dd_add(dd a, dd b)
{
    const dd s = dd_sum(a.hi, b.hi);
    return dd_fast_sum(s.hi, s.lo + (a.lo + b.lo));
}

static inline dd dd_add_double(dd a, double b)
{
    const dd s = dd_sum(a.hi, b);
    return dd_fast_sum(s.hi, s.lo + a.lo);
}

static inline dd dd_minus(dd a) { return (dd){-a.hi, -a.lo}; }

static inline dd dd_times_power(dd a, double power) { return (dd){a.hi * power, a.lo * power}; } /* exact, of two */

static inline dd dd_mul(dd a, dd b)
{
    const dd p = dd_product(a.hi, b.hi);
    return dd_fast_sum(p.hi, p.lo + fma(a.hi, b.lo, a.lo * b.hi));
}

static inline dd dd_mul_double(dd a, double b)
{
    const dd p = dd_product(a.hi, b);
    return dd_fast_sum(p.hi, fma(a.lo, b, p.lo));
}

static inline dd dd_div(dd a, dd b)
{
    const double q = a.hi / b.hi;
    const double rest = fma(-q, b.hi, a.hi); /* exact */
    return dd_fast_sum(q, (rest + fma(-q, b.lo, a.lo)) / b.hi);
}

#endif
