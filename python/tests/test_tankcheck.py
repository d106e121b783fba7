"""The package against the program it carries, or the one that TANKCHECK_BINARY names.

Values are checked against closed forms, and against the program's own JSON read without the package.
"""

from __future__ import annotations

import base64
import json
import math
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
import warnings
from html.parser import HTMLParser
from pathlib import Path
from unittest import mock

import tankcheck
from tankcheck import _calls, _html, _program

TANK = {
    "name": "Test <tank>",
    "tank": {
        "shape": "cylinder",
        "radius": "7.5 m",
        "support": "anchored",
        "courses": [{"height": "7.5 m", "thickness": "8 mm", "material": "steel"}],
    },
    "liquid": {"density": "1000 kg/m3", "fill_height": "6.5 m"},
    "materials": {"steel": {"grade": "S235"}},
    "site": {"ec8": {"ground": "B", "spectrum": 1, "ag": "0.25 g", "importance": 1.0}},
}


class Record:
    """A second of shaking at 1 Hz, as a file."""

    def __init__(self, folder: str) -> None:
        self.path = Path(folder) / "record.csv"
        lines = [f"{i * 0.01:.2f},{math.sin(2 * math.pi * i * 0.01):.6f}" for i in range(101)]
        self.path.write_text("time_s,acceleration_m_s2\n" + "\n".join(lines) + "\n", encoding="utf-8")


