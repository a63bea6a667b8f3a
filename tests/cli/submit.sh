#!/usr/bin/env bash
# tools/slurm/submit with a stand-in for sbatch, which runs each job at once in the shell's own terms: what it asks of
# Slurm, what its jobs do, what is refused before there is a job. slurm.sh beside it has the real one.
. "$(dirname "$0")/support.sh"
program=$(readlink -f "$program")
submit=$(readlink -f "$(dirname "$0")/../../tools/slurm/submit")
mkdir "$scratch/bin" "$scratch/a folder"
cat > "$scratch/bin/sbatch" <<'T'
#!/usr/bin/env bash
# Notes its options, runs the script once for each index of the array, and says a number.
printf '%s\n' "$*" >> "$JOBS/asked"
number=$(wc -l < "$JOBS/asked")
cat > "$JOBS/$number.sh"
range="" log=/dev/null
for option; do
  case $option in
    --array=1-*) range=${option#--array=1-} ;;
    --output=*) log=${option#--output=} ;;
  esac
done
for ((i = 1; i <= ${range:-1}; ++i)); do
  [ -n "$range" ] && [ "${LOST-}" = "$i" ] && continue
  if [ -n "$range" ]; then export SLURM_ARRAY_TASK_ID=$i; fi
  (cd / && SLURM_CPUS_PER_TASK=1 bash "$JOBS/$number.sh") > "${log//%a/$i}" 2>&1
done
echo "$number;cluster"
T
chmod +x "$scratch/bin/sbatch"
cat > "$scratch/a folder/study.toml" <<'CASE'
[conductor]
catalogue = "curlew"
friction = 0.5
[section]
law = "return-map"
points = 12
[analysis]
type = "self-damping"
method = "quadrature"
frequencies_Hz = [10, 20]
amplitude_over_diameter = [0.1, 0.3]
tensions_rts = [0.15, 0.25]
CASE
cd "$scratch/a folder" || exit
export JOBS=$scratch STRANDYN=$program
with_sbatch() { PATH=$scratch/bin:$PATH "$submit" "$@"; }
without_times() { sed '/"wall_s"\|"cpu_s"/d' "$1"; }
expect_same() {
  local file
  for file in summary.json points.jsonl sectional_loss.csv points_quadrature.csv; do
    cmp -s <(without_times "whole/$file") <(without_times "$1/$file") || fail "$2: other $file"
  done
}

expect_code 0 "undivided" "$program" run study.toml --quiet --out whole --set conductor.friction=0.4
expect_code 0 "submitted" with_sbatch study.toml 3 --cores 2 --set conductor.friction=0.4 -- --partition=long --time=60
expect_said "shards: job 1, 3 tasks"
expect_said "merge: job 2, when they have ended"
expect_said "results: $scratch/a folder/results/study"
expect_same results/study "as a job array"
grep -q -- '--array=1-3 --cpus-per-task=2 .*--partition=long --time=60$' "$scratch/asked" || fail "not asked for an array"
grep -q -- '--dependency=afterany:1 .*--partition=long --time=60$' "$scratch/asked" || fail "the merge does not wait"

# A shard that a node has lost: the merge says so, and the same command goes on.
rm -r results "$scratch/asked"
expect_code 0 "submitted, one job lost" env LOST=2 PATH="$scratch/bin:$PATH" "$submit" study.toml 3 --out out --set conductor.friction=0.4
grep -q 'shard 2/3 is not given: points' out.shards/merge.log || { fail "the merge does not name the lost shard"; cat out.shards/merge.log; }
[ ! -e out/summary.json ] || fail "there is a result without a shard"
expect_code 0 "submitted again" with_sbatch study.toml 3 --out out --set conductor.friction=0.4
expect_same out "after a lost job"

rm "$scratch/asked"
expect_code 2 "more shards than points" with_sbatch study.toml 9
expect_said "the study has 8 points; give no more shards than that"
expect_code 2 "no number" with_sbatch study.toml some
expect_code 2 "no cores" with_sbatch study.toml 2 --cores 0
expect_code 2 "an unknown word" with_sbatch study.toml 2 --partition=long
expect_said "options of sbatch stand behind --"
expect_code 2 "half an option" with_sbatch study.toml 2 --out
expect_code 4 "no case" with_sbatch none.toml 2
expect_code 2 "no arguments" with_sbatch
expect_code 0 "help" with_sbatch --help
expect_said "usage: tools/slurm/submit CASE.toml N"
[ ! -e "$scratch/asked" ] || fail "a job was submitted for what is refused"
mkdir "$scratch/few"
for tool in bash env basename dirname readlink cat mkdir; do ln -s "$(command -v $tool)" "$scratch/few/$tool"; done
expect_code 69 "no Slurm" env PATH="$scratch/few" "$submit" study.toml 2
expect_said "there is no sbatch here"
finish
