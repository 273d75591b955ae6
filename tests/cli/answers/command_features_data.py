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
                      "bem.cell_ratio", "bem.cell_shift_x", "bem.cell_shift_y", "mdr.springs", "mdr.elements_per_radius", "fem.accuracy", "fem.size", "fem.growth", "fem.tolerance", "fem.solver", "fem.cache",
                      "indenter.radius", "indenter.shape", "substrate.young", "substrate.poisson",
                      "friction.coefficient", "load.normal_force", "load.tangential_ratio", "load.tangential_force"]

correlation = 'correlation."substrate.young and friction.coefficient"'
layer = {"substrate.thickness": '"8 mm"'}
height_map = "".join(" ".join(f"{((x / 10) ** 2 + (y / 10) ** 2) * 6.25:.4f}" for x in range(-30, 31, 2)) + "\n"
                     for y in range(-30, 31, 2))  # um, of a ball of 80 mm on 6 mm


def body_of_revolution(n=12, half=12., height=10., radius=40.):
    """A gmsh file of a box whose lower face is a paraboloid, n x n x 2 hexahedra, in mm."""
    def node(i, j, k):
        return 1 + i + (n + 1) * (j + (n + 1) * k)

    def position(i, j, k):
        x, y = (2 * i / n - 1) * half, (2 * j / n - 1) * half
        low = (x * x + y * y) / 2 / radius
        return f"{node(i, j, k)} {x} {y} {low + (height - low) * k / 2}"

    def face(i, j, k):
        return [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]

    cells = [(i, j) for j in range(n) for i in range(n)]
    elements = [(3, 1, face(*at, 0)) for at in cells] + [(3, 2, face(*at, 2)) for at in cells]
    elements += [(5, 3, face(*at, k) + face(*at, k + 1)) for k in range(2) for at in cells]
    nodes = [position(i, j, k) for k in range(3) for j in range(n + 1) for i in range(n + 1)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '2 1 "contact"', '2 2 "support"',
             '3 3 "body"', "$EndPhysicalNames", "$Nodes", len(nodes), *nodes, "$EndNodes", "$Elements", len(elements)]
    lines += [" ".join(map(str, (e + 1, kind, 2, group, group, *at))) for e, (kind, group, at) in enumerate(elements)]
    return "\n".join(map(str, [*lines, "$EndElements\n"]))


# Of columns whose base does not roll back and forth.
rolled = {name: {"rolling.amplitude_ratio": "0.24"} for name in ("run rolling on", "run fem-axisymmetric")}


def path(*columns, **values):
    """A table that presses, pulls and lets go; further columns as given, in three rows."""
    names = ["normal_force [N]", "tangential_force_x [N]", *columns]
    rows = [["21", "0"], ["21", "4"], ["21", values.get("force", "2")]]
    for column in columns:
        for row, value in zip(rows, values[column.split(" ")[0]]):
            row.append(value)
    return '"' + "\\n".join([", ".join(names), *(", ".join(row) for row in rows)]) + '"'


def feature(name, keys, words, one, other, base=None, over_for=None, other_for=None):
    """`over_for`, `other_for`: further keys by commands, of both cases and of the other one."""
    return {"name": name, "keys": keys.split(), "words": [name, *words.split("|")], "one": one, "other": other,
            "base": base or {}, "over_for": over_for or {}, "other_for": other_for or {}}


loop = '"normal_force [N], shift_x [um]\\n21, 0\\n21, 5\\n21, -5\\n21, 5"'
no_load = {"load.*": None, "rolling.*": None, "tractive_rolling.*": None, "path.steps": "2"}
relaxing = {"substrate.relaxation.relative_moduli": "[0.4]", "substrate.relaxation.times": '["0.5 s"]',
            "load.press_time": '"0.5 s"'}
falling = {"friction.rate.law": '"linear"', "friction.rate.drops": "0.2", "friction.rate.speeds": '"5 mm/s"'}
weakening = {"friction.weakening.law": '"linear"', "friction.weakening.drop": "0.2", "friction.weakening.length": '"20 um"'}
yielding = {"interface.yield_stress": '"0.05 MPa"', "interface.hardening": '"1 MPa/mm"'}
# Designs know laws of friction on the half-space, and check assumptions of layers under Coulomb's law.
under_laws = {"design": {"substrate.thickness": None, "design.assumptions": None, "design.vary.substrate.thickness": None,
                         "design.vary.load.normal_force": '{from = "10 N", to = "30 N"}'}}
