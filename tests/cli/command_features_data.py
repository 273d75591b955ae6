"""What command_features.py tries: the features of cases, each by two cases that differ in it, and the commands."""

# A sphere on rubber, rolled: coarse, and fast in every model.
base = {
    "models": '["bem"]',
    "indenter.radius": '"40 mm"',
    "substrate.young": '"5.2 MPa"',
    "substrate.poisson": "0.5",
    "friction.coefficient": "0.57",
    "load.normal_force": '"21.1 N"',
    "load.tangential_ratio": "0.4",
    "rolling.amplitude_ratio": "0.24",
    "rolling.steps_per_quarter": "1",
    "rolling.periods": "2",
    "bem.cells_per_radius": "6",
    "mdr.springs": "200",
    "output.vtk": '"none"',
}
keys_of_every_case = ["title", "models", "output.*", "bem.cells_per_radius", "bem.spacing", "bem.tolerance",
                      "bem.cell_ratio", "bem.cell_shift_x", "bem.cell_shift_y", "mdr.springs", "fem.accuracy", "fem.size", "fem.growth", "fem.tolerance", "fem.cache",
                      "indenter.radius", "indenter.shape", "substrate.young", "substrate.poisson",
                      "friction.coefficient", "load.normal_force", "load.tangential_ratio", "load.tangential_force"]

layer = {"substrate.thickness": '"8 mm"'}
height_map = "".join(" ".join(f"{((x / 10) ** 2 + (y / 10) ** 2) * 6.25:.4f}" for x in range(-30, 31, 2)) + "\n"
                     for y in range(-30, 31, 2))  # um, of a ball of 80 mm on 6 mm


def path(*columns, **values):
    """A table that presses, pulls and lets go; further columns as given, in three rows."""
    names = ["normal_force [N]", "tangential_force_x [N]", *columns]
    rows = [["21", "0"], ["21", "4"], ["21", values.get("force", "2")]]
    for column in columns:
        for row, value in zip(rows, values[column.split(" ")[0]]):
            row.append(value)
    return '"' + "\\n".join([", ".join(names), *(", ".join(row) for row in rows)]) + '"'


def feature(name, keys, words, one, other, base=None, over_for=None):
    return {"name": name, "keys": keys.split(), "words": [name, *words.split("|")], "one": one, "other": other,
            "base": base or {}, "over_for": over_for or {}}


no_load = {"load.*": None, "rolling.*": None, "tractive_rolling.*": None, "path.steps": "2"}
relaxing = {"substrate.relaxation.relative_moduli": "[0.4]", "substrate.relaxation.times": '["0.5 s"]',
            "load.press_time": '"0.5 s"'}
body = {"indenter.radius": None}
mapped = {**body, "indenter.shape": '"height-map"', "indenter.file": '"map.txt"', "indenter.spacing": '"0.2 mm"',
          "bem.cells_per_radius": None, "bem.spacing": '"0.4 mm"', "load.normal_force": '"1 N"',
          "rolling.amplitude_ratio": None, "rolling.amplitude": '"0.4 mm"'}
