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

/* Two vectors a turn while all their lanes are typical, else a block; fewer than two are filled up with the last one. */
#define GS_SINGLES(name)                                                                                               \
    void GS_JOIN(gs_##name##_ns, GS_SUFFIX)(size_t n, const float *x, float *value)                                    \
    {                                                                                                                  \
        while (n >= 2 * GS_LANES) {                                                                                    \
            const gs_v a = gs_v_widen(x), b = gs_v_widen(x + GS_LANES);                                                \
            size_t here = 2 * GS_LANES;                                                                                \
            if (gs_all(gs_both(gs_##name##_is_kind0(a), gs_##name##_is_kind0(b)))) {                                   \
                gs_v r = gs_##name##_quick0(a), s = gs_##name##_quick0(b);                                             \
                const gs_mask good = gs_rounds_one_way(r), fine = gs_rounds_one_way(s);                                \
                if (!gs_all(gs_both(good, fine))) {                                                                    \
                    r = gs_all(good) ? r : gs_##name##_settled(a);                                                     \
                    s = gs_all(fine) ? s : gs_##name##_settled(b);                                                     \
                }                                                                                                      \
                gs_v_narrow(value, r);                                                                                 \
                gs_v_narrow(value + GS_LANES, s);                                                                      \
            } else {                                                                                                   \
                here = n < GS_BLOCK ? n - n % GS_LANES : GS_BLOCK;                                                     \
                gs_##name##_mixed_single(here, x, value);                                                              \
            }                                                                                                          \
            n -= here, x += here, value += here;                                                                       \
        }                                                                                                              \
        if (n > 0) {                                                                                                   \
            float pad[2 * GS_LANES];                                                                                   \
            for (size_t j = 0; j < 2 * GS_LANES; j++)                                                                  \
                pad[j] = x[j < n ? j : n - 1];                                                                         \
            for (size_t j = 0; j < n; j += GS_LANES)                                                                   \
                gs_v_narrow(pad + j, gs_##name##_any_single(gs_v_widen(pad + j)));                                     \
            memcpy(value, pad, n * sizeof *value);                                                                     \
        }                                                                                                              \
    }

@SINGLES@
#endif
