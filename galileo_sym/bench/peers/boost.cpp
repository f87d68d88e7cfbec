// Printed formulas with the Lambert W of Boost.Math. FUNCTIONS is put in place of the line that says so.
#include <boost/math/special_functions/lambert_w.hpp>
#include <cmath>
#include <cstddef>

using std::asin;
using std::atan;
using std::cos;
using std::exp;
using std::fabs;
using std::pow;
using std::sin;
using std::sqrt;
using std::tan;

namespace policies = boost::math::policies;
using Quiet = policies::policy<
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>, policies::evaluation_error<policies::ignore_error>,
    policies::underflow_error<policies::ignore_error>, policies::denorm_error<policies::ignore_error>>;

static inline double W0(double x) { return boost::math::lambert_w0(x, Quiet()); }
static inline double Wm1(double x) { return boost::math::lambert_wm1(x, Quiet()); }

extern "C" {
/* FUNCTIONS */
}
