"""A headless Firefox that is asked by WebDriver BiDi, so that neither a driver nor selenium is needed."""
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

import websocket

SECONDS_TO_START = 60
SECONDS_TO_ANSWER = 60


class Firefox:
    """Has one tab. `errors` collects what pages log as errors or warnings."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        home = self.folder.name
        # Firefox refuses root where the home folder belongs to somebody else.
        self.process = subprocess.Popen(
            ["firefox-esr", "--headless", "--no-remote", "--profile", home, "--remote-debugging-port", "0"],
            env=os.environ | {"HOME": home}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            self.connect(Path(home, "WebDriverBiDiServer.json"))
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def connect(self, server):
        """Firefox writes its address into a file of the profile."""
        deadline = time.monotonic() + SECONDS_TO_START
        while not (server.exists() and server.read_text()):
            if time.monotonic() > deadline or self.process.poll() is not None:
                raise RuntimeError("firefox-esr does not start")
            time.sleep(0.05)
        at = json.loads(server.read_text())
        self.socket = websocket.create_connection(f"ws://{at['ws_host']}:{at['ws_port']}/session", suppress_origin=True,
                                                  timeout=SECONDS_TO_ANSWER)
        self.count, self.errors = 0, []
        self.ask("session.new", capabilities={})
        self.ask("session.subscribe", events=["log.entryAdded"])
        self.tab = self.ask("browsingContext.getTree")["contexts"][0]["context"]

    def ask(self, method, **parameters):
        """The answer to a command. Events that arrive meanwhile are heard."""
        self.count += 1
        self.socket.send(json.dumps({"id": self.count, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("method") == "log.entryAdded" and message["params"]["level"] in ("error", "warn"):
                self.errors.append(message["params"]["text"])
            elif message.get("id") == self.count:
                if message["type"] == "error":
                    raise RuntimeError(f"{method}: {message['message']}")
                return message["result"]

    def open(self, page):
        self.ask("browsingContext.navigate", context=self.tab, url=page.as_uri(), wait="complete")

    def run(self, script, **names):
        """What the body of an asynchronous function returns, in which the names have these values."""
        given = "".join(f"const {name} = {json.dumps(value)};" for name, value in names.items())
        body = f"(async () => {{ {given} {script} }})().then(value => JSON.stringify(value ?? null))"
        answer = self.ask("script.evaluate", expression=body, target={"context": self.tab}, awaitPromise=True)
        if answer["type"] == "exception":
            raise RuntimeError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"]["value"])

    def touch(self, selector):
        """A finger touches the middle of an element."""
        found = self.ask("browsingContext.locateNodes", context=self.tab, locator={"type": "css", "value": selector})
        node = {"type": "element", "element": {"sharedId": found["nodes"][0]["sharedId"]}}
        finger = [{"type": "pointerMove", "x": 0, "y": 0, "origin": node}, {"type": "pointerDown", "button": 0},
                  {"type": "pointerUp", "button": 0}]
        self.ask("input.performActions", context=self.tab, actions=[
            {"type": "pointer", "id": "finger", "parameters": {"pointerType": "touch"}, "actions": finger}])
