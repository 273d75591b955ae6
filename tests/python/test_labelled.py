"""Labels of results: units, xarray, pint, plots, notebooks."""

import json

import numpy as np
import pytest

import tricontact
from tricontact import _core, labels, progress

COARSE = {"rolling.steps": "turning-points", "rolling.periods": 2, "bem.spacing": "0.5 mm"}


@pytest.fixture(scope="module")
def result():
    from conftest import COPY

    rig = COPY / "share" / "tricontact" / "examples" / "cases" / "rig_sphere_parallel.toml"
    return tricontact.run(tricontact.Case.from_file(rig, COARSE), studies=False, surfaces="all")


def test_units_of_names_and_declarations_agree():
    # The rule for names that no declaration has gives what the declarations say of theirs.
    declared = [name for name in vars(tricontact.Results) if not name.startswith("_")]
    rule = labels._SUFFIX
    for name in declared:
        unit = labels.label_of(name).unit
        match = rule.search(name)
        assert (labels._unit(*match.groups()) if match else "1") == unit, name


@pytest.mark.parametrize(
    "name, unit",
    [
        ("shift_x_m", "m"),
        ("normal_traction_Pa", "Pa"),
        ("dissipation_J_per_m2", "J/m2"),
        ("normal_line_load_N_per_m", "N/m"),
        ("rolling.amplitude_m", "m"),
        ("tangential_ratio", "1"),
        ("model", ""),
    ],
)
def test_units(name, unit):
    assert labels.label_of(name).unit == unit


def test_datasets(result):
    pytest.importorskip("xarray")
    history = result["bem"].to_xarray()
    assert history["shift_x_m"].dims == ("step",) and history["shift_x_m"].attrs["units"] == "m"
    np.testing.assert_array_equal(history["shift_x_m"], result["bem"]["shift_x_m"])
    models = result.to_xarray()
    assert list(models["model"].values) == ["mdr", "bem"]
    # What the program puts into summary.json.
    for model in result.models:
        value = models["static_shift_m"].sel(model=model).item()
        assert value == result.summary["models"][model]["static_shift_m"]
    surface = result["bem"].snapshots[-1].surface.to_xarray()
    cell = float(surface.x[1] - surface.x[0]) * float(surface.y[1] - surface.y[0])
    force = surface["normal_traction_Pa"].sum(("y", "x")).item() * cell
    assert force == pytest.approx(21.1, rel=1e-6)  # F_N of the case; the solver's tolerance is 1e-7


def test_surfaces_of_all_steps(result):
    history, surfaces = result["bem"], result.surfaces("bem")
    assert len(surfaces) == len(history) > len(history.snapshots)
    np.testing.assert_array_equal(surfaces.phases, history["phase"])
    data = surfaces.to_xarray() if pytest.importorskip("xarray") else None
    assert data["normal_traction_Pa"].dims == ("instant", "y", "x")
    # Coulomb at each point of each step: |tau| <= mu p, to the tolerance of the solver.
    bound = data["friction_bound_Pa"]
    traction = np.hypot(data["tangential_traction_x_Pa"], data["tangential_traction_y_Pa"])
    assert float((traction - bound).max()) <= 1e-6 * float(bound.max())
    quarters = tricontact.run(result.case, models=["bem"], studies=False)
    assert len(quarters.surfaces("bem")) == len(quarters["bem"].snapshots)
    with pytest.raises(KeyError):
        result.surfaces("fem")


def last_state(path):
    """Fields of the last state of a file for ParaView, in the file's order, as VTK reads them."""
    vtk = pytest.importorskip("vtkmodules.vtkIOExodus")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.SetSqueezePoints(False)
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.UpdateTimeStep(reader.GetExecutive().GetOutputInformation(0).Get(
        reader.GetExecutive().TIME_STEPS())[-1])
    data = reader.GetOutput().GetBlock(0).GetBlock(0).GetPointData()
    return {data.GetArrayName(i).removesuffix("_"): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())}


