"""What nibabel reads from a NIfTI file, and files that nibabel writes, for the tests to compare with.

read FILE... prints a JSON list with an object for each file: shape, affine (4 x 4, RAS), values (scaled, first index
fastest). write FOLDER writes files of every kind there, and expected.json with the same facts of each by name.
"""

import json
import pathlib
import sys

try:
    import nibabel
    import numpy
except ImportError:
    sys.exit(77)


def facts(path):
    image = nibabel.load(path)
    values = numpy.asanyarray(image.dataobj).astype(numpy.float64)
    return {
        "shape": list(image.shape),
        "affine": image.affine.tolist(),
        "values": values.flatten(order="F").tolist(),
    }


def turned(degrees, mirror):
    cosine, sine = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    about_x = numpy.array([[1, 0, 0], [0, cosine, -sine], [0, sine, cosine]])
    about_z = numpy.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    affine = numpy.eye(4)
    affine[:3, :3] = about_x @ about_z @ numpy.diag([0.5, 0.75 * mirror, 1.25])
    affine[:3, 3] = [-20, 30.5, 4]
    return affine


def write(folder):
    generator = numpy.random.default_rng(7)
    expected = {}

    def keep(name, image):
        nibabel.save(image, folder / name)
        expected[name] = facts(folder / name)

    for code in ["uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"]:
        values = generator.integers(0, 120, (3, 4, 5)).astype(code)
        keep(f"{code}.nii", nibabel.Nifti1Image(values, turned(33, 1)))
        keep(f"{code}_2.nii.gz", nibabel.Nifti2Image(values, turned(-70, -1)))
        for order in "<>":
            header = nibabel.Nifti1Header(endianness=order)
            header.set_data_dtype(numpy.dtype(code).newbyteorder(order))
            name = "little" if order == "<" else "big"
            keep(f"{code}_{name}.nii", nibabel.Nifti1Image(values, turned(120, -1), header))
    bytes_ = generator.integers(0, 255, (3, 4, 5)).astype("uint8")
    keep("pair.hdr", nibabel.Nifti1Pair(bytes_, turned(10, 1)))
    keep("moving.nii", nibabel.Nifti1Image(generator.integers(0, 255, (3, 4, 5, 6)).astype("uint8"), turned(5, 1)))
    for mirror in (1, -1):
        image = nibabel.Nifti1Image(bytes_, turned(77, mirror))
        image.set_sform(None, code=0)
        image.set_qform(turned(77, mirror), code=1)
        keep(f"qform{mirror}.nii", image)
    image = nibabel.Nifti1Image(generator.normal(50, 20, (3, 4, 5)), turned(0, 1))
    image.set_data_dtype("int16")  # nibabel finds slope and intercept by itself
    keep("scaled.nii", image)
    (folder / "expected.json").write_text(json.dumps(expected))


if sys.argv[1] == "read":
    print(json.dumps([facts(path) for path in sys.argv[2:]]))
else:
    write(pathlib.Path(sys.argv[2]))
