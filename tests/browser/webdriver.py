"""A small WebDriver client for headless Chromium, with the standard library only."""

import base64
import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import programs
from share import share_of

programs.use_nothing_else()
EVERYTHING = bool(os.environ.get('GRADUS_STRESS'))  # every page, not the first one of each topic
KEYS = {'ArrowLeft': '\ue012', 'ArrowRight': '\ue014', 'ArrowUp': '\ue013', 'ArrowDown': '\ue015', 'Home': '\ue011',
        'End': '\ue010', 'PageUp': '\ue00e', 'PageDown': '\ue00f', 'Enter': '\ue007', 'Escape': '\ue00c',
        'Tab': '\ue004', 'Space': ' ', 'Shift': '\ue008', 'Control': '\ue009'}

# Through a pipe: the driver would ask for `localhost` by name, which a machine without /etc/hosts doesn't know
FLAGS = ['--headless=new', '--remote-debugging-pipe', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
         '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-extensions',
         '--disable-default-apps', '--disable-dev-shm-usage', '--force-prefers-reduced-motion',
         '--window-size=1280,720']


class WebDriverError(Exception):
    pass


def key_actions(keys):
    """The keys one after the other; "Shift+b": held, then let go in turn."""
    actions = []
    for key in keys:
        values = [KEYS.get(part, part) for part in (key.split('+') if len(key) > 1 else [key])]
        actions += [{'type': 'keyDown', 'value': value} for value in values]
        actions += [{'type': 'keyUp', 'value': value} for value in reversed(values)]
    return {'type': 'key', 'id': 'keys', 'actions': actions}


def drag_actions(places, touch):
    """Down at the first place, over the others, up at the last one."""
    moves = [{'type': 'pointerMove', 'duration': 0, 'x': round(x), 'y': round(y)} for x, y in places]
    actions = [moves[0], {'type': 'pointerDown', 'button': 0}, *moves[1:], {'type': 'pointerUp', 'button': 0}]
    return {'type': 'pointer', 'id': 'finger' if touch else 'mouse', 'actions': actions,
            'parameters': {'pointerType': 'touch' if touch else 'mouse'}}


def free_port():
    with socket.socket() as s:
        s.bind(('127.0.0.1', 0))
        return s.getsockname()[1]


class Browser:
    """One Chromium with a profile of its own. Use as a context manager: the driver always ends with it."""

    def __init__(self, chromium='chromium', chromedriver='chromedriver', flags=()):
        self.base = None
        self.profile = tempfile.mkdtemp(prefix='gradus-browser-')
        port = free_port()
        self.driver = subprocess.Popen([chromedriver, f'--port={port}'], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        try:
            self._start(f'http://127.0.0.1:{port}', shutil.which(chromium) or chromium, flags)
        except BaseException:
            self.close()
            raise

    def _start(self, server, binary, flags):
        for _ in range(100):
            try:
                urllib.request.urlopen(f'{server}/status', timeout=5).read()
                break
            except OSError:
                time.sleep(0.1)
        options = {'binary': binary, 'args': [*FLAGS, f'--user-data-dir={self.profile}', *flags]}
        # The default of 30 s is short for reading a large page on a busy machine
        wanted = {'browserName': 'chrome', 'goog:chromeOptions': options, 'unhandledPromptBehavior': 'ignore',
                  'timeouts': {'script': 110_000},
                  'goog:loggingPrefs': {'browser': 'ALL', 'performance': 'ALL'}}
        self.base = f'{server}/session'
        answer = self.call('POST', '', {'capabilities': {'alwaysMatch': wanted}})
        self.base = f'{server}/session/{answer["sessionId"]}'

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        try:
            if self.base:
                self.call('DELETE', '')
        except (OSError, WebDriverError):
            pass
        self.driver.terminate()
        try:
            self.driver.wait(10)
        except subprocess.TimeoutExpired:
            self.driver.kill()
            self.driver.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {'Content-Type': 'application/json'}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)['value']
        except urllib.error.HTTPError as error:
            raise WebDriverError(json.load(error)['value']['message'].split('\n')[0]) from None

    def cdp(self, command, **parameters):
        return self.call('POST', '/goog/cdp/execute', {'cmd': command, 'params': parameters})

    def open(self, url):
        self.call('POST', '/url', {'url': url})

    def frame(self, number):
        """Goes into the page's frame of this number; None: back to the page itself."""
        self.call('POST', '/frame', {'id': number})

    def run(self, script, *arguments):
        return self.call('POST', '/execute/sync', {'script': script, 'args': list(arguments)})

    def size(self, width, height, dpr=1):
        self.cdp('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=dpr, mobile=False)

    def press(self, *keys):
        self.call('POST', '/actions', {'actions': [key_actions(keys)]})

    def drag(self, places, touch=False):
        """Down at the first place, over the others, up at the last one."""
        self.call('POST', '/actions', {'actions': [drag_actions(places, touch)]})

    def click(self, x, y):
        self.drag([(x, y)])

    def errors(self):
        """What has been said on the console since the last call."""
        return [entry['message'] for entry in self.log('browser')]

    def click_on(self, selector, nth=0):
        """Clicks the middle of an element, as a hand would."""
        place = self.run('''const node = document.querySelectorAll(arguments[0])[arguments[1]];
                            if (!node) return null;
                            node.scrollIntoView({block: 'nearest'});
                            const box = node.getBoundingClientRect();
                            return [box.left + box.width / 2, box.top + box.height / 2];''', selector, nth)
        if place is None:
            raise WebDriverError(f'there is no {selector} number {nth}')
        self.click(*place)

    def alert(self):
        try:
            return self.call('GET', '/alert/text')
        except WebDriverError:
            return None

    def log(self, kind):
        return self.call('POST', '/se/log', {'type': kind})

    def screenshot(self, path):
        with open(path, 'wb') as file:
            file.write(base64.b64decode(self.call('GET', '/screenshot')))
