"""Every command with a file, a case and a dictionary; keys as keywords; results kept and opened."""

import pickle

import numpy as np
import pytest

import tricontact

SMALL = {"rolling.steps": "turning-points", "rolling.periods": 1, "mdr.springs": 300, "models": ["mdr"]}
# Of each command a cheap call, from its input.
CALLS = {
    "run": lambda case: tricontact.run(case, overrides=SMALL, studies=False),
    "limit": lambda case: tricontact.limit(case, overrides=SMALL, tolerance=0.1),
    "predict": lambda case: tricontact.predict(case),
    "deviation": lambda case: tricontact.deviation(case, no_runs=True),
    "refine": lambda case: tricontact.refine(
        case, models=["bem"], levels=3, overrides={"models": ["bem"], "rolling.periods": 1,
                                                   "rolling.steps": "turning-points", "bem.spacing": "1 mm"}),
}
LAYERED = {"deviation"}


@pytest.fixture
def file_of(examples):
    def found(name):
        return examples / "cases" / f"rig_{'layer' if name in LAYERED else 'sphere'}_parallel.toml"
    return found


@pytest.mark.parametrize("name", CALLS)
def test_a_file_a_case_and_a_dictionary_give_the_same(name, file_of):
    file = file_of(name)
    case = tricontact.Case.from_file(file)
    expected = CALLS[name](file)
    for given in (case, case.to_dict()):
        assert CALLS[name](given) == expected


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
