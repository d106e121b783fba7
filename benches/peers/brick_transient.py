#!/usr/bin/env python3
"""Linear transient of a cylinder of bricks against OpenSees (PyPI: openseespy) and CalculiX (Debian: calculix-ccx).

Usage: benches/peers/brick_transient.py [--mesh 12,16,20] [--steps 200] [--ccx-steps 15] [--full 2000] [--runs 3]

One mesh, one load, one step length, one thread, trapezoidal rule without damping; whole processes, user + system time,
alternating, medians. The peers:
  OpenSees   stdBrick, Mumps, `Linear -factorOnce`. Runs `--steps` steps and half of them: the difference is the time a step,
             the rest set-up; from both the time of `--full` steps is extrapolated and said so.
  CalculiX   C3D8, C3D6 at the axis, *DYNAMIC,DIRECT,ALPHA=0 (refactorises), `--ccx-steps` steps.
The displacement of a node at the edge of the top is compared every five steps: the three programs use the same trilinear
brick with consistent mass and must agree to 1e-4 of the largest displacement.
"""
import argparse, json, os, resource, statistics, subprocess, sys, tempfile

parser = argparse.ArgumentParser()
parser.add_argument("--mesh", default="12,16,20")
parser.add_argument("--steps", type=int, default=200)
parser.add_argument("--ccx-steps", type=int, default=15)
parser.add_argument("--full", type=int, default=2000)
parser.add_argument("--runs", type=int, default=3)
parser.add_argument("--without-calculix", action="store_true")
parser.add_argument("--binary", help="our example, if it is built already")
options = parser.parse_args()

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
one = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", MKL_NUM_THREADS="1", RAYON_NUM_THREADS="1")
DT, FREQUENCY = 1e-3, 10.0

OPENSEES = r'''
import json, math, sys
import openseespy.opensees as ops
path, steps, dt, frequency = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])
ops.model("basic", "-ndm", 3, "-ndf", 3)
ops.nDMaterial("ElasticIsotropic", 1, 30e9, 0.2, 2500.0)
ops.timeSeries("Trig", 1, 0.0, 1e9, 1.0 / frequency)
ops.pattern("Plain", 1, 1)
count = 0
for line in open(path):
    kind, *v = line.split()
    if kind == "node":
        ops.node(int(v[0]), *map(float, v[1:4]))
        if v[4] == "1":
            ops.fix(int(v[0]), 1, 1, 1)
    elif kind == "brick":
        count += 1
        ops.element("stdBrick", count, *map(int, v), 1)
    elif kind == "load":
        ops.load(int(v[0]), float(v[1]), 0.0, 0.0)
    else:
        tip = int(v[0])
ops.constraints("Plain")
ops.numberer("RCM")
ops.system("Mumps")
ops.algorithm("Linear", False, False, "-factorOnce")
ops.integrator("Newmark", 0.5, 0.25)
ops.analysis("Transient")
found = []
for step in range(1, steps + 1):
    if ops.analyze(1, dt) != 0:
        sys.exit("OpenSees failed in step %d" % step)
    if step % 5 == 0:
        found.append(ops.nodeDisp(tip, 1))
print(json.dumps(found))
'''


