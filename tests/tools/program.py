"""The program `restrip` as the tests run it."""
import subprocess


class Program:
    """Run by a call: Program(path)("stripify", mesh, "-o", out)."""

    def __init__(self, path):
        self.path = path

    def __call__(self, *arguments, code=0):
        """The finished program with its output; it must end with this code."""
        done = subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert done.returncode == code, (arguments, done.returncode, done.stderr, done.stdout[-500:])
        return done
