"""Results as objects: rows of tables, and the whole."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any, Generic, TypeVar, overload

from . import _html, _program, errors


@dataclass(frozen=True)
class Quantity:
    """A quantity of a method, SI."""

    #: Id of the method, ``"ec8-2006"``; of the finite elements ``"fe"``.
    method: str
    #: ``"record"`` or ``"site"`` (design spectrum).
    excitation: str
    #: Id, ``"base_shear"``.
    name: str
    #: Name for people.
    title: str
    value: float
    unit: str
    #: Ratio to the finite elements, where they ran.
    ratio: float | None


@dataclass(frozen=True)
class Check:
    """A limit state of a method, SI."""

    method: str
    excitation: str
    #: Id, ``"freeboard"``.
    id: str
    #: ``"holds"``, ``"fails"``, ``"not_checked"``, ``"not_applicable"`` or ``"accepted"``.
    status: str
    name: str
    demand: float | None
    capacity: float | None
    #: Demand over capacity.
    utilisation: float | None
    unit: str
    clause: str
    #: Why it was not checked, does not apply or is accepted.
    reason: str | None
    #: Key of the tank file that the check needs, ``"tank.pipes"``.
    input: str | None
    note: str


@dataclass(frozen=True)
class Method:
    """A code procedure or an engine, under one excitation."""

    id: str
    title: str
    excitation: str
    #: ``"computed"`` or ``"not-applicable"``.
    status: str
    #: Why it does not apply.
    reason: str | None


Row = TypeVar("Row", bound="Quantity | Check | Method")


class Table(Sequence[Row], Generic[Row]):
    """Rows of one kind."""

    def __init__(self, kind: type[Row], rows: Iterable[Row]) -> None:
        self._kind: type[Row] = kind
        self._rows: tuple[Row, ...] = tuple(rows)

    @overload
    def __getitem__(self, index: int) -> Row: ...
    @overload
    def __getitem__(self, index: slice) -> Table[Row]: ...
    def __getitem__(self, index: int | slice) -> Row | Table[Row]:
        if isinstance(index, slice):
            return Table(self._kind, self._rows[index])
        return self._rows[index]

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self._rows)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._rows == other._rows

    def __hash__(self) -> int:
        return hash(self._rows)

    def __repr__(self) -> str:
        return f"<{len(self)} × {self._kind.__name__}: {', '.join(self.columns)}>"

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns."""
        return tuple(field.name for field in fields(self._kind))

    def where(self, **values: Any) -> Table[Row]:
        """The rows with these values, such as ``method="ec8-2006", excitation="site"``."""
        for name in values:
            if name not in self.columns:
                raise TypeError(f"unknown column {name!r}, expected one of {', '.join(self.columns)}")
        return Table(self._kind, (r for r in self if all(getattr(r, k) == v for k, v in values.items())))

    def to_dicts(self) -> list[dict[str, Any]]:
        """A dictionary for each row."""
        return [asdict(row) for row in self]

    def to_frame(self) -> Any:
        """A ``pandas.DataFrame``; needs pandas."""
        return _pandas().DataFrame(self.to_dicts(), columns=list(self.columns))

    def _repr_html_(self) -> str:
        return _html.table(self.columns, ([getattr(row, c) for c in self.columns] for row in self))


