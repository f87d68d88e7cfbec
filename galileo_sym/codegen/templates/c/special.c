/* The primitives in plain C99, and the choice of the version for this machine at each call. */
#include <fenv.h>
#include <float.h>

#include "galileo.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "galileo_singles.h"

#if @CONDITION@
static int gs_has_wide_vectors(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")
        && __builtin_cpu_supports("avx512vl");
}
static int gs_has_vectors(void) { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#define GS_DECLARED(name, suffix)                                                                                      \
    void name##_n##suffix(size_t n, const double *x, double *value);                                                   \
    void name##_ns##suffix(size_t n, const float *x, float *value);
#define GS_DECLARE(name) GS_DECLARED(name, _avx512) GS_DECLARED(name, _avx2) GS_DECLARED(name, _fma)
#define GS_CHOOSE(name)                                                                                                \
    (gs_has_wide_vectors() ? name##_avx512 : gs_has_vectors() ? name##_avx2 : name##_plain)
#define GS_CHOOSE_SINGLE(name) (gs_has_vectors() ? name##_fma : name##_plain)
#define GS_VECTORS (gs_has_wide_vectors() ? "avx512" : gs_has_vectors() ? "avx2" : "plain")
#else
#define GS_VECTORS "plain"
#define GS_DECLARE(name)
#define GS_CHOOSE(name) name##_plain
#define GS_CHOOSE_SINGLE(name) name##_plain
#endif

/* 'divide by zero' for a pole at 0. Kernels do not raise it: the lanes that a short array leaves empty hold 0. */
#define GS_POLE_AT_0(n, x)                                                                                             \
    do {                                                                                                               \
        int found = 0;                                                                                                 \
        for (size_t i = 0; i < (n); i++)                                                                               \
            found |= (x)[i] == 0;                                                                                      \
        if (found)                                                                                                     \
            feraiseexcept(FE_DIVBYZERO);                                                                               \
    } while (0)
#define GS_NO_POLE(n, x) (void)0

/* Kernels may raise 'underflow' in what they select away: it stays where it is due, a result being tiny. */
static void gs_excuse(int before, size_t n, const double *value, int zero_is_tiny)
{
    if (before || !fetestexcept(FE_UNDERFLOW))
        return;
    for (size_t i = 0; i < n; i++)
        if (isless(fabs(value[i]), DBL_MIN) && (value[i] != 0.0 || zero_is_tiny))
            return;
    feclearexcept(FE_UNDERFLOW);
}
static void gs_excuse_single(int before, size_t n, const float *value, int zero_is_tiny)
{
    if (before || !fetestexcept(FE_UNDERFLOW))
        return;
    for (size_t i = 0; i < n; i++)
        if (isless(fabsf(value[i]), FLT_MIN) && (value[i] != 0.0f || zero_is_tiny))
            return;
    feclearexcept(FE_UNDERFLOW);
}

#define GS_PUBLIC(name, LOOK, zero)                                                                                    \
    GS_DECLARE(gs_##name)                                                                                              \
    GS_LOOPS(name)                                                                                                     \
    void gs_special_##name##_n(size_t n, const double *x, double *value)                                               \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(n, x);                                                                                                    \
        GS_CHOOSE(gs_##name##_n)(n, x, value);                                                                         \
        gs_excuse(before, n, value, zero);                                                                             \
    }                                                                                                                  \
    void gs_special_##name##_nf(size_t n, const float *x, float *value)                                                \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(n, x);                                                                                                    \
        GS_CHOOSE(gs_##name##_ns)(n, x, value);                                                                        \
        gs_excuse_single(before, n, value, zero);                                                                      \
    }                                                                                                                  \
    double gs_special_##name(double x)                                                                                 \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(1, &x);                                                                                                   \
        GS_CHOOSE_SINGLE(gs_##name##_n)(1, &x, &x);                                                                    \
        gs_excuse(before, 1, &x, zero);                                                                                \
        return x;                                                                                                      \
    }                                                                                                                  \
    float gs_special_##name##f(float x)                                                                                \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(1, &x);                                                                                                   \
        GS_CHOOSE_SINGLE(gs_##name##_ns)(1, &x, &x);                                                                   \
        gs_excuse_single(before, 1, &x, zero);                                                                         \
        return x;                                                                                                      \
    }

const char *gs_vectors(void) { return GS_VECTORS; }

@PUBLIC@
