"""Values have the types that the stub of the compiled module states, those above all that pybind11 does not tell."""

import ast
import typing
from pathlib import Path

import numpy as np
import pytest

import tricontact
from tricontact import _core, atlas, benchmark, theory

STUB = ast.parse((Path(tricontact.__file__).parent / "_core.pyi").read_text())
COARSE = {"rolling.periods": 2, "bem.cells_per_radius": 8}


def names():
    """What annotations of the stub are made of."""
    found = {**vars(typing), **vars(_core), "np": np, "NDArray": np.typing.NDArray, "Surfaces": tricontact.Surfaces}
    for node in STUB.body:
        if isinstance(node, (ast.Import, ast.Assign)) or isinstance(node, ast.ClassDef) and node.name.startswith("_"):
            exec(ast.unparse(node), found)
    return found


NAMES = names()
# Of overloads the first, for numbers; see test_theory.py for arrays.
RETURNS, PROPERTIES = {}, {}
for owner in (None, *(node for node in STUB.body if isinstance(node, ast.ClassDef))):
    for one in STUB.body if owner is None else owner.body:
        if isinstance(one, ast.FunctionDef):
            place = one.name if owner is None else f"{owner.name}.{one.name}"
            RETURNS.setdefault(place, eval(ast.unparse(one.returns), NAMES))
            if any(ast.unparse(by) == "property" for by in one.decorator_list):
                PROPERTIES.setdefault(owner.name, []).append(one.name)


def fits(value, kind):
    """Whether a value is of a type."""
    origin, parts = typing.get_origin(kind), typing.get_args(kind)
    if kind is typing.Any:
        return True
    if kind in (None, type(None)):
        return value is None
    if typing.is_typeddict(kind):
        hints = typing.get_type_hints(kind, NAMES)
        return isinstance(value, dict) and set(value) == set(hints) and all(fits(value[key], hints[key]) for key in hints)
    if origin is typing.Union:
        return any(fits(value, part) for part in parts)
    if origin is list:
        return isinstance(value, list) and all(fits(one, parts[0]) for one in value)
    if origin is dict:
        return isinstance(value, dict) and all(fits(key, parts[0]) and fits(one, parts[1]) for key, one in value.items())
    if origin is tuple and parts[-1] is Ellipsis:
        return isinstance(value, tuple) and all(fits(one, parts[0]) for one in value)
    if origin is tuple:
        return isinstance(value, tuple) and len(value) == len(parts) and all(map(fits, value, parts))
    if origin is np.ndarray:
        scalar = typing.get_args(parts[1])[0]
        return isinstance(value, np.ndarray) and (scalar is typing.Any or value.dtype == scalar)
    if kind is float:
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    return isinstance(value, kind) and (kind is not int or not isinstance(value, bool))


def check(place, value):
    assert fits(value, RETURNS[place]), f"{place}: {value!r} is no {RETURNS[place]}"
    return place


def check_object(one):
    """All properties of an object, and of what they hold; yields their places."""
    owner = type(one).__name__
    for name in PROPERTIES.get(owner, ()):
        value = getattr(one, name)
        yield check(f"{owner}.{name}", value)
        for part in value if isinstance(value, list) else [value]:
            if type(part).__module__ == "tricontact._core":
                yield from check_object(part)


def of_a_run(rig):
    case = tricontact.Case.from_file(rig, COARSE)
    result = tricontact.run(case, models=["mdr", "bem"], threads=1)
    for one in (case, result, *(result[model] for model in result), *(result.results(model) for model in result)):
        yield from check_object(one)
    surface, history = result.surfaces("bem")[0].surface, result["bem"]
    yield check("Surface.__getitem__", surface["contact_state"])
    yield check("History.__getitem__", history["shift_x_m"])
    yield check("Result.__getitem__", history)
    yield check("Result.surfaces", result.surfaces("bem"))
    yield check("Case.from_file", case)
    yield check("Case.to_dict", case.to_dict())
    yield check("Case.from_dict", tricontact.Case.from_dict(case.to_dict()))
    pressed = {key: part for key, part in case.to_dict().items() if key != "rolling"}
    yield check("History.state", tricontact.run(pressed, models=["mdr"])["mdr"].state)


