"""Sweeps: the program's own, from Python."""

import contextlib
import os
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest

import tricontact

STUDY = """
case = "{rig}"
models = ["mdr", "bem"]
[set]
rolling.steps = "turning-points"
rolling.periods = 2
bem.spacing = "0.5 mm"
[vary]
rolling.amplitude_ratio = [0.1, 0.24]
load.tangential_ratio = [0.1, 0.24, 0.56]
"""


@pytest.fixture
def study(rig, tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY.format(rig=rig))
    return file


def test_table_is_that_of_the_program(study, rig, program, tmp_path):
    # Threads of an earlier run must not be missed in the sweep's processes.
    case = tricontact.Case.from_file(rig, {"rolling.periods": 1, "bem.spacing": "0.4 mm"})
    tricontact.run(case, models=["bem"], threads=2, studies=False)
    table = tricontact.sweep(study, tmp_path / "python", jobs=2)
    program("sweep", study, "--output", "program", "--jobs", 2, "--quiet")
    text = (tmp_path / "program" / "results.csv").read_text()
    assert (tmp_path / "python" / "results.csv").read_text() == text
    assert len(table["model"]) == 12 and set(table["model"]) == {"mdr", "bem"}
    assert table["load.tangential_ratio"].dtype == float
    assert (tmp_path / "python" / "report.html").exists()
    # U_stat/U_max = 1 - (1 - f)^(2/3): of springs exactly but for the edge of the stick zone.
    springs = table["model"] == "mdr"
    static = 1 - (1 - table["load.tangential_ratio"][springs]) ** (2 / 3)
    np.testing.assert_allclose(table["static_shift_ratio"][springs], static, rtol=1e-3)
    again = tricontact.read_table(tmp_path / "python" / "results.csv")
    np.testing.assert_array_equal(again["model"], table["model"])


def test_finished_points_are_not_computed_again(study, tmp_path):
    tricontact.sweep(study, tmp_path / "out", jobs=1, report=False)
    assert not (tmp_path / "out" / "report.html").exists()
    store = (tmp_path / "out" / "results.sqlite").read_bytes()  # holds the times of computing
    tricontact.sweep(study, tmp_path / "out", jobs=2, report=False)
    assert (tmp_path / "out" / "results.sqlite").read_bytes() == store


def test_progress_counts_points(study, tmp_path):
    heard = []
    tricontact.sweep(study, tmp_path / "out", jobs=2, report=False, progress=lambda *told: heard.append(told))
    assert {(name, total) for name, _, total in heard} == {("sweep", 12)}
    assert [done for _, done, _ in heard] == sorted(done for _, done, _ in heard) and heard[-1][1] == 12
    heard.clear()
    tricontact.sweep(study, tmp_path / "out", report=False, progress=lambda *told: heard.append(told))
    assert not heard  # all are there


def test_failed_points_are_told_and_stand_in_the_table(rig, tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(
        f'case = "{rig}"\nmodels = ["mdr"]\n[set]\nload.indentation = "0.5 mm"\n'
        '[vary]\nload.tangential_force = ["1 N", "4000 N"]\n'  # the second one would slide
    )
    with pytest.raises(RuntimeError, match="1 of 2 points failed"):
        tricontact.sweep(file, tmp_path / "out", jobs=1, report=False)
    errors = tricontact.read_table(tmp_path / "out" / "results.csv")["error"]
    assert errors[0] == "" and errors[1] != ""


def test_bad_studies_are_refused(tmp_path, study):
    study.write_text(study.read_text().replace("0.24, 0.56", "0.24, 1.5"))
    with pytest.raises(tricontact.InputError, match="load.tangential_ratio"):
        tricontact.sweep(study, tmp_path / "out")
    assert not (tmp_path / "out").exists()
    with pytest.raises(ValueError, match="jobs"):
        tricontact.sweep(study, tmp_path / "out", jobs=0)


def processes_of(session):
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(ProcessLookupError):
            if os.getsid(int(name)) == session:
                found.append(int(name))
    return found


def test_interrupted_sweeps_go_on(study, tmp_path):
    text = study.read_text().replace("0.5 mm", "0.1 mm").replace("periods = 2", "periods = 100")
    study.write_text(text.replace("[vary]", "rolling.run_all = true\n[vary]"))
    script = f"""
import threading, tricontact
threading.Timer(0.5, lambda: print("on", flush=True)).start()
try:
    tricontact.sweep({str(study)!r}, {str(tmp_path / "out")!r}, jobs=2, report=False)
except KeyboardInterrupt:
    print("interrupted")
"""
    child = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, start_new_session=True
    )
    assert child.stdout.readline() == "on\n"
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=60)[0] == "interrupted\n"
    assert processes_of(child.pid) == []  # none outlives the sweep
    text = study.read_text().replace("0.1 mm", "0.5 mm").replace("periods = 100", "periods = 1")
    study.write_text(text)
    table = tricontact.sweep(study, tmp_path / "out", jobs=2, report=False)
    assert np.all(np.isnan(table["error"]))  # there are none


def test_from_a_thread_of_its_own(study, tmp_path):
    tables = []

    def sweep():
        tables.append(tricontact.sweep(study, tmp_path / "out", jobs=1, report=False))

    thread = threading.Thread(target=sweep)
    thread.start()
    thread.join()
    assert len(tables[0]["model"]) == 12


def test_a_dictionary_is_a_study(rig, study, tmp_path):
    values = {
        "case": str(rig),
        "models": ["mdr", "bem"],
        "set": {"rolling": {"steps": "turning-points", "periods": 2}, "bem": {"spacing": "0.5 mm"}},
        "vary": {"rolling": {"amplitude_ratio": [0.1, 0.24]}, "load": {"tangential_ratio": [0.1, 0.24, 0.56]}},
    }
    tricontact.sweep(values, tmp_path / "values", jobs=2, report=False)
    tricontact.sweep(study, tmp_path / "file", jobs=2, report=False)
    table = [(tmp_path / name / "results.csv").read_text() for name in ("values", "file")]
    assert table[0] == table[1]
    fitted = [tricontact.fit(given, tmp_path / name)["kappa"] for given, name in ((values, "values"), (study, "file"))]
    assert fitted[0] == fitted[1]
    for call in (tricontact.sweep, tricontact.fit, tricontact.atlas.build):
        with pytest.raises(tricontact.InputError, match="<dict>: .* has no name for its folder; name one by output"):
            call(values)
    with pytest.raises(tricontact.InputError, match="^<dict>"):
        tricontact.sweep({**values, "vari": {}}, tmp_path / "wrong")
