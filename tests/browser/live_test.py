#!/usr/bin/env python3
"""The module of live pages, asked in headless Chromium, from file://: it answers byte for byte what the command writes.

    live_test.py [--count N] ANSWERS

ANSWERS (live_answers.cpp) draws N seeded inputs per topic beside its examples and its promises' traps, and answers them by
the same code in an ordinary program; that is held to `gradus run` here, too. Exits 1 when something differs, 77 when
there is no Chromium or no module.
"""
import argparse
import base64
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import project
from share import share_of
from webdriver import Browser

HOST = project.ROOT / 'visualize/web/workbench/host.js'
WORKER = pathlib.Path(__file__).with_name('live_host.js')
FILES = [project.ROOT / name for name in ('examples/images/camera.png', 'examples/models/letter_f.obj',
                                          'examples/models/letter_f.mtl', 'tests/browser/live_maze.txt')]
PAGE = """<!doctype html>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:">
<title>live</title>
<script id="host" type="text/plain">%s</script>
<script>
  const worker = new Worker(URL.createObjectURL(new Blob([document.getElementById('host').textContent])));
  const waiting = new Map();
  worker.onmessage = ({data: [id, value, error]}) => {
    const {resolve, reject} = waiting.get(id);
    waiting.delete(id);
    error ? reject(new Error(error)) : resolve(value);
  };
  function call(...message) {
    return new Promise((resolve, reject) => {
      waiting.set(call.count = (call.count ?? 0) + 1, {resolve, reject});
      worker.postMessage([call.count, ...message]);
    });
  }
</script>
"""
# What users would ask of files; and what no topic takes
OF_FILES = [
    {'topic': 'flood_fill', 'arguments': {'image': 'camera.png', 'at': '300,60', 'tolerance': '20'}, 'steps': '0-200'},
    {'topic': 'flood_fill', 'arguments': {'maze': 'live_maze.txt', 'at': '1,1'}},
    {'topic': 'flood_fill', 'arguments': {'maze': '@live_maze.txt', 'at': '1,1', 'method': 'span'}},
    {'topic': 'flood_fill', 'arguments': {'image': 'none.png', 'at': '3,3'}},
    {'topic': 'flood_fill', 'arguments': {'image': 'live_maze.txt', 'at': '3,3'}},
    {'topic': 'pipeline', 'arguments': {'model': 'letter_f.obj', 'stage': 'clipping'}},
    {'topic': 'pipeline', 'arguments': {'model': 'camera.png'}},
    {'topic': 'back_face_culling', 'arguments': {'faces': 'letter_f.obj'}},
]
REFUSED = [
    {'topic': 'bresenham_lime', 'arguments': {}},
    {'topic': 'bresenham_line', 'arguments': {'from': 'here'}},
    {'topic': 'bresenham_line', 'arguments': {'from': ''}},
    {'topic': 'bresenham_line', 'arguments': {'from': '0,0\n\u202e1'}},
    {'topic': 'bresenham_line', 'arguments': {'method': 'fast'}},
    {'topic': 'bresenham_line', 'steps': '3-99'},
    {'topic': 'bresenham_line', 'step': '4.1'},
    {'topic': 'bresenham_line', 'step': '4', 'steps': '4'},
    {'topic': 'bresenham_line', 'language': 'fr'},
    {'topic': 'bresenham_line', 'numbers': 'roman'},
    {'topic': 'bresenham_line', 'notation': 'newton'},
    {'topic': 'bresenham_line', 'notation': '{"symbols": 3}'},
    {'topic': 'bresenham_line', 'notation': '{"symbols"'},
    {'topic': 'bresenham_line', 'labels': ['q=d']},
    {'topic': 'liang_barsky', 'arguments': {'line': '0,0,1,1e999'}},
]
# What no command line could ask
MALFORMED = [('', r'^request:1: expected '), ('[]', r'^request: expected an object, found an empty list$'),
             ('{}', r'^request: want: expected run, trace, remarks or list, found '),
             ('{"want": "run"}', r'^request: expected a topic, found none$'),
             ('{"want": "run", "topic": 3}', r'^request: topic: expected a text, found 3$'),
             ('{"want": "run", "colour": "red"}', r"^request: expected one of want, topic, .*, found 'colour'$"),
             ('{"want": "run", "topic": "viewing", "arguments": {"to": "1"}}', r'^--to: viewing has no such parameter$'),
             ('{"want": "run", "topic": "viewing", "labels": [3]}', r'^request: labels: expected a list of texts, found a list$')]