def of_saved_results(rig, program, tmp_path):
    settings = [text for key, value in COARSE.items() for text in ("--set", f"{key}={value}")]
    program("run", rig, "--models", "mdr", *settings, "--quiet", "--no-report", "--no-studies", "--output", "out")
    saved = _core._saved_surfaces(str(tmp_path / "out").encode())
    assert saved["mdr"]
    yield check("_saved_surfaces", saved)
    _, path, state = saved["mdr"][0]
    yield check("_read_surface", _core._read_surface(path, state))


def of_theory(examples):
    contact = theory.layer_contact(tricontact.Case.from_file(examples / "cases" / "rig_layer_parallel.toml"))
    yield from check_object(contact)
    yield from check_object(theory.kalker_coefficients(1, 0.3))
    yield check("LayerContact.pressure", contact.pressure(0))
    yield check("settled_shift_ratio", theory.settled_shift_ratio(0.2, 0.5))


def of_references(hertz):
    yield from check_object(hertz)
    for name in ("traction", "traction_bar", "displacement", "displacement_bar", "pressure", "load_within"):
        yield check(f"BenchmarkReference.{name}", getattr(hertz, name)(0.01))


def of_others(examples):
    maps = atlas.load("sphere_half_space")._maps
    yield from check_object(maps)
    middle = np.array([[sum(axis.range) / 2 for axis in maps.axes]])
    yield check("AtlasMaps.read", maps.read(maps.quantities[0], middle, False))
    machine = tricontact.WalkCase.from_file(examples / "cases" / "walking_set_b.toml", {"time.end": 20})
    yield from check_object(machine)
    yield check("WalkCase.from_file", machine)
    yield check("WalkCase.to_dict", machine.to_dict())
    yield check("WalkCase.from_dict", tricontact.WalkCase.from_dict(machine.to_dict()))
    yield check("_walk", _core._walk(machine, lambda what, done, total: None))
    cylinder = tricontact.Case.from_file(examples / "cases" / "rolling_cylinder.toml",
                                         {"bem.cells_per_radius": 12, "tractive_rolling.distance": 2})
    yield check("_roll", _core._roll(cylinder, None, 0, 1, None))
    yield check("_command_options", _core._command_options("limit"))
    yield check("_atlas_names", _core._atlas_names())
    yield check("_label", _core._label("kappa"))
    yield check("_label", _core._label("nothing of this name"))


def test_values_have_the_types_of_the_stub(rig, examples, program, tmp_path, monkeypatch):
    monkeypatch.setenv("TRICONTACT_CACHE", str(tmp_path / "cache"))
    (tmp_path / "cache").mkdir()
    seen = {*of_a_run(rig), *of_saved_results(rig, program, tmp_path), *of_theory(examples),
            *of_references(benchmark.reference(rig)), *of_others(examples)}
    # Every property, and every function whose result is more than pybind11 says.
    missing = {f"{owner}.{name}" for owner, all_of in PROPERTIES.items() for name in all_of} - seen
    more = (dict, list, tuple, np.ndarray, typing.Union)
    missing |= {place for place, kind in RETURNS.items() if typing.get_origin(kind) in more} - seen
    assert missing == set()


@pytest.mark.parametrize(("value", "kind", "is_one"), [
    (1.0, "float", True), (1, "float", True), ("1", "float", False), (True, "float", False), (None, "Optional[str]", True),
    ([1.0, None], "_Quantity", True), ([1.0, "a"], "_Quantity", False), ((1, 2), "tuple[int, ...]", True),
    ((1.0, 2.0, 3.0), "tuple[float, float]", False), ({"a": {"worst": 1.0}}, "dict[str, _Check]", False),
    (np.zeros(2), "_Numbers", True), (np.zeros(2, int), "_Numbers", False), (np.zeros(2, int), "NDArray[Any]", True),
])
def test_other_values_are_found(value, kind, is_one):
    assert fits(value, eval(kind, NAMES)) == is_one
