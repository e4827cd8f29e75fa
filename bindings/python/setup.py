"""Puts the C library into the package: the one that RESTRIP_C_LIBRARY names, or one compiled here by $CXX (c++), which needs
only C++20. The sources are in the repository around this folder; a source archive has copies of them in `sources/`."""
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
from setuptools.command.sdist import sdist
from setuptools.dist import Distribution

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    try:
        from wheel.bdist_wheel import bdist_wheel
    except ImportError:
        bdist_wheel = None  # a source archive needs no wheel

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE / "sources" if (HERE / "sources").is_dir() else HERE.parents[1]
SOURCES = ("cmake/project.cmake", "LICENSE", "bindings/c", "runtime/include", "runtime/src", "tables/include")  # the parts of the repository that the archive contains
C = ROOT / "bindings/c"
PROJECT = dict(re.findall(r'^set\(RESTRIP_(\w+) "?(.*?)"?\)', (ROOT / "cmake/project.cmake").read_text(), re.M))
VERSION = PROJECT["VERSION"]
LINKS = {name: PROJECT[key] for name, key in (("Homepage", "HOMEPAGE"), ("Source", "REPOSITORY"), ("Issues", "ISSUES")) if PROJECT[key]}
SCRATCH = tempfile.mkdtemp()  # nothing is written into the sources
NAME = {"darwin": "librestrip_c.dylib", "win32": "restrip_c.dll"}.get(sys.platform, "librestrip_c.so")


class WithLibrary(build_py):
    def run(self):
        super().run()
        # What is installed with pip install -e is imported from the sources.
        editable = getattr(self, "editable_mode", False)
        target = (HERE / "src" if editable else pathlib.Path(self.build_lib)) / "restrip" / NAME
        target.parent.mkdir(parents=True, exist_ok=True)
        if not editable:
            shutil.copyfile(ROOT / "LICENSE", target.parent / "LICENSE")
        made = os.environ.get("RESTRIP_C_LIBRARY")
        if made:
            shutil.copyfile(made, target)
            return
        library = pathlib.Path(SCRATCH) / "library.cpp"  # one unit: separately, the same headers are compiled thirty times
        library.write_text("".join(f'#include "{source.as_posix()}"\n' for source in sorted((ROOT / "runtime/src").rglob("*.cpp"))))
        subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O2", "-DNDEBUG", "-ffp-contract=off", "-fPIC", "-shared", "-fvisibility=hidden",
                        "-fvisibility-inlines-hidden", *shlex.split(os.environ.get("CXXFLAGS", "")), f'-DRESTRIP_VERSION="{VERSION}"',
                        *(f"-I{folder}" for folder in (C / "include", ROOT / "runtime/include", ROOT / "runtime/src", ROOT / "tables/include")),
                        C / "restrip.cpp", library, "-o", target], check=True)


class WithSources(sdist):
    """An archive from which pip compiles the package without the repository."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for name in SOURCES:
            source, target = ROOT / name, pathlib.Path(base_dir) / "sources" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copytree(source, target) if source.is_dir() else shutil.copyfile(source, target)
        for name in ("example.py", "pyproject.toml"):
            shutil.copyfile(HERE / name, pathlib.Path(base_dir) / name)


class WithBinary(Distribution):
    def has_ext_modules(self):  # installs into the folder for one platform
        return True


commands = {"build_py": WithLibrary, "sdist": WithSources}
if bdist_wheel:
    class OfThisMachine(bdist_wheel):
        """The library depends on the machine, but not on the version of Python."""

        def get_tag(self):
            return ("py3", "none", super().get_tag()[2])

    commands["bdist_wheel"] = OfThisMachine

setup(name="restrip", version=VERSION, description="Triangle strips, made from scratch and maintained while a mesh changes", license="MIT",
      author=PROJECT["AUTHORS"], keywords=["triangle strips", "level of detail", "mesh", "index buffer"],
      project_urls={"Paper": "https://doi.org/10.2312/LocalChapterEvents/ItalChap/ItalianChapConf2007/023-029", **LINKS},
      classifiers=["Development Status :: 5 - Production/Stable", "Intended Audience :: Developers", "License :: OSI Approved :: MIT License",
                   "Programming Language :: C++", "Programming Language :: Python :: 3", "Topic :: Multimedia :: Graphics :: 3D Modeling", "Typing :: Typed"],
      long_description=(HERE / "README.md").read_text(), long_description_content_type="text/markdown", python_requires=">=3.8",
      packages=["restrip"], package_dir={"": "src"}, package_data={"restrip": ["py.typed"]}, install_requires=["numpy"],
      options={"build": {"build_base": SCRATCH}, "egg_info": {"egg_base": SCRATCH}},
      cmdclass=commands, distclass=WithBinary)
