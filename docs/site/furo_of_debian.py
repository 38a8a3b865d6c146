"""Mends what Debian's furo leaves undone, in the site that was built.

Its script begins with an `import`, which a browser refuses outside of a module: the switch between light and dark and the marks in the list
of contents were dead. Its style sheet takes normalize.css from an address of Debian's web server, where no other server has it.
"""

import re
from pathlib import Path

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")


def mend(app, exception) -> None:
    static = Path(app.outdir) / "_static"
    script, style = static / "scripts/furo.js", static / "styles/furo.css"
    if exception or not (script.exists() and style.exists()):
        return
    text = script.read_text(encoding="utf-8")
    if text.startswith("import Gumshoe"):
        library = (static / "scripts/gumshoe-patched.js").read_text(encoding="utf-8")
        script.write_text(library + text.partition("\n")[2], encoding="utf-8")
    rules = NORMALIZE.read_text(encoding="utf-8") if NORMALIZE.exists() else ""
    text = style.read_text(encoding="utf-8")
    style.write_text(re.sub(r"^@import url\(/javascript/[^)]*\);", lambda _: rules, text), encoding="utf-8")


def setup(app):
    app.connect("build-finished", mend)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
