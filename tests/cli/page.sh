#!/usr/bin/env bash
# A page of results in a browser: drawn, asked, zoomed, played, printed. Skipped without a browser, npm, or the library.
source "$(dirname "$0")/support.sh"

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  { echo "no browser: skipped"; exit 77; }
command -v node >/dev/null && command -v npm >/dev/null || { echo "no node or npm: skipped"; exit 77; }
root=$(cd "$(dirname "$0")/../.." && pwd)
cp "$root"/tests/cli/page/{package.json,package-lock.json,look.mjs,open.mjs} "$scratch"
(cd "$scratch" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) || { echo "npm cannot fetch: skipped"; exit 77; }

"$program" run "$root/cases/line/curlew_clamp.toml" --quiet --report --out "$scratch/run" || fail "the case"
grep -q 'id="plots"' "$scratch/run/report.html" || { echo "built without interactive plots: skipped"; exit 77; }
(cd "$scratch" && timeout 300 node look.mjs "$browser" "$scratch/run/report.html" "$scratch/run") || fail "the page"
size=$(stat -c %s "$scratch/run/report.html")
[[ $size -lt 5000000 ]] || fail "a page of $size bytes"

# A study of a thousand points opens at once, and says which rows it leaves out and where they are.
study=$scratch/thousand
"$program" run "$root/tests/cli/page/thousand.toml" --quiet --report --out "$study" || fail "the study"
[[ $(wc -l <"$study/points_quadrature.csv") -eq 1001 ]] || fail "the study has not a thousand points"
(cd "$scratch" && timeout 300 node open.mjs "$browser" "$study/report.html" 2) || fail "the page of a thousand points"
grep -q '60 of 1000 rows, evenly spaced; 940 are left out. All are in <a href="points_quadrature.csv">' "$study/report.html" ||
  fail "the page does not say what it leaves out"
grep -q "24 of 100 lines are drawn" "$study/report.html" || fail "the page does not say which lines it leaves out"
finish
