"""Reads the moving span that a run has written, with h5py: how far the middle of a span goes, where energy is lost."""

import numpy as np

import strandyn

case = {
    "title": "a decay of Curlew, its span written 24 times a cycle", "conductor": {"catalogue": "curlew"},
    "section": {"law": "return-map", "points": 20}, "span": {"length_m": 8, "tension_rts": 0.2, "elements": 40},
    "integrator": {"method": "generalized-alpha", "steps_per_cycle": 48}, "output": {"fields_per_cycle": 24},
    "analysis": {"type": "decay", "mode": 4, "antinode_amplitude_mm": 5, "cycles": 3},
}
result = strandyn.run(case)
try:
    fields = result.fields()
except ImportError:
    raise SystemExit("h5py is not installed")
print(f"{len(fields['time'])} moments of {len(fields['points'])} nodes, up to {1e3 * fields['time'][-1]:.1f} ms")
print(f"largest displacement {1e3 * np.abs(fields['displacement'][..., 1]).max():.2f} mm")
worst = fields["dissipated_J_per_m"][-1].argmax()
print(f"most is lost in element {worst + 1} of {len(fields['points']) - 1}: "
      f"{fields['dissipated_J_per_m'][-1, worst]:.3g} J/m in three cycles")
