"""How far a computation is: a bar in notebooks, a line on terminals."""

import html
import importlib
import sys
import time
from typing import Any, Callable, Optional, Union

Progress = Union[None, bool, Callable[[str, int, int], object]]
"""True shows it, False does not, None does in notebooks; or a function of name, done and total."""


class Display:
    """What hears of a computation, and shows it."""

    def say(self, line: str) -> None:
        """A line about what goes on."""

    def progress(self, name: str, done: int, total: int) -> None:
        """So many of at most so many steps are done."""

    def close(self) -> None:
        """Nothing more comes."""


class _Callback(Display):
    def __init__(self, call: Callable[[str, int, int], object]) -> None:
        self._call = call

    def progress(self, name: str, done: int, total: int) -> None:
        self._call(name, done, total)


class _Paced(Display):
    """Draws no more often than eyes follow."""

    interval = 0.2  # s

    def __init__(self) -> None:
        self._begin = time.monotonic()
        self._drawn = -1.0
        self._line = ""

    def say(self, line: str) -> None:
        self._line = line
        self._draw(line, None)

    def progress(self, name: str, done: int, total: int) -> None:
        now = time.monotonic()
        if now - self._drawn < self.interval and done < total:
            return
        self._drawn = now
        share = done / total if total > 0 else 0.0
        passed = now - self._begin
        self._draw(f"{name}: {done} of at most {total} steps, {passed:.0f} s", share)

    def _draw(self, text: str, share: Optional[float]) -> None:
        raise NotImplementedError


class _Notebook(_Paced):
    def __init__(self) -> None:
        super().__init__()
        self._display = importlib.import_module("IPython.display")
        self._handle: Any = None

    def _draw(self, text: str, share: Optional[float]) -> None:
        value = "" if share is None else f' value="{share:.3f}"'
        shown = self._display.HTML(f"<progress{value}></progress> {html.escape(text)}")
        if self._handle is None:
            self._handle = self._display.display(shown, display_id=True)
        else:
            self._handle.update(shown)

    def close(self) -> None:
        if self._handle is not None:
            self._handle.update(self._display.HTML(""))


class _Terminal(_Paced):
    def _draw(self, text: str, share: Optional[float]) -> None:
        bar = "" if share is None else f"[{'#' * int(20 * share):.<20}] "
        sys.stderr.write(f"\r\x1b[K{bar}{text}" if sys.stderr.isatty() else f"{bar}{text}\n")
        sys.stderr.flush()

    def close(self) -> None:
        if sys.stderr.isatty():
            sys.stderr.write("\r\x1b[K")


def in_notebook() -> bool:
    """Whether a kernel of Jupyter runs this."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    return type(shell).__name__ == "ZMQInteractiveShell"


def display(wanted: Progress) -> Display:
    """What shows it as wanted."""
    if callable(wanted):
        return _Callback(wanted)
    notebook = in_notebook()
    if wanted is False or (wanted is None and not notebook):
        return Display()
    return _Notebook() if notebook else _Terminal()