class Folders(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        # What the program warns of is asserted where it is meant.
        context = warnings.catch_warnings()
        context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        warnings.simplefilter("ignore", tankcheck.TankcheckWarning)

    def file(self, content: object, name: str = "tank.json") -> Path:
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path


class Check(Folders):
    def test_housner_by_his_formula(self) -> None:
        """ω² = 1.84 (g/R) tanh(1.84 H/R); 1.84 is rounded from 1.8412 or √(27/8) = 1.837, hence 0.2 %."""
        expected = 2 * math.pi / math.sqrt(1.84 * 9.80665 / 7.5 * math.tanh(1.84 * 6.5 / 7.5))
        results = tankcheck.check(TANK)
        self.assertAlmostEqual(results.value("sloshing_period", method="housner") / expected, 1.0, delta=2e-3)

    def test_the_path_and_the_dict_give_the_same(self) -> None:
        by_path, by_dict = tankcheck.check(self.file(TANK)), tankcheck.check(TANK)
        self.assertEqual(by_path.quantities, by_dict.quantities)
        self.assertEqual(by_path.checks, by_dict.checks)
        self.assertEqual(by_path.name, "Test <tank>")

    def test_everything_in_the_json_of_the_program_is_there(self) -> None:
        arguments = ["check", str(self.file(TANK)), "--format", "json"]
        program = tankcheck.find_program()
        if _program.has_option(program, "check", "--select"):
            arguments += ["--select", "all"]
        done = subprocess.run([program, *arguments], capture_output=True, check=False)
        raw = json.loads(done.stdout)
        results = tankcheck.check(self.file(TANK))
        self.assertEqual(results.exit_code, done.returncode)
        self.assertEqual(results.status, raw["verdict"]["status"])
        quantities = {(m["id"], m["excitation"], q): v["value"] for m in raw["methods"] for q, v in m["quantities"].items()}
        self.assertGreater(len(quantities), 20)
        self.assertEqual({(q.method, q.excitation, q.name): q.value for q in results.quantities}, quantities)
        checks = [(m["id"], c["id"], c["status"]) for m in raw["methods"] for c in m["checks"]]
        self.assertEqual([(c.method, c.id, c.status) for c in results.checks], checks)
        self.assertEqual(results.missing[0].input, raw["verdict"]["missing"][0]["check"]["input"])
        self.assertEqual(results.governing.utilisation, raw["verdict"]["governing"]["check"]["utilisation"])

    def test_options_reach_the_program(self) -> None:
        results = tankcheck.check(TANK, procedures=["ec8-2006", "housner"])
        self.assertEqual({m.id for m in results.methods}, {"ec8-2006", "housner"})

    def test_a_failed_check_is_a_result(self) -> None:
        thin = json.loads(json.dumps(TANK))
        thin["tank"]["courses"][0]["thickness"] = "1 mm"
        results = tankcheck.check(thin)
        self.assertEqual((results.status, results.exit_code, results.holds), ("fails", 1, False))
        self.assertEqual(results.governing.status, "fails")
        exceeded = [c for c in results.checks.where(status="fails") if c.utilisation is not None]
        self.assertTrue(exceeded)
        for check in exceeded:
            self.assertGreater(check.utilisation, 1.0)

    def test_a_report_is_written(self) -> None:
        results = tankcheck.check(TANK, out=self.folder / "out", report="summary")
        self.assertEqual(results.report, self.folder / "out" / "report.html")
        self.assertIn("Test &lt;tank&gt;", results.report.read_text(encoding="utf-8"))
        self.assertEqual(results.series(), {})
        self.assertIsNone(tankcheck.check(TANK).report)


class Select(Folders):
    @unittest.skipIf(os.name == "nt", "a shell script stands for the program")
    def test_everything_is_asked_for_where_the_program_can_be_asked(self) -> None:
        """A program whose help has --select gets --select=all; another one does not."""
        for known, expected in (("--select <FIELDS>", True), ("--selected", False)):
            program = self.folder / f"program{expected}"
            log = self.folder / f"log{expected}"
            script = f"""#!/bin/sh
case "$*" in *--help*) echo '{known}' ;; *) echo "$@" > '{log}'; exit 2 ;; esac
"""
            program.write_text(script, encoding="utf-8")
            program.chmod(0o755)
            with mock.patch.dict(os.environ, {_program.VARIABLE: str(program)}):
                with self.assertRaises(tankcheck.InputError):
                    tankcheck.check("tank.json")
            self.assertEqual("--select=all" in log.read_text(encoding="utf-8").split(), expected)


class Compare(Folders):
    def test_histories_begin_at_rest_and_follow_the_record(self) -> None:
        record = Record(str(self.folder))
        results = tankcheck.compare(TANK, quake=record.path, out=self.folder / "out", no_mesh_error=True)
        series = results.series()
        self.assertEqual(series["time_s"][0], 0.0)
        at = series["time_s"].index(0.25)
        self.assertAlmostEqual(series["ground_acceleration"][at], 1.0, delta=1e-6)
        shear = results.value("base_shear", method="fe", excitation="record")
        # The peak is that of the integration, whose step is finer than the samples.
        self.assertAlmostEqual(max(abs(v) for v in series["base_shear"]) / shear, 1.0, delta=1e-2)
        self.assertEqual({q.ratio for q in results.quantities.where(method="fe", excitation="record")}, {1.0})
        with self.assertRaisesRegex(KeyError, "give excitation, one of"):
            results.value("base_shear", method="ec8-2006")

    def test_without_a_folder_it_lives_as_long_as_the_results(self) -> None:
        results = tankcheck.compare(TANK, fe="none", quake=Record(str(self.folder)).path)
        folder = results.folder
        self.assertTrue(results.report.is_file())
        del results
        self.assertFalse(folder.exists())

    def test_a_failure_leaves_no_folder(self) -> None:
        with mock.patch.object(tempfile, "tempdir", str(self.folder)):
            with self.assertRaises(tankcheck.InputError):
                tankcheck.compare({}, quake="absent.csv")
        self.assertEqual(list(self.folder.iterdir()), [])


class Errors(Folders):
    def test_a_fault_has_key_value_and_what_is_allowed(self) -> None:
        bad = json.loads(json.dumps(TANK))
        bad["tank"]["radius"] = "-3 m"
        with self.assertRaises(tankcheck.InputError) as caught:
            tankcheck.check(bad)
        error = caught.exception
        self.assertEqual(error.exit_code, 2)
        for part in ("tank.radius", "-3 m", "expected"):
            self.assertIn(part, error.message)
        self.assertEqual(pickle.loads(pickle.dumps(error)).message, error.message)

    def test_a_missing_file_is_named(self) -> None:
        with self.assertRaisesRegex(tankcheck.InputError, "absent.json"):
            tankcheck.check(self.folder / "absent.json")

    def test_an_unknown_option_is_bad_input(self) -> None:
        with self.assertRaisesRegex(tankcheck.InputError, "--no-such-option"):
            tankcheck.check(TANK, no_such_option=3)

    def test_what_is_not_json_is_bad_input(self) -> None:
        for value in (math.nan, object()):
            with self.assertRaisesRegex(tankcheck.InputError, "the tank is not JSON"):
                tankcheck.check({"name": value})
        with self.assertRaisesRegex(TypeError, "expected a path or a dict, found int"):
            tankcheck.check(3)  # type: ignore[arg-type]

    def test_options_of_another_form_are_refused(self) -> None:
        with self.assertRaisesRegex(TypeError, "use tankcheck.run"):
            tankcheck.check(TANK, solve="fill_height")

    def test_exit_codes_have_their_error(self) -> None:
        kinds = {2: tankcheck.InputError, 3: tankcheck.ComputationError, 130: tankcheck.Interrupted}
        kinds |= {-2: tankcheck.Interrupted, -9: tankcheck.ComputationError}
        for code, kind in kinds.items():
            done = tankcheck.Completed(code, "", "error: found")
            with mock.patch.object(_calls, "run", return_value=done), self.assertRaises(kind) as caught:
                tankcheck.check(TANK)
            self.assertEqual(caught.exception.exit_code, code)
        self.assertTrue(issubclass(tankcheck.InputError, tankcheck.TankcheckError))

    def test_a_collapse_is_a_result(self) -> None:
        done = tankcheck.run(["check", "-", "--format=json", "--select=all"], stdin=json.dumps(TANK))
        stopped = tankcheck.Completed(3, done.stdout, "")
        with mock.patch.object(_calls, "run", return_value=stopped):
            self.assertEqual(tankcheck.check(TANK).exit_code, 3)

    def test_warnings_of_the_program_are_warnings(self) -> None:
        done = tankcheck.run(["check", "-", "--format=json", "--select=all"], stdin=json.dumps(TANK))
        warned = tankcheck.Completed(done.exit_code, done.stdout, "warning: a doubt\nnote: a remark\n")
        with mock.patch.object(_calls, "run", return_value=warned):
            with self.assertWarnsRegex(tankcheck.TankcheckWarning, "^a doubt$"):
                results = tankcheck.check(TANK)
        self.assertEqual(results.messages, ("warning: a doubt", "note: a remark"))

    def test_an_absent_program_is_named(self) -> None:
        with mock.patch.dict(os.environ, {_program.VARIABLE: str(self.folder / "none")}):
            with self.assertRaisesRegex(tankcheck.ProgramNotFound, "none"):
                tankcheck.version()
        places = mock.patch.object(_program, "_places", return_value=iter([self.folder / "nowhere"]))
        with mock.patch.dict(os.environ, {_program.VARIABLE: ""}), places:
            with self.assertRaisesRegex(tankcheck.ProgramNotFound, "nowhere"):
                tankcheck.version()


class Program(Folders):
    def test_version_and_module(self) -> None:
        module = subprocess.run([sys.executable, "-m", "tankcheck", "--version"], capture_output=True, text=True, check=True)
        self.assertEqual(module.stdout, f"tankcheck {tankcheck.version()}\n")
        self.assertRegex(tankcheck.version(), r"^\d+\.\d+\.\d+")
        failed = subprocess.run([sys.executable, "-m", "tankcheck", "check", "absent.json"], capture_output=True, check=False)
        self.assertEqual(failed.returncode, 2)

    def test_the_template_is_a_tank_file(self) -> None:
        for shape in ("cylinder", "rectangle"):
            path = self.file(tankcheck.template(shape), f"{shape}.json")
            self.assertIn(tankcheck.run(["check", path, "--quake", Record(str(self.folder)).path]).exit_code, (0, 1, 4))
        with self.assertRaises(tankcheck.InputError):
            tankcheck.template("sphere")

    def test_names_that_look_like_options_are_files(self) -> None:
        self.assertEqual(_calls._tank("-"), (os.path.join(".", "-"), None))
        self.assertEqual(_calls._tank("--help")[0], os.path.join(".", "--help"))

    def test_arguments(self) -> None:
        options = {"fe": "both", "no_mesh_error": True, "vtu": None, "resume": False, "procedures": ["a", "b"], "dt": 0.02}
        expected = ["--fe=both", "--no-mesh-error", "--procedures=a,b", "--dt=0.02"]
        self.assertEqual(_calls._arguments(options), expected)


class Hook(Folders):
    """`python -m tankcheck.hook`: what pre-commit and the GitHub action run."""

    def run_hook(self, *arguments: object) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "tankcheck.hook", *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_the_worst_file_decides(self) -> None:
        thin = json.loads(json.dumps(TANK))
        thin["tank"]["courses"][0]["thickness"] = "1 mm"
        good, fails, bad = self.file(TANK), self.file(thin, "thin.json"), self.file("{", "bad.json")
        self.assertEqual(self.run_hook(good).returncode, 4)
        self.assertEqual(self.run_hook("--allow-incomplete", good).returncode, 0)
        self.assertEqual(self.run_hook("--allow-incomplete", good, fails).returncode, 1)
        done = self.run_hook(good, fails, bad)
        self.assertEqual(done.returncode, 2)
        titles = [line for line in done.stdout.splitlines() if line.startswith("== ")]
        self.assertEqual(titles, [f"== {path}" for path in (good, fails, bad)])

    def test_options_reach_the_program(self) -> None:
        self.assertNotIn("api650", self.run_hook("--procedures=ec8-2006", self.file(TANK)).stdout)
        self.assertEqual(self.run_hook().returncode, 2)
        self.assertIn("usage: python -m tankcheck.hook", self.run_hook("--help").stdout)

    def test_names_are_files_and_print_one_line(self) -> None:
        home = Path(self.file(TANK)).parent
        for name in ("--out=x.json", "-h", "a\n::error::b.json", "##[stop]\u202e.json", "\x1b[31m.json"):
            (home / name).write_text(json.dumps(TANK), encoding="utf-8")
            command = [sys.executable, "-m", "tankcheck.hook", "--", name]
            done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=home)
            self.assertEqual(done.returncode, 4, (name, done.stderr))
            for line in (done.stdout + done.stderr).splitlines():
                self.assertFalse(line.lstrip().startswith("::"), line)
                self.assertTrue("##[" not in line and line.isprintable(), line)
        doubtful = [sys.executable, "-m", "tankcheck.hook", "--out=x.json", "tank.json"]
        done = subprocess.run(doubtful, capture_output=True, text=True, check=False, cwd=home)
        self.assertEqual(done.returncode, 2)
        self.assertIn("write -- before the files", done.stderr)
        self.assertFalse((home / "x.json").exists())


