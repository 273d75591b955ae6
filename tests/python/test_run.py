"""Runs beside closed forms, conservation laws, and the program's own files."""

import copy
import csv
import gc
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import tricontact

COARSE = {"rolling.steps": "turning-points", "rolling.periods": 2, "bem.spacing": "0.5 mm"}


@pytest.fixture
def case(rig):
    return tricontact.Case.from_file(rig, COARSE)


def test_springs_agree_with_closed_forms(rig):
    settings = {"rolling.steps": "turning-points", "rolling.periods": 200}
    case = tricontact.Case.from_file(rig, settings)
    history = tricontact.run(case, models=["mdr"])["mdr"]
    # MDR is exact for paraboloids; 10000 springs resolve the edges of contact and stick to 1e-4.
    assert history.scales.contact_radius == pytest.approx(case.scales.contact_radius, rel=1e-4)
    assert history.scales.peak_pressure == pytest.approx(case.scales.peak_pressure, rel=1e-3)
    unit = history.scales.unit_shift
    assert history.static_shift / unit == pytest.approx(1 - (1 - 0.56) ** (2 / 3), rel=1e-3)
    settled = tricontact.theory.settled_shift_ratio(0.24, 0.56)
    assert history.shift_per_period[-1] / unit == pytest.approx(settled, rel=1e-3)
    assert history.state == "shakedown"


def test_columns_are_those_of_the_file(case, rig, program, tmp_path):
    result = tricontact.run(case, studies=False)
    settings = [text for key, value in COARSE.items() for text in ("--set", f"{key}={value}")]
    program("run", rig, *settings, "--quiet", "--no-report", "--no-studies", "--output", "out")
    for model in ("mdr", "bem"):
        history = result[model]
        with open(tmp_path / "out" / model / "history.csv", newline="") as file:
            names, *rows = csv.reader(file)
        assert ["step", *history.columns] == names
        assert len(history) == len(rows)
        for k, name in enumerate(history.columns):
            # The file's digits read back the same.
            np.testing.assert_array_equal(history[name], [float(row[k + 1]) for row in rows])


@pytest.mark.parametrize(
    "name, models", [("rig_sphere_parallel", "mdr,bem"), ("rig_layer_parallel", "mdr-layer")]
)
def test_summary_is_that_of_the_program(name, models, examples, program, tmp_path, summary_of):
    file = examples / "cases" / f"{name}.toml"
    overrides = {**COARSE, "rolling.periods": 1}
    case = tricontact.Case.from_file(file, {**overrides, "models": models.split(",")})
    settings = [text for key, value in overrides.items() for text in ("--set", f"{key}={value}")]
    program("run", file, *settings, "--models", models, "--quiet", "--no-report", "--output", "out")
    summary = tricontact.run(case).summary
    assert summary_of(summary) == summary_of(tmp_path / "out" / "summary.json")


def test_models_are_checked_as_those_of_a_file(case):
    assert tricontact.run(case, models=["mdr"]).models == ["mdr"]
    with pytest.raises(tricontact.InputError, match="mdr-layer"):
        tricontact.run(case, models=["mdr-layer"])  # it has no layer
    with pytest.raises(tricontact.InputError, match="fme"):
        tricontact.run(case, models=["fme"])
    with pytest.raises(ValueError, match="threads"):
        tricontact.run(case, threads=0)


def test_arrays_share_the_memory_of_the_run(case):
    result = tricontact.run(case, models=["bem"])
    history = result["bem"]
    column = history["shift_x_m"]
    pressure = history.snapshots[-1].surface["normal_traction_Pa"]
    for array in (column, pressure, history.shift_per_period):
        assert not array.flags.owndata
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    assert np.shares_memory(column, history["shift_x_m"])
    assert np.shares_memory(pressure, result["bem"].snapshots[-1].surface["normal_traction_Pa"])
    kept = column.copy(), pressure.copy()
    del result, history
    gc.collect()
    np.empty_like(pressure).fill(1)  # where it was, had it gone
    np.testing.assert_array_equal(column, kept[0])
    np.testing.assert_array_equal(pressure, kept[1])


