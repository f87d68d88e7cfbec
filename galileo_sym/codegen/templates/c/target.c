/* @WHAT@ for @MACHINE@. */
#if @CONDITION@

#if defined(__clang__) /* or it evaluates what is selected away, and raises its flags */
#pragma STDC FENV_ACCESS ON
#endif
#include <immintrin.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("@FEATURES@"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("@FEATURES@")
#endif

#define GS_LANES @LANES@
#define GS_SUFFIX _@SUFFIX@
#include "@HEADER@"

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#else
typedef int gs_not_for_this_machine;
#endif
