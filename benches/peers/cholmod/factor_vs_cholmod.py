#!/usr/bin/env python3
"""Time factor and solve against CHOLMOD with METIS (Debian: libsuitesparse-dev, libopenblas0) on the same matrices.

Usage: benches/peers/cholmod/factor_vs_cholmod.py [NAME...]      (default: all patterns, 4 000 to 104 000 unknowns)

CHOLMOD needs an optimised BLAS with the kernels of the processor: an OpenBLAS that does not recognise it falls back to some
without wide registers (choose with OPENBLAS_CORETYPE), and the comparison means nothing; it stops. One thread each, processor time, medians; both programs run one after the other for every matrix. The sums of the solutions
must agree to 1e-6: a fast wrong run does not count.
"""
import ctypes, json, os, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(os.path.dirname(here)))
one = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "fem", "--example", "solver_peers"], cwd=root, check=True)
target = os.environ.get("CARGO_TARGET_DIR", os.path.join(root, "target"))
ours_program = os.path.join(target, "release", "examples", "solver_peers")

blas = ctypes.CDLL("libopenblas.so.0")
blas.openblas_get_corename.restype = ctypes.c_char_p
kernels = blas.openblas_get_corename().decode()
print("OpenBLAS kernels:", kernels)
if kernels not in ("Haswell", "Zen", "SkylakeX", "Cooperlake", "Sapphirerapids"):
    sys.exit("these kernels are older than AVX2: set OPENBLAS_CORETYPE to those of the processor")

with tempfile.TemporaryDirectory() as folder:
    peer = os.path.join(folder, "cholmod_times")
    subprocess.run(["cc", "-O2", os.path.join(here, "cholmod_times.c"), "-I/usr/include/suitesparse", "-lcholmod", "-lm",
                    "-o", peer], check=True)
    print("load", os.getloadavg()[0])
    print(f"{'matrix':18}{'unknowns':>9}{'factor':>9}{'CHOLMOD':>9}{'ratio':>7}{'solve':>9}{'CHOLMOD':>9}{'ratio':>7}"
          f"{'8 solves':>10}{'CHOLMOD':>9}{'L/METIS':>9}{'order':>8}{'CHOLMOD':>9}")
    ours = subprocess.Popen([ours_program, "factor", folder, *sys.argv[1:]], stdout=subprocess.PIPE, text=True, env=one)
    failed = False
    for line in ours.stdout:
        a = json.loads(line)
        file = os.path.join(folder, a["name"] + ".raw")
        b = json.loads(subprocess.run([peer, file], check=True, capture_output=True, text=True, env=one).stdout)
        os.remove(file)
        agrees = abs(a["sum"] / b["sum"] - 1) < 1e-6
        failed |= not agrees
        print(f"{a['name']:18}{a['n']:9}{a['factor']:9.4f}{b['factor']:9.4f}{b['factor'] / a['factor']:7.2f}"
              f"{1e3 * a['solve']:9.2f}{1e3 * b['solve']:9.2f}{b['solve'] / a['solve']:7.2f}"
              f"{1e3 * a['solve8']:10.2f}{1e3 * b['solve8']:9.2f}{a['entries'] / b['entries']:9.2f}"
              f"{a['order'] + a['symbolic']:8.2f}{b['analysis']:9.2f}"
              + ("" if agrees else "   DIFFERENT ANSWER"), flush=True)
        print(f"{'':18}{a['gflop']:.2f} Gflop, METIS {b['gflop']:.2f}, faer's AMD {a['gflop_degree']:.2f}; "
              f"{8e-6 * a['entries']:.0f} MB; residual {a['residual']:.0e}", flush=True)
    sys.exit(ours.wait() or failed)
