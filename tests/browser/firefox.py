"""Headless Firefox, driven by WebDriver BiDi over its own WebSocket: Debian 12 has no geckodriver. Standard library only."""

import base64
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time

from webdriver import WebDriverError, drag_actions, key_actions

PREFERENCES = {'remote.active-protocols': 1, 'browser.shell.checkDefaultBrowser': False, 'ui.prefersReducedMotion': 1,
               'datareporting.policy.dataSubmissionEnabled': False, 'toolkit.telemetry.reportingpolicy.firstRun': False,
               'app.update.enabled': False, 'browser.startup.page': 0, 'network.captive-portal-service.enabled': False,
               'network.connectivity-service.enabled': False, 'dom.max_script_run_time': 0}


class WebSocket:
    """A client's side of RFC 6455, as much as one local server needs."""

    def __init__(self, port, path, seconds):
        self.socket = socket.create_connection(('127.0.0.1', port), timeout=seconds)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f'GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n'
                             f'Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n').encode())
        self.rest = b''
        head = b''
        while b'\r\n\r\n' not in head:
            head += self._some()
        head, self.rest = head.split(b'\r\n\r\n', 1)
        if b' 101 ' not in head.split(b'\r\n')[0]:
            raise OSError(f'no WebSocket: {head[:80]!r}')

    def _some(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise OSError('the browser has closed the WebSocket')
        return data

    def _take(self, count):
        while len(self.rest) < count:
            self.rest += self._some()
        taken, self.rest = self.rest[:count], self.rest[count:]
        return taken

    def send(self, text, opcode=1):
        data, mask = text if isinstance(text, bytes) else text.encode(), os.urandom(4)
        size = len(data)
        head = bytes([0x80 | opcode])
        if size < 126:
            head += bytes([0x80 | size])
        elif size < 1 << 16:
            head += bytes([0x80 | 126]) + struct.pack('>H', size)
        else:
            head += bytes([0x80 | 127]) + struct.pack('>Q', size)
        wide = (mask * (size // 4 + 1))[:size]
        masked = (int.from_bytes(data, 'big') ^ int.from_bytes(wide, 'big')).to_bytes(size, 'big')
        self.socket.sendall(head + mask + masked)

    def receive(self):
        """The next text."""
        parts = b''
        while True:
            first, second = self._take(2)
            size = second & 127
            if size == 126:
                size, = struct.unpack('>H', self._take(2))
            elif size == 127:
                size, = struct.unpack('>Q', self._take(8))
            data, opcode = self._take(size), first & 15
            if opcode == 9:
                self.send(data, 10)
            elif opcode == 8:
                raise OSError('the browser has closed the WebSocket')
            elif opcode in (0, 1):
                parts += data
                if first & 128:
                    return parts.decode()


class Firefox:
    """One Firefox with a profile of its own, with what webdriver.Browser has. Use as a context manager."""

    def __init__(self, binary='firefox-esr', seconds=110):
        self.profile = tempfile.mkdtemp(prefix='gradus-firefox-')
        self.count, self.messages, self.frame_context = 0, [], None
        preferences = ''.join(f'user_pref({json.dumps(name)}, {json.dumps(value)});\n' for name, value in PREFERENCES.items())
        pathlib.Path(self.profile, 'user.js').write_text(preferences, encoding='utf-8')
        self.process = subprocess.Popen([binary, '--headless', '--no-remote', '--profile', self.profile, '--remote-debugging-port', '0'],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding='utf-8', errors='replace',
                                        env={**os.environ, 'HOME': self.profile, 'MOZ_DISABLE_CONTENT_SANDBOX': '1'})
        try:
            self._start(seconds)
        except BaseException:
            self.close()
            raise

    def _start(self, seconds):
        end = time.monotonic() + seconds
        port = None
        for line in self.process.stderr:
            found = re.search(r'WebDriver BiDi listening on ws://127\.0\.0\.1:(\d+)', line)
            if found:
                port = int(found[1])
                break
            if time.monotonic() > end:
                break
        if port is None:
            raise WebDriverError('Firefox does not listen')
        self.socket = WebSocket(port, '/session', seconds)
        self.call('session.new', capabilities={})
        self.context = self.call('browsingContext.getTree')['contexts'][0]['context']
        self.call('session.subscribe', events=['log.entryAdded'])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stderr.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def call(self, method, **parameters):
        self.count += 1
        self.socket.send(json.dumps({'id': self.count, 'method': method, 'params': parameters}))
        while True:
            try:
                message = json.loads(self.socket.receive())
            except TimeoutError:
                raise WebDriverError(f'{method}: no answer; asked with {str(parameters)[:300]}') from None
            if message.get('method') == 'log.entryAdded':
                self.messages.append(message['params'])
            if message.get('id') != self.count:
                continue
            if message['type'] == 'error':
                raise WebDriverError(f'{method}: {message["error"]}: {message["message"]}')
            return message['result']

    def open(self, url):
        self.frame_context = None
        # Waiting for the event by the protocol hangs now and then, and a page that was asked for too early never comes:
        # the page itself is asked, and asked for again
        for _ in range(6):
            self.call('browsingContext.navigate', context=self.context, url=url, wait='none')
            end = time.monotonic() + 15
            while time.monotonic() < end:
                if self._is_open(url):
                    return
                time.sleep(0.02)
        raise WebDriverError(f'{url} does not open')

    def _is_open(self, url):
        try:
            return self.run('return [location.href, document.readyState]') == [url, 'complete']
        except WebDriverError:
            return False  # between two pages there is none

    def frame(self, number):
        """Goes into the page's frame of this number; None: back to the page itself."""
        tree = self.call('browsingContext.getTree', root=self.context)['contexts'][0]
        self.frame_context = None if number is None else tree['children'][number]['context']

    def run(self, script, *arguments):
        """What a function of this body returns, or its promise gives, for these arguments."""
        declaration = (f'async (given) => {{ const value = await (function () {{ {script} }}).apply(null, JSON.parse(given));'
                       ' return JSON.stringify(value === undefined ? null : value); }')
        done = self.call('script.callFunction', functionDeclaration=declaration, awaitPromise=True,
                         target={'context': self.frame_context or self.context},
                         arguments=[{'type': 'string', 'value': json.dumps(arguments)}])
        if done['type'] == 'exception':
            raise WebDriverError(done['exceptionDetails']['text'])
        return json.loads(done['result']['value'])

    def size(self, width, height, dpr=1):
        self.call('browsingContext.setViewport', context=self.context, viewport={'width': width, 'height': height}, devicePixelRatio=dpr)

    def _perform(self, actions):
        self.call('input.performActions', context=self.frame_context or self.context, actions=actions)

    def press(self, *keys):
        self._perform([key_actions(keys)])

    def drag(self, places, touch=False):
        """Down at the first place, over the others, up at the last one."""
        self._perform([drag_actions(places, touch)])

    def click(self, x, y):
        self.drag([(x, y)])

    def errors(self):
        """What has been said on the console since the last call."""
        said, self.messages = self.messages, []
        return [entry.get('text', '') for entry in said if entry.get('level') in ('error', 'warn')]

    def screenshot(self, path):
        data = self.call('browsingContext.captureScreenshot', context=self.context)['data']
        pathlib.Path(path).write_bytes(base64.b64decode(data))
