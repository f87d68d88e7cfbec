/* The primitives in plain C99, and the choice of the version for this machine at each call. */
#include <fenv.h>
#include <float.h>

#include "galileo.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "galileo_singles.h"
#include "galileo_versions.h"

#if @CONDITION@
#define GS_DECLARED(name, suffix)                                                                                      \
    void name##_n##suffix(size_t n, const double *x, double *value);                                                   \
    void name##_blocks##suffix(size_t n, const double *x, double *value);                                              \
    void name##_ns##suffix(size_t n, const float *x, float *value);
#define GS_DECLARE(name) GS_DECLARED(name, _avx512) GS_DECLARED(name, _avx2) GS_DECLARED(name, _fma)
#else
#define GS_DECLARE(name)
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
#define GS_EXCUSING(name, real, least)                                                                                 \
    static void name(int before, size_t n, const real *value, int zero_is_tiny)                                        \
    {                                                                                                                  \
        if (before || !fetestexcept(FE_UNDERFLOW))                                                                     \
            return;                                                                                                    \
        for (size_t i = 0; i < n; i++)                                                                                 \
            if (isless(fabs(value[i]), least) && (value[i] != 0 || zero_is_tiny))                                      \
                return;                                                                                                \
        feclearexcept(FE_UNDERFLOW);                                                                                   \
    }

GS_EXCUSING(gs_excuse_n, double, DBL_MIN)
GS_EXCUSING(gs_excuse_nf, float, FLT_MIN)

#define GS_SERVED(name, real, inner, array, number, LOOK, zero)                                                        \
    void gs_special_##name##array(size_t n, const real *x, real *value)                                                \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(n, x);                                                                                                    \
        GS_CHOOSE(gs_##name##inner)(n, x, value);                                                                      \
        gs_excuse##array(before, n, value, zero);                                                                      \
    }                                                                                                                  \
    real gs_special_##name##number(real x)                                                                             \
    {                                                                                                                  \
        const int before = fetestexcept(FE_UNDERFLOW);                                                                 \
        LOOK(1, &x);                                                                                                   \
        GS_CHOOSE_SINGLE(gs_##name##inner)(1, &x, &x);                                                                 \
        gs_excuse##array(before, 1, &x, zero);                                                                         \
        return x;                                                                                                      \
    }

#define GS_PUBLIC(name, inner, LOOK, zero)                                                                             \
    GS_DECLARE(gs_##name)                                                                                              \
    GS_SERVED(name, double, inner, _n, , LOOK, zero)                                                                   \
    GS_SERVED(name, float, _ns, _nf, f, LOOK, zero)

const char *gs_vectors(void) { return GS_VECTORS; }

@PUBLIC@
