/* The choice of a version for this machine, at each call; without versions the plain one, whose names end in _plain. */
#ifndef GALILEO_VERSIONS_H
#define GALILEO_VERSIONS_H

#if @CONDITION@
static inline int gs_has_wide_vectors(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")
        && __builtin_cpu_supports("avx512vl");
}
static inline int gs_has_vectors(void) { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#define GS_CHOOSE(name)                                                                                                \
    (gs_has_wide_vectors() ? name##_avx512 : gs_has_vectors() ? name##_avx2 : name##_plain)
#define GS_CHOOSE_SINGLE(name) (gs_has_vectors() ? name##_fma : name##_plain)
#define GS_VECTORS (gs_has_wide_vectors() ? "avx512" : gs_has_vectors() ? "avx2" : "plain")
#else
#define GS_CHOOSE(name) name##_plain
#define GS_CHOOSE_SINGLE(name) name##_plain
#define GS_VECTORS "plain"
#endif

#endif
