"""What a page is written in, as Doxygen takes it. Every name that a page mentions in one of the forms below
must exist: a figure, a test, a known mistake, a source file, a citation. What does not is an error, and so is a
misspelt form.

  $x$, $$x$$                       formulas
  [text](chapter.md#anchor)        a link to another page of the book, which works in the Markdown file, too
  ![alt](figures/name.svg "caption")   a numbered figure; the caption may hold formulas. A .png is taken
                                   by the viewer, and left out where that was not built
  {fig:name}                       its number, as a link
  {api:hill_climb()}               a function or type of the contract
  {src:engine/world/step.cpp}            the listing of a given file
  {test:Name}                      the listing of a visible graded test, at its first line
  {mutant:name}                    a known mistake of tests/mutants
  {default:substeps}               the default of a member of WorldSettings or BodyDef, or a constant of the
                                   contract, read from its header; an expression of them and a format work too:
                                   {default:1/(60*substeps)|.1e}. What game_settings() changes is named
                                   {default:game_substeps}
  {defaults}                       a table of all of them
  {code:lab4 overlap}              a function of the reference as a listing, in a paragraph of its own; the
                                   declaration where the reference is absent. Given code is named by its file:
                                   {code:engine/contacts/softness.cpp soft_contact}
  {measured:name}                  what ./cs550 bench has measured (measured.py): `processor`, `date`, the tables
                                   `times` and `quality`, `exponent support/climb`, `time manifold/cold/128`
  [@Key], [@Key, §2]               a citation; {ref:Key|label} defines it in the bibliography
"""
import math
import re
from html import escape, unescape
from pathlib import Path

from book import FIGURE, figure_key, is_of_handout, listing_name
from listing import find_function

WIDE = 720  # pixels: a phone scrolls such a figure instead of making its letters unreadable
CODE_OR_TEXT = re.compile(r"(^```.*?^```[^\n]*\n?|``[^`]+``|`[^`]+`)", re.M | re.S)
FENCE_OR_HEADING = re.compile(r"(^```.*?^```)|^(##+) ([^\n]*)$", re.M | re.S)
BOLD = re.compile(r"\*\*(.+?)\*\*", re.S)
MEASURED = re.compile(r"\{measured:([^}]+)\}")
DEFAULT = re.compile(r"\{default:([^}|]+)(?:\|([^}]*))?\}")
CODE = re.compile(r"^\{code:(\S+) (\w+)\}$", re.M)
MATH = re.compile(r"\$\$(.+?)\$\$|\$([^$]+?)\$", re.S)
# Of a converted page.
CODE_OR_FORMULA = re.compile("|".join([r"^```.*?^```", r"``[^`]+``", r"`[^`]+`", r"<code>.*?</code>",
                                       r"\\f\[.*?\\f\]", r"\\f\$.*?\\f\$", r"\\\(.*?\\\)"]), re.M | re.S)
LOOKS_LIKE_FORM = re.compile(r"\{[A-Za-z]+[: ][^}]*\}")
FORMS = "fig, api, src, test, mutant, ref, default, defaults, measured, and code in a paragraph of its own"


