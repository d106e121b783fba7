"""Time step of a potential liquid in a shell wall against OpenSees' acoustic elements.

    python3 benches/peers/acoustic_vs_opensees.py [RINGS SECTORS LEVELS]        (default 12 16 20)

Needs openseespy (PyPI). Model: steel cylinder R = H = 10 m, t = 20 mm, clamped, full of water; radial forces
cos(theta) kN at all nodes above the base, growing with t / 0.1 s; steps of 2 ms, trapezoidal rule, matrices factored once. OpenSees: AC3D8 + ShellMITC4 + ASI3D8,
Mumps (SuperLU if this build has none).

What is compared is processor time per step: both programs run twice with different numbers of steps, one after the other,
and the difference is divided by the difference of the steps, so that set-up drops out.

Answers. ASI3D8 with six-dof shell nodes only warns and leaves the wall uncoupled (its displacement is that of the dry shell),
so that the coupled answer cannot be compared. Checked instead:
* the dry wall: radial displacement of its top at theta = 0 over twenty steps, both programs. ShellMITC4 takes the membrane
  shear point by point and locks in thin cylinders; ours is compared with the same element, and printed without locking;
* that OpenSees' "coupled" displacement is indeed the dry one;
* the coupled answer of ours against closed forms and the harmonic engine: rows F9 of the verification.
"""

import json
import math
import os
import pathlib
import resource
import subprocess
import sys

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS"):
    os.environ[name] = "1"

RADIUS, HEIGHT, THICKNESS, STEP, FORCE, RAMP = 10.0, 10.0, 0.02, 2e-3, 1e3, 0.1
ROOT = pathlib.Path(__file__).parents[2]
OURS = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release/examples/potential_transient"


def opensees(rings, sectors, levels, steps, wet):
    """Radial displacement of the wall's top at theta = 0 at every step."""
    import openseespy.opensees as ops

    ops.wipe()
    per_level = 1 + rings * sectors

    def liquid(level, ring, sector):
        return 1 + level * per_level + (0 if ring == 0 else 1 + (ring - 1) * sectors + sector % sectors)

    first = (levels + 1) * per_level + 1

    def wall(level, sector):
        return first + level * sectors + sector % sectors

    def place(level, ring, sector):
        r, t = RADIUS * ring / rings, 2 * math.pi * sector / sectors
        return r * math.cos(t), r * math.sin(t), HEIGHT * level / levels

    if wet:
        ops.model("basic", "-ndm", 3, "-ndf", 1)
        for level in range(levels + 1):
            ops.node(liquid(level, 0, 0), *place(level, 0, 0))
            for ring in range(1, rings + 1):
                for sector in range(sectors):
                    ops.node(liquid(level, ring, sector), *place(level, ring, sector))
        for node in range(levels * per_level + 1, (levels + 1) * per_level + 1):
            ops.fix(node, 1)
        ops.nDMaterial("AcousticMedium", 1, 2.2e9, 1000.0)
        tag = 0
        for level in range(levels):
            for ring in range(rings):
                for sector in range(sectors):
                    tag += 1
                    n = [
                        liquid(z, r, s)
                        for z in (level, level + 1)
                        for r, s in ((ring, sector), (ring + 1, sector), (ring + 1, sector + 1), (ring, sector + 1))
                    ]
                    ops.element("AC3D8", tag, *n, 1)
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    for level in range(levels + 1):
        for sector in range(sectors):
            ops.node(wall(level, sector), *place(level, rings, sector))
    for sector in range(sectors):
        ops.fix(wall(0, sector), 1, 1, 1, 1, 1, 1)
    ops.section("ElasticMembranePlateSection", 2, 210e9, 0.3, THICKNESS, 7850.0)
    tag = 10_000_000
    for level in range(levels):
        for sector in range(sectors):
            tag += 1
            corners = [wall(level, sector), wall(level, sector + 1), wall(level + 1, sector + 1), wall(level + 1, sector)]
            ops.element("ShellMITC4", tag, *corners, 2)
    if wet:
        for level in range(levels):
            for sector in range(sectors):
                tag += 1
                at = ((level, sector), (level, sector + 1), (level + 1, sector + 1), (level + 1, sector))
                ops.element("ASI3D8", tag, *(wall(*p) for p in at), *(liquid(z, rings, s) for z, s in at))
    ops.timeSeries("Linear", 1, "-factor", 1.0 / RAMP)
    ops.pattern("Plain", 1, 1)
    for level in range(1, levels + 1):
        for sector in range(sectors):
            t = 2 * math.pi * sector / sectors
            force = FORCE * math.cos(t)
            ops.load(wall(level, sector), force * math.cos(t), force * math.sin(t), 0.0, 0.0, 0.0, 0.0)
    ops.constraints("Plain")
    ops.numberer("RCM")
    try:
        ops.system("Mumps")
    except Exception:
        ops.system("SuperLU")
    ops.algorithm("Linear", "-factorOnce")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    out = []
    for _ in range(steps):
        if ops.analyze(1, STEP) != 0:
            raise RuntimeError("OpenSees: no answer")
        out.append(ops.nodeDisp(wall(levels, 0), 1))
    return out


