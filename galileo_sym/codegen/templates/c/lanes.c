/* The papers' formulas on one number at a time in plain C99, and the choice of the version for this machine. */
#include "galileo.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "galileo_forms.h"
#include "galileo_versions.h"

#if @CONDITION@
@DECLARED@
#endif

@PUBLIC@
