"""Results as tables for notebooks."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._results import Check, Results

#: Engineers' units of SI units: factor and symbol, the largest first.
_UNITS: dict[str, tuple[tuple[float, str], ...]] = {
    "N": ((1e6, "MN"), (1e3, "kN"), (1.0, "N")),
    "N*m": ((1e6, "MN·m"), (1e3, "kN·m"), (1.0, "N·m")),
    "Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (1.0, "Pa")),
    "kg": ((1e3, "t"), (1.0, "kg")),
    "m": ((1.0, "m"), (1e-3, "mm")),
}

_COLOURS = {"holds": "#1a7f37", "accepted": "#8a6100", "fails": "#b3261e", "not_checked": "#8a6100", "incomplete": "#8a6100"}


def unit(values: Iterable[float], si: str) -> tuple[float, str]:
    """Factor and symbol of the unit in which the largest of these values is at least one."""
    largest = max((abs(v) for v in values), default=0.0)
    units = _UNITS.get(si, ((1.0, si.replace("*", "·")),))
    for factor, symbol in units:
        if largest >= factor:
            return factor, symbol
    return units[-1]


def number(value: float | None) -> str:
    """Three significant digits without an exponent; a dash for none."""
    if value is None:
        return "–"
    if value == 0 or not abs(value) < float("inf"):
        return f"{value:g}"
    text = f"{float(f'{value:.2e}'):.12f}".rstrip("0").rstrip(".")
    # 1.50 rather than 1.5: all values of a column have the same digits.
    digits = text.lstrip("-").replace(".", "").lstrip("0")
    if abs(value) < 1e3 and len(digits) < 3:
        text += ("" if "." in text else ".") + "0" * (3 - len(digits))
        text = text.rstrip(".")
    return text


def table(columns: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A plain table; numbers stand at the right."""

    def cell(value: Any) -> str:
        if isinstance(value, float):
            return f'<td style="text-align:right">{value:.4g}</td>'
        return f"<td>{'' if value is None else escape(str(value))}</td>"

    head = "".join(f"<th>{escape(c)}</th>" for c in columns)
    body = "".join(f"<tr>{''.join(cell(v) for v in row)}</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def results(found: Results) -> str:
    """Verdict, quantities by method under each excitation, checks of the deciding methods, figures."""
    status = found.status
    colour = _COLOURS.get(status, "inherit")
    parts = [
        f"<p><strong>{escape(found.name)}</strong>: "
        f'<strong style="color:{colour}">{escape(status.replace("_", " "))}</strong>{_governing(found.governing)}</p>'
    ]
    for excitation, title in (("record", "Record"), ("site", "Design spectrum of the site")):
        parts.append(_quantities(found, excitation, title))
    for deciding in found.data["verdict"].get("deciding", []):
        parts.append(_checks(found, deciding["method"], deciding["excitation"]))
    return "".join(parts) + _figures(found)


#: Figures of a report that a notebook shows, where the report has them.
_SHOWN = ("sketch", "hoop_total", "history_base_shear", "history_wave_height_theta_0")


def _figures(found: Results) -> str:
    """Figures as images, which run nothing, whatever their file contains."""
    folder = found.folder / "figures" if found.folder else None
    files = [folder / f"{name}.svg" for name in _SHOWN] if folder else []
    images = [b64encode(file.read_bytes()).decode("ascii") for file in files if file.is_file()]
    return "".join(f'<img alt="" style="width:48%;min-width:20em" src="data:image/svg+xml;base64,{image}"/>' for image in images)


def _governing(check: Check | None) -> str:
    if check is None or check.utilisation is None:
        return ""
    return f"; governing: {escape(check.name)} ({escape(check.method)}), utilisation {check.utilisation:.2f}"


def _quantities(found: Results, excitation: str, title: str) -> str:
    values = found.quantities.where(excitation=excitation)
    if not values:
        return ""
    methods = list(dict.fromkeys(q.method for q in values))
    lines = []
    for name in dict.fromkeys(q.name for q in values):
        row = {q.method: q for q in values if q.name == name}
        first = next(iter(row.values()))
        factor, symbol = unit((q.value for q in row.values()), first.unit)
        cells = (number(row[m].value / factor if m in row else None) for m in methods)
        head = f"{first.title} [{symbol}]" if symbol else first.title
        lines.append(_line(head, cells))
    return _titled(title, ["", *methods], lines)


def _checks(found: Results, method: str, excitation: str) -> str:
    lines = []
    for check in found.checks.where(method=method, excitation=excitation):
        if check.status == "not_applicable":
            continue
        given = [v for v in (check.demand, check.capacity) if v is not None]
        factor, symbol = unit(given, check.unit)
        scaled = (number(None if v is None else v / factor) for v in (check.demand, check.capacity))
        ratio = "–" if check.utilisation is None else f"{check.utilisation:.2f}"
        head = f"{check.name} [{symbol}]" if symbol and given else check.name
        lines.append(_line(head, [*scaled, ratio], check.status))
    return _titled(f"{method} ({excitation})", ["", "demand", "capacity", "utilisation", ""], lines) if lines else ""


def _line(head: str, cells: Iterable[str], status: str | None = None) -> str:
    right = "".join(f'<td style="text-align:right">{escape(c)}</td>' for c in cells)
    last = ""
    if status is not None:
        colour = _COLOURS.get(status, "inherit")
        last = f'<td style="color:{colour}">{escape(status.replace("_", " "))}</td>'
    return f'<tr><th style="text-align:left">{escape(head)}</th>{right}{last}</tr>'


def _titled(title: str, columns: Sequence[str], lines: Sequence[str]) -> str:
    head = "".join(f"<th>{escape(c)}</th>" for c in columns)
    caption = f'<caption style="text-align:left">{escape(title)}</caption>'
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"
