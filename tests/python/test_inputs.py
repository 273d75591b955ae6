"""Every command with a file, a case and a dictionary; keys as keywords; results kept and opened."""

import inspect
import json
import os
import pickle
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest

import tricontact

SMALL = {"rolling.steps": "turning-points", "rolling.periods": 1, "mdr.springs": 300, "models": ["mdr"]}
ON = {"bem.cells_per_radius": 12, "tractive_rolling.distance": 1}
BALL = "cases/rig_sphere_parallel.toml"
RIG = "rigs/sphere_parallel.toml"
# Of each function that takes a case: an example and a cheap call.
CALLS = {
    "run": (BALL, lambda case: tricontact.run(case, overrides=SMALL, studies=False)),
    "wear": ("cases/fretting_wear.toml", lambda case: tricontact.wear(
        case, models=["mdr"], overrides={"wear.cycles": 1000, "mdr.springs": 200}, studies=False)),
    "limit": (BALL, lambda case: tricontact.limit(case, overrides=SMALL, tolerance=0.1)),
    "predict": (BALL, tricontact.predict),
    "deviation": ("cases/rig_layer_parallel.toml", lambda case: tricontact.deviation(case, no_runs=True)),
    "refine": (BALL, lambda case: tricontact.refine(
        case, models=["bem"], levels=3, overrides={"models": ["bem"], "rolling.periods": 1,
                                                "rolling.steps": "turning-points", "bem.spacing": "1 mm"})),
    "rig": (RIG, tricontact.rig),
    "design": ("rigs/design_resolution.toml", tricontact.design),
    "identify": (RIG, lambda case: tricontact.identify(case, overrides={"measurement.models": ["half-space"]})),
    "experiment": ("records/synthetic_shakedown.toml", lambda case: tricontact.experiment(
        case, overrides={"models": ["mdr"], "record.runs": [str(RECORDS / "run_1.csv"), str(RECORDS / "run_2.csv")]})),
    "roll": ("cases/rolling_cylinder.toml", lambda case: tricontact.roll(case, overrides=ON, points=2)),
    "walk": ("cases/walking_set_b.toml", lambda case: tricontact.walk(case, time__end=100)),
    "benchmark.reference": (BALL, lambda case: tricontact.benchmark.reference(
        case, overrides={"models": ["bem"], "load.tangential_ratio": 0}, contact__coupling=False).values),
    "theory.layer_contact": ("cases/rig_layer_parallel.toml", lambda case: [
        getattr(tricontact.theory.layer_contact(case), name) for name in ("contact_radius", "indentation")]),
}
# These take the finished case alone.
CASE_ALONE = {"theory.layer_contact"}
# Two seconds a call, and given to the program as "limit" is: called once, beside exact theory.
LONG = {"deviation"}
# Each call draws its figures: a file and the dictionary of a case.
DRAWN = {"refine"}
RECORDS = Path(os.environ["TRICONTACT_COPY"]) / "share/tricontact/examples/records/synthetic"


def taking_a_case():
    """Names of all public functions whose first parameter is called "case"."""
    places = {"": tricontact, "benchmark.": tricontact.benchmark, "theory.": tricontact.theory,
              "atlas.": tricontact.atlas}
    for before, place in places.items():
        for name in place.__all__:
            thing = getattr(place, name)
            if inspect.isclass(thing) or not callable(thing):
                continue
            parameters = re.findall(r"^\w+\((\w+)", thing.__doc__ or "")  # of the compiled ones
            if inspect.isfunction(thing):
                parameters = list(inspect.signature(thing).parameters)
            if parameters and parameters[0] == "case":
                yield before + name


def test_every_function_that_takes_a_case_is_tried():
    assert sorted(set(taking_a_case()) - {"atlas.predict"}) == sorted(CALLS)
    assert tricontact.atlas.predict is tricontact.predict


