# Sourced by tests that compare numbers of summaries, in place of prepare.bash.
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"

# value MODEL KEY FILE: of a summary.
value() {
    "$python" -S -c "import json; print(json.load(open('$3'))['models']['$1']['$2'])"
}
# near VALUE EXPECTED TOLERANCE WHAT
near() {
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !(a / b - 1 <= t && 1 - a / b <= t) }' ||
        complain "$4: $1 instead of $2, allowed $3"
}
