"""What ./cs550 bench has measured, from docs/figures/benchmarks.json, as text and tables of a page."""
import json


class Measured:
    def __init__(self, file):
        self.report = json.loads(file.read_text())

    def text(self, name):
        """The form {measured:name} of a page. Raises KeyError for an unknown name."""
        kind, _, argument = name.partition(" ")
        return {"processor": self.processor, "date": lambda _: self.report["date"], "times": self.times,
                "quality": self.quality, "exponent": self.exponent, "time": self.stage_time,
                "memory": self.memory}[kind](argument)

    def processor(self, _):
        return " ".join(self.report["processor"].replace("(R)", "").replace("(TM)", "").split())

    def exponent(self, family):
        """The fitted exponent of a family, such as support/climb."""
        return f"{_named(self.report['exponents'], family)['exponent']:.2f}"

    def stage_time(self, stage):
        """The time of a stage, such as manifold/cold/128."""
        return _time(_named(self.report["stages"], stage)["seconds"])

    def memory(self, key):
        return f"{self.report['memory'][key]:.0f}"

    def times(self, _):
        """Milliseconds per step, and the ratio to the fastest engine of the scene."""
        def cell(run, fastest):
            return f"{1e3 * run['seconds']:.3g} ({run['seconds'] / fastest:.2g})"
        return self._table(lambda run, runs: cell(run, min(other["seconds"] for other in runs)))

    def quality(self, _):
        """Deepest penetration (mm), pairs deeper than 2 cm, kinetic energy (J), drift (mm) where it is an error, lost bodies if any."""
        def cell(run):
            lost = f", {run['lost_bodies']} lost" if run["lost_bodies"] else ""
            drift = "" if run["drift"] is None else f", {_short(1e3 * run['drift'])}"
            return f"{_short(1e3 * run['deepest'])}, {run['deep_pairs']}, {_short(run['kinetic_energy'])}{drift}{lost}"
        return self._table(lambda run, _: cell(run))

    def _table(self, cell):
        engines = list(dict.fromkeys(run["engine"] for scene in self.report["scenes"] for run in scene["runs"]))
        lines = [f"| | {' | '.join(engines)} |", "|---" * (len(engines) + 1) + "|"]
        for scene in self.report["scenes"]:
            runs = {run["engine"]: run for run in scene["runs"]}
            cells = [cell(runs[engine], scene["runs"]) if engine in runs else "–" for engine in engines]
            lines.append(f"| {scene['scene']}: {scene['title']} | {' | '.join(cells)} |")
        return "\n".join(lines)


def _named(entries, name):
    for entry in entries:
        if entry["name"] == name:
            return entry
    raise KeyError(name)


def _time(seconds):
    for unit, size in (("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if seconds >= size:
            break
    return f"{float(f'{seconds / size:.2g}'):g} {unit}"  # two digits, and 110 rather than 1.1e+02


def _short(number):
    """Two digits; whole numbers from 100 on; powers of ten for what is tiny."""
    if number >= 100:
        return f"{number:.0f}"
    return f"{number:.2g}" if number == 0 or number >= 1e-3 else f"{number:.0e}".replace("e-0", "e-")