@pytest.mark.parametrize("name", CALLS)
def test_a_file_a_case_and_a_dictionary_give_the_same(name, examples, tmp_path, monkeypatch):
    monkeypatch.setenv("TRICONTACT_CACHE", str(tmp_path))
    place, call = CALLS[name]
    file = examples / place
    kind = tricontact.WalkCase if name == "walk" else tricontact.Case
    case = kind.from_file(file)
    if name in CASE_ALONE:
        assert call(case) == call(pickle.loads(pickle.dumps(case)))
        with pytest.raises(TypeError):
            call(file)
        return
    if name in LONG:
        outcome = call(case.to_dict())
        radius = outcome["layer"]["exact"]["contact_radius"]["ratio"] * outcome["hertz_diameter_m"] / 2
        # The same theory, asked directly: to rounding.
        assert radius == pytest.approx(tricontact.theory.layer_contact(case).contact_radius, rel=1e-9)
        with pytest.raises(tricontact.InputError, match=f"{file.name}.*w = W/a is at least 1"):
            tricontact.deviation(file, rolling__amplitude_ratio=1.5)
        return
    expected = call(file)
    if name in DRAWN:
        assert call(case.to_dict()) == expected
        return
    assert call(case) == expected
    # As a file holds it, and, where the resolved case is enough, with its defaults.
    given = absolute(tomllib.loads(file.read_text()), file.parent)
    assert same(call(given)) == same(expected)
    if name not in ("rig", "design", "identify", "experiment"):
        assert call(case.to_dict()) == expected


def same(result):
    """Without the command line, which names the file."""
    if isinstance(result, tricontact.Outcome) and "command" in result:
        return {key: value for key, value in result.items() if key != "command"}
    return result


def absolute(item, folder):
    """Paths in a dictionary are absolute."""
    if isinstance(item, dict):
        return {key: absolute(one, folder) for key, one in item.items()}
    if isinstance(item, list):
        return [absolute(one, folder) for one in item]
    return str(folder / item) if isinstance(item, str) and item.endswith(".csv") else item


def test_a_case_brings_its_rig_along(examples, tmp_path):
    file = tmp_path / "rig.toml"
    file.write_text((examples / RIG).read_text().partition("\n[measurement]")[0])
    case = tricontact.Case.from_file(file, {"rig.viscosity": "41 Pa s"})
    expected = tricontact.rig(file, rig__viscosity="41 Pa s")
    plain = tricontact.rig(file)
    assert expected != plain
    for given in (case, pickle.loads(pickle.dumps(case))):
        assert tricontact.rig(given) == expected
    assert tricontact.rig(case, rig__viscosity="40 Pa s") == plain
    values = tomllib.loads(file.read_text())
    assert tricontact.rig(tricontact.Case.from_dict(values, {"rig.viscosity": "41 Pa s"})) == expected
    file.write_text(file.read_text() + "# later\n")
    with pytest.raises(tricontact.InputError, match="rig.toml: has changed since the case was read"):
        tricontact.rig(case)
    assert tricontact.Case.from_file(file).to_toml() == tricontact.Case.from_dict(values).to_toml()


def test_a_study_takes_a_case_and_a_dictionary_as_its_case(rig, tmp_path):
    case = tricontact.Case.from_file(rig, SMALL)
    tables = [
        tricontact.sweep({"case": given, "models": ["mdr"], "vary": {"load": {"tangential_ratio": [0.2, 0.4]}}},
                         tmp_path / str(i), jobs=1, report=False)
        for i, given in enumerate((case, case.to_dict()))
    ]
    assert tables[0] == tables[1]
    # U_stat/U_max = 1 - (1 - f)^(2/3) of a paraboloid; 300 springs resolve the edge to 1 %.
    np.testing.assert_allclose(tables[0]["static_shift_ratio"], [1 - 0.8 ** (2 / 3), 1 - 0.6 ** (2 / 3)], rtol=1e-2)
    assert tricontact.open(tmp_path / "0").table("results") == tables[0]


def test_keys_are_keywords_with_units(rig):
    one = tricontact.run(rig, overrides=SMALL, load__normal_force="10 N", studies=False)
    other = tricontact.run(rig, overrides={**SMALL, "load.normal_force": "10 N"}, studies=False)
    assert one == other and one["mdr"].scales.normal_force == pytest.approx(10)
    with pytest.raises(tricontact.InputError, match="did you mean load.tangential_ratio"):
        tricontact.run(rig, load__tangential_ratoi=0.3)
    with pytest.raises(TypeError, match="no option model; keys of the case have two underscores"):
        tricontact.run(rig, model="mdr")
    with pytest.raises(TypeError, match="rolling.periods is given twice"):
        tricontact.run(rig, overrides=SMALL, rolling__periods=2)


