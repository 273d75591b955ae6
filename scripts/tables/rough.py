"""docs/explanation/rough.md."""

from .common import table


@table("docs/explanation/rough.md", "| L over shortest wave | cells in it | p = 0.01 E* h' | 0.02 | 0.05 | 0.10 |", cheap=True)
def challenge_area(program):
    found = program.benchmarks("benchmark_rough", "challenge_area/512")
    rows = []
    for cells in (16, 8, 4):
        one = next(value for name, value in found.items() if name.startswith(f"challenge_area/512/{cells}/"))
        rows.append([f"{512 // cells}", f"{cells}", *(f"{one[key]:.2f}" for key in ("kappa_0.01", "kappa_0.02", "kappa_0.05", "kappa_0.10"))])
    return rows
