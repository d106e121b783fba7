#!/usr/bin/env python3
"""Nonlinear transient of a cylinder of layered shells against OpenSees (PyPI: openseespy; needs libblas.so.3).

Usage: benches/peers/shell_transient.py [--mesh 48,8] [--layers 3] [--steps 12] [--runs 3] [--algorithm Newton] [--element ShellMITC4]

One mesh, one load, one step length, one thread, trapezoidal rule without damping; whole processes, user + system time,
alternating, medians. The peer: ShellMITC4 or ShellNLDKGQ, section LayeredShell of PlateFiber of J2Plasticity, Mumps, a relative energy of
1e-8 as criterion (ours 1e-10, which the peer does not reach once the wall yields). Both run `--steps` steps and half of them: the
difference is the time of a step, the rest set-up. On 48 x 16 shells of 10 layers the peer stops in step 8 without convergence, so that
the defaults are coarser.

The displacement of a node at the edge of the top is compared at every step, before any time is printed. Both are four-node
shells with tied shear; the peer's are flat facets with a drilling stiffness and small rotations, ours have common directors and
finite rotations, layers at stretched depths (1/(2 n²) in bending) and plane stress without a local iteration. They must agree to
2 % of the largest displacement.
"""
import argparse, json, os, resource, statistics, subprocess, sys, tempfile

parser = argparse.ArgumentParser()
parser.add_argument("--mesh", default="48,8")
parser.add_argument("--layers", type=int, default=3)
parser.add_argument("--steps", type=int, default=12)
parser.add_argument("--runs", type=int, default=3)
parser.add_argument("--algorithm", default="Newton", help="of OpenSees: Newton, ModifiedNewton, KrylovNewton")
parser.add_argument("--element", default="ShellMITC4", choices=["ShellMITC4", "ShellNLDKGQ"], help="of OpenSees")
parser.add_argument("--binary", help="our example, if it is built already")
options = parser.parse_args()

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
one = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", MKL_NUM_THREADS="1", RAYON_NUM_THREADS="1")
DT, FREQUENCY, TOLERANCE = 1e-3, 10.0, 0.02

OPENSEES = r'''
import json, sys
import openseespy.opensees as ops
path, steps, dt, frequency = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])
algorithm, shell = sys.argv[5:7]
ops.model("basic", "-ndm", 3, "-ndf", 6)
young, nu, yields = 210e9, 0.3, 240e6
ops.nDMaterial("J2Plasticity", 1, young / (3 - 6 * nu), young / (2 + 2 * nu), yields, yields, 0.0, 0.0)
ops.nDMaterial("PlateFiber", 2, 1)
lines = [line.split() for line in open(path)]
for kind, *v in lines:
    if kind == "layers":
        ops.section("LayeredShell", 1, int(v[0]), *([2, float(v[1])] * int(v[0])))
ops.timeSeries("Trig", 1, 0.0, 1e9, 1.0 / frequency)
ops.pattern("Plain", 1, 1)
count = 0
for kind, *v in lines:
    if kind == "node":
        ops.node(int(v[0]), *map(float, v[1:4]))
        if v[4] == "1":
            ops.fix(int(v[0]), 1, 1, 1, 1, 1, 1)
        m = float(v[5])
        ops.mass(int(v[0]), m, m, m, 0.0, 0.0, 0.0)
    elif kind == "shell":
        count += 1
        ops.element(shell, count, *map(int, v), 1)
    elif kind == "load":
        ops.load(int(v[0]), float(v[1]), 0.0, 0.0, 0.0, 0.0, 0.0)
    elif kind == "observe":
        tip = int(v[0])
ops.constraints("Plain")
ops.numberer("RCM")
ops.system("Mumps")
ops.test("RelativeEnergyIncr", 1e-8, 50)
ops.algorithm(algorithm)
ops.integrator("Newmark", 0.5, 0.25)
ops.analysis("Transient")
found, iterations = [], 0
for step in range(steps):
    if ops.analyze(1, dt) != 0:
        sys.exit("OpenSees failed in step %d" % step)
    iterations += ops.testIter()
    found.append(ops.nodeDisp(tip, 1))
print(json.dumps({"tip": found, "iterations": iterations}))
'''


def cpu(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(command, capture_output=True, text=True, env=one)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if out.returncode != 0:
        sys.exit(f"{command[0]} failed: {out.stderr[-2000:]}{out.stdout[-2000:]}")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    found = next(line for line in out.stdout.splitlines() if line.startswith("{"))
    return seconds, json.loads(found)


target = os.environ.get("CARGO_TARGET_DIR", os.path.join(root, "target"))
binary = options.binary or os.path.join(target, "release", "examples", "shell_transient")
if not options.binary:
    subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "fem", "--example", "shell_transient"],
                   cwd=root, check=True)
ours = [binary, "--mesh", options.mesh, "--layers", str(options.layers)]

with tempfile.TemporaryDirectory() as folder:
    model = os.path.join(folder, "model.txt")
    subprocess.run(ours + ["--model", model], check=True)
    mine = lambda steps: ours + ["--steps", str(steps)]
    peer = lambda steps: [sys.executable, "-c", OPENSEES, model, str(steps), str(DT), str(FREQUENCY),
                          options.algorithm, options.element]
    whole, half = options.steps, options.steps // 2
    times = {}
    for _ in range(options.runs):
        for name, command in (("ours", mine), ("OpenSees", peer)):
            for steps in (whole, half):
                seconds, found = cpu(command(steps))
                times.setdefault((name, steps), []).append(seconds)
                if steps == whole:
                    times[name] = found
    own, other = times["ours"], times["OpenSees"]
    largest = max(map(abs, other["tip"]))
    worst = max(abs(a - b) for a, b in zip(own["tip"], other["tip"])) / largest
    for k in range(whole // 5 - 1, whole, whole // 5):
        print(f"step {k + 1}: {own['tip'][k]:.6e} m, OpenSees {other['tip'][k]:.6e} m")
    print(f"largest difference {100 * worst:.2f} % of the largest displacement; energy error {own['energy_error']:.0e}, "
          f"dissipated {own['hysteretic']:.3e} J")
    if worst > TOLERANCE:
        sys.exit("the answers differ: no times")
    shells, step = own["shells"], {}
    for name, found in (("ours", own), ("OpenSees", other)):
        full, part = (statistics.median(times[name, steps]) for steps in (whole, half))
        step[name] = (full - part) / (whole - half)
        print(f"{name}: {full:.2f} s for {whole} steps, {found['iterations'] / whole:.1f} iterations a step, "
              f"{1e3 * step[name]:.1f} ms a step, {1e6 * step[name] / shells:.1f} us a step and shell")
    print(f"{shells} shells of {options.layers} layers, {own['unknowns']} unknowns: a step {step['OpenSees'] / step['ours']:.1f} "
          f"times as fast as with {options.element} of OpenSees ({options.algorithm})")