def cpu(command, **arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(command, capture_output=True, text=True, env=one, **arguments)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if out.returncode != 0:
        sys.exit(f"{command[0]} failed: {out.stderr[-2000:]}{out.stdout[-2000:]}")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, out.stdout


def calculix_input(model, steps):
    """The same model as an input deck; a brick whose first four or inner nodes coincide is a wedge."""
    from math import pi, sin
    nodes, wedges, bricks, loads, fixed, tip = [], [], [], [], [], 0
    for line in open(model):
        kind, *v = line.split()
        if kind == "node":
            # Fields of more than 20 characters are misread.
            nodes.append(f"{v[0]}, " + ", ".join(f"{float(x):.10e}" for x in v[1:4]))
            if v[4] == "1":
                fixed.append(v[0])
        elif kind == "brick":
            # Local r runs outwards: nodes 1 and 4, 5 and 8 coincide at the axis.
            if v[0] == v[3]:
                wedges.append([v[0], v[1], v[2], v[4], v[5], v[6]])
            else:
                bricks.append(v)
        elif kind == "load":
            loads.append(v)
        else:
            tip = v[0]
    number = iter(range(1, 10**9))
    text = ["*NODE, NSET=ALL"] + nodes
    text += ["*ELEMENT, TYPE=C3D8, ELSET=E"] + [f"{next(number)}, " + ", ".join(b) for b in bricks]
    text += ["*ELEMENT, TYPE=C3D6, ELSET=E"] + [f"{next(number)}, " + ", ".join(w) for w in wedges]
    text += ["*NSET, NSET=TIP", tip, "*NSET, NSET=BASE"] + [f"{n}," for n in fixed]
    text += ["*MATERIAL, NAME=M", "*ELASTIC", "30e9, 0.2", "*DENSITY", "2500.", "*SOLID SECTION, ELSET=E, MATERIAL=M"]
    text += ["*BOUNDARY", "BASE, 1, 3", "*AMPLITUDE, NAME=A"]
    text += [f"{i * DT:.9e}, {sin(2 * pi * FREQUENCY * i * DT):.10e}" for i in range(steps + 1)]
    text += ["*STEP, INC=100000", "*DYNAMIC, DIRECT, ALPHA=0.", f"{DT}, {steps * DT}", "*CLOAD, AMPLITUDE=A"]
    text += [f"{n}, 1, {float(f):.10e}" for n, f in loads]
    text += ["*NODE PRINT, NSET=TIP, FREQUENCY=5", "U", "*END STEP", ""]
    return "\n".join(text)


def compare(name, mine, theirs):
    largest = max(abs(u) for u in mine)
    worst = max(abs(a - b) for a, b in zip(mine, theirs)) / largest
    for k in range(0, min(len(mine), len(theirs)), max(1, len(theirs) // 4)):
        print(f"  step {5 * k + 5}: {mine[k]:.6e} m, {name} {theirs[k]:.6e} m")
    print(f"  largest difference {worst:.1e} of the largest displacement")
    return worst


target = os.environ.get("CARGO_TARGET_DIR", os.path.join(root, "target"))
binary = options.binary or os.path.join(target, "release", "examples", "brick_transient")
if not options.binary:
    subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "fem", "--example", "brick_transient"],
                   cwd=root, check=True)
ours = [binary, "--mesh", options.mesh]

with tempfile.TemporaryDirectory() as folder:
    model = os.path.join(folder, "model.txt")
    subprocess.run(ours + ["--model", model], check=True)
    peer = lambda steps: [sys.executable, "-c", OPENSEES, model, str(steps), str(DT), str(FREQUENCY)]
    times = {key: [] for key in ("full", "same", "eight", "opensees", "half", "ccx-same", "ccx")}
    print("load", os.getloadavg()[0])
    for _ in range(options.runs):
        seconds, out = cpu(ours + ["--steps", str(options.full)])
        times["full"].append(seconds)
        seconds, out = cpu(ours + ["--steps", str(options.steps)])
        times["same"].append(seconds)
        mine = json.loads(out)
        seconds, out = cpu(ours + ["--steps", str(options.full), "--records", "8"])
        times["eight"].append(seconds)
        eight = json.loads(out)
        seconds, out = cpu(peer(options.steps))
        times["opensees"].append(seconds)
        opensees = json.loads(out.strip().splitlines()[-1])
        times["half"].append(cpu(peer(options.steps // 2))[0])
        if not options.without_calculix:
            seconds, out = cpu(ours + ["--steps", str(options.ccx_steps)])
            times["ccx-same"].append(seconds)
            short = json.loads(out)
            with open(os.path.join(folder, "job.inp"), "w") as deck:
                deck.write(calculix_input(model, options.ccx_steps))
            times["ccx"].append(cpu(["ccx", "job"], cwd=folder)[0])
            calculix = [float(line.split()[1]) for line in open(os.path.join(folder, "job.dat"))
                        if len(line.split()) == 4 and line.split()[0].isdigit()]
    t = {key: statistics.median(values) for key, values in times.items() if values}
    print(f"{mine['unknowns']} unknowns, energy error {mine['energy_error']:.0e}, residual {mine['residual']:.0e}")
    print(f"{options.steps} steps: {t['same']:.2f} s, OpenSees {t['opensees']:.2f} s, ratio {t['opensees'] / t['same']:.1f}")
    step = (t["opensees"] - t["half"]) / (options.steps - options.steps // 2)
    own_step = (t["full"] - t["same"]) / (options.full - options.steps)
    peer_full = t["opensees"] + step * (options.full - options.steps)
    print(f"a step: {1e3 * own_step:.2f} ms, OpenSees {1e3 * step:.1f} ms, ratio {step / own_step:.1f}")
    print(f"set-up: {t['same'] - own_step * options.steps:.2f} s, OpenSees {t['opensees'] - step * options.steps:.2f} s")
    print(f"{options.full} steps: {t['full']:.2f} s, OpenSees {peer_full:.1f} s (extrapolated from {options.steps}), "
          f"ratio {peer_full / t['full']:.1f}")
    print(f"eight records, {options.full} steps: {t['eight']:.2f} s, {t['eight'] / t['full']:.2f} times one")
    worst = [compare("OpenSees", mine["tip"], opensees)]
    if not options.without_calculix:
        print(f"{options.ccx_steps} steps: {t['ccx-same']:.2f} s, CalculiX {t['ccx']:.2f} s, "
              f"ratio {t['ccx'] / t['ccx-same']:.1f}")
        worst.append(compare("CalculiX", short["tip"], calculix))
    same = max(abs(a - b) for a, b in zip(eight["tip"], mine["tip"])) / max(map(abs, mine["tip"]))
    print(f"first of eight records against one alone: {same:.1e}")
    sys.exit(max(worst) > 1e-4 or same > 1e-8)