class Balanced(HTMLParser):
    """Every tag that opens closes."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag, tag


class Notebook(Folders):
    def test_html_is_balanced_and_escaped(self) -> None:
        results = tankcheck.check(TANK)
        for text in (results._repr_html_(), results.checks._repr_html_()):
            parser = Balanced()
            parser.feed(text)
            self.assertEqual(parser.open, [])
        page = results._repr_html_()
        self.assertIn("Test &lt;tank&gt;", page)
        self.assertNotIn("<tank>", page)
        self.assertIn("ec8-2006 (site)", page)

    def test_figures_and_viewer(self) -> None:
        out = self.folder / "out"
        results = tankcheck.check(TANK, out=out)
        page = results._repr_html_()
        sketch = (out / "figures" / "sketch.svg").read_bytes()
        self.assertIn(base64.b64encode(sketch).decode("ascii"), page)
        # An image runs nothing.
        self.assertNotIn("<svg", page)
        viewer = results.viewer()
        self.assertGreater(viewer.stat().st_size, 100_000)
        with self.assertRaisesRegex(ValueError, "give `out`"):
            tankcheck.check(TANK).viewer()

    def test_three_digits(self) -> None:
        shown = [_html.number(v) for v in (0.08612, 4.2, 286.4, 1234.5, 5.0, 0.0, None, 99.96)]
        self.assertEqual(shown, ["0.0861", "4.20", "286", "1230", "5.00", "0", "–", "100"])
        self.assertEqual(_html.unit([4.24e6, 1e3], "N"), (1e6, "MN"))
        self.assertEqual(_html.unit([2e-5], "m"), (1e-3, "mm"))

    def test_tables_filter_and_slice(self) -> None:
        checks = tankcheck.check(TANK).checks
        some = checks.where(method="ec8-2006", status="holds")
        self.assertTrue(some)
        self.assertEqual({c.method for c in some}, {"ec8-2006"})
        self.assertEqual(checks[:2].to_dicts()[0]["id"], checks[0].id)
        with self.assertRaisesRegex(TypeError, "unknown column 'stat'"):
            checks.where(stat="holds")

    def test_frames(self) -> None:
        results = tankcheck.check(TANK)
        try:
            import pandas  # noqa: F401
        except ImportError:
            with self.assertRaisesRegex(ImportError, "pip install pandas"):
                results.to_frame()
            return
        frame = results.to_frame()
        value = frame.loc[("base_shear", "N"), ("ec8-2006", "site")]
        self.assertEqual(value, results.value("base_shear", method="ec8-2006"))
        self.assertEqual(len(results.checks.to_frame()), len(results.checks))


if __name__ == "__main__":
    unittest.main()
