/* Printed formulas with the Lambert W of the GNU Scientific Library. FUNCTIONS is put in place of the line that says so. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_lambert.h>
#include <math.h>
#include <stddef.h>

static inline double W0(double x) { return gsl_sf_lambert_W0(x); }
static inline double Wm1(double x) { return gsl_sf_lambert_Wm1(x); }

/* Outside of the domain GSL would end the process. */
__attribute__((constructor)) static void quiet(void) { gsl_set_error_handler_off(); }

/* FUNCTIONS */
