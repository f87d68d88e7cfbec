/* Array loops over the kernels, for a source that has set GS_LANES and GS_SUFFIX. */
#ifndef GALILEO_LOOPS_H
#define GALILEO_LOOPS_H

#include "galileo_frames.h"

#define GS_JOIN2(a, b) a##b
#define GS_JOIN(a, b) GS_JOIN2(a, b)

/* Two vectors a turn, so that each column of a table serves both; what is left at the end goes through a full block. */
#define GS_LOOPS(name)                                                                                                 \
    void GS_JOIN(gs_##name##_n, GS_SUFFIX)(size_t n, const double *x, double *value)                                   \
    {                                                                                                                  \
        gs_v lo;                                                                                                       \
        for (; n >= 2 * GS_LANES; n -= 2 * GS_LANES, x += 2 * GS_LANES, value += 2 * GS_LANES) {                       \
            const gs_v a = gs_##name##_value(gs_v_load(x), &lo);                                                       \
            const gs_v b = gs_##name##_value(gs_v_load(x + GS_LANES), &lo);                                            \
            gs_v_store(value, a);                                                                                      \
            gs_v_store(value + GS_LANES, b);                                                                           \
        }                                                                                                              \
        while (n > 0) {                                                                                                \
            const size_t left = n < GS_LANES ? n : GS_LANES;                                                           \
            double block[GS_LANES] = {0};                                                                              \
            memcpy(block, x, left * sizeof *x);                                                                        \
            gs_v_store(block, gs_##name##_value(gs_v_load(block), &lo));                                               \
            memcpy(value, block, left * sizeof *x);                                                                    \
            n -= left, x += left, value += left;                                                                       \
        }                                                                                                              \
    }                                                                                                                  \
    void GS_JOIN(gs_##name##_nf, GS_SUFFIX)(size_t n, const float *x, float *value)                                    \
    {                                                                                                                  \
        gs_v hi, lo;                                                                                                   \
        for (; n >= GS_LANES; n -= GS_LANES, x += GS_LANES, value += GS_LANES) {                                       \
            hi = gs_##name##_value(gs_v_widen(x), &lo);                                                                \
            gs_v_narrow(value, gs_to_odd(hi, lo));                                                                     \
        }                                                                                                              \
        if (n > 0) {                                                                                                   \
            float block[GS_LANES] = {0};                                                                               \
            memcpy(block, x, n * sizeof *x);                                                                           \
            hi = gs_##name##_value(gs_v_widen(block), &lo);                                                            \
            gs_v_narrow(block, gs_to_odd(hi, lo));                                                                     \
            memcpy(value, block, n * sizeof *x);                                                                       \
        }                                                                                                              \
    }

#endif
