#!/usr/bin/python3
"""Walks through the program as a screen reader does, and prints what would be spoken.

    walk.py PROGRAM [ARGUMENTS...]

It needs a display, and a session bus of its own: scripts/with-display dbus-run-session -- tests/accessibility/walk.py ...
The last line counts the controls found, those without a name, and the actions that work. The exit status is 0 if every
control has a name and every action that was tried did something, 77 if the machine has no pyatspi, else 1.
"""

import os
import subprocess
import sys
import time

try:
    import gi

    gi.require_version("Atspi", "2.0")
    import pyatspi
except (ImportError, ValueError) as missing:
    print(f"SKIP: {missing}: python3-pyatspi is not installed")
    sys.exit(77)

CONTROLS = {
    pyatspi.ROLE_PUSH_BUTTON, pyatspi.ROLE_TOGGLE_BUTTON, pyatspi.ROLE_CHECK_BOX, pyatspi.ROLE_RADIO_BUTTON,
    pyatspi.ROLE_COMBO_BOX, pyatspi.ROLE_SLIDER, pyatspi.ROLE_SPIN_BUTTON, pyatspi.ROLE_MENU, pyatspi.ROLE_MENU_ITEM,
    pyatspi.ROLE_CHECK_MENU_ITEM, pyatspi.ROLE_RADIO_MENU_ITEM, pyatspi.ROLE_TEXT, pyatspi.ROLE_ENTRY,
    pyatspi.ROLE_TABLE, pyatspi.ROLE_LIST, pyatspi.ROLE_PAGE_TAB, pyatspi.ROLE_IMAGE, pyatspi.ROLE_CANVAS,
    pyatspi.ROLE_ICON, pyatspi.ROLE_DIAL,
}
BOXES = {pyatspi.ROLE_CHECK_BOX, pyatspi.ROLE_TOGGLE_BUTTON, pyatspi.ROLE_RADIO_BUTTON}
# The tabs of panels bring a panel to the front: toggled once more they stay.
PANELS = ["Picture", "Curve", "Measure", "Method", "Tube cores", "Designers", "Compare", "Study", "Motion", "Explain",
          "Theory", "Lessons"]


def waited(condition, seconds):
    """What the condition gives once it is true; None if it never is."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.05)
    return None


def application(process):
    for each in pyatspi.Registry.getDesktop(0):
        if each is not None and each.get_process_id() == process.pid and each.childCount > 0:
            return each
    return None


def below(node, depth=0):
    """Everything below a node, in the order of a screen reader, with its depth."""
    yield node, depth
    for place in range(node.childCount):
        child = node.getChildAtIndex(place)
        if child is not None and depth < 40:
            yield from below(child, depth + 1)


def spoken(node):
    """Name, role, value and state in the order in which a screen reader says them."""
    words = [node.name, node.getLocalizedRoleName()]
    try:
        value = node.queryValue()
        words.append(f"{value.currentValue:g} of {value.minimumValue:g} to {value.maximumValue:g}")
    except NotImplementedError:
        pass
    states = node.getState()
    for state, word in ((pyatspi.STATE_CHECKED, "checked"), (pyatspi.STATE_EXPANDED, "expanded")):
        if states.contains(state):
            words.append(word)
    if not states.contains(pyatspi.STATE_ENABLED):
        words.append("unavailable")
    return ", ".join(word for word in words if word)


def is_shown(node):
    states = node.getState()
    return states.contains(pyatspi.STATE_SHOWING) or states.contains(pyatspi.STATE_VISIBLE)


def try_actions(node):
    """Does what leads nowhere else, and takes it back. Returns how many actions were tried and how many did it."""
    try:
        actions = node.queryAction()
    except NotImplementedError:
        return 0, 0
    names = [actions.getName(i) for i in range(actions.nActions)]
    role, tried, worked = node.getRole(), 0, 0

    def value():
        return node.queryValue().currentValue

    def state():
        return node.getState().contains(pyatspi.STATE_CHECKED)

    if not node.getState().contains(pyatspi.STATE_ENABLED) or not node.getState().contains(pyatspi.STATE_SHOWING):
        return 0, 0
    for one, back in (("Increase", "Decrease"), ("Decrease", "Increase")):
        if role in (pyatspi.ROLE_SLIDER, pyatspi.ROLE_SPIN_BUTTON) and one in names and back in names:
            before = value()
            at_end = before == (node.queryValue().maximumValue if one == "Increase" else node.queryValue().minimumValue)
            if at_end:
                continue
            tried += 1
            actions.doAction(names.index(one))
            worked += value() != before
            actions.doAction(names.index(back))
    # A side that is taken once more stays taken.
    stays = node.name in PANELS or node.parent.name == "Sides of the scan"
    if role == pyatspi.ROLE_CHECK_BOX and "Toggle" in names and not stays:
        before = state()
        tried += 1
        actions.doAction(names.index("Toggle"))
        if waited(lambda: state() != before, 2):
            worked += 1
            actions.doAction(names.index("Toggle"))
    if role == pyatspi.ROLE_COMBO_BOX and "ShowMenu" in names:
        tried += 1
        actions.doAction(names.index("ShowMenu"))
        worked += node.getState().contains(pyatspi.STATE_EXPANDED)
        actions.doAction(names.index("ShowMenu"))
    return tried, worked


def toggle(program, name):
    """Toggles the shown check box of that name; whether there is one."""
    for node, _ in list(below(program)):
        if node.name == name and node.getRole() in BOXES and node.getState().contains(pyatspi.STATE_SHOWING):
            actions = node.queryAction()
            actions.doAction([actions.getName(i) for i in range(actions.nActions)].index("Toggle"))
            return True
    return False


def main():
    process = subprocess.Popen(sys.argv[1:], env={**os.environ, "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1"})
    try:
        program = waited(lambda: application(process), 60)
        if program is None:
            print("the program did not appear on the bus of screen readers")
            return 1
        waited(lambda: any(node.name == "3D view" for node, _ in below(program)), 60)
        unnamed, failed, controls = [], [], 0
        for node, depth in list(below(program)):
            try:
                print("  " * depth + spoken(node))
                if node.getRole() in CONTROLS:
                    controls += 1
                    if not node.name:
                        unnamed.append(f"{node.getRoleName()} in {node.parent.getRoleName()} “{node.parent.name}”")
            except (RuntimeError, gi.repository.GLib.Error):
                print("  " * depth + "(gone meanwhile)")
        known, tried, worked = set(), 0, 0

        def use_what_is_shown():
            nonlocal tried, worked
            for node, _ in list(below(program)):
                try:
                    path = str(node.path)
                    if path in known:
                        continue
                    one, good = try_actions(node)
                    if one:
                        known.add(path)
                    if good < one:
                        failed.append(spoken(node))
                    tried, worked = tried + one, worked + good
                except (RuntimeError, gi.repository.GLib.Error):
                    continue

        use_what_is_shown()
        if not toggle(program, "Teach"):
            failed.append("the face Teach: no button is shown")
        use_what_is_shown()
        for what in unnamed:
            print("unnamed:", what)
        for what in failed:
            print("did nothing:", what)
        print(f"controls {controls}, unnamed {len(unnamed)}, actions tried {tried}, that worked {worked}")
        return 1 if unnamed or failed or controls < 500 or tried < 100 else 0
    finally:
        process.kill()
        process.wait()


if __name__ == "__main__":
    sys.exit(main())
