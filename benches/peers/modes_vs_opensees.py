#!/usr/bin/env python3
"""Time the 20 lowest modes of 3 840 bricks (11 580 unknowns) against OpenSees (PyPI: openseespy) in the same run.

Usage: benches/peers/modes_vs_opensees.py

Whole processes, user time, one thread, median of three, alternating: ours with mesh, assembly, inertia count and checks; the peer with
`eigen 20` on the same mesh, stdBrick and the same nodal masses. The frequencies must agree to 1e-6.
"""
import json, os, resource, statistics, subprocess, sys, tempfile

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
one = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", MKL_NUM_THREADS="1")
peer = r'''
import json, sys
import openseespy.opensees as ops
ops.model("basic", "-ndm", 3, "-ndf", 3)
ops.nDMaterial("ElasticIsotropic", 1, 30e9, 0.2, 0.0)
count = 0
for line in open(sys.argv[1]):
    kind, *values = line.split()
    if kind == "node":
        n, m = int(values[0]), float(values[4])
        ops.node(n, *map(float, values[1:4]))
        if m > 0.0:
            ops.mass(n, m, m, m)
        else:
            ops.fix(n, 1, 1, 1)
    else:
        count += 1
        ops.element("stdBrick", count, *map(int, values), 1)
print(json.dumps([v ** 0.5 for v in ops.eigen(20)]))
'''
subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "fem", "--example", "solver_peers"], cwd=root, check=True)
target = os.environ.get("CARGO_TARGET_DIR", os.path.join(root, "target"))
ours = os.path.join(target, "release", "examples", "solver_peers")


def timed(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    out = subprocess.run(command, check=True, capture_output=True, text=True, env=one).stdout
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, json.loads(out.strip().splitlines()[-1])


with tempfile.TemporaryDirectory() as folder:
    model = os.path.join(folder, "model.txt")
    times = [[], []]
    print("load", os.getloadavg()[0])
    for _ in range(3):
        t, a = timed([ours, "modes", model])
        times[0].append(t)
        t, b = timed([sys.executable, "-c", peer, model])
        times[1].append(t)
    worst = max(abs(x / y - 1) for x, y in zip(a["omega"], b))
    mine, other = map(statistics.median, times)
    print(f"20 modes, {a['unknowns']} unknowns: {mine:.2f} s, OpenSees {other:.2f} s, ratio {other / mine:.1f}; "
          f"largest difference of a frequency {worst:.1e}; lowest {a['omega'][0]:.6f} rad/s; "
          f"{a['products']} products, residual {a['residual']:.0e}")
    sys.exit(worst > 1e-6 or len(b) != 20)
