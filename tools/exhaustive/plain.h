/* Doubles for first guesses, without a call that would keep a loop from being vectorised. */
#ifndef PLAIN_H
#define PLAIN_H

#include <math.h>
#include <stdint.h>
#include <string.h>

/* log(x), x normal: 2 artanh((m - 1)/(m + 1)), x = 2^e m, m within a factor sqrt(2) of 1 */
static inline double plain_log(double x)
{
    int64_t bits, e;
    double m;
    memcpy(&bits, &x, sizeof bits);
    e = (bits - 0x3fe6a09e667f3bcd) >> 52;
    bits -= e * (INT64_C(1) << 52);
    memcpy(&m, &bits, sizeof m);
    const double f = (m - 1.0) / (m + 1.0), g = f * f;
    double q = 1.0 / 19.0;
    q = fma(q, g, 1.0 / 17.0);
    q = fma(q, g, 1.0 / 15.0);
    q = fma(q, g, 1.0 / 13.0);
    q = fma(q, g, 1.0 / 11.0);
    q = fma(q, g, 1.0 / 9.0);
    q = fma(q, g, 1.0 / 7.0);
    q = fma(q, g, 1.0 / 5.0);
    q = fma(q, g, 1.0 / 3.0);
    return fma(0.6931471805599453, (double)e, fma(2.0 * f * g, q, 2.0 * f));
}

/* log(1 + x), x >= 0 */
static inline double plain_log1p(double x)
{
    const double sum = 1.0 + x;
    return x < 0x1p-30 ? x : plain_log(sum) * (x / (sum - 1.0));
}

/* arctan(x), 0 <= x <= 1: the angle halved twice, then its power series */
static inline double plain_arctan(double x)
{
    const double half = x / (1.0 + sqrt(1.0 + x * x)), quarter = half / (1.0 + sqrt(1.0 + half * half));
    const double g = -quarter * quarter;
    double q = 1.0 / 23.0;
    q = fma(q, g, 1.0 / 21.0);
    q = fma(q, g, 1.0 / 19.0);
    q = fma(q, g, 1.0 / 17.0);
    q = fma(q, g, 1.0 / 15.0);
    q = fma(q, g, 1.0 / 13.0);
    q = fma(q, g, 1.0 / 11.0);
    q = fma(q, g, 1.0 / 9.0);
    q = fma(q, g, 1.0 / 7.0);
    q = fma(q, g, 1.0 / 5.0);
    q = fma(q, g, 1.0 / 3.0);
    return 4.0 * fma(quarter * g, q, quarter);
}

#endif
