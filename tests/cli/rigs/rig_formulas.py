#!/usr/bin/env python3
"""The text of every formula of rig.json, evaluated with the numbers shown beside it, gives the number shown: for each example
of a rig, and with its numbers drawn at random.

usage: rig_formulas.py PROGRAM RIGS SEED DRAWS
"""

import json
import math
import random
import re
import subprocess
import sys
from pathlib import Path

# What no formula in closed form gives: another theory solved, a run, a map, or a fit whose coefficients are not shown.
NOT_CLOSED = re.compile(r"layer_(?!modulus)|layer_modulus|fitted_modulus_error|.*_difference|coupling_effect|edge_exponent|end_load$|"
                        r"strain_|side_|von_mises_ratio|shakedown_ratio")
GRAVITY = 9.81
FUNCTIONS = {"sqrt": math.sqrt, "tan": math.tan, "ln": math.log, "erf": math.erf, "exp": math.exp}
TOKEN = re.compile(r"\s*([0-9.]+(?:e-?[0-9]+)?|[A-Za-z][A-Za-z_0-9]*(?:\*|')*|[-+/^()|\[\]])")


class Text:
    """A formula as it is shown: products are written side by side and go with quotients from left to right."""

    def __init__(self, text, value_of):
        self.tokens, self.value_of, at = [], value_of, 0
        while at < len(text):
            token = TOKEN.match(text, at)
            if not token:
                raise ValueError(f"no formula: {text!r} at {text[at:]!r}")
            self.tokens.append(token[1])
            at = token.end()

    def value(self):
        value = self.sum()
        if self.tokens:
            raise ValueError(f"left over: {self.tokens}")
        return value

    def next(self):
        return self.tokens[0] if self.tokens else ""

    def take(self):
        return self.tokens.pop(0)

    def sum(self):
        value = self.product()
        while self.next() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self, inside=False):
        value = self.power()
        while self.next() and self.next() not in "+-)]" and not (self.next() == "|" and self.in_bars):
            if self.next() == "/":
                self.take()
                value /= self.power()
            else:
                value *= self.power()
        return value

    in_bars = False

    def power(self):
        value = self.atom()
        if self.next() == "^":
            self.take()
            value **= self.atom()
        return value

    def atom(self):
        token = self.take()
        if token == "-":
            return -self.power()
        if token in "([|":
            outer, self.in_bars = self.in_bars, token == "|"
            value = self.sum()
            self.in_bars = outer
            assert self.take() == {"(": ")", "[": "]", "|": "|"}[token]
            return abs(value) if token == "|" else value
        if token in FUNCTIONS:
            return FUNCTIONS[token](self.atom())
        return float(token) if token[0].isdigit() or token[0] == "." else self.value_of(token)


def symbols_of(name, given, clauses):
    """The symbols of a formula: what is given, what its clauses define, and what the documents do (docs/explanation/rig.md)."""
    definitions = {}
    for clause in clauses:
        left, equals, right = clause.partition(" = ")
        if equals and re.fullmatch(r"[A-Za-z][\w*]*", left):
            definitions[left] = right

    def modulus(i):
        return value("E_" + i) / (2 * (1 + value("nu_" + i)))

    def over_both(part):
        return 1 / (part("1") + part("2"))

    walking, line = "D_c" in given and "E_1" in given or "m" in given or name == "kappa2", "L" in given
    conventions = {
        "pi": lambda: math.pi,
        "g": lambda: GRAVITY,
        "mu": lambda: 1,  # of a unit shift
        "E*": lambda: over_both(lambda i: (1 - value("nu_" + i)) / (2 * modulus(i)) if walking else
                                (1 - value("nu_" + i)**2) / value("E_" + i)),
        "G*": lambda: over_both(lambda i: (2 - value("nu_" + i)) / (4 * modulus(i))),
        "G_1": lambda: modulus("1" if "E_1" in given else "2"),  # beside eta the substrate's at rest
        "G_2": lambda: value("G_2/G_1") * value("G_1") if "G_2/G_1" in given else modulus("2"),
        "E'": lambda: value("E_2") / (1 - value("nu_2")**2),
        "omega": lambda: 2 * math.pi * value("v") / (4 * value("w") * value("a")),
        "tau": lambda: value("eta") / value("G_2"),
        "a": lambda: math.sqrt(4 * value("F_N") * value("R") / (math.pi * value("E*") * value("L"))) if line else
        (3 * value("F_N") * value("R") / (4 * value("E*")))**(1 / 3),
        "d": lambda: value("a")**2 / value("R"),
        "p_0": lambda: 2 * value("F_N") / (math.pi * value("a") * value("L")) if line else
        3 * value("F_N") / (2 * math.pi * value("a")**2),
        "kappa_3": lambda: value("a") / value("b"),
        "r_s": lambda: math.sqrt(value("k") * value("l_s") / (math.pi * value("E_s"))),
        "I_s": lambda: math.pi * value("r_s")**4 / 4,
    }

    def value(symbol):
        if symbol in given:
            return given[symbol]["value"]
        if symbol in definitions and "sum" not in definitions[symbol]:
            return Text(definitions[symbol], value).value()
        return conventions[symbol]()

    return value