class Markup:
    """Converts the text of one page. `cited` gathers the keys of its citations."""

    def __init__(self, book, page):
        self.book, self.page = book, page
        self.cited = set()

    def error(self, message, line=None):
        self.book.error(self.page, message, line)

    def line_of(self, form):
        return self.page.source.read_text().split(form)[0].count("\n") + 1

    def convert(self, text):
        # Listings are put in last, since code looks like markup.
        listings = [self.listing(*match.groups(), match[0]) for match in CODE.finditer(text)]
        pieces = CODE.sub("{listing}", text).split("{listing}")
        return "".join(piece for pair in zip(map(self.convert_text, pieces), listings + [""]) for piece in pair)

    def convert_text(self, text):
        text = FIGURE.sub(lambda m: self.figure(*m.groups()), text)
        text = text.replace("{defaults}", self.defaults())
        text = MEASURED.sub(lambda m: self.measured(m[1]), text)
        text = DEFAULT.sub(lambda m: self.default(*m.groups()), text)
        text = re.sub(r"^## (L(\d+)\.(\d+) .*)$", r"## \1 {#L\2_\3}", text, flags=re.M)
        text = FENCE_OR_HEADING.sub(lambda m: self.heading(*m.groups()), text)
        text = re.sub(r"<details><summary>(.*?)</summary>",
                      lambda m: raw(f"<details><summary>{self.inline_html(m[1])}</summary>"), text, flags=re.S)
        text = text.replace("</details>", raw("</details>"))
        text = re.sub(r"(\]\([\w-]+)\.md#", r"\1.html#", text)
        text = re.sub(r"\[`?([^\]`]+)`?\]\(([^)#]+)\)", lambda m: self.link(*m.groups()), text)
        pieces = re.split(r"(@htmlonly.*?@endhtmlonly)", text, flags=re.S)
        text = "".join(piece if piece.startswith("@htmlonly") else self.convert_prose(piece) for piece in pieces)
        self.find_unknown_forms(text)
        return text

    def find_unknown_forms(self, text):
        """A form that was not converted would be printed as it is written."""
        for form in map(unescape, LOOKS_LIKE_FORM.findall(CODE_OR_FORMULA.sub("", text))):
            self.error(f"{form} is no form of a page; known: {FORMS}", self.line_of(form))

    def heading(self, fence, marks, title):
        """An anchor that stays the same when other headings are added, so that it can be cited."""
        if fence or title.endswith("}"):
            return fence or f"{marks} {title}"
        return f"{marks} {title} {{#{self.page.name}_{re.sub(r'[^a-z0-9]+', '_', title.lower()).strip('_')}}}"

    def convert_prose(self, text):
        # Doxygen knows no formula between asterisks, and leaves a gap before one in parentheses.
        text = BOLD.sub(lambda m: f"<b>{m[1]}</b>" if "$" in m[1] else m[0], text)
        text = re.sub(r"\(\$([^$()]+)\$\)", r"$(\1)$", text)
        pieces = CODE_OR_TEXT.split(text)
        return "".join(self.code(piece) if i % 2 else self.roles(MATH.sub(doxygen_math, piece), markdown_link)
                       for i, piece in enumerate(pieces))

    def code(self, piece):
        """A visible test in code font is a link, in handouts too."""
        name = piece.strip("`")
        if piece.startswith("`") and name in self.book.tests:
            return markdown_link(name, self.book.test_address(name))
        # To Doxygen, a quote ends what a single backtick has begun.
        return f"`{piece}`" if re.fullmatch(r"`[^`]*'[^`]*`", piece) else piece

    def inline_html(self, text):
        """Formulas, code, emphasis and the roles, as HTML."""
        text = escape(text, quote=False)
        text = MATH.sub(lambda m: rf"\({m.group(1) or m.group(2)}\)", text)
        text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
        text = re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)
        return self.roles(text, html_link)

    def figure(self, alt, name, kind, caption):
        if not self.book.is_there(name, kind):
            return "*A picture of the viewer belongs here; the viewer was not built with this book.*"
        key = figure_key(self.page, name)
        if not is_of_handout(name) and name not in self.book.figures:
            self.error(f"figure {name} is not in figures.txt")
        number, _ = self.book.figure_number[key]
        text = self.inline_html(caption or alt + ".")
        live = f' data-live="{escape(self.book.live_figures[name])}"' if name in self.book.live_figures else ""
        live += " data-start" if live and self.page.name == "index" else ""  # the first page opens on a live scene
        wide = ' class="wide"' if self.book.figure_width(key, kind) > WIDE else ""
        return raw(f'<figure id="fig_{key}"{live}{wide}><img src="figures/{key}.{kind}" alt="{escape(" ".join(alt.split()))}"/>'
                   f"<figcaption><b>Figure {number}.</b> {text}</figcaption></figure>")

    def listing(self, place, name, form):
        found = find_function(place, name)
        if not found:
            self.error(f"{form} names no function that exists", self.line_of(form))
            return form
        code, file, is_definition = found
        note = "" if is_definition else ". Writing its body is part of the lab."
        return f'```{{.cpp}}\n{code}\n```\n<p class="origin"><code>{file}</code>{note}</p>\n'

    def link(self, text, target):
        """Links of handouts are paths in the repository: to headers of the contract, or to files there."""
        if re.match(r"https?:", target):
            return f"[{text}]({target})"
        name = Path(target).name
        if target.endswith(".hpp"):
            return f'@ref {name} "{name}"'
        if target.endswith(".cpp"):
            return f"`{name}`"
        if target.endswith(".md") or target.endswith(".html"):
            return f"[{text}]({Path(target).stem}.html)"
        self.error(f"a link to {target} leads out of the book")
        return text

    # ------------------------------------------------------------------------ {role:value} and [@Key]

    def roles(self, text, link):
        def role(match):
            kind, value = match.groups()
            try:
                return getattr(self, "role_" + kind)(value, link)
            except KeyError:
                self.error(f"{match[0]} names nothing that exists", self.line_of(match[0]))
                return value

        text = re.sub(r"\{(fig|api|src|test|mutant|ref):([^}]+)\}", role, text)
        return re.sub(r"\[@(\w+)(,[^\]]*)?\]", lambda m: self.citation(*m.groups(), link), text)

    def citation(self, key, place, link):
        if key not in self.book.citations:
            self.error(f"[@{key}] is not in the bibliography")
            return key
        self.cited.add(key)
        return link(f"[{self.book.citations[key]}{place or ''}]", f"bibliography.html#{key}")

    def role_fig(self, name, link):
        number, page = self.book.figure_number[name]
        return link(f"Figure {number}", f"{page.html}#fig_{name}")

    def role_api(self, name, link):
        if link is html_link:  # Doxygen checks names in other text
            if name.removesuffix("()") not in self.book.contract_names:
                raise KeyError(name)
            return f"<code>{escape(name)}</code>"
        return f'@ref cs550::{name.rstrip("()")} "{name}"'

    def role_src(self, name, link):
        self.book.sources[name]  # must exist
        return link(name, f"{listing_name(name)}.html")

    def role_test(self, name, link):
        return link(name, self.book.test_address(name))

    def role_mutant(self, name, _):
        if self.book.mutants and name not in self.book.mutants:
            raise KeyError(name)
        return f"<code>{name}</code>"

    def default(self, expression, form):
        try:
            number = eval(expression, {"__builtins__": {}, "pi": math.pi}, self.book.numbers)
        except (NameError, SyntaxError) as reason:
            self.error(f"{{default:{expression}}}: {reason}")
            return expression
        text = format(number, form or "g")
        return re.sub(r"e([+-]\d+)", lambda m: rf"\cdot10^{{{int(m[1])}}}", text)

    def measured(self, name):
        try:
            return self.book.measured.text(name)
        except KeyError:
            self.error(f"{{measured:{name}}} is not in docs/figures/benchmarks.json")
            return name

    def defaults(self):
        rows = [f"| `{setting.name}` | {setting.default} | {setting.comment} |" for setting in self.book.settings]
        return "\n".join(["| Setting | Default | Meaning |", "|---|---|---|"] + rows)

    def role_ref(self, value, _):
        key, label = value.split("|")
        return f'@anchor {key} <b>[{label}]</b>'


def raw(html):
    return f"@htmlonly {html} @endhtmlonly"


def doxygen_math(match):
    display, inline = match.groups()
    return rf"\f[{display}\f]" if display else rf"\f${inline}\f$"


def markdown_link(text, address):
    return f'<a href="{address}">{escape(text)}</a>'


def html_link(text, address):
    """For text that is HTML already."""
    return f'<a href="{address}">{text}</a>'
