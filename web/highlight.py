"""Code as HTML, coloured by the classes of viewer/style.css. Needs Pygments (package python3-pygments)."""
from html import escape

from pygments.lexers import get_lexer_by_name
from pygments.token import Token

# The class of a word of code, by its kind; the first that fits.
CLASSES = {Token.Comment.Preproc: "k", Token.Comment.PreprocFile: "s", Token.Comment: "c", Token.Keyword: "k", Token.Operator.Word: "k",
           Token.Literal.String: "s", Token.Literal.Number: "n", Token.Name.Function: "f", Token.Name.Class: "f", Token.Name.Tag: "f",
           Token.Name.Builtin: "f", Token.Name.Attribute: "f"}


def highlighted(code, language):
    """The code as HTML, with the classes of style.css."""
    lexer = get_lexer_by_name({"wgsl": "rust"}.get(language, language), stripnl=False)  # older versions do not know WGSL, which looks like Rust
    spans = []
    for kind, text in lexer.get_tokens(code):
        name = next((name for of, name in CLASSES.items() if kind in of), None)
        spans.append(f'<span class="{name}">{escape(text, quote=False)}</span>' if name else escape(text, quote=False))
    return "".join(spans)
