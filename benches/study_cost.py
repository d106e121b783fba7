"""Measures what a study costs: the farm of example 10 under 50 synthetic records of 31 s.

    python3 benches/study_cost.py target/release/tankcheck [--singles 100] [--codes] [--merge] [--hq PYTHON]

CPU seconds are user and system time of the program. Wall times mean something on idle cores alone. `--singles N` also runs N single
`compare -q --no-mesh-error --no-report` of the same tanks and records; `--codes` 10,000 rows of the codes alone; `--merge` a merge of
100,000 rows; `--hq PYTHON` the rows of one scale as 100 tasks on two local threads and on a HyperQueue worker of two cores, three times each in turn, where
PYTHON has the package `hyperqueue`. Its server listens in a network namespace of its own. Folders stand in a temporary folder.
"""

import argparse
import csv
import json
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

EXAMPLE = Path(__file__).resolve().parent.parent / "examples/10_tank_farm"


class Runs:
    def __init__(self, program, home):
        self.program, self.home, self.cpu = str(program), home, {}

    def __call__(self, what, *arguments, count=1):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        done = subprocess.run([self.program, *map(str, arguments)], cwd=self.home, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode not in (0, 1, 4):
            sys.exit(f"{arguments}: exit {done.returncode}\n{done.stdout}{done.stderr}")
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.cpu[what] = self.cpu.get(what, 0.0) + cpu
        if count:
            print(f"{what:<40} {time.monotonic() - start:8.2f} s wall {cpu:8.2f} CPU s", flush=True)
        return done.stdout


def study(home, name, scales, records="records/*.csv", **more):
    value = {
        "name": name,
        "tanks": [{"template": "template.json", "table": "farm.csv", "id": "tag", "columns": json.loads((EXAMPLE / "study.json").read_text())["tanks"][0]["columns"]}],
        "records": [{"files": records}],
        "scales": {"im": "PGA", "levels": [f"{s} g" for s in scales]},
        **more,
    }
    (home / f"{name}.json").write_text(json.dumps(value, indent=1))


CLUSTER = """
import os, sys, time
from hyperqueue import Job, LocalCluster
from hyperqueue.cluster import WorkerConfig
program, folder = sys.argv[1:]
with LocalCluster() as cluster:
    cluster.start_worker(WorkerConfig(cores=2))
    client = cluster.client()
    start = time.monotonic()
    job = Job()
    for k in range(1, 101):
        job.program([program, "study", "run", folder, "--task", str(k), "--quiet"], cwd=os.getcwd())
    client.wait_for_jobs([client.submit(job)])
    print(time.monotonic() - start)
"""


def hyperqueue(python, program, home):
    """Wall times of 100 tasks on local threads and by HyperQueue [s]."""
    (home / "cluster.py").write_text(CLUSTER)
    study(home, "tasks", [0.4], block=10)
    times = {"local": [], "hq": []}
    for k in range(3):
        for how in times:
            folder = f"{how}{k}"
            subprocess.run([program, "study", "plan", "tasks.json", "--out", folder, "-q"], cwd=home, check=True, capture_output=True)
            if how == "local":
                start = time.monotonic()
                subprocess.run([program, "study", "run", folder, "--jobs", "2", "-q"], cwd=home, check=True, capture_output=True)
                times[how].append(time.monotonic() - start)
            else:
                command = f"ip link set lo up 2>/dev/null; exec {python} cluster.py {program} {folder}"
                done = subprocess.run(["unshare", "--net", "--map-root-user", "sh", "-c", command], cwd=home, check=True, capture_output=True, text=True)
                times[how].append(float(done.stdout.split()[-1]))
            subprocess.run([program, "study", "merge", folder, "-q"], cwd=home, check=True, capture_output=True)
    hashes = {(home / f"{how}{k}/rows.sha256").read_text().split()[0] for how in times for k in range(3)}
    print(f"100 tasks, local threads {times['local']} s, HyperQueue {times['hq']} s; rows {'the same' if len(hashes) == 1 else 'DIFFER'}")
    print(f"HyperQueue over local threads: {sorted(times['hq'])[1] / sorted(times['local'])[1]:.3f}")


def single_tanks(home):
    """The tanks of the list as files of their own."""
    template = (EXAMPLE / "template.json").read_text().replace('"scale_to": "0.3 g"', '"scale_to": "0.4 g"')
    files = []
    for row in csv.DictReader((EXAMPLE / "farm.csv").open()):
        text = template.replace('"radius": "7.5 m"', f'"radius": "{row["radius"]}"')
        text = text.replace('"fill_height": "6.5 m"', f'"fill_height": "{row["fill"]}"')
        courses = iter([row["course_1"], row["course_2"]])
        text = re.sub(r'("height": "2.5 m", "thickness": ")[^"]*', lambda m: m[1] + (next(courses, None) or "5 mm"), text)
        files.append(home / f"{row['tag']}.json")
        files[-1].write_text(text)
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--singles", type=int, default=0)
    parser.add_argument("--codes", action="store_true")
    parser.add_argument("--merge", action="store_true")
    parser.add_argument("--hq", metavar="PYTHON", type=Path)
    parser.add_argument("--records", type=int, default=50)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        run = Runs(args.program.resolve(), home)
        for name in ["template.json", "farm.csv"]:
            (home / name).write_bytes((EXAMPLE / name).read_bytes())
        run("synthetic records", "quake", "synth", "--target", "template.json", "--n", args.records, "--seed", 1, "--duration", 31, "--strong", 15, "--out", "records/")
        study(home, "one", [0.4])
        study(home, "ten", [0.1 * k for k in range(1, 11)])
        for name in ["one", "ten"]:
            run(f"plan, {name}", "study", "plan", f"{name}.json", "--out", name)
            run(f"run, {name}", "study", "run", name, "-q")
        rows = 20 * args.records
        print(f"ten scales over one: {run.cpu['run, ten'] / run.cpu['run, one']:.3f}; {1e3 * run.cpu['run, one'] / rows:.1f} CPU ms a row of one")
        run("run, ten, finished", "study", "run", "ten", "-q")
        run("merge, ten", "study", "merge", "ten", "-q")
        print((home / "ten/rows.sha256").read_text().split()[0])
        if args.singles:
            tanks, records = single_tanks(home), sorted((home / "records").glob("*.csv"))
            for k in range(args.singles):
                run("singles", "compare", tanks[k % len(tanks)], "--quake", records[k % len(records)], "-q", "--no-mesh-error", "--no-report", "--out", f"single{k}", count=0)
            each = run.cpu["singles"] / args.singles
            print(f"single compare: {each:.4f} CPU s; {rows * each / run.cpu['run, one']:.2f} times the study's")
        if args.hq:
            hyperqueue(args.hq.absolute(), run.program, home)
        if args.codes:
            study(home, "codes", [0.1 * k for k in range(1, 11)], engine="none")
            run("plan, codes", "study", "plan", "codes.json", "--out", "codes")
            run("run, codes", "study", "run", "codes", "-q")
        if args.merge:
            study(home, "many", [0.01 * k for k in range(1, 101)])
            run("plan, many", "study", "plan", "many.json", "--out", "many")
            run("run, many, one task", "study", "run", "many", "--task", 1, "-q")
            subprocess.run([sys.executable, EXAMPLE.parent.parent / "benches/study_rows.py", home / "many"], check=True)
            run("merge, many", "study", "merge", "many", "-q")
            print(f"largest memory of a run so far: {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()
