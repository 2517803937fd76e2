#!/usr/bin/env python3
"""Watches which files the program opens while it loads scenes that ask for files they must not have.

    opened_files.py PROGRAM [FOLDER]

Builds scenes whose buffers lie outside their folder, behind every kind of URI, with a triangle there that
would show; then takes every scene below FOLDER, where one is given. Fails naming the scene and the file if
anything is opened that is neither below the scene's own folder nor a part of the system.
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

SYSTEM = ("/proc/", "/sys/", "/usr/", "/lib", "/etc/ld.so", "/etc/ssl/", "/dev/")  # libcrypto reads its settings
OPENED = re.compile(r'open(?:at|at2)?\((?:AT_FDCWD, |\d+, )?"((?:[^"\\]|\\.)*)".* = \d+')
TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)


def opened(program, scene, log):
    subprocess.run(["strace", "-f", "-qq", "-s", "4096", "-e", "trace=open,openat,openat2,creat", "-o", log, program, "info", scene],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    for line in pathlib.Path(log).read_text(errors="replace").splitlines():
        found = OPENED.search(line)
        if found:
            name = found[1].encode().decode("unicode_escape").encode("latin-1").decode(errors="replace")
            yield os.path.realpath(os.path.join(os.getcwd(), name))


def strangers(program, scene, log):
    """What is opened beyond the program itself, the system, and the scene's folder."""
    inside = os.path.realpath(os.path.dirname(scene)) + os.sep
    own = os.path.realpath(program)
    return [f for f in opened(program, scene, log)
            if not f.startswith(inside) and not f.startswith(SYSTEM) and f != own]


def document(uri):
    return json.dumps({
        "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": uri}],
        "images": [{"uri": uri}]})


def planted(folder):
    """Scenes that ask for a file beside their folder, and one that asks for a file in it."""
    (folder / "secret.bin").write_bytes(TRIANGLE)
    inner = folder / "inner"
    inner.mkdir()
    (inner / "own.bin").write_bytes(TRIANGLE)
    (inner / "link.bin").symlink_to(folder / "secret.bin")
    (inner / "folder").symlink_to(folder)
    secret = str(folder / "secret.bin")
    uris = ["../secret.bin", "%2e%2e/secret.bin", "..%2Fsecret.bin", "..\\secret.bin", "x/../../secret.bin", secret,
            "%2F" + secret[1:], "//" + secret, "file://" + secret, "file:" + secret, "link.bin", "folder/secret.bin",
            "./../secret.bin", "own.bin/../../secret.bin", "%252e%252e/secret.bin", "own.bin"]
    for number, uri in enumerate(uris):
        scene = inner / f"{number}.gltf"
        scene.write_text(document(uri))
        yield str(scene)


def main():
    program = os.path.realpath(sys.argv[1])
    failed = count = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        log = str(folder / "log")
        scenes = list(planted(folder))
        own = str(folder / "inner/own.bin")
        if os.path.realpath(own) not in opened(program, scenes[-1], log):
            sys.exit("a scene's own file is not seen to be opened: this check could not fail")
        for extra in sys.argv[2:]:
            scenes += [str(p) for p in sorted(pathlib.Path(extra).rglob("*")) if p.suffix in (".gltf", ".glb", ".ply")]
        for scene in scenes:
            count += 1
            for name in strangers(program, scene, log):
                failed += 1
                print(f"{scene} opens {name}")
    print(f"{count} scenes, {failed} files outside their folders")
    sys.exit(failed != 0)


main()
