#!/usr/bin/env python3
"""Records of agencies against ObsPy (PyPI) and a second parse in numpy: number of samples, time step, peak.

Usage: benches/peers/records.py FOLDER [TANKCHECK]      FOLDER: files of agencies, one format each by their names:
       *.ASC (ESM), *.knet, *.smc, *.v1 (COSMOS), *.V2 (CSMIP). TANKCHECK: default target/release/tankcheck.

Makes a virtual environment in a temporary folder and installs numpy and obspy. ObsPy reads K-NET; the other formats have
no reader there, and are parsed by fixed columns in numpy, without this program's code.
"""
import glob, os, subprocess, sys, tempfile, venv

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
folder = os.path.abspath(sys.argv[1])
binary = os.path.abspath(sys.argv[2] if len(sys.argv) > 2 else os.path.join(root, "target/release/tankcheck"))
peer = r'''
import glob, json, os, re, subprocess, sys
import numpy as np
binary, folder = sys.argv[1:]
def product(path, *more):
    out = subprocess.run([binary, "quake", "info", path, "--format", "json", *more], capture_output=True, text=True)
    if out.returncode: raise SystemExit(out.stderr)
    found = json.loads(out.stdout)
    return found["samples"], found["dt"], found["pga"]
def columns(lines, width, count):
    per = len(lines[0].rstrip()) // width or 1
    lines = lines[:-(-count // per) + 1]
    fields = [line[i:i + width] for line in lines for i in range(0, len(line.rstrip("\r\n")), width) if line[i:i + width].strip()]
    return np.array([float(f) for f in fields[:count]])
def of(path):
    lines = open(path, encoding="latin-1", newline="").read().splitlines()
    name = path.lower()
    if name.endswith(".asc"):
        key = {l.split(":")[0]: l.split(":", 1)[1].strip() for l in lines[:64]}
        a = np.array([float(l) for l in lines[64:] if l.strip()])
        return "by hand", len(a), float(key["SAMPLING_INTERVAL_S"]), abs(a).max() / 100, ()
    if name.endswith(".knet"):
        import obspy
        trace = obspy.read(path)[0]
        a = trace.data * trace.stats.calib
        return "obspy " + obspy.__version__, len(a), trace.stats.delta, abs(a - a.mean()).max(), ()
    if name.endswith(".smc"):
        n = int(lines[13][0:10])
        rate = float(lines[17][15:30])
        start = 11 + 6 + 10 + int(lines[12][70:80])
        a = columns(lines[start:], 10, n)
        return "by hand", len(a), 1 / rate, abs(a).max() / 100, ()
    if name.endswith(".v1"):
        head = next(i for i, l in enumerate(lines) if "acceleration pts" in l)
        n = int(lines[head].split()[0])
        reals = next(i for i, l in enumerate(lines) if "Real-header" in l)
        header = columns(lines[reals + 1:reals + 18], 13, 100)
        # Real 62 [ms] is the step of the data, real 34 [s] that of the recorder.
        dt = header[61] / 1000 if header[61] > 0 else header[33]
        a = columns(lines[head + 1:], int(re.search(r"8F(\d+)", lines[head]).group(1)), n)
        return "by hand", len(a), dt, abs(a).max() / 100, ()
    head = next(i for i, l in enumerate(lines) if "POINTS OF ACCEL DATA" in l)
    n, dt = int(lines[head].split()[0]), float(re.search(r"AT\s+([.\d]+)", lines[head]).group(1))
    a = columns(lines[head + 1:head + 1 + -(-n // 8)], 10, n)
    return "by hand", len(a), dt, abs(a).max() / 100, ("--channel", "1")
bad = 0
for path in sorted(glob.glob(os.path.join(folder, "*"))):
    if not path.lower().endswith((".asc", ".knet", ".smc", ".v1", ".v2")): continue
    who, n, dt, pga, more = of(path)
    found = product(path, *more)
    error = abs(found[2] / pga - 1)
    good = found[0] == n and abs(found[1] / dt - 1) < 1e-9 and error < 1e-6
    bad += not good
    print(f"{os.path.basename(path)[:44]:<44} {who:<13} n {n:>6} dt {dt:<7g} PGA {pga:.6f} m/s2, off by {error:.1e} {'' if good else 'DIFFERS ' + str(found)}")
sys.exit(bad)
'''
with tempfile.TemporaryDirectory() as place:
    venv.create(place, with_pip=True)
    python = os.path.join(place, "bin", "python")
    subprocess.run([python, "-m", "pip", "install", "--quiet", "numpy", "obspy"], check=True)
    sys.exit(subprocess.run([python, "-c", peer, binary, folder]).returncode)