heated = {f"{body}.heat.{key}": value for body, conductivity in (("indenter", 50), ("substrate", 0.2))
          for key, value in (("conductivity", f'"{conductivity} W/(m K)"'), ("specific_heat", '"450 J/(kg K)"'),
                             ("density", '"7850 kg/m3"'))}
by_heat = {**heated, "friction.temperature.change": "-0.2", "friction.temperature.from": '"0 degC"', "friction.temperature.to": '"5 degC"'}
body = {"indenter.radius": None}
elastic = {"indenter.young": '"20 MPa"', "indenter.poisson": "0.5"}
# Bodies of finite elements do not roll, and a ball between plates takes no force along them.
at_rest = {"rolling.*": None}
pressed = {f"run {model}": {**at_rest, "load.tangential_ratio": "0.0"} for model in ("fem", "fem-axisymmetric")}
steep = {"fem.growth": "3.0"}  # elements of a body whose numbers nobody reads
hemisphere = {"indenter.body": '"hemisphere"', "indenter.support": '"holder"'}
between_plates = {"indenter.young": '"20 MPa"', "indenter.poisson": "0.5", "indenter.body": '"ball"', "indenter.support": '"plates"', "contact.coupling": "false"}
on_hub = {"indenter.body": '"cylinder"', "indenter.support": '"hub"', "indenter.hub_radius": '"10 mm"'}
still = {"rolling.*": None, "tractive_rolling.*": None, "load.tangential_ratio": "0.0"}
tacky = {"friction.coefficient": None, "adhesion.work": '"0.5 J/m2"'}
in_hole = {**still, "substrate.thickness": None, "substrate.width": None, "substrate.depth": None, "substrate.shape": '"hole"', "substrate.hole_radius": '"40.5 mm"',
           "substrate.outer_radius": '"400 mm"', "indenter.shape": '"cylinder"', "indenter.length": '"60 mm"'}
flat_punch = {**still, **body, "indenter.shape": '"flat-punch"', "indenter.flat_radius": '"3 mm"'}
along_y = {"run fem-plane": {"indenter.length": '"60 mm"'}}
long_punch = {**still, "indenter.shape": '"rounded-punch"', "indenter.flat_radius": '"1 mm"', "indenter.length": '"60 mm"'}
loose_block = {**flat_punch, **elastic, "indenter.body": '"block"', "indenter.support": '"pressure"', "indenter.height": '"6 mm"'}
mapped = {**body, "indenter.shape": '"height-map"', "indenter.file": '"map.txt"', "indenter.spacing": '"0.2 mm"',
          "bem.cells_per_radius": None, "bem.spacing": '"0.4 mm"', "load.normal_force": '"1 N"',
          "rolling.amplitude_ratio": None, "rolling.amplitude": '"0.4 mm"'}
