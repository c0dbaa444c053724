"""What SimpleITK reads from a volume, for the tests to compare with.

FILE... prints a JSON list with an object for each file: size, spacing, origin, direction (row by row, LPS), values (first
index fastest).
"""

import json
import sys

try:
    import SimpleITK
except ImportError:
    sys.exit(77)


def facts(path):
    image = SimpleITK.ReadImage(path)
    return {
        "size": list(image.GetSize()),
        "spacing": list(image.GetSpacing()),
        "origin": list(image.GetOrigin()),
        "direction": list(image.GetDirection()),
        "values": SimpleITK.GetArrayFromImage(image).flatten().tolist(),
    }


print(json.dumps([facts(path) for path in sys.argv[1:]]))
