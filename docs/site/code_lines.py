"""Each line of a code box is an element of its own: a line that is too long goes on below, indented (_static/ljmd.css)."""

from pygments.formatters import HtmlFormatter
from sphinx.highlighting import PygmentsBridge


class LineFormatter(HtmlFormatter):
    def _format_lines(self, tokensource):
        for is_code, line in super()._format_lines(tokensource):
            text = line.rstrip("\n")
            yield is_code, f'<span class="line">{text}</span>\n' if is_code and text else line


def setup(app):
    PygmentsBridge.html_formatter = LineFormatter
    return {"parallel_read_safe": True, "parallel_write_safe": True}
