"""Formulas as MathML, made by KaTeX while the pages are built: a page needs no script, font or network for them."""
import json
import re
import subprocess

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util import logging

KATEX = "/usr/share/javascript/katex/katex.js"
WORKER = """
const katex = require(process.argv[1]);
require('readline').createInterface({input: process.stdin}).on('line', line => {
  const [tex, displayMode] = JSON.parse(line);
  let answer;
  try {
    answer = {html: katex.renderToString(tex, {displayMode, output: 'mathml', strict: 'ignore'})};
  } catch (error) {
    answer = {error: error.message};
  }
  console.log(JSON.stringify(answer));
});
"""
# Browsers show mathvariant as plain letters; Unicode has letters of their own.
VARIANTS = {
    "bold": (0x1D400, 0x1D41A, 0x1D7CE),
    "bold-italic": (0x1D468, 0x1D482, None),
    "double-struck": (0x1D538, 0x1D552, 0x1D7D8),
    "script": (0x1D49C, 0x1D4B6, None),
}
logger = logging.getLogger(__name__)
worker = None


def letters(match):
    capital, small, digit = VARIANTS[match[2]]

    def other(letter):
        for first, base, count in (("A", capital, 26), ("a", small, 26), ("0", digit, 10)):
            if base and 0 <= ord(letter) - ord(first) < count:
                return chr(base + ord(letter) - ord(first))
        return letter

    return f'<{match[1]} mathvariant="normal">' + "".join(map(other, match[3])) + f"</{match[1]}>"


def render(tex, display, node):
    global worker
    if worker is None:
        try:
            worker = subprocess.Popen(
                ["node", "-e", WORKER, KATEX], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
        except OSError as error:
            raise ExtensionError(f"formulas need Node.js: {error}") from error
    worker.stdin.write(json.dumps([tex, display]) + "\n")
    worker.stdin.flush()
    answer = json.loads(worker.stdout.readline() or '{"error": "KaTeX did not answer"}')
    if "error" in answer:
        logger.warning("%s", answer["error"], location=node)
        return ""
    return re.sub(
        r'<(mi|mn|mtext) mathvariant="(%s)">([^<]*)</(?:mi|mn|mtext)>' % "|".join(VARIANTS), letters, answer["html"]
    )


def inline(visitor, node):
    visitor.body.append(render(node.astext(), False, node))
    raise nodes.SkipNode


def block(visitor, node):
    visitor.body.append(visitor.starttag(node, "div", CLASS="math") + render(node.astext(), True, node) + "</div>\n")
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("katex", (inline, None), (block, None))
    app.config.html_math_renderer = "katex"
    return {"parallel_read_safe": True, "parallel_write_safe": False}