class Results:
    """What ``check`` and ``compare`` found.

    * ``data``: the content of ``results.json``, with everything that has no attribute here
    * ``exit_code``: 0 holds, 1 a check fails, 3 unfinished or collapsed, 4 something required was not checked
    * ``messages``: warnings and notes of the program
    * ``folder``: where report and histories are; ``None`` without ``out``
    """

    def __init__(self, data: dict[str, Any], *, exit_code: int, messages: tuple[str, ...] = (), folder: Path | None = None):
        self.data = data
        self.exit_code = exit_code
        self.messages = messages
        self.folder = folder

    @property
    def name(self) -> str:
        """Name of the tank."""
        return str(self.data["name"])

    @property
    def status(self) -> str:
        """The verdict: ``"holds"``, ``"fails"``, ``"incomplete"`` or ``"not_assessed"``."""
        return str(self.data["verdict"]["status"])

    @property
    def holds(self) -> bool:
        """Whether everything that the deciding codes require was checked and holds, or is an accepted gap."""
        return self.exit_code == 0

    @property
    def methods(self) -> Table[Method]:
        """Code procedures and engines."""
        return Table(
            Method,
            (
                Method(m["id"], m["title"], m["excitation"], m["status"]["kind"], m["status"].get("reason"))
                for m in self.data["methods"]
            ),
        )

    @property
    def quantities(self) -> Table[Quantity]:
        """Quantities of all methods."""
        rows = []
        methods = self.data["methods"]
        for line in self.data["comparison"]["rows"]:
            for method, cell in zip(methods, line["cells"]):
                found = method["quantities"].get(line["quantity"])
                if cell is None or found is None:
                    continue
                rows.append(
                    Quantity(
                        method=method["id"],
                        excitation=method["excitation"],
                        name=line["quantity"],
                        title=line["title"],
                        value=found["value"],
                        unit=found["unit"],
                        ratio=cell.get("ratio"),
                    )
                )
        return Table(Quantity, rows)

    @property
    def checks(self) -> Table[Check]:
        """Limit states of all methods."""
        return Table(Check, (_check(m, c) for m in self.data["methods"] for c in m["checks"]))

    @property
    def governing(self) -> Check | None:
        """The check with the largest utilisation among those that decide."""
        found = self.data["verdict"].get("governing")
        return _check({"id": found["method"], "excitation": found["excitation"]}, found["check"]) if found else None

    @property
    def missing(self) -> Table[Check]:
        """Required checks that were not made."""
        found = self.data["verdict"].get("missing", [])
        return Table(Check, (_check({"id": m["method"], "excitation": m["excitation"]}, m["check"]) for m in found))

    def value(self, quantity: str, *, method: str, excitation: str | None = None) -> float:
        """A quantity of a method, SI; ``excitation`` is needed where the method ran under both.

        Raises ``KeyError`` if there is none, or more than one.
        """
        rows = self.quantities.where(name=quantity, method=method)
        if excitation is not None:
            rows = rows.where(excitation=excitation)
        if len(rows) == 1:
            return rows[0].value
        if rows:
            raise KeyError(f"{quantity} of {method}: give excitation, one of {', '.join(r.excitation for r in rows)}")
        known = sorted({(r.name, r.method, r.excitation) for r in self.quantities if quantity in r.name or r.method == method})
        raise KeyError(f"{quantity} of {method}: no such value; found {known}")

    @property
    def report(self) -> Path | None:
        """Path of ``report.html``; ``None`` without ``out``."""
        return self.folder / "report.html" if self.folder else None

    def viewer(self) -> Path:
        """Writes ``interactive.html`` beside the report and returns its path: scene, charts and tables in one file.

        In a notebook: ``IPython.display.IFrame(results.viewer(), 1000, 700)``, where the notebook may show local files.
        """
        if self.folder is None:
            raise ValueError("results without a folder have no viewer: give `out`")
        done = _program.run(["report", self.folder, "--interactive"])
        if done.exit_code != 0:
            raise errors.of_exit_code(done.exit_code, done.stderr.strip())
        return self.folder / "interactive.html"

    def series(self) -> dict[str, list[float]]:
        """Time histories by name, SI; empty without a record or without ``out``. Missing samples are NaN."""
        if self.folder is None or not (self.folder / "series.csv").is_file():
            return {}
        with open(self.folder / "series.csv", newline="", encoding="utf-8") as file:
            rows = csv.reader(file)
            head = next(rows, [])
            columns = list(zip(*rows)) or [() for _ in head]
        # Heads are `base_shear [N]`.
        names = [name.split(" [", 1)[0] for name in head]
        return {name: [float(v) if v else float("nan") for v in column] for name, column in zip(names, columns)}

    def to_frame(self) -> Any:
        """Quantities as a ``pandas.DataFrame``: a row for each, a column for each method and excitation; needs pandas."""
        frame = self.quantities.to_frame()
        wide = frame.pivot(index=["name", "unit"], columns=["method", "excitation"], values="value")
        order = dict.fromkeys((q.name, q.unit) for q in self.quantities)
        columns = dict.fromkeys((q.method, q.excitation) for q in self.quantities)
        return wide.reindex(index=list(order), columns=list(columns))

    def __repr__(self) -> str:
        return f"<tankcheck.Results {self.name!r}: {self.status}>"

    def _repr_html_(self) -> str:
        return _html.results(self)


def _check(method: dict[str, Any], check: dict[str, Any]) -> Check:
    return Check(
        method=method["id"],
        excitation=method["excitation"],
        id=check["id"],
        status=check["status"],
        name=check["name"],
        demand=check.get("demand"),
        capacity=check.get("capacity"),
        utilisation=check.get("utilisation"),
        unit=check.get("unit", ""),
        clause=check.get("clause", ""),
        reason=check.get("reason"),
        input=check.get("input"),
        note=check.get("note", ""),
    )


def _pandas() -> Any:
    try:
        import pandas  # type: ignore[import-untyped,unused-ignore]
    except ImportError as error:
        raise ImportError("to_frame needs pandas: pip install pandas") from error
    return pandas