features = [
    feature("path", "path.*", "[path]|prescribed path|[tractive_rolling]", {**no_load, "path.table": path(force="2")},
            {**no_load, "path.table": path(force="1")}),
    feature("path with a force along y", "", "path|along y|[tractive_rolling]",
            {**no_load, "path.table": path("tangential_force_y [N]", tangential_force_y=["0", "0", "0"])},
            {**no_load, "path.table": path("tangential_force_y [N]", tangential_force_y=["0", "0", "1"])}),
    feature("path with a shift", "", "path|along y|shift|[tractive_rolling]",
            {**no_load, "path.table": path("shift_y [um]", shift_y=["0", "0", "5"])},
            {**no_load, "path.table": path("shift_y [um]", shift_y=["0", "0", "9"])}),
    feature("path with a twist", "", "path|twist|rotation|[tractive_rolling]",
            {**no_load, "path.table": path("rotation [mrad]", rotation=["0", "0", "0"])},
            {**no_load, "path.table": path("rotation [mrad]", rotation=["0", "0", "8"])}),
    feature("path with rolling", "", "path|offset|[tractive_rolling]",
            {**no_load, "path.table": path("offset_x [mm]", offset_x=["0", "0", "0"])},
            {**no_load, "path.table": path("offset_x [mm]", offset_x=["0", "0", "0.5"])}),
    feature("static load", "", "[rolling]|rolling", {"load.tangential_ratio": "0.4", "rolling.*": None},
            {"load.tangential_ratio": "0.5", "rolling.*": None}),
    feature("rolling angle", "rolling.angle", "rolling.angle|angle", {}, {"rolling.angle": '"90 deg"'}),
    feature("rolling steps", "rolling.steps rolling.steps_per_quarter rolling.increment rolling.periods rolling.until "
            "rolling.run_all rolling.amplitude rolling.amplitude_ratio rolling.amplitude_reference", "rolling.steps",
            {"rolling.steps_per_quarter": "1"}, {"rolling.steps_per_quarter": "3"}),
    feature("rolling on", "tractive_rolling.*", "tractive_rolling|rolling on|rolls on",
            {"rolling.*": None, "tractive_rolling.distance": "1.0"},
            {"rolling.*": None, "tractive_rolling.distance": "1.0", "tractive_rolling.lateral_creepage": "0.01"}),
    feature("oscillating normal force", "load.normal_*", "load.normal_amplitude_ratio|oscillat", {},
            {"load.normal_amplitude_ratio": "0.3"}),
    feature("oscillating tangential force", "load.tangential_amplitude_ratio load.tangential_phase",
            "load.tangential_amplitude_ratio|oscillat", {}, {"load.tangential_amplitude_ratio": "0.3"}),
    feature("prescribed depth", "load.indentation", "load.indentation|depth|indentation",
            {"load.normal_force": None, "load.indentation": '"0.1 mm"'},
            {"load.normal_force": None, "load.indentation": '"0.12 mm"'}),
    feature("load by its limit", "load.limit_fraction load.limit_excess", "load.limit_fraction|limit_fraction",
            {"load.tangential_ratio": None, "load.limit_fraction": "0.5"},
            {"load.tangential_ratio": None, "load.limit_fraction": "0.6"}),
    feature("pressing", "load.press load.press_steps", "load.press|pressed with friction", {},
            {"load.press": '"frictionless"'}, layer),
    feature("layer", "substrate.thickness substrate.thickness_ratio", "substrate.thickness|layer",
            {"substrate.thickness": '"8 mm"'}, {"substrate.thickness": '"6 mm"'}),
    feature("base that glides", "substrate.base", "substrate.base|base|substrate.thickness: ", layer,
            {**layer, "substrate.base": '"frictionless"'}),
    feature("ground", "ground.*", "[ground]|ground|rigid base|substrate.thickness: ", layer,
            {**layer, "substrate.base": '"half-space"', "ground.young": '"5 MPa"', "ground.poisson": "0.4"}),
    feature("lower layer", "lower_layer.*", "[lower_layer]|lower_layer|one layer|several layers|substrate.thickness: |rigid base", layer,
            {**layer, "lower_layer.thickness": '"4 mm"', "lower_layer.young": '"2 MPa"',
             "lower_layer.poisson": "0.45"}),
    feature("width", "substrate.width substrate.depth", "substrate.width|width|substrate.thickness: ", layer,
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"'}),
    feature("elastic indenter", "indenter.young indenter.poisson", "indenter.young|elastic indenter|rigid", {},
            {"indenter.young": '"20 MPa"', "indenter.poisson": "0.5"}),
    feature("coupled contact", "contact.coupling", "contact.coupling|coupl", {"contact.coupling": "false"},
            {"contact.coupling": "true"}, {**layer, "substrate.poisson": "0.3"}),
    feature("relaxation", "substrate.relaxation.* load.press_time load.hold rolling.speed",
            "substrate.relaxation|relax", {}, {**relaxing, "rolling.speed": '"5 mm/s"'},
            over_for={"roll": {"tractive_rolling.speed": '"20 mm/s"'}}),
    feature("finite strain", "substrate.material substrate.c01_ratio", "substrate.material|finite strain", layer,
            {**layer, "substrate.material": '"neo-hookean"'}),
    feature("roughness", "indenter.roughness.*", "[indenter.roughness]|rough|smooth|indenter.shape", {},
            {"indenter.roughness.rms_slope": "0.05", "indenter.roughness.long_wavelength": '"2 mm"',
             "indenter.roughness.roll_off": '"2 mm"', "indenter.roughness.short_wavelength": '"1 mm"'}),
    feature("height map", "indenter.file indenter.spacing indenter.unit indenter.heights", "height map|rough surfaces|bodies other than|height-map|indenter.shape",
            {**mapped, "indenter.unit": '"1 um"'}, {**mapped, "indenter.unit": '"1.5 um"'}),
    feature("period", "bem.period", "bem.period|period", {}, {"bem.period": '"14 mm"'}, layer),
    feature("influence file", "bem.influence", "bem.influence|influence", {}, {"bem.influence": '"influence.txt"'}),
    feature("sides that are held", "fem.sides", "fem.sides|sides|finite width|substrate.thickness: ",
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"'},
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"', "fem.sides": '"fixed"'}),
    feature("mesh file", "fem.mesh fem.mesh_unit", "fem.mesh|mesh", layer,
            {**layer, "fem.size": None, "fem.mesh": '"layer.msh"', "fem.mesh_unit": '"1 mm"'}),
    feature("cylinder", "indenter.length", "cylinder|line contact|indenter.shape",
            {"indenter.shape": '"cylinder"', "indenter.length": '"40 mm"'},
            {"indenter.shape": '"cylinder"', "indenter.length": '"50 mm"'}),
    feature("roller", "indenter.chamfer", "roller|indenter.shape|indenter.length",
            {"indenter.shape": '"roller"', "indenter.length": '"10 mm"'},
            {"indenter.shape": '"roller"', "indenter.length": '"12 mm"'}),
    feature("sphere", "", "sphere|indenter.shape", {"indenter.radius": '"10 mm"'},
            {"indenter.radius": '"10 mm"', "indenter.shape": '"sphere"'}),
    feature("cone", "indenter.angle", "cone|bodies other than|indenter.shape",
            {**body, "indenter.shape": '"cone"', "indenter.angle": '"5 deg"'},
            {**body, "indenter.shape": '"cone"', "indenter.angle": '"6 deg"'}),
    feature("power law", "indenter.exponent", "power-law|bodies other than|power law|indenter.shape",
            {"indenter.shape": '"power-law"', "indenter.exponent": "3.0"},
            {"indenter.shape": '"power-law"', "indenter.exponent": "4.0"}),
    feature("rounded punch", "indenter.flat_radius", "rounded-punch|bodies other than|punch|indenter.shape",
            {"indenter.shape": '"rounded-punch"', "indenter.flat_radius": '"1 mm"'},
            {"indenter.shape": '"rounded-punch"', "indenter.flat_radius": '"2 mm"'}),
    feature("ellipsoid", "indenter.radius_y", "ellipsoid|bodies other than|indenter.shape",
            {"indenter.shape": '"ellipsoid"', "indenter.radius_y": '"60 mm"'},
            {"indenter.shape": '"ellipsoid"', "indenter.radius_y": '"80 mm"'}),
    feature("profile", "", "profile|bodies other than|indenter.shape",
            {**body, "indenter.shape": '"profile"', "indenter.file": '"profile.csv"'},
            {**body, "indenter.shape": '"profile"', "indenter.file": '"profile_2.csv"'}),
    feature("uncertain numbers", "", "uncertain|±", {"substrate.young": '"5.2 MPa"'},
            {"substrate.young": '"5.2 ± 0.4 MPa"'}),
    feature("[rig]", "rig.*", "[rig]|rig.", {}, {"rig.density": '"1300 kg/m3"'}),
    feature("[record]", "record.*", "[record]|record.", {},
            {"record.kind": '"shakedown"', "record.runs": '["record.csv"]'}),
    feature("[measurement]", "measurement.*", "[measurement]|measurement.", {},
            {"measurement.static_shift": '"shift.csv"', "measurement.find": '["substrate.young"]',
             "measurement.models": '["half-space"]'}),
    feature("[design]", "design.*", "[design]|design.", {},
            {"design.assumptions": '["small_strains"]',
             "design.vary.substrate.thickness": '{from = "4 mm", to = "30 mm"}'}, layer),
]


def files():
    """Files that cases name, by their names."""
    def profile(radius):  # mm
        return "r [mm], h [um]\n" + "".join(f"{r / 10}, {5 * r * r / radius:.6g}\n" for r in range(0, 81, 2))

    shift = "tangential_force [N], shift [um]\n" + "".join(f"{f}, {f * 6 * (1 + f / 60):.4g}\n" for f in range(1, 8))
    return {"map.txt": height_map, "profile.csv": profile(40), "profile_2.csv": profile(60), "shift.csv": shift}


def model_run(model, over=None):
    return {"calls": [["run", "case.toml", "--models", model, "--output", "out", "--no-studies"]],
            "answer": "out/summary.json", "part": ["models", model], "telling": "out/report.html", "over": over or {}}


def call(*arguments, answer, telling=None, over=None, always=None, part=(), files=None, before=()):
    """One column: its calls, where the answer stands, what is put over the case before the feature, and after it."""
    return {"calls": [*before, list(arguments)], "answer": answer, "telling": telling, "over": over or {},
            "always": always or {}, "part": part, "files": files or {}}


def study(model, vary, more=""):
    return {"study.toml": f'case = "case.toml"\nmodels = ["{model}"]\n{more}[vary]\n{vary}\n'}


elements = {**layer, "models": '["fem"]', "fem.size": '"1.5 mm"', "fem.cache": '"none"'}
two_frictions = "friction.coefficient = [0.5, 0.6]"
commands = {
    "run mdr": model_run("mdr"),
    "run mdr-layer": model_run("mdr-layer", layer),
    "run bem": model_run("bem"),
    "run bem-layer": model_run("bem-layer", layer),
    "run fem": model_run("fem", elements),
    "check": call("check", "case.toml", answer="output"),
    "mesh": call("mesh", "case.toml", "--output", "out", answer="out/*.msh", over=elements),
    "condense": call("condense", "case.toml", answer="output", over={**elements, "fem.cache": '"kept"'}),
    "refine bem": call("refine", "case.toml", "--model", "bem", "--output", "out",
                       answer="out/refinement.json", telling="out/report.html"),
    "refine fem": call("refine", "case.toml", "--model", "fem", "--output", "out",
                       answer="out/refinement.json", telling="out/report.html",
                       over={**elements, "fem.size": '"2 mm"'}),
    "influence": call("influence", "case.toml", "--model", "bem-layer", "--output", "out.txt", answer="out.txt",
                      over=layer),
    "export bem": call("export", "case.toml", "--model", "bem", "--output", "out", answer="out/*.inp"),
    "export bem-layer": call("export", "case.toml", "--model", "bem-layer", "--output", "out",
                             answer="out/*.inp out/*.influence", over=layer),
    "limit": call("limit", "case.toml", "--models", "bem", "--tolerance", "1e-2", "--output", "out",
                  answer="out/limit.json", telling="out/report.html"),
    "roll": call("roll", "case.toml", "--points", "0", "--output", "out", answer="out/summary.json",
                 telling="out/report.html", over={"tractive_rolling.distance": "1.0"}, always={"rolling.*": None, "load.press_time": None}),
    "sweep": call("sweep", "study.toml", "--output", "out", "--jobs", "1", answer="out/results.csv",
                  telling="out/report.html", files=study("bem", two_frictions)),
    "fit": call("fit", "study.toml", "--output", "out", answer="out/fit*.csv out/fit.json",
                before=[["sweep", "study.toml", "--output", "out", "--jobs", "1", "--no-report"]],
                over={"rolling.steps_per_quarter": None, "rolling.steps": '"turning-points"',
                      "rolling.periods": "30", "load.tangential_ratio": "0.2"},
                files=study("bem", "load.tangential_ratio = [0.1, 0.2, 0.3]")),
    "atlas": call("atlas", "study.toml", "--output", "out", "--jobs", "1", answer="out/*.json",
                  files=study("bem", "load.tangential_ratio = {from = 0.1, to = 0.2}",
                              '[atlas]\npoints = 3\nerror = 0.5\nquantities = ["static_shift_ratio"]\n')),
    "predict": call("predict", "case.toml", "--json", answer="output"),
    "predict on a layer": call("predict", "case.toml", "--json", answer="output", over=layer),
    "experiment": call("experiment", "case.toml", "--output", "out", answer="out/experiment.json",
                       telling="out/report.html",
                       over={"record.kind": '"shakedown"', "record.runs": '["record.csv"]',
                             "load.tangential_ratio": "0.4"}),
    "deviation": call("deviation", "case.toml", "--no-runs", "--output", "out",
                      answer="out/deviation.json", telling="out/report.html", over=layer),
    "deviation --finite-strain": call("deviation", "case.toml", "--finite-strain", "--output", "out",
                                      answer="out/deviation.json", over=elements),
    "identify": call("identify", "case.toml", "--output", "out", answer="out/identify.json",
                     telling="out/report.html",
                     over={"measurement.static_shift": '"shift.csv"', "measurement.find": '["substrate.young"]',
                           "measurement.models": '["bem-layer"]', **layer}),
    "rig": call("rig", "case.toml", "--output", "out", answer="out/rig.json", telling="out/report.html", over=layer),
    "design": call("design", "case.toml", "--output", "out", answer="out/design.json", telling="out/report.html",
                   over={**layer, "design.assumptions": '["small_strains"]',
                         "design.vary.substrate.thickness": '{from = "4 mm", to = "30 mm"}'}),
}
# Not in the table. With finite elements or many runs a cell takes a minute: tried by their names. sweep does not say yet
# which parts of a rig's file it leaves unread.
slow_commands = {name: commands.pop(name) for name in (
    "sweep", "run fem", "mesh", "condense", "refine bem", "refine fem", "fit", "atlas", "experiment", "deviation",
    "deviation --finite-strain", "identify", "design")}
# Where the same answer is right, and why: (commands, features, reason).
rigs = "[rig]|[record]|[measurement]|[design]|uncertain numbers"
unaffected = [
    ("run bem|run mdr|run mdr-layer|limit|sweep|refine bem|roll|export bem|fit", "pressing",
     "normal and tangential contact are uncoupled: there is one way of pressing"),
    ("predict|predict on a layer|limit|fit", "rolling steps", "the answer is that of rolling without steps"),
    ("roll", "rolling angle|rolling steps|oscillating normal force|oscillating tangential force|load by its limit",
     "[rolling] is not there"),
    ("mesh|condense|influence", "*", "what makes the layer alone; loads, friction and the rest do not enter"),
    ("limit", "load by its limit", "the limit is what is looked for"),
    ("fit", "load by its limit", "the study varies the load"),
    ("deviation", "rolling angle|rolling steps|pressing|coupled contact",
     "exact theories of the pressed contact, stuck or without coupling"),
    ("rig|design", "static load|load by its limit|rolling steps|pressing|coupled contact|finite strain|sphere",
     "assumptions are about the pressed contact and the drive; coupling and strains are criteria themselves"),
    ("identify", "static load|rolling angle|rolling steps|rolling on|oscillating normal force|"
     "oscillating tangential force|load by its limit", "what was done stands in the tables of [measurement]"),
    ("run bem|run mdr|run mdr-layer|run bem-layer|limit|roll|sweep|fit|refine bem|export bem|export bem-layer|rig|"
     "design|deviation|experiment|identify", "mesh file|sides that are held|influence file",
     "settings of models that do not take part"),
]
commands_with_no_report = ["run", "roll", "sweep"]
# They take no case: files of others, archives, folders of results.
commands_without_a_case = ["cache", "verify", "walk", "merge", "convert", "keys", "list", "manual", "import",
                           "reproduce", "animate"]
