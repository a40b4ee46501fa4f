# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene of tools/compare-frames in the viewer: viewerScene.py PROGRAM WORD...

Needs its own display (tools/with-display --own), where no other program takes the keyboard. Types
into the window as a user would: saves picture.png, layers.exr and session.json into the current
folder, and quits. Exit status: the viewer's; 1 if a file is not saved.
"""

import ctypes
import os
import pathlib
import subprocess
import sys
import tempfile
import time

LIMIT = 120  # seconds, for each file
CONTROL = 4  # the mask of the key
VIEWABLE = 2


class KeyEvent(ctypes.Structure):
    """Xlib's XKeyEvent, as large as XEvent."""

    _fields_ = [
        ("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("root", ctypes.c_ulong),
        ("subwindow", ctypes.c_ulong), ("time", ctypes.c_ulong), ("x", ctypes.c_int),
        ("y", ctypes.c_int), ("x_root", ctypes.c_int), ("y_root", ctypes.c_int),
        ("state", ctypes.c_uint), ("keycode", ctypes.c_uint), ("same_screen", ctypes.c_int),
        ("rest", ctypes.c_long * 24),
    ]  # fmt: skip


class Attributes(ctypes.Structure):
    """Xlib's XWindowAttributes."""

    _fields_ = [
        ("place", ctypes.c_int * 5), ("visual", ctypes.c_void_p), ("root", ctypes.c_ulong),
        ("kind", ctypes.c_int), ("gravity", ctypes.c_int * 3), ("planes", ctypes.c_ulong * 2),
        ("save_under", ctypes.c_int), ("colormap", ctypes.c_ulong), ("installed", ctypes.c_int),
        ("map_state", ctypes.c_int), ("rest", ctypes.c_long * 16),
    ]  # fmt: skip


class Keyboard:
    """Visible windows of the display, and keys sent to them."""

    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        for name, result, *words in (
            ("XOpenDisplay", "p", "s"), ("XDefaultRootWindow", "w", "p"), ("XFlush", "i", "p"),
            ("XQueryTree", "i", "p", "w", "p", "p", "p", "p"), ("XFree", "i", "p"),
            ("XGetWindowAttributes", "i", "p", "w", "p"), ("XStringToKeysym", "w", "s"),
            ("XKeysymToKeycode", "b", "p", "w"), ("XSetInputFocus", "i", "p", "w", "i", "w"),
            ("XSendEvent", "i", "p", "w", "i", "l", "p"),
        ):  # fmt: skip
            kinds = {
                "p": ctypes.c_void_p, "s": ctypes.c_char_p, "w": ctypes.c_ulong, "i": ctypes.c_int,
                "b": ctypes.c_ubyte, "l": ctypes.c_long,
            }  # fmt: skip
            function = getattr(self.x, name)
            function.restype, function.argtypes = kinds[result], [kinds[word] for word in words]
        # A window may close during a request.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(lambda *_: 0)
        self.x.XSetErrorHandler(self.ignore)
        self.display = self.x.XOpenDisplay(None)
        if not self.display:
            sys.exit("viewerScene: no display")
        self.root = self.x.XDefaultRootWindow(self.display)

    def windows(self):
        """The visible windows, lowest first."""
        root, parent = ctypes.c_ulong(), ctypes.c_ulong()
        held, count = ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint()
        self.x.XQueryTree(self.display, self.root, *map(ctypes.byref, (root, parent, held, count)))
        found = []
        for i in range(count.value):
            what = Attributes()
            if self.x.XGetWindowAttributes(self.display, held[i], ctypes.byref(what)):
                found += [held[i]] if what.map_state == VIEWABLE else []
        if held:
            self.x.XFree(held)
        return found

    def key(self, window, name, state=0):
        """Presses and releases a key over a window, which gets the focus."""
        code = self.x.XKeysymToKeycode(self.display, self.x.XStringToKeysym(name.encode()))
        self.x.XSetInputFocus(self.display, window, 1, 0)
        for kind in (2, 3):
            event = KeyEvent(type=kind, display=self.display, window=window, root=self.root,
                             state=state, keycode=code, same_screen=1)  # fmt: skip
            self.x.XSendEvent(self.display, window, 0, kind - 1, ctypes.byref(event))
        self.x.XFlush(self.display)


class Viewer:
    """The program and its windows."""

    def __init__(self, words, folder):
        desktop = ("XDG_CURRENT_DESKTOP", "DESKTOP_SESSION", "KDE_FULL_SESSION")
        environment = {name: value for name, value in os.environ.items() if name not in desktop}
        environment.update(XDG_CONFIG_HOME=folder, XDG_DATA_HOME=folder, QT_QPA_PLATFORMTHEME="")
        self.program = subprocess.Popen(words, env=environment)
        self.keyboard = Keyboard()
        self.window = self.wait("a window", lambda: self.keyboard.windows()[:1])[0]

    def wait(self, what, get, again=None):
        """Waits until `get` returns something; calls `again` every second until then."""
        end = time.monotonic() + LIMIT
        turn = time.monotonic()
        while time.monotonic() < end and self.program.poll() is None:
            found = get()
            if found:
                return found
            if again and time.monotonic() >= turn:
                again()
                turn = time.monotonic() + 1
            time.sleep(0.05)
        print(f"viewerScene: {what} did not come; status {self.program.poll()}", file=sys.stderr)
        self.end()
        sys.exit(1)

    def end(self):
        if self.program.poll() is None:
            self.program.kill()
        self.program.wait()

    def save(self, key, name):
        """Saves a file by Ctrl and the key, whose action asks for its name."""
        path = pathlib.Path(name)

        def others():
            return [each for each in self.keyboard.windows() if each != self.window]

        asked = self.wait(
            f"a dialog for {name}", others,
            lambda: self.keyboard.key(self.window, key, CONTROL))[0]  # fmt: skip
        time.sleep(0.3)
        for letter in name:
            self.keyboard.key(asked, {".": "period"}.get(letter, letter))
        time.sleep(0.3)
        self.keyboard.key(asked, "Return")
        self.wait(name, lambda: path.exists() and not others())


def main():
    with tempfile.TemporaryDirectory() as folder:
        viewer = Viewer(sys.argv[1:], folder)
        try:
            for key, name in (("p", "picture.png"), ("e", "layers.exr"), ("s", "session.json")):
                viewer.save(key, name)
            viewer.keyboard.key(viewer.window, "q", CONTROL)
            return viewer.program.wait(LIMIT)
        finally:
            viewer.end()


if __name__ == "__main__":
    sys.exit(main())
