#!/usr/bin/env bash
# As many cores as there are, and the bytes of one: a quadrature study of one tension (its knots go through the law in
# pieces), one of two, and the cases of `verify`.
. "$(dirname "$0")/support.sh"
study() {  # NAME TENSIONS LAW
  cat > "$scratch/$1.toml" <<CASE
[conductor]
catalogue = "curlew"
friction = 0.5
[section]
law = "$3"
[analysis]
type = "self-damping"
method = "quadrature"
frequencies_Hz = [10, 20, 40]
amplitude_over_diameter = [0.01, 0.1, 0.5]
tensions_rts = $2
CASE
}
run() { expect_code 0 "$1 on $2" env STRANDYN_CORES="$2" "$program" run "$scratch/$1.toml" --quiet --out "$scratch/$1.$2"; }
without_times() { sed '/"wall_s"\|"cpu_s"/d' "$1"; }
for law in compliant return-map masing; do
  study one 0.2 $law
  study two '[0.2, 0.3]' $law
  for name in one two; do
    for cores in 1 2 5; do
      run $name $cores
      for file in "$scratch/$name.$cores"/*; do
        cmp -s <(without_times "$file") <(without_times "$scratch/$name.1/$(basename "$file")") ||
          fail "$law, tensions $name, $cores cores: other $(basename "$file")"
      done
    done
  done
done
# What the variable says is no more than a bound.
for odd in 0 x "" -3 99999; do
  expect_code 0 "STRANDYN_CORES=$odd" env STRANDYN_CORES="$odd" "$program" run "$scratch/one.toml" --quiet --out "$scratch/odd"
done

mkdir "$scratch/cases"
cp cases/section/curlew_compliant.toml cases/curlew_modes.toml cases/beam/*cantilever*.toml "$scratch/cases"
for cores in 1 2; do
  STRANDYN_CORES=$cores "$program" verify --cases "$scratch/cases" > "$scratch/verified.$cores" 2> "$scratch/said" ||
    { fail "verify on $cores"; cat "$scratch/said"; }
done
cmp -s "$scratch/verified.1" "$scratch/verified.2" || fail "verify says other things on two cores"
finish
