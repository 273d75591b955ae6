"""The commands that command_features.py tries, each a column of its table, and where the same answer is right."""

from command_features_data import layer


def call(*arguments, answer, telling=None, over=None, always=None, part=(), files=None, before=()):
    """One column: its calls, where the answer stands, what is put over the case before the feature, and after it."""
    return {"calls": [*before, list(arguments)], "answer": answer, "telling": telling, "over": over or {},
            "always": always or {}, "part": part, "files": files or {}}


def model_run(model, over=None):
    return call("run", "case.toml", "--models", model, "--output", "out", "--no-studies", answer="out/summary.json",
                part=("models", model), telling="out/report.html", over=over)


def study(model, vary, more=""):
    return {"study.toml": f'case = "case.toml"\nmodels = ["{model}"]\n{more}[vary]\n{vary}\n'}


# Given sides: fem looks for none. What is condensed is kept for the next cell.
elements = {**layer, "models": '["fem"]', "fem.size": '"2 mm"', "substrate.width": '"40 mm"',
            "substrate.depth": '"40 mm"', "fem.cache": '"kept"'}
# Sections: a cylinder across, and the sphere through its axis, which is pressed alone.
across = {**layer, "models": '["fem-plane"]', "fem.size": '"0.4 mm"', "indenter.shape": '"cylinder"', "indenter.length": '"60 mm"'}
of_revolution = {**layer, "models": '["fem-axisymmetric"]', "fem.size": '"0.4 mm"', "rolling.*": None, "load.tangential_ratio": "0.0"}
two_frictions = "friction.coefficient = [0.5, 0.6]"
commands = {
    "run mdr": model_run("mdr"),
    "run mdr-layer": model_run("mdr-layer", layer),
    "run bem": model_run("bem"),
    "run bem-layer": model_run("bem-layer", layer),
    "run fem": model_run("fem", elements),
    "run fem-plane": model_run("fem-plane", across),
    "run fem-axisymmetric": model_run("fem-axisymmetric", of_revolution),
    "check": call("check", "case.toml", answer="output"),
    "mesh": call("mesh", "case.toml", "--output", "out", answer="out/*.msh", over=elements),
    "cache condense": call("cache", "condense", "case.toml", answer="kept layers", over=elements),
    "refine bem": call("refine", "case.toml", "--models", "bem", "--output", "out",
                       answer="out/refinement.json", telling="out/report.html"),
    "refine fem": call("refine", "case.toml", "--models", "fem", "--output", "out",
                       answer="out/refinement.json", telling="out/report.html",
                       over=elements),
    "influence": call("influence", "case.toml", "--models", "bem-layer", "--output", "out.txt", answer="out.txt",
                      over=layer),
    "contact export bem": call("contact", "export", "case.toml", "--models", "bem", "--output", "out",
                               answer="out/*.inp"),
    "contact export bem-layer": call("contact", "export", "case.toml", "--models", "bem-layer", "--output", "out",
                                     answer="out/*.inp out/*.influence", over=layer),
    "limit": call("limit", "case.toml", "--models", "bem", "--tolerance", "1e-2", "--output", "out",
                  answer="out/limit.json", telling="out/report.html"),
    "run rolling on": call("run", "case.toml", "--points", "0", "--output", "out", answer="out/summary.json",
                 telling="out/report.html", over={"rolling.*": None, "tractive_rolling.distance": "1.0"},
                 always={"load.press_time": None}),
    "sweep": call("sweep", "study.toml", "--output", "out", "--jobs", "1", answer="out/results.csv",
                  telling="out/report.html", files=study("bem", two_frictions)),
    "fit": call("fit", "study.toml", "--output", "out", answer="out/fit*.csv out/fit.json",
                before=[["sweep", "study.toml", "--output", "out", "--jobs", "1", "--no-report"]],
                over={"rolling.steps_per_quarter": None, "rolling.steps": '"turning-points"',
                      "rolling.periods": "30", "load.tangential_ratio": "0.2"},
                files=study("bem", "load.tangential_ratio = [0.1, 0.2, 0.3]")),
    "atlas": call("atlas", "study.toml", "--output", "out", "--jobs", "1", answer="out/*.json",
                  part=("maps",), files=study("bem", "load.tangential_ratio = {from = 0.1, to = 0.2}",
                              '[atlas]\npoints = 20\nerror = 0.5\nquantities = ["final_shift_ratio"]\n')),
    "predict": call("predict", "case.toml", "--json", answer="output"),
    "predict on a layer": call("predict", "case.toml", "--json", answer="output", over=layer),
    "experiment": call("experiment", "case.toml", "--output", "out", answer="out/experiment.json",
                       telling="out/report.html",
                       over={"record.kind": '"shakedown"', "record.runs": '["record.csv"]',
                             "load.tangential_ratio": "0.4"}),
    "deviation": call("deviation", "case.toml", "--output", "out", answer="out/deviation.json",
                      telling="out/report.html", over=layer),
    "deviation --finite-strain": call("deviation", "case.toml", "--finite-strain", "--output", "out",
                                      answer="out/deviation.json", telling="out/report.html", over=elements),
    "identify": call("identify", "case.toml", "--output", "out", answer="out/identify.json",
                     telling="out/report.html",
                     over={"measurement.static_shift": '"shift.csv"', "measurement.find": '["substrate.young"]',
                           "measurement.models": '["bem-layer"]', **layer}),
    "rig": call("rig", "case.toml", "--output", "out", answer="out/rig.json", telling="out/report.html", over=layer),
    "design": call("design", "case.toml", "--output", "out", answer="out/design.json", telling="out/report.html",
                   over={**layer, "design.assumptions": '["small_strains"]', "design.resolution": "0.3",
                         "design.quantity": '"settled_shift"', "design.scatter": '"2 um"', "design.repeats": "5",
                         "design.vary.substrate.thickness": '{from = "7 mm", to = "30 mm"}'}),
}
# Columns by the tests that try them; those of groups but the first take seconds a cell.
groups = {
    "fast": ["run mdr", "run mdr-layer", "run bem", "run bem-layer", "check", "influence", "contact export bem",
             "contact export bem-layer", "limit", "run rolling on", "sweep", "fit", "predict", "predict on a layer",
             "experiment", "rig"],
    "elements": ["run fem", "run fem-plane", "run fem-axisymmetric", "mesh", "cache condense", "refine bem", "atlas", "identify", "design"],
}
# Without a place in the table: tried by hand (command_features.py PROGRAM TABLE slow), for wrong cells alone.
slow = ["refine fem", "deviation", "deviation --finite-strain"]
# Where the same answer is right, and why: (commands, features, reason).
unaffected = [
    ("run bem|run mdr|run mdr-layer|limit|sweep|refine bem|run rolling on|contact export bem|fit|atlas|experiment",
     "pressing",
     "normal and tangential contact are uncoupled: there is one way of pressing"),
    ("predict|predict on a layer|limit", "rolling steps", "the answer is that of rolling without steps"),
    ("mesh|cache condense", "wear|load that alternates about zero|rig in series with the contact|path|path with a shift|centre of rotation|path with rolling|static load|rolling amplitude|"
     "rolling steps|oscillating tangential force|load by its limit|pressing|coupled contact|relaxation|hold|"
     "shear strength|friction by a power of the pressure|friction up to a limit|springs of the interface|"
     "friction over the substrate|friction falling with the way of slip|layer of the interface that yields|"
     "finite strain|period|influence file|sphere",
     "the layer alone, cut to the contact: of the loads what changes its patch by an element; friction does not enter"),
    ("mesh", "oscillating normal force|prescribed depth|sides that are held|cone",
     "as above; how the block is held is no part of its mesh"),
    ("influence", "wear|load that alternates about zero|rig in series with the contact|path|path with a force along y|path with a shift|path with a twist|centre of rotation|static load|"
     "rolling steps|rolling on|oscillating tangential force|load by its limit|pressing|coupled contact|relaxation|hold|"
     "shear strength|friction by a power of the pressure|friction up to a limit|"
     "map turned over|height map|sides that are held|sphere|springs of the interface|friction over the substrate|"
     "friction falling with the way of slip|layer of the interface that yields",
     "coefficients of the relaxed layer for cells of one size, whatever presses on how many of them"),
    ("limit", "load by its limit", "the limit is what is looked for"),
    ("contact export bem|limit|fit|experiment|refine bem|atlas", "yield stresses",
     "strength is judged beside elastic results, which it does not change"),
    ("fit|atlas", "load by its limit", "the study varies the load"),
    ("atlas", "load that alternates about zero", "as above"),
    ("atlas", "static load|elastic indenter|rigid substrate|cone",
     "the study varies the load; maps are of ratios, which modulus and angle do not change"),
    ("rig|design", "rolling steps", "assumptions are about the pressed contact and the drive"),
    ("rig", "static load|load by its limit|pressing|coupled contact|sphere",
     "assumptions are about the pressed contact and the drive; coupling is a criterion itself"),
    ("identify", "uncertain modulus|correlated numbers",
     "the modulus is what is looked for: the case's value is a guess"),
    ("design", "layer", "the thickness is what is varied"),
    ("design", "[rig]", "no requirement that is asked for needs the density"),
    ("run bem|run mdr|run mdr-layer|run bem-layer|influence|limit|run rolling on|sweep|fit|refine bem|"
     "contact export bem|contact export bem-layer|rig|design|experiment|identify|atlas", "mesh file", "a mesh is fem's, which does not take part"),
    ("run mdr-layer|run bem-layer|contact export bem-layer|rig|identify", "sides that are held",
     "the block of fem, which does not take part"),
    ("run mdr|run mdr-layer|rig|design", "influence file", "coefficients of bem-layer, which does not take part"),
]
# Known faults: (command, feature).
open_cells = set()
commands_with_no_report = ["run", "sweep"]
# They take no case, or those of the catalogue: files of others, archives, folders of results.
commands_without_a_case = ["verify", "keys", "list", "manual", "reproduce", "benchmark", "compare", "new"]
