#!/usr/bin/env bash
# new: a first case from questions on a terminal, from options, or from an example. Each case can be read; nothing is
# written over; without a terminal nothing is asked.
# usage: new.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# 1. Examples: all that stand alone, each as it is in the sources, each a case that is read.
"$program" new --list >list.txt || complain "--list"
[ "$(wc -l <list.txt)" -gt 30 ] || complain "only $(wc -l <list.txt) examples"
"$program" new --list --json >list.json || complain "--list --json"
"$python" -S -c '
import json
for one in json.load(open("list.json"))["examples"]:
    assert one["title"], one
    print(one["name"], one["command"])' >names.txt || complain "list.json: $(cat list.json)"
cut -d' ' -f1 <list.txt | diff - <(cut -d' ' -f1 names.txt) >/dev/null || complain "the lists differ"
while read -r name command; do
    "$program" new --example "$name" >said.txt || complain "new --example $name"
    cmp -s "$name.toml" "$(find "$source_dir"/examples/cases "$source_dir"/examples/rigs -name "$name.toml")" ||
        complain "$name is not the example"
    grep -q "tricontact $command $name.toml" said.txt || complain "$name: $(cat said.txt)"
    [ "$command" != run ] || "$program" check "$name.toml" >/dev/null || complain "$name is no case"
done <names.txt
refused "--example rig_sphere_paralel: is none of the examples; did you mean rig_sphere_parallel?" \
    new --example rig_sphere_paralel
refused "--example: is written as it stands" new --example rough_plane --set indenter.radius="1 mm"
refused "--list: lists the examples" new --list --output x.toml

# 2. What is there stays.
before=$(cat rough_plane.toml)
"$program" new --example rough_plane >out.txt 2>said.txt
[ $? -eq 2 ] && [ ! -s out.txt ] && grep -q '^error: rough_plane.toml: exists already; name another file by --output' said.txt ||
    complain "an existing file: $(cat said.txt)"
ln -s nowhere dangling.toml
"$program" new --defaults --output dangling.toml >out.txt 2>said.txt
[ $? -eq 2 ] && [ ! -e nowhere ] && grep -q 'exists already' said.txt || complain "a link: $(cat said.txt)"
[ "$(cat rough_plane.toml)" = "$before" ] || complain "written over"

# 3. Options in the place of answers; without them nothing is asked where nobody is.
refused "no terminal, on which title would be asked" new
"$program" new --set 'substrate.thickness=8 mm' --set indenter.radius='"20 mm"' --set rolling.amplitude_ratio=none \
    --set title='A "soft" layer' --defaults -o layer.toml >said.txt </dev/null || complain "options: $(cat said.txt)"
"$program" check layer.toml --json >layer.json || complain "the layer cannot be read"
"$python" -S - <<'PYTHON' || complain "the layer is another: $(cat layer.toml)"
import json
answer = json.load(open("layer.json"))
case = answer["case"]
assert answer["title"] == 'A "soft" layer', answer["title"]
assert case["substrate"]["thickness"] == "0.008 m" and case["indenter"]["radius"] == "0.02 m", case
assert case["models"] == ["mdr", "bem", "bem-layer"] and "rolling" not in case, case
PYTHON
"$program" run layer.toml --set mdr.springs=200 --set bem.cells_per_radius=4 --no-report --no-studies -q -o run ||
    complain "the layer does not run"
refused 'indenter.radius' new --defaults --set 'indenter.radius=20'
refused 'substrate.poisson = 0.7' new --defaults --set substrate.poisson=0.7
refused '--set indenter.raduis=20 mm: answers none of the questions; did you mean indenter.radius=...?' \
    new --defaults --set 'indenter.raduis=20 mm'
refused 'coupled, which mdr does not model' new --defaults --set substrate.poisson=0.4 --set models=mdr
refused '--set title: is given twice' new --defaults --set title=a --set title=b
refused 'indenter.radius: is needed; for example 40 mm' new --defaults --set indenter.radius=none

# 4. A terminal: usual answers by Enter; a wrong one is told at once, in one line, and asked again; an end writes nothing.
"$python" -S - "$program" <<'PYTHON' || complain "the terminal"
import os, pty, select, sys

def talk(arguments, answers):
    """What the terminal shows, and the exit code; each answer follows a prompt."""
    pid, terminal = pty.fork()
    if pid == 0:
        os.execv(sys.argv[1], [sys.argv[1], "new", *arguments])
    shown, answers = "", list(answers)
    seen = 0
    while True:
        ready, _, _ = select.select([terminal], [], [], 60)
        if not ready:
            sys.exit(f"waits for ever: {shown}")
        try:
            part = os.read(terminal, 4096).decode()
        except OSError:
            part = ""
        if not part:
            break
        shown += part
        if answers and shown[seen:].endswith("]: "):
            seen = len(shown)
            os.write(terminal, answers.pop(0).encode())
    return shown, os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])

text, code = talk(["-o", "asked.toml"], ["Mine\n", "30\n", "30 mm\n", "\n", "0.9\n", "0.4\n", "6 mm\n"] + ["\n"] * 5)
assert code == 0, text
assert text.count("error: ") == 2 and "error: substrate.poisson = 0.9" in text, text
assert "[bem,bem-layer]: " in text and "written: asked.toml" in text, text
case = open("asked.toml").read()
assert 'title = "Mine"' in case and 'radius = "30 mm"' in case and "poisson = 0.4" in case, case
# Of coupled materials mdr is not among the usual models; named it is refused at once.
text, code = talk(["--set", "substrate.poisson=0.5", "-o", "layer_again.toml"], ["\n"] * 3 + ["6 mm\n"] + ["\n"] * 5)
assert code == 0 and "[mdr,bem,bem-layer]: " in text, text
text, code = talk(["-o", "ended.toml"], ["\n", "\n", "\x04"])
assert code == 2 and "error: new: the input ended before the last question" in text, text
assert not os.path.exists("ended.toml")
text, code = talk(["-o", "asked.toml"], [])
assert code == 2 and "exists already" in text and open("asked.toml").read() == case, text
text, code = talk(["--set", "title=Half", "--set", "models=mdr", "-o", "half.toml"], ["\n"] * 8)
assert code == 0 and "Title" not in text and "Models" not in text, text
PYTHON
"$program" check asked.toml >/dev/null || complain "what was asked is no case"

finish
