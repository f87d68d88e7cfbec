/* GS_LANES doubles at a time: 8 (AVX-512), 4 (AVX2 and FMA) or 1 (any C99 compiler); the same operations, so the same bits.
 * Comparisons are quiet: they raise no flag for NaN.
 */
#ifndef GALILEO_VECTOR_H
#define GALILEO_VECTOR_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if GS_LANES > 1
#include <immintrin.h>
#endif

#if defined(__clang__) /* or it evaluates what was selected away, and raises its flags */
#pragma STDC FENV_ACCESS ON
#endif

#if defined(__GNUC__)
#define GS_TABLE(name) static const double name[16] __attribute__((aligned(64)))
#define GS_RARE __attribute__((noinline))
#else
#define GS_TABLE(name) static const double name[16]
#define GS_RARE
#endif

#if GS_LANES == 8

typedef __m512d gs_v;
typedef __mmask8 gs_mask;
typedef __m512i gs_index;

static inline gs_v gs_v_of(double x) { return _mm512_set1_pd(x); }
static inline gs_v gs_v_load(const double *p) { return _mm512_loadu_pd(p); }
static inline void gs_v_store(double *p, gs_v x) { _mm512_storeu_pd(p, x); }
static inline gs_v gs_v_widen(const float *p) { return _mm512_cvtps_pd(_mm256_loadu_ps(p)); }
static inline void gs_v_narrow(float *p, gs_v x) { _mm256_storeu_ps(p, _mm512_cvtpd_ps(x)); }
static inline gs_v gs_add(gs_v a, gs_v b) { return _mm512_add_pd(a, b); }
static inline gs_v gs_sub(gs_v a, gs_v b) { return _mm512_sub_pd(a, b); }
static inline gs_v gs_mul(gs_v a, gs_v b) { return _mm512_mul_pd(a, b); }
static inline gs_v gs_div(gs_v a, gs_v b) { return _mm512_div_pd(a, b); }
static inline gs_v gs_fma(gs_v a, gs_v b, gs_v c) { return _mm512_fmadd_pd(a, b, c); }
static inline gs_v gs_fms(gs_v a, gs_v b, gs_v c) { return _mm512_fmsub_pd(a, b, c); }
static inline gs_v gs_sqrt(gs_v a) { return _mm512_sqrt_pd(a); }
static inline gs_v gs_fnma(gs_v a, gs_v b, gs_v c) { return _mm512_fnmadd_pd(a, b, c); }
static inline gs_v gs_min(gs_v a, gs_v b) { return _mm512_min_pd(a, b); }
static inline gs_v gs_abs(gs_v a) { return _mm512_abs_pd(a); }
static inline gs_v gs_flip(gs_v a, gs_v x) { return _mm512_xor_pd(a, _mm512_and_pd(x, _mm512_set1_pd(-0.0))); }
static inline gs_mask gs_at_least(gs_v a, gs_v b) { return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ); }
static inline gs_mask gs_less(gs_v a, gs_v b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
static inline gs_mask gs_both(gs_mask a, gs_mask b) { return a & b; }
static inline int gs_all(gs_mask m) { return m == 0xff; }
static inline gs_mask gs_either(gs_mask a, gs_mask b) { return a | b; }
static inline gs_mask gs_not(gs_mask a) { return (gs_mask)~a; }
static inline unsigned gs_bits_of(gs_mask m) { return m; }
static inline gs_v gs_select(gs_mask m, gs_v a, gs_v b) { return _mm512_mask_blend_pd(m, b, a); }
static inline gs_index gs_piece(gs_v shifted, int64_t first, int drop)
{
    return _mm512_sub_epi64(_mm512_srl_epi64(_mm512_castpd_si512(shifted), _mm_cvtsi32_si128(drop)), _mm512_set1_epi64(first));
}
static inline gs_index gs_low_index(gs_v u) { return _mm512_castpd_si512(u); } /* a permutation takes its last four bits */
static inline gs_v gs_power(gs_v u)
{
    const __m512i n = _mm512_slli_epi64(_mm512_srli_epi64(_mm512_castpd_si512(u), 4), 52);
    return _mm512_castsi512_pd(_mm512_sub_epi64(_mm512_set1_epi64(0x3ff0000000000000), n));
}
static inline gs_v gs_exponent(gs_v x)
{
    const __m512i k = _mm512_or_si512(_mm512_srli_epi64(_mm512_castpd_si512(x), 52), _mm512_set1_epi64(0x4330000000000000));
    return gs_sub(_mm512_castsi512_pd(k), gs_v_of(0x1.00000000004p+52));
}
static inline gs_v gs_mantissa(gs_v x)
{
    const __m512i fraction = _mm512_and_si512(_mm512_castpd_si512(x), _mm512_set1_epi64(0xfffffffffffff));
    return _mm512_castsi512_pd(_mm512_or_si512(fraction, _mm512_set1_epi64(0x4000000000000000)));
}
static inline gs_v gs_pick(const double table[16], gs_index i) /* table[i], 0 <= i < 16 */
{
    return _mm512_permutex2var_pd(_mm512_loadu_pd(table), i, _mm512_loadu_pd(table + 8));
}
/* hi + lo cut off at an odd last bit, which a later rounding to binary32 cannot mistake for a tie */
static inline gs_v gs_to_odd(gs_v hi, gs_v lo)
{
    const __m512i one = _mm512_set1_epi64(1), bits = _mm512_castpd_si512(hi);
    const __m512i opposite = _mm512_srai_epi64(_mm512_xor_si512(bits, _mm512_castpd_si512(lo)), 63);
    const __mmask8 move = _mm512_cmp_pd_mask(lo, _mm512_setzero_pd(), _CMP_NEQ_OQ) & _mm512_testn_epi64_mask(bits, one);
    return _mm512_castsi512_pd(_mm512_mask_add_epi64(bits, move, bits, _mm512_or_si512(opposite, one)));
}
/* 1/x to 24 bits, x between 2^-126 and 2^126: by floats, which are divided in a third of the time */
static inline gs_v gs_rough_inverse(gs_v x)
{
    return _mm512_cvtps_pd(_mm256_div_ps(_mm256_set1_ps(1.0f), _mm512_cvtpd_ps(x)));
}
/* the bits that a rounding to binary32 takes away are more than 2^18 from a tie */
static inline gs_mask gs_off_ties(gs_v r)
{
    const __m512i left = _mm512_add_epi64(_mm512_castpd_si512(r), _mm512_set1_epi64(0x10040000));
    return _mm512_cmpge_epu64_mask(_mm512_and_si512(left, _mm512_set1_epi64(0x1fffffff)), _mm512_set1_epi64(0x80000));
}

#elif GS_LANES == 4

typedef __m256d gs_v;
typedef __m256d gs_mask;
typedef struct { __m256i pair; __m256d upper, high; } gs_index;

static inline gs_v gs_v_of(double x) { return _mm256_set1_pd(x); }
static inline gs_v gs_v_load(const double *p) { return _mm256_loadu_pd(p); }
static inline void gs_v_store(double *p, gs_v x) { _mm256_storeu_pd(p, x); }
static inline gs_v gs_v_widen(const float *p) { return _mm256_cvtps_pd(_mm_loadu_ps(p)); }
static inline void gs_v_narrow(float *p, gs_v x) { _mm_storeu_ps(p, _mm256_cvtpd_ps(x)); }
static inline gs_v gs_add(gs_v a, gs_v b) { return _mm256_add_pd(a, b); }
static inline gs_v gs_sub(gs_v a, gs_v b) { return _mm256_sub_pd(a, b); }
static inline gs_v gs_mul(gs_v a, gs_v b) { return _mm256_mul_pd(a, b); }
static inline gs_v gs_div(gs_v a, gs_v b) { return _mm256_div_pd(a, b); }
static inline gs_v gs_fma(gs_v a, gs_v b, gs_v c) { return _mm256_fmadd_pd(a, b, c); }
static inline gs_v gs_fms(gs_v a, gs_v b, gs_v c) { return _mm256_fmsub_pd(a, b, c); }
static inline gs_v gs_sqrt(gs_v a) { return _mm256_sqrt_pd(a); }
static inline gs_v gs_fnma(gs_v a, gs_v b, gs_v c) { return _mm256_fnmadd_pd(a, b, c); }
static inline gs_v gs_min(gs_v a, gs_v b) { return _mm256_min_pd(a, b); }
static inline gs_v gs_abs(gs_v a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
static inline gs_v gs_flip(gs_v a, gs_v x) { return _mm256_xor_pd(a, _mm256_and_pd(x, _mm256_set1_pd(-0.0))); }
static inline gs_mask gs_at_least(gs_v a, gs_v b) { return _mm256_cmp_pd(a, b, _CMP_GE_OQ); }
static inline gs_mask gs_less(gs_v a, gs_v b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
static inline gs_mask gs_both(gs_mask a, gs_mask b) { return _mm256_and_pd(a, b); }
static inline int gs_all(gs_mask m) { return _mm256_movemask_pd(m) == 0xf; }
static inline gs_mask gs_either(gs_mask a, gs_mask b) { return _mm256_or_pd(a, b); }
static inline gs_mask gs_not(gs_mask a) { return _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))); }
static inline unsigned gs_bits_of(gs_mask m) { return (unsigned)_mm256_movemask_pd(m); }
static inline gs_v gs_select(gs_mask m, gs_v a, gs_v b) { return _mm256_blendv_pd(b, a, m); }
/* each index 0..15 as the permutation of floats that picks it out of four doubles, and its bits 2 and 3 as masks */
static inline gs_index gs_index_of(__m256i i)
{
    const __m256i twice = _mm256_add_epi64(i, i);
    gs_index r;
    r.pair = _mm256_or_si256(_mm256_or_si256(twice, _mm256_slli_epi64(twice, 32)), _mm256_set1_epi64x(0x100000000));
    r.upper = _mm256_castsi256_pd(_mm256_slli_epi64(i, 61));
    r.high = _mm256_castsi256_pd(_mm256_slli_epi64(i, 60));
    return r;
}
static inline gs_index gs_piece(gs_v shifted, int64_t first, int drop)
{
    return gs_index_of(_mm256_sub_epi64(_mm256_srl_epi64(_mm256_castpd_si256(shifted), _mm_cvtsi32_si128(drop)), _mm256_set1_epi64x(first)));
}
static inline gs_index gs_low_index(gs_v u) { return gs_index_of(_mm256_and_si256(_mm256_castpd_si256(u), _mm256_set1_epi64x(15))); }
static inline gs_v gs_power(gs_v u)
{
    const __m256i n = _mm256_slli_epi64(_mm256_srli_epi64(_mm256_castpd_si256(u), 4), 52);
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(0x3ff0000000000000), n));
}
static inline gs_v gs_exponent(gs_v x)
{
    const __m256i k = _mm256_or_si256(_mm256_srli_epi64(_mm256_castpd_si256(x), 52), _mm256_set1_epi64x(0x4330000000000000));
    return gs_sub(_mm256_castsi256_pd(k), gs_v_of(0x1.00000000004p+52));
}
static inline gs_v gs_mantissa(gs_v x)
{
    const __m256i fraction = _mm256_and_si256(_mm256_castpd_si256(x), _mm256_set1_epi64x(0xfffffffffffff));
    return _mm256_castsi256_pd(_mm256_or_si256(fraction, _mm256_set1_epi64x(0x4000000000000000)));
}
static inline gs_v gs_pick(const double table[16], gs_index i)
{
    const float *f = (const float *)(const void *)table;
#define GS_OF(k) _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_loadu_ps(f + 8 * (k)), i.pair))
    return _mm256_blendv_pd(_mm256_blendv_pd(GS_OF(0), GS_OF(1), i.upper), _mm256_blendv_pd(GS_OF(2), GS_OF(3), i.upper), i.high);
#undef GS_OF
}
static inline gs_v gs_to_odd(gs_v hi, gs_v lo)
{
    const __m256i zero = _mm256_setzero_si256(), one = _mm256_set1_epi64x(1), bits = _mm256_castpd_si256(hi);
    const __m256i opposite = _mm256_cmpgt_epi64(zero, _mm256_xor_si256(bits, _mm256_castpd_si256(lo)));
    const __m256i even = _mm256_cmpeq_epi64(_mm256_and_si256(bits, one), zero);
    const __m256i inexact = _mm256_castpd_si256(_mm256_cmp_pd(lo, _mm256_setzero_pd(), _CMP_NEQ_OQ));
    const __m256i step = _mm256_and_si256(_mm256_and_si256(inexact, even), _mm256_or_si256(opposite, one));
    return _mm256_castsi256_pd(_mm256_add_epi64(bits, step));
}
static inline gs_v gs_rough_inverse(gs_v x) { return _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0f), _mm256_cvtpd_ps(x))); }
static inline gs_mask gs_off_ties(gs_v r)
{
    const __m256i left = _mm256_add_epi64(_mm256_castpd_si256(r), _mm256_set1_epi64x(0x10040000));
    const __m256i place = _mm256_and_si256(left, _mm256_set1_epi64x(0x1fffffff));
    return _mm256_castsi256_pd(_mm256_cmpgt_epi64(place, _mm256_set1_epi64x(0x7ffff)));
}

