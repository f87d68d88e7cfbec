/* b d/a - 1 - log(-c d/a) in integers, where pairs are not enough: is there a root, and how far from a double one.
 *
 * It is 0 only if c d = -a and b d = a: the logarithm of a rational number other than 1 is irrational. Fixed point with
 * 384 bits after the point, rounded down at every step, to the same bits as in NumPy.
 */
#include "galileo_support.h"

#include <stdint.h>
#include <string.h>

#define GS_LIMBS 16    /* of 32 bits, the lowest first; sums wrap, so that differences may be negative */
#define GS_FRACTION 12 /* limbs after the point */
#define GS_BITS (32 * GS_FRACTION)
#define GS_DIGITS 53

#ifdef __GNUC__
#define GS_APART __attribute__((noinline)) /* inlined, gcc 12 -O3 -march=x86-64-v4 makes an endless loop of it */
#else
#define GS_APART
#endif

typedef struct {
    uint32_t limb[GS_LIMBS];
} gs_wide;

static gs_wide gs_wide_of(uint64_t value, int limb)
{
    gs_wide r;
    memset(&r, 0, sizeof r);
    r.limb[limb] = (uint32_t)value;
    r.limb[limb + 1] = (uint32_t)(value >> 32);
    return r;
}

static gs_wide gs_wide_sum(gs_wide a, gs_wide b)
{
    uint64_t carry = 0;
    for (int i = 0; i < GS_LIMBS; i++) {
        carry += (uint64_t)a.limb[i] + b.limb[i];
        a.limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static gs_wide gs_wide_opposite(gs_wide a)
{
    for (int i = 0; i < GS_LIMBS; i++)
        a.limb[i] = ~a.limb[i];
    return gs_wide_sum(a, gs_wide_of(1, 0));
}

static gs_wide gs_wide_difference(gs_wide a, gs_wide b)
{
    return gs_wide_sum(a, gs_wide_opposite(b));
}

static int gs_wide_less(gs_wide a, gs_wide b)
{
    for (int i = GS_LIMBS - 1; i >= 0; i--)
        if (a.limb[i] != b.limb[i])
            return a.limb[i] < b.limb[i];
    return 0;
}

static int gs_wide_is_zero(gs_wide a)
{
    return !gs_wide_less(gs_wide_of(0, 0), a);
}

static gs_wide gs_wide_twice(gs_wide a)
{
    return gs_wide_sum(a, a);
}

/* a m for a small m. */
static gs_wide gs_wide_times(gs_wide a, uint32_t m)
{
    uint64_t carry = 0;
    for (int i = 0; i < GS_LIMBS; i++) {
        carry += (uint64_t)a.limb[i] * m;
        a.limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

/* a/m for a small m, rounded down. */
static GS_APART gs_wide gs_wide_part(gs_wide a, uint32_t m)
{
    uint64_t rest = 0;
    for (int i = GS_LIMBS - 1; i >= 0; i--) {
        rest = (rest << 32) + a.limb[i];
        a.limb[i] = (uint32_t)(rest / m);
        rest %= m;
    }
    return a;
}

/* Product of two numbers in fixed point, rounded down. */
static gs_wide gs_wide_product(gs_wide a, gs_wide b)
{
    uint32_t all[2 * GS_LIMBS] = {0};
    for (int i = 0; i < GS_LIMBS; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < GS_LIMBS; j++) {
            carry += (uint64_t)a.limb[i] * b.limb[j] + all[i + j];
            all[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        all[i + GS_LIMBS] = (uint32_t)carry;
    }
    memcpy(a.limb, all + GS_FRACTION, sizeof a.limb);
    return a;
}

/* Product of two integers of 53 bits. */
static gs_wide gs_wide_integer(uint64_t a, uint64_t b)
{
    gs_wide r = gs_wide_of(0, 0), part = gs_wide_of(a, 0);
    for (; b; b >>= 1, part = gs_wide_twice(part))
        if (b & 1)
            r = gs_wide_sum(r, part);
    return r;
}

/* above/below 2^bits for integers above < below, rounded down. */
static gs_wide gs_wide_quotient(gs_wide above, gs_wide below, int bits)
{
    gs_wide r = gs_wide_of(0, 0);
    for (int i = 0; i < bits; i++) {
        above = gs_wide_twice(above);
        r = gs_wide_twice(r);
        if (!gs_wide_less(above, below)) {
            above = gs_wide_difference(above, below);
            r.limb[0] |= 1;
        }
    }
    return r;
}

/* Inverse hyperbolic tangent of 0 <= z < 1/2. */
static gs_wide gs_wide_atanh(gs_wide z)
{
    const gs_wide square = gs_wide_product(z, z);
    gs_wide total = gs_wide_of(0, 0);
    for (uint32_t order = 1; !gs_wide_is_zero(z); order += 2) {
        total = gs_wide_sum(total, gs_wide_part(z, order));
        z = gs_wide_product(z, square);
    }
    return total;
}

/* Logarithm of above/below 2^exponent, for integers with a quotient between 1/4 and 2. */
static gs_wide gs_wide_log(gs_wide above, gs_wide below, int exponent)
{
    while (gs_wide_less(gs_wide_times(above, 3), gs_wide_times(below, 2))) {
        above = gs_wide_twice(above);
        exponent--;
    }
    if (gs_wide_less(gs_wide_times(below, 4), gs_wide_times(above, 3))) {
        below = gs_wide_twice(below);
        exponent++;
    }
    const int less = gs_wide_less(above, below);
    const gs_wide gap = less ? gs_wide_difference(below, above) : gs_wide_difference(above, below);
    const gs_wide z = gs_wide_quotient(gap, gs_wide_sum(above, below), GS_BITS);
    const gs_wide third = gs_wide_part(gs_wide_of(1, GS_FRACTION), 3);
    const gs_wide near = gs_wide_twice(gs_wide_atanh(z));
    const gs_wide step = gs_wide_times(gs_wide_atanh(third), (uint32_t)(exponent < 0 ? -2 * exponent : 2 * exponent));
    const gs_wide sum = less ? gs_wide_opposite(near) : near;
    return exponent < 0 ? gs_wide_difference(sum, step) : gs_wide_sum(sum, step);
}

/* Integer m, 0 or of 53 bits, and exponent e with |x| = m 2^e. */
static uint64_t gs_integer(double x, int *e)
{
    const double m = frexp(fabs(x), e);
    *e -= GS_DIGITS;
    return (uint64_t)ldexp(m, GS_DIGITS);
}

static int gs_wide_bit(gs_wide a, int i)
{
    return i >= 0 && (a.limb[i / 32] >> (i % 32) & 1);
}

/* The 53 bits below bit n. */
static uint64_t gs_wide_digits(gs_wide a, int n)
{
    uint64_t r = 0;
    for (int i = 1; i <= GS_DIGITS; i++)
        r = 2 * r + (uint64_t)gs_wide_bit(a, n - i);
    return r;
}

/* The value for c d/a < 0, |b d/a| < 2^18; 0 for a double root. */
gs_scaled gs_excess(double a, double b, double c, double d)
{
    int ea, eb, ec, ed, n = 32 * GS_LIMBS - 1;
    const uint64_t ma = gs_integer(a, &ea), mb = gs_integer(b, &eb), mc = gs_integer(c, &ec), md = gs_integer(d, &ed);
    const gs_wide scale = gs_wide_integer(ma, (uint64_t)1 << (GS_DIGITS + 1)); /* above mb md */
    gs_wide value = gs_wide_quotient(gs_wide_integer(mb, md), scale, GS_BITS + GS_DIGITS + 1 + eb + ed - ea);
    if ((a < 0.0) ^ (b < 0.0) ^ (d < 0.0))
        value = gs_wide_opposite(value);
    value = gs_wide_difference(value, gs_wide_of(1, GS_FRACTION));
    const gs_wide below = gs_wide_integer(ma, (uint64_t)1 << GS_DIGITS);
    value = gs_wide_difference(value, gs_wide_log(gs_wide_integer(mc, md), below, ec + ed - ea + GS_DIGITS));
    const int negative = gs_wide_bit(value, n);
    const gs_wide size = negative ? gs_wide_opposite(value) : value;
    while (n > 0 && !gs_wide_bit(size, n - 1))
        n--;
    const double sign = negative ? -1.0 : 1.0;
    const double hi = ldexp((double)gs_wide_digits(size, n), -GS_DIGITS);
    const double lo = ldexp((double)gs_wide_digits(size, n - GS_DIGITS), -2 * GS_DIGITS);
    return gs_make(gs_fast_two_sum(sign * hi, sign * lo), n - GS_BITS);
}
