"""Several threads of Python read one mesh, as help(restrip.LiveMesh) allows; each gets what one reader gets. With a library compiled
with ThreadSanitizer (RESTRIP_C_LIBRARY), whose run-time library is loaded first, the process fails if they race."""
import sys
import threading

import numpy as np

import restrip

SIDE = 24
start = np.add.outer(np.arange(SIDE) * (SIDE + 1), np.arange(SIDE)).ravel()
faces = np.concatenate([np.column_stack([start, start + 1, start + SIDE + 2]), np.column_stack([start, start + SIDE + 2, start + SIDE + 1])])
mesh = restrip.LiveMesh(faces)
mesh.begin_buffer(history=1000)
mesh.update()
mesh.collapse(mesh.find(60, 61))  # not updated since: a reader must not catch up
readers = {
    "index_count": lambda: mesh.index_count, "indices": mesh.indices, "strip_indices": lambda: np.concatenate(mesh.strip_indices()), "faces": mesh.faces,
    "strip_count": lambda: mesh.strip_count, "buffer": mesh.buffer, "strips": lambda: np.concatenate(mesh.strips()), "colors": lambda: mesh.colors,
    "check": mesh.check, "history": lambda: mesh.history, "corners": lambda: mesh.corners(7), "ends": lambda: mesh.ends(5),
    "check_each": lambda: mesh.check_each("flip", np.arange(400)), "find_each": lambda: mesh.find_each(faces[:, 0], faces[:, 1]),
    "why_not": lambda: mesh.why_not("bisect", 4), "repr": lambda: repr(mesh)}
alone = {name: read() for name, read in readers.items()}
wrong = []


def reading():
    for _ in range(5):
        for name, read in readers.items():
            if not np.array_equal(read(), alone[name]):
                wrong.append(name)


sys.setswitchinterval(1e-6)
threads = [threading.Thread(target=reading) for _ in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert not wrong, set(wrong)
print(f"{len(readers)} readers: as one")
