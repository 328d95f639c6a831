"""check_page.py PAGE.html [SHOTS]: drives the page in headless Chromium and looks at its pixels.

No message on the console, a picture that is not blank, and every switch, key, drag and wheel
changes it; on a phone and in dark mode too. Nothing is timed. SHOTS: a folder for the pictures."""
import base64
import fcntl
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import png

WAIT = """new Promise(done => setTimeout(() => requestAnimationFrame(() =>
    requestAnimationFrame(() => done(0))), 60))"""


class Browser:
    """Chromium over its debugging pipe: messages are JSON, each with a zero byte behind it."""

    def __init__(self):
        # Above 3 and 4, which are Chromium's ends.
        command_read, self.write, self.read, answer_write = (
            fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in os.pipe() + os.pipe())

        def connect():
            os.dup2(command_read, 3)
            os.dup2(answer_write, 4)

        self.folder = tempfile.TemporaryDirectory()
        self.process = subprocess.Popen(
            [os.environ.get("CHROMIUM", "chromium"), "--headless=new", "--no-sandbox",
             "--disable-gpu-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--disable-dev-shm-usage", "--no-first-run", "--user-data-dir=" + self.folder.name,
             "--remote-debugging-pipe", "about:blank"],
            preexec_fn=connect, close_fds=False, stderr=subprocess.DEVNULL)
        os.close(command_read)
        os.close(answer_write)
        self.number, self.session, self.buffer, self.said = 0, None, b"", []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")

    def message(self):
        while b"\0" not in self.buffer:
            got = os.read(self.read, 1 << 20)
            assert got, "Chromium has gone"
            self.buffer += got
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        sent = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            sent["sessionId"] = self.session
        os.write(self.write, json.dumps(sent).encode() + b"\0")
        while True:
            got = self.message()
            if got.get("method") in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown",
                                     "Log.entryAdded"):
                self.said.append(json.dumps(got["params"])[:600])
            if got.get("id") == self.number:
                assert "error" not in got, got
                return got["result"]

    def run(self, script):
        got = self.call("Runtime.evaluate", expression=script, awaitPromise=True,
                        returnByValue=True)
        assert "exceptionDetails" not in got, got
        return got["result"].get("value")

    def settle(self):
        self.run(WAIT)

    def open(self, url):
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=url)
        self.run("new Promise(done => document.readyState === 'complete' ? done(0) :"
                 " addEventListener('load', () => done(0)))")
        self.settle()

    def size(self, width, height, mobile=False, dark=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=mobile)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def shot(self, **clip):
        return base64.b64decode(self.call("Page.captureScreenshot", **clip)["data"])

    def canvas(self):
        """A PNG file of the canvas alone: equal pixels are equal bytes."""
        left, top, width, height = self.run(
            "(r => [r.left, r.top, r.width, r.height])"
            "(document.getElementById('view').getBoundingClientRect())")
        return self.shot(clip={"x": left, "y": top, "width": width, "height": height, "scale": 1})

    def close(self):
        self.call("Browser.close")
        self.process.wait(20)
        self.folder.cleanup()


passed = failed = 0


def check(name, good):
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print("FAIL page:", name)


def drawn(file):
    """The part of the pixels that are not as the upper left corner."""
    rows = png.read(file)[2]
    ground, pixels = rows[0][:3], len(rows) * len(rows[0]) // 3
    return sum(row[i:i + 3] != ground for row in rows for i in range(0, len(row), 3)) / pixels


def check_switches(browser):
    for field in ("rules", "views"):
        seen = set()
        values = browser.run("Array.from(document.querySelectorAll('#%s input'), i => i.value)"
                             % field)
        for value in values:
            browser.run("document.querySelector('#%s input[value=%s]').click()" % (field, value))
            browser.settle()
            file = browser.canvas()
            seen.add(file)
            check("%s %s is not blank" % (field, value), drawn(file) > 0.05)
        check("the %d %s differ" % (len(values), field), len(seen) == len(values) > 5)
    for value in ("edges", "creases", "net", "normals"):
        before = browser.canvas()
        box = "document.querySelector('#shows input[value=%s]').click()" % value
        browser.run(box)
        browser.settle()
        check("%s can be seen" % value, browser.canvas() != before)
        browser.run(box)
        browser.settle()
        check("%s can be hidden" % value, browser.canvas() == before)


