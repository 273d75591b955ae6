"""The Python reference, a page for Sphinx: signatures from the sources and the stubs of the module tricontact, texts from its
docstrings. Those of the compiled part are read if it is built; its stubs stand for them otherwise.
usage: python_reference.py SOURCE_DIR FOLDER [COMPILED]   COMPILED: build/release/python/_core*.so"""

import ast
import copy
import importlib.util
import inspect
import os
import re
import sys
from pathlib import Path

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


def definitions(tree):
    """Name -> definition; of overloads the first."""
    found = {}
    for one in tree.body:
        if isinstance(one, (*FUNCTIONS, ast.ClassDef)):
            found.setdefault(one.name, one)
    return found


def imports(tree):
    """Name -> (module, its name there), of modules beside this one."""
    return {name.asname or name.name: (one.module, name.name)
            for one in tree.body if isinstance(one, ast.ImportFrom) and one.level == 1 for name in one.names}


def exported(tree):
    for one in tree.body:
        if isinstance(one, ast.Assign) and getattr(one.targets[0], "id", "") == "__all__":
            return ast.literal_eval(one.value)
    return []


class Package:
    def __init__(self, folder, compiled):
        self.trees = {path.stem: ast.parse(path.read_text(encoding="utf-8"))
                      for path in (*folder.glob("*.py"), folder / "_core.pyi")}
        self.core = None
        if compiled:
            # From where it was built: it looks for its library from there.
            sys.dont_write_bytecode = True
            spec = importlib.util.spec_from_file_location("tricontact._core", os.path.realpath(compiled))
            try:
                self.core = importlib.util.module_from_spec(spec)
            except ImportError as error:
                sys.exit(f"error: {compiled} cannot be read: {error}")

    def definition(self, module, name):
        """(module, definition) of what a module defines or imports from its neighbours."""
        tree = self.trees[module]
        if name in definitions(tree):
            return module, definitions(tree)[name]
        if name in imports(tree) and imports(tree)[name][0] in self.trees:
            return self.definition(*imports(tree)[name])
        return module, None

    def text(self, module, node, *path):
        """The docstring of a definition; of the compiled part without the signature that pybind11 puts before it."""
        own = ast.get_docstring(node)
        if own or module != "_core" or not self.core:
            return own or ""
        there = self.core
        for name in path:
            there = inspect.getattr_static(there, name, None)
            there = getattr(there, "__func__", there)
        text = inspect.cleandoc(getattr(there, "__doc__", None) or "")
        return re.sub(r"\A(?:(?:\d+\. )?\w+\([^\n]*\)(?: -> [^\n]*)?\n*|Overloaded function\.\n*)+", "", text)


def escaped(text):
    """Words as they are: docstrings are no markup but for code between single `."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        return re.sub(r"([\\*`|_])", r"\\\1", text)
    parts[::2] = [re.sub(r"([\\*|_])", r"\\\1", part) for part in parts[::2]]
    return "".join(f"\\ ``{part}``\\ " if k % 2 else part for k, part in enumerate(parts))


def paragraphs(text, indent):
    """A docstring as reStructuredText: what is indented is code, unless it is a sentence."""
    space = " " * indent
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        lines = block.split("\n")
        if lines[0].startswith("    ") and not re.match(r"\s*[\w, ]+: .*", lines[0]):
            yield from ["", f"{space}.. code-block:: python", "", *(f"{space}   {line}" for line in lines)]
        elif block.strip():
            yield from ["", *(space + escaped(line.strip()) for line in lines)]


def signature(node, is_method=False):
    given = copy.copy(node.args)
    for part in ("posonlyargs", "args"):
        if is_method and getattr(given, part) and getattr(given, part)[0].arg in ("self", "cls"):
            setattr(given, part, getattr(given, part)[1:])
            break
    return f"({ast.unparse(given)})" + (f" -> {ast.unparse(node.returns)}" if node.returns else "")


def is_decorated(node, *names):
    return any(ast.unparse(one).split("(")[0] in names for one in node.decorator_list)


def function(package, module, node, indent=0, path=(), kind="function"):
    space = " " * indent
    if is_decorated(node, "property", "cached_property", "functools.cached_property"):
        yield from ["", f"{space}.. py:property:: {node.name}"]
        if node.returns:
            yield f"{space}   :type: {ast.unparse(node.returns)}"
    else:
        yield from ["", f"{space}.. py:{kind}:: {node.name}{signature(node, kind == 'method')}"]
        for word in ("staticmethod", "classmethod"):
            if is_decorated(node, word):
                yield f"{space}   :{word}:"
    yield from paragraphs(package.text(module, node, *path, node.name), indent + 3)


def described_class(package, module, node):
    bases = {ast.unparse(base) for base in node.bases}
    is_error = bases & {"ValueError", "RuntimeError", "Exception"}
    fields = [one for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name) and
              not one.target.id.startswith("_")]
    yield from ["", f".. py:{'exception' if is_error else 'class'}:: {node.name}"]
    yield from paragraphs(package.text(module, node, node.name), 3)
    for one in fields:
        yield from ["", f"   .. py:attribute:: {one.target.id}", f"      :type: {ast.unparse(one.annotation)}"]
    for name, one in definitions(node).items():
        is_shown = not name.startswith("_") or name in ("__getitem__", "__len__", "__iter__", "__contains__")
        if isinstance(one, FUNCTIONS) and is_shown:
            yield from function(package, module, one, 3, (node.name,), "method")


def described_module(package, module, title):
    tree = package.trees[module]
    yield from ["", title, ("-" if module != "__init__" else "=") * len(title), "",
                f".. py:module:: tricontact{'' if module == '__init__' else '.' + module}"]
    yield from paragraphs(ast.get_docstring(tree) or "", 0)
    names = sorted(exported(tree), key=lambda name: (name[0].isupper(), name))
    found = [(name, *package.definition(module, name)) for name in names]
    wanted = [(name, where, node) for name, where, node in found if node is not None]
    yield from ["", ".. list-table::", "   :widths: 30 70", ""]
    for name, where, node in wanted:
        first = re.split(r"(?<=[.:;])\s|\n\s*\n", package.text(where, node, name).strip() or "\\ ")[0].replace("\n", " ")
        yield from [f"   * - :py:obj:`{name}`", f"     - {escaped(first)}"]
    for name, where, node in wanted:
        yield from (described_class if isinstance(node, ast.ClassDef) else function)(package, where, node)


def main():
    source, folder = Path(sys.argv[1]) / "python" / "tricontact", Path(sys.argv[2])
    compiled = sys.argv[3] if len(sys.argv) > 3 and os.path.exists(sys.argv[3]) else None
    package = Package(source, compiled)
    lines = [".. Written by scripts/site/python_reference.py."]
    lines += described_module(package, "__init__", "Python reference")
    tree = package.trees["__init__"]
    for name in exported(tree):
        if name in package.trees and imports(tree).get(name, ("", ""))[0] is None:
            lines += described_module(package, name, f"tricontact.{name}")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "python-api.rst").write_text("\n".join(lines) + "\n", encoding="utf-8")
    n = sum(line.lstrip().startswith(".. py:") for line in lines)
    print(f"Python reference: {n} entries" + ("" if package.core else ", without the texts of the compiled part"))


if __name__ == "__main__":
    main()
