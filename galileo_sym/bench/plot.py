"""Run time against error as a plot: the nearer to the lower left corner, the better."""

import math
from importlib.util import find_spec
from pathlib import Path

from galileo_sym.files import write_whole

from .cases import TINY_DRAG
from .core import ARRAYS

PANELS = (
    "chord.descent_time drag",
    "chord.descent_time friction_drag",
    "chord.distance drag",
    "projectile.flight_time drag",
    "projectile.horizontal_range drag",
    "projectile.best_angle",
    "lambert.w0",
    "lambert.wm1",
)
_LOOKS = {  # colours that are told apart by everyone; shapes tell back ends and formats apart as well
    "C": ("#0072b2", "o"),
    "C, float32": ("#0072b2", "s"),
    "NumPy": ("#56b4e9", "o"),
    "NumPy, float32": ("#56b4e9", "s"),
    "verify's references": ("#666666", "P"),
    "lambdify": ("#d55e00", "D"),
    "SciPy": ("#e69f00", "v"),
    "C, Boost's W": ("#009e73", "^"),
    "C, GSL's W": ("#b8860b", "<"),
    "Rust, lambert_w": ("#cc79a7", ">"),
}
_LEAST, _MOST = 0.3, 1e20  # errors beyond are drawn at the edge
_PER_LINE = 4
_CAPTION = (
    "Largest error sampled (a lower bound), in ulp of the format, against time an element. Filled: typical inputs; "
    "open: tiny drag. Errors above 1e20 are drawn there. {date}; {machine}."
)


def can_plot():
    """Whether matplotlib is there."""
    return find_spec("matplotlib") is not None


def _place(row):
    return row.ns.median, min(max(row.ulp, _LEAST), _MOST)


def _draw_panel(axes, title, rows):
    axes.set(xscale="log", yscale="log", title=title, ylim=(_LEAST / 2, 4 * _MOST))
    axes.title.set_fontsize(9)
    axes.grid(True, which="major", linewidth=0.4, alpha=0.5)
    axes.axhline(1.0, color="black", linewidth=0.6, linestyle=":")
    for name, (colour, shape) in _LOOKS.items():
        of_name = [row for row in rows if row.contestant == name and not math.isnan(row.ulp)]
        for row in of_name:
            inside = "none" if row.case.endswith(TINY_DRAG) else colour
            axes.plot(*_place(row), shape, color=colour, markerfacecolor=inside, markersize=6, linestyle="none")
        if len(of_name) == 2:
            axes.plot(*zip(*map(_place, of_name), strict=True), color=colour, linewidth=0.6, alpha=0.6)


def pareto(rows, stamp, target):
    """Draw time against error, a panel for each function that was measured, and write it as SVG.

    Parameters
    ----------
    rows : list of Row
    stamp : dict
        Date and machine.
    target : Path

    Returns
    -------
    bool
        Whether there was anything to draw.
    """
    import matplotlib as mpl  # noqa: PLC0415 (an extra, and slow to import)
    from matplotlib.figure import Figure  # noqa: PLC0415

    rows = [row for row in rows if row.layout == ARRAYS]
    panels = [name for name in PANELS if any(row.case == name for row in rows)]
    if not panels:
        return False
    lines = math.ceil(len(panels) / _PER_LINE)
    with mpl.rc_context({"svg.hashsalt": "galileo-sym", "svg.fonttype": "none", "font.size": 8}):
        figure = Figure(figsize=(3.1 * _PER_LINE, 2.9 * lines + 0.9), layout="constrained")
        grid = figure.subplots(lines, _PER_LINE, sharex=True, sharey=True, squeeze=False)
        for axes, name in zip(grid.flat, panels, strict=False):
            _draw_panel(axes, name, [row for row in rows if row.case in (name, f"{name} {TINY_DRAG}")])
        for axes in list(grid.flat)[len(panels) :]:
            axes.set_axis_off()
        for axes in grid[:, 0]:
            axes.set_ylabel("max ulp")
        for axes in grid[-1, :]:
            axes.set_xlabel("ns an element")
        there = [name for name in _LOOKS if any(row.contestant == name for row in rows)]
        handles = [mpl.lines.Line2D([], [], color=_LOOKS[n][0], marker=_LOOKS[n][1], linestyle="none") for n in there]
        figure.legend(handles, there, loc="outside lower center", ncols=min(5, len(there)), frameon=False)
        figure.suptitle(_CAPTION.format(**stamp), fontsize=8)
        _write(figure, target)
    return True


def _write(figure, target):
    target = Path(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, format="svg", metadata={"Date": None})
    text = target.read_text(encoding="utf-8")  # without blanks at line ends, which version control complains of
    write_whole(target, ("\n".join(line.rstrip() for line in text.splitlines()) + "\n").encode())
