"""Commands of the program in Python: the program's own files, its options, what ends them."""

import inspect
import json
import signal
import threading
import time

import numpy as np
import pytest

import tricontact
from tricontact import _core, benchmark, commands

COARSE = {"mdr.springs": 500, "rolling.steps": "turning-points"}
FUNCTIONS = {
    "limit": commands.limit,
    "refine": commands.refine,
    "deviation": commands.deviation,
    "predict": commands.predict,
    "experiment": commands.experiment,
    "identify": commands.identify,
    "rig": commands.rig,
    "design": commands.design,
    "fit": commands.fit,
    "atlas": commands.build_atlas,
    "reproduce": commands.reproduce,
    "benchmark deck": benchmark.deck,
    "benchmark compare": benchmark.compare,
    "compare": commands.compare,
    "new": commands.new,
}
# In Python a parameter of another name, what progress decides, what the result always has, or a function of its own
# (tricontact.examples).
OTHERWISE = {"--set": "overrides", "--quiet": None, "--json": None, "--list": None, "--defaults": None}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_options_are_those_of_the_program(name):
    expected = set()
    for option, *_ in _core._command_options(name):
        parameter = OTHERWISE.get(option, option.lstrip("-").replace("-", "_"))
        if parameter:
            expected.add(parameter)
    assert set(inspect.signature(FUNCTIONS[name]).parameters) - {"progress", "keys"} == expected


def test_numbers_are_those_of_the_program(rig, program, tmp_path):
    settings = [text for key, value in COARSE.items() for text in ("--set", f"{key}={value}")]
    options = ("--models", "mdr", "--tolerance", "0.01", "--quiet", "--output", "out")
    program("limit", rig, *settings, *options)
    limit = tricontact.limit(rig, overrides=COARSE, models=["mdr"], tolerance=0.01)
    assert dict(limit) == json.loads((tmp_path / "out" / "limit.json").read_text())
    assert limit["mdr"] == limit["models"]["mdr"]
    assert "<html" in limit.report and "MDR" in limit.text and limit.folder is None
    # A case instead of its file.
    case = tricontact.Case.from_file(rig, COARSE)
    again = tricontact.limit(case, models=["mdr"], tolerance=0.01)
    assert again["mdr"] == limit["mdr"]
    # The bracket is as narrow as asked for, around MDR's exact limit of shakedown (thesis).
    exact = tricontact.theory.shakedown_limit(0.24)
    assert limit["mdr"]["limit"] == pytest.approx(exact, abs=0.01)


def test_tables_have_units(rig):
    limit = tricontact.limit(rig, overrides=COARSE, models=["mdr"], tolerance=0.05)
    runs = limit.table("models/mdr/runs")
    assert runs.units["final_shift_m"] == "m" and runs.units["final_shift_ratio"] == "1"
    xarray = pytest.importorskip("xarray")
    data = limit.to_xarray("models/mdr/runs")
    assert isinstance(data, xarray.Dataset)
    assert data["final_shift_m"].attrs["units"] == "m"
    np.testing.assert_array_equal(data["value"].values, runs["value"])
    assert "<table>" in limit._repr_html_()
    with pytest.raises(KeyError, match="nothing.*limit"):
        limit.table("nothing")


def test_rig_and_design(examples):
    rig = tricontact.rig(examples / "rigs" / "sphere_parallel.toml")
    names = list(rig.table("assumptions")["name"])
    assert "half_space" in names and "quasi_static_drive" in names
    # Of the rig: a = (3 F_N R (1 - nu^2)/(4 E))^(1/3), against a rigid sphere but for 1e-5.
    radius = (3 * 21.1 * 0.04 * 0.75 / (4 * 5.2e6)) ** (1 / 3)
    computed = {one["name"]: one["computed"] for one in rig["printed"]}
    assert computed["contact_radius"]["result"]["value"] == pytest.approx(radius, rel=1e-4)
    design = tricontact.design(examples / "rigs" / "design_resolution.toml")
    assert len(design) > 0 and design.text


def test_wear(examples, rig):
    case = examples / "cases" / "fretting_wear.toml"
    worn = tricontact.wear(case, models=["mdr"], studies=False, wear__cycles=500, mdr__springs=400)
    states = worn.table("mdr/wear")
    assert states["cycles"][0] == 0 and states["cycles"][-1] == 500
    # Archard's law under Coulomb's: worn volume k_w times friction's work over mu, to the order of 400 springs.
    inputs = tricontact.Case.from_file(case).to_dict()
    k, unit = inputs["wear"]["coefficient"].split(maxsplit=1)
    assert unit == "m2/N"
    expected = float(k) * worn["mdr"]["wear_work_J"] / inputs["friction"]["coefficient"]
    assert worn["mdr"]["worn_volume_m3"] == pytest.approx(expected, rel=1e-4)
    assert len(worn.table("mdr/profiles")["r_m"]) > 10
    with pytest.raises(tricontact.InputError, match="tricontact.wear"):
        tricontact.run(case)
    with pytest.raises(tricontact.InputError, match="without .wear. nothing wears"):
        tricontact.wear(rig)


def test_identify_and_predict(examples, rig):
    found = tricontact.identify(examples / "measurements" / "rig_indentation.toml")
    assert "layer" in found.text
    predicted = tricontact.predict(rig)
    # Half-space, uncoupled springs: MDR is exact (thesis).
    exact = tricontact.theory.settled_shift_ratio(0.24, 0.56)
    assert predicted["mdr"]["settled_shift_ratio"] == pytest.approx(exact, rel=1e-6)


