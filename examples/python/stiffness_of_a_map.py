# SPDX-License-Identifier: BSD-3-Clause
"""From an array of heights to K(p) with its band, and a picture of it: stiffness_of_a_map.png in the current folder.

The parts between the lines "# %%" are cells for editors that know them.
"""

# %% A map of heights [m]. Here one is made: self-affine with H = 0.8 between waves of 8 um and 64 um, 0.5 um rms.
# With a map of your own: surface = fstiff.open_surface("map.al3d"), or heights = numpy.load("map.npy").
import numpy as np

import fstiff

points, step = 256, 1e-6
k = np.hypot(*np.meshgrid(np.fft.fftfreq(points, step), np.fft.fftfreq(points, step)))
amplitude = np.zeros_like(k)
band = (k > 1 / 64e-6) & (k < 1 / 8e-6)
amplitude[band] = k[band] ** -1.8
heights = np.fft.ifft2(amplitude * np.fft.fft2(np.random.default_rng(1).standard_normal(k.shape))).real
heights *= 0.5e-6 / heights.std()

# %% What the surface is, with the errors that so small a piece of it leaves.
measured = fstiff.measure(heights, spacing=step, lambda_s="none")
for name in ("rms_height", "rms_gradient", "peak_radius", "peak_density"):
    one = measured["surface"][name]
    print(f"{name:14} {one['value']:.3g} +- {one['error']:.2g} {one.get('unit', '')}".rstrip())

# %% K(p) of two steel bodies: the answer with its 90 % band, and two laws to compare.
scene = """
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3

[contact]
pressures = { from = "1 MPa", to = "300 MPa", count = 16, spacing = "log" }
laws = ["hybrid", "greenwood_williamson"]
"""
curves = fstiff.run(scene, surface=measured)
for row in curves.answer.rows[::5]:
    K, low, high = (row[f"stiffness{end}_Pa_per_m"] for end in ("", "_p05", "_p95"))
    print(f"{row['pressure_Pa'] / 1e6:3.0f} MPa: K {K:.2e} Pa/m ({low:.2e} to {high:.2e}) by {row['law']}")
print(curves.answer.explanation[0])

# %% The truth at a few pressures: the elastic contact of the map itself, by boundary elements.
truth = fstiff.truth(heights, [10e6, 30e6, 100e6, 300e6], effective_modulus=curves.effective_modulus, spacing=step, lambda_s="none")
hybrid = fstiff.hybrid(measured, truth.column("pressure_Pa"), effective_modulus=curves.effective_modulus)
for p, of_law, of_map in zip(hybrid.pressure, hybrid.stiffness, truth.column("stiffness_Pa_per_m")):
    print(f"{p / 1e6:3.0f} MPa: hybrid {of_law:.2e} Pa/m, boundary elements {of_map:.2e} Pa/m")

# %% The picture.
import matplotlib  # noqa: E402

matplotlib.use("Agg")  # without a screen; leave it out to see the picture in a window
import matplotlib.pyplot as plt  # noqa: E402

figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
fstiff.Surface(heights, step, name="map").plot(left)
curves.plot(ax=right)
truth.plot(ax=right)
right.legend(fontsize="small")
right.set_title("K(p) with the 5 % to 95 % band of the surface's errors", fontsize="medium")
figure.savefig("stiffness_of_a_map.png", dpi=120)
print("wrote stiffness_of_a_map.png")
