"""Puts the C library into the package: the one that RESTRIP_C_LIBRARY names, or one compiled here by $CXX (c++), which needs
only C++20. The sources are in the repository around this folder."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from setuptools import setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
C = ROOT / "bindings/c"
VERSION = re.search(r"project\(\s*restrip VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
SCRATCH = tempfile.mkdtemp()  # the sources do not change
NAME = {"darwin": "librestrip_c.dylib", "win32": "restrip_c.dll"}.get(sys.platform, "librestrip_c.so")


class WithLibrary(build_py):
    def run(self):
        super().run()
        target = pathlib.Path(self.build_lib) / "restrip" / NAME
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / "LICENSE", target.parent / "LICENSE")
        made = os.environ.get("RESTRIP_C_LIBRARY")
        if made:
            shutil.copyfile(made, target)
            return
        subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O2", "-DNDEBUG", "-ffp-contract=off", "-fPIC", "-shared", "-fvisibility=hidden",
                        "-fvisibility-inlines-hidden", *shlex.split(os.environ.get("CXXFLAGS", "")), f'-DRESTRIP_VERSION="{VERSION}"',
                        *(f"-I{folder}" for folder in (C / "include", C, ROOT / "runtime/include", ROOT / "tables/include")),
                        C / "restrip.cpp", "-o", target], check=True)


class OfThisMachine(bdist_wheel):
    """The library depends on the machine, but not on the version of Python."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])


setup(name="restrip", version=VERSION, description="Triangle strips, made from scratch and maintained while a mesh changes", license="MIT",
      long_description=(HERE / "README.md").read_text(), long_description_content_type="text/markdown", python_requires=">=3.8",
      packages=["restrip"], package_dir={"": "src"}, package_data={"restrip": ["py.typed"]}, install_requires=["numpy"],
      options={"build": {"build_base": SCRATCH}, "egg_info": {"egg_base": SCRATCH}},
      cmdclass={"build_py": WithLibrary, "bdist_wheel": OfThisMachine})
