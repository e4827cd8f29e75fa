"""A clone with core.autocrlf=true, Git for Windows' default, has the bytes of the repository: .gitattributes asks for LF in
every text file, so tables verify and scripts run."""
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, "-c", "safe.directory=*", *arguments], check=True, capture_output=True).stdout


class LineEnds(unittest.TestCase):
    def setUp(self):
        if not (ROOT / ".git").exists():
            self.skipTest("left out: this is no checkout of git")

    def test_a_checkout_with_carriage_returns(self):
        with tempfile.TemporaryDirectory() as folder:
            # The index of the working tree, uncommitted files included, as a repository of its own.
            git(folder, "init", "-q", ".")
            listed = git(ROOT, "ls-files", "-z", "-co", "--exclude-standard").decode().rstrip("\0").split("\0")
            kept = [name for name in listed if (ROOT / name).is_file()]
            for name in kept:
                copy = Path(folder) / name
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes((ROOT / name).read_bytes())
            git(folder, "-c", "core.autocrlf=false", "add", "-A")
            git(folder, "-c", "user.name=test", "-c", "user.email=test", "commit", "-qm", "all")
            clone = folder + "/clone"
            git(folder, "-c", "core.autocrlf=true", "clone", "-q", "-c", "core.autocrlf=true", folder, clone)
            self.assertGreater(len(kept), 500)
            changed = [name for name in kept if (Path(clone) / name).read_bytes() != (ROOT / name).read_bytes()]
            self.assertEqual(changed, [])


unittest.main()
