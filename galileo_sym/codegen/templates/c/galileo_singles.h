/* The primitives in binary32, correctly rounded: by plain double arithmetic where that settles the rounding, else by pairs. */
#ifndef GALILEO_SINGLES_H
#define GALILEO_SINGLES_H

#include "galileo_blocks.h"
#include "galileo_single.h"

/* Whether no number within 2^-34 of r lies on the other side of a tie between floats, nor among the subnormal ones. */
static inline gs_mask gs_rounds_one_way(gs_v r)
{
    return gs_both(gs_at_least(gs_abs(r), gs_v_of(0x1p-126)), gs_off_ties(r));
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
