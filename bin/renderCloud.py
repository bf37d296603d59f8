"""Draws the particles of a case with ParaView; see renderCloud.

To be run by pvbatch, with the case directory as its argument.
"""

import os
import sys

from paraview import servermanager
from paraview.simple import (
    ColorBy, CreateLayout, CreateView, Glyph, AssignViewToLayout, GetColorTransferFunction,
    GetScalarBar, OpenFOAMReader, Outline, SaveScreenshot, Show, Text, Render,
)

case = sys.argv[1]
marker = os.path.join(case, "case.foam")
created = not os.path.exists(marker)
open(marker, "a").close()


def draw(time, layout, place):
    """The cloud at a time in one cell of the layout."""
    reader = OpenFOAMReader(FileName=marker)
    reader.MeshRegions = ["lagrangian/aerosol"]
    reader.CellArrays = []
    reader.LagrangianArrays = ["d"]
    reader.UpdatePipeline(time)

    view = CreateView("RenderView")
    AssignViewToLayout(view, layout, place)
    view.ViewTime = time
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0

    # Micrometres, four times enlarged: the true size would not be seen
    glyph = Glyph(Input=reader, GlyphType="Sphere")
    glyph.ScaleArray = ["POINTS", "d"]
    glyph.ScaleFactor = 4.0
    glyph.GlyphMode = "All Points"
    glyph.GlyphType.Radius = 0.5

    shown = Show(glyph, view)
    ColorBy(shown, ("POINTS", "d"))
    colours = GetColorTransferFunction("d")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(0.3e-6, 10e-6)

    frame = Show(Outline(Input=reader), view)
    frame.AmbientColor = frame.DiffuseColor = [0.5, 0.5, 0.5]

    points = servermanager.Fetch(reader)
    number = sum(
        points.GetBlock(b).GetNumberOfPoints()
        for b in range(points.GetNumberOfBlocks())
        if points.GetBlock(b)
    ) if points.IsA("vtkMultiBlockDataSet") else points.GetNumberOfPoints()

    label = Show(Text(Text=f"{1e3*time:.3g} ms: {number} particles"), view)
    label.Color = [0, 0, 0]
    label.FontSize = 16
    label.WindowLocation = "Upper Center"

    view.ResetCamera()
    camera = view.GetActiveCamera()
    camera.Azimuth(25)
    camera.Elevation(20)
    camera.Zoom(1.25)

    return view, colours


times = OpenFOAMReader(FileName=marker).TimestepValues
if not times:
    sys.exit("no times with a cloud")

layout = CreateLayout("particles")
layout.SplitHorizontal(0, 0.5)
draw(times[0], layout, 1)
last, colours = draw(times[-1], layout, 2)

bar = GetScalarBar(colours, last)
bar.Title = "diameter [m]"
bar.ComponentTitle = ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.Visibility = 1

layout.SetSize(1600, 800)
Render(last)
SaveScreenshot(os.path.join(case, "cloud.png"), layout)

if created:
    os.remove(marker)
