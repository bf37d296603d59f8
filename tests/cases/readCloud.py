"""What ParaView's own reader finds of a lagrangian cloud.

    xvfb-run -a pvbatch readCloud.py <case> [<cloud>] [--decomposed]

Prints for each time of the case

    time <time> points <number>
    time <time> <field>[<component>] min <value> max <value>

for each point field; ends with status 1 if the reader finds no such cloud at
any time.
"""

import os
import sys

from paraview import servermanager, simple


def main(case, cloud="aerosol", decomposed=False):
    # The reader wants a file, of any content; the case is where it lies
    marker = os.path.join(case, "readCloud.foam")
    made = not os.path.exists(marker)
    if made:
        open(marker, "w").close()

    try:
        return read(marker, "lagrangian/" + cloud, decomposed)
    finally:
        if made:
            os.remove(marker)


def read(marker, region, decomposed):
    reader = simple.OpenFOAMReader(FileName=marker)
    if decomposed:
        reader.CaseType = "Decomposed Case"
    reader.SkipZeroTime = 0
    reader.Refresh()  # or the reader forgets what was just set
    reader.UpdatePipelineInformation()

    if region not in reader.MeshRegions.Available:
        print("no", region, "among", list(reader.MeshRegions.Available))
        return 1
    reader.MeshRegions = [region]

    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        points = 0
        ranges = {}

        for leaf in leaves(servermanager.Fetch(reader)):
            points += leaf.GetNumberOfPoints()
            data = leaf.GetPointData()
            for i in range(data.GetNumberOfArrays()):
                array = data.GetArray(i)
                if array is None or array.GetNumberOfTuples() == 0:
                    continue
                for c in range(array.GetNumberOfComponents()):
                    low, high = array.GetRange(c)
                    old = ranges.get((array.GetName(), c), (low, high))
                    ranges[array.GetName(), c] = (
                        min(low, old[0]), max(high, old[1]))

        print(f"time {time:.10g} points {points}")
        for (name, c), (low, high) in sorted(ranges.items()):
            print(f"time {time:.10g} {name}[{c}] min {low:.9g} max {high:.9g}")

    return 0


def leaves(data):
    """The data sets of a composite one, or the data set itself"""
    if data is None:
        return
    if data.IsA("vtkMultiBlockDataSet"):
        for i in range(data.GetNumberOfBlocks()):
            yield from leaves(data.GetBlock(i))
    elif data.IsA("vtkMultiPieceDataSet"):
        for i in range(data.GetNumberOfPieces()):
            yield from leaves(data.GetPieceAsDataObject(i))
    else:
        yield data


if __name__ == "__main__":
    arguments = [a for a in sys.argv[1:] if a != "--decomposed"]
    sys.exit(main(*arguments, decomposed="--decomposed" in sys.argv))
