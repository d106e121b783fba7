#!/usr/bin/env python3
"""Time a 200-period spectrum against eqsig (PyPI) in the same run.

Usage: benches/peers/spectrum_vs_eqsig.py [RECORD.csv]      (default: examples/records/elcentro.csv)

Builds tankcheck in release, and prints the median time of both, alternating; `benches/peers/run --peers` installs eqsig. tankcheck is timed as the difference of two whole commands (41 and 1 damping ratios), so that
start, reading and printing do not count; eqsig is timed inside Python. The values are compared where eqsig's sampling
at the record's points can be compared with the maxima of the continuous response: T >= 200 dt, where sampling misses
at most (2 pi/200)^2/8 = 0.012 %.
"""
import json, os, statistics, subprocess, sys

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
record = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(root, "examples/records/elcentro.csv"))
peer = r'''
import sys, time, json, numpy as np
from eqsig import sdof
data = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
unit = 9.80665 if open(sys.argv[1]).readline().strip().endswith("_g") else 1.0
dt, a = round(data[1, 0] - data[0, 0], 6), unit * data[:, 1]
periods = 0.02 * 1000 ** (np.arange(200) / 199)
start = time.perf_counter()
sd, sv, sa = sdof.pseudo_response_spectra(a, dt, periods, 0.02)
print(json.dumps({"seconds": time.perf_counter() - start, "dt": dt, "n": len(a), "sd": list(map(float, sd))}))
'''
subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=root, check=True)
binary = os.path.join(os.environ.get("CARGO_TARGET_DIR", os.path.join(root, "target")), "release", "tankcheck")


def product(count):
    import time
    damping = ",".join(str(0.02 + 1e-6 * i) for i in range(count))
    start = time.perf_counter()
    out = subprocess.run([binary, "--quiet", "spectrum", record, "--damping", damping, "--format", "csv"],
                         check=True, capture_output=True, text=True).stdout
    return time.perf_counter() - start, out


ours, theirs = [], []
for _ in range(9):
    many, _ = product(41)
    one, text = product(1)
    ours.append((many - one) / 40)
    run = subprocess.run([sys.executable, "-c", peer, record], check=True, capture_output=True, text=True)
    result = json.loads(run.stdout)
    theirs.append(result["seconds"])
rows = [list(map(float, line.split(","))) for line in text.splitlines()[1:]]
compared = [(row[1], row[2], sd) for row, sd in zip(rows, result["sd"]) if row[1] >= 200 * result["dt"]]
worst = max(abs(sd / mine - 1) for _, mine, sd in compared)
a, b = statistics.median(ours), statistics.median(theirs)
print(f"{result['n']} points, 200 periods, one damping ratio, medians of 9 (tankcheck's time includes printing):")
print(f"  tankcheck {1e3 * a:8.3f} ms   eqsig {1e3 * b:8.1f} ms   ratio {b / a:.0f}")
print(f"  largest difference of sd over {len(compared)} periods from {200 * result['dt']} s on: {worst:.1e}")
sys.exit(0 if worst < 2e-4 else 1)
