"""What pydicom reads from an Enhanced US Volume, for the tests to compare with.

FILE prints the spacing along x and y, the six numbers of the orientation, and then for every frame a line: its time
index, its position, and the checksum of its pixels.
"""

import sys
import zlib

try:
    import numpy  # pixel_array needs it
    import pydicom
except ImportError:
    sys.exit(77)

dataset = pydicom.dcmread(sys.argv[1])
shared = dataset.SharedFunctionalGroupsSequence[0]
measures = shared.PixelMeasuresSequence[0]
print(repr(float(measures.PixelSpacing[1])), repr(float(measures.PixelSpacing[0])))
print(*[repr(value) for value in shared.PlaneOrientationVolumeSequence[0].ImageOrientationVolume])
for frame, groups in zip(dataset.pixel_array, dataset.PerFrameFunctionalGroupsSequence):
    position = groups.PlanePositionVolumeSequence[0].ImagePositionVolume
    time = groups.FrameContentSequence[0].DimensionIndexValues[0]
    print(time, *[repr(value) for value in position], zlib.crc32(frame.tobytes()))