def test_surfaces_are_grids_by_rows(case):
    history = tricontact.run(case, models=["bem"])["bem"]
    turned = max(history.snapshots, key=lambda snapshot: snapshot.surface.offset[0]).surface
    pressure = turned["normal_traction_Pa"]
    assert pressure.shape == turned.shape == (len(turned.y), len(turned.x))
    cell = (turned.x[1] - turned.x[0]) * (turned.y[1] - turned.y[0])
    force = history["normal_force_N"][-1]
    # The solver balances forces to 1e-7; the centre lies within rounding of a symmetric sum, plus
    # the cells that the edge of the contact cuts differently: a tenth of a cell.
    assert pressure.sum() * cell == pytest.approx(force, rel=1e-6)
    centre_x = (pressure @ turned.x).sum() / pressure.sum()
    centre_y = (turned.y @ pressure).sum() / pressure.sum()
    assert centre_x == pytest.approx(turned.offset[0], abs=0.05e-3)
    assert centre_y == pytest.approx(0, abs=0.05e-3)
    assert turned.offset[0] > 1e-3
    states = turned["contact_state"]
    assert states.dtype == np.uint8 and set(np.unique(states)) == {0, 1, 2}
    assert np.all((states > 0) == (pressure > 0))
    with pytest.raises(KeyError):
        turned["normal_line_load_N_per_m"]  # of springs
    with pytest.raises(KeyError):
        history["shift_z_m"]


def test_without_rolling_there_is_no_state(rig):
    values = tricontact.Case.from_file(rig).to_dict()
    del values["rolling"]
    history = tricontact.run(tricontact.Case.from_dict(values), models=["mdr"])["mdr"]
    assert history.state is None and len(history.shift_per_period) == 0


def test_pandas(case):
    pytest.importorskip("pandas")
    history = tricontact.run(case, models=["mdr"])["mdr"]
    frame = history.to_pandas()
    assert list(frame.columns) == history.columns
    np.testing.assert_array_equal(frame["shift_x_m"], history["shift_x_m"])


def test_not_converged(rig, program):
    # Rounding forbids a residual of 1.1e-14.
    settings = {**COARSE, "bem.tolerance": 1.1e-14}
    case = tricontact.Case.from_file(rig, settings)
    with pytest.raises(tricontact.NotConverged) as error:
        tricontact.run(case, models=["bem"])
    arguments = [text for key, value in settings.items() for text in ("--set", f"{key}={value}")]
    said = program("run", rig, *arguments, "--models", "bem", "--quiet", code=1)
    assert said == f"error: {error.value}\n"
    assert isinstance(error.value, RuntimeError)


def test_steps_are_told_and_may_end_the_run(case):
    told = []
    history = tricontact.run(case, models=["mdr"], on_step=lambda *step: told.append(step))["mdr"]
    assert [step[1] for step in told] == list(range(1, len(history) + 1))
    assert {(step[0], step[2]) for step in told} == {("mdr", len(history))}

    def stop(model, step, steps):
        if step == 3:
            raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        tricontact.run(case, models=["mdr"], on_step=stop)


def test_other_threads_go_on(rig):
    case = tricontact.Case.from_file(rig, {"rolling.periods": 1, "bem.spacing": "0.2 mm"})
    beats = []
    done = threading.Event()

    def beat():
        while not done.wait(0.005):
            beats.append(time.monotonic())

    thread = threading.Thread(target=beat)
    thread.start()
    began = time.monotonic()
    tricontact.run(case, models=["bem"], threads=1, studies=False)
    ended = time.monotonic()
    done.set()
    thread.join()
    # Were the lock held, there would be none between the first and the last fifth of the run.
    fifth = (ended - began) / 5
    assert any(began + fifth < beat < ended - fifth for beat in beats)


def test_interrupt_ends_the_run_between_steps(rig):
    script = f"""
import tricontact
case = tricontact.Case.from_file({str(rig)!r}, {{"rolling.periods": 1000, "rolling.run_all": True}})
def tell(model, step, steps):
    if step == 3:
        print("on", flush=True)
try:
    tricontact.run(case, models=["bem"], on_step=tell)
except KeyboardInterrupt:
    case = tricontact.Case.from_file({str(rig)!r}, {{"rolling.periods": 1}})
    print("interrupted", len(tricontact.run(case, models=["mdr"])["mdr"]))
"""
    child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "on\n"
    child.send_signal(signal.SIGINT)
    # A run of 1000 periods would take an hour; after the interrupt the module is as good as before.
    said, _ = child.communicate(timeout=120)
    assert said.startswith("interrupted ") and child.returncode == 0


