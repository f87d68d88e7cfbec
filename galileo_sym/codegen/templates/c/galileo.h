/* Motion on chords and of projectiles under gravity, friction and linear resistance: closed forms, arranged so that
 * they stay accurate over the whole range of the floating-point numbers; errors are measured, not proved.
 *
 * SI units, angles in radians. Every function comes for double and, with a trailing f, for float (computed in double,
 * rounded once); and for arrays of n elements, _n and _nf, whose outputs may be the inputs. A suffix names the forces
 * that act: _free, _friction, _drag, _friction_drag take only the arguments these need; without a suffix all are taken.
 *
 * Outside the domain: NaN, and FE_INVALID is raised. NaN in: NaN out, no exception raised. Infinite arguments give the
 * limit; where there is none, NaN and FE_INVALID. Overflow and underflow are raised by the result only. Needs
 * round-to-nearest. No allocation, no global state, no errno contract. Link with -lm.
 */
#ifndef GALILEO_H
#define GALILEO_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the array functions that this machine runs: "avx512", "avx2" or "plain"; the bits are the same. */
const char *gs_vectors(void);

@DECLARATIONS@
#ifdef __cplusplus
}
#endif

#endif