def test_signs_are_those_of_the_files_for_paraview(rig, program, tmp_path):
    settings = [text for key, value in COARSE.items() for text in ("--set", f"{key}={value}")]
    program("run", rig, *settings, "--models", "bem", "--quiet", "--no-report", "--no-studies",
            "--output", "out")
    fields = last_state(tmp_path / "out" / "bem" / "surface.ex2")
    case = tricontact.Case.from_file(rig, COARSE)
    surface = tricontact.run(case, models=["bem"], studies=False)["bem"].snapshots[-1].surface
    for i, axis in enumerate("xyz"):
        np.testing.assert_array_equal(  # files are of single precision
            fields["elastic_displacement_m"][:, i], surface[f"displacement_{axis}_m"].ravel().astype(np.float32))
    assert surface["displacement_z_m"].min() < 0  # pressed in
    np.testing.assert_array_equal(
        fields["tangential_traction_Pa"][:, 0], surface["tangential_traction_x_Pa"].ravel().astype(np.float32))


def test_quantities_of_pint(rig):
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    case = tricontact.Case.from_file(rig, {
        "indenter.radius": 4.0 * unit.centimeter,
        "substrate.young": 5.2 * unit.newton / unit.millimeter**2,
        "rolling.angle": 30.0 * unit.degree,
        "substrate.poisson": unit.Quantity(0.5, ""),
    })
    plain = tricontact.Case.from_file(rig, {
        "indenter.radius": "40 mm", "substrate.young": "5.2 MPa", "rolling.angle": "30 deg",
    })
    assert case.scales.contact_radius == pytest.approx(plain.scales.contact_radius, rel=1e-12)
    with pytest.raises(tricontact.InputError, match="indenter.radius"):
        tricontact.Case.from_file(rig, {"indenter.radius": 1.0 * unit.newton})
    atlas = tricontact.atlas.load("sphere_half_space")
    at = {"amplitude_ratio": 0.24, "limit_fraction": 0.5, "poisson": 0.5}
    in_degrees = atlas("settled_shift_ratio", angle=45 * unit.degree, **at)
    assert in_degrees == pytest.approx(atlas("settled_shift_ratio", angle=np.pi / 4, **at))
    with pytest.raises(pint.DimensionalityError):
        atlas("settled_shift_ratio", angle=1 * unit.meter, **at)


def test_plots(result, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    history = result["bem"].plot()
    line = history.get_lines()[0]
    # In micrometres, as the axis says.
    np.testing.assert_allclose(line.get_ydata(), 1e6 * result["bem"]["shift_x_m"], rtol=1e-12)
    assert "µm" in history.get_ylabel()
    assert len(result.plot().get_lines()) == 2
    for model in result.models:
        result.surfaces(model).plot("tangential_traction_x_Pa").figure.savefig(tmp_path / model)
    table = tricontact.Table("a_m,b_Pa\n1e-3,2e6\n2e-3,3e6\n").plot()
    assert table.get_xlabel() == "a [mm]" and table.get_ylabel() == "b [MPa]"
    with pytest.raises(KeyError, match="no column c"):
        tricontact.Table("a,b\n1,2\n").plot(y="c")
    with pytest.raises(ValueError, match="two columns"):
        tricontact.Table("a\n").plot()


def test_notebooks_show_numbers_with_units(result):
    for shown in (result, result["bem"], result.case):
        assert "<" in shown._repr_html_()
    assert "21.1" in result["bem"]._repr_html_() and "<td>N</td>" in result["bem"]._repr_html_()
    table = tricontact.Table("name,a_m\n<b>,1\n")
    assert "&lt;b&gt;" in table._repr_html_() and "a_m [m]" in table._repr_html_()
    assert not progress.in_notebook()


def test_the_example_notebook_runs(examples, tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(examples.parent)
    notebook = json.loads((examples / "notebooks" / "shakedown.ipynb").read_text())
    names = {}
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for cell in cells:
        exec(compile("".join(cell["source"]), "shakedown.ipynb", "exec"), names)
    assert len(cells) >= 4 and not any(cell["outputs"] for cell in cells)