#else

typedef double gs_v;
typedef int gs_mask;
typedef int64_t gs_index;

static inline gs_v gs_v_of(double x) { return x; }
static inline gs_v gs_v_load(const double *p) { return *p; }
static inline void gs_v_store(double *p, gs_v x) { *p = x; }
static inline gs_v gs_v_widen(const float *p) { return *p; }
static inline void gs_v_narrow(float *p, gs_v x) { *p = (float)x; }
static inline gs_v gs_add(gs_v a, gs_v b) { return a + b; }
static inline gs_v gs_sub(gs_v a, gs_v b) { return a - b; }
static inline gs_v gs_mul(gs_v a, gs_v b) { return a * b; }
static inline gs_v gs_div(gs_v a, gs_v b) { return a / b; }
static inline gs_v gs_fma(gs_v a, gs_v b, gs_v c) { return fma(a, b, c); }
static inline gs_v gs_fms(gs_v a, gs_v b, gs_v c) { return fma(a, b, -c); }
static inline gs_v gs_sqrt(gs_v a) { return sqrt(a); }
static inline gs_v gs_fnma(gs_v a, gs_v b, gs_v c) { return fma(-a, b, c); }
static inline gs_v gs_min(gs_v a, gs_v b) { return isless(a, b) ? a : b; }
static inline gs_v gs_abs(gs_v a) { return fabs(a); }
static inline gs_v gs_flip(gs_v a, gs_v x) { return signbit(x) ? -a : a; }
static inline gs_mask gs_at_least(gs_v a, gs_v b) { return isgreaterequal(a, b); }
static inline gs_mask gs_less(gs_v a, gs_v b) { return isless(a, b); }
static inline gs_mask gs_both(gs_mask a, gs_mask b) { return a && b; }
static inline int gs_all(gs_mask m) { return m; }
static inline gs_mask gs_either(gs_mask a, gs_mask b) { return a || b; }
static inline gs_mask gs_not(gs_mask a) { return !a; }
static inline unsigned gs_bits_of(gs_mask m) { return (unsigned)m; }
static inline gs_v gs_select(gs_mask m, gs_v a, gs_v b) { return m ? a : b; }
static inline uint64_t gs_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
static inline double gs_of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}
static inline gs_index gs_piece(gs_v shifted, int64_t first, int drop) { return (int64_t)(gs_bits(shifted) >> drop) - first; }
static inline gs_index gs_low_index(gs_v u) { return (int64_t)(gs_bits(u) & 15); }
static inline gs_v gs_power(gs_v u) { return gs_of_bits(0x3ff0000000000000 - (gs_bits(u) >> 4 << 52)); }
static inline gs_v gs_exponent(gs_v x) { return gs_of_bits(gs_bits(x) >> 52 | 0x4330000000000000) - 0x1.00000000004p+52; }
static inline gs_v gs_mantissa(gs_v x) { return gs_of_bits((gs_bits(x) & 0xfffffffffffff) | 0x4000000000000000); }
static inline gs_v gs_pick(const double table[16], gs_index i) { return table[i]; }
static inline gs_v gs_to_odd(gs_v hi, gs_v lo)
{
    const uint64_t bits = gs_bits(hi);
    if (lo == 0.0 || bits % 2 == 1)
        return hi;
    return gs_of_bits((lo < 0.0) == (hi < 0.0) ? bits + 1 : bits - 1);
}
static inline gs_v gs_rough_inverse(gs_v x) { return 1.0f / (float)x; }
static inline gs_mask gs_off_ties(gs_v r) { return ((gs_bits(r) + 0x10040000) & 0x1fffffff) >= 0x80000; }

