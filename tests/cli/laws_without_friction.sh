#!/usr/bin/env bash
# With every wire stuck, or every wire slipping, nothing is dissipated: exactly zero, and no share is formed.
. "$(dirname "$0")/support.sh"
sed '/^\[accept\]/,$d' cases/curlew_lab_span.toml > "$scratch/case.toml"
for law in stick slip; do
  expect_code 0 "$law" "$program" run "$scratch/case.toml" --set section.law=$law --quiet --out "$scratch/$law"
  summary="$scratch/$law/summary.json"
  [ "$(grep -c '"friction_dissipation_J": 0.0,' "$summary")" -eq 201 ] || fail "$law: friction is not exactly zero"
  grep -q '"numerical_share"' "$summary" && fail "$law: a share of nothing"
done
finish
