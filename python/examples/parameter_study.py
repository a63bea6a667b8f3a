"""What friction between the wires does to a decay: one case under several overrides, on all cores."""

import strandyn

decay = {
    "title": "a decay of Curlew", "conductor": {"catalogue": "curlew"}, "section": {"law": "return-map", "points": 20},
    "span": {"length_m": 8, "tension_rts": 0.2, "elements": 40},
    "integrator": {"method": "generalized-alpha", "steps_per_cycle": 60},
    "analysis": {"type": "decay", "mode": 4, "antinode_amplitude_mm": 5, "cycles": 3},
}
frictions = [0.1, 0.2, 0.35, 0.5, 0.7]
results = strandyn.run_many(decay, [{"conductor.friction": mu} for mu in frictions])
for mu, result in zip(frictions, results):
    print(f"friction {mu:4.2f}: loss factor {result['steady.loss_factor']:.3g}, "
          f"self-damping {result['steady.self_damping_W_per_m']:.3g} W/m")
