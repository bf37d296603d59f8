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
        AssignViewToLayout, ColorBy, CreateLayout, CreateView,
        GetColorTransferFunction, GetScalarBar, Glyph, OpenFOAMReader, Outline,
        Render, SaveScreenshot, Show, Text,
    )
except ImportError as missing:
    sys.exit(f"ERROR: {missing}: run bin/renderCloud, which runs this")

LARGEST = 10e-6  # m, of the colours

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


def count(data):
    """Number of points of a data set, or of all blocks of one."""
    if data is None:
        return 0
    if data.IsA("vtkCompositeDataSet"):
        return sum(count(data.GetBlock(b))
                   for b in range(data.GetNumberOfBlocks()))
    return data.GetNumberOfPoints()


def diagonal(bounds):
    return math.dist(bounds[::2], bounds[1::2])


def draw(time, layout, place):
    """The cloud at a time in one cell of the layout."""
    reader = open_case()
    reader.UpdatePipeline(time)

    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.ViewTime = time
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0

    # Larger than they are, to be seen at all
    bounds = reader.GetDataInformation().GetBounds()
    enlarged = float(f"{max(1, 0.02*diagonal(bounds)/LARGEST):.1g}")

    glyph = Glyph(Input=reader, GlyphType="Sphere")
    glyph.ScaleArray = ["POINTS", "d"]
    glyph.ScaleFactor = enlarged
    glyph.GlyphMode = "All Points"
    glyph.GlyphType.Radius = 0.5

    shown = Show(glyph, view)
    ColorBy(shown, ("POINTS", "d"))
    colours = GetColorTransferFunction("d")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(0.3e-6, LARGEST)

    frame = Show(Outline(Input=reader), view)
    frame.AmbientColor = frame.DiffuseColor = [0.5, 0.5, 0.5]

    number = count(servermanager.Fetch(reader))
    label = Show(Text(Text=f"{1e3*time:.4g} ms: {number} particles"), view)
    label.Color = [0, 0, 0]
    label.FontSize = 12
    label.WindowLocation = "Upper Center"

    return view, colours, bounds, enlarged


def look(view, bounds):
    """See all of a box, from a corner."""
    centre = [0.5*(bounds[2*k] + bounds[2*k + 1]) for k in range(3)]
    size = diagonal(bounds)
    view.CameraFocalPoint = [centre[0], centre[1], centre[2] - 0.04*size]
    view.CameraPosition = [
        centre[k] + 2.4*size*d for k, d in enumerate((0.42, -0.85, 0.32))
    ]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 30


def has_particles(time):
    reader = open_case()
    reader.UpdatePipeline(time)
    return count(servermanager.Fetch(reader)) > 0


times = list(open_case().TimestepValues)
while times and not has_particles(times[0]):
    del times[0]
while times and not has_particles(times[-1]):
    del times[-1]
if not times:
    if created:
        os.remove(marker)
    sys.exit(f"ERROR: no time in {case} has particles that ParaView finds; it "
             "looks at the first two times: is 0/lagrangian there?")

layout = CreateLayout("particles")
layout.SplitHorizontal(0, 0.5)
first, _, bounds, _ = draw(times[0], layout, 1)
last, colours, _, enlarged = draw(times[-1], layout, 2)

Render(first)
Render(last)
look(first, bounds)
look(last, bounds)

bar = GetScalarBar(colours, last)
bar.Title = "diameter [m], drawn %g times larger" % enlarged
bar.ComponentTitle = ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.TitleFontSize = bar.LabelFontSize = 9
bar.Visibility = 1
bar.Orientation = "Horizontal"
bar.WindowLocation = "Any Location"
bar.Position = [0.25, 0.02]
bar.ScalarBarLength = 0.5

Render(last)
SaveScreenshot(
    os.path.join(case, "cloud.png"), layout, ImageResolution=[1600, 800]
)

if created:
    os.remove(marker)