def check_moves(browser):
    def moves(name, act):
        before = browser.canvas()
        act()
        browser.settle()
        check(name, browser.canvas() != before)

    def key(name, modifiers=0):
        for kind in ("keyDown", "keyUp"):
            browser.call("Input.dispatchKeyEvent", type=kind, key=name, modifiers=modifiers)

    def mouse(kind, x, y, **more):
        browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(modifiers=0):
        mouse("mousePressed", 200, 200, button="left", buttons=1, modifiers=modifiers)
        mouse("mouseMoved", 260, 220, button="left", buttons=1, modifiers=modifiers)
        mouse("mouseReleased", 260, 220, button="left", modifiers=modifiers)

    def pinch():
        touch = lambda kind, points: browser.call(
            "Input.dispatchTouchEvent", type=kind,
            touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])
        touch("touchStart", [(150, 200), (250, 200)])
        touch("touchMove", [(120, 200), (300, 210)])
        touch("touchEnd", [])

    browser.run("document.getElementById('view').focus()")
    first = browser.canvas()
    for name in ("ArrowLeft", "ArrowUp", "+", "-"):
        moves("the key " + name, lambda: key(name))
    moves("Shift and an arrow", lambda: key("ArrowRight", 8))
    moves("a drag", drag)
    moves("a drag with Shift", lambda: drag(8))
    moves("the wheel", lambda: mouse("mouseWheel", 200, 200, deltaX=0, deltaY=-200))
    moves("two fingers", pinch)
    browser.run("document.querySelector('#rules input:checked').focus()")
    key("Enter")
    browser.settle()
    browser.run("document.getElementById('view').focus()")
    key("0")
    browser.settle()
    check("0 starts again", browser.canvas() == first)


def check_texts(browser):
    check("the picture has a label", "bottle" in browser.run(
        "document.getElementById('view').getAttribute('aria-label')"))
    check("every control has a name", browser.run(
        "Array.from(document.querySelectorAll('input, button'))"
        ".every(i => (i.labels && i.labels.length ? i.labels[0] : i).textContent.trim())"))
    check("the report is there", "Made, by the rule 'paper'" in browser.run(
        "document.getElementById('report').textContent"))
    check("a frame took its time", browser.run(
        "parseFloat(document.getElementById('milliseconds').textContent) > 0"))


def check_still(browser, page):
    """Without WebGL the page shows its picture and says why it stands still."""
    script = browser.call("Page.addScriptToEvaluateOnNewDocument",
                          source="HTMLCanvasElement.prototype.getContext = () => null")
    browser.open(page)
    check("without WebGL there is a picture", drawn(browser.shot()) > 0.05 and browser.run(
        "document.getElementById('still').naturalWidth == 640"))
    check("and the reason", browser.run(
        "document.getElementById('problem').getBoundingClientRect().height > 0"))
    browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])


def main():
    page = pathlib.Path(sys.argv[1]).resolve().as_uri()
    shots = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    browser = Browser()
    browser.size(760, 440)
    browser.open(page)
    check("it is not blank", 0.05 < drawn(browser.canvas()) < 0.95)
    check_texts(browser)
    check_moves(browser)
    check_switches(browser)
    for name, size in (("desk", (1200, 800)), ("phone", (390, 844, True)),
                       ("dark", (1200, 800, False, True))):
        browser.size(*size)
        browser.open(page + "#view=%s" % {"desk": "mean", "phone": "zebra", "dark": "gauss"}[name])
        check(name + " is not blank", drawn(browser.canvas()) > 0.05)
        check(name + " is not wider than its screen", browser.run(
            "document.documentElement.scrollWidth <= innerWidth"))
        if shots:
            (shots / (name + ".png")).write_bytes(browser.shot())
    check_still(browser, page)
    check("nothing on the console", not browser.said)
    for said in browser.said:
        print("   ", said)
    browser.close()
    print("page: %d passed, %d failed" % (passed, failed))
    sys.exit(failed > 0)


main()
