"""What the book is made of: its pages in reading order, and everything that a page may name."""
import json
import re
from pathlib import Path

from measured import Measured

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
FIGURE = re.compile(r"!\[([^\]]*)\]\((?:figures/)?([\w-]+)\.(svg|png)(?:\s+\"(.*?)\")?\)", re.S)


class Page:
    """A page in reading order. `number` is that of a chapter, or the letter-number of a handout."""

    def __init__(self, name, source, part):
        self.name, self.source, self.part = name, source, part
        self.number, self.title, self.text = "", "", ""
        self.is_reference = source is None

    @property
    def html(self):
        return f"group__{self.name}.html" if self.is_reference else f"{self.name}.html"

    @property
    def label(self):
        return f"{self.number} {self.title}" if self.number.isdigit() and self.name != "index" else self.title

    @property
    def lab(self):
        """The number of the lab that a reference page is about; empty for the given code's."""
        return re.sub(r"\D", "", self.name)


class Book:
    """The pages, numbered, and the names that exist. `figures` is the folder of the pictures."""

    def __init__(self, figures):
        self.figure_folder = figures
        self.errors = []
        self.pages = read_order()
        self.figures = figure_names()
        self.live_figures = live_figures() if (figures.parent / "live_engine.js").exists() else {}
        self.tests = visible_tests()
        self.mutants = known_mistakes()
        self.sources = given_sources(self.tests)
        self.contract_names = contract_names()
        self.settings = members_of("WorldSettings")
        self.numbers = default_numbers(self.settings)
        self.measured = Measured(DOCS / "figures" / "benchmarks.json")
        self.figure_number = {}
        self.citations = {}
        self.number_pages()

    def error(self, page, message, line=None):
        place = f"{page.source}:{line}" if line else page.source
        self.errors.append(f"{place}: {message}")

    def number_pages(self):
        chapter = 0
        for page in self.pages:
            if page.is_reference:
                page.title = f"Lab {page.lab}: the contract" if page.lab else "The given code: the contract"
                continue
            page.text = page.source.read_text()
            page.title = re.match(r"# (.*)", page.text).group(1)
            lab = re.match(r"lab(\d+)$", page.name)
            if lab:
                page.number = f"L{lab.group(1)}"
            elif page.name == "bibliography":
                self.citations = dict(re.findall(r"\{ref:(\w+)\|([^}]+)\}", page.text))
            else:
                page.number = str(chapter)
                chapter += 1
            self.number_figures(page)

    def number_figures(self, page):
        shown = [name for _, name, kind, _ in FIGURE.findall(page.text) if self.is_there(name, kind)]
        for place, name in enumerate(shown, 1):
            key = figure_key(page, name)
            if key in self.figure_number:
                self.error(page, f"figure {key} stands twice in the book")
            self.figure_number[key] = (f"{page.number}.{place}", page)

    def is_there(self, name, kind):
        """Pictures of the viewer may be missing; all others were made, or the build has ended."""
        return kind == "svg" or (self.figure_folder / f"{name}.png").exists()

    def figure_width(self, key, kind):
        """As drawn, in pixels."""
        data = (self.figure_folder / f"{key}.{kind}").read_bytes()
        if kind == "png":
            return int.from_bytes(data[16:20], "big")
        return float(re.search(rb'viewBox="[\d.-]+ [\d.-]+ ([\d.]+)', data)[1])

    def test_address(self, name):
        source, line = self.tests[name]
        return f"{listing_name(source)}.html#l{line:05}"


def figure_key(page, name):
    """Handouts call their pictures `figure` and `figure_topic`."""
    return page.name + name.removeprefix("figure") if is_of_handout(name) else name


def is_of_handout(name):
    return name == "figure" or name.startswith("figure_")


def read_order():
    pages, part = [], ""
    for line in (DOCS / "book.txt").read_text().splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith("Part:"):
            part = line.removeprefix("Part:").strip()
            continue
        name, _, source = line.partition(" ")
        if name.endswith("?") and not (DOCS / source.strip()).exists():
            continue
        pages.append(Page(name.rstrip("?"), DOCS / source.strip() if source.strip() else None, part))
    return pages