#endif

/* The exact rest of s = a + b, rounded, where |a| >= |b| or a = 0. */
static inline gs_v gs_rest(gs_v a, gs_v b, gs_v s) { return gs_add(gs_sub(a, s), b); }

/* The exact rest of s = a + b, rounded. */
static inline gs_v gs_sum_rest(gs_v a, gs_v b, gs_v s)
{
    const gs_v b_part = gs_sub(s, a);
    return gs_add(gs_sub(a, gs_sub(s, b_part)), gs_sub(b, b_part));
}

/* The exact rest of p = a b, rounded. */
static inline gs_v gs_product_rest(gs_v a, gs_v b, gs_v p) { return gs_fms(a, b, p); }

/* lo <= x < hi, false for NaN */
static inline gs_mask gs_within(gs_v x, gs_v lo, gs_v hi) { return gs_both(gs_at_least(x, lo), gs_less(x, hi)); }

/* r where lower <= x <= upper; NaN with FE_INVALID elsewhere, without it where x is NaN. */
static inline gs_v gs_refuse_beyond(gs_v x, gs_v lower, gs_v upper, gs_v r, gs_v *lo)
{
    const gs_v zero = gs_v_of(0.0);
    const gs_mask good = gs_both(gs_at_least(x, lower), gs_at_least(upper, x));
    const gs_v z = gs_select(good, zero, gs_select(gs_within(x, gs_v_of(-INFINITY), gs_v_of(INFINITY)), gs_v_of(INFINITY), x));
    *lo = gs_select(good, *lo, zero);
    return gs_select(good, r, gs_sub(z, z));
}

/* The same for the domain x >= 0. */
static inline gs_v gs_refuse_negative(gs_v x, gs_v r, gs_v *lo)
{
    return gs_refuse_beyond(x, gs_v_of(0.0), gs_v_of(INFINITY), r, lo);
}

#endif
