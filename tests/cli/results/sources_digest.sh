#!/usr/bin/env bash
# The identity of the numerics: the same in every folder, another for another byte, written only when it
# changes; part of what a refinement keeps.
# usage: sources_digest.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

printf 'contact/run.cc\nbem/model.cc\n' >list
digest() {
    cmake -DROOT="$work/$1" -DLIST="$work/list" -DUNIT="$work/$2" -DHEADER=runs/point_key.h \
        -DFUNCTION=app::numerics_digest -P "$source_dir/cmake/sources_digest.cmake" ||
        complain "no digest of $1"
}
for root in one another/place; do
    mkdir -p "$root/contact" "$root/bem"
    cp "$source_dir/contact/run.cc" "$root/contact"
    cp "$source_dir/bem/model.cc" "$root/bem"
    digest "$root" "${root%/*}.cc"
done
grep -qE '^    return "[0-9a-f]{64}";$' one.cc || complain "no digest: $(cat one.cc)"
cmp -s one.cc another.cc || complain "another digest in another folder"
touch -d '2020-01-01' one.cc
touch one/bem/model.cc
digest one one.cc
[ "$(stat -c %Y one.cc)" -lt 1600000000 ] || complain "written though nothing changed"
printf ' ' >>one/bem/model.cc
digest one one.cc
! cmp -s one.cc another.cc || complain "the same digest of another byte"
mv one/bem/model.cc one/contact/model.cc
sed -i 's,bem/model,contact/model,' list
truncate -s -1 one/contact/model.cc
digest one moved.cc
! cmp -s moved.cc another.cc || complain "the same digest of another name"

"$program" refine "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --output refined --quiet \
    --set "bem.spacing=1 mm" --set rolling.periods=1 --set rolling.steps=turning-points >/dev/null ||
    complain "the refinement"
# What another program, or this one with other numerics, left is not taken: one whose digest was changed.
unit=$(dirname "$program")/runs_numerics_digest.cc
if [ -e "$unit" ]; then
    own=$(grep -oE '[0-9a-f]{64}' "$unit")
    # The digest stands in the program, or in the library that it shares with Python's module and finds beside it.
    mkdir other
    holder=$(dirname "$program")/libtricontact.so
    [ -e "$holder" ] || holder=$program
    cp "$program" other/tricontact
    LC_ALL=C sed "s/$own/$(printf '%064d' 0)/" "$holder" >changed
    ! cmp -s "$holder" changed || complain "another identity than that of the program's sources"
    [ "$holder" = "$program" ] && cp changed other/tricontact || cp changed other/libtricontact.so
    chmod +x other/*
    for one in "$program" ./other/tricontact; do
        "$one" refine "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --output refined \
            --set "bem.spacing=1 mm" --set rolling.periods=1 --set rolling.steps=turning-points >/dev/null 2>log ||
            complain "the next refinement: $(cat log)"
        grep -c 'taken from' log >>taken
    done
    [ "$(tr '\n' ' ' <taken)" = "3 0 " ] || complain "taken over: $(cat taken) levels, not 3 and 0"
fi

finish
