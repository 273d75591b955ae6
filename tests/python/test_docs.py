"""The examples of docs/how-to/python.md say what they say."""

import doctest
import os
from pathlib import Path


def test_examples(examples, tmp_path, monkeypatch):
    (tmp_path / "examples").symlink_to(examples)
    monkeypatch.chdir(tmp_path)
    document = Path(os.environ["TRICONTACT_DOCS"]) / "how-to" / "python.md"
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    failed, tried = doctest.testfile(str(document), module_relative=False, optionflags=flags)
    assert tried > 10 and failed == 0
