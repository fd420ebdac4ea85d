# SPDX-License-Identifier: BSD-3-Clause
"""A page in headless Chromium, steered by its DevTools protocol over a WebSocket; nothing but the standard library."""
import base64
import itertools
import json
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import tempfile
import time
import urllib.request

OPTIONS = ("--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
           "--disable-component-update --disable-sync --remote-debugging-port=0 --allow-pre-commit-input").split()
KEYS = {"Tab": (9, ""), "Enter": (13, "\r"), " ": (32, " "), "Shift+Tab": (9, "")}


def find():
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


class Socket:
    """Messages of JSON over a WebSocket (RFC 6455)."""

    def __init__(self, address):
        host, _, path = address.removeprefix("ws://").partition("/")
        name, _, port = host.partition(":")
        self.stream = socket.create_connection((name, int(port)), timeout=120)
        key = base64.b64encode(os.urandom(16)).decode()
        self.stream.sendall((f"GET /{path} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode())
        self.file = self.stream.makefile("rb")
        while self.file.readline().strip():
            pass

    def send(self, message):
        text, mask = json.dumps(message).encode(), os.urandom(4)
        size = (bytes([0x80 | len(text)]) if len(text) < 126 else struct.pack(">BH", 0xFE, len(text))
                if len(text) < 65536 else struct.pack(">BQ", 0xFF, len(text)))
        masked = bytes(a ^ b for a, b in zip(text, itertools.cycle(mask)))
        self.stream.sendall(b"\x81" + size + mask + masked)

    def receive(self):
        whole = b""
        while True:
            first, second = self.file.read(2)
            size = second & 127
            if size > 125:
                size = struct.unpack(">H", self.file.read(2))[0] if size == 126 else struct.unpack(">Q", self.file.read(8))[0]
            part = self.file.read(size)
            if first & 15 in (0, 1):
                whole += part
                if first & 128:
                    return json.loads(whole)


class Page:
    """A page in a Chromium of its own, whose downloads are in the folder `downloads`."""

    def __init__(self, url, width=1000, height=1400, dark=False):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        profile = pathlib.Path(self.folder.name)
        self.downloads = profile / "downloads"
        self.downloads.mkdir()
        self.process = subprocess.Popen([find(), *OPTIONS, f"--user-data-dir={profile / 'user'}", "about:blank"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        named = profile / "user/DevToolsActivePort"
        self.wait(lambda: named.is_file() and named.read_text().count("\n"), "Chromium does not start")
        with urllib.request.urlopen(f"http://127.0.0.1:{named.read_text().split()[0]}/json") as pages:
            address = next(page for page in json.load(pages) if page["type"] == "page")["webSocketDebuggerUrl"]
        self.socket, self.ids, self.events = Socket(address), itertools.count(1), []
        for domain in ("Page", "Runtime", "Network", "DOM", "Log"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 500)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Browser.setDownloadBehavior", behavior="allowAndName", downloadPath=str(self.downloads),
                  eventsEnabled=True)
        self.call("Page.navigate", url=url)
        self.wait(lambda: self.run("document.readyState") == "complete", "the page does not load")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    @staticmethod
    def wait(holds, otherwise, seconds=300, step=0.05):  # ends a hang; a loaded machine may take minutes
        end = time.monotonic() + seconds
        while not (found := holds()):
            if time.monotonic() > end:
                raise TimeoutError(otherwise)
            time.sleep(step)
        return found

    def call(self, method, **parameters):
        number = next(self.ids)
        self.socket.send({"id": number, "method": method, "params": parameters})
        while (answer := self.socket.receive()).get("id") != number:
            self.events.append(answer)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def run(self, script):
        """The value of an expression of JavaScript, as if a person had done it: else Chromium stops after some downloads."""
        done = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in done:
            raise RuntimeError(f"{script}: {done['exceptionDetails']}")
        return done["result"].get("value")

    def choose(self, file):
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        node = self.call("DOM.querySelector", nodeId=root, selector="#file")["nodeId"]
        self.call("DOM.setFileInputFiles", nodeId=node, files=[str(file)])

    def download(self, link):
        """The bytes of what a click on `link`, an expression of JavaScript, downloads."""
        for _ in range(12):  # Chromium holds back a picture now and then, which may be harmful elsewhere
            before = len(self.events)
            self.run(f"{link}.click()")

            def complete(before=before):
                self.run("0")  # events come with answers
                return [event["params"]["guid"] for event in self.events[before:]
                        if event["method"] == "Browser.downloadProgress" and event["params"]["state"] == "completed"]

            try:
                return (self.downloads / self.wait(complete, "", 10)[0]).read_bytes()
            except TimeoutError:
                continue
        raise TimeoutError(f"no download by {link}")

    def press(self, key, text=None):
        """One key; or a \\p text typed letter by letter."""
        if text is not None:
            return self.call("Input.insertText", text=text)
        code, letter = KEYS[key]
        name = key.removeprefix("Shift+")
        pressed = dict(key=name, code="Space" if key == " " else name, windowsVirtualKeyCode=code,
                       modifiers=8 if key.startswith("Shift") else 0)
        self.call("Input.dispatchKeyEvent", type="keyDown", **({"text": letter} if letter else {}), **pressed)
        return self.call("Input.dispatchKeyEvent", type="keyUp", **pressed)

    def screenshot(self, file):
        size = self.call("Page.getLayoutMetrics")["cssContentSize"]
        clip = {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}
        shot = self.call("Page.captureScreenshot", clip=clip, captureBeyondViewport=True)
        pathlib.Path(file).write_bytes(base64.b64decode(shot["data"]))
