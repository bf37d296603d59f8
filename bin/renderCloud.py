"""Draws the particles of a case with ParaView; see renderCloud.

To be run by pvbatch, with the case directory and the name of the cloud as its
arguments.
"""

import math
import os
import sys

try:
    from paraview import servermanager
    from paraview.simple import (
        AssignViewToLayout, Calculator, ColorBy, CreateLayout, CreateView,
        GetColorTransferFunction, GetScalarBar, Glyph, OpenFOAMReader, Outline,
        Render, SaveScreenshot, Show, Text, TrivialProducer,
    )
except ImportError as missing:
    sys.exit(f"ERROR: {missing}: run bin/renderCloud, which runs this")

SMALLEST, LARGEST = 0.3, 10  # um, of the colours
DIRECTION = 0.42, -0.85, 0.32  # from which the box is seen
HEIGHT = 900  # of the picture [pixels]
PART = 0.76  # of it, that the box takes: a label above, the colours below

if len(sys.argv) != 3:
    sys.exit("ERROR: run bin/renderCloud, which runs this")
case, cloud = sys.argv[1:]
marker = os.path.join(case, "case.foam")
created = not os.path.exists(marker)
open(marker, "a").close()


def open_case():
    """A reader of the cloud that also reads the time zero."""
    reader = OpenFOAMReader(FileName=marker)
    reader.SkipZeroTime = 0
    reader.Refresh()
    reader.MeshRegions = [f"lagrangian/{cloud}"]
    reader.CellArrays = []
    reader.LagrangianArrays = ["d"]
    reader.UpdatePipelineInformation()
    return reader


def particles(time):
    """The points of the cloud at a time, or None. ParaView reads all clouds of
    a case, whichever is asked for."""
    reader = open_case()
    reader.UpdatePipeline(time)

    def search(data, name):
        if data is None:
            return None
        if not data.IsA("vtkMultiBlockDataSet"):
            return data if name == cloud and data.GetNumberOfPoints() else None
        for k in range(data.GetNumberOfBlocks()):
            inside = data.HasMetaData(k) and data.GetMetaData(k).Get(data.NAME())
            found = search(data.GetBlock(k), inside or name)
            if found is not None:
                return found
        return None

    return search(servermanager.Fetch(reader), cloud)


def product(a, b):
    """Of two vectors, normal to both."""
    return [
        a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]
    ]


def extents(bounds):
    """Half the width and the height of a box, as it is seen from afar."""
    half = [0.5*(bounds[2*k + 1] - bounds[2*k]) for k in range(3)]
    back = [x/math.hypot(*DIRECTION) for x in DIRECTION]
    right = product((0, 0, 1), back)
    right = [x/math.hypot(*right) for x in right]
    return [
        sum(abs(x*h) for x, h in zip(axis, half))
        for axis in (right, product(back, right))
    ]


def colours_of_sizes():
    """Viridis over the logarithm of the diameter."""
    colours = GetColorTransferFunction("diameter")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    points = list(colours.RGBPoints)  # x, red, green, blue, x, ...
    for k in range(0, len(points), 4):
        points[k] = SMALLEST*(LARGEST/SMALLEST)**(k/(len(points) - 4))
    colours.UseLogScale = 1
    colours.RGBPoints = points
    return colours


def write(text, view, place):
    shown = Show(Text(Text=text), view)
    shown.Color = [0, 0, 0]
    shown.FontSize = 20
    shown.WindowLocation = place


def time_text(time):
    return f"{time:.4g} s" if times[-1] >= 1 else f"{1e3*time:.4g} ms"


def draw(time, layout, place):
    """The cloud at a time in one cell of the layout."""
    data = particles(time)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()

    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.ViewTime = time
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0

    # Larger than they are, to be seen at all
    bounds = data.GetBounds()
    diagonal = math.dist(bounds[::2], bounds[1::2])
    enlarged = float(f"{max(1, 0.02*diagonal/(1e-6*LARGEST)):.1g}")

    sizes = Calculator(Input=source)
    sizes.AttributeType = "Point Data"
    sizes.ResultArrayName = "diameter"
    sizes.Function = "1e6*d"

    glyph = Glyph(Input=sizes, GlyphType="Sphere")
    glyph.ScaleArray = ["POINTS", "diameter"]
    glyph.ScaleFactor = 1e-6*enlarged
    glyph.GlyphMode = "All Points"
    glyph.GlyphType.Radius = 0.5

    shown = Show(glyph, view)
    ColorBy(shown, ("POINTS", "diameter"))

    frame = Show(Outline(Input=source), view)
    frame.AmbientColor = frame.DiffuseColor = [0.5, 0.5, 0.5]

    label = f"{time_text(time)}: {data.GetNumberOfPoints()} particles"
    write(label, view, "Upper Center")
    print(label)

    return view, bounds, enlarged


def look(view, bounds):
    """See all of a box, from a corner, in parallel projection."""
    centre = [0.5*(bounds[2*k] + bounds[2*k + 1]) for k in range(3)]
    width, height = extents(bounds)
    scale = height/PART
    far = 4*max(width, height)
    view.CameraParallelProjection = 1
    view.CameraParallelScale = scale
    # What is below the middle of the picture is more than what is above
    view.CameraFocalPoint = [centre[0], centre[1], centre[2] - 0.05*scale]
    view.CameraPosition = [
        x + far*d for x, d in zip(view.CameraFocalPoint, DIRECTION)
    ]
    view.CameraViewUp = [0, 0, 1]


times = list(open_case().TimestepValues)
while times and particles(times[0]) is None:
    del times[0]
while times and particles(times[-1]) is None:
    del times[-1]
if not times:
    if created:
        os.remove(marker)
    sys.exit(f"ERROR: no time in {case} has particles that ParaView finds; it "
             "looks at the first two times: is 0/lagrangian there?")

layout = CreateLayout("particles")
layout.SplitHorizontal(0, 0.5)
first, bounds, _ = draw(times[0], layout, 1)
last, _, enlarged = draw(times[-1], layout, 2)

Render(first)
Render(last)
look(first, bounds)
look(last, bounds)

bar = GetScalarBar(colours_of_sizes(), last)
bar.Title = "diameter [µm]"
bar.ComponentTitle = ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.TitleFontSize = bar.LabelFontSize = 20
bar.AutomaticLabelFormat = 0
bar.LabelFormat = bar.RangeLabelFormat = "%g"
bar.UseCustomLabels = 1
bar.CustomLabels = [0.5, 1, 2, 5]
bar.Visibility = 1
bar.Orientation = "Horizontal"
bar.WindowLocation = "Any Location"
bar.Position = [0.2, 0.015]
bar.ScalarBarLength = 0.6
write(f"drawn {enlarged:g} times larger", first, "Lower Center")

# As wide as the boxes want it, and the labels
wide, high = extents(bounds)
width = max(480, min(900, int(1.15*HEIGHT*PART*wide/high)))

for view in (first, last):
    view.ViewSize = [width, HEIGHT]
Render(first)
Render(last)
SaveScreenshot(
    os.path.join(case, "cloud.png"), layout,
    ImageResolution=[2*width, HEIGHT], SeparatorWidth=0, CompressionLevel=9,
)

if created:
    os.remove(marker)