class Native:
    """The ordinary program, which answers one request after the other."""

    def __init__(self, program, files):
        self.process = subprocess.Popen([program, *files], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait()

    def ask(self, request):
        """("answer", its bytes) or ("refused", the line)"""
        self.process.stdin.write(request.encode() + b'\n')
        self.process.stdin.flush()
        kind, size = self.process.stdout.readline().split()
        return kind.decode(), self.process.stdout.read(int(size))


class Module:
    """The module in a worker of a page."""

    def __init__(self, browser, module, folder):
        self.browser = browser
        page = folder / 'live.html'
        page.write_text(PAGE % (HOST.read_text(encoding='utf-8') + WORKER.read_text(encoding='utf-8')), encoding='utf-8')
        browser.open(page.as_uri())
        self.compiled, self.imports, self.exports = self.call('load', base64.b64encode(module.read_bytes()).decode())
        self.slowest = {}

    def call(self, *message):
        return self.browser.run('return call(...arguments)', *message)

    def open(self, file):
        self.call('open', file.name, base64.b64encode(file.read_bytes()).decode(), file.suffix == '.png')

    def ask(self, requests, whole=False):
        """[(how it ended, the text or its digest)], for requests as JSON."""
        told = self.call('ask', [json.loads(request) for request in requests], whole)
        for request, (_, _, time) in zip(requests, told):
            topic = json.loads(request)['topic']
            self.slowest[topic] = max(self.slowest.get(topic, (0, '')), (time, request))
        return [(kind, text) for kind, text, _ in told]


def digest(text):
    return hashlib.sha256(text).hexdigest()


def first_difference(ours, theirs):
    at = next((i for i, (a, b) in enumerate(zip(ours, theirs)) if a != b), min(len(ours), len(theirs)))
    start = max(at - 60, 0)
    return f'command: …{ours[start:at + 60]!r}\n  module:  …{theirs[start:at + 60]!r}'


def as_command(request):
    """The words after `gradus` that ask the same."""
    words = ['run', request['topic'], '--json']
    for name, value in request.get('arguments', {}).items():
        name = '--' + name.replace('_', '-')
        words.append(name if value == 'yes' else f'{name}={value}')  # flags take no value
    for name in ('step', 'steps', 'language', 'numbers', 'notation'):
        if name in request:
            words.append(f'--{name}={request[name]}')
    return words + [f'--label={label}' for label in request.get('labels', ())]


class Test:
    def __init__(self, module, native):
        self.module, self.native, self.failures = module, native, 0

    def check(self, holds, what):
        if not holds:
            self.failures += 1
            print('FAILED:', what, flush=True)

    def same(self, requests):
        """The module ends each as the program does, with the same text; how many were refused."""
        refused = 0
        for start in range(0, len(requests), 50):
            part = requests[start:start + 50]
            for request, theirs in zip(part, self.module.ask(part)):
                kind, ours = self.native.ask(request)
                refused += kind == 'refused'
                if theirs != (kind, digest(ours)):
                    self.tell_difference(request, kind, ours)
        return refused

    def tell_difference(self, request, kind, ours):
        if self.failures > 10:
            self.failures += 1
            return
        their_kind, theirs = self.module.ask([request], whole=True)[0]
        self.check(False, f'{request}\n  command: {kind}, module: {their_kind}\n  '
                   + first_difference(ours.decode('utf-8', 'replace'), theirs))

    def is_the_commands(self, request):
        """The ordinary program ends a request as `gradus` does."""
        kind, text = self.native.ask(json.dumps(request))
        done = subprocess.run([project.COMMAND, *as_command(request)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              check=False)
        if done.returncode == 0:
            same = (kind, text) == ('answer', done.stdout)
        else:
            same = (kind, b'gradus: ' + text + b'\n') == ('refused', done.stderr)
        self.check(same, f'{request}\n  gradus: {done.stdout[:200] or done.stderr}\n  program: {kind} {text[:200]}')

    def is_the_players(self, topic, folder):
        """A trace is what the page of the player loads."""
        kind, text = self.native.ask(json.dumps({'want': 'trace', 'topic': topic}))
        page = folder / f'{topic}.html'
        project.run(project.COMMAND, 'figure', topic, '-o', page, '-q')
        self.check(kind == 'answer' and text in page.read_bytes(), f'the player of {topic} loads another trace')

    def lists(self):
        [(kind, told)] = self.module.ask([json.dumps({'want': 'list', 'topic': ''})], whole=True)
        self.check((kind, told) == ('answer', project.run(project.COMMAND, 'list', '--json')), 'the list of topics')
        return [topic['name'] for topic in json.loads(told)['topics']]

    def told_in_the_docs(self):
        text = HOST.read_text(encoding='utf-8')
        quoted = text[text.index('const LEFT'):]
        self.check(quoted in (project.ROOT / 'docs/live.md').read_text(encoding='utf-8'), 'docs/live.md quotes host.js')

    def malformed(self):
        for request, pattern in MALFORMED:
            kind, line = self.native.ask(request)
            self.check(kind == 'refused' and re.search(pattern, line.decode()), f'{request!r} is refused: {line}')


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--count', type=int, default=20)
    parser.add_argument('answers')
    options = parser.parse_args()
    if not shutil.which('chromium') or not shutil.which('chromedriver'):
        print('skipped: chromium and chromedriver are not here (Debian: chromium chromium-driver)')
        return 77
    built = project.live_build()
    if not built:
        print('skipped: the module is not built (./bootstrap live)')
        return 77
    seed = os.environ.get('GRADUS_SEED', '20240611')
    print(f'GRADUS_SEED={seed}', flush=True)
    with tempfile.TemporaryDirectory() as folder, Browser() as browser, Native(options.answers, FILES) as native:
        module = Module(browser, built / 'gradus.wasm', pathlib.Path(folder))
        test = Test(module, native)
        test.check(sorted(module.imports) == ['attempt', 'leave', 'refused'], f'the module needs more than its host gives: {module.imports}')
        test.check(sorted(module.exports) == sorted(['memory', '_initialize', 'room', 'keep_file', 'keep_picture', 'answer',
                                                     'answer_size', 'run']), f'the exports are {module.exports}')
        for file in FILES:
            module.open(file)
        topics = test.lists()
        test.malformed()
        test.told_in_the_docs()
        for request in [{'topic': topic} for topic in topics] + REFUSED:
            test.is_the_commands({'want': 'run', **request})
        for topic in topics[::7]:
            test.is_the_players(topic, pathlib.Path(folder))
        others = [json.dumps({'want': want, **request}) for request in OF_FILES + REFUSED for want in ('run', 'trace')]
        print(f'{len(others)} requests of files and mistakes, {test.same(others)} refused')
        for topic in share_of(topics, 7):
            start = time.perf_counter()
            drawn = subprocess.run([options.answers, '--draw', str(options.count), seed, topic], stdout=subprocess.PIPE,
                                   encoding='utf-8', check=True).stdout.splitlines()
            test.check(len(drawn) > options.count, f'{topic} has inputs')
            refused = test.same(drawn)
            test.check(len(drawn) - refused > 5, f'{topic} refuses {refused} of {len(drawn)} inputs: little is compared')
            slowest, request = module.slowest[topic]
            print(f'{topic}: {len(drawn)} requests, {refused} refused, {time.perf_counter() - start:.1f} s, '
                  f'the slowest {slowest:.0f} ms: {request[:160]}', flush=True)
    print(f'{test.failures} failed')
    return 1 if test.failures else 0


if __name__ == '__main__':
    sys.exit(main())
