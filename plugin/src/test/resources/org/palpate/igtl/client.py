"""A client made with pyigtl: receives poses for some seconds, then sends a label map and a transform.

Arguments: port, seconds. Prints one line a fact, as "name value"; exit status 3 without pyigtl.
"""
import sys
import time

try:
    import numpy
    import pyigtl
except ImportError:
    sys.exit(3)

port, seconds = int(sys.argv[1]), float(sys.argv[2])
client = pyigtl.OpenIGTLinkClient(host="127.0.0.1", port=port)

first = client.wait_for_message("PalpateTool", timeout=20)
begin = time.time()
heights = [float(first.matrix[2, 3])]
while time.time() - begin < seconds:
    message = client.wait_for_message("PalpateTool", timeout=20)
    heights.append(float(message.matrix[2, 3]))
elapsed = time.time() - begin
print("poses", len(heights))
print("rate", round((len(heights) - 1) / elapsed, 1))
print("rising", int(all(a < b for a, b in zip(heights, heights[1:]))))
print("x", float(message.matrix[0, 3]))

for received in client.get_latest_messages():
    if received.device_name == "PalpateLandmarks":
        print("landmark", received.positions[0][1])
print("landmarks_seen", int(client.wait_for_message("PalpateDevice", timeout=20) is not None))

labels = numpy.arange(24, dtype=numpy.int16).reshape(2, 3, 4)
matrix = numpy.array(
    [[0.5, 0, 0, 10], [0, 0.75, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]], float)
for version in (1, 2):
    image = pyigtl.ImageMessage(labels, ijk_to_world_matrix=matrix, device_name="labels")
    image.header_version = version
    client.send_message(image, wait=True)
pose = numpy.array([[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]], float)
client.send_message(pyigtl.TransformMessage(pose, device_name="fragment 2"), wait=True)
time.sleep(0.5)
client.stop()
