"""How the papers' formulas compute on vectors, in C: with pairs of doubles, and for binary32 with doubles alone."""

from dataclasses import dataclass

from galileo_sym.codegen.hoisting import operands_of

_FAILING = {"driving": ("good", "held")} | dict.fromkeys(("below", "arctangent", "shot", "launch", "roots"), ("good",))


@dataclass(frozen=True)
class Arithmetic:
    """How a form computes: C types, what its operations begin with, and which of them may fail in a lane.

    ``kind`` is the type of arguments and results; ``number`` the type of values, ``types`` those of what certain nodes
    give. ``load``, ``store``, ``padded`` name what moves vectors; ``rate`` makes a vector of a lane's argument that
    is a rate, as others are taken as they are; ``pair`` makes a number of such a vector, ``value`` a lane's result of
    a number; ``widened`` makes a double of an argument for the scaled form. ``ordinary`` tests arguments by domain;
    ``failing`` gives the masks that an operation changes; ``of_kinds`` names the operation in which operands are
    plain, that is vectors of doubles, where numbers are pairs.
    """

    kind: str
    prefix: str
    number: str
    types: dict
    load: str
    store: str
    padded: str
    rate: str
    pair: str
    value: str
    widened: dict
    ordinary: dict
    failing: dict
    of_kinds: dict


DOUBLE = Arithmetic(
    kind="double",
    prefix="gs_vp_",
    number="gs_vp",
    types={"angle": "gs_turn", "shot": "gs_vp_best", "launch": "gs_vp_angles", "roots": "gs_vp_roots_values"},
    load="gs_v_load",
    store="gs_v_store",
    padded="gs_padded",
    rate="gs_felt({})",
    pair="gs_vp_load({})",
    value="gs_vp_value({})",
    widened={},
    ordinary={  # no term of a formula over- or underflows, nor what a product leaves
        "positive": "gs_between({}, 0x1p-100, 0x1p+100)",
        "nonnegative": "gs_between_or_0({}, 0x1p-100, 0x1p+100)",
        "rate": "gs_between({}, 0.0, 0x1p+100)",
        "chord angle": "gs_between_or_0(gs_abs({}), 0x1p-100, GS_HALF_TURN_0)",
        "elevation": "gs_between_or_0({}, 0x1p-100, GS_HALF_TURN_0)",
        "chord angle, idle": "gs_at_least(gs_v_of(GS_HALF_TURN_0), gs_abs({}))",
        "real": "gs_between_or_0(gs_abs({}), 0x1p-100, 0x1p+100)",
    },
    failing=_FAILING | {"phi0m": ("good",)},
    of_kinds={
        ("mul", True, True): "product",
        ("mul", False, True): "times",
        ("div", True, True): "quotient",
        ("div", False, True): "over",
        ("driving", False, True): "driving",
    },
)
SINGLE = Arithmetic(
    kind="float",
    prefix="gs_s_",
    number="gs_v",
    types={"angle": "gs_turn_single", "shot": "gs_best", "launch": "gs_s_angles", "roots": "gs_s_roots_values"},
    load="gs_v_widen",
    store="gs_v_narrow",
    padded="gs_padded_single",
    rate="{}",
    pair="{}",
    value="{}",
    widened={"chord angle": "gs_wide_angle({})", "elevation": "gs_wide_angle({})"},
    ordinary={
        "positive": "gs_between({}, 0x1p-149, 0x1p+128)",
        "nonnegative": "gs_between({}, 0.0, 0x1p+128)",
        "rate": "gs_between({}, 0.0, 0x1p+128)",
        "chord angle": "gs_between(gs_abs({}), 0.0, GS_HALF_TURN_SINGLE)",
        "elevation": "gs_between({}, 0.0, GS_HALF_TURN_SINGLE)",
        "chord angle, idle": "gs_between(gs_abs({}), 0.0, GS_HALF_TURN_SINGLE)",
        "real": "gs_between(gs_abs({}), 0.0, 0x1p+128)",
    },
    failing=_FAILING | {"add": ("good",), "sub": ("good",)},
    of_kinds={},
)


def is_rate(argument):
    """Whether an argument enters by factors that are 1 where it is small, so that 0 stands for the smallest."""
    return argument.name in ("gamma", "k")


def size_of(argument, turned):
    """Return which test tells whether an argument is of ordinary size: a key of ``Arithmetic.ordinary``.

    ``turned`` says whether the form has a sine or cosine; if not, an angle needs only be one.
    """
    return "rate" if is_rate(argument) else argument.domain + ", idle" * (argument.unit == "rad" and not turned)


def call_text(node, arithmetic, good, plain):
    """A node as nested calls; good is the mask of lanes that its operations may change, plain names what is no pair."""
    if isinstance(node, str):
        return arithmetic.pair.format(node) if node in plain else node
    prefix = arithmetic.prefix
    if node[0] == "constant":
        return f"{prefix}constant({node[1]!r})"
    operands = operands_of(node)
    if node[0] == "mul" and operands[0] in plain:
        operands = operands[::-1]
    operation = arithmetic.of_kinds.get((node[0], *(operand in plain for operand in operands)))
    exact = plain if operation else ()
    texts = [o if o in exact else call_text(o, arithmetic, good, plain) for o in operands]
    if node[0] == "scale":
        return f"{prefix}scaled({texts[0]}, {float(2) ** node[2]!r})"
    masks = [f"&{good if mask == 'good' else mask}" for mask in arithmetic.failing.get(node[0], ())]
    return f"{prefix}{operation or node[0]}({', '.join([*texts, *masks])})"