to_and_fro = {"load.tangential_ratio": None, "rolling.*": None, "tractive_rolling.*": None, "load.periods": "1", "load.steps_per_quarter": "2"}
features = [
    feature("load that alternates about zero", "load.tangential_amplitude load.shift_amplitude load.periods load.steps_per_quarter",
            "load.tangential_amplitude|prescribed path|[tractive_rolling]|path|[rolling]", {**to_and_fro, "load.tangential_amplitude": '"4 N"'},
            {**to_and_fro, "load.tangential_amplitude": '"5 N"'}),
    feature("rig in series with the contact", "rig.tangential_stiffness rig.normal_stiffness",
            "rig|load.shift_amplitude|prescribed path|[tractive_rolling]|path", {**to_and_fro, "load.shift_amplitude": '"20 um"'},
            {**to_and_fro, "load.shift_amplitude": '"20 um"', "rig.tangential_stiffness": '"1e5 N/m"'}),
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
    feature("centre of rotation", "path.centre_*", "path|centre_|rotation|[tractive_rolling]",
            {**no_load, "path.table": path("rotation [mrad]", rotation=["0", "0", "8"])},
            {**no_load, "path.table": path("rotation [mrad]", rotation=["0", "0", "8"]), "path.centre_x": '"1 mm"'}),
    feature("path with rolling", "", "path|offset|[tractive_rolling]",
            {**no_load, "path.table": path("offset_x [mm]", offset_x=["0", "0", "0"])},
            {**no_load, "path.table": path("offset_x [mm]", offset_x=["0", "0", "0.5"])}),
    feature("wear", "wear.*", "[wear]|wear|path|[tractive_rolling]", {**no_load, "path.table": loop, "wear.coefficient": '"1e-6 mm3/(N m)"', "wear.cycles": "20"},
            {**no_load, "path.table": loop, "wear.coefficient": '"1e-6 mm3/(N m)"', "wear.cycles": "40"}),
    feature("static load", "", "[rolling]|rolling|load.tangential_ratio", {"load.tangential_ratio": "0.4", "rolling.*": None},
            {"load.tangential_ratio": "0.5", "rolling.*": None}),
    feature("rolling angle", "rolling.angle", "rolling.angle|angle|rolling direction|[rolling]", {},
            {"rolling.angle": '"90 deg"'}, other_for=rolled),
    feature("rolling amplitude", "rolling.amplitude rolling.amplitude_ratio rolling.amplitude_reference",
            "rolling.amplitude|[rolling]", {}, {"rolling.amplitude_ratio": "0.3"}),
    feature("rolling steps", "rolling.steps rolling.steps_per_quarter rolling.increment rolling.periods rolling.until "
            "rolling.run_all", "rolling.steps|[rolling]",
            {"rolling.steps_per_quarter": "1"}, {"rolling.steps_per_quarter": "3"}, other_for=rolled),
    feature("rolling on", "tractive_rolling.*", "tractive_rolling|rolling on|rolls on",
            {"rolling.*": None, "tractive_rolling.distance": "1.0"},
            {"rolling.*": None, "tractive_rolling.distance": "1.0", "tractive_rolling.lateral_creepage": "0.01"},
            other_for={"run fem-plane": {"tractive_rolling.lateral_creepage": None, "tractive_rolling.distance": "2.0"}}),
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
    feature("shear strength", "friction.shear_strength", "friction|Coulomb", {}, {"friction.shear_strength": '"0.1 MPa"'},
            over_for=under_laws),
    feature("friction by a power of the pressure", "friction.pressure_exponent friction.reference_pressure",
            "friction|Coulomb", {}, {"friction.pressure_exponent": "0.7", "friction.reference_pressure": '"0.1 MPa"'},
            over_for=under_laws),
    feature("friction up to a limit", "friction.strength_limit", "friction|Coulomb", {},
            {"friction.strength_limit": '"0.1 MPa"'}, over_for=under_laws),
    feature("friction over the substrate", "friction.map", "friction|Coulomb", {"friction.map": '"friction.csv"'},
            {"friction.map": '"friction_2.csv"'}),
    feature("bulk stress", "load.bulk_stress", "bulk_stress|bulk stress|[rolling]|rolling|no layer", {"rolling.*": None}, {"rolling.*": None, "load.bulk_stress": '"20 kPa"'}),
    feature("yield stresses", "substrate.yield_stress indenter.yield_stress", "yield_stress|strength", {}, {"substrate.yield_stress": '"1 MPa"'}),
    feature("springs of the interface", "interface.normal_stiffness interface.tangential_stiffness", "interface", {},
            {"interface.normal_stiffness": '"20 MPa/mm"', "interface.tangential_stiffness": '"10 MPa/mm"'}),
    feature("adhesion", "adhesion.* bem.adhesive_edge", "adhesion|attract|contact.coupling|[adhesion]|rolling|[rolling]", {**still}, {**still, "adhesion.work": '"0.5 J/m2"'},
            over_for={"identify": {"load.*": None, "substrate.thickness": None, "measurement.static_shift": None, "measurement.models": '["half-space"]',
                                   "measurement.force_indentation": '"curve.csv"'}}),
    feature("adhesion with hysteresis", "adhesion.approach_work", "adhesion|attract|approach|contact.coupling|[adhesion]|rolling|[rolling]",
            {**still, "adhesion.work": '"0.5 J/m2"'}, {**still, "adhesion.work": '"0.5 J/m2"', "adhesion.approach_work": '"0.2 J/m2"'},
            over_for={**{name: {"models": '["mdr"]'} for name in ("check", "predict")},
                      "identify": {"load.*": None, "substrate.thickness": None, "measurement.static_shift": None, "measurement.models": '["half-space"]',
                                   "measurement.force_indentation": '"curve.csv"'}}),
    feature("friction of surfaces that attract each other", "", "adhesion|attract|friction|Coulomb|contact.coupling|[adhesion]|rolling|[rolling]",
            {**tacky, "friction.shear_strength": '"50 kPa"'}, {**tacky, "friction.shear_strength": '"70 kPa"'}),
    feature("friction falling with the slip", "friction.rate.*", "friction.rate|friction|Coulomb", {}, falling,
            other_for={"run rolling on": {**falling, "tractive_rolling.speed": '"1 m/s"', "tractive_rolling.distance": None}}),
    feature("friction falling with the way of slip", "friction.weakening.*", "friction.weakening|friction|Coulomb|[rolling]",
            {"rolling.*": None, **weakening}, {"rolling.*": None, **weakening, "friction.weakening.drop": "0.3"},
            over_for={"run rolling on": weakening}),
    feature("layer of the interface that yields", "interface.yield_stress interface.hardening",
            "interface|friction|Coulomb|[rolling]", yielding, {**yielding, "interface.hardening": '"3 MPa/mm"'},
            over_for={"run fem-axisymmetric": {"substrate.poisson": "0.1"}}),
    feature("temperatures of the surfaces", "indenter.heat.* substrate.heat.*", "substrate.heat|heat|[tractive_rolling]", {}, heated,
            other_for={"run rolling on": {**heated, "tractive_rolling.speed": '"1 m/s"'}}),
    feature("friction by the temperature", "friction.temperature.*", "friction.temperature|friction|Coulomb|substrate.heat|heat", {}, by_heat,
            other_for={"run rolling on": {**by_heat, "tractive_rolling.speed": '"1 m/s"', "tractive_rolling.distance": None}}),
    feature("layer", "substrate.thickness substrate.thickness_ratio", "substrate.thickness|layer",
            {"substrate.thickness": '"8 mm"'}, {"substrate.thickness": '"7 mm"'}),
    feature("base that glides", "substrate.base", "substrate.base|base|substrate.thickness: ", layer,
            {**layer, "substrate.base": '"frictionless"'}),
    feature("ground", "ground.*", "[ground]|ground|rigid base|substrate.thickness: ", layer,
            {**layer, "substrate.base": '"half-space"', "ground.young": '"5 MPa"', "ground.poisson": "0.4"}),
    feature("lower layer", "lower_layer.*", "[lower_layer]|lower_layer|one layer|several layers|substrate.thickness: |rigid base", layer,
            {**layer, "lower_layer.thickness": '"4 mm"', "lower_layer.young": '"2 MPa"',
             "lower_layer.poisson": "0.45"}),
    feature("width", "substrate.width substrate.depth", "substrate.width|width|substrate.thickness: ", layer,
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"'}, other_for={"run fem-plane": {"substrate.depth": None}}),
    feature("elastic indenter", "indenter.young indenter.poisson", "indenter.young|elastic indenter|rigid", {},
            {"indenter.young": '"20 MPa"', "indenter.poisson": "0.5"}),
    feature("body of the indenter", "indenter.body indenter.support indenter.hub_radius indenter.height",
            "indenter.body|indenter.young|elastic indenter|rigid", {**elastic, **hemisphere},
            {**elastic, "indenter.body": '"ball"', "indenter.support": '"plates"'},
            over_for={**pressed, "run fem": {**pressed["run fem"], **steep}, "run fem-plane": on_hub, "cache condense": pressed["run fem"]},
            other_for={"run fem-plane": {"indenter.hub_radius": '"20 mm"'}}),
    feature("unlike plates", "upper_plate.rigid upper_plate.young upper_plate.poisson upper_plate.thickness",
            "upper_plate|indenter.body|contact.coupling|coupling|indenter.young|elastic indenter|rigid",
            {**between_plates, "upper_plate.young": '"4 MPa"', "upper_plate.poisson": "0.3", "upper_plate.thickness": '"8 mm"'},
            {**between_plates, "upper_plate.rigid": "true"},
            over_for={**pressed, "run fem-plane": {**pressed["run fem"], "indenter.body": '"cylinder"'}, "cache condense": pressed["run fem"]}),
    feature("mesh of the indenter", "indenter.mesh indenter.mesh_unit",
            "indenter.mesh|indenter.young|elastic indenter|rigid",
            {**elastic, "indenter.mesh": '"body.msh"', "indenter.mesh_unit": '"1 mm"'},
            {**elastic, "indenter.mesh": '"body.msh"', "indenter.mesh_unit": '"1.1 mm"'}, over_for=pressed),
    feature("rigid substrate", "substrate.rigid", "substrate.rigid|substrate.thickness|substrate.young|rigid|layer", elastic,
            {**elastic, "substrate.*": None, "substrate.rigid": "true"},
            over_for={"run fem": {**at_rest, **hemisphere, **steep, "fem.size": '"1 mm"'}, "run fem-axisymmetric": hemisphere, "run fem-plane": on_hub}),
    feature("hole in the substrate", "substrate.shape substrate.hole_radius substrate.outer_radius", "hole|flat substrate|substrate.thickness",
            in_hole, {**in_hole, "substrate.hole_radius": '"41 mm"'}),
    feature("punch with a sharp edge", "", "sharp edge|flat punch|punch along y|indenter.shape", flat_punch,
            {**flat_punch, "indenter.flat_radius": '"2 mm"'}, over_for=along_y),
    feature("punch along y", "", "punch along y|punch of revolution|flat punch|indenter.shape", long_punch, {**long_punch, "indenter.flat_radius": '"2 mm"'}),
    feature("body that nothing holds", "", "indenter.body|sharp edge|punch along y|flat punch|indenter.young|indenter.shape", loose_block,
            {**loose_block, "indenter.height": '"4 mm"'}, over_for=along_y),
    feature("coupled contact", "contact.coupling", "contact.coupling|coupl", {"contact.coupling": "false"},
            {"contact.coupling": "true"}, {**layer, "substrate.poisson": "0.3"},
            over_for={"design": {"substrate.poisson": "0.5"}}),
    feature("relaxation", "substrate.relaxation.* load.press_time rolling.speed",
            "substrate.relaxation|relax", {}, {**relaxing, "rolling.speed": '"5 mm/s"'},
            other_for={"run rolling on": {"tractive_rolling.speed": '"20 mm/s"', "rolling.*": None},
                       "run fem-axisymmetric": {"rolling.*": None}}),
    feature("relaxing indenter", "substrate.relaxation.body", "substrate.relaxation|relax", {**elastic, **relaxing, "rolling.speed": '"5 mm/s"'},
            {**elastic, **relaxing, "rolling.speed": '"5 mm/s"', "substrate.relaxation.body": '"both"'},
            over_for={**{f"run {model}": at_rest for model in ("mdr", "bem", "mdr-layer", "bem-layer")},
                      "run rolling on": {"tractive_rolling.speed": '"20 mm/s"', "rolling.*": None},
                      "run fem": {**pressed["run fem"], **hemisphere, **steep, "fem.size": '"1 mm"'},
                      "run fem-axisymmetric": {**pressed["run fem-axisymmetric"], **hemisphere},
                      "run fem-plane": {**at_rest, **on_hub}}),
    feature("hold", "load.hold", "load.hold|relax", {}, {"load.hold": '"2 s"'},
            {**relaxing, "rolling.speed": '"5 mm/s"'}, over_for={"run rolling on": {"tractive_rolling.speed": '"20 mm/s"'}}),
    feature("finite strain", "substrate.material substrate.c01_ratio", "substrate.material|finite strain", layer,
            {**layer, "substrate.material": '"neo-hookean"'}),
    feature("roughness", "indenter.roughness.*", "[indenter.roughness]|rough|smooth|indenter.shape", {},
            {"indenter.roughness.rms_slope": "0.05", "indenter.roughness.long_wavelength": '"4 mm"',
             "indenter.roughness.roll_off": '"4 mm"', "indenter.roughness.short_wavelength": '"2 mm"'}),
    feature("map turned over", "indenter.heights", "height map|map|rough surfaces|bodies other than|indenter.shape",
            {**mapped, "indenter.unit": '"1 um"'},
            {**mapped, "indenter.unit": '"1 um"', "indenter.heights": '"outward"'},
            over_for={"run rolling on": {"rolling.*": None}}),
    feature("height map", "indenter.file indenter.spacing indenter.unit", "height map|rough surfaces|bodies other than|height-map|indenter.shape",
            {**mapped, "indenter.unit": '"1 um"'}, {**mapped, "indenter.unit": '"1.5 um"'}, over_for={"run rolling on": {"rolling.*": None}}),
    feature("period", "bem.period", "bem.period|period", {}, {"bem.period": '"14 mm"'}, layer,
            over_for={"identify": {"bem.cells_per_radius": "9"}}),
    feature("influence file", "bem.influence", "bem.influence|influence", {}, {"bem.influence": '"influence.txt"'}),
    feature("sides that are held", "fem.sides", "fem.sides|sides|finite width|substrate.thickness: ",
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"'},
            {**layer, "substrate.width": '"20 mm"', "substrate.depth": '"20 mm"', "fem.sides": '"fixed"'},
            over_for={"run fem-plane": {"substrate.depth": None}}),
    feature("mesh file", "fem.mesh fem.mesh_unit", "fem.mesh|mesh", layer,
            {**layer, "fem.size": None, "fem.mesh": '"layer.msh"', "fem.mesh_unit": '"1 m"'}),
    feature("cylinder", "indenter.length", "cylinder|line contact|indenter.shape",
            {"indenter.shape": '"cylinder"', "indenter.length": '"40 mm"'},
            {"indenter.shape": '"cylinder"', "indenter.length": '"50 mm"'}),
    feature("roller", "indenter.chamfer", "roller|indenter.shape|indenter.length",
            {"indenter.shape": '"roller"', "indenter.length": '"10 mm"'},
            {"indenter.shape": '"roller"', "indenter.length": '"12 mm"'}),
    feature("sphere", "", "sphere|indenter.shape", {"indenter.radius": '"10 mm"'},
            {"indenter.radius": '"10 mm"', "indenter.shape": '"sphere"'},
            over_for={"design": {"indenter.radius": '"40 mm"'}, "mesh": {"indenter.radius": '"30 mm"'},
                      "cache condense": {"indenter.radius": '"30 mm"'}, "run fem": {"indenter.radius": '"30 mm"'},
                      "refine fem": {"indenter.radius": '"30 mm"'}}),
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
    *[feature(f"uncertain {name}", "", f"uncertain|±|[rolling]|{key}", {}, {key: text.replace("±", f"± {error}")})
      for name, key, text, error in [("modulus", "substrate.young", '"5.2 ± MPa"', "0.4"),
                                     ("radius", "indenter.radius", '"40 ± mm"', "1"),
                                     ("friction", "friction.coefficient", '"0.57 ±"', "0.02"),
                                     ("load", "load.normal_force", '"21.1 ± N"', "0.5"),
                                     ("amplitude", "rolling.amplitude_ratio", '"0.24 ±"', "0.02")]],
    feature("correlated numbers", "correlation.*", "uncertain|±|correlat", {}, {correlation: "0.9"},
            {"substrate.young": '"5.2 ± 0.4 MPa"', "friction.coefficient": '"0.57 ± 0.02"'}),
    feature("[rig]", "rig.*", "[rig]|rig.", {}, {"rig.density": '"1300 kg/m3"'}),
    feature("[printed]", "printed.*", "[printed]", {}, {"printed.indentation": '{value = "0.26 mm", source = "table 1"}'}),
    feature("[record]", "record.*", "[record]|record.", {},
            {"record.kind": '"shakedown"', "record.runs": '["record.csv", "record_2.csv"]'},
            other_for={"design": {"record.resolution": '"1 um"'}}),
    feature("[measurement]", "measurement.*", "[measurement]|measurement.", {},
            {"measurement.static_shift": '"shift.csv"', "measurement.find": '["substrate.young"]',
             "measurement.models": '["half-space"]'}),
    feature("[design]", "design.*", "[design]|design.", {},
            {"design.assumptions": '["small_strains"]',
             "design.vary.substrate.thickness": '{from = "5 mm", to = "30 mm"}'}, layer),
]


def files():
    """Files that cases name, by their names."""
    def profile(radius):  # mm
        return "r [mm], h [um]\n" + "".join(f"{r / 10}, {5 * r * r / radius:.6g}\n" for r in range(0, 81, 2))

    shift = "tangential_force [N], shift [um]\n" + "".join(f"{f}, {f * 6 * (1 + f / 60):.4g}\n" for f in range(1, 8, 2))
    # Of a ball under tension, E* = 6.9 MPa, w = 0.5 J/m2 (Johnson, Kendall and Roberts 1971).
    radius, modulus, work = 0.04, 6.9e6, 0.5
    jkr = [((a * a / radius - (2 * 3.14159 * a * work / modulus) ** 0.5) * 1e6,
            4 * modulus * a**3 / (3 * radius) - (8 * 3.14159 * modulus * work * a**3) ** 0.5)
           for a in (k * 2e-4 for k in range(8, 20))]
    curve = "indentation [um], normal_force [N]\n" + "".join(f"{d:.6g}, {f:.6g}\n" for d, f in jkr)
    stripes = "x [mm], factor\n-90, 1\n-0.5, 1\n0.5, {}\n90, {}\n"
    return {"friction.csv": stripes.format(1.1, 1.1), "friction_2.csv": stripes.format(0.9, 0.9), "map.txt": height_map, "profile.csv": profile(40), "profile_2.csv": profile(60), "shift.csv": shift, "curve.csv": curve}