def test_files_stay_where_they_are_wanted(rig, tmp_path):
    folder = tmp_path / "limits"
    limit = tricontact.limit(rig, overrides=COARSE, models=["mdr"], tolerance=0.1, output=folder)
    assert limit.folder == folder and (folder / "report.html").exists()


def test_an_archive_runs_again(rig, tmp_path):
    paper = tmp_path / "paper"
    limit = tricontact.limit(rig, overrides=COARSE, models=["mdr"], tolerance=0.1, export=paper)
    assert (paper / "references.bib").exists() and list((paper / "figures").glob("*.pdf"))
    again = tricontact.reproduce(paper / "archive.zip", output=tmp_path / "again")
    assert again["reproduces"] and again["same_bytes"] and again["changed"] == []
    found = json.loads((tmp_path / "again" / "results" / "limit.json").read_text())
    assert found["models"] == limit["models"]
    with pytest.raises(tricontact.InputError, match="no zip archive"):
        tricontact.reproduce(rig)


def test_what_is_wrong_is_said_as_the_program_says_it(rig, tmp_path):
    with pytest.raises(tricontact.InputError, match="nowhere.toml"):
        tricontact.limit(tmp_path / "nowhere.toml")
    with pytest.raises(tricontact.InputError, match="tolerance"):
        tricontact.limit(rig, tolerance=2.0)
    with pytest.raises(tricontact.InputError, match="substrate.poisson"):
        tricontact.predict(rig, overrides={"substrate.poisson": 0.7})
    with pytest.raises(tricontact.InputError, match="--vary: moon not in"):
        tricontact.limit(rig, vary="moon")
    with pytest.raises(tricontact.InputError, match="^<dict>:1:1: missing key models"):
        tricontact.limit({"substrate": {"young": "1 MPa"}})


def test_progress_is_told_and_may_end_it(rig):
    told = []
    tricontact.run(
        tricontact.Case.from_file(rig, {**COARSE, "rolling.periods": 1}),
        models=["mdr"],
        progress=lambda *step: told.append(step),
    )
    assert told and told[-1][0] == "mdr" and 0 < told[-1][1] <= told[-1][2]

    class Enough(Exception):
        pass

    def enough(*_):
        raise Enough

    with pytest.raises(Enough):
        tricontact.refine(rig, models="bem", progress=enough, overrides={"models": ["bem"]})


def test_ctrl_c_ends_a_command(rig):
    # Without it: minutes. Other threads go on meanwhile, or nobody would send the signal.
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    begin = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        tricontact.limit(rig, models=["bem"], overrides={"bem.spacing": "0.05 mm"})
    assert time.monotonic() - begin < 60  # far from the minutes that it takes


def test_sweep_and_fit(examples, tmp_path):
    study = tmp_path / "amplitudes.toml"
    study.write_text(
        f"""case = "{examples}/cases/rig_sphere_parallel.toml"
models = ["mdr"]
[set]
mdr.springs = 1000
rolling.steps = "turning-points"
rolling.periods = 100
load.tangential_ratio = 0.4
[vary]
rolling.amplitude_ratio = [0.1, 0.2, 0.3]
"""
    )
    table = tricontact.sweep(study, tmp_path / "out", jobs=1)
    fit = tricontact.fit(study, tmp_path / "out")
    points = fit.table("points")
    assert points.n_rows == len(table["rolling.amplitude_ratio"])
    assert table.units["settled_shift_m"] == "m"


def test_a_first_case(tmp_path, examples):
    case = tricontact.Case.from_file(
        tricontact.new(tmp_path / "layer.toml", substrate__thickness="8 mm", overrides={"models": ["bem"]})
    )
    assert case.to_dict()["substrate"]["thickness"] == "0.008 m" and case.to_dict()["models"] == ["bem"]
    with pytest.raises(tricontact.InputError, match="exists already"):
        tricontact.new(tmp_path / "layer.toml")
    with pytest.raises(tricontact.InputError, match="substrate.poisson = 0.7"):
        tricontact.new(tmp_path / "wrong.toml", overrides={"substrate.poisson": 0.7})
    names = [one["name"] for one in tricontact.examples()]
    written = tricontact.new(tmp_path / "sphere.toml", example=names[names.index("rig_sphere_parallel")])
    assert written.read_text() == (examples / "cases" / "rig_sphere_parallel.toml").read_text()


def test_two_folders_of_results_are_compared(rig, program, tmp_path):
    for name, springs in ("a", 500), ("b", 1000):
        program("run", rig, "--models", "mdr", "--set", f"mdr.springs={springs}", "--output", name,
                "--quiet", "--no-studies", "--no-report")
    outcome = tricontact.compare(tmp_path / "a", tmp_path / "b", export=tmp_path / "paper")
    assert (tmp_path / "paper" / "archive.zip").is_file()
    assert [change["key"] for change in outcome["case_differences"]] == ["mdr.springs"]
    pair = outcome["pairs"][0]
    assert pair["a"] == "mdr" and pair["quantities"]["normal_force_N"]["relative"] == 0
    with pytest.raises(tricontact.InputError, match="summary.json"):
        tricontact.compare(tmp_path / "a", tmp_path)
