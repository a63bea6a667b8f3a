"""A self-damping curve in ten lines: power per metre against the antinode amplitude, a line for each frequency."""

import numpy as np

import strandyn

study = strandyn.self_damping("drake", frequencies_Hz=[15, 20, 30, 40], tensions_rts=[0.2], law="return-map",
                              amplitude_over_diameter=[0.05, 0.1, 0.2, 0.3, 0.4])
points = study.table("points_quadrature")
for frequency in np.unique(points["frequency_Hz"]):
    at = points["frequency_Hz"] == frequency
    for amplitude, power in zip(points["antinode_amplitude_m"][at], points["self_damping_W_per_m"][at]):
        print(f"{frequency:5.1f} Hz  {1e3 * amplitude:6.2f} mm  {power:.4g} W/m")
try:
    import matplotlib.pyplot as plt
except ImportError:
    raise SystemExit("matplotlib is not installed: no picture")
for frequency in np.unique(points["frequency_Hz"]):
    at = points["frequency_Hz"] == frequency
    plt.loglog(1e3 * points["antinode_amplitude_m"][at], points["self_damping_W_per_m"][at], "o-", label=f"{frequency:g} Hz")
plt.xlabel("antinode amplitude (mm)"), plt.ylabel("self-damping (W/m)"), plt.legend(), plt.savefig("self_damping.png")