def figure_lines():
    lines = (DOCS / "figures" / "figures.txt").read_text().splitlines()
    return [line.split(maxsplit=2) for line in lines if line.strip() and not line.startswith("#")]


def figure_names():
    return [name for name, *_ in figure_lines()]


def live_figures():
    """Name → page and settings, as live.js opens it."""
    return {name: arguments[0] for name, tool, *arguments in figure_lines() if tool == "live"}


def visible_tests():
    """Name → (file without tests/, line) of every graded test that students see."""
    tests = {}
    for file in sorted((ROOT / "tests").glob("lab*/*.cpp")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            match = re.match(r"GRADED_TEST\(Lab\d+, (\w+),", line)
            if match:
                tests[match.group(1)] = (str(file.relative_to(ROOT)), number)
    return tests


def known_mistakes():
    names = set()
    for file in (ROOT / "tests" / "mutants").glob("lab*.json"):
        names |= {mutant["name"] for mutant in json.loads(file.read_text())["mutants"]}
    return names


def given_sources(tests):
    """Listings: the engine, and the files of the visible graded tests. Never a solution."""
    framework = ROOT / "framework"
    engine = {str(file.relative_to(framework)): file for file in sorted((framework / "engine").rglob("*.?pp"))}
    tested = {file: ROOT / file for file, _ in sorted(set(tests.values()))}
    return engine | tested


def contract_names():
    """The names of the contract's functions and types."""
    headers = "".join(header.read_text() for header in sorted((ROOT / "framework/include/cs550").glob("*.hpp")))
    code = re.sub(r"//[^\n]*", "", headers)
    return set(re.findall(r"\b(\w+)\(", code)) | set(re.findall(r"\b(?:class|struct|using) (\w+)", code))


class Setting:
    """A member of WorldSettings or BodyDef: its name, its default as the header writes it, and its comment."""

    def __init__(self, name, default, comment):
        self.name, self.comment = name, comment
        self.default = re.sub(r"Real\(([^)]*)\)|\w+::(\w+)", lambda m: m[1] or m[2], default).strip("{}")

    @property
    def number(self):
        """The default as a number, or None."""
        return float(self.default) if re.fullmatch(r"-?[\d.]+(e-?\d+)?", self.default) else None


def members_of(structure):
    header = (ROOT / "framework/include/cs550/world.hpp").read_text()
    members = re.search(rf"struct {structure} \{{(.*?)\n\}};", header, re.S).group(1)
    declarations = re.findall(r"^((?:  /// .*\n)*)  [\w:]+ (\w+) = ([^;\n]*);(?:\s*///< (.*))?$", members, re.M)
    return [Setting(name, default, behind or " ".join(re.findall(r"/// (.*)", before)))
            for before, name, default, behind in declarations]


def default_numbers(settings):
    """Name → number: the settings of a world, the properties of a body, the constants of the contract."""
    numbers = {member.name: member.number for member in settings + members_of("BodyDef") if member.number is not None}
    for header in sorted((ROOT / "framework/include/cs550").glob("*.hpp")):
        constants = re.findall(r"^inline constexpr Real (\w+) = Real\((-?[\d.]+(?:e-?\d+)?)\);", header.read_text(), re.M)
        numbers |= {name: float(number) for name, number in constants}
    return numbers | game_numbers()


def game_numbers():
    """game_NAME → number: what game_settings() changes."""
    source = (ROOT / "framework/engine/world/quality.cpp").read_text()
    changes = re.search(r"WorldSettings game_settings\(\) \{(.*?)\n\}", source, re.S)[1]
    members = [Setting(*match, "") for match in re.findall(r"settings\.(\w+) = ([^;]*);", changes)]
    return {f"game_{member.name}": member.number for member in members if member.number is not None}


def listing_name(name):
    return "src_" + re.sub(r"\W", "_", name)
