#!/usr/bin/env python3
"""Fragility fits against statsmodels (PyPI) on random data.

Usage: benches/peers/fragility.py [TANKCHECK]      (default: target/release/tankcheck, built if it is missing)

Makes a virtual environment in a temporary folder, installs statsmodels, draws 20 sets of binomial counts and 20 clouds with a
fixed seed, and compares median and dispersion: probit regression on ln im for the counts, least squares for the clouds.
"""
import json, os, subprocess, sys, tempfile, venv

root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
binary = sys.argv[1] if len(sys.argv) > 1 else os.path.join(root, "target/release/tankcheck")
if not os.path.exists(binary):
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=root, check=True)
peer = r'''
import json, os, subprocess, sys
import numpy as np, statsmodels.api as sm, statsmodels
from scipy.stats import norm
binary, folder = sys.argv[1:]
rng = np.random.default_rng(2015)
def ours(option, text, more=()):
    path = os.path.join(folder, "data.csv")
    open(path, "w").write(text)
    out = subprocess.run([binary, "fragility", option, path, "--bootstrap", "0", "--format", "json", *more],
                         capture_output=True, text=True)
    return json.loads(out.stdout)["curves"][0]
worst = [0.0, 0.0]
for _ in range(20):
    theta, beta = rng.uniform(0.2, 2), rng.uniform(0.2, 0.8)
    im = theta * np.exp(beta * np.linspace(-1.8, 1.8, 9))
    n = rng.integers(10, 60, 9)
    z = rng.binomial(n, norm.cdf(np.log(im / theta) / beta))
    fit = sm.GLM(np.column_stack([z, n - z]), sm.add_constant(np.log(im)),
                 family=sm.families.Binomial(sm.families.links.Probit())).fit(tol=1e-14, maxiter=200)
    a, b = fit.params
    found = ours("--stripes", "im,n,exceed\n" + "".join(f"{x!r},{int(k)},{int(e)}\n" for x, k, e in zip(im.tolist(), n, z)))
    if found["status"] == "fitted":
        worst[0] = max(worst[0], abs(found["median"] / np.exp(-a / b) - 1), abs(found["dispersion"] * b - 1))
for _ in range(20):
    im = np.exp(rng.normal(0, 0.6, 40))
    edp = np.exp(0.2 + 1.1 * np.log(im) + rng.normal(0, 0.3, 40))
    fit = sm.OLS(np.log(edp), sm.add_constant(np.log(im))).fit()
    a, b = fit.params
    sigma = fit.mse_resid ** 0.5
    found = ours("--cloud", "im,edp\n" + "".join(f"{x!r},{y!r}\n" for x, y in zip(im.tolist(), edp.tolist())), ("--limit", "2"))
    worst[1] = max(worst[1], abs(found["median"] / np.exp((np.log(2) - a) / b) - 1), abs(found["dispersion"] * b / sigma - 1))
print(f"statsmodels {statsmodels.__version__}, largest relative difference of median and dispersion:")
print(f"  20 sets of counts  {worst[0]:.1e}\n  20 clouds          {worst[1]:.1e}")
sys.exit(0 if max(worst) < 1e-6 else 1)
'''
with tempfile.TemporaryDirectory() as folder:
    venv.create(folder, with_pip=True)
    python = os.path.join(folder, "bin", "python")
    subprocess.run([python, "-m", "pip", "install", "--quiet", "statsmodels"], check=True)
    sys.exit(subprocess.run([python, "-c", peer, os.path.abspath(binary), folder]).returncode)
