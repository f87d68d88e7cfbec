/* Sums of two products, a b + c d, for a source that has set GS_LANES and GS_SUFFIX. Each operand is in two parts, the first
 * of which have so few bits that their products are exact; all versions do the same operations, so the bits are the same. */
#include "galileo_vector.h"

#define GS_JOIN2(a, b) a##b
#define GS_JOIN(a, b) GS_JOIN2(a, b)
#if defined(__GNUC__) /* sixteen times, with what varies known */
#define GS_INTO_EACH static inline __attribute__((always_inline))
#else
#define GS_INTO_EACH static inline
#endif

/* At x[0] x[1] the parts of a, then those of b, c and d. */
GS_INTO_EACH gs_v gs_sum_of(const gs_v *x)
{
    const gs_v high = gs_add(gs_mul(x[0], x[2]), gs_mul(x[4], x[6]));
    const gs_v first = gs_add(gs_mul(x[0], x[3]), gs_mul(x[1], gs_add(x[2], x[3])));
    const gs_v low = gs_add(gs_add(first, gs_mul(x[4], x[7])), gs_mul(x[5], gs_add(x[6], x[7])));
    return gs_add(high, low);
}

/* From element i on: loaded where a bit of varying says so, else as it is. */
GS_INTO_EACH gs_v gs_sum_at(const double *const *in, const gs_v *fixed, unsigned varying, size_t i)
{
    gs_v x[8];
    for (int k = 0; k < 8; k++)
        x[k] = varying >> k / 2 & 1 ? gs_v_load(in[k] + i) : fixed[k];
    return gs_sum_of(x);
}

GS_INTO_EACH void gs_sum_all(size_t n, const double *const *in, unsigned varying, double *out)
{
    gs_v fixed[8];
    size_t i = 0;
    for (int k = 0; k < 8; k++)
        fixed[k] = gs_v_of(*in[k]);
    for (; n - i >= GS_LANES; i += GS_LANES)
        gs_v_store(out + i, gs_sum_at(in, fixed, varying, i));
    if (i < n) {
        double last[8][GS_LANES] = {{0}}, sums[GS_LANES];
        const double *block[8];
        for (int k = 0; k < 8; k++) {
            if (varying >> k / 2 & 1)
                memcpy(last[k], in[k] + i, (n - i) * sizeof *out);
            block[k] = last[k];
        }
        gs_v_store(sums, gs_sum_at(block, fixed, varying, 0));
        memcpy(out + i, sums, (n - i) * sizeof *out);
    }
}

#define GS_VARYING(bits)                                                                                               \
    case bits:                                                                                                         \
        gs_sum_all(n, in, bits, out);                                                                                  \
        return;

/* The sums of n elements, n >= 1; bit k of varying: the k-th operand has n elements, else one. */
void GS_JOIN(gs_sums, GS_SUFFIX)(size_t n, unsigned varying, const double *const *in, double *out)
{
    switch (varying) {
        GS_VARYING(0) GS_VARYING(1) GS_VARYING(2) GS_VARYING(3) GS_VARYING(4) GS_VARYING(5) GS_VARYING(6) GS_VARYING(7)
        GS_VARYING(8) GS_VARYING(9) GS_VARYING(10) GS_VARYING(11) GS_VARYING(12) GS_VARYING(13) GS_VARYING(14)
        GS_VARYING(15)
    }
}
