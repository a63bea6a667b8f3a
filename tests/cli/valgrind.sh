#!/usr/bin/env bash
# One short run of each analysis under valgrind, which has nothing to say: no byte is read or written that nobody has set,
# and none of another's. Skipped (77) where valgrind is not installed.
. "$(dirname "$0")/support.sh"
command -v valgrind > /dev/null || { echo "valgrind is not installed"; exit 77; }

wires() { printf '[conductor]\ncatalogue = "curlew"\nfriction = 0.5\n[section]\nlaw = "%s"\npoints = 12\n' "$1"; }
span() { printf '[span]\nlength_m = 6\ntension_rts = 0.2\nelements = 12\n'; }
steps() { printf '[integrator]\nmethod = "%s"\nsteps_per_cycle = 40\nmax_numerical_share = 1e3\ncheckpoint_every_s = 0.5\n' "$1"; }
shaker() { printf '[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = %s\nfrequency = "mode 2"\n' "$1"; }
points='antinode_amplitude_mm = 3\ntensions_rts = 0.2\n'

# write_case KIND
write_case() {
  case $1 in
    section) wires compliant; printf '[analysis]\ntype = "section"\ntension_rts = 0.2\ncurvature_amplitudes_per_m = 0.02\nsteps_per_cycle = 20\n' ;;
    wires) wires return-map; printf '[analysis]\ntype = "section"\ntension_rts = 0.2\ncurvature_amplitudes_per_m = 0.02\nsteps_per_cycle = 20\nwires_at_per_m = 0.01\n' ;;
    axial-torsion) wires return-map; printf '[analysis]\ntype = "axial-torsion"\naxial_strain = 1e-3\n' ;;
    static) wires return-map; span; printf '[[load]]\ntype = "static-force"\nat_m = 3\nforce_N = 300\n[analysis]\ntype = "static"\nsteps = 4\n' ;;
    modes) wires return-map; span; printf '[analysis]\ntype = "modes"\ncount = 4\n' ;;
    decay/ida) wires masing; span; steps ida; printf '[analysis]\ntype = "decay"\nmode = 2\nantinode_amplitude_mm = 6\ncycles = 2\n' ;;
    decay/generalized-alpha)
      wires compliant; span; printf '[air]\n[material]\n'; steps generalized-alpha
      printf '[analysis]\ntype = "decay"\nmode = 2\nantinode_amplitude_mm = 6\ncycles = 2\n' ;;
    forced) wires return-map; span; shaker 20; steps ida; printf '[analysis]\ntype = "forced"\ncycles = 2\n' ;;
    transient)
      wires return-map; span
      printf '[[load]]\ntype = "table"\nat_m = 3\nhistory = [[0, 0], [0.01, 50], [0.02, 0]]\n'
      printf '[integrator]\nstep_s = 1e-3\nmax_numerical_share = 1e3\n[analysis]\ntype = "transient"\nduration_s = 0.05\n' ;;
    sweep) wires return-map; span; shaker 3; printf '[analysis]\ntype = "sweep"\nrelative_width = 0.02\n' ;;
    study/transient)
      wires return-map; span; shaker 1; printf '[integrator]\nmethod = "generalized-alpha"\nsteps_per_cycle = 40\n'
      printf "[analysis]\ntype = \"self-damping\"\nmethod = \"transient\"\nmodes = 2\n$points" ;;
    study/*) wires return-map; span; printf "[analysis]\ntype = \"self-damping\"\nmethod = \"${1#study/}\"\nmodes = 2\n$points" ;;
  esac
}

# Other exit codes are the case's own: two cycles are no steady state.
for kind in section wires axial-torsion static modes decay/ida decay/generalized-alpha forced transient sweep \
  study/quadrature study/foti-2018 study/periodic study/transient; do
  write_case "$kind" > "$scratch/case.toml"
  "$program" check "$scratch/case.toml" > "$scratch/said" 2>&1 || { fail "$kind is refused"; cat "$scratch/said"; }
  valgrind -q --error-exitcode=99 "$program" run "$scratch/case.toml" --quiet --out "$scratch/out" > "$scratch/said" 2>&1 < /dev/null
  [ $? -ne 99 ] && ! grep -q "^==" "$scratch/said" || { fail "valgrind on $kind"; cat "$scratch/said"; }
done
finish
