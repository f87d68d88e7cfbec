/* The loops of the steps of scenes, for a source that has set GS_SUFFIX: operations on scaled pairs, element by element. */
#include "galileo_support.h"

#include <stddef.h>

#define GS_JOIN2(a, b) a##b
#define GS_JOIN(a, b) GS_JOIN2(a, b)
#define GS_LOOP(name)                                                                                                  \
    void GS_JOIN(gs_step_##name, GS_SUFFIX)(char **args, const ptrdiff_t *counts, const ptrdiff_t *steps, void *data)

enum { GS_MOST = 500 }; /* exponents of factors whose product is sure to be a normal number */

static inline double gs_double(char *const *at) { return *(const double *)*at; }

static inline gs_scaled gs_get(char *const *at)
{
    const gs_scaled r = {gs_double(at), gs_double(at + 1), *(const int *)at[2]};
    return r;
}

static inline void gs_put(char *const *at, gs_scaled value)
{
    *(double *)at[0] = value.hi;
    *(double *)at[1] = value.lo;
    *(int *)at[2] = value.e;
}

#define GS_EACH(operands)                                                                                              \
    char *at[operands];                                                                                                \
    (void)data;                                                                                                        \
    memcpy(at, args, sizeof at);                                                                                       \
    for (ptrdiff_t i = 0; i < counts[0]; i++, gs_advance(at, steps, operands))

static inline void gs_advance(char **at, const ptrdiff_t *steps, int operands)
{
    for (int k = 0; k < operands; k++)
        at[k] += steps[k];
}

GS_LOOP(load)
{
    GS_EACH(4) gs_put(at + 1, gs_load(gs_double(at)));
}

#define GS_UNARY(name)                                                                                                 \
    GS_LOOP(name)                                                                                                      \
    {                                                                                                                  \
        GS_EACH(6) gs_put(at + 3, gs_##name(gs_get(at)));                                                              \
    }
#define GS_BINARY(name)                                                                                                \
    GS_LOOP(name)                                                                                                      \
    {                                                                                                                  \
        GS_EACH(9) gs_put(at + 6, gs_##name(gs_get(at), gs_get(at + 3)));                                              \
    }

GS_BINARY(mul)
GS_BINARY(div)
GS_BINARY(add)
GS_BINARY(sub)
GS_UNARY(sqrt)
GS_UNARY(phi0m)
GS_UNARY(phi1m)
GS_UNARY(phi2m)
GS_UNARY(descent_factor)
GS_UNARY(flight_factor)
GS_UNARY(range_factor)

GS_LOOP(angle)
{
    GS_EACH(12)
    {
        const gs_direction a = gs_angle(gs_double(at));
        *(double *)at[1] = a.x;
        *(double *)at[2] = a.x2;
        *(double *)at[3] = a.x3;
        *(unsigned char *)at[4] = a.complement != 0;
        *(double *)at[5] = a.sign;
        gs_put(at + 6, a.s);
        gs_put(at + 9, a.c);
    }
}

GS_LOOP(driving)
{
    GS_EACH(17)
    {
        const gs_direction a = {gs_double(at), gs_double(at + 1), gs_double(at + 2), gs_double(at + 4),
                                *(const unsigned char *)at[3], gs_get(at + 5), gs_get(at + 8)};
        gs_put(at + 14, gs_driving(a, gs_get(at + 11)));
    }
}

/* A product of factors as large or small as a pair might leave the range: those become 0. */
static inline int gs_is_odd(gs_scaled a)
{
    return a.hi != 0.0 && (a.e < -GS_MOST || a.e > GS_MOST);
}

/* x 2^e for a part x of a pair. */
static inline double gs_scaled_part(gs_scaled a, double x)
{
    const uint64_t bits = (uint64_t)(1023 + (gs_is_odd(a) || a.hi == 0.0 ? 0 : a.e)) << 52; /* faster than ldexp */
    double unit;
    memcpy(&unit, &bits, sizeof unit);
    return gs_is_odd(a) ? 0.0 : unit * x;
}

static inline void gs_put_parts(char *const *at, gs_scaled a, gs_pair parts)
{
    *(double *)at[0] = gs_scaled_part(a, parts.hi);
    *(double *)at[1] = gs_scaled_part(a, parts.lo);
    *(unsigned char *)at[2] = (unsigned char)gs_is_odd(a);
}

GS_LOOP(round)
{
    GS_EACH(5)
    {
        const gs_scaled a = gs_get(at);
        *(double *)at[3] = gs_scaled_part(a, a.hi);
        *(unsigned char *)at[4] = (unsigned char)gs_is_odd(a);
    }
}

GS_LOOP(parts)
{
    GS_EACH(6) gs_put_parts(at + 3, gs_get(at), gs_mantissa(gs_get(at)));
}

/* The first of 26 bits. */
GS_LOOP(halves)
{
    GS_EACH(6)
    {
        const gs_scaled a = gs_get(at);
        const double scaled = 134217729.0 * a.hi, high = scaled - (scaled - a.hi);
        const gs_pair halves = {high, (a.hi - high) + a.lo};
        gs_put_parts(at + 3, a, halves);
    }
}
