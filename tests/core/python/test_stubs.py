"""The stubs match the module; everything public is documented and typed."""

import ast
import doctest
import importlib.util
import inspect
import pkgutil
import re
import unittest
from pathlib import Path

import adore
from adore import _core

PACKAGE = Path(adore.__file__).parent
SOURCE = Path(__file__).resolve().parents[3] / "core" / "python"


def signature(function):
    """Names of the parameters that pybind11 writes into the first line of the docstring."""
    line = function.__doc__.splitlines()[0]
    inside = line[line.index("(") + 1 : line.rindex(") ->")]
    return [name for name in re.findall(r"(?:^|, )(\w+): ", inside)]


class Core(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse((PACKAGE / "_core.pyi").read_text())

    def test_the_stub_names_what_the_module_has(self):
        stub = {n.name for n in self.tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        module = {n for n in dir(_core) if not n.startswith("_")}
        self.assertEqual(stub, module)

    def test_functions_have_the_parameters_of_the_stub_and_a_docstring(self):
        checked = 0
        for node in self.tree.body:
            if not isinstance(node, ast.FunctionDef):
                continue
            function = getattr(_core, node.name)
            self.assertEqual([a.arg for a in node.args.args], signature(function), node.name)
            self.assertGreater(len(function.__doc__.splitlines()), 2, node.name)
            checked += 1
        self.assertGreater(checked, 15)

    def test_classes_have_the_members_of_the_stub(self):
        for node in self.tree.body:
            if not isinstance(node, ast.ClassDef):
                continue
            kind = getattr(_core, node.name)
            self.assertEqual(ast.get_docstring(node), kind.__doc__.strip(), node.name)
            members = {}
            for n in node.body:
                if isinstance(n, ast.FunctionDef):
                    members.setdefault(n.name, n)
            stub = {n for n in members if not n.startswith("_")}
            self.assertEqual(stub, {n for n in vars(kind) if not n.startswith("_")}, node.name)
            for name, member in members.items():
                if name.startswith("__"):
                    continue
                decorators = {d.id for d in member.decorator_list if isinstance(d, ast.Name)}
                found = inspect.getattr_static(kind, name)
                self.assertEqual("property" in decorators, isinstance(found, property), f"{node.name}.{name}")
                if "property" in decorators:
                    self.assertTrue(found.__doc__, f"{node.name}.{name}")
                else:
                    arguments = [a.arg for a in member.args.args if a.arg != "self"]
                    given = [a for a in signature(getattr(kind, name)) if a != "self"]
                    self.assertEqual(arguments, given, f"{node.name}.{name}")


class Variables(unittest.TestCase):
    def test_the_stub_of_the_variables_is_the_schema(self):
        spec = importlib.util.spec_from_file_location("write_stubs", SOURCE / "write_stubs.py")
        writer = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(writer)
        text = (PACKAGE / "variables.pyi").read_text()
        self.assertEqual(text, writer.text(), "run core/python/write_stubs.py")
        calc = (PACKAGE / "calc.pyi").read_text()
        self.assertEqual(calc, writer.calc_text(writer.described_calculators()), "run core/python/write_stubs.py")
        ast.parse(calc)
        names = {n.target.id for n in ast.parse(text).body[-1].body if isinstance(n, ast.AnnAssign)}
        self.assertEqual(names, set(adore.schema.variable_names()))


class Documented(unittest.TestCase):
    def test_everything_public_has_a_docstring_and_types(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        checked = 0
        for info in pkgutil.iter_modules([str(PACKAGE)]):
            if info.name == "_core":
                continue
            module = importlib.import_module(f"adore.{info.name}")
            self.assertTrue(module.__doc__, info.name)
            for name in module.__all__:
                found = inspect.getattr_static(module, name, None)
                self.assertIsNotNone(found, f"adore.{info.name}.{name}")
                if not (inspect.isclass(found) or inspect.isfunction(found)):
                    continue
                self.assertTrue(found.__doc__, f"adore.{info.name}.{name}")
                functions = [(name, found)] if inspect.isfunction(found) else [
                    (f"{name}.{n}", f.fget if isinstance(f, property) else getattr(f, "__func__", f))
                    for n, f in vars(found).items() if not n.startswith("_") and (inspect.isfunction(f) or isinstance(f, (property, classmethod)))
                ]  # fmt: skip
                for label, function in functions:
                    self.assertTrue(function.__doc__, label)
                    annotations = function.__annotations__
                    self.assertIn("return", annotations, label)
                    for parameter in inspect.signature(function).parameters.values():
                        if parameter.name not in ("self", "cls"):
                            self.assertIn(parameter.name, annotations, label)
                    checked += 1
        self.assertGreater(checked, 60)

    def test_examples_in_docstrings_give_what_they_say(self):
        tried = 0
        for module in [adore] + [importlib.import_module(f"adore.{i.name}") for i in pkgutil.iter_modules([str(PACKAGE)])]:
            found = doctest.DocTestFinder().find(module, extraglobs={"adore": adore})
            for example in found:
                result = doctest.DocTestRunner().run(example)
                self.assertEqual(result.failed, 0, example.name)
                tried += result.attempted
        self.assertGreater(tried, 20)

    def test_no_module_imports_itself_through_others(self):
        # Also imports inside functions and those for type checkers only.
        imports = {}
        for file in PACKAGE.glob("*.py"):
            found = set()
            for node in ast.walk(ast.parse(file.read_text())):
                if isinstance(node, ast.ImportFrom) and node.level == 1:
                    found |= {node.module.split(".")[0]} if node.module else {alias.name for alias in node.names}
            imports[file.stem] = found
        self.assertIn("run", imports["deck"])
        self.assertIn("errors", imports["run"])

        def reached(module, seen):
            for each in imports.get(module, ()):
                if each not in seen:
                    seen.add(each)
                    reached(each, seen)
            return seen

        for module in imports:
            self.assertNotIn(module, reached(module, set()), module)

    def test_all_names_what_the_package_offers(self):
        for name in adore.__all__:
            self.assertTrue(hasattr(adore, name), name)


if __name__ == "__main__":
    unittest.main()
