"""docs/explanation/atlas-formulas.md: what the tests of the formulas print; kappa of a shear strength."""

from .common import table


@table("docs/explanation/atlas-formulas.md", "| Formula | largest | median | points |", cheap=True)
def atlas_formulas(program):
    rows = program.tests("verification_tests", "AtlasFormulas.*")
    return [[f"{float(cell):.0f}" if "e+" in cell else cell for cell in row] for row in rows]


@table("docs/explanation/friction-laws.md", "| w | f | f/f_T,lim | nu = 0 | nu = 1/2, along | nu = 1/2, across |")
def shear_strength_kappa(program):
    groups = {one["group"]: one["points"] for one in program.fit("shear_strength_shakedown.toml")["kappa"]
              if one["model"] == "bem"}

    def points_of(direction, poisson):
        name = next(name for name in groups if name.startswith(direction) and name.endswith(f"= {poisson}"))
        return {(round(p["amplitude_ratio"], 3), round(p["tangential_ratio"], 3)): p for p in groups[name]}
    columns = [points_of("parallel", "0"), points_of("parallel", "0.5"), points_of("perpendicular", "0.5")]

    def cell(point):
        return f"{point['kappa']['value']:.3f} ± {point['kappa']['numerical_error']:.3f}"
    return [[f"{w:g}", f"{f:g}", f"{columns[0][w, f]['over_limit']:.2f}", *(cell(one[w, f]) for one in columns)]
            for w, f in columns[0] if f in (.1, .4) or w in (.2,)]
