"""References for contact codes of others: the best that is known of a case, with its bar.

    reference = tricontact.benchmark.reference("layer.toml")
    reference.values["normal_force"]["value"], reference.pressure(x, y)

Quantities are in SI units, tractions act on the elastic body, z points into it.
"""

from typing import Optional

from ._core import BenchmarkReference as Reference
from ._core import Case, _reference
from .inputs import Input, Overrides, case_of

__all__ = ["Reference", "reference"]


def reference(
    case: Input, *, overrides: Overrides = None, threads: Optional[int] = None
) -> Reference:
    """The reference of a case: scalars and fields at the end of its path, each with a bar.

    Kept by the case's digest: the second call reads the first one's. `overrides` are the program's
    --set. threads: for large grids (1).

    Raises InputError where no model is a reference for the case, NotConverged.
    """
    return _reference(case_of(Case, case, overrides), 1 if threads is None else threads)
