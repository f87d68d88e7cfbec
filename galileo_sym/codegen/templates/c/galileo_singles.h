/* The primitives in binary32, correctly rounded: by plain double arithmetic where that settles the rounding, else by pairs. */
#ifndef GALILEO_SINGLES_H
#define GALILEO_SINGLES_H

#include "galileo_loops.h"
#include "galileo_single.h"

/* Whether no number within 2^-34 of r lies on the other side of a tie between floats, nor among the subnormal ones. */
static inline gs_mask gs_rounds_one_way(gs_v r)
{
    const gs_mask normal = gs_at_least(gs_abs(r), gs_v_of(0x1p-126));
#if GS_LANES == 8
    const __m512i left = _mm512_add_epi64(_mm512_castpd_si512(r), _mm512_set1_epi64(0x10040000));
    return normal & _mm512_cmpge_epu64_mask(_mm512_and_si512(left, _mm512_set1_epi64(0x1fffffff)), _mm512_set1_epi64(0x80000));
#elif GS_LANES == 4
    const __m256i left = _mm256_add_epi64(_mm256_castpd_si256(r), _mm256_set1_epi64x(0x10040000));
    const __m256i place = _mm256_and_si256(left, _mm256_set1_epi64x(0x1fffffff));
    return _mm256_and_pd(normal, _mm256_castsi256_pd(_mm256_cmpgt_epi64(place, _mm256_set1_epi64x(0x7ffff))));
#else
    return normal && ((gs_bits(r) + 0x10040000) & 0x1fffffff) >= 0x80000;
#endif
}

/* Two vectors a turn, so that each column of a table serves both. */
#define GS_SINGLES(name)                                                                                               \
    static GS_RARE gs_v gs_##name##_settled(gs_v wide)                                                                 \
    {                                                                                                                  \
        gs_v lo;                                                                                                       \
        const gs_v hi = gs_##name##_value(wide, &lo);                                                                  \
        return gs_to_odd(hi, lo);                                                                                      \
    }                                                                                                                  \
    void GS_JOIN(gs_##name##_ns, GS_SUFFIX)(size_t n, const float *x, float *value)                                    \
    {                                                                                                                  \
        float pad[2 * GS_LANES];                                                                                       \
        gs_v r, s;                                                                                                     \
        for (;;) {                                                                                                     \
            const size_t here = n < 2 * GS_LANES ? n : 2 * GS_LANES;                                                   \
            if (here == 0)                                                                                             \
                return;                                                                                                \
            if (here < 2 * GS_LANES) {                                                                                 \
                for (size_t j = 0; j < 2 * GS_LANES; j++)                                                              \
                    pad[j] = x[j < here ? j : here - 1];                                                               \
                x = pad;                                                                                               \
            }                                                                                                          \
            const gs_v a = gs_v_widen(x), b = gs_v_widen(x + GS_LANES);                                                \
            const gs_mask good = gs_##name##_quick(a, &r), fine = gs_##name##_quick(b, &s);                            \
            if (!gs_all(gs_both(good, fine))) {                                                                        \
                r = gs_all(good) ? r : gs_##name##_settled(a);                                                         \
                s = gs_all(fine) ? s : gs_##name##_settled(b);                                                         \
            }                                                                                                          \
            if (here < 2 * GS_LANES) {                                                                                 \
                gs_v_narrow(pad, r);                                                                                   \
                gs_v_narrow(pad + GS_LANES, s);                                                                        \
                memcpy(value, pad, here * sizeof *value);                                                              \
                return;                                                                                                \
            }                                                                                                          \
            gs_v_narrow(value, r);                                                                                     \
            gs_v_narrow(value + GS_LANES, s);                                                                          \
            n -= 2 * GS_LANES, x += 2 * GS_LANES, value += 2 * GS_LANES;                                               \
        }                                                                                                              \
    }

@SINGLES@
#endif
