# Sourced by tests that draw what they damage, in place of prepare.bash: their arguments end in
# [NUMBER [SEED]]; a child that runs ends with the test.
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
RANDOM=${4:-20261122}
child=
trap 'kill -9 $child 2>/dev/null; rm -rf "$work"' EXIT
export OPENBLAS_NUM_THREADS=1
