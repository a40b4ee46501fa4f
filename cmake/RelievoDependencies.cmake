# Finds what Relievo builds on: VTK (ParaView's or a stand-alone one), Python, GLM, OpenEXR, Embree.

set(Python3_FIND_STRATEGY LOCATION)
set(relievo_vtk_components
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  ChartsCore FiltersCore FiltersGeneral FiltersGeometry FiltersHybrid FiltersModeling FiltersSources
  IOExport IOGeometry IOImage IOImport IOLegacy IOPLY IOXML ImagingCore InteractionStyle
  RenderingAnnotation RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType
  RenderingOpenGL2 RenderingVolumeOpenGL2 ViewsContext2D WrappingPythonCore)

if (RELIEVO_USE_PARAVIEW)
  find_package(ParaView 5.11 REQUIRED)
else ()
  find_package(VTK 9.1 REQUIRED COMPONENTS ${relievo_vtk_components} Python Wrapping WrappingTools)
endif ()
# VTK's Python modules are built for one interpreter, which need not be the first on PATH.
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(glm REQUIRED)
find_package(OpenEXR 3 REQUIRED CONFIG)
if (RELIEVO_BUILD_TESTS OR RELIEVO_BUILD_BENCH)
  find_package(embree 3 REQUIRED)
endif ()