def test_results_iterate_print_pickle_and_compare(rig):
    result = tricontact.run(rig, overrides=SMALL, studies=False)
    history = result["mdr"]
    assert list(result) == ["mdr"] and "mdr" in result and "bem" not in result and len(result) == 1
    assert "shift_x_m" in history and list(history) == history.columns
    surface = history.snapshots[-1].surface
    assert list(surface) == surface.fields
    for one in (result, history, history.snapshots[-1], surface, result.case):
        again = pickle.loads(pickle.dumps(one))
        assert again == one and one == again and not one != again
        assert " at 0x" not in repr(one) and repr(again) == repr(one)
    loaded = tricontact.run(rig, overrides=SMALL, load__tangential_ratio=0.3, studies=False)
    assert loaded != result and loaded["mdr"] != history and result != 1
    assert "<Result of 'Sphere" in repr(result) and "300" not in repr(result)
    assert "<b>mdr: shakedown</b>" in result._repr_html_()
    assert result._repr_html_() == pickle.loads(pickle.dumps(result))._repr_html_()


def test_a_folder_of_the_program_is_opened(rig, program, tmp_path):
    settings = [text for key, value in SMALL.items() if key != "models" for text in ("--set", f"{key}={value}")]
    program("run", rig, "--models", "mdr", *settings, "--quiet", "--no-studies", "--output", "out")
    result = tricontact.run(rig, overrides=SMALL, studies=False)
    opened = tricontact.open(tmp_path / "out")
    assert opened.models == ["mdr"] and opened.case == result.case
    for column in result["mdr"]:
        np.testing.assert_array_equal(opened["mdr"][column], result["mdr"][column])
    assert opened.results("mdr").final_shift_m == result.results("mdr").final_shift_m
    np.testing.assert_allclose(opened["mdr"].shift_per_period, result["mdr"].shift_per_period, rtol=1e-12)
    # Files hold single precision: 2^-24 of the largest value.
    kept, computed = (one.surfaces("mdr")[-1].surface["normal_traction_Pa"] for one in (opened, result))
    np.testing.assert_allclose(kept, computed, rtol=1e-6, atol=1e-7 * computed.max())
    again = pickle.loads(pickle.dumps(opened))
    assert again == opened


def test_a_folder_of_an_earlier_version_is_refused_by_name(rig, program, tmp_path):
    settings = [text for key, value in SMALL.items() if key != "models" for text in ("--set", f"{key}={value}")]
    run = ("run", rig, "--models", "mdr", *settings, "--quiet", "--no-studies", "--no-report", "--output", "out")
    program(*run)
    for name in ("surface.pvd", "surface_000000.vtp", "indenter.pvd", "surface_000000.csv"):
        (tmp_path / "out" / "mdr" / name).write_text("of an earlier version, or a user's own")
    with pytest.raises(tricontact.InputError, match=r"mdr/surface.pvd: is of an earlier version, .* compute the case anew"):
        tricontact.open(tmp_path / "out")
    program(*run)
    assert tricontact.open(tmp_path / "out").models == ["mdr"]
    left = {path.name for path in (tmp_path / "out" / "mdr").iterdir()}
    assert left == {"history.csv", "surface.ex2", "indenter.ex2", "surface_000000.csv"}


def test_folders_of_other_commands_are_opened(rig, tmp_path):
    limit = tricontact.limit(rig, overrides=SMALL, tolerance=0.1, output=tmp_path / "limit")
    opened = tricontact.open(tmp_path / "limit")
    assert opened.command == "limit" and dict(opened) == dict(limit) and "mdr" in opened