def values_of(calculation, layer):
    """What the text gives, once for each of its sides."""
    name, text, given = calculation["name"], calculation["formula"], dict(calculation["given"])
    text, _, _ = text.partition(": ")
    text = text.replace(" at mu = 1", "").replace("2 sqrt(a b) of the wear spots", "D_wear").replace(" over ", "/")
    if text.startswith("propagated"):
        text = "s_k/k_x"
        given["s_k"] = given["s(k_x)"]
    if text == "a of the linear layer":
        text = "a/R"
    main, *clauses = re.split(r", (?![^(]*\))", text)
    if name.startswith("modulus_from") or name in ("strain_measure", "height_change", "axis_indentation"):
        given.update(layer)  # "d of the layer"
    if main.startswith("x = "):
        main = main[4:]
    value = symbols_of(name, given, clauses)
    if main.startswith("a^3 = "):  # of an adhesive radius: over that of Hertz, minus 1
        return [(Text(main[6:], value).value())**(1 / 3) / value("a") - 1]
    sides = main.split(" = ")
    return [Text(side, value).value() for side in sides if side != "k_z/k_x"]


def difference(calculation, layer):
    """Largest relative difference of the text's values from the number shown."""
    shown = calculation["result"]["value"]
    scale = max(abs(shown), 1e-9)  # of a small difference of two numbers the text has rounding
    return max(abs(value - shown) / scale for value in values_of(calculation, layer))


def check(path, program, overrides, seen):
    """Problems of a rig's formulas."""
    command = [program, "rig", path, "--output", "out", *(word for one in overrides for word in ("--set", one))]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        return [f"{' '.join(map(str, command))}: {done.stderr}"]
    report = json.loads(Path("out/rig.json").read_text())
    calculations = [one for a in report["assumptions"] for one in a["criteria"] + a["background"]]
    result = {one["name"]: one["result"] for one in calculations}
    layer = {"d": result.get("layer_indentation"), "a": result.get("layer_contact_radius")}
    problems = []
    for one in calculations:
        if NOT_CLOSED.match(one["name"]):
            continue
        seen.add((one["name"], one["formula"]))
        try:
            off = difference(one, {symbol: value for symbol, value in layer.items() if value})
        except (ValueError, KeyError, AssertionError, ZeroDivisionError) as error:
            problems.append(f"{path.stem}: {one['name']} = {one['formula']}: {error!r}")
            continue
        if not off < 1e-9:
            problems.append(f"{path.stem} {overrides}: {one['name']}: {one['symbol']} = {one['formula']} with "
                            f"{one['given']} is not {one['result']['value']}")
    return problems


def drawn(text, numbers):
    """Overrides that change the numbers of a rig's data by up to a tenth."""
    overrides, section = [], ""
    for line in text.splitlines():
        heading, entry = re.match(r"\[([\w.]+)\]", line), re.match(r'(\w+) = ("?)([0-9.e-]+)((?: ±|[ "#]|$).*)', line)
        if heading:
            section = heading[1]
        elif entry and section in ("indenter", "substrate", "friction", "load", "rig", "machine", "contact"):
            key, quote, number, rest = entry.groups()
            if key in ("poisson", "substrate_poisson", "periods"):
                continue
            if key == "young" and len(re.findall(r"(?m)^young = ", text)) > 1:
                continue  # bodies that become unlike couple, which mdr does not
            unit = re.match(r'[^"]*', rest)[0] if quote else ""
            value = f"{float(number) * numbers.uniform(.9, 1.1):.6g}{unit}"
            overrides.append(f'{section}.{key}="{value}"' if quote else f"{section}.{key}={value}")
    return overrides


def main():
    program, rigs, seed, draws = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
    numbers, problems, seen = random.Random(seed), [], set()
    more = {"sphere_parallel": ['rig.tilt="0.5 deg"', 'rig.rms_height="2 um"', "rig.rms_slope=0.1", 'rig.conductivity="0.2 W/m/K"',
                                'rig.temperature_coefficient="3e-3 1/K"', 'rig.wear_rate="1e-15 m2/N"', "rig.periods=30"],
            "sphere_perpendicular": ['rig.contact_size="9 mm"', 'rig.tilt="0.3 deg"'],
            "cylinder_parallel": ['rig.tilt="0.1 deg"', 'rig.axis_tilt="0.05 deg"', 'rig.rms_height="2 um"', "rig.rms_slope=0.1"]}
    for path in sorted(rigs.glob("*.toml")):
        text = path.read_text()
        if "[design]" in text:
            continue
        for draw in range(draws + 1):
            overrides = drawn(text, numbers) if draw else []
            problems += check(path, program, overrides + more.get(path.stem, []), seen)
    print("\n".join(problems))
    print(f"{len(seen)} formulas in closed form")
    return 1 if problems or len(seen) < 45 else 0


if __name__ == "__main__":
    sys.exit(main())
