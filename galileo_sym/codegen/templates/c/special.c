/* The primitives in plain C99, and the choice of the version for this machine at each call. */
#include <fenv.h>

#include "galileo.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "galileo_loops.h"

#if @CONDITION@
static int gs_has_wide_vectors(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")
        && __builtin_cpu_supports("avx512vl");
}
static int gs_has_vectors(void) { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#define GS_DECLARED(name, suffix)                                                                                      \
    void name##_n##suffix(size_t n, const double *x, double *value);                                                   \
    void name##_nf##suffix(size_t n, const float *x, float *value);
#define GS_DECLARE(name) GS_DECLARED(name, _avx512) GS_DECLARED(name, _avx2) GS_DECLARED(name, _fma)
#define GS_CHOOSE(name)                                                                                                \
    (gs_has_wide_vectors() ? name##_avx512 : gs_has_vectors() ? name##_avx2 : name##_plain)
#define GS_CHOOSE_SINGLE(name) (gs_has_vectors() ? name##_fma : name##_plain)
#else
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

#define GS_PUBLIC(name, LOOK)                                                                                          \
    GS_DECLARE(gs_##name)                                                                                              \
    GS_LOOPS(name)                                                                                                     \
    void gs_special_##name##_n(size_t n, const double *x, double *value)                                               \
    {                                                                                                                  \
        LOOK(n, x);                                                                                                    \
        GS_CHOOSE(gs_##name##_n)(n, x, value);                                                                         \
    }                                                                                                                  \
    void gs_special_##name##_nf(size_t n, const float *x, float *value)                                                \
    {                                                                                                                  \
        LOOK(n, x);                                                                                                    \
        GS_CHOOSE(gs_##name##_nf)(n, x, value);                                                                        \
    }                                                                                                                  \
    double gs_special_##name(double x)                                                                                 \
    {                                                                                                                  \
        LOOK(1, &x);                                                                                                   \
        GS_CHOOSE_SINGLE(gs_##name##_n)(1, &x, &x);                                                                    \
        return x;                                                                                                      \
    }                                                                                                                  \
    float gs_special_##name##f(float x)                                                                                \
    {                                                                                                                  \
        LOOK(1, &x);                                                                                                   \
        GS_CHOOSE_SINGLE(gs_##name##_nf)(1, &x, &x);                                                                   \
        return x;                                                                                                      \
    }

@PUBLIC@