def cpu_of(command):
    """(processor seconds of a child, its output)"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, json.loads(done.stdout.splitlines()[-1] if
        done.stdout.lstrip().startswith("[") else done.stdout)


def per_step(command, few, many):
    """(processor seconds a step, answer of the longer run), the difference of two runs"""
    short, _ = cpu_of(command(few))
    long, answer = cpu_of(command(many))
    return (long - short) / (many - few), answer


def main():
    subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "fem", "--example", "potential_transient"], cwd=ROOT, check=True)
    if sys.argv[1:2] == ["--opensees"]:
        counts = [int(a) for a in sys.argv[2:6]]
        print(json.dumps(opensees(*counts, wet=sys.argv[6] == "wet")[:20]))
        return
    counts = sys.argv[1:4] or ["12", "16", "20"]

    def peer(kind):
        return lambda steps: [sys.executable, __file__, "--opensees", *counts, str(steps), kind]

    def own(steps):
        return [str(OURS), *counts, str(steps)]

    ratios = []
    for _ in range(3):
        ours, answer = per_step(own, 100, 1100)
        theirs, coupled = per_step(peer("wet"), 20, 120)
        ratios.append((theirs / ours, ours, theirs))
    ratio, ours, theirs = sorted(ratios)[1]
    _, dry = per_step(peer("dry"), 20, 25)
    print(f"unknowns of ours {answer['unknowns']}; processor time a step, median of 3 alternating runs")
    print(f"ours {1e3 * ours:.3f} ms   OpenSees {1e3 * theirs:.2f} ms   ratio {ratio:.1f}")
    print(f"dry wall, steps 1, 5, 10, 20 [m]: ours {[answer['dry'][i] for i in (0, 4, 9, 19)]}")
    print(f"                  ours as plain MITC4 {[answer['dry_plain_mitc4'][i] for i in (0, 4, 9, 19)]}")
    print(f"                             OpenSees {[dry[i] for i in (0, 4, 9, 19)]}")
    print(f"OpenSees with liquid and ASI3D8       {[coupled[i] for i in (0, 4, 9, 19)]}   (the dry wall's if uncoupled)")
    print(f"ours with liquid                      {[answer['wet'][i] for i in (0, 4, 9, 19)]}")
    apart = max(abs(a - b) for a, b in zip(answer["dry_plain_mitc4"], dry)) / max(abs(b) for b in dry)
    print(f"largest difference of the dry MITC4 walls over the peak: {100 * apart:.2f} %")
    # Lumped mass there, consistent mass here; both walls are MITC4 shells.
    if apart > 0.03:
        sys.exit("the dry walls differ")


if __name__ == "__main__":
    main()
