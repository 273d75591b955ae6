"""Cases from files and dictionaries, and what is said of bad ones."""

import os
from pathlib import Path

import numpy as np
import pytest

import tricontact

VALUES = {
    "models": ["mdr", "bem"],
    "indenter": {"radius": "40 mm"},
    "substrate": {"young": "5.2 MPa", "poisson": 0.5},
    "friction": {"coefficient": 0.57},
    "load": {"normal_force": "21.1 N", "tangential_ratio": 0.56},
    "rolling": {"amplitude_ratio": 0.24, "periods": 3},
}


def test_is_the_installed_copy(examples):
    assert Path(tricontact.__file__).is_relative_to(examples.parents[2])


def test_dictionary_and_file_give_the_same_case(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(
        'models = ["mdr", "bem"]\nindenter.radius = "40 mm"\n'
        '[substrate]\nyoung = "5.2 MPa"\npoisson = 0.5\n[friction]\ncoefficient = 0.57\n'
        '[load]\nnormal_force = "21.1 N"\ntangential_ratio = 0.56\n'
        "[rolling]\namplitude_ratio = 0.24\nperiods = 3\n"
    )
    from_file = tricontact.Case.from_file(file)
    assert tricontact.Case.from_dict(VALUES).to_toml() == from_file.to_toml()
    assert tricontact.Case.from_file(str(file)).to_toml() == from_file.to_toml()


def test_resolved_case_reads_back(examples):
    for file in (examples / "cases").glob("rig_*.toml"):
        case = tricontact.Case.from_file(file)
        again = tricontact.Case.from_dict(case.to_dict())
        assert again.to_toml() == case.to_toml(), file.name


def test_overrides_are_those_of_the_program(rig):
    case = tricontact.Case.from_file(rig, {"load.indentation": "0.5 mm", "models": ["mdr"]})
    assert case.models == ["mdr"]
    assert case.to_dict()["load"]["indentation"] == "5e-04 m"
    assert "normal_force" not in case.to_dict()["load"]  # its alternative


def test_numpy_values_are_values():
    values = {**VALUES, "friction": {"coefficient": np.float64(0.57)}}
    values["rolling"] = {"amplitude_ratio": np.float32(0.25), "periods": np.int64(3)}
    values["models"] = np.array(["mdr", "bem"])
    case = tricontact.Case.from_dict(values)
    assert case.to_dict()["rolling"]["periods"] == 3
    assert case.to_dict()["rolling"]["amplitude_ratio"] == 0.25


@pytest.mark.parametrize("text", ['quote " and \\', "two\nlines", "\u00e4\u4e2d", "tab\t, del\x7f"])
def test_texts_survive(text):
    assert tricontact.Case.from_dict({**VALUES, "title": text}).title == text


@pytest.mark.parametrize("value", [None, object(), {1: 2}, float])
def test_values_without_a_place_in_toml_are_refused(value):
    with pytest.raises(TypeError, match="TOML has texts, numbers"):
        tricontact.Case.from_dict({**VALUES, "title": value})


def test_errors_have_the_texts_of_the_program(rig, program, tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text(rig.read_text().replace("poisson = 0.5", "poisson = 0.6"))
    with pytest.raises(tricontact.InputError) as error:
        tricontact.Case.from_file(bad)
    assert program("check", bad, code=2) == f"error: {error.value}\n"
    assert isinstance(error.value, ValueError)
    assert "substrate.poisson = 0.6" in str(error.value)


def test_errors_of_a_dictionary_name_the_key():
    with pytest.raises(tricontact.InputError, match="unknown key indenter.raduis"):
        tricontact.Case.from_dict({**VALUES, "indenter": {"raduis": "40 mm"}})


def test_a_missing_file_is_bad_input(tmp_path):
    with pytest.raises(tricontact.InputError, match="nowhere.toml"):
        tricontact.Case.from_file(tmp_path / "nowhere.toml")


def test_a_walking_machine_is_a_case_of_its_own(examples):
    file = examples / "cases" / "walking_set_b.toml"
    with pytest.raises(tricontact.InputError, match="tricontact run computes it"):
        tricontact.Case.from_file(file)
    assert tricontact.WalkCase.from_file(file).to_dict()["machine"]["kappa1"] == 2


def test_half_characters_are_refused(rig, tmp_path):
    half = "\ud800"
    for call in (lambda: tricontact.Case.from_dict({**VALUES, "title": half}),
                 lambda: tricontact.Case.from_dict({**VALUES, half: 1}),
                 lambda: tricontact.Case.from_file(rig, {"title": half}),
                 lambda: tricontact.Case.from_file(half),
                 lambda: tricontact.run(half),
                 lambda: tricontact.limit(rig, overrides={"title": half}),
                 lambda: tricontact.rig(half),
                 lambda: tricontact.sweep(half, tmp_path / "out"),
                 lambda: tricontact.atlas.load(half)):
        with pytest.raises(tricontact.InputError, match="holds half a character"):
            call()


def test_files_may_have_names_that_are_no_text(rig, tmp_path):
    file = os.fsencode(tmp_path) + b"/\xff.toml"
    Path(os.fsdecode(file)).write_bytes(rig.read_bytes())
    assert tricontact.Case.from_file(os.fsdecode(file)).title == tricontact.Case.from_file(rig).title
    assert tricontact.Case.from_file(file).models == ["mdr", "bem"]
