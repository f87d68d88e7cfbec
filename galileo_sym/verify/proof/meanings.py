"""What each operation is in the vector header: its definition for 1, 4 and 8 lanes, held against the replay's."""

import re

from .emitted import RefusedSource

# operation: its body in plain C, with AVX2 and FMA, and with AVX-512
_BY_LANES = {
    "gs_v_of": ("x", "_mm256_set1_pd(x)", "_mm512_set1_pd(x)"),
    "gs_add": ("a + b", "_mm256_add_pd(a, b)", "_mm512_add_pd(a, b)"),
    "gs_sub": ("a - b", "_mm256_sub_pd(a, b)", "_mm512_sub_pd(a, b)"),
    "gs_mul": ("a * b", "_mm256_mul_pd(a, b)", "_mm512_mul_pd(a, b)"),
    "gs_div": ("a / b", "_mm256_div_pd(a, b)", "_mm512_div_pd(a, b)"),
    "gs_fma": ("fma(a, b, c)", "_mm256_fmadd_pd(a, b, c)", "_mm512_fmadd_pd(a, b, c)"),
    "gs_fms": ("fma(a, b, -c)", "_mm256_fmsub_pd(a, b, c)", "_mm512_fmsub_pd(a, b, c)"),
    "gs_fnma": ("fma(-a, b, c)", "_mm256_fnmadd_pd(a, b, c)", "_mm512_fnmadd_pd(a, b, c)"),
    "gs_sqrt": ("sqrt(a)", "_mm256_sqrt_pd(a)", "_mm512_sqrt_pd(a)"),
    "gs_abs": ("fabs(a)", "_mm256_andnot_pd(_mm256_set1_pd(-0.0), a)", "_mm512_abs_pd(a)"),
    "gs_flip": (
        "signbit(x) ? -a : a",
        "_mm256_xor_pd(a, _mm256_and_pd(x, _mm256_set1_pd(-0.0)))",
        "_mm512_xor_pd(a, _mm512_and_pd(x, _mm512_set1_pd(-0.0)))",
    ),
    "gs_min": ("isless(a, b) ? a : b", "_mm256_min_pd(a, b)", "_mm512_min_pd(a, b)"),
    "gs_select": ("m ? a : b", "_mm256_blendv_pd(b, a, m)", "_mm512_mask_blend_pd(m, b, a)"),
    "gs_less": ("isless(a, b)", "_mm256_cmp_pd(a, b, _CMP_LT_OQ)", "_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ)"),
    "gs_at_least": ("isgreaterequal(a, b)", "_mm256_cmp_pd(a, b, _CMP_GE_OQ)", "_mm512_cmp_pd_mask(a, b, _CMP_GE_OQ)"),
    "gs_both": ("a && b", "_mm256_and_pd(a, b)", "a & b"),
    "gs_all": ("m", "_mm256_movemask_pd(m) == 0xf", "m == 0xff"),
}
# the look-up in plain C; that the vector versions pick the same is a matter of their bits, which the tests compare
_PLAIN = {
    "gs_bits": "uint64_t bits; memcpy(&bits, &x, sizeof bits); return bits;",
    "gs_piece": "return (int64_t)(gs_bits(shifted) >> drop) - first;",
    "gs_pick": "return table[i];",
    "gs_of_bits": "double x; memcpy(&x, &bits, sizeof x); return x;",
    "gs_low_index": "return (int64_t)(gs_bits(u) & 15);",
    "gs_power": "return gs_of_bits(0x3ff0000000000000 - (gs_bits(u) >> 4 << 52));",
    "gs_exponent": "return gs_of_bits(gs_bits(x) >> 52 | 0x4330000000000000) - 0x1.00000000004p+52;",
    "gs_mantissa": "return gs_of_bits((gs_bits(x) & 0xfffffffffffff) | 0x4000000000000000);",
}
_COMMON = {
    "gs_rest": "return gs_add(gs_sub(a, s), b);",
    "gs_sum_rest": (
        "const gs_v b_part = gs_sub(s, a); return gs_add(gs_sub(a, gs_sub(s, b_part)), gs_sub(b, b_part));"
    ),
    "gs_product_rest": "return gs_fms(a, b, p);",
    "gs_within": "return gs_both(gs_at_least(x, lo), gs_less(x, hi));",
    "gs_refuse_beyond": (
        "const gs_v zero = gs_v_of(0.0); const gs_mask good = gs_both(gs_at_least(x, lower), gs_at_least(upper, x)); "
        "const gs_v z = gs_select(good, zero, "
        "gs_select(gs_within(x, gs_v_of(-INFINITY), gs_v_of(INFINITY)), gs_v_of(INFINITY), x)); "
        "*lo = gs_select(good, *lo, zero); return gs_select(good, r, gs_sub(z, z));"
    ),
    "gs_refuse_negative": "return gs_refuse_beyond(x, gs_v_of(0.0), gs_v_of(INFINITY), r, lo);",
}
_VECTORS = ("double", "__m256d", "__m512d")
_BRANCHES = re.compile(r"#if GS_LANES == 8\n(.*?)\n#elif GS_LANES == 4\n(.*?)\n#else\n(.*?)\n#endif\n(.*)", re.DOTALL)
_DEFINITION = re.compile(r"^static inline \w+ (gs_\w+)\((.*?)\)[^{\n]*(?:\n\s*)?\{(.*?)\}$", re.DOTALL | re.MULTILINE)
_TABLE_MACRO = re.compile(
    r"#define GS_TABLE\(name\) static const double name\[16\]( __attribute__\(\(aligned\(64\)\)\))?\n"
)


def _definitions(text):
    """Return {name: body, in single spaces}; a name defined twice has no body."""
    found = {}
    for name, _, body in _DEFINITION.findall(text):
        found[name] = None if name in found else " ".join(body.split())
    return found


def _wrong(defined, expected, where):
    return [f"{name} {where}: {defined.get(name)!r}" for name, body in expected.items() if defined.get(name) != body]


def require_meanings(header):
    """Hold the vector header against the operations that the replay knows.

    Parameters
    ----------
    header : str
        The text of galileo_vector.h.

    Raises
    ------
    RefusedSource
        If an operation is defined in another way, or in another number of places, for any number of lanes.
    """
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = "\n".join(line.rstrip() for line in text.split("\n"))
    parts = _BRANCHES.search(text)
    if not parts:
        raise RefusedSource("galileo_vector.h has no branches for 8, 4 and 1 lanes")
    eight, four, one, common = map(_definitions, parts.groups())
    by_lanes = {name: [f"return {body};" for body in bodies] for name, bodies in _BY_LANES.items()}
    wrong = _wrong(one, {name: bodies[0] for name, bodies in by_lanes.items()} | _PLAIN, "in plain C")
    wrong += _wrong(four, {name: bodies[1] for name, bodies in by_lanes.items()}, "with AVX2")
    wrong += _wrong(eight, {name: bodies[2] for name, bodies in by_lanes.items()}, "with AVX-512")
    wrong += _wrong(common, _COMMON, "for all")
    wrong += [f"no vector of {kind}" for kind in _VECTORS if f"typedef {kind} gs_v;" not in text]
    if len(_TABLE_MACRO.findall(text)) != 2 or text.count("define GS_TABLE") != 2:
        wrong.append("GS_TABLE is no table of sixteen doubles")
    known = (*_BY_LANES, *_PLAIN, *_COMMON)
    wrong += [f"{name} is a macro" for name in known if re.search(rf"#\s*define\s+{name}\b", text)]
    if wrong:
        raise RefusedSource(f"galileo_vector.h does not define what the proof takes: {'; '.join(wrong)}")
