"""docs/explanation/atlas-formulas.md: what the tests of the formulas print."""

from .common import table


@table("docs/explanation/atlas-formulas.md", "| Formula | largest | median | points |", cheap=True)
def atlas_formulas(program):
    rows = program.tests("verification_tests", "AtlasFormulas.*")
    return [[f"{float(cell):.0f}" if "e+" in cell else cell for cell in row] for row in rows]
