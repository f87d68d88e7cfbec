/* Array loops that serve each range of an argument apart, where an array holds several; for a source that has set
 * GS_LANES and GS_SUFFIX. A vector that holds numbers of two ranges would cost as much as both.
 */
#ifndef GALILEO_BLOCKS_H
#define GALILEO_BLOCKS_H

#include "galileo_loops.h"

#define GS_BLOCK 256

/* gs_count: how many lanes of a mask there are; gs_squeeze: those lanes side by side; gs_spread: back into their places. */
#if GS_LANES == 8
static inline size_t gs_count(gs_mask m) { return (size_t)__builtin_popcount(m); }
static inline gs_v gs_squeeze(gs_mask m, gs_v x) { return _mm512_maskz_compress_pd(m, x); }
static inline gs_v gs_spread(gs_mask m, gs_v x, gs_v r) { return _mm512_mask_expand_pd(r, m, x); }
#elif GS_LANES == 4
static inline size_t gs_count(gs_mask m) { return (size_t)__builtin_popcount(gs_bits_of(m)); }
/* permutations of floats, by the bits of a mask: its lanes to the front, and back */
static const int32_t gs_to_front[16][8] __attribute__((aligned(32))) = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
    {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7}, {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
    {6, 7, 0, 1, 2, 3, 4, 5}, {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
    {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1}, {0, 1, 2, 3, 4, 5, 6, 7}};
static const int32_t gs_from_front[16][8] __attribute__((aligned(32))) = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 0, 1, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
    {0, 1, 2, 3, 0, 1, 6, 7}, {0, 1, 2, 3, 2, 3, 6, 7}, {0, 1, 0, 1, 2, 3, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
    {0, 1, 2, 3, 4, 5, 0, 1}, {0, 1, 2, 3, 4, 5, 2, 3}, {0, 1, 0, 1, 4, 5, 2, 3}, {0, 1, 2, 3, 4, 5, 4, 5},
    {0, 1, 2, 3, 0, 1, 2, 3}, {0, 1, 2, 3, 2, 3, 4, 5}, {0, 1, 0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5, 6, 7}};
static inline gs_v gs_permuted(const int32_t order[8], gs_v x)
{
    return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(x), _mm256_load_si256((const __m256i *)(const void *)order)));
}
static inline gs_v gs_squeeze(gs_mask m, gs_v x) { return gs_permuted(gs_to_front[gs_bits_of(m)], x); }
static inline gs_v gs_spread(gs_mask m, gs_v x, gs_v r) { return gs_select(m, gs_permuted(gs_from_front[gs_bits_of(m)], x), r); }
#else
static inline size_t gs_count(gs_mask m) { return (size_t)m; }
static inline gs_v gs_squeeze(gs_mask m, gs_v x) { (void)m; return x; }
static inline gs_v gs_spread(gs_mask m, gs_v x, gs_v r) { return m ? x : r; }
#endif

/* Append the lanes of a mask to a part; there is room for a whole vector. Return the part's length. */
static inline size_t gs_append(double *part, size_t length, gs_mask lanes, gs_v x)
{
    gs_v_store(part + length, gs_squeeze(lanes, x));
    return length + gs_count(lanes);
}

/* Put the numbers of a part that come next into the lanes of a mask. */
static inline gs_v gs_take(const double *part, size_t *taken, gs_mask lanes, gs_v r)
{
    const gs_v next = gs_v_load(part + *taken);
    *taken += gs_count(lanes);
    return gs_spread(lanes, next, r);
}

/* Replace the numbers of a part by their values; the last vector is filled up with what does no harm. */
#define GS_SERVE(kind, harmless, part, length)                                                                         \
    do {                                                                                                               \
        gs_v_store((part) + (length), harmless);                                                                       \
        for (size_t i = 0; i < (length); i += GS_LANES)                                                                \
            gs_v_store((part) + i, kind(gs_v_load((part) + i)));                                                       \
    } while (0)

/* Two vectors a turn while all their lanes are typical, else a block. */
#define GS_BLOCKS(name)                                                                                                \
    void GS_JOIN(gs_##name##_blocks, GS_SUFFIX)(size_t n, const double *x, double *value)                              \
    {                                                                                                                  \
        while (n >= 2 * GS_LANES) {                                                                                    \
            const gs_v a = gs_v_load(x), b = gs_v_load(x + GS_LANES);                                                  \
            size_t here = 2 * GS_LANES;                                                                                \
            if (gs_all(gs_both(gs_##name##_is_kind0(a), gs_##name##_is_kind0(b)))) {                                   \
                const gs_v r = gs_##name##_kind0(a), s = gs_##name##_kind0(b);                                         \
                gs_v_store(value, r);                                                                                  \
                gs_v_store(value + GS_LANES, s);                                                                       \
            } else {                                                                                                   \
                here = n < GS_BLOCK ? n - n % GS_LANES : GS_BLOCK;                                                     \
                gs_##name##_mixed(here, x, value);                                                                     \
            }                                                                                                          \
            n -= here, x += here, value += here;                                                                       \
        }                                                                                                              \
        GS_JOIN(gs_##name##_n, GS_SUFFIX)(n, x, value);                                                                \
    }

@KINDS@
#endif
