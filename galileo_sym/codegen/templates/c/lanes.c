/* The papers' formulas on one number at a time in plain C99, and the choice of the version for this machine. */
#include "galileo.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "galileo_loops.h"
#include "galileo_forms.h"

#if @CONDITION@
static int gs_has_wide_vectors(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")
        && __builtin_cpu_supports("avx512vl");
}
static int gs_has_vectors(void) { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
@DECLARED@
#define GS_CHOOSE(name)                                                                                                \
    (gs_has_wide_vectors() ? name##_avx512 : gs_has_vectors() ? name##_avx2 : name##_plain)
#define GS_CHOOSE_SINGLE(name) (gs_has_vectors() ? name##_fma : name##_plain)
#else
#define GS_CHOOSE(name) name##_plain
#define GS_CHOOSE_SINGLE(name) name##_plain
#endif

@PUBLIC@