def test_what_is_no_folder_of_results_is_refused(rig, tmp_path):
    with pytest.raises(tricontact.InputError, match="holds no results of a command; give the folder"):
        tricontact.open(tmp_path)
    with pytest.raises(tricontact.InputError, match="is no folder"):
        tricontact.open(rig)
    (tmp_path / "summary.json").write_text("{")
    with pytest.raises(tricontact.InputError, match="summary.json: is no JSON; the results are damaged"):
        tricontact.open(tmp_path)


FOREIGN = {
    "package.json": ('{"name": "left-pad", "version": "1.3.0"}', "holds no results of a command; give the folder"),
    "summary.json": ('{"models": {"a": 1}}', "summary.json: was not written by tricontact run, it has no case; give"),
    "limit.json": ("[1, 2]", "limit.json: was not written by tricontact limit"),
    "results.csv": ("a,b\n1,2\n", "results.csv: is no table of a study; give"),
    "table.csv": ("a,b\n1,2\n", "holds no results of a command"),
}


@pytest.mark.parametrize("name", FOREIGN)
def test_folders_of_others_are_refused(name, tmp_path):
    text, message = FOREIGN[name]
    (tmp_path / name).write_text(text)
    with pytest.raises(tricontact.InputError, match=message):
        tricontact.open(tmp_path)
    # Damaged ones, too.
    (tmp_path / "results.csv").write_bytes(b"a,b\n\xff\n")
    with pytest.raises(tricontact.InputError):
        tricontact.open(tmp_path)


def test_foreign_files_beside_results_are_left_alone(rig, tmp_path):
    limit = tricontact.limit(rig, overrides=SMALL, tolerance=0.1, output=tmp_path / "limit")
    (tmp_path / "limit" / "notes.json").write_text(json.dumps({"models": "mine"}))
    assert dict(tricontact.open(tmp_path / "limit")) == dict(limit)


def test_rolling_and_walking_iterate_print_pickle_and_compare(examples):
    cylinder, machine = (examples / "cases" / f"{name}.toml" for name in ("rolling_cylinder", "walking_set_b"))
    rolling = tricontact.roll(cylinder, overrides=ON, points=2)
    walk = tricontact.walk(machine, time__end=100)
    for one in (rolling, walk):
        again = pickle.loads(pickle.dumps(one))
        assert again == one and not one != again and one != 1
        assert " at 0x" not in repr(one) and repr(again) == repr(one)
        assert again._repr_html_() == one._repr_html_() and "<table>" in one._repr_html_()
    assert list(rolling) == rolling.models == ["bem"] and "bem" in rolling and "mdr" not in rolling
    assert len(rolling) == 1 and rolling["bem"] == rolling.histories["bem"]
    with pytest.raises(KeyError, match="no model mdr; there are bem"):
        rolling["mdr"]
    # Given: F_T/(mu F_N) = 1/2.
    assert rolling.steady["bem"]["force_ratio"] == pytest.approx(0.5, rel=1e-9)
    assert "at force ratio 0.5" in repr(rolling)
    assert tricontact.roll(cylinder, overrides=ON, points=3) != rolling
    assert walk["regime"] == walk.summary["regime"] and "regime" in walk and len(walk) == len(list(walk))
    assert repr(walk).startswith(f"<Walk: {walk['regime']}")
    assert tricontact.walk(machine, time__end=101) != walk
    with pytest.raises(KeyError, match="no number regimes; there are version"):
        walk["regimes"]


def test_rolling_and_walking_plot(examples):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    rolling = tricontact.roll(examples / "cases" / "rolling_cylinder.toml", overrides=ON, points=2)
    lines = rolling.plot().lines
    assert [line.get_label() for line in lines] == list(dict.fromkeys(rolling.creep["model"]))
    np.testing.assert_array_equal(np.sort(lines[0].get_ydata()),
                                  np.sort(rolling.creep["force_ratio_x"][rolling.creep["model"] == "bem"]))
    walk = tricontact.walk(examples / "cases" / "walking_set_b.toml", time__end=100)
    np.testing.assert_array_equal(walk.plot("z").lines[0].get_ydata(), walk.motion["z"])
    pyplot.close("all")
    assert "data:image/png" in walk._repr_html_() and "data:image/png" in rolling._repr_html_()
