"""The tables of the documents, a file per subject."""

from . import atlas, bodies, cylinder, half_space, identification, layers, models, performance, rolling, rough, submissions, superposed, walking  # noqa: F401
