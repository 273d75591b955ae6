"""Closed forms and exact references; the functions take numbers and arrays of numbers.

f = F_T/(mu F_N), w = W/a, u = U/U_max; a, F_N and U_max as in the scales of a case. Arguments out
of range raise ValueError.
"""

from ._core import (
    KalkerCoefficients,
    LayerContact,
    amplitude_limit,
    carter_creepage_ratio,
    carter_force_ratio,
    carter_stick_ratio,
    carter_traction,
    cattaneo_mindlin_traction,
    hertz_pressure,
    hertz_surface_displacement,
    kalker_coefficients,
    layer_contact,
    mapping_parameter,
    mdr_shakedown_traction,
    mdr_threshold_slope,
    settled_shift_ratio,
    shakedown_limit,
    static_shift_ratio,
    stick_radius_ratio,
)

__all__ = [
    "KalkerCoefficients",
    "LayerContact",
    "amplitude_limit",
    "carter_creepage_ratio",
    "carter_force_ratio",
    "carter_stick_ratio",
    "carter_traction",
    "cattaneo_mindlin_traction",
    "hertz_pressure",
    "hertz_surface_displacement",
    "kalker_coefficients",
    "layer_contact",
    "mapping_parameter",
    "mdr_shakedown_traction",
    "mdr_threshold_slope",
    "settled_shift_ratio",
    "shakedown_limit",
    "static_shift_ratio",
    "stick_radius_ratio",
]