def test_finite_elements_are_found(examples, program):
    file = examples / "cases" / "rig_layer_parallel.toml"
    settings = {**COARSE, "rolling.periods": 1, "load.press_steps": 2, "fem.size": "2 mm", "fem.cache": "none"}
    try:
        case = tricontact.Case.from_file(file, {**settings, "models": ["fem"]})
        history = tricontact.run(case, studies=False)["fem"]
    except tricontact.InputError as error:
        assert "built without the model fem" in str(error)
        pytest.skip("built without finite elements")
    exact = tricontact.theory.layer_contact(case)
    # Elements of 2 mm in a contact of some 4 mm radius: force within some percent.
    assert history.scales.indentation == pytest.approx(exact.indentation, rel=0.05)
    assert history.snapshots[0].surface.layout == "nodes"


def test_files_and_dictionaries_are_cases(rig):
    settings = {**COARSE, "models": ["mdr"], "rolling.periods": 1}
    expected = tricontact.run(tricontact.Case.from_file(rig, settings), studies=False)
    whole = tricontact.Case.from_file(rig)
    for given in (rig, str(rig), whole, whole.to_dict()):
        result = tricontact.run(given, overrides=settings, studies=False)
        assert result.case.to_toml() == expected.case.to_toml()
        np.testing.assert_array_equal(result["mdr"]["shift_x_m"], expected["mdr"]["shift_x_m"])
    with pytest.raises(tricontact.InputError, match="No such file"):
        tricontact.run("missing.toml")
    with pytest.raises(TypeError, match="3 is no case: give a file, a Case or a dictionary"):
        tricontact.run(3)


def test_errors_name_what_there_is(case):
    result = tricontact.run(case, models=["mdr"], studies=False)
    for call in (result.__getitem__, result.surfaces, result.results):
        with pytest.raises(KeyError, match="no model bem; there are mdr"):
            call("bem")
    with pytest.raises(KeyError, match="no column shift; there are .*shift_x_m"):
        result["mdr"]["shift"]
    with pytest.raises(KeyError, match="no field pressure; there are .*normal_traction_Pa"):
        result["mdr"].snapshots[-1].surface["pressure"]


def test_export_fills_a_folder_whose_archive_runs_again(rig, tmp_path):
    settings = {**COARSE, "rolling.periods": 1, "mdr.springs": 500}
    result = tricontact.run(rig, models=["mdr"], overrides=settings, studies=False, export=tmp_path / "paper")
    assert (tmp_path / "paper" / "references.bib").exists()
    again = tricontact.reproduce(tmp_path / "paper" / "archive.zip", output=tmp_path / "again")
    assert again["reproduces"]
    shift = (tmp_path / "again" / "results" / "mdr" / "history.csv").read_text().splitlines()
    column = shift[0].split(",").index("shift_x_m")
    assert float(shift[-1].split(",")[column]) == result["mdr"]["shift_x_m"][-1]


def test_objects_come_from_functions_alone(case):
    classes = [thing for thing in vars(tricontact._core).values()
               if isinstance(thing, type) and not issubclass(thing, Exception)]
    assert tricontact.History in classes and len(classes) > 8
    for one in classes:
        for call in (one, lambda one=one: one.__new__(one), lambda one=one: object.__new__(one)):
            with pytest.raises(TypeError):
                call()
    history = tricontact.run(case, models=["mdr"], studies=False)["mdr"]
    assert copy.copy(history) == history  # its content, apart from the run


def test_the_drive_of_a_rig_has_its_columns(tmp_path):
    file = tmp_path / "loop.toml"
    file.write_text("""
models = ["mdr"]
indenter = {radius = "40 mm"}
substrate = {young = "5.2 MPa", poisson = 0.5}
friction.coefficient = 0.6
rig.tangential_stiffness = "1 N/um"
[path]
steps = 4
table = '''
normal_force [N], shift_x [um]
20, 0
20, 50
20, -50
20, 50
'''
""")
    history = tricontact.run(tricontact.Case.from_file(file), studies=False)["mdr"]
    assert history.columns[-3:] == ["drive_shift_x_m", "drive_shift_y_m", "drive_indentation_m"]
    drive = history["shift_x_m"] + history["tangential_force_x_N"] / 1e6
    np.testing.assert_array_equal(history["drive_shift_x_m"], drive)
    assert drive[-1] == pytest.approx(50e-6, rel=1e-12)
    with pytest.raises(ValueError):
        history["drive_shift_x_m"][0] = 1
