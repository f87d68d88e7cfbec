"""The two real branches of W about their branch point, as SymPy functions: nothing is lost where W meets exp."""

# ruff: noqa: N801 (named as the mathematical functions are, like those of SymPy)

from sympy import E, LambertW, S, exp

from galileo_sym.primitives.functions import Primitive


class w0_offset(Primitive):
    """w0_offset(x) = 1 + W0(-exp(-1 - x)), x >= 0: the h in [0, 1) with -h - log(1 - h) = x; like sqrt(2 x) at 0."""

    at_zero = S.Zero
    latex_name = r"\operatorname{offset}_0"
    is_nonnegative = True

    @staticmethod
    def _derivative(x):
        return 1 / w0_offset(x) - 1

    def _eval_rewrite_as_LambertW(self, x, **kwargs):
        return 1 + LambertW(-exp(-1 - x))


class wm1_offset(Primitive):
    """wm1_offset(x) = 1 + W-1(-exp(-1 - x)), x >= 0: -s with s - log(1 + s) = x, s >= 0; like -sqrt(2 x) at 0."""

    at_zero = S.Zero
    latex_name = r"\operatorname{offset}_{-1}"
    is_nonpositive = True

    @staticmethod
    def _derivative(x):
        return 1 / wm1_offset(x) - 1

    def _eval_rewrite_as_LambertW(self, x, **kwargs):
        return 1 + LambertW(-exp(-1 - x), -1)


class branch_factor(Primitive):
    """branch_factor(r) = exp(-W0(x)) = W0(x)/x at r = sqrt(2 (1 + e x)) >= 0; e at r = 0, and 1 at x = 0.

    Regular at the branch point, where W0(x) = -1 + r - r**2/3 + ..., and where x = 0.
    """

    at_zero = E
    latex_name = r"\operatorname{branch}"
    is_positive = True

    @staticmethod
    def _derivative(r):
        factor = branch_factor(r)
        return -r * factor**2 / (E + (r**2 / 2 - 1) * factor)

    def _eval_rewrite_as_LambertW(self, r, **kwargs):
        return exp(-LambertW((r**2 / 2 - 1) * exp(-1)))


OF_BRANCHES = {cls.__name__: cls for cls in (w0_offset, wm1_offset, branch_factor)}
