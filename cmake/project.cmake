# Name, version and addresses of the project, in one place. Packages, programs and pages derive them; version_test.py compares the
# files that cannot, such as CITATION.cff.
set(RESTRIP_VERSION 1.0.0)
set(RESTRIP_RELEASE_DATE 2026-11-29)
set(RESTRIP_DESCRIPTION "Maintains triangle strips while a mesh changes, by proven rules")
set(RESTRIP_AUTHORS "The restrip authors")
# Packages and pages have no link to an empty address.
set(RESTRIP_CONTACT "")     # NAME@HOST, for the maintainer of the Debian packages
set(RESTRIP_REPOSITORY "")  # https://HOST/OWNER/NAME
set(RESTRIP_HOMEPAGE "")
set(RESTRIP_ISSUES "")
