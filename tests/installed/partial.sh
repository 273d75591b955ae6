#!/usr/bin/env bash
# What is built is installed, and what is not is named: the install scripts of the build, made to miss something.
# usage: partial.sh BUILD_DIR
set -uo pipefail
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# install NAME FROM TO: as `cmake --install` does, with FROM for TO in paths of what is built; the code it ends with.
install() {
    local script
    (cd "$build" && find . -name cmake_install.cmake) | while read -r script; do
        mkdir -p "$work/$1/$(dirname "$script")"
        sed -e "s,include(\"$build,include(\"$work/$1," -e "s,$build/$2,$build/$3,g" "$build/$script" >"$work/$1/$script"
    done
    cmake -DCMAKE_INSTALL_PREFIX="$work/$1.prefix" -DCMAKE_INSTALL_COMPONENT=program -P "$work/$1/cmake_install.cmake" \
        >"$work/log" 2>&1
}

install no_python python/_core python/missing || complain "without Python's module: $(cat "$work/log")"
if grep -q '_core' "$build/python/cmake_install.cmake" 2>/dev/null; then
    grep -q "Left out, as it is not built: the module for Python (target tricontact_python). cmake --build .* builds all" \
        "$work/log" || complain "not said: $(cat "$work/log")"
fi
[ -x "$work/no_python.prefix/bin/tricontact" ] || complain "no program"
[ -z "$(find "$work/no_python.prefix" -path '*dist-packages*')" ] || complain "half a module for Python"

install no_manual manual/ missing/ || complain "without the manual: $(cat "$work/log")"
grep -q "Left out, as it is not built: manual page and completions of shells (target manual)" "$work/log" ||
    complain "not said: $(cat "$work/log")"
[ -x "$work/no_manual.prefix/bin/tricontact" ] || complain "no program"

install no_program app/tricontact app/missing && complain "installed without the program"
grep -q "The program is not built: nothing is installed or packed" "$work/log" || complain "not said: $(cat "$work/log")"
[ -z "$(find "$work/no_program.prefix" -type f 2>/dev/null)" ] || complain "files without the program"

printf '%d failures\n' "$failures"
exit $((failures > 0))
