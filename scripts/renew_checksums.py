#!/usr/bin/env python3
"""Renews the two sums in the last line of certificates that were changed by hand (docs/reference/certificate.md).

The verifier refuses a changed certificate for its sums before it looks at its rules. With new sums it judges them, and
names a configuration in which a changed rule fails. Nothing is proven by this program: what it writes may be wrong.
"""
import argparse
import pathlib
import re
import sys


def renewed(data):
    """The bytes of a certificate with the sums of its bytes, or None if its last line is not `end ROWS SUM SUM`."""
    found = re.search(rb"(?:\A|\n)(end [0-9]+) [0-9]+ [0-9]+\n\Z", data)
    if not found:
        return None
    body = data[:found.start(1)]
    return body + b"%s %d %d\n" % (found[1], sum(body), sum(at * byte for at, byte in enumerate(body, 1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/renew_checksums.py rules/certificates/operations/divide-face.cert")
    parser.add_argument("file", nargs="+", type=pathlib.Path)
    for file in parser.parse_args().file:
        try:
            data = file.read_bytes()
        except OSError as error:
            sys.exit(f"{file}: {error.strerror}")
        new = renewed(data)
        if new is None:
            sys.exit(f'{file}: expected a certificate, whose last line is "end", rows and two sums')
        file.write_bytes(new)
        print(f"{file}: {'new sums; not proven' if new != data else 'the sums were right'}")


if __name__ == "__main__":
    main()
